//! One combination of a pair, evaluated exactly, and its roots once they stand alone.

use core::cell::Cell;

use super::{Basis, Pair, Root, Side};
use crate::numerics::dual::Dual;
use crate::numerics::gauss::RULE;
use crate::numerics::root;

/// Halvings in one search, far more than two roots near each other need.
const MOST_HALVINGS: u32 = 1000;

/// One combination of a pair, evaluated exactly.
pub(super) struct Combination<'a, B, const K: usize> {
    pub(super) basis: &'a B,
    pub(super) pair: &'a Pair<K>,
    pub(super) side: Side,
    /// the coordinate from which another panel goes on, and what it takes this combination for there
    pub(super) border: Option<(f64, f64)>,
    /// halvings left: where rounding alone is at work they would go on and on
    halvings: Cell<u32>,
}

impl<'a, B: Basis<K>, const K: usize> Combination<'a, B, K> {
    #[inline]
    pub(super) fn new(basis: &'a B, pair: &'a Pair<K>, side: Side, border: Option<(f64, f64)>) -> Self {
        Self { basis, pair, side, border, halvings: Cell::new(MOST_HALVINGS) }
    }

    #[inline]
    pub(super) fn at(&self, t: f64) -> Dual {
        let (mut even, mut odd) = (Dual::new(0.0, 0.0), Dual::new(0.0, 0.0));
        for (k, function) in self.basis.at(t).iter().enumerate() {
            even = even + self.pair.even[k] * *function;
            odd = odd + self.pair.odd[k] * *function;
        }
        even + self.side * odd
    }

    /// Takes one from the halvings left, if there is one.
    pub(super) fn may_halve(&self) -> bool {
        let left = self.halvings.get();
        self.halvings.set(left.saturating_sub(1));
        left > 0
    }

    /// Whether function `k` takes part.
    pub(super) fn takes(&self, k: usize) -> bool {
        self.pair.even[k] != 0.0 || self.pair.odd[k] != 0.0
    }

    /// The combination of given values, and the sum of its terms' sizes.
    pub(super) fn sum_and_size(&self, values: &[f64; K]) -> (f64, f64) {
        let (mut even, mut odd, mut size) = (0.0, 0.0, 0.0);
        for (k, value) in values.iter().enumerate() {
            even += self.pair.even[k] * value;
            odd += self.pair.odd[k] * value;
            size += (self.pair.even[k] * value).abs() + (self.pair.odd[k] * value).abs();
        }
        (even + self.side * odd, size)
    }

    /// What rounding may make of the combination at `t`.
    pub(super) fn rounding(&self, t: f64) -> f64 {
        8.0 * f64::EPSILON * self.sum_and_size(&self.basis.at(t).map(|f| f.value)).1
    }

    /// The root between `low` and `high`, of which the combination is positive at `low` or at `high` alone.
    #[inline]
    pub(super) fn refine(&self, low: f64, high: f64, positive_low: bool, start: f64) -> Root {
        let (at, slope) = root::bracketed(|t| self.at(t), low, high, positive_low, start);
        Root { at, slope, double: false }
    }

    /// As [`refine`](Self::refine), of a combination that vanishes at coordinate 0 too. Up to `low` what cancels there may hide it; where the
    /// root is nearer than that, the combination is the integral of its slope, in which nothing of that size cancels.
    #[cold]
    pub(super) fn refine_past_zero(&self, low: f64, high: f64, positive: bool) -> Root {
        let risen = |t: f64| {
            let half = 0.5 * t;
            let both = |x: f64| self.at(half * (1.0 + x)).slope + self.at(half * (1.0 - x)).slope;
            let sum: f64 = RULE.iter().map(|&(x, weight)| weight * both(x)).sum();
            Dual::new(half * sum, self.at(t).slope)
        };
        if low > 0.0 && (risen(low).value >= 0.0) != positive {
            let (at, slope) = root::bracketed(risen, 0.0, low, positive, 0.5 * low);
            return Root { at, slope, double: false };
        }
        self.refine(low, high, positive, 0.5 * high)
    }

    /// Where the slope vanishes, known to happen once between `low` and `high`.
    pub(super) fn extremum(&self, mut low: f64, mut high: f64, rises: bool) -> f64 {
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if (self.at(middle).slope > 0.0) == rises {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    /// The roots on either side of the only extremum, at `top`.
    pub(super) fn around(&self, top: f64, start: f64, end: f64, from: bool, to: bool, found: &mut impl FnMut(Root)) {
        let height = self.at(top);
        let above = height.value >= 0.0;
        if from != to {
            let (low, high) = if above == from { (top, end) } else { (start, top) };
            found(self.refine(low, high, from, 0.5 * (low + high)));
        } else if height.value.abs() <= self.rounding(top) {
            // where all terms underflow, zero tells of nothing
            if self.rounding(top) >= f64::MIN_POSITIVE {
                found(Root { at: top, slope: height.slope, double: true });
            }
        } else if above != from {
            found(self.refine(start, top, from, 0.5 * (start + top)));
            found(self.refine(top, end, above, 0.5 * (top + end)));
        }
    }
}
