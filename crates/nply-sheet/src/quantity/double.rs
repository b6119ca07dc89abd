//! Numbers of twice the digits, so that a unit's size costs one rounding and no more.

/// The sum of two doubles that do not overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Double {
    high: f64,
    low: f64,
}

/// a·b and what its rounding leaves out (Veltkamp, Dekker); nothing is left out where the parts would overflow.
fn product(a: f64, b: f64) -> (f64, f64) {
    const SPLIT: f64 = 134_217_729.0; // 2²⁷ + 1
    let halves = |x: f64| {
        let wide = SPLIT * x;
        let high = wide - (wide - x);
        (high, x - high)
    };
    let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
    let rounded = a * b;
    let rest = ((a1 * b1 - rounded) + a1 * b2 + a2 * b1) + a2 * b2;
    (rounded, if rest.is_finite() { rest } else { 0.0 })
}

impl Double {
    /// 2π.
    pub(crate) const TAU: Self = Self { high: core::f64::consts::TAU, low: 2.449_293_598_294_706_4e-16 };

    pub(crate) const fn exactly(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    fn sum(large: f64, small: f64) -> Self {
        let high = large + small;
        Self { high, low: small - (high - large) }
    }

    pub(crate) fn times(self, other: Self) -> Self {
        let (high, rest) = product(self.high, other.high);
        Self::sum(high, rest + (self.high * other.low + self.low * other.high))
    }

    pub(crate) fn over(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let (high, rest) = product(quotient, other.high);
        let remainder = ((self.high - high) - rest) + (self.low - quotient * other.low);
        Self::sum(quotient, remainder / other.high)
    }

    /// The product with a double, rounded once (to within a thousandth of an ulp of it).
    pub(crate) fn scale(self, value: f64) -> f64 {
        let (high, rest) = product(self.high, value);
        let sum = high + (rest + self.low * value);
        if sum.is_finite() { sum } else { high }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::float_cmp, reason = "the nearest double is claimed")]
    use super::*;

    #[test]
    fn what_the_double_of_a_turn_leaves_out_is_its_sine() {
        assert_eq!(Double::TAU.low, -libm::sin(Double::TAU.high));
    }

    #[test]
    fn a_third_times_three_is_one() {
        let third = Double::exactly(1.0).over(Double::exactly(3.0));
        assert_eq!(third.scale(3.0), 1.0);
        assert_eq!(third.low, 1.850_371_707_708_594e-17); // 1/3 − fl(1/3)
        let ninth = third.times(third);
        assert_eq!(ninth.scale(9e200), 1e200);
        assert_eq!(Double::TAU.over(Double::TAU), Double::exactly(1.0));
        assert_eq!(Double::exactly(f64::MAX).scale(2.0), f64::INFINITY);
    }
}
