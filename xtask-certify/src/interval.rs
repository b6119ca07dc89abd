//! Real numbers between two doubles: every operation rounds outwards, so that the true result lies between its ends.
//!
//! Sums, products, quotients and square roots of doubles are rounded to the nearest one: the true value lies between the two next to it.
//! x ∓ (φ|x| + η) with φ a hair above half a unit is at or beyond them (Rump, Zimmermann, Boldo & Melquiond, BIT 49, 2009, 419–431), without a branch.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// All real numbers from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    pub low: f64,
    pub high: f64,
}

/// Half a unit in the last place of 1, and a hair.
const PHI: f64 = 0.5 * f64::EPSILON * (1.0 + f64::EPSILON);

/// The least and the greatest of four, none of which is no number.
#[inline(always)]
fn ends([p, q, r, s]: [f64; 4]) -> (f64, f64) {
    let least = |a: f64, b: f64| if a < b { a } else { b };
    let most = |a: f64, b: f64| if a > b { a } else { b };
    (least(least(p, q), least(r, s)), most(most(p, q), most(r, s)))
}

impl Interval {
    pub const ZERO: Self = Self::point(0.0);
    pub const ONE: Self = Self::point(1.0);
    /// π: the double of that name is below it, by less than the step to the next.
    pub const PI: Self = Self { low: std::f64::consts::PI, high: std::f64::consts::PI.next_up() };

    #[must_use]
    pub const fn point(value: f64) -> Self {
        Self { low: value, high: value }
    }

    #[must_use]
    pub const fn between(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    #[inline(always)]
    fn outwards(low: f64, high: f64) -> Self {
        Self { low: low - (PHI * low.abs() + f64::MIN_POSITIVE), high: high + (PHI * high.abs() + f64::MIN_POSITIVE) }
    }

    /// The least interval with both in it.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    #[must_use]
    pub fn square(self) -> Self {
        let (low, high) = (self.low * self.low, self.high * self.high);
        if self.low <= 0.0 && self.high >= 0.0 {
            Self { low: 0.0, ..Self::outwards(0.0, low.max(high)) }
        } else {
            let square = Self::outwards(low.min(high), low.max(high));
            Self { low: square.low.max(0.0), ..square }
        }
    }

    /// Of a number known not to be below zero.
    ///
    /// # Panics
    /// If all of it is below zero.
    #[must_use]
    pub fn sqrt(self) -> Self {
        assert!(self.high >= 0.0, "a square root of {self:?}");
        Self { low: self.low.max(0.0).sqrt().next_down().max(0.0), high: self.high.sqrt().next_up() }
    }

    /// Whether it is above zero for sure (`true`), below zero for sure (`false`), or neither.
    #[must_use]
    pub fn sign(self) -> Option<bool> {
        if self.low > 0.0 {
            Some(true)
        } else if self.high < 0.0 {
            Some(false)
        } else {
            None
        }
    }

    /// A number in it, and the most that any other is away.
    #[must_use]
    pub fn middle_and_radius(self) -> (f64, f64) {
        let middle = 0.5 * (self.low + self.high);
        (middle, (self.high - middle).max(middle - self.low).next_up())
    }

    /// The greatest size of a number in it.
    #[must_use]
    pub fn size(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self::outwards(self.low + b.low, self.high + b.high)
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        Self::outwards(self.low - b.high, self.high - b.low)
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        let (low, high) = if self.low >= 0.0 && b.low >= 0.0 {
            (self.low * b.low, self.high * b.high)
        } else {
            ends([self.low * b.low, self.low * b.high, self.high * b.low, self.high * b.high])
        };
        Self::outwards(low, high)
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        assert!(b.sign().is_some(), "a quotient by {b:?}");
        let (low, high) = ends([self.low / b.low, self.low / b.high, self.high / b.low, self.high / b.high]);
        Self::outwards(low, high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outwards_is_at_least_to_the_next_double() {
        for x in [1.0, 1.0 + f64::EPSILON, 2.0 - f64::EPSILON, 1.5, 3.0, 1e-300, 1e300, 0.0, f64::MIN_POSITIVE, 7e-310]
        {
            for x in [x, -x] {
                let out = Interval::outwards(x, x);
                assert!(out.low <= x.next_down() && out.high >= x.next_up(), "{x:e}");
                assert!(
                    x.abs() < 1e-290 || (out.low >= x.next_down().next_down() && out.high <= x.next_up().next_up())
                );
            }
        }
    }

    #[test]
    fn one_third_lies_strictly_within_and_a_whole_is_never_lost() {
        let third = Interval::ONE / Interval::point(3.0);
        assert!(third.low < third.high && third.high - third.low < 3e-16);
        let one = third + third + third;
        assert!(one.low < 1.0 && one.high > 1.0);
        let two = Interval::point(2.0).sqrt().square();
        assert!(two.low < 2.0 && two.high > 2.0);
        let across = Interval::between(-2.0, 3.0);
        assert!(across.square().low == 0.0 && across.square().high >= 9.0);
        assert!((across * across).low <= -6.0);
        assert_eq!((across.sign(), third.sign(), (-third).sign()), (None, Some(true), Some(false)));
    }
}
