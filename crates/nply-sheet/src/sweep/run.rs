//! The values that a datum takes: at places of a range or a list, or at shares of the way.

use crate::spec::sweep::{Course, Run};
use crate::table::{Kind as Cells, Values};
use crate::{Key, Kind, Quantity, Unit};

impl Run {
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
}

/// The head of the column of a datum.
pub(super) fn column(key: &'static Key, unit: Option<&Unit>) -> crate::table::Column {
    let name = key.column_name();
    let kind = match key.kind {
        Kind::Count => Cells::Integer,
        _ if key.is_word() => Cells::Text,
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

/// A number of a column as the datum it stands for.
pub(super) fn quantity(value: f64, unit: Option<&Unit>) -> Quantity {
    match unit {
        None => Quantity::Bare(value),
        Some(unit) => Quantity::Measured { si: unit.to_si(value), unit: unit.clone() },
    }
}
