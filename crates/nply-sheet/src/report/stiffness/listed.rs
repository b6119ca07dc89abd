//! The lists of a cable, as names with their words and units alone.

use super::figure::{Figure, OF_CABLE, OF_MEMBER};
use super::json::unit;
use crate::report::listed::Sized;

/// Every number of the cable as a whole.
pub(crate) fn of_cable() -> Vec<Sized> {
    OF_CABLE.iter().flat_map(sized).collect()
}

/// Every number of its core, or of a layer.
pub(crate) fn of_member() -> Vec<Sized> {
    OF_MEMBER.iter().flat_map(sized).collect()
}

fn sized<T>(figure: &Figure<T>) -> Vec<Sized> {
    match unit(figure.sort) {
        None => vec![figure.listed(Some(""))],
        Some(unit) => vec![Sized { bare_only: true, ..figure.listed(None) }, figure.listed_in_si(unit)],
    }
}
