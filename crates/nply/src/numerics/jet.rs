//! A number with slope and bend: formulas differentiate themselves twice.

use core::ops::{Add, Mul, Neg, Sub};

use super::dual::Dual;

/// A value with its first and second derivative with respect to one variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Jet {
    pub(crate) value: f64,
    pub(crate) slope: f64,
    pub(crate) bend: f64,
}

impl Jet {
    pub(crate) const fn new(value: f64, slope: f64, bend: f64) -> Self {
        Self { value, slope, bend }
    }

    pub(crate) fn recip(self) -> Self {
        let inverse = 1.0 / self.value;
        let square = inverse * inverse;
        let bend = (2.0 * self.slope * self.slope * inverse - self.bend) * square;
        Self::new(inverse, -self.slope * square, bend)
    }

    /// The derivative as a number with its own slope.
    pub(crate) const fn derivative(self) -> Dual {
        Dual::new(self.slope, self.bend)
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self::new(self.value + b.value, self.slope + b.slope, self.bend + b.bend)
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        Self::new(self.value - b.value, self.slope - b.slope, self.bend - b.bend)
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value, -self.slope, -self.bend)
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        Self::new(
            self.value * b.value,
            self.slope * b.value + self.value * b.slope,
            self.bend * b.value + 2.0 * self.slope * b.slope + self.value * b.bend,
        )
    }
}

impl Mul<Jet> for f64 {
    type Output = Jet;
    fn mul(self, b: Jet) -> Jet {
        Jet::new(self * b.value, self * b.slope, self * b.bend)
    }
}

#[cfg(test)]
mod tests {
    use super::Jet;

    #[test]
    fn derivatives_follow_the_rules() {
        let x = Jet::new(0.7, 1.0, 0.0);
        let y = 3.0 * x * x * x - x.recip() - (-x);
        assert!((y.value - (3.0 * 0.343 - 1.0 / 0.7 + 0.7)).abs() < 1e-15);
        assert!((y.slope - (9.0 * 0.49 + 1.0 / 0.49 + 1.0)).abs() < 1e-15);
        assert!((y.bend - (18.0 * 0.7 - 2.0 / 0.343)).abs() < 1e-14);
    }
}
