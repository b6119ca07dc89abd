//! What carries the strands: neighbours, a core, both, or nothing. Contacts push and never pull.

mod free;
mod lift;
mod search;
mod wedge;

pub use wedge::Wedge;

use core::f64::consts::TAU;

use super::energy::Energy;
use super::potential::{Potential, Slopes};
use super::{Holding, Load, Stability, Twist};
use crate::geometry::{Contact, HelicalAngle};
use crate::{DomainError, Handedness};

/// Which contacts are closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Support {
    /// Strands touch each other; a core, if there is one, lies loose: contact balance.
    Neighbours,
    /// Strands lie on the core with gaps between them: radial balance at the core's radius.
    Core,
    /// Strands lie on the core and touch each other: the core fixes the angle.
    Both,
    /// Neither: free helices, the ply that has opened (birdcage).
    Free,
}

impl Support {
    /// The name used in JSON and CSV: `neighbours`, `core`, `both` or `none`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Neighbours => "neighbours",
            Self::Core => "core",
            Self::Both => "both",
            Self::Free => "none",
        }
    }
}

/// A state of n equal helices that touch each other, a core, both or nothing, in equilibrium with every contact pushing.
///
/// Dimensionless (r = B = 1). ρ may be above that of touching strands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SupportedState {
    support: Support,
    handedness: Handedness,
    /// strands that touch at the same angle
    touching: Contact,
    radius_ratio: f64,
    interstrand_pressure: f64,
    core_pressure: f64,
    /// ρ of strands on the core
    on_core: Option<f64>,
    stiffness_ratio: f64,
    twist: Twist,
    load: Load,
}

impl SupportedState {
    /// The state of a regime at a place where it is in equilibrium: its contact forces follow.
    pub(super) fn new(support: Support, place: Place, gamma: f64, twist: Twist, load: Load) -> Self {
        let Place { strands, handedness, angle, radius_ratio, on_core } = place;
        let touching = Contact::at(strands, angle);
        let slopes = Potential::new(strands, gamma, twist, load).on(handedness, angle, radius_ratio);
        let eps = handedness.sign();
        // ∂E/∂ρ = 2p₁/ρ + p_c and, at fixed ρ, ∂E/∂θ = −2q p₁ cot θ
        let rotation = angle.sin() / radius_ratio;
        let outward = -eps * slopes.by_rotation * rotation / radius_ratio;
        let (interstrand_pressure, core_pressure) = match support {
            Support::Neighbours => (0.5 * radius_ratio * outward, 0.0),
            Support::Core => (0.0, outward),
            Support::Free => (0.0, 0.0),
            Support::Both => {
                let turning = eps * (slopes.by_angle + slopes.by_rotation * angle.cos() / radius_ratio);
                let p1 = -turning * angle.tan() / (2.0 * touching.shift_ratio_squared());
                (p1, outward - 2.0 * p1 / radius_ratio)
            }
        };
        Self {
            support,
            handedness,
            touching,
            radius_ratio,
            interstrand_pressure,
            core_pressure,
            on_core,
            stiffness_ratio: gamma,
            twist,
            load,
        }
    }

    /// What carries the strands.
    #[must_use]
    pub const fn support(&self) -> Support {
        self.support
    }

    /// n.
    #[must_use]
    pub const fn strands(&self) -> u32 {
        self.touching.strands()
    }

    /// ε.
    #[must_use]
    pub const fn handedness(&self) -> Handedness {
        self.handedness
    }

    /// θ.
    #[must_use]
    pub const fn angle(&self) -> HelicalAngle {
        self.touching.angle()
    }

    /// ρ = R/r.
    #[must_use]
    pub const fn radius_ratio(&self) -> f64 {
        self.radius_ratio
    }

    /// Strands that touch at the same angle: the state's own contact where neighbours touch.
    #[must_use]
    pub const fn touching(&self) -> &Contact {
        &self.touching
    }

    /// γ = C/B.
    #[must_use]
    pub const fn stiffness_ratio(&self) -> f64 {
        self.stiffness_ratio
    }

    /// What is held of the twist.
    #[must_use]
    pub const fn twist(&self) -> Twist {
        self.twist
    }

    /// The end loads.
    #[must_use]
    pub const fn load(&self) -> Load {
        self.load
    }

    /// The core's radius in units of r, if there is a core.
    #[must_use]
    pub fn core_radius(&self) -> Option<f64> {
        self.on_core.map(|rho| rho - 1.0)
    }

    /// p₁ r³/B ≥ 0, from each neighbour.
    #[must_use]
    pub const fn interstrand_pressure(&self) -> f64 {
        self.interstrand_pressure
    }

    /// p_c r³/B ≥ 0, from the core.
    #[must_use]
    pub const fn core_pressure(&self) -> f64 {
        self.core_pressure
    }

    /// p r³/B, resultant of both, outward.
    #[must_use]
    pub fn resultant_pressure(&self) -> f64 {
        self.radius_ratio * self.interstrand_pressure * self.touching.one_minus_cos_beta() + self.core_pressure
    }

    /// Clearance between the surfaces of neighbours, in units of r; 0 where they touch.
    ///
    /// The distance of two helices of the same angle is in proportion to their radius.
    #[must_use]
    pub fn neighbour_gap(&self) -> f64 {
        match self.support {
            Support::Neighbours | Support::Both => 0.0,
            Support::Core | Support::Free => 2.0 * (self.radius_ratio / self.touching.radius_ratio() - 1.0),
        }
    }

    /// Clearance between strand and core, in units of r; 0 on the core; `None` without a core.
    #[must_use]
    pub fn core_gap(&self) -> Option<f64> {
        self.on_core.map(|rho| match self.support {
            Support::Core | Support::Both => 0.0,
            Support::Neighbours | Support::Free => self.radius_ratio - rho,
        })
    }

    /// r u₃, (45).
    #[must_use]
    pub fn strand_twist(&self) -> f64 {
        match self.twist {
            Twist::Pretwist(pretwist) => pretwist + self.torsion(),
            Twist::StrandTwist(strand_twist) => strand_twist,
        }
    }

    /// φ̄a, (49).
    #[must_use]
    pub fn pretwist(&self) -> f64 {
        match self.twist {
            Twist::Pretwist(pretwist) => pretwist,
            Twist::StrandTwist(strand_twist) => strand_twist - self.torsion(),
        }
    }

    /// r τ = ε sin θ cos θ/ρ, the centreline's torsion.
    #[must_use]
    pub fn torsion(&self) -> f64 {
        self.rotation() * self.angle().cos()
    }

    /// r κ = sin²θ/ρ, the centreline's curvature.
    #[must_use]
    pub fn curvature(&self) -> f64 {
        self.angle().sin() * self.angle().sin() / self.radius_ratio
    }

    /// a·d_f = cos θ, (50): ply length per strand length.
    #[must_use]
    pub fn extension(&self) -> f64 {
        self.angle().cos()
    }

    /// a·d_m = ε sin θ/ρ, (51): rotation of the ply's end in rad per strand length, times r.
    #[must_use]
    pub fn rotation(&self) -> f64 {
        self.handedness.sign() * self.angle().sin() / self.radius_ratio
    }

    /// Ply length per turn of a strand, in units of r: 2πρ/tan θ.
    #[must_use]
    pub fn lay_length(&self) -> f64 {
        TAU * self.radius_ratio / self.angle().tan()
    }

    /// Energy per strand length of one strand, in units of B/r², (52)–(56).
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// let load = Load { force: -0.05, moment: 0.2 };
    /// for state in Ply::new(3, 0.75)?.supported_states(Twist::Pretwist(-0.2), load, None)? {
    ///     assert!(state.energy().bending > 0.0);
    /// }
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn energy(&self) -> Energy {
        let n = f64::from(self.strands());
        Energy::of_strand(
            self.curvature(),
            self.stiffness_ratio,
            self.strand_twist(),
            Load { force: self.load.force / n, moment: self.load.moment / n },
            (self.extension(), self.rotation()),
        )
    }

    /// Right-handed first, then by angle.
    fn in_order(&self, other: &Self) -> core::cmp::Ordering {
        let left = |s: &Self| s.handedness == Handedness::Left;
        left(self).cmp(&left(other)).then(self.angle().radians().total_cmp(&other.angle().radians()))
    }

    fn slopes(&self) -> Slopes {
        Potential::new(self.strands(), self.stiffness_ratio, self.twist, self.load).on(
            self.handedness,
            self.angle(),
            self.radius_ratio,
        )
    }

    #[doc = include_str!("../../equations/second_variation.md")]
    ///
    /// Per strand and strand length, in B/r² per rad². `None` where closed contacts and held ends leave nothing free.
    ///
    /// ```
    /// use nply::mechanics::{Holding, Load, Ply, Stability, Support, Twist};
    /// // two strands pushed and turned apart: under dead loads the helices run away, at a held length they stay
    /// let load = Load { force: -0.3, moment: 0.9 };
    /// let states = Ply::new(2, 0.75)?.supported_states(Twist::Pretwist(-0.2), load, None)?;
    /// let open = states.iter().find(|s| s.support() == Support::Free).expect("an opened state");
    /// assert!((open.angle().degrees() - 50.36).abs() < 0.01);
    /// assert_eq!(open.stability(Holding::DeadLoads), Stability::Unstable);
    /// assert_eq!(open.stability(Holding::Length), Stability::Stable);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn second_variation(&self, holding: Holding) -> Option<f64> {
        let (s, c) = (self.angle().sin(), self.angle().cos());
        let at = self.slopes();
        // along a closed contact Y is a function of Θ: its slope and bend, odd and even in the hand
        let along = |slope: f64, bend: f64| {
            let eps = self.handedness.sign();
            at.angle_angle
                + 2.0 * at.angle_rotation * slope
                + at.rotation_rotation * slope * slope
                + eps * at.by_rotation * bend
        };
        match (self.support, holding) {
            (Support::Both, _) | (Support::Neighbours | Support::Core, Holding::Rotation | Holding::Length) => None,
            (Support::Neighbours, Holding::DeadLoads) => {
                let rotation = self.touching.curved().rotation();
                Some(along(rotation.slope, rotation.bend))
            }
            (Support::Core, Holding::DeadLoads) => Some(along(c / self.radius_ratio, -s / self.radius_ratio)),
            (Support::Free, Holding::DeadLoads) => {
                // the lesser eigenvalue, without taking a difference of what is nearly equal
                let (mean, half) = (
                    0.5 * (at.angle_angle + at.rotation_rotation),
                    libm::hypot(0.5 * (at.angle_angle - at.rotation_rotation), at.angle_rotation),
                );
                let determinant = at.angle_angle * at.rotation_rotation - at.angle_rotation * at.angle_rotation;
                Some(if mean > 0.0 { determinant / (mean + half) } else { mean - half })
            }
            (Support::Free, Holding::Rotation) => Some(at.angle_angle),
            (Support::Free, Holding::Length) => Some(at.rotation_rotation),
        }
    }

    /// The verdict of the [second variation](Self::second_variation) among uniform plies. Where nothing is left free the
    /// contacts push, or are about to: stable.
    #[must_use]
    pub fn stability(&self, holding: Holding) -> Stability {
        let Some(second) = self.second_variation(holding) else { return Stability::Stable };
        let (at, slope) = (self.slopes(), 1.0 / self.radius_ratio);
        let size = at.angle_angle.abs() + at.angle_rotation.abs() * slope + at.rotation_rotation * slope * slope;
        Stability::of(second, 1e2 * f64::EPSILON * (size + at.by_rotation.abs() * slope))
    }

    /// The same state with the strands' twisting moment held, as at a given torque, where their ends were clipped together.
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// let state = Ply::new(3, 0.75)?.supported_states(Twist::Pretwist(-1.0), Load::NONE, None)?[0];
    /// assert_eq!(state.with_strand_twist_held().strand_twist(), state.strand_twist());
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn with_strand_twist_held(self) -> Self {
        Self { twist: Twist::StrandTwist(self.strand_twist()), ..self }
    }
}

/// Where a state is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) strands: u32,
    pub(super) handedness: Handedness,
    pub(super) angle: HelicalAngle,
    pub(super) radius_ratio: f64,
    /// ρ of strands on the core, if there is one
    pub(super) on_core: Option<f64>,
}

/// ρ of strands on a core, from the core's radius.
pub(super) fn check_core(core_radius: f64) -> Result<f64, DomainError> {
    let positive = core_radius > 0.0 && core_radius < f64::INFINITY;
    DomainError::check(positive, "core_radius", core_radius, "greater than 0 and finite")?;
    Ok(1.0 + core_radius)
}

/// Strands that touch each other on a core: none where they lie straight, so that the core fixes no angle, or where it is too
/// small for them.
pub(super) fn core_contact(strands: u32, on_core: f64) -> Option<Contact> {
    Contact::from_radius_ratio(strands, on_core).ok().filter(|contact| contact.shift_ratio_squared() > 0.0)
}
