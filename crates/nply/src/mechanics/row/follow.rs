//! The roots on a monotone piece, value by value.

use core::ops::Range;

use super::cell::Cell;
use super::line::Line;
use super::piece::Piece;
use crate::numerics::dual::Dual;
use crate::numerics::halley::{size, walk};
use crate::numerics::root::bracketed;
use crate::numerics::septic::{self, Coefficients, ORDER};
use crate::numerics::wide::{Four, LANES, Wide};

/// Roots that are worked out together.
const TOGETHER: usize = REGISTERS * LANES;
const REGISTERS: usize = 2;

/// What the next step would move at the most, in u.
const SETTLED: f64 = 2e-14;

/// A number for each root.
type Block = [Four; REGISTERS];

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
    fn wide<W: Wide>(&self, w: W, x: W::V) -> W::V {
        let s = w.mul(w.sub(x, w.splat(self.x)), w.splat(self.per_x));
        let [c0, c1, c2, c3] = self.cubic;
        let u = w.mul_add(s, w.mul_add(s, w.splat(c3), w.splat(c2)), w.splat(c1));
        w.mul_add(s, u, w.splat(c0))
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
    pub(super) fn follow<W: Wide>(&self, w: W, list: &[f64], values: Range<usize>, mut found: impl FnMut(Found)) {
        let mut first = values.start;
        for given in list[values].chunks(TOGETHER) {
            // the last stands in for those that are missing
            let mut x = [[given[given.len() - 1]; LANES]; REGISTERS];
            for (x, &given) in x.as_flattened_mut().iter_mut().zip(given) {
                *x = given;
            }
            let u = self.roots(w, &x);
            let (apart, together) = self.pressures(w, &x, &u);
            let (u, apart, together) = (u.as_flattened(), apart.as_flattened(), together.as_flattened());
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
    fn roots<W: Wide>(&self, w: W, list: &Block) -> Block {
        let [from, to] = self.piece.u;
        let (mut c, mut x) = ([[w.splat(0.0); ORDER]; REGISTERS], [w.splat(0.0); REGISTERS]);
        for r in 0..REGISTERS {
            x[r] = w.load(&list[r]);
            for (i, c) in c[r].iter_mut().enumerate() {
                *c = w.mul_add(x[r], w.splat(self.b[i]), w.splat(self.a[i]));
            }
        }
        let mut start = x;
        for start in &mut start {
            *start = self.start.wide(w, *start);
        }
        let way = walk(w, &c, start, SETTLED);
        let mut u = [[0.0; LANES]; REGISTERS];
        for (u, at) in u.iter_mut().zip(way.u) {
            *u = w.store(at);
        }
        for r in 0..REGISTERS {
            let inside = w.and(w.at_least(way.u[r], w.splat(from)), w.at_least(w.splat(to), way.u[r]));
            let settled = w.bits(w.and(inside, w.at_least(w.splat(SETTLED), way.next[r])));
            if settled != 0b1111 {
                for l in 0..LANES {
                    if settled >> l & 1 == 0 {
                        u[r][l] = self.bracketed(list[r][l]);
                    }
                }
            }
        }
        u
    }

    /// p₁ and p at every root; both are 0 where they are lost in the rounding of their terms.
    #[inline(always)]
    fn pressures<W: Wide>(&self, w: W, x: &Block, u: &Block) -> (Block, Block) {
        let mut both = ([[0.0; LANES]; REGISTERS], [[0.0; LANES]; REGISTERS]);
        let rounding = w.splat(self.pressure_rounding);
        for r in 0..REGISTERS {
            let (x, u) = (w.load(&x[r]), w.load(&u[r]));
            let mut sum = w.splat(0.0);
            for i in (0..ORDER).rev() {
                let mut coefficient = w.splat(self.pressure_a[i]);
                if let Some(b) = &self.pressure_b {
                    coefficient = w.mul_add(x, w.splat(b[i]), coefficient);
                }
                sum = w.mul_add(sum, u, coefficient);
            }
            sum = w.select(w.at_least(rounding, size(w, sum)), w.splat(0.0), sum);
            both.1[r] = w.store(w.mul(sum, wide_value(w, &self.cell.pressure.factor, u)));
            if let Some(divisor) = &self.cell.pressure.divisor {
                sum = w.div(sum, wide_value(w, divisor, u));
            }
            both.0[r] = w.store(sum);
        }
        both
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

/// As [`septic::value`].
#[inline(always)]
fn wide_value<W: Wide>(w: W, powers: &Coefficients, u: W::V) -> W::V {
    let mut sum = w.splat(powers[ORDER - 1]);
    for i in (0..ORDER - 1).rev() {
        sum = w.mul_add(sum, u, w.splat(powers[i]));
    }
    sum
}

fn derivative(powers: &Coefficients) -> Coefficients {
    core::array::from_fn(|i| powers.get(i + 1).map_or(0.0, |coefficient| (i + 1) as f64 * coefficient))
}
