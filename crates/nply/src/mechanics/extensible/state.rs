//! A state of strands that stretch.

use core::f64::consts::TAU;

use super::obstacle::{self, thickness};
use super::ply::ExtensiblePly;
use super::potential::{Potential, Slopes, Spot};
use crate::geometry::{Contact, HelicalAngle};
use crate::mechanics::{Load, Support, Twist};
use crate::{DomainError, Handedness};

/// A state in equilibrium of a ply whose strands stretch. Lengths in units of the unstretched strand's radius, per unstretched strand
/// length where "per strand length" is said.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExtensibleState {
    pub(super) ply: ExtensiblePly,
    pub(super) support: Support,
    pub(super) handedness: Handedness,
    pub(super) touching: Contact,
    /// Y > 0 in the sense of the hand
    pub(super) turn: f64,
    pub(super) strain: f64,
    pub(super) twist: Twist,
    pub(super) load: Load,
    /// multipliers of Y ≤ that of touching neighbours, and of Y ≤ that on the core
    pub(super) shares: [f64; 2],
}

/// Energies per strand and unstretched strand length, in units of B/r².
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct StretchEnergy {
    /// ½ α e².
    pub stretch: f64,
    /// ½ (λκ − κ₀)².
    pub bending: f64,
    /// ½ γ (u₃ − u₀)².
    pub torsion: f64,
    /// The core's, shared out among the strands.
    pub core: f64,
    /// −(f/n) λ cos θ − ε (m/n) λ sin θ/ρ.
    pub loads: f64,
}

impl StretchEnergy {
    /// All together.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.stretch + self.bending + self.torsion + self.core + self.loads
    }
}

impl ExtensibleState {
    /// The ply it is a state of.
    #[must_use]
    pub const fn ply(&self) -> &ExtensiblePly {
        &self.ply
    }

    /// What carries the strands.
    #[must_use]
    pub const fn support(&self) -> Support {
        self.support
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

    /// e = λ − 1, the strain of a strand's centreline.
    #[must_use]
    pub const fn strain(&self) -> f64 {
        self.strain
    }

    /// λ.
    #[must_use]
    pub fn stretch(&self) -> f64 {
        1.0 + self.strain
    }

    /// Radius of the stretched strand over that of the unstretched: 1 − νe.
    #[must_use]
    pub fn thickness(&self) -> f64 {
        thickness(&self.ply, self.strain)
    }

    /// R/r, r unstretched.
    #[must_use]
    pub fn radius_ratio(&self) -> f64 {
        match self.support {
            Support::Neighbours | Support::Both => self.thickness() * self.touching.radius_ratio(),
            Support::Core => self.thickness() + self.core_radius().unwrap_or(f64::NAN),
            Support::Free => (1.0 + self.strain) * self.angle().sin() / self.turn,
        }
    }

    /// Radius of the core, thinned, in units of r; `None` without one.
    #[must_use]
    pub fn core_radius(&self) -> Option<f64> {
        self.ply.core().map(|_| obstacle::core_radius(&self.ply, self.angle(), self.strain).value)
    }

    /// Radius of the cylinder around the ply, in units of r.
    #[must_use]
    pub fn outer_radius(&self) -> f64 {
        self.radius_ratio() + self.thickness()
    }

    /// What is held of the twist.
    #[must_use]
    pub const fn twist(&self) -> Twist {
        self.twist
    }

    /// End force and end moment on the whole ply, core included.
    #[must_use]
    pub const fn load(&self) -> Load {
        self.load
    }

    /// Ply length per unstretched strand length, λ cos θ.
    #[must_use]
    pub fn extension(&self) -> f64 {
        (1.0 + self.strain) * self.angle().cos()
    }

    /// Rotation of the ply's end in rad per unstretched strand length, times r.
    #[must_use]
    pub fn rotation(&self) -> f64 {
        self.handedness.sign() * self.turn
    }

    /// Ply length per turn of a strand, in units of r.
    #[must_use]
    pub fn lay_length(&self) -> f64 {
        TAU * self.extension() / self.turn
    }

    /// Twist of a strand, rad per unstretched strand length, times r.
    #[must_use]
    pub fn strand_twist(&self) -> f64 {
        match self.twist {
            Twist::Pretwist(pretwist) => pretwist + self.rotation() * self.angle().cos(),
            Twist::StrandTwist(strand_twist) => strand_twist,
        }
    }

    /// Change of curvature against what the strand takes by itself, λκ − κ₀, times r.
    #[must_use]
    pub fn bending(&self) -> f64 {
        self.turn * self.angle().sin() - self.ply.formed().map_or(0.0, |lay| lay.curvature())
    }

    /// Twist against what the strand takes by itself, u₃ − u₀, times r.
    #[must_use]
    pub fn torsion(&self) -> f64 {
        self.strand_twist() - self.ply.formed().map_or(0.0, |lay| lay.twist())
    }

    /// p₁ r³/B from each neighbour, per unstretched strand length.
    #[must_use]
    pub fn interstrand_pressure(&self) -> f64 {
        0.5 * self.shares[0] * self.turn / self.thickness()
    }

    /// p_c r³/B from the core, per unstretched strand length.
    #[must_use]
    pub fn core_pressure(&self) -> f64 {
        self.shares[1] * self.turn / self.radius_ratio()
    }

    /// Clearance between the surfaces of neighbours, in units of r; 0 where they touch.
    #[must_use]
    pub fn neighbour_gap(&self) -> f64 {
        match self.support {
            Support::Neighbours | Support::Both => 0.0,
            Support::Core | Support::Free => {
                2.0 * (self.radius_ratio() / self.touching.radius_ratio() - self.thickness())
            }
        }
    }

    /// Clearance between strand and core, in units of r; `None` without a core.
    #[must_use]
    pub fn core_gap(&self) -> Option<f64> {
        let core = self.core_radius()?;
        Some(match self.support {
            Support::Core | Support::Both => 0.0,
            Support::Neighbours | Support::Free => self.radius_ratio() - self.thickness() - core,
        })
    }

    /// Force in the core in B/r², 0 without one that works: what its strain asks for, less what the strands that lie on it push along it,
    /// which thins when it is pulled: with the strands' own it makes up the force at the ends.
    #[must_use]
    pub fn core_force(&self) -> f64 {
        let Some(core) = self.ply.core() else { return 0.0 };
        core.axial_stiffness() * self.core_strain() - 2.0 * core.poissons_ratio() * self.squeeze()
    }

    /// How much longer the core is than as made.
    pub(super) fn core_strain(&self) -> f64 {
        self.ply.formed().map_or(0.0, |lay| self.extension() / lay.angle.cos() - 1.0)
    }

    /// What lies on the core, evenly spread over its surface, times its section, both as made.
    pub(super) fn squeeze(&self) -> f64 {
        let Some((core, lay)) = self.ply.core().zip(self.ply.formed()) else { return 0.0 };
        0.5 * f64::from(self.ply.strands()) * self.core_pressure() * core.radius() / lay.angle.cos()
    }

    /// Torque of the core in B/r, right-handed positive.
    #[must_use]
    pub fn core_moment(&self) -> f64 {
        let Some((core, lay)) = self.ply.core().zip(self.ply.formed()) else { return 0.0 };
        core.torsional_stiffness() * (self.rotation() - lay.rotation()) / lay.angle.cos()
    }

    /// Energies per strand and unstretched strand length.
    ///
    /// ```
    /// use nply::mechanics::{ExtensiblePly, Load, StretchingStrand, Twist};
    /// let yarn = ExtensiblePly::new(3, StretchingStrand::solid_round(0.3)?)?;
    /// for state in yarn.states(Twist::Pretwist(-0.2), Load { force: 0.1, moment: 0.0 })? {
    ///     assert!(state.energy().stretch > 0.0 && state.energy().core == 0.0);
    /// }
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn energy(&self) -> StretchEnergy {
        let [stretch, bending, torsion, core, loads] =
            self.potential().parts(&self.spot(), self.ply.strand().stiffness_ratio());
        StretchEnergy { stretch, bending, torsion, core, loads }
    }

    pub(super) fn spot(&self) -> Spot {
        Spot { sin: self.angle().sin(), cos: self.angle().cos(), rotation: self.turn, strain: self.strain }
    }

    pub(super) fn potential(&self) -> Potential {
        Potential::new(&self.ply, self.handedness, self.twist, self.load)
    }

    pub(super) fn slopes(&self) -> Slopes {
        self.potential().at(&self.spot())
    }

    /// Right-handed first, then by angle.
    pub(super) fn in_order(&self, other: &Self) -> core::cmp::Ordering {
        let left = |s: &Self| s.handedness == Handedness::Left;
        left(self).cmp(&left(other)).then(self.angle().radians().total_cmp(&other.angle().radians()))
    }

    /// The same state with the strands' twisting moment held.
    #[must_use]
    pub fn with_strand_twist_held(self) -> Self {
        Self { twist: Twist::StrandTwist(self.strand_twist()), ..self }
    }
}

/// Stretch is looked for between half and double the length: beyond, linear elasticity means nothing.
pub(super) const LEAST_STRAIN: f64 = -0.5;
/// See [`LEAST_STRAIN`].
pub(super) const MOST_STRAIN: f64 = 1.0;

/// Refuses data under which strands would be stretched beyond what is looked at.
pub(super) fn beyond(force: f64) -> DomainError {
    DomainError {
        quantity: "force",
        value: force,
        allowed: "such that, with the other data, strands are stretched to no less than half and no more than double their length",
    }
}
