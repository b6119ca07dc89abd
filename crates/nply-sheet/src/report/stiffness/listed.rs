//! The lists of a cable, as names with their words and units alone.

use super::figure::{Figure, OF_CABLE, OF_MEMBER};
use super::json::unit;
use crate::report::csv::unit_suffix;
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
    match unit(figure.sort) {
        None => vec![plain(Some(""))],
        Some(unit) => {
            let name = format!("{}_{}", figure.name, unit_suffix(unit));
            vec![
                Sized { bare_only: true, ..plain(None) },
                Sized { name, unit: Some(unit), measured_only: true, ..plain(None) },
            ]
        }
    }
}
