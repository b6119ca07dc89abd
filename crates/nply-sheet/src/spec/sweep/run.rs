//! One datum that varies, as it is written: a range, a list of values, a list of words.

use super::{may_vary, refused};
use crate::spec::{Entry, Value};
use crate::{Dimension, ErrorKind, Key, Place, Quantity, SpecError, Unit};

/// A datum and the values it takes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Run {
    pub(crate) key: &'static Key,
    /// What its numbers are written in; none for bare numbers and for words.
    pub(crate) unit: Option<Unit>,
    pub(crate) course: Course,
    pub(crate) place: Place,
}

/// Which values, in the run's unit.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Course {
    /// From one number to another, both included; how many, where it is said.
    Range {
        from: f64,
        to: f64,
        count: Option<u64>,
        log: bool,
    },
    List(Vec<f64>),
    Words(Vec<String>),
}

impl Run {
    /// A range between two values of a datum.
    pub(crate) fn range(from: &Entry, to: &Entry, count: Option<u64>, log: bool) -> Result<Self, SpecError> {
        let key = to.key;
        let unit = common_unit(&[to, from])?;
        if key.is_word() {
            return Err(to.error(ErrorKind::WrongType, format!("`{}` is no number: give a list of words", key.name)));
        }
        let [first, last] = [from, to].map(|entry| number(entry, unit.as_ref()));
        if log && (first * last).partial_cmp(&0.0) != Some(core::cmp::Ordering::Greater) {
            let message = format!("`{}`: equal ratios need two ends on one side of 0", key.name);
            return Err(to.error(ErrorKind::Domain, message));
        }
        let course = Course::Range { from: first, to: last, count, log };
        Self { key, unit, course, place: to.place.clone() }.checked()
    }

    /// A list of values of a datum.
    pub(crate) fn list(entries: &[Entry]) -> Result<Self, SpecError> {
        let Some(first) = entries.first() else {
            return Err(refused(ErrorKind::Missing, "sweep", "a list without values"));
        };
        let key = first.key;
        let all: Vec<&Entry> = entries.iter().collect();
        let (unit, course) = if key.is_word() {
            let word = |entry: &Entry| match &entry.value {
                Value::Balance(balance) => balance.name().to_owned(),
                Value::Hand(hand) => if hand.sign() > 0.0 { "right" } else { "left" }.to_owned(),
                Value::Text(text) => text.clone(),
                Value::Switch(switch) => switch.to_string(),
                Value::Quantity(_) => entry.written.clone(),
            };
            (None, Course::Words(entries.iter().map(word).collect()))
        } else {
            let unit = common_unit(&all)?;
            let list = entries.iter().map(|entry| number(entry, unit.as_ref())).collect();
            (unit, Course::List(list))
        };
        Self { key, unit, course, place: first.place.clone() }.checked()
    }

    fn checked(self) -> Result<Self, SpecError> {
        may_vary(self.key, &self.place)?;
        match &self.course {
            Course::Range { count: Some(0), .. } => Err(self.refuse("a range has at least one value")),
            _ => Ok(self),
        }
    }

    fn refuse(&self, why: &str) -> SpecError {
        let message = format!("`{}`: {why}", self.key.name);
        SpecError::new(ErrorKind::Domain, self.place.clone(), message).of_key(self.key.name)
    }

    /// How many values it has by itself; none for a range of which that is not said.
    pub(crate) fn count(&self) -> Option<u64> {
        match &self.course {
            Course::Range { count, .. } => *count,
            Course::List(list) => Some(list.len() as u64),
            Course::Words(list) => Some(list.len() as u64),
        }
    }

    /// As it would stand in a file.
    pub(crate) fn text(&self) -> String {
        let unit = self.unit.as_ref().map_or(String::new(), |unit| format!(" {unit}"));
        let value = |value: f64| match unit.as_str() {
            "" => format!("{value:?}"),
            unit => format!("\"{value:?}{unit}\""),
        };
        let what = match &self.course {
            Course::Range { from, to, count, log } => {
                let count = count.map_or(String::new(), |count| format!(", count = {count}"));
                let scale = if *log { ", scale = \"log\"" } else { "" };
                format!("{{ from = {}, to = {}{count}{scale} }}", value(*from), value(*to))
            }
            Course::List(list) => {
                format!("[{}]", list.iter().map(|one| value(*one)).collect::<Vec<_>>().join(", "))
            }
            Course::Words(list) => {
                format!("[{}]", list.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", "))
            }
        };
        format!("{}.{} = {what}", self.key.table.name(), self.key.name)
    }
}

/// The unit of the first that has one; others must measure the same.
fn common_unit(entries: &[&Entry]) -> Result<Option<Unit>, SpecError> {
    let unit_of = |entry: &Entry| match &entry.value {
        Value::Quantity(Quantity::Measured { unit, .. }) => Some(unit.clone()),
        _ => None,
    };
    let Some(unit) = entries.iter().find_map(|entry| unit_of(entry)) else { return Ok(None) };
    for entry in entries {
        let found = unit_of(entry).map_or(Dimension::NUMBER, |unit| unit.dimension());
        let nothing = !entry.is_measured() && entry.number() == 0.0;
        if found != unit.dimension() && !nothing {
            let message = format!("{} and {unit} go not together: give all values in one kind of unit", entry.said());
            return Err(entry.error(ErrorKind::WrongUnit, message));
        }
    }
    Ok(Some(unit))
}

/// The number of an entry in a unit, as it was written.
fn number(entry: &Entry, unit: Option<&Unit>) -> f64 {
    let Some(unit) = unit.filter(|_| entry.is_measured()) else { return entry.number() };
    let value = unit.of_si(entry.number());
    // what was written has fewer digits than a double; the last of these may be lost on the way to SI and back
    let near: f64 = format!("{value:.14e}").parse().unwrap_or(value);
    if (near - value).abs() <= 4.0 * f64::EPSILON * value.abs() { near } else { value }
}
