//! Which panels hold a root, and about where.

use super::panels::{HALVES, PANELS, Panels};
use crate::mechanics::row::TERMS;
use crate::numerics::septic::{self, Coefficients, ORDER};
use crate::numerics::wide::{Four, LANES, Wide};

/// Halvings of a panel before a case is left to be solved by itself.
const DEEPEST: u32 = 6;

/// A balance's polynomials on all panels, for the right hand and for the left.
pub(super) struct Sums {
    hands: [[[Four; HALVES]; ORDER]; 2],
    tolerance: [Four; HALVES],
}

/// Between which u of a panel there is one root, and how far the polynomial may be off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bracket {
    pub(super) ends: [f64; 2],
    /// where the control polygon crosses zero: from this u, within this step, from this height to that
    pub(super) crossing: [f64; 4],
    pub(super) tolerance: f64,
}

/// A case that cannot be told from one with more or fewer roots.
#[derive(Clone, Copy, Debug)]
pub(super) struct Doubt;

impl Sums {
    pub(super) const fn new() -> Self {
        let zero = [[0.0; LANES]; HALVES];
        Self { hands: [[zero; ORDER]; 2], tolerance: zero }
    }

    /// Adds up the terms with the weights (1, γ, γφ̄a, f, m), the third and the last with the hand's sign. Bit k of the answer
    /// is set unless panel k, bit 8 + k unless panel k of the left hand, is without a root for sure.
    #[inline(always)]
    pub(super) fn fill<W: Wide, const LOADED: bool>(&mut self, w: W, panels: &Panels, weights: &[f64; TERMS]) -> u32 {
        let [bending, twisting, pretwist, force, moment] = &panels.terms;
        let (love, held, f, m) = (w.splat(weights[1]), w.splat(weights[2]), w.splat(weights[3]), w.splat(weights[4]));
        let mut candidates = 0;
        for half in 0..HALVES {
            let (mut least, mut greatest) = ([w.splat(f64::INFINITY); 2], [w.splat(f64::NEG_INFINITY); 2]);
            for i in 0..ORDER {
                let mut even = w.mul_add(love, w.load(&twisting[i][half]), w.load(&bending[i][half]));
                let mut odd = w.mul(held, w.load(&pretwist[i][half]));
                if LOADED {
                    even = w.mul_add(f, w.load(&force[i][half]), even);
                    odd = w.mul_add(m, w.load(&moment[i][half]), odd);
                }
                let hands = [w.add(even, odd), w.sub(even, odd)];
                for hand in 0..2 {
                    self.hands[hand][i][half] = w.store(hands[hand]);
                    least[hand] = w.min(least[hand], hands[hand]);
                    greatest[hand] = w.max(greatest[hand], hands[hand]);
                }
            }
            let off = &panels.tolerance;
            let mut tolerance = w.mul_add(w.splat(weights[1].abs()), w.load(&off[1][half]), w.load(&off[0][half]));
            tolerance = w.mul_add(w.splat(weights[2].abs()), w.load(&off[2][half]), tolerance);
            if LOADED {
                tolerance = w.mul_add(w.splat(weights[3].abs()), w.load(&off[3][half]), tolerance);
                tolerance = w.mul_add(w.splat(weights[4].abs()), w.load(&off[4][half]), tolerance);
            }
            self.tolerance[half] = w.store(tolerance);
            let negative = w.sub(w.splat(0.0), tolerance);
            for hand in 0..2 {
                let unsure = w.and(w.at_least(tolerance, least[hand]), w.at_least(greatest[hand], negative));
                candidates |= w.bits(unsure) << (hand * PANELS + half * LANES);
            }
        }
        candidates
    }

    /// The root of a candidate that is plainly the only one there, or the candidate's polynomial and how far it may be off.
    #[inline(always)]
    pub(super) fn single<W: Wide>(&self, w: W, candidate: usize) -> Result<Bracket, (Coefficients, f64)> {
        let (hand, half, lane) = (candidate / PANELS, candidate % PANELS / LANES, candidate % LANES);
        let sum = &self.hands[hand];
        let mut b = [0.0; ORDER];
        for i in 0..ORDER {
            b[i] = sum[i][half][lane];
        }
        let tolerance = self.tolerance[half][lane];
        let (low, high) = (w.load(&[b[0], b[1], b[2], b[3]]), w.load(&[b[4], b[5], b[6], b[7]]));
        let zero = w.splat(0.0);
        let least = w.min(w.max(low, w.sub(zero, low)), w.max(high, w.sub(zero, high)));
        let unsure = w.bits(w.at_least(w.splat(tolerance), least));
        let positive = w.bits(w.at_least(low, zero)) | w.bits(w.at_least(high, zero)) << LANES;
        // bit i: coefficients i and i + 1 differ in sign
        let changes = (positive ^ positive >> 1) & 0x7f;
        if unsure == 0 && changes.is_power_of_two() {
            Ok(bracket(&b, changes.trailing_zeros() as usize & 7, tolerance, [-1.0, 1.0]))
        } else {
            Err((b, tolerance))
        }
    }
}

/// A root between coefficients `before` and the next.
#[inline(always)]
fn bracket(b: &Coefficients, before: usize, tolerance: f64, ends: [f64; 2]) -> Bracket {
    let step = (ends[1] - ends[0]) * (1.0 / (ORDER - 1) as f64);
    let next = (before + 1).min(ORDER - 1);
    Bracket { ends, crossing: [ends[0] + step * before as f64, step, b[before], b[next]], tolerance }
}

/// Hands every root of a polynomial on a panel, alone in its bracket, to `found`.
#[cold]
#[inline(never)]
pub(super) fn isolate(b: &Coefficients, tolerance: f64, found: &mut impl FnMut(Bracket)) -> Result<(), Doubt> {
    split(b, tolerance, [-1.0, 1.0], DEEPEST, found)
}

/// One change among signs that are all sure: with the tolerance added or taken away the polynomial still has one root, so that
/// the function's roots lie in one short stretch about it.
fn split(
    b: &Coefficients,
    tolerance: f64,
    ends: [f64; 2],
    depth: u32,
    found: &mut impl FnMut(Bracket),
) -> Result<(), Doubt> {
    let sure = b.iter().all(|b| b.abs() > tolerance);
    let changed = |i: &usize| (b[*i] > 0.0) != (b[i + 1] > 0.0);
    let mut changes = (0..ORDER - 1).filter(changed);
    match (sure, changes.next(), changes.next()) {
        (true, None, _) => Ok(()),
        (true, Some(before), None) => {
            found(bracket(b, before, tolerance, ends));
            Ok(())
        }
        _ => halve(b, tolerance, ends, depth, found),
    }
}

fn halve(
    b: &Coefficients,
    tolerance: f64,
    [from, to]: [f64; 2],
    depth: u32,
    found: &mut impl FnMut(Bracket),
) -> Result<(), Doubt> {
    if depth == 0 || b[0].abs() <= tolerance || b[ORDER - 1].abs() <= tolerance {
        return Err(Doubt);
    }
    let middle = 0.5 * (from + to);
    let [left, right] = septic::halves(b);
    split(&left, tolerance, [from, middle], depth - 1, &mut *found)?;
    split(&right, tolerance, [middle, to], depth - 1, &mut *found)
}
