//! The branch in eight panels that lie side by side in the lanes of two registers.

use core::f64::consts::FRAC_PI_4;

use crate::geometry::{Contact, HelicalAngle};
use crate::mechanics::Balance;
use crate::mechanics::atlas::Condition;
use crate::mechanics::row::{TERMS, judged, largest};
use crate::numerics::septic::{self, Coefficients, NODES, ORDER};
use crate::numerics::wide::{Four, LANES};

/// Registers: the steep half and the flat one.
pub(super) const HALVES: usize = 2;
pub(super) const PANELS: usize = HALVES * LANES;

/// Width of a panel, by helical angle in the steep half, by pitch angle in the flat one.
const WIDTH: f64 = FRAC_PI_4 / LANES as f64;

/// Polynomials of a balance's terms, panel by panel from θ = 0 to π/2.
#[derive(Clone, Debug)]
pub(in crate::mechanics) struct Panels {
    /// in Bernstein form, to be judged by their signs: a term's coefficient for every panel
    pub(super) terms: [[[Four; HALVES]; ORDER]; TERMS],
    /// how far each may be off
    pub(super) tolerance: [[Four; HALVES]; TERMS],
    /// in powers of u, to be evaluated
    pub(super) powers: [[Coefficients; TERMS]; PANELS],
}

/// Both forms of a balance: as it is, and over cos θ where no force pulls, so that it does not vanish for flat rings.
#[derive(Clone, Debug)]
pub(in crate::mechanics) struct Both {
    pub(super) whole: Panels,
    pub(super) unpulled: Panels,
}

impl Both {
    pub(in crate::mechanics) fn new(strands: u32, balance: Balance) -> Self {
        Self {
            whole: Panels::fit(|angle| balance.terms(&Contact::at(strands, angle)).map(|term| term.value)),
            unpulled: Panels::fit(|angle| unpulled(strands, balance, angle)),
        }
    }
}

/// The terms over cos θ; that of the force, and in contact balance that of the moment, do not vanish with it and are left out.
fn unpulled(strands: u32, balance: Balance, angle: HelicalAngle) -> [f64; TERMS] {
    let at = Contact::at(strands, angle).regular();
    let (n, s, c, radius) = (f64::from(strands), at.sin.value, at.cos.value, at.radius.value);
    let (ss, cc) = (s * s, c * c);
    let (q_cc, moment) = match balance {
        Balance::Contact => (ss * at.share.value, 0.0),
        Balance::Radial => (0.0, -(radius * c)),
    };
    let cos2 = cc - ss - q_cc;
    [n * s * ss * (2.0 * cc - q_cc), n * s * cc * cos2, n * radius * cos2, 0.0, moment]
}

/// Middle of a panel and half its width, both by the angle of its half.
pub(super) fn place(panel: usize) -> (f64, f64) {
    // panels go by θ, so that those of the flat half run against the pitch angle
    let from_end = if panel < LANES { panel } else { PANELS - 1 - panel };
    (WIDTH * (from_end as f64 + 0.5), 0.5 * WIDTH)
}

impl Panels {
    fn fit(terms: impl Fn(HelicalAngle) -> [f64; TERMS]) -> Self {
        let zero = [[0.0; LANES]; HALVES];
        let mut panels =
            Self { terms: [[zero; ORDER]; TERMS], tolerance: [zero; TERMS], powers: [[[0.0; ORDER]; TERMS]; PANELS] };
        for panel in 0..PANELS {
            let (middle, half) = place(panel);
            let at = |u: f64| {
                let t = (middle + half * u).clamp(0.0, FRAC_PI_4);
                terms(if panel < LANES { HelicalAngle::steep(t) } else { HelicalAngle::flat(t) })
            };
            let nodes = NODES.map(at);
            let between: [[f64; TERMS]; ORDER - 1] = core::array::from_fn(|i| at(0.5 * (NODES[i] + NODES[i + 1])));
            for k in 0..TERMS {
                let values: Coefficients = nodes.map(|terms| terms[k]);
                let (bernstein, tolerance) = judged(&values, largest(&values), |i| between[i][k]);
                for (i, coefficient) in bernstein.into_iter().enumerate() {
                    panels.terms[k][i][panel / LANES][panel % LANES] = coefficient;
                }
                panels.tolerance[k][panel / LANES][panel % LANES] = tolerance;
                panels.powers[panel][k] = septic::powers(&values);
            }
        }
        panels
    }
}
