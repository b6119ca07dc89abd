//! The pieces of the branch on which the varied datum runs one way, and the values for which that is in doubt.

use core::ops::Range;

use super::cell::Cell;
use super::line::Line;
use super::values::{Values, sure};
use crate::numerics::septic::{self, Coefficients, ORDER};

/// Halvings of one cell, after which the values left are in doubt.
const DEEPEST: u32 = 10;
/// Halvings in one row: where rounding alone is at work they would go on and on.
const MOST_HALVINGS: u32 = 4000;

/// Part of a cell on which x = −A/B is monotone, with the values it holds.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub(super) cell: usize,
    /// which of the two hands' lines
    pub(super) line: usize,
    pub(super) values: Range<usize>,
    /// u at both ends
    pub(super) u: [f64; 2],
    /// x at both ends
    pub(super) x: [f64; 2],
    /// du/dx at both ends
    pub(super) slope: [f64; 2],
    /// whether B > 0
    pub(super) positive: bool,
    /// whether dG/dθ > 0 on all of it
    pub(super) rises: bool,
}

/// Pieces and doubts of a row.
#[derive(Debug)]
pub(super) struct Search<'a> {
    pub(super) values: Values<'a>,
    pub(super) pieces: Vec<Piece>,
    pub(super) doubts: Vec<Range<usize>>,
    halvings: u32,
}

/// A, B and W = A′B − AB′ between two places in a cell, and how far each may be off.
struct Part {
    u: [f64; 2],
    a: Coefficients,
    b: (Coefficients, f64),
    wronskian: (Coefficients, f64),
    /// of A + xB for any value x
    tolerance: f64,
}

impl<'a> Search<'a> {
    pub(super) fn new(values: Values<'a>) -> Self {
        Self { values, pieces: Vec::new(), doubts: Vec::new(), halvings: MOST_HALVINGS }
    }

    /// Takes in one cell for one hand.
    #[inline]
    pub(super) fn judge(&mut self, cells: &[Cell], cell: usize, lines: &[Line; 2], line: usize) {
        let (here, Line { a, b, pairs, .. }) = (&cells[cell], &lines[line]);
        let (a, a_tolerance) = here.terms.sum(a);
        let b = here.terms.sum(b);
        let tolerance = a_tolerance + self.values.largest() * b.1;
        if self.values.clear_of(&a, &b.0, tolerance) {
            return;
        }
        if here.edge {
            return self.judge_edge(&a, &b.0, tolerance);
        }
        let part = Part { u: [-1.0, 1.0], a, b, wronskian: here.wronskians.sum(pairs), tolerance };
        self.split(&part, (cell, here.flat, line), DEEPEST);
    }

    /// At coordinate 0 all terms left may vanish together: then the quotient by the coordinate tells.
    #[cold]
    fn judge_edge(&mut self, a: &Coefficients, b: &Coefficients, tolerance: f64) {
        let quotient = |f: &Coefficients| {
            // t·Σ cᵢ Bᵢ⁶ = Σ bᵢ Bᵢ⁷ gives cᵢ = 7 bᵢ₊₁/(i + 1); the last is told twice to keep the form
            core::array::from_fn(|i| f[(i + 1).min(ORDER - 1)] * ((ORDER - 1) as f64 / (i + 1).min(ORDER - 1) as f64))
        };
        if b[0] == 0.0 && a[0].abs() <= tolerance {
            self.doubt(&quotient(a), &quotient(b), (ORDER - 1) as f64 * tolerance);
        } else {
            self.doubt(a, b, tolerance);
        }
    }

    fn doubt(&mut self, a: &Coefficients, b: &Coefficients, tolerance: f64) {
        self.doubts.extend(self.values.doubtful(a, b, tolerance).into_iter().filter(|range| !range.is_empty()));
    }

    fn split(&mut self, part: &Part, place: (usize, bool, usize), depth: u32) {
        if sure(&part.wronskian) && sure(&part.b) {
            return self.keep(part, place);
        }
        let (a, b) = (&part.a, &part.b.0);
        if self.values.doubtful(a, b, part.tolerance).iter().all(Range::is_empty) {
            return;
        }
        if depth == 0 || self.halvings == 0 {
            return self.doubt(a, b, part.tolerance);
        }
        self.halvings -= 1;
        let middle = 0.5 * (part.u[0] + part.u[1]);
        let [a, b, w] = [a, b, &part.wronskian.0].map(septic::halves);
        for (i, u) in [[part.u[0], middle], [middle, part.u[1]]].into_iter().enumerate() {
            let half = Part {
                u,
                a: a[i],
                b: (b[i], part.b.1),
                wronskian: (w[i], part.wronskian.1),
                tolerance: part.tolerance,
            };
            self.split(&half, place, depth - 1);
        }
    }

    /// Keeps a monotone part with its values. Of its ends that towards θ = 0 belongs to it.
    fn keep(&mut self, part: &Part, (cell, flat, line): (usize, bool, usize)) {
        let (a, b, w) = (&part.a, &part.b.0, &part.wronskian.0);
        let ends = [0, ORDER - 1];
        let x = ends.map(|i| -a[i] / b[i]);
        let (own, other) = if flat { (x[1], x[0]) } else { (x[0], x[1]) };
        let values = if own < other {
            self.values.below(own)..self.values.below(other)
        } else {
            self.values.up_to(other)..self.values.up_to(own)
        };
        if !values.is_empty() {
            let positive = b[0] > 0.0;
            // G′ = (A′B − AB′)/B by u, which runs against θ in a flat cell
            let rises = ((w[0] > 0.0) == positive) != flat;
            let slope = ends.map(|i| -b[i] * b[i] / w[i]);
            self.pieces.push(Piece { cell, line, values, u: part.u, x, slope, positive, rises });
        }
    }

    /// The values in doubt, each once, ascending.
    pub(super) fn merge_doubts(&mut self) {
        self.doubts.sort_by_key(|range| range.start);
        self.doubts.dedup_by(|next, before| {
            let joined = next.start <= before.end;
            if joined {
                before.end = before.end.max(next.end);
            }
            joined
        });
    }

    /// The values of a piece that are in no doubt.
    pub(super) fn undoubted(&self, values: &Range<usize>) -> impl Iterator<Item = Range<usize>> {
        let (mut start, end) = (values.start, values.end);
        // one more at the end, of nothing, lets the values behind the last doubt out
        let doubts = self.doubts.iter().cloned().chain(core::iter::once(end..end));
        doubts.filter_map(move |doubt| {
            let before = start..doubt.start.min(end);
            start = start.max(doubt.end);
            (!before.is_empty()).then_some(before)
        })
    }
}
