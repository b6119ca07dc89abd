//! A number of some thing with sizes of its own unit: where it stands, what it is called, what sort it is.

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
