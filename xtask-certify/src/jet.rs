//! A function's value and first two derivatives, each as an interval; and what value and jet have in common.

use std::ops::{Add, Mul, Neg, Sub};

use crate::interval::Interval;
use crate::series::Series;

/// What the terms of the balance are written in.
pub trait Number: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> {
    fn constant(value: Interval) -> Self;
    #[must_use]
    fn square(self) -> Self;
    #[must_use]
    fn sqrt(self) -> Self;
    #[must_use]
    fn reciprocal(self) -> Self;
    #[must_use]
    fn series(self, series: Series) -> Self;
}

impl Number for Interval {
    fn constant(value: Interval) -> Self {
        value
    }
    fn square(self) -> Self {
        self.square()
    }
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    fn reciprocal(self) -> Self {
        Self::ONE / self
    }
    fn series(self, series: Series) -> Self {
        series.value(self)
    }
}

/// Value, slope and second derivative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet {
    pub value: Interval,
    pub slope: Interval,
    pub curve: Interval,
}

impl Jet {
    /// The coordinate itself.
    #[must_use]
    pub const fn variable(at: Interval) -> Self {
        Self { value: at, slope: Interval::ONE, curve: Interval::ZERO }
    }

    /// f of this, with f, f′ and f″ there.
    fn chain(self, [f, slope, curve]: [Interval; 3]) -> Self {
        Self { value: f, slope: slope * self.slope, curve: curve * self.slope.square() + slope * self.curve }
    }
}

impl Number for Jet {
    fn constant(value: Interval) -> Self {
        Self { value, slope: Interval::ZERO, curve: Interval::ZERO }
    }
    fn square(self) -> Self {
        let two = Interval::point(2.0);
        self.chain([self.value.square(), two * self.value, two])
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        let slope = Interval::point(0.5) / root;
        self.chain([root, slope, -(slope / (Interval::point(2.0) * self.value))])
    }
    fn reciprocal(self) -> Self {
        let one = Interval::ONE / self.value;
        let square = one.square();
        self.chain([one, -square, Interval::point(2.0) * square * one])
    }
    fn series(self, series: Series) -> Self {
        self.chain(series.derivatives(self.value))
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self { value: self.value + b.value, slope: self.slope + b.slope, curve: self.curve + b.curve }
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        Self { value: self.value - b.value, slope: self.slope - b.slope, curve: self.curve - b.curve }
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope, curve: -self.curve }
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        Self {
            value: self.value * b.value,
            slope: self.slope * b.value + self.value * b.slope,
            curve: self.curve * b.value + Interval::point(2.0) * self.slope * b.slope + self.value * b.curve,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (1 + t²)·√t/t at t = 4: 17/2, slope 2t·t^(−1/2) − (1 + t²) t^(−3/2)/2, and so on.
    #[test]
    fn derivatives_are_those_of_the_schoolbook() {
        let t = Jet::variable(Interval::point(4.0));
        let f = (Jet::constant(Interval::ONE) + t.square()) * t.sqrt() * t.reciprocal();
        // f = t^(−1/2) + t^(3/2)
        let known = [8.5, -0.5 / 8.0 + 1.5 * 2.0, 0.75 / 32.0 + 0.75 / 2.0];
        for (interval, known) in [f.value, f.slope, f.curve].into_iter().zip(known) {
            assert!(interval.low <= known && known <= interval.high && interval.high - interval.low < 1e-13);
        }
    }
}
