//! The lists of the fit, as names with their words and units alone.

use super::figure::{Figure, OF_FORMULAS, OF_LAYER, OF_WHOLE, Sort};
use super::json::si;
use crate::report::listed::Sized;

/// Every number of a layer.
pub(crate) fn of_layer() -> Vec<Sized> {
    OF_LAYER.iter().chain(&OF_FORMULAS).flat_map(sized).collect()
}

/// Every number of the strand as a whole.
pub(crate) fn of_strand() -> Vec<Sized> {
    OF_WHOLE.iter().flat_map(sized).collect()
}

fn sized<T>(figure: &Figure<T>) -> Vec<Sized> {
    let Some(unit) = si(figure.sort) else {
        return vec![figure.listed(Some(if figure.sort == Sort::Degrees { "deg" } else { "" }))];
    };
    let bare = figure.listed(None);
    match figure.sort {
        Sort::LinearDensity => vec![Sized { bare_only: true, ..bare }, figure.listed_in_si(unit)],
        _ => vec![bare, figure.listed_in_si(unit)],
    }
}
