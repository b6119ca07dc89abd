//! The lists of the fit, as names with their words and units alone.

use super::figure::{Figure, OF_FORMULAS, OF_LAYER, OF_WHOLE, Sort};
use super::json::si;
use crate::report::csv::unit_suffix;
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
    let label = match (figure.heading, figure.label) {
        ("", label) => label.to_owned(),
        (_, "") => String::new(),
        (heading, label) => format!("{heading}: {label}"),
    };
    let plain = |unit| Sized {
        name: figure.name.to_owned(),
        label: label.clone(),
        unit,
        measured_only: false,
        bare_only: false,
    };
    let Some(unit) = si(figure.sort) else {
        return vec![plain(Some(if figure.sort == Sort::Degrees { "deg" } else { "" }))];
    };
    let name = format!("{}_{}", figure.name, unit_suffix(unit));
    let measured = Sized { name, unit: Some(unit), measured_only: true, ..plain(None) };
    match figure.sort {
        Sort::LinearDensity => vec![Sized { bare_only: true, ..plain(None) }, measured],
        _ => vec![plain(None), measured],
    }
}
