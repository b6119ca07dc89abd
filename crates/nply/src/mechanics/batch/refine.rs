//! Roots that stand alone, brought to their last digits eight at a time.
//!
//! One or two of Halley's steps on a panel's polynomial lead into one of the short cells of a row's chart, on which the balance is
//! a polynomial to within rounding; as a rule one more ends there.

use super::panels::{Panels, place};
use super::sift::{Bracket, Doubt};
use crate::Handedness;
use crate::mechanics::row::{Chart, TERMS};
use crate::numerics::halley::{size, walk};
use crate::numerics::septic::{Coefficients, ORDER};
use crate::numerics::wide::{Four, LANES, Wide};

/// Roots that are worked out together.
pub(super) const TOGETHER: usize = REGISTERS * LANES;
const REGISTERS: usize = 2;

/// What the next step on a panel, and in a cell, would move at the most, in u.
const NEAR: f64 = 1e-6;
const SETTLED: f64 = 2e-14;
/// A root whose slope is not that far above what the polynomial leaves out might be several.
const STEEP: f64 = 1e4;
/// How far a root may lie beyond the cell it was sought in, which is one unit from its middle to its end.
const BEYOND: f64 = 1.0 + 1e-3;

/// A polynomial in powers of u.
type Powers = [Four; ORDER / LANES];

/// One root that is sought.
#[derive(Clone, Copy)]
pub(super) struct Sought<'a> {
    handedness: Handedness,
    panel: usize,
    bracket: Bracket,
    weights: [f64; TERMS],
    chart: &'a Chart,
    panels: &'a Panels,
}

/// One root that is found.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    pub(super) handedness: Handedness,
    pub(super) helical_angle: f64,
    pub(super) pitch_angle: f64,
}

#[inline(always)]
fn sum<W: Wide>(w: W, terms: &[Coefficients; TERMS], weights: &[f64; TERMS]) -> Powers {
    let mut sum = [w.splat(0.0); ORDER / LANES];
    for (term, &weight) in terms.iter().zip(weights) {
        for (sum, term) in sum.iter_mut().zip(term.as_chunks().0) {
            *sum = w.mul_add(w.splat(weight), w.load(term), *sum);
        }
    }
    [w.store(sum[0]), w.store(sum[1])]
}

impl<'a> Sought<'a> {
    /// `weights` carry the hand's sign.
    #[inline(always)]
    pub(super) fn new(
        (handedness, panel): (Handedness, usize),
        bracket: Bracket,
        weights: [f64; TERMS],
        (chart, panels): (&'a Chart, &'a Panels),
    ) -> Self {
        Self { handedness, panel, bracket, weights, chart, panels }
    }

    #[inline(always)]
    fn powers<W: Wide>(&self, w: W) -> Powers {
        sum(w, &self.panels.powers[self.panel], &self.weights)
    }
}

#[inline(always)]
fn columns<W: Wide>(w: W, powers: &[Powers]) -> [W::V; ORDER] {
    let [p, q, r, s] = [&powers[0], &powers[1], &powers[2], &powers[3]];
    let [a, b, c, d] = w.transpose([w.load(&p[0]), w.load(&q[0]), w.load(&r[0]), w.load(&s[0])]);
    let [e, f, g, h] = w.transpose([w.load(&p[1]), w.load(&q[1]), w.load(&r[1]), w.load(&s[1])]);
    [a, b, c, d, e, f, g, h]
}

/// Refines up to eight roots, at least one.
#[inline(always)]
pub(super) fn refine<W: Wide>(w: W, sought: &[Sought<'_>]) -> [Result<State, Doubt>; TOGETHER] {
    let mut powers = [[[0.0; LANES]; ORDER / LANES]; TOGETHER];
    let mut start = [w.splat(0.0); REGISTERS];
    let mut guess = [[[0.0; LANES]; REGISTERS]; 4];
    let count = sought.len().min(TOGETHER);
    for l in 0..TOGETHER {
        // the last stands in for those that are missing
        let here = &sought[l.min(count - 1)];
        powers[l] = here.powers(w);
        for (list, value) in guess.iter_mut().zip(here.bracket.crossing) {
            list.as_flattened_mut()[l] = value;
        }
    }
    for r in 0..REGISTERS {
        // where the control polygon crosses
        let [from, step, here, there] = &guess;
        let (here, there) = (w.load(&here[r]), w.load(&there[r]));
        let share = w.div(here, w.sub(here, there));
        start[r] = w.mul_add(w.load(&step[r]), share, w.load(&from[r]));
    }
    let coarse = walk(w, &[columns(w, &powers[..LANES]), columns(w, &powers[LANES..])], start, NEAR);
    let at = [w.store(coarse.u[0]), w.store(coarse.u[1])];
    let next = [w.store(coarse.next[0]), w.store(coarse.next[1])];
    let slope = [w.store(size(w, coarse.slope[0])), w.store(size(w, coarse.slope[1]))];

    let mut in_cell = [[0.0; LANES]; REGISTERS];
    let mut cells = [&sought[0].chart.cells[0]; TOGETHER];
    let mut sure = [false; TOGETHER];
    for l in 0..TOGETHER {
        let Sought { panel, bracket, chart, weights, .. } = &sought[l.min(count - 1)];
        let (at, next, slope) = (at.as_flattened()[l], next.as_flattened()[l], slope.as_flattened()[l]);
        let (middle, half) = place(*panel);
        let inside = (at >= bracket.ends[0]) & (at <= bracket.ends[1]);
        let t = middle + half * if inside { at } else { 0.0 };
        let cell = chart.cell(*panel >= LANES, t);
        sure[l] = inside & (next <= NEAR) & (slope > STEEP * bracket.tolerance) & !cell.edge;
        powers[l] = sum(w, &cell.powers, weights);
        in_cell.as_flattened_mut()[l] = (t - cell.middle) * cell.per_half;
        cells[l] = cell;
    }
    let start = [w.load(&in_cell[0]), w.load(&in_cell[1])];
    let fine = walk(w, &[columns(w, &powers[..LANES]), columns(w, &powers[LANES..])], start, SETTLED);
    let at = [w.store(fine.u[0]), w.store(fine.u[1])];
    let next = [w.store(fine.next[0]), w.store(fine.next[1])];
    let mut found = [Err(Doubt); TOGETHER];
    for l in 0..count {
        let (at, next) = (at.as_flattened()[l], next.as_flattened()[l]);
        if sure[l] && next <= SETTLED && at.abs() <= BEYOND {
            let (helical_angle, pitch_angle) = cells[l].angles(at);
            found[l] = Ok(State { handedness: sought[l].handedness, helical_angle, pitch_angle });
        }
    }
    found
}
