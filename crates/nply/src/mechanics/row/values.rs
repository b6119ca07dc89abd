//! The ascending values of the datum that varies.

use core::ops::Range;

use crate::numerics::bernstein::one_sign;
use crate::numerics::septic::{Coefficients, ORDER};

/// Places tried one by one from where an even spacing would have it, before the list is halved.
const NEARBY: usize = 8;

/// A list in ascending order, of which equal neighbours may be part; not empty.
#[derive(Clone, Copy, Debug)]
pub(super) struct Values<'a> {
    pub(super) list: &'a [f64],
    first: f64,
    last: f64,
    per_unit: f64,
}

impl<'a> Values<'a> {
    /// `None` of an empty list.
    pub(super) fn new(list: &'a [f64]) -> Option<Self> {
        let (&first, &last) = (list.first()?, list.last()?);
        Some(Self { list, first, last, per_unit: (list.len() - 1) as f64 / (last - first) })
    }

    pub(super) fn largest(&self) -> f64 {
        self.first.abs().max(self.last.abs())
    }

    /// How many are less than `x`.
    pub(super) fn below(&self, x: f64) -> usize {
        self.count(x, |value| value < x)
    }

    /// How many are at most `x`.
    pub(super) fn up_to(&self, x: f64) -> usize {
        self.count(x, |value| value <= x)
    }

    fn count(&self, x: f64, before: impl Fn(f64) -> bool) -> usize {
        let list = self.list;
        // a conversion that saturates, and takes NaN to 0: a guess that need not be right
        let mut at = (((x - self.first) * self.per_unit) as usize).min(list.len());
        for _ in 0..NEARBY {
            if at > 0 && !before(list[at - 1]) {
                at -= 1;
            } else if at < list.len() && before(list[at]) {
                at += 1;
            } else {
                return at;
            }
        }
        list.partition_point(|&value| before(value))
    }

    /// Whether A + xB has no root for any value x: it has none for the first and the last, with one sign.
    #[inline]
    pub(super) fn clear_of(&self, a: &Coefficients, b: &Coefficients, tolerance: f64) -> bool {
        let (mut least, mut greatest) = ([0.0; ORDER], [0.0; ORDER]);
        for i in 0..ORDER {
            let (first, last) = (a[i] + self.first * b[i], a[i] + self.last * b[i]);
            least[i] = if first < last { first } else { last };
            greatest[i] = if first > last { first } else { last };
        }
        let mut half = ORDER / 2;
        while half > 0 {
            for i in 0..half {
                let (low, high) = (least[i + half], greatest[i + half]);
                least[i] = if low < least[i] { low } else { least[i] };
                greatest[i] = if high > greatest[i] { high } else { greatest[i] };
            }
            half /= 2;
        }
        least[0] > tolerance || greatest[0] < -tolerance
    }

    /// The values x for which A + xB may have a root, as the signs of its coefficients tell.
    pub(super) fn doubtful(&self, a: &Coefficients, b: &Coefficients, tolerance: f64) -> [Range<usize>; 3] {
        let end = self.list.len();
        let mut sure = [self.all_beyond(a, b, tolerance), self.all_beyond(&a.map(|v| -v), &b.map(|v| -v), tolerance)];
        sure.sort_by_key(|range| range.start);
        let [one, other] = sure;
        [0..one.start, one.end..other.start.max(one.end), other.end.max(one.end)..end]
    }

    /// The values x for which all coefficients of A + xB exceed the tolerance.
    fn all_beyond(&self, a: &Coefficients, b: &Coefficients, tolerance: f64) -> Range<usize> {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for (a, b) in a.iter().zip(b) {
            if *b > 0.0 {
                low = low.max((tolerance - a) / b);
            } else if *b < 0.0 {
                high = high.min((tolerance - a) / b);
            } else if *a <= tolerance {
                return 0..0;
            }
        }
        let start = self.up_to(low);
        start..self.below(high).max(start)
    }
}

/// Whether a polynomial has a sure sign throughout.
pub(super) fn sure((b, tolerance): &(Coefficients, f64)) -> bool {
    one_sign(b, *tolerance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_agree_with_a_search() {
        let lists: [&[f64]; 4] =
            [&[0.5], &[0.0, 0.0, 0.0], &[-2.0, -1.0, 0.0, 0.0, 1.0, 2.0], &[0.0, 1e-9, 1e-3, 1.0, 1e9]];
        for list in lists {
            let values = Values::new(list).unwrap();
            for &x in [f64::NEG_INFINITY, f64::INFINITY, -1.5, 0.5, 0.7, 1e5].iter().chain(list) {
                assert_eq!(values.below(x), list.partition_point(|&v| v < x));
                assert_eq!(values.up_to(x), list.partition_point(|&v| v <= x));
            }
        }
    }

    #[test]
    fn doubt_covers_every_root() {
        // x = u on [−1, 1]: A = −u, B = 1
        let a: Coefficients = core::array::from_fn(|i| 1.0 - 2.0 * i as f64 / 7.0);
        let list: Vec<f64> = (-20..=20).map(|i| 0.1 * f64::from(i)).collect();
        let values = Values::new(&list).unwrap();
        let doubts: Vec<usize> = values.doubtful(&a, &[1.0; ORDER], 1e-12).into_iter().flatten().collect();
        assert_eq!(doubts, (10..=30).collect::<Vec<_>>());
    }
}
