//! Roots that stand alone, brought to their last digits four at a time.
//!
//! Three of Halley's steps on a panel's polynomial lead into one of the short cells of a row's chart, on which the balance is a
//! polynomial to within rounding; two more end there.

use super::panels::{Panels, place};
use super::sift::{Bracket, Doubt};
use crate::Handedness;
use crate::mechanics::row::{Chart, TERMS};
use crate::numerics::septic::{Coefficients, ORDER};
use crate::numerics::wide::{Four, LANES, Wide};

/// Steps on a panel, and in a cell.
const COARSE: usize = 3;
const FINE: usize = 2;
/// What the last step on a panel, and what a further one in a cell would move at the most, in u.
const NEAR: f64 = 1e-4;
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
    pub(super) row: usize,
    pub(super) handedness: Handedness,
    panel: usize,
    bracket: Bracket,
    weights: [f64; TERMS],
    chart: &'a Chart,
    panels: &'a Panels,
}

/// One root that is found: the helical and the pitch angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Angles {
    pub(super) helical: f64,
    pub(super) pitch: f64,
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
        (row, handedness, panel): (usize, Handedness, usize),
        bracket: Bracket,
        weights: [f64; TERMS],
        (chart, panels): (&'a Chart, &'a Panels),
    ) -> Self {
        Self { row, handedness, panel, bracket, weights, chart, panels }
    }

    #[inline(always)]
    fn powers<W: Wide>(&self, w: W) -> Powers {
        sum(w, &self.panels.powers[self.panel], &self.weights)
    }
}

/// Four of Halley's steps, one for each lane.
struct Step<V> {
    u: V,
    /// what the next would move at the most
    next: V,
    slope: V,
}

#[inline(always)]
fn step<W: Wide>(w: W, c: &[W::V; ORDER], u: W::V) -> Step<W::V> {
    let mut f = w.mul_add(c[7], u, c[6]);
    let mut slope = c[7];
    let mut bend = w.splat(0.0);
    for i in (0..6).rev() {
        bend = w.mul_add(bend, u, slope);
        slope = w.mul_add(slope, u, f);
        f = w.mul_add(f, u, c[i]);
    }
    let minus = w.sub(w.splat(0.0), f);
    let curved = w.mul(minus, bend);
    let inverse = w.div(w.splat(1.0), w.mul_add(slope, slope, curved));
    let move_by = w.mul(w.mul(minus, slope), inverse);
    let size = size(w, move_by);
    let share = w.add(size, self::size(w, w.mul(curved, inverse)));
    Step { u: w.add(u, move_by), next: w.mul(size, w.mul(share, share)), slope }
}

#[inline(always)]
fn size<W: Wide>(w: W, a: W::V) -> W::V {
    w.max(a, w.sub(w.splat(0.0), a))
}

#[inline(always)]
fn columns<W: Wide>(w: W, powers: [&Powers; LANES]) -> [W::V; ORDER] {
    let [p, q, r, s] = powers;
    let [a, b, c, d] = w.transpose([w.load(&p[0]), w.load(&q[0]), w.load(&r[0]), w.load(&s[0])]);
    let [e, f, g, h] = w.transpose([w.load(&p[1]), w.load(&q[1]), w.load(&r[1]), w.load(&s[1])]);
    [a, b, c, d, e, f, g, h]
}

/// Refines four roots.
#[inline(always)]
pub(super) fn refine<W: Wide>(w: W, four: [&Sought<'_>; LANES]) -> [Result<Angles, Doubt>; LANES] {
    let [a, b, c, d] = four;
    let on_panel = columns(w, [&a.powers(w), &b.powers(w), &c.powers(w), &d.powers(w)]);
    let mut u = w.load(&[a.bracket.guess, b.bracket.guess, c.bracket.guess, d.bracket.guess]);
    let mut coarse = step(w, &on_panel, u);
    for _ in 1..COARSE {
        u = coarse.u;
        coarse = step(w, &on_panel, u);
    }
    let (at, next, slope) = (w.store(coarse.u), w.store(coarse.next), w.store(size(w, coarse.slope)));

    let zero = [[0.0; LANES]; ORDER / LANES];
    let (mut powers, mut start, mut cells, mut sure) =
        ([zero; LANES], [0.0; LANES], [&a.chart.cells[0]; LANES], [false; LANES]);
    for l in 0..LANES {
        let Sought { panel, bracket, chart, .. } = four[l];
        let (middle, half) = place(*panel);
        let inside = at[l] >= bracket.ends[0] && at[l] <= bracket.ends[1];
        let t = middle + half * if inside { at[l] } else { 0.0 };
        let cell = chart.cell(*panel >= LANES, t);
        sure[l] = inside && next[l] <= NEAR && slope[l] > STEEP * bracket.tolerance && !cell.edge;
        powers[l] = sum(w, &cell.powers, &four[l].weights);
        start[l] = (t - cell.middle) / cell.half;
        cells[l] = cell;
    }
    let in_cell = columns(w, [&powers[0], &powers[1], &powers[2], &powers[3]]);
    let mut fine = step(w, &in_cell, w.load(&start));
    for _ in 1..FINE {
        u = fine.u;
        fine = step(w, &in_cell, u);
    }
    let (at, next) = (w.store(fine.u), w.store(fine.next));
    let mut found = [Err(Doubt); LANES];
    for l in 0..LANES {
        if sure[l] && next[l] <= SETTLED && at[l].abs() <= BEYOND {
            let (helical, pitch) = cells[l].angles(at[l]);
            found[l] = Ok(Angles { helical, pitch });
        }
    }
    found
}
