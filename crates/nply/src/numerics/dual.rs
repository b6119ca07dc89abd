//! A number with its slope: formulas are written once and differentiate themselves.

use core::ops::{Add, Mul, Neg, Sub};

/// A value and its derivative with respect to one variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Dual {
    pub(crate) value: f64,
    pub(crate) slope: f64,
}

impl Dual {
    #[inline]
    pub(crate) const fn new(value: f64, slope: f64) -> Self {
        Self { value, slope }
    }

    #[inline]
    pub(crate) fn recip(self) -> Self {
        let inverse = 1.0 / self.value;
        Self::new(inverse, -self.slope * inverse * inverse)
    }
}

impl Add for Dual {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self::new(self.value + b.value, self.slope + b.slope)
    }
}

impl Sub for Dual {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self::new(self.value - b.value, self.slope - b.slope)
    }
}

impl Neg for Dual {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.value, -self.slope)
    }
}

impl Mul for Dual {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        Self::new(self.value * b.value, self.slope * b.value + self.value * b.slope)
    }
}

impl Mul<Dual> for f64 {
    type Output = Dual;
    #[inline]
    fn mul(self, b: Dual) -> Dual {
        Dual::new(self * b.value, self * b.slope)
    }
}

#[cfg(test)]
mod tests {
    use super::Dual;

    #[test]
    fn slopes_follow_the_rules() {
        let x = Dual::new(0.7, 1.0);
        let y = 3.0 * x * x - x.recip() + (-x);
        assert!((y.value - (3.0 * 0.49 - 1.0 / 0.7 - 0.7)).abs() < 1e-15);
        assert!((y.slope - (6.0 * 0.7 + 1.0 / 0.49 - 1.0)).abs() < 1e-15);
    }
}
