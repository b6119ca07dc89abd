//! The balance and the pressure of one hand along a row: A + xB, with the varied datum x.

use super::Along;
use super::cell::{self, PRESSURES, TERMS, Weights};
use crate::Handedness;
use crate::mechanics::{Load, Twist};

/// The weights of A and B, of the pairs in A′B − AB′, and of the pressure.
#[derive(Clone, Debug)]
pub(super) struct Line {
    pub(super) handedness: Handedness,
    pub(super) a: Weights,
    pub(super) b: Weights,
    pub(super) pairs: Weights,
    pub(super) pressure_a: Weights,
    pub(super) pressure_b: Weights,
    /// the greatest of the fixed weights and of those that x multiplies
    pub(super) greatest: [f64; 2],
}

impl Line {
    pub(super) fn new(along: Along, gamma: f64, twist: Twist, load: Load, handedness: Handedness) -> Self {
        let eps = handedness.sign();
        let (Twist::Pretwist(given) | Twist::StrandTwist(given)) = twist;
        let love = match twist {
            Twist::Pretwist(_) => 1.0,
            Twist::StrandTwist(_) => 0.0,
        };
        // the weights (1, γ, εγφ̄a, f, εm) or (1, 0, εγ r u₃, f, εm)
        let mut a = [1.0, gamma * love, eps * gamma * given, load.force, eps * load.moment];
        let mut b = [0.0; TERMS];
        match along {
            Along::Force => (a[3], b[3]) = (0.0, 1.0),
            Along::Moment => (a[4], b[4]) = (0.0, eps),
            Along::Pretwist => (a[1], a[2], b[2]) = (gamma, 0.0, eps * gamma),
            Along::StrandTwist => (a[1], a[2], b[2]) = (0.0, 0.0, eps * gamma),
            Along::StiffnessRatio => (a[1], a[2], b[1], b[2]) = (0.0, 0.0, love, eps * given),
        }
        let greatest = [a, b].map(|weights| weights.iter().fold(0.0, |most: f64, weight| most.max(weight.abs())));
        // the force presses on nothing
        let pressing = |w: &[f64; TERMS]| -> [f64; PRESSURES] { [w[0], w[1], w[2], w[4]] };
        Self {
            handedness,
            pairs: cell::pair_weights(&a, &b),
            pressure_a: Weights::new(&pressing(&a)),
            pressure_b: Weights::new(&pressing(&b)),
            a: Weights::new(&a),
            b: Weights::new(&b),
            greatest,
        }
    }
}
