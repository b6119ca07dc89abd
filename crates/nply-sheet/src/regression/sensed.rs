//! A number that knows how it changes: with the two coordinates of a row's state, and with every parameter.

use core::ops::{Add, Mul, Neg, Sub};

/// Parameters of a ply that can be estimated: ln r, ln of what gives B, ln of what gives C, the twist, ln EA.
pub(super) const SLOTS: usize = 5;
/// A state's coordinates come first.
pub(super) const COORDINATES: usize = 2;
const WIDTH: usize = COORDINATES + SLOTS;

/// A value with its slopes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sensed {
    pub(super) value: f64,
    slopes: [f64; WIDTH],
}

impl Sensed {
    pub(super) const fn constant(value: f64) -> Self {
        Self { value, slopes: [0.0; WIDTH] }
    }

    /// A coordinate of the state.
    pub(super) fn coordinate(value: f64, k: usize) -> Self {
        let mut number = Self::constant(value);
        number.slopes[k] = 1.0;
        number
    }

    /// A parameter.
    pub(super) fn slot(value: f64, k: usize) -> Self {
        Self::coordinate(value, COORDINATES + k)
    }

    /// A function of numbers, by its value and its slope with each.
    pub(super) fn of<const N: usize>(value: f64, parts: [(f64, Self); N]) -> Self {
        let mut number = Self::constant(value);
        for (slope, part) in parts {
            // what does not depend on anything adds nothing, however steep
            if part.slopes.iter().any(|s| *s != 0.0) {
                for (sum, s) in number.slopes.iter_mut().zip(part.slopes) {
                    *sum += slope * s;
                }
            }
        }
        number
    }

    pub(super) fn recip(self) -> Self {
        let inverse = 1.0 / self.value;
        Self::of(inverse, [(-inverse * inverse, self)])
    }

    pub(super) fn exp(self) -> Self {
        let value = libm::exp(self.value);
        Self::of(value, [(value, self)])
    }

    /// By the state's coordinates.
    pub(super) fn by_place(&self) -> [f64; COORDINATES] {
        [self.slopes[0], self.slopes[1]]
    }

    /// By the parameters.
    pub(super) fn by_slot(&self) -> [f64; SLOTS] {
        core::array::from_fn(|k| self.slopes[COORDINATES + k])
    }

    pub(super) fn is_finite(&self) -> bool {
        self.value.is_finite() && self.slopes.iter().all(|slope| slope.is_finite())
    }
}

impl Add for Sensed {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self::of(self.value + b.value, [(1.0, self), (1.0, b)])
    }
}

impl Sub for Sensed {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        Self::of(self.value - b.value, [(1.0, self), (-1.0, b)])
    }
}

impl Neg for Sensed {
    type Output = Self;
    fn neg(self) -> Self {
        Self::of(-self.value, [(-1.0, self)])
    }
}

impl Mul for Sensed {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        Self::of(self.value * b.value, [(b.value, self), (self.value, b)])
    }
}

impl Mul<Sensed> for f64 {
    type Output = Sensed;
    fn mul(self, b: Sensed) -> Sensed {
        Sensed::of(self * b.value, [(self, b)])
    }
}
