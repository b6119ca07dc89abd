//! A list of numbers of some thing, from which text, JSON and CSV are made.

use core::fmt::Write as _;

use nply::Handedness;
use serde_json::{Map, Value, json};

use super::text::{Emphasis, Row, hand, largest, lay_out};
use super::{Known, Measure};
use crate::PreferredUnits;
use crate::preferred::six_digits;

/// One reported number of a `T`: its name in JSON and CSV, its words (none: a reader's table leaves it out), the heading it
/// stands under, its kind, its dimensionless value.
pub(super) struct Item<T> {
    pub(super) name: &'static str,
    pub(super) label: &'static str,
    heading: &'static str,
    pub(super) measure: Measure,
    pub(super) value: fn(&T) -> Option<f64>,
}

pub(super) const fn item<T>(
    heading: &'static str,
    name: &'static str,
    label: &'static str,
    measure: Measure,
    value: fn(&T) -> Option<f64>,
) -> Item<T> {
    Item { name, label, heading, measure, value }
}

impl<T> Item<T> {
    /// The value, if there is one and it can be written as a number.
    pub(super) fn of(&self, of: &T) -> Option<f64> {
        // adding 0 takes the sign from a negative zero
        (self.value)(of).filter(|value| value.is_finite()).map(|value| value + 0.0)
    }

    fn values(&self, all: &[T]) -> Vec<Option<f64>> {
        all.iter().map(|of| self.of(of)).collect()
    }
}

/// How numbers are written for a reader.
pub(super) struct Reader<'r> {
    pub(super) known: Known,
    pub(super) units: &'r PreferredUnits,
    pub(super) emphasis: &'r Emphasis,
}

impl Reader<'_> {
    /// The parts of a table, one column for each of `all`; what nobody has a value of is left out.
    pub(super) fn parts<T>(
        &self,
        head: Vec<Row>,
        items: &[Item<T>],
        all: &[T],
        found: Option<&str>,
    ) -> Vec<(&'static str, Vec<Row>)> {
        let mut parts = vec![("", head)];
        let shown: Vec<&Item<T>> = items.iter().filter(|item| !item.label.is_empty()).collect();
        for item in &shown {
            let mark = if found == Some(item.name) { " (found)" } else { "" };
            let beside: Vec<(Measure, f64)> = shown
                .iter()
                .filter(|other| other.heading == item.heading)
                .map(|other| (other.measure, largest(&other.values(all))))
                .collect();
            let Some(row) = self.row(item, mark, all, &beside) else { continue };
            match parts.last_mut() {
                Some((last, rows)) if *last == item.heading => rows.push(row),
                _ => parts.push((item.heading, vec![row])),
            }
        }
        parts
    }

    /// A row in the unit that suits the rows beside it, of which measure and size are given.
    pub(super) fn row<T>(&self, item: &Item<T>, mark: &str, all: &[T], beside: &[(Measure, f64)]) -> Option<Row> {
        let values = item.values(all);
        let size = item.measure.size_among(largest(&values), beside);
        let reading = item.measure.reading(self.known, self.units, size);
        let cell = |value: &Option<f64>| value.map_or_else(|| "–".to_owned(), |v| six_digits(v * reading.factor));
        values.iter().any(Option::is_some).then(|| Row {
            label: format!("{}{mark}", item.label),
            unit: reading.unit.clone(),
            cells: values.iter().map(cell).collect(),
        })
    }

    /// A heading, and a table with the hands in its first row.
    pub(super) fn table<T>(
        &self,
        out: &mut String,
        heading: &str,
        items: &[Item<T>],
        all: &[T],
        of: fn(&T) -> Handedness,
    ) {
        if !all.is_empty() {
            let _ = writeln!(out, "\n{}", self.emphasis.heading(heading));
            let head = vec![words("hand", all.iter().map(|one| hand(of(one))))];
            lay_out(out, &self.parts(head, items, all, None), self.emphasis);
        }
    }
}

/// A row of words.
pub(super) fn words<'w>(label: &str, cells: impl Iterator<Item = &'w str>) -> Row {
    Row { label: label.to_owned(), unit: String::new(), cells: cells.map(str::to_owned).collect() }
}

pub(super) fn units<T>(items: &[Item<T>], known: Known) -> impl Iterator<Item = (String, Value)> {
    items.iter().filter_map(move |item| Some((item.name.to_owned(), json!(item.measure.si(known)?.1))))
}

pub(super) fn of_hand(handedness: Handedness) -> Map<String, Value> {
    let mut object = Map::new();
    object.insert("handedness".into(), json!(if handedness == Handedness::Right { 1 } else { -1 }));
    object.insert("lay".into(), json!(handedness.lay_letter().to_string()));
    object
}

/// The numbers of one thing, and the same in SI where its scale is known.
pub(super) fn numbers<T>(
    mut object: Map<String, Value>,
    items: &[Item<T>],
    of: &T,
    known: Known,
) -> Map<String, Value> {
    let mut si = Map::new();
    for item in items {
        let value = item.of(of);
        object.insert(item.name.into(), json!(value));
        if let Some((factor, _)) = item.measure.si(known) {
            si.insert(item.name.into(), json!(value.map(|value| value * factor)));
        }
    }
    if !si.is_empty() {
        object.insert("si".into(), Value::Object(si));
    }
    object
}
