//! Roots of polynomials of degree 7 by Halley's steps, four to a register: a step has to wait for its own beginning, so that
//! several registers take turns.

use super::septic::ORDER;
use super::wide::Wide;

/// Steps after which a root that still moves is left.
const MOST_STEPS: usize = 5;

/// A number for each of the roots in a register.
pub(crate) type Rows<V, const R: usize> = [V; R];

/// Roots on their way.
pub(crate) struct Way<V, const R: usize> {
    pub(crate) u: Rows<V, R>,
    /// what the next step would move at the most
    pub(crate) next: Rows<V, R>,
    pub(crate) slope: Rows<V, R>,
}

/// Halley's steps for all roots, until the next would move none of them by more than `enough`. A root that has come to rest stays where it
/// is while others go on, so that none depends on its neighbours.
#[inline(always)]
pub(crate) fn walk<W: Wide, const R: usize>(
    w: W,
    c: &[[W::V; ORDER]; R],
    start: Rows<W::V, R>,
    enough: f64,
) -> Way<W::V, R> {
    let zero = w.splat(0.0);
    let enough_all = w.splat(enough);
    let mut way = Way { u: start, next: [zero; R], slope: [zero; R] };
    let mut rests = [w.at_least(zero, w.splat(1.0)); R];
    for _ in 0..MOST_STEPS {
        step(w, c, &mut way, &rests);
        for (rests, next) in rests.iter_mut().zip(way.next) {
            *rests = w.at_least(enough_all, next);
        }
        let mut open = way.next[0];
        for next in way.next {
            open = w.max(next, open);
        }
        if w.bits(w.at_least(enough_all, open)) == 0b1111 {
            break;
        }
    }
    way
}

#[inline(always)]
fn step<W: Wide, const R: usize>(w: W, c: &[[W::V; ORDER]; R], way: &mut Way<W::V, R>, rests: &Rows<W::V, R>) {
    let zero = w.splat(0.0);
    let u = way.u;
    let (mut f, mut slope) = ([zero; R], [zero; R]);
    for r in 0..R {
        (f[r], slope[r]) = (w.mul_add(c[r][7], u[r], c[r][6]), c[r][7]);
    }
    let mut bend = [zero; R];
    for i in (0..6).rev() {
        for r in 0..R {
            bend[r] = w.mul_add(bend[r], u[r], slope[r]);
            slope[r] = w.mul_add(slope[r], u[r], f[r]);
            f[r] = w.mul_add(f[r], u[r], c[r][i]);
        }
    }
    for r in 0..R {
        let minus = w.sub(zero, f[r]);
        let curved = w.mul(minus, bend[r]);
        let inverse = w.div(w.splat(1.0), w.mul_add(slope[r], slope[r], curved));
        let by = w.mul(w.mul(minus, slope[r]), inverse);
        let share = w.add(size(w, by), size(w, w.mul(curved, inverse)));
        let still = rests[r];
        way.u[r] = w.select(still, u[r], w.add(u[r], by));
        // no number: the second is taken, which is none either
        way.next[r] = w.select(still, way.next[r], w.mul(size(w, by), w.mul(share, share)));
        way.slope[r] = w.select(still, way.slope[r], slope[r]);
    }
}

/// |a|.
#[inline(always)]
pub(crate) fn size<W: Wide>(w: W, a: W::V) -> W::V {
    w.max(a, w.sub(w.splat(0.0), a))
}
