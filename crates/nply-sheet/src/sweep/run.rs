//! One datum that varies: a range, a list of values, a list of words.

use super::refused;
use crate::spec::{Entry, Value};
use crate::table::{Kind as Cells, Values};
use crate::{Datum, Dimension, ErrorKind, Key, Kind, Place, Quantity, SpecError, Unit};

/// A datum and the values it takes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Run {
    pub(super) key: &'static Key,
    /// What its numbers are written in; none for bare numbers and for words.
    pub(super) unit: Option<Unit>,
    pub(super) course: Course,
    pub(super) place: Place,
}

/// Which values, in the run's unit.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Course {
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
    pub(super) fn range(from: &Entry, to: &Entry, count: Option<u64>, log: bool) -> Result<Self, SpecError> {
        let key = to.key;
        let unit = common_unit(&[to, from])?;
        if is_word(key) {
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
    pub(super) fn list(entries: &[Entry]) -> Result<Self, SpecError> {
        let Some(first) = entries.first() else {
            return Err(refused(ErrorKind::Missing, "sweep", "a list without values"));
        };
        let key = first.key;
        let all: Vec<&Entry> = entries.iter().collect();
        let (unit, course) = if is_word(key) {
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
    pub(super) fn count(&self) -> Option<u64> {
        match &self.course {
            Course::Range { count, .. } => *count,
            Course::List(list) => Some(list.len() as u64),
            Course::Words(list) => Some(list.len() as u64),
        }
    }

    /// The values at these places, counted from 0.
    pub(super) fn at(&self, places: impl ExactSizeIterator<Item = u64>) -> Values {
        match &self.course {
            &Course::Range { from, to, count, log } => {
                let last = count.unwrap_or(1).saturating_sub(1);
                numbers(self.key, places.map(|place| between(from, to, log, place, last)))
            }
            Course::List(list) => {
                let end = list.len().saturating_sub(1);
                numbers(self.key, places.map(|place| list.get((place as usize).min(end)).copied().unwrap_or(f64::NAN)))
            }
            Course::Words(list) => Values::Text(places.map(|place| list.get(place as usize).cloned()).collect()),
        }
    }

    /// The values at these shares of the way, 0 to below 1.
    pub(super) fn sampled(&self, shares: impl ExactSizeIterator<Item = f64>) -> Values {
        let pick = |share: f64, length: usize| ((share * length as f64) as usize).min(length.saturating_sub(1)) as u64;
        match &self.course {
            // whole numbers from the first to the last, all alike
            &Course::Range { from, to, .. } if self.key.kind == Kind::Count => {
                let width = to - from + if to >= from { 1.0 } else { -1.0 };
                numbers(self.key, shares.map(|share| from + libm::trunc(share * width)))
            }
            &Course::Range { from, to, log, .. } => numbers(self.key, shares.map(|share| along(from, to, log, share))),
            Course::List(list) => {
                let places: Vec<u64> = shares.map(|share| pick(share, list.len())).collect();
                self.at(places.into_iter())
            }
            Course::Words(list) => {
                let places: Vec<u64> = shares.map(|share| pick(share, list.len())).collect();
                self.at(places.into_iter())
            }
        }
    }

    /// The value so far on the way from one place to the next, if there is anything between.
    pub(super) fn between(&self, place: u64, share: f64) -> Option<f64> {
        if self.key.kind == Kind::Count {
            return None;
        }
        match &self.course {
            &Course::Range { from, to, count, log } => {
                let last = count.unwrap_or(1).saturating_sub(1);
                let [a, b] = [place, place + 1].map(|place| between(from, to, log, place, last));
                Some(along(a, b, log, share))
            }
            Course::List(list) => {
                let (a, b) = (list.get(place as usize)?, list.get(place as usize + 1)?);
                Some(along(*a, *b, false, share))
            }
            Course::Words(list) => {
                let (a, b) = (list.get(place as usize)?, list.get(place as usize + 1)?);
                (a == b).then_some(f64::NAN)
            }
        }
    }

    /// The head of its column, the unit behind the name.
    pub(super) fn column(&self) -> crate::table::Column {
        column(self.key, self.unit.as_ref())
    }

    /// As it would stand in a file.
    pub(super) fn text(&self) -> String {
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

/// Refuses what has the same value for a whole table.
pub(super) fn may_vary(key: &'static Key, place: &Place) -> Result<(), SpecError> {
    let why = match key.datum {
        Datum::Title => "a title is one for the whole study: give it in [ply]",
        Datum::Stretch => "whether strands stretch is one for the whole study: give it in [strand]",
        _ => return Ok(()),
    };
    Err(SpecError::new(ErrorKind::Contradiction, place.clone(), format!("`{}`: {why}", key.name)).of_key(key.name))
}

/// The head of the column of a datum.
pub(super) fn column(key: &'static Key, unit: Option<&Unit>) -> crate::table::Column {
    let name = name(key);
    let kind = match key.kind {
        Kind::Count => Cells::Integer,
        _ if is_word(key) => Cells::Text,
        _ => Cells::Float,
    };
    match unit {
        Some(unit) => {
            let name = format!("{name}_{}", crate::report::unit_suffix(unit.as_str()));
            crate::table::Column::new(name, kind).with_unit(unit.as_str())
        }
        None => crate::table::Column::new(name, kind),
    }
}

/// What a datum is called in a table: its flag, and its table before it where an answer of another meaning has that name.
pub(super) fn name(key: &'static Key) -> String {
    let flag = key.flag.replace('-', "_");
    match key.datum {
        Datum::TorsionalStiffness | Datum::AxialStiffness => format!("strand_{flag}"),
        _ => flag,
    }
}

pub(super) const fn is_word(key: &Key) -> bool {
    matches!(key.kind, Kind::Balance | Kind::Hand | Kind::Text | Kind::Switch)
}

fn numbers(key: &Key, values: impl ExactSizeIterator<Item = f64>) -> Values {
    if key.kind != Kind::Count {
        return Values::Dense(values.collect());
    }
    // a count that is none is left empty here, and refused where it is read
    #[expect(clippy::cast_possible_truncation, reason = "whole, and far below 2⁶³")]
    let whole = |value: f64| (value.fract() == 0.0 && value.abs() < 1e15).then_some(value as i64);
    let cells: Vec<Option<i64>> = values.map(whole).collect();
    let dense: Option<Vec<i64>> = cells.iter().copied().collect();
    dense.map_or(Values::Integer(cells), Values::Counts)
}

/// The number of a place between two ends, both of them exact.
fn between(from: f64, to: f64, log: bool, place: u64, last: u64) -> f64 {
    match (place, last) {
        (0, _) | (_, 0) => from,
        _ if place >= last => to,
        _ => along(from, to, log, place as f64 / last as f64),
    }
}

fn along(from: f64, to: f64, log: bool, share: f64) -> f64 {
    if log { from * libm::pow(to / from, share) } else { from * (1.0 - share) + to * share }
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

/// A number of a column as the datum it stands for.
pub(super) fn quantity(value: f64, unit: Option<&Unit>) -> Quantity {
    match unit {
        None => Quantity::Bare(value),
        Some(unit) => Quantity::Measured { si: unit.to_si(value), unit: unit.clone() },
    }
}
