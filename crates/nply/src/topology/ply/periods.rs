//! ∫ C du over whole periods of flat strands, as many as there are.
//!
//! At a fixed phase v the values C(v + 2πk) are those of one smooth function of k, and its integral is known: Euler's and Maclaurin's formula
//! sums them from their ends alone, and Gauss's rule then goes over one period of phases.

use core::cell::Cell;
use core::f64::consts::{PI, TAU};

use super::chord::{Bounded, Chord, Nodes, Panel};
use crate::numerics::gauss::LEFT;

/// B₂ (2π), B₄ (2π)³, …, B₂₄ (2π)²³.
const BERNOULLI: [f64; 12] = [
    core::f64::consts::FRAC_PI_3,
    -8.268340448079952047,
    233.1578550745001549,
    -12886.58443851431282,
    1156231.731721550028,
    -152508465.8271336295,
    27751411567.67468726,
    -6660032646687.813257,
    2037946624986603.49,
    -774417500083210733.2,
    3.57780629042338701e+20,
    -1.974948719109332366e+23,
];
/// The least period from which the formula's terms fall far enough.
pub(super) const FIRST: f64 = 5.0;
/// Periods that are summed one by one in the time which the formula takes.
pub(super) const WORTHWHILE: f64 = 15.0;

impl Chord {
    /// ∫ C du from the period `first` ≥ [`FIRST`] up to, not including, the period `last` for every chord, added to `sums`.
    pub(super) fn periods(chords: &[Self], first: f64, last: f64, sums: &mut [Bounded]) {
        if first >= last {
            return;
        }
        let mut order: Vec<usize> = (0..chords.len()).collect();
        let (first, last) = (TAU * first, TAU * last);
        let left_out = Cell::new(0.0_f64);
        let error = |chord: &Self, panel: &Panel| {
            let size = last + TAU + 4.0 * chord.sin / chord.cos; // R on the ellipse, and the terms beside it, in units of 2π
            let clear = panel.half < 1e-16 || chord.clearance(panel, first).is_some();
            clear.then_some((LEFT + 2.0 * f64::EPSILON) * panel.half * size)
        };
        let sum = |chord: &Self, nodes: &Nodes| {
            let tan = chord.sin / chord.cos;
            nodes.sum(chord, |v, s| {
                let (low, high) = (Ladder::new(tan * s, v + first), Ladder::new(tan * s, v + last));
                left_out.set(left_out.get().max(low.last));
                (high.root - low.root) / TAU + (high.rest - low.rest)
            })
        };
        Panel { centre: PI, half: PI }.each(chords, &mut order, &error, &sum, sums);
        for sum in sums {
            sum.bound += 2.0 * TAU * left_out.get(); // twice the last term at either end
        }
    }
}

/// One end of the formula for R = √(q² + u²), the integral of u/R: Taylor's coefficients of R are Gegenbauer's polynomials of index −½.
struct Ladder {
    root: f64,
    /// −½ u/R + Σ B₂ₖ (2π)²ᵏ⁻¹ R⁽²ᵏ⁾/(2k)!
    rest: f64,
    last: f64,
}

impl Ladder {
    fn new(q: f64, u: f64) -> Self {
        let root = (q * q + u * u).sqrt();
        let (x, inverse) = (-u / root, 1.0 / root);
        let share = q * inverse;
        let mut rest = 0.5 * x;
        // R⁽ⁿ⁾/n! = Rⁿ⁻¹ Cₙ(−u/R): C₂ = q²/2R², C₃ = x C₂, n Cₙ = (2n − 3) x Cₙ₋₁ − (n − 3) Cₙ₋₂
        let (mut even, mut odd) = (0.5 * share * share, 0.5 * x * share * share);
        let mut scale = inverse;
        let (mut n, mut last) = (2.0, 0.0);
        for bernoulli in BERNOULLI {
            last = bernoulli * scale * even;
            rest += last;
            if last.abs() < 1e-18 {
                break; // at the far end soon
            }
            scale *= inverse * inverse;
            even = ((2.0 * n + 1.0) * x * odd - (n - 1.0) * even) / (n + 2.0);
            odd = ((2.0 * n + 3.0) * x * even - n * odd) / (n + 3.0);
            n += 2.0;
        }
        Self { root, rest, last: last.abs() }
    }
}
