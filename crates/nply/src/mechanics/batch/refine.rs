//! Roots that stand alone, brought to their last digits eight at a time: one step has to wait for the other, so that two
//! registers take turns.
//!
//! One or two of Halley's steps on a panel's polynomial lead into one of the short cells of a row's chart, on which the balance is
//! a polynomial to within rounding; as a rule one more ends there.

use super::panels::{Panels, place};
use super::sift::{Bracket, Doubt};
use crate::Handedness;
use crate::mechanics::row::{Chart, TERMS};
use crate::numerics::septic::{Coefficients, ORDER};
use crate::numerics::wide::{Four, LANES, Wide};

/// Roots that are refined together.
pub(super) const TOGETHER: usize = REGISTERS * LANES;
const REGISTERS: usize = 2;

/// Steps on a panel or in a cell, after which a root that still moves is in doubt.
const MOST_STEPS: usize = 5;
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

/// A number for each of the roots in a register.
type Rows<V> = [V; REGISTERS];

/// Roots on their way.
struct Way<V> {
    u: Rows<V>,
    /// what the next step would move at the most
    next: Rows<V>,
    slope: Rows<V>,
}

/// Halley's steps for all roots, until the next would move none of them by more than `enough`.
#[inline(always)]
fn walk<W: Wide>(w: W, c: &[[W::V; ORDER]; REGISTERS], start: &[Four; REGISTERS], enough: f64) -> Way<W::V> {
    let zero = w.splat(0.0);
    let mut way = Way { u: [w.load(&start[0]), w.load(&start[1])], next: [zero; REGISTERS], slope: [zero; REGISTERS] };
    for _ in 0..MOST_STEPS {
        step(w, c, &mut way);
        let open = w.max(way.next[0], way.next[1]);
        if w.bits(w.at_least(w.splat(enough), open)) == 0b1111 {
            break;
        }
    }
    way
}

#[inline(always)]
fn step<W: Wide>(w: W, c: &[[W::V; ORDER]; REGISTERS], way: &mut Way<W::V>) {
    let zero = w.splat(0.0);
    let u = way.u;
    let mut f = [w.mul_add(c[0][7], u[0], c[0][6]), w.mul_add(c[1][7], u[1], c[1][6])];
    let mut slope = [c[0][7], c[1][7]];
    let mut bend = [zero; REGISTERS];
    for i in (0..6).rev() {
        for r in 0..REGISTERS {
            bend[r] = w.mul_add(bend[r], u[r], slope[r]);
            slope[r] = w.mul_add(slope[r], u[r], f[r]);
            f[r] = w.mul_add(f[r], u[r], c[r][i]);
        }
    }
    for r in 0..REGISTERS {
        let minus = w.sub(zero, f[r]);
        let curved = w.mul(minus, bend[r]);
        let inverse = w.div(w.splat(1.0), w.mul_add(slope[r], slope[r], curved));
        let by = w.mul(w.mul(minus, slope[r]), inverse);
        let share = w.add(size(w, by), size(w, w.mul(curved, inverse)));
        way.u[r] = w.add(u[r], by);
        // no number: the second is taken, which is none either
        way.next[r] = w.mul(size(w, by), w.mul(share, share));
        way.slope[r] = slope[r];
    }
}

#[inline(always)]
fn size<W: Wide>(w: W, a: W::V) -> W::V {
    w.max(a, w.sub(w.splat(0.0), a))
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
    let mut start = [[0.0; LANES]; REGISTERS];
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
        start[r] = w.store(w.mul_add(w.load(&step[r]), share, w.load(&from[r])));
    }
    let coarse = walk(w, &[columns(w, &powers[..LANES]), columns(w, &powers[LANES..])], &start, NEAR);
    let at = [w.store(coarse.u[0]), w.store(coarse.u[1])];
    let next = [w.store(coarse.next[0]), w.store(coarse.next[1])];
    let slope = [w.store(size(w, coarse.slope[0])), w.store(size(w, coarse.slope[1]))];

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
        start.as_flattened_mut()[l] = (t - cell.middle) * cell.per_half;
        cells[l] = cell;
    }
    let fine = walk(w, &[columns(w, &powers[..LANES]), columns(w, &powers[LANES..])], &start, SETTLED);
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
