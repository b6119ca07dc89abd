//! A number of some thing with sizes of its own unit: where it stands, what it is called, what sort it is.

use super::csv::unit_suffix;
use super::listed::Sized;

/// One reported number: heading, name in JSON and CSV, words (none: a reader's table leaves it out), sort, value in SI or bare.
pub(super) struct Figure<T, S> {
    pub(super) heading: &'static str,
    pub(super) name: &'static str,
    pub(super) label: &'static str,
    pub(super) sort: S,
    pub(super) value: fn(&T) -> Option<f64>,
}

pub(super) const fn figure<T, S>(
    heading: &'static str,
    name: &'static str,
    label: &'static str,
    sort: S,
    value: fn(&T) -> Option<f64>,
) -> Figure<T, S> {
    Figure { heading, name, label, sort, value }
}

impl<T, S> Figure<T, S> {
    /// What a list says of it under its bare name.
    pub(super) fn listed(&self, unit: Option<&'static str>) -> Sized {
        let label = match (self.heading, self.label) {
            ("", label) => label.to_owned(),
            (_, "") => String::new(),
            (heading, label) => format!("{heading}: {label}"),
        };
        Sized { name: self.name.to_owned(), label, unit, measured_only: false, bare_only: false }
    }

    /// What a list says of it in SI, the unit behind its name.
    pub(super) fn listed_in_si(&self, unit: &'static str) -> Sized {
        let name = format!("{}_{}", self.name, unit_suffix(unit));
        Sized { name, measured_only: true, ..self.listed(Some(unit)) }
    }
}
