//! The roots on a monotone piece, value by value.

use core::ops::Range;

use super::cell::Cell;
use super::line::Line;
use super::piece::Piece;
use crate::numerics::dual::Dual;
use crate::numerics::root::bracketed;
use crate::numerics::septic::{self, Coefficients};

/// Roots that are worked out together, in loops without a branch.
const BLOCK: usize = 16;
/// A block is filled up to a multiple of this, by its last value.
const LANES: usize = 4;
/// Steps taken together; then the roots that still move are bracketed one by one.
const STEPS: usize = 3;
/// What the next step would move at the most, in u.
const SETTLED: f64 = 2e-14;

/// A number for each root.
type Block = [f64; BLOCK];

/// What is found at one root.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) value: usize,
    pub(super) u: f64,
    pub(super) interstrand_pressure: f64,
    pub(super) resultant_pressure: f64,
    /// whether p₁ is lost in the rounding of its terms
    pub(super) lost: bool,
}

/// A piece with its polynomials.
pub(super) struct Follower<'a> {
    piece: &'a Piece,
    cell: &'a Cell,
    a: Coefficients,
    b: Coefficients,
    pressure_a: Coefficients,
    /// `None` where the varied datum does not press
    pressure_b: Option<Coefficients>,
    pressure_rounding: f64,
    start: Start,
}

/// The cubic u(x) with given values and slopes at both ends.
struct Start {
    x: f64,
    per_x: f64,
    cubic: [f64; 4],
}

impl Start {
    fn new(piece: &Piece) -> Self {
        let ([x, to], [u, u_to]) = (piece.x, piece.u);
        let (length, rise) = (to - x, u_to - u);
        // slopes of at most thrice the chord's keep a cubic monotone, and so between its ends
        let [m0, m1] = piece.slope.map(|slope| (slope * length).max(0.0).min(3.0 * rise));
        Self { x, per_x: 1.0 / length, cubic: [u, m0, 3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise] }
    }

    #[inline(always)]
    fn fill(&self, x: &[f64], u: &mut [f64]) {
        for (u, &x) in u.iter_mut().zip(x) {
            *u = self.at(x);
        }
    }

    #[inline(always)]
    fn at(&self, x: f64) -> f64 {
        let s = (x - self.x) * self.per_x;
        let [c0, c1, c2, c3] = self.cubic;
        c0 + s * (c1 + s * (c2 + s * c3))
    }
}

impl<'a> Follower<'a> {
    pub(super) fn new(piece: &'a Piece, cell: &'a Cell, line: &Line, largest: f64) -> Self {
        let pressure = &cell.pressure;
        let size = line.pressure_a.size(&pressure.size) + largest * line.pressure_b.size(&pressure.size);
        Self {
            piece,
            cell,
            a: line.a.sum(&cell.powers),
            b: line.b.sum(&cell.powers),
            pressure_a: line.pressure_a.sum(&pressure.terms),
            pressure_b: (!line.pressure_b.is_empty()).then(|| line.pressure_b.sum(&pressure.terms)),
            pressure_rounding: 16.0 * f64::EPSILON * size,
            start: Start::new(piece),
        }
    }

    /// Hands the root for each of these values of the piece to `found`.
    #[inline(always)]
    pub(super) fn follow(&self, list: &[f64], values: Range<usize>, mut found: impl FnMut(Found)) {
        let [mut x, mut u, mut apart, mut together]: [Block; 4] = [[0.0; BLOCK]; 4];
        let mut first = values.start;
        for given in list[values].chunks(BLOCK) {
            let filled = given.len().next_multiple_of(LANES);
            x[..given.len()].copy_from_slice(given);
            x[given.len()..filled].fill(given[given.len() - 1]);
            self.roots(&x[..filled], &mut u[..filled]);
            self.pressures(&x[..filled], &u[..filled], &mut apart[..filled], &mut together[..filled]);
            for l in 0..given.len() {
                found(Found {
                    value: first + l,
                    u: u[l],
                    interstrand_pressure: apart[l],
                    resultant_pressure: together[l],
                    lost: together[l] == 0.0,
                });
            }
            first += given.len();
        }
    }

    #[inline(always)]
    fn roots(&self, x: &[f64], u: &mut [f64]) {
        let [from, to] = self.piece.u;
        let mut error = [0.0; BLOCK];
        let error = &mut error[..x.len()];
        self.start.fill(x, u);
        for _ in 0..STEPS {
            self.step(x, u, error);
            let settled = |all, (&u, &error): (&f64, &f64)| all & (error <= SETTLED) & (u >= from) & (u <= to);
            if u.iter().zip(&*error).fold(true, settled) {
                return;
            }
        }
        for ((u, &error), &x) in u.iter_mut().zip(&*error).zip(x) {
            if !(error <= SETTLED && *u >= from && *u <= to) {
                *u = self.bracketed(x);
            }
        }
    }

    /// One of Halley's steps for every root, and about what the next would move.
    #[inline(always)]
    fn step(&self, x: &[f64], u: &mut [f64], error: &mut [f64]) {
        let (a, b) = (self.a, self.b);
        for ((u, error), &x) in u.iter_mut().zip(error).zip(x) {
            let [c0, c1, c2, c3, c4, c5, c6, c7]: Coefficients = core::array::from_fn(|i| a[i] + x * b[i]);
            let at = *u;
            let (mut f, mut df, mut half_d2f) = (c7 * at + c6, c7, c7);
            (df, f) = (df * at + f, f * at + c5);
            for c in [c4, c3, c2, c1] {
                (half_d2f, df, f) = (half_d2f * at + df, df * at + f, f * at + c);
            }
            (half_d2f, df, f) = (half_d2f * at + df, df * at + f, f * at + c0);
            let bend = f * half_d2f;
            let inverse = 1.0 / (df * df - bend);
            let step = f * df * inverse;
            let share = step.abs() + (bend * inverse).abs();
            *u = at - step;
            *error = step.abs() * share * share;
        }
    }

    /// p₁ and p at every root; both are 0 where they are lost in the rounding of their terms.
    #[inline(always)]
    fn pressures(&self, x: &[f64], u: &[f64], apart: &mut [f64], together: &mut [f64]) {
        let (a, factor, rounding) = (self.pressure_a, self.cell.pressure.factor, self.pressure_rounding);
        match &self.pressure_b {
            Some(b) => {
                for ((sum, &u), &x) in apart.iter_mut().zip(u).zip(x) {
                    let line: Coefficients = core::array::from_fn(|i| a[i] + x * b[i]);
                    *sum = septic::value(&line, u);
                }
            }
            None => {
                for (sum, &u) in apart.iter_mut().zip(u) {
                    *sum = septic::value(&a, u);
                }
            }
        }
        for ((sum, product), &u) in apart.iter_mut().zip(together).zip(u) {
            *sum = if sum.abs() > rounding { *sum } else { 0.0 };
            *product = *sum * septic::value(&factor, u);
        }
        if let Some(divisor) = &self.cell.pressure.divisor {
            for (sum, &u) in apart.iter_mut().zip(u) {
                *sum /= septic::value(divisor, u);
            }
        }
    }

    /// The root for a value of which the steps did not settle between the piece's ends.
    #[cold]
    fn bracketed(&self, x: f64) -> f64 {
        let Piece { u: [from, to], x: [x_from, x_to], positive, .. } = *self.piece;
        if (x <= x_from) == (x_from < x_to) {
            return from;
        }
        if (x >= x_to) == (x_from < x_to) {
            return to;
        }
        let (slope_a, slope_b) = (derivative(&self.a), derivative(&self.b));
        let f = |t: f64| {
            let u = t - 1.0;
            let line = |a: &Coefficients, b: &Coefficients| septic::value(a, u) + x * septic::value(b, u);
            Dual::new(line(&self.a, &self.b), line(&slope_a, &slope_b))
        };
        // A + xB = (x − x_from) B at the piece's beginning
        let (at, _) = bracketed(f, from + 1.0, to + 1.0, (x > x_from) == positive, 1.0 + self.start.at(x));
        at - 1.0
    }
}

fn derivative(powers: &Coefficients) -> Coefficients {
    core::array::from_fn(|i| powers.get(i + 1).map_or(0.0, |coefficient| (i + 1) as f64 * coefficient))
}
