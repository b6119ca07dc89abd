//! The main branch from straight strands to flat rings, in six panels, ready for any combination of known functions.

use core::f64::consts::FRAC_PI_4;

use crate::Handedness;
use crate::geometry::{Contact, HelicalAngle};
use crate::numerics::dual::Dual;
use crate::numerics::isolate::{Basis, Pair, Panel};

/// A condition on states of the branch, linear in K weights: Σ weight·term = 0.
///
/// Its terms are scaled by a power of cos θ so that they are finite on all of [0, π/2].
pub(crate) trait Condition<const K: usize>: Copy {
    /// The terms and their slopes dθ.
    fn terms(&self, contact: &Contact) -> [Dual; K];
}

/// One place where a condition holds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Solution {
    pub(crate) angle: HelicalAngle,
    /// Two solutions that rounding cannot tell apart.
    pub(crate) double: bool,
}

/// A condition along the branch of given n.
#[derive(Clone, Debug)]
pub(crate) struct Atlas<C, const K: usize> {
    strands: u32,
    condition: C,
    steep: [Panel<K>; 3],
    flat: [Panel<K>; 3],
}

/// Borders of the panels, by helical angle when steep, by pitch angle when flat: each half keeps its digits near 0, and
/// the branch of n = 2 is smooth on either side of π/4.
pub(super) const BORDERS: [f64; 4] = [0.0, FRAC_PI_4 / 3.0, FRAC_PI_4 * 2.0 / 3.0, FRAC_PI_4];

/// The functions by helical angle, or by pitch angle.
struct Chart<C> {
    strands: u32,
    condition: C,
    flat: bool,
}

impl<C> Chart<C> {
    #[inline]
    fn angle(&self, t: f64) -> HelicalAngle {
        // π/4 itself belongs to the steep half, so that both see the same numbers on their common border
        if self.flat && t < FRAC_PI_4 { HelicalAngle::flat(t) } else { HelicalAngle::steep(t) }
    }
}

impl<C: Condition<K>, const K: usize> Basis<K> for Chart<C> {
    #[inline]
    fn at(&self, t: f64) -> [Dual; K] {
        // flat rings at a pitch angle of exactly 0 are the limit of the terms; their cosine is then exactly 0
        let terms = self.condition.terms(&Contact::at(self.strands, self.angle(t)));
        if self.flat { terms.map(|term| Dual::new(term.value, -term.slope)) } else { terms }
    }
}

impl<C: Condition<K>, const K: usize> Atlas<C, K> {
    pub(crate) fn new(strands: u32, condition: C) -> Self {
        let half = |flat| {
            let chart = Chart { strands, condition, flat };
            core::array::from_fn(|i| Panel::fit(&chart, BORDERS[i], BORDERS[i + 1]))
        };
        Self { strands, condition, steep: half(false), flat: half(true) }
    }

    /// Hands every solution in (0, π/2) for either hand to `found`, none missed and none twice (see
    /// [`crate::numerics::isolate`]); the weights' odd part carries ε.
    #[inline]
    pub(crate) fn solve(&self, weights: Pair<K>, found: impl FnMut(Handedness, Solution)) {
        self.solve_from(0, &weights.tamed(), found);
    }

    /// The pair's even and odd part where panel `at` of the steep half begins.
    #[inline]
    pub(super) fn at_start(&self, at: usize, weights: &Pair<K>) -> (f64, f64) {
        self.steep[at].at_start(weights)
    }

    /// As [`solve`](Self::solve) for weights that are tamed, from the start of panel `first` of the steep half.
    #[inline]
    pub(super) fn solve_from(&self, first: usize, weights: &Pair<K>, mut found: impl FnMut(Handedness, Solution)) {
        for (panels, flat) in [(&self.steep[first..], false), (&self.flat, true)] {
            let chart = Chart { strands: self.strands, condition: self.condition, flat };
            for panel in panels {
                panel.roots(&chart, weights, &mut |side, root| {
                    if !flat || root.at >= HelicalAngle::FLATTEST {
                        found(Handedness::of_sign(side), Solution { angle: chart.angle(root.at), double: root.double });
                    }
                });
            }
        }
    }
}
