//! Cosine and sine over their argument as functions of its square, y = u²: C(y) = cos √y and S(y) = sin √y/√y, and their first two
//! derivatives, from their series, for 0 ≤ y ≤ 2.5 (u up to a quarter turn).
//!
//! In Σ (−y)ᵏ/(2k + 1)! and Σ (−y)ᵏ/(2k)!, differentiated up to three times, each term is less than y/2 < 1 … of the one before it in size for
//! y ≤ 2.5 once differentiated, and signs alternate. So what is cut off lies between zero and the first term left out, and the sum has the
//! sign of its first term: each derivative has one sign, hence the one below it is monotone, and its range is that of its ends.

use std::sync::OnceLock;

use crate::interval::Interval;

/// Powers kept; 2.5¹⁴/28! is some 1e-24.
const KEPT: usize = 14;
/// y up to here: more than π²/4.
const GREATEST: f64 = 2.5;

/// Coefficients of a series and its first two derivatives.
type Coefficients = [[Interval; KEPT + 1]; 3];

/// S of y, or C.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Series {
    /// cos √y
    Cosine,
    /// sin √y/√y
    SineOverArgument,
}

impl Series {
    fn coefficients(self) -> &'static Coefficients {
        static BOTH: [OnceLock<Coefficients>; 2] = [const { OnceLock::new() }; 2];
        let odd = usize::from(self == Self::SineOverArgument);
        BOTH[odd].get_or_init(|| {
            let whole = |k: usize| Interval::point(k as f64);
            // two more than are kept, for the derivatives
            let mut plain = [Interval::ONE; KEPT + 3];
            for k in 1..plain.len() {
                plain[k] = -(plain[k - 1] / whole((2 * k - 1 + odd) * (2 * k + odd)));
            }
            std::array::from_fn(|order| {
                std::array::from_fn(|k| (1..=order).fold(plain[k + order], |product, i| product * whole(k + i)))
            })
        })
    }

    /// The series and its first two derivatives over all of y.
    ///
    /// # Panics
    /// Unless 0 ≤ y ≤ 2.5.
    #[must_use]
    pub fn derivatives(self, y: Interval) -> [Interval; 3] {
        // squares are not below zero, whatever rounding says
        let low = y.low.max(0.0);
        assert!(low <= y.high && y.high <= GREATEST, "{y:?} is not from 0 to 2.5");
        self.coefficients().each_ref().map(|coefficients| {
            let at_low = sum(coefficients, low);
            if low == y.high { at_low } else { at_low.hull(sum(coefficients, y.high)) }
        })
    }

    /// The series alone.
    ///
    /// # Panics
    /// Unless 0 ≤ y ≤ 2.5.
    #[must_use]
    pub fn value(self, y: Interval) -> Interval {
        let low = y.low.max(0.0);
        assert!(low <= y.high && y.high <= GREATEST, "{y:?} is not from 0 to 2.5");
        let coefficients = &self.coefficients()[0];
        sum(coefficients, low).hull(sum(coefficients, y.high))
    }
}

fn sum(coefficients: &[Interval; KEPT + 1], y: f64) -> Interval {
    let y = Interval::point(y);
    let rest = coefficients[KEPT].hull(Interval::ZERO);
    coefficients[..KEPT].iter().rev().fold(rest, |sum, &coefficient| sum * y + coefficient)
}

#[cfg(test)]
#[allow(clippy::disallowed_methods)] // an independent route
mod tests {
    use super::*;

    #[test]
    fn cosine_and_sine_are_enclosed_tightly() {
        for i in 1..=157 {
            let u = f64::from(i) / 100.0;
            let y = Interval::point(u).square();
            for (series, known) in [(Series::Cosine, u.cos()), (Series::SineOverArgument, u.sin() / u)] {
                let value = series.value(y);
                assert!(value.low - 3e-16 <= known && known <= value.high + 3e-16, "{series:?} {u}: {value:?}");
                assert!(value.high - value.low < 4e-15, "{series:?} {u}: {value:?}");
                assert_eq!(value, series.derivatives(y)[0]);
            }
        }
    }

    #[test]
    fn derivatives_obey_their_differential_equations() {
        // with y = u²: 2 C′ = −S, and 2 y S′ = C − S; differentiated once more 2 C″ = −S′, 2 y S″ = C′ − 3 S′
        for i in 0..=246 {
            let y = Interval::point(f64::from(i) / 100.0);
            let two = Interval::point(2.0);
            let [c, c1, c2] = Series::Cosine.derivatives(y);
            let [s, s1, s2] = Series::SineOverArgument.derivatives(y);
            for zero in
                [two * c1 + s, two * y * s1 - c + s, two * c2 + s1, two * y * s2 - c1 + Interval::point(3.0) * s1]
            {
                assert!(zero.low <= 0.0 && zero.high >= 0.0 && zero.high - zero.low < 2e-14, "{y:?}: {zero:?}");
            }
        }
    }

    #[test]
    fn a_range_holds_the_values_inside() {
        let wide = Interval::between(0.3, 1.9);
        for series in [Series::Cosine, Series::SineOverArgument] {
            let range = series.derivatives(wide);
            for i in 0..=160 {
                let inside = series.derivatives(Interval::point(0.3 + f64::from(i) / 100.0));
                for (outer, inner) in range.iter().zip(inside) {
                    assert!(outer.low <= inner.high && inner.low <= outer.high);
                }
            }
        }
    }
}
