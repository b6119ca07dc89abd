//! One state on the way, and what happens there.

use super::course::hand;
use super::regime::{Here, Regime};
use super::{Contacts, Path};
use crate::Handedness;
use crate::geometry::{Contact, HelicalAngle};
use crate::mechanics::support::Place;
use crate::mechanics::{Balance, Ends, Load, Stability, Support, SupportedState, Twist};
use crate::numerics::linear::Vector;

/// A state on a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// The share of the path: 0 at its beginning, 1 at its end.
    pub along: f64,
    /// What carries the strands.
    pub support: Support,
    /// ε.
    pub handedness: Handedness,
    /// θ; 0 where the strands are straight.
    pub angle: HelicalAngle,
    /// ρ = R/r.
    pub radius_ratio: f64,
    /// γ.
    pub stiffness_ratio: f64,
    /// What is given of the twist.
    pub twist: Twist,
    /// The end loads, one of them found where a displacement is held.
    pub load: Load,
    /// The core's radius, units of r.
    pub core_radius: Option<f64>,
    /// p₁ r³/B; negative only where neighbours are kept together.
    pub interstrand_pressure: f64,
    /// p_c r³/B.
    pub core_pressure: f64,
    /// p r³/B.
    pub resultant_pressure: f64,
    /// Among uniform plies with the ends held as on this path; `None` in radial balance.
    pub stability: Option<Stability>,
}

/// What happens on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mark {
    /// The far end of the path is reached.
    Arrival,
    /// The branch turns back: a limit point.
    Fold,
    /// Contacts open or close; this carries the strands from here on.
    ContactChange(Support),
    /// p = 0 where neighbours are kept together.
    Separation,
    /// θ = π/4.
    Diagonal,
    /// q = 1: no more turns fit in, the ply locks.
    MostTurns,
    /// The curvature passes the limit that was set.
    CurvatureLimit,
    /// The strain of the outermost fibre passes the limit that was set.
    StrainLimit,
    /// θ = 0: the strands are straight, and the hand changes.
    Straight,
    /// Straight strands come under a thrust, under which each buckles by itself.
    Buckling,
}

impl Mark {
    /// The name used in JSON and CSV.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Arrival => "arrival",
            Self::Fold => "fold",
            Self::ContactChange(_) => "contact_change",
            Self::Separation => "separation",
            Self::Diagonal => "diagonal",
            Self::MostTurns => "most_turns",
            Self::CurvatureLimit => "curvature_limit",
            Self::StrainLimit => "strain_limit",
            Self::Straight => "straight",
            Self::Buckling => "buckling",
        }
    }
}

/// Something that happens on the way, and where: halved down to rounding, to 1e-10 as a rule. Next to straight strands, and where contacts
/// change between branches that are nearly parallel, rounding leaves some 1e-8.
#[derive(Clone, Debug, PartialEq)]
pub struct Event<S = Station> {
    /// What.
    pub mark: Mark,
    /// Where.
    pub station: S,
    /// The index of the first of the trace's stations behind it.
    pub before: usize,
    /// Where a stable state ends here: the stable states to which the ply can jump, nearest angle first. `None` where nothing ends;
    /// empty where nothing uniform is left to jump to.
    pub jump: Option<Vec<S>>,
}

impl Station {
    /// a·d_f = cos θ, (50).
    #[must_use]
    pub fn extension(&self) -> f64 {
        self.angle.cos()
    }

    /// a·d_m = ε sin θ/ρ, (51).
    #[must_use]
    pub fn rotation(&self) -> f64 {
        self.handedness.sign() * self.angle.sin() / self.radius_ratio
    }

    /// φ̄a, (49).
    #[must_use]
    pub fn pretwist(&self) -> f64 {
        match self.twist {
            Twist::Pretwist(pretwist) => pretwist,
            Twist::StrandTwist(strand_twist) => strand_twist - self.rotation() * self.angle.cos(),
        }
    }

    /// r u₃, (45).
    #[must_use]
    pub fn strand_twist(&self) -> f64 {
        match self.twist {
            Twist::Pretwist(pretwist) => pretwist + self.rotation() * self.angle.cos(),
            Twist::StrandTwist(strand_twist) => strand_twist,
        }
    }

    /// r κ.
    #[must_use]
    pub fn curvature(&self) -> f64 {
        self.angle.sin() * self.angle.sin() / self.radius_ratio
    }

    /// Whether neighbours that are kept together would have to pull.
    #[must_use]
    pub fn is_separated(&self) -> bool {
        self.interstrand_pressure < 0.0
    }

    fn at(state: &SupportedState, stability: Option<Stability>) -> Self {
        Self {
            along: 0.0,
            support: state.support(),
            handedness: state.handedness(),
            angle: state.angle(),
            radius_ratio: state.radius_ratio(),
            stiffness_ratio: state.stiffness_ratio(),
            twist: state.twist(),
            load: state.load(),
            core_radius: state.core_radius(),
            interstrand_pressure: state.interstrand_pressure(),
            core_pressure: state.core_pressure(),
            resultant_pressure: state.resultant_pressure(),
            stability,
        }
    }
}

/// What rounding leaves of a pressure, per load.
const PRESSURE_ROUNDING: f64 = 1e-15;

impl Path {
    /// The station at given coordinates of a regime.
    pub(super) fn station(&self, regime: Regime, z: Vector) -> Station {
        let here = Here::new(self, z);
        let data = self.data(z[3]);
        let load = match data.ends {
            Ends::Loads(load) => load,
            Ends::Rotation { force, .. } => Load { force, moment: z[2] },
            Ends::Length { moment, .. } => Load { force: z[2], moment },
        };
        let support = regime.support();
        let handedness = hand(z[0]);
        let contact = Contact::at(self.strands, here.angle);
        let radius_ratio = match support {
            Support::Neighbours | Support::Both => contact.radius_ratio(),
            Support::Core => 1.0 + data.core_radius.unwrap_or(f64::NAN),
            Support::Free => here.angle.sin() / z[1].abs(),
        };
        let on_core = data.core_radius.map(|radius| 1.0 + radius);
        let place = Place { strands: self.strands, handedness, angle: here.angle, radius_ratio, on_core };
        let state = SupportedState::new(support, place, data.stiffness_ratio, data.twist, load);
        let mut station = Station { along: z[3], ..Station::at(&state, Some(state.stability(self.holding()))) };
        if here.angle.sin() == 0.0 && regime == Regime::On(Support::Neighbours) {
            // neighbours do not bound how straight strands may lean and bow: E = −(f/n) cos Θ falls away from them under a thrust
            station.stability = Some(Stability::of(load.force, 0.0));
        }
        if let Regime::On(_) = regime {
            // where a contact opens or closes, its pressure is nothing but rounding
            let size = PRESSURE_ROUNDING * (1.0 + load.force.abs() + load.moment.abs());
            for pressure in
                [&mut station.interstrand_pressure, &mut station.core_pressure, &mut station.resultant_pressure]
            {
                if pressure.abs() < size {
                    *pressure = 0.0;
                }
            }
        }
        if self.contacts == Contacts::Kept(Balance::Radial) {
            // p̂, which contact balance counts as 2p₁/ρ
            let outward = 2.0 * state.interstrand_pressure() / radius_ratio;
            station.resultant_pressure = outward;
            station.interstrand_pressure = outward / (radius_ratio * contact.one_minus_cos_beta());
            station.stability = None;
        }
        station
    }
}
