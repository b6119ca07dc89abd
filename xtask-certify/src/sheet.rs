//! The branch of touching strands in pieces on which everything is explicit: no contact condition is solved.
//!
//! Contact (5) is E + e sin E = 2π/n with e = tan²θ, E the angle between neighbours' touching points seen along the axis. Given E it is
//! linear in e. With λ = 2π/n and N = λ − E + sin E:
//!
//! ```text
//! sin²θ = (λ − E)/N,   cos²θ = sin E/N,   D = cos²θ + sin²θ cos²(E/2),   ρ cos θ = 2 cos(E/2)/(N √D),   q cos²θ = sin²θ cos²(E/2)/D
//! ```
//!
//! Straight strands are E = λ, where θ goes as the root of λ − E; flat rings are E = 0, where π/2 − θ goes as the root of E. So the
//! coordinates are those roots: v = √(λ − E), w = √E. Two strands touch along a line up to 45°, there y = tan θ; beyond it all depends on the
//! square of z = π − E.

use nply::mechanics::Balance;

use crate::interval::Interval;
use crate::jet::Number;
use crate::series::Series;

/// Terms of the balance, for the weights (1, γ, εγφ̄a, f, εm) or (1, 0, εγ r u₃, f, εm).
pub const TERMS: usize = 5;

/// A stretch of the branch by its coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sheet {
    /// n = 2 up to 45°: y = tan θ
    Line,
    /// n = 2 from 45°: z² = (π − E)²
    Fork,
    /// n ≥ 3 from straight strands: v = √(λ − E)
    Steep,
    /// to flat rings: w = √E
    Flat,
}

/// What the balance is divided by, a positive factor: a power of the coordinate that all of its terms have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Division {
    /// the power
    pub power: u32,
    /// the moment is that which holds straight strands, m = n·(γφ̄a or γ r u₃): both terms are one, which vanishes as sin²θ
    pub held: bool,
}

/// sin θ and cos θ, or over the coordinate that they vanish with, and what follows from them.
struct Shape<T> {
    sine: T,
    cosine: T,
    radius: T,
    share: T,
    sine_square: T,
    cosine_square: T,
}

impl Sheet {
    /// From straight strands to flat rings.
    #[must_use]
    pub const fn all(strands: u32) -> &'static [Self] {
        if strands == 2 { &[Self::Line, Self::Fork, Self::Flat] } else { &[Self::Steep, Self::Flat] }
    }

    /// The greatest coordinate; the least is 0. Where two sheets meet at other than 45° they overlap by some last digits, see [`seam`](Self::seam).
    #[must_use]
    pub fn end(self, strands: u32) -> f64 {
        match self {
            Self::Line => 1.0,
            Self::Fork => 4.0,
            Self::Steep => self.seam(strands).high,
            Self::Flat if strands == 2 => (Interval::PI - Interval::point(2.0)).sqrt().high,
            Self::Flat => (Interval::PI / Interval::point(f64::from(strands))).sqrt().low,
        }
    }

    /// Where this sheet ends for flatter strands: all coordinates that belong to the next sheet's border too.
    #[must_use]
    pub fn seam(self, strands: u32) -> Interval {
        match self {
            Self::Line => Interval::ONE,
            Self::Fork => {
                let next = Self::Flat.end(strands);
                (Interval::PI - Interval::point(next).square()).square().hull(Interval::point(4.0))
            }
            Self::Steep => {
                let next = Self::Flat.end(strands);
                (lambda(strands) - Interval::point(next).square()).sqrt()
            }
            Self::Flat => Interval::ZERO,
        }
    }

    /// Whether the coordinate grows with the helical angle.
    #[must_use]
    pub fn rises(self) -> bool {
        self != Self::Flat
    }

    fn shape<T: Number>(self, strands: u32, t: T) -> Shape<T> {
        let number = |value: f64| T::constant(Interval::point(value));
        let (one, two, quarter) = (number(1.0), number(2.0), number(0.25));
        match self {
            Self::Line => {
                let cosine_square = (one + t.square()).reciprocal();
                let cosine = cosine_square.sqrt();
                Shape {
                    sine: cosine,
                    cosine,
                    radius: cosine,
                    share: number(0.0),
                    sine_square: t.square() * cosine_square,
                    cosine_square,
                }
            }
            Self::Fork => {
                let half = t * quarter;
                // sin(z/2)/(z/2) and cos(z/2): of E, which is π less, they are cosine and sine
                let (sinc, cos) = (half.series(Series::SineOverArgument), half.series(Series::Cosine));
                let whole = sinc * cos; // sin z/z
                let sine_square = (one + whole).reciprocal();
                let cosine_square = whole * sine_square;
                let half_square = half * sinc.square();
                let d = cosine_square + sine_square * half_square;
                Shape {
                    sine: sine_square.sqrt(),
                    cosine: cosine_square.sqrt(),
                    radius: sinc * sine_square * d.sqrt().reciprocal(),
                    share: half_square * d.reciprocal(),
                    sine_square,
                    cosine_square,
                }
            }
            Self::Steep | Self::Flat => {
                let lambda = T::constant(lambda(strands));
                let steep = self == Self::Steep;
                let anomaly = if steep { lambda - t.square() } else { t.square() };
                let rest = if steep { t.square() } else { lambda - t.square() };
                let half = anomaly.square() * quarter;
                let (sinc, cos) = (half.series(Series::SineOverArgument), half.series(Series::Cosine));
                let over = sinc * cos; // sin E/E
                let sin = anomaly * over;
                let inverse = (rest + sin).reciprocal();
                let (sine_square, cosine_square) = (rest * inverse, sin * inverse);
                let d = cosine_square + sine_square * cos.square();
                Shape {
                    sine: if steep { inverse.sqrt() } else { sine_square.sqrt() },
                    cosine: if steep { cosine_square.sqrt() } else { (over * inverse).sqrt() },
                    radius: two * cos * inverse * d.sqrt().reciprocal(),
                    share: cos.square() * d.reciprocal(),
                    sine_square,
                    cosine_square,
                }
            }
        }
    }

    /// The powers of the coordinate in the terms of cos²θ·G.
    #[must_use]
    pub fn powers(self, balance: Balance, held: bool) -> [u32; TERMS] {
        match (self, balance) {
            (Self::Line | Self::Steep, _) => [3, 1, if held { 2 } else { 0 }, 1, 0],
            (Self::Fork, _) => [0; TERMS],
            (Self::Flat, Balance::Contact) => [1, 3, 1, 0, 0],
            (Self::Flat, Balance::Radial) => [3, 3, 1, 0, 2],
        }
    }

    /// The terms of cos²θ·G over a power of the coordinate, of (40) with (45), or with nρ²p̂ρ′ added for the contact balance. Terms with
    /// less than that power are zero here: their weights must be.
    #[must_use]
    pub fn terms<T: Number>(self, strands: u32, balance: Balance, division: Division, t: T) -> [T; TERMS] {
        let zero = T::constant(Interval::ZERO);
        let n = T::constant(Interval::point(f64::from(strands)));
        let two = T::constant(Interval::point(2.0));
        let Shape { sine, cosine, radius, share, sine_square, cosine_square } = self.shape(strands, t);
        let q_part = match balance {
            Balance::Contact => sine_square * share,
            Balance::Radial => zero,
        };
        let rest = cosine_square - q_part;
        let cos_double = rest - sine_square;
        // what is left of sine and cosine when the coordinate is taken out
        let (left_sine, left_cosine) = (sine.square(), cosine.square());
        let flat_radial = self == Self::Flat && balance == Balance::Radial;
        let held = division.held && matches!(self, Self::Line | Self::Steep);
        let one = T::constant(Interval::ONE);
        let left = [
            if flat_radial {
                n * two * sine * left_sine * cosine * left_cosine
            } else {
                n * sine * left_sine * cosine * (two * cosine_square - q_part)
            },
            n * sine * cosine * if self == Self::Flat { left_cosine } else { cosine_square } * cos_double,
            if held {
                -(n * radius * left_sine * (rest * (one + cosine).reciprocal() + cosine))
            } else {
                n * radius * cosine * cos_double
            },
            radius.square() * sine,
            if held {
                zero
            } else if flat_radial {
                -(radius * left_cosine)
            } else {
                -(radius * rest)
            },
        ];
        let powers = self.powers(balance, held);
        std::array::from_fn(|k| match powers[k].checked_sub(division.power) {
            None => zero,
            Some(0) => left[k],
            Some(1) => left[k] * t,
            Some(2) => left[k] * t.square(),
            Some(_) => left[k] * t.square() * t,
        })
    }
}

fn lambda(strands: u32) -> Interval {
    Interval::point(2.0) * Interval::PI / Interval::point(f64::from(strands))
}
