//! The part of the numbers that a picture shows.

use crate::report::Measure;

/// Which axes are logarithmic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Scales {
    /// The one below.
    pub log_x: bool,
    /// The one on the left.
    pub log_y: bool,
}

/// From one number to another, on a linear or a logarithmic scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Window {
    pub(super) low: f64,
    pub(super) high: f64,
    logarithmic: bool,
}

/// Outside these parts of all the weight numbers may be left out, if they would take most of the room.
const PARTS: (f64, f64) = (0.03, 0.97);
/// How many times the room of the rest.
const MOST: f64 = 4.0;
/// The room that is left for them then, in parts of that of the rest.
const AIR: f64 = 0.35;

impl Window {
    /// Of numbers with the weights they have: all of them, but for poles.
    pub(super) fn around(numbers: &[(f64, f64)], logarithmic: bool) -> Self {
        let seen = |value: f64| if logarithmic { libm::log10(value) } else { value };
        let fit = |value: f64| value.is_finite() && (!logarithmic || value > 0.0);
        let mut sorted: Vec<(f64, f64)> =
            numbers.iter().filter(|(value, _)| fit(*value)).map(|&(value, weight)| (seen(value), weight)).collect();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (Some(&(least, _)), Some(&(most, _))) = (sorted.first(), sorted.last()) else {
            return if logarithmic { Self::from(1.0, 10.0, true) } else { Self::from(0.0, 1.0, false) };
        };
        let whole: f64 = sorted.iter().map(|(_, weight)| weight).sum();
        let part = |share: f64| {
            let mut sum = 0.0;
            let found = sorted.iter().find(|(_, weight)| {
                sum += weight;
                sum >= share * whole
            });
            found.map_or(most, |(value, _)| *value)
        };
        let (low, high) = (part(PARTS.0), part(PARTS.1));
        let (low, high) = if most - least <= MOST * (high - low) {
            (least, most)
        } else {
            let air = AIR * (high - low);
            (least.max(low - air), most.min(high + air))
        };
        let (low, high) = if high > low { (low, high) } else { (low - 0.5, low + 0.5) };
        match logarithmic {
            true => Self::from(libm::pow(10.0, low), libm::pow(10.0, high), true),
            false => Self::from(low, high, false),
        }
    }

    /// Of numbers of a kind: angles and shares, which have bounds of their own, are all shown.
    pub(super) fn of(measure: Measure, numbers: &[(f64, f64)], logarithmic: bool) -> Self {
        if !matches!(measure, Measure::Degrees | Measure::Percent) || logarithmic {
            return Self::around(numbers, logarithmic);
        }
        let finite = numbers.iter().map(|(value, _)| *value).filter(|value| value.is_finite());
        let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        if high > low { Self::from(low, high, false) } else { Self::around(numbers, false) }
    }

    /// From a number to a greater one; a logarithmic scale is for numbers greater than 0.
    pub(super) fn from(low: f64, high: f64, logarithmic: bool) -> Self {
        Self { low, high, logarithmic: logarithmic && low > 0.0 }
    }

    /// Where a number lies, in parts of the window; NaN where the scale has no such number.
    pub(super) fn share(self, value: f64) -> f64 {
        let seen = |value: f64| match self.logarithmic {
            true if value > 0.0 => libm::log10(value),
            true => f64::NAN,
            false => value,
        };
        (seen(value) - seen(self.low)) / (seen(self.high) - seen(self.low))
    }

    /// Its ends with a little room.
    pub(super) fn aired(self) -> (f64, f64) {
        const ROOM: f64 = 0.04;
        if self.logarithmic {
            let room = libm::pow(self.high / self.low, ROOM);
            return (self.low / room, self.high * room);
        }
        let room = ROOM * (self.high - self.low);
        (self.low - room, self.high + room)
    }
}

/// How much of the axis each point of a curve stands for.
pub(super) fn weights(places: &[f64]) -> Vec<f64> {
    let near = |i: usize| places.get(i).copied().filter(|place| place.is_finite());
    (0..places.len())
        .map(|i| {
            let here = near(i);
            let ends = [i.checked_sub(1).and_then(near), near(i + 1)];
            ends.into_iter().map(|end| (end.or(here).unwrap_or(0.0) - here.unwrap_or(0.0)).abs()).sum::<f64>() + 1e-9
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pole_does_not_take_the_room_of_the_rest() {
        let places: Vec<f64> = (0..2000).map(|i| f64::from(i) / 2000.0 + 1e-4).collect();
        let weights = weights(&places);
        let pole: Vec<(f64, f64)> = places.iter().zip(&weights).map(|(x, w)| (1.0 / (x * x), *w)).collect();
        let window = Window::around(&pole, false);
        assert!(window.high < 2000.0 && window.low < 1.01, "{window:?}");
        let line: Vec<(f64, f64)> = places.iter().zip(&weights).map(|(x, w)| (*x, *w)).collect();
        let window = Window::around(&line, false);
        assert!(window.low < 2e-4 && window.high > 0.999);
        assert!(Window::around(&pole, true).high > 1e7); // decades have room
        assert!(Window::around(&[], false).high > 0.0);
    }
}
