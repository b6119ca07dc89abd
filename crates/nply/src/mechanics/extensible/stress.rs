//! Stresses of solid round wires: outer fibres of strand and core, and the pressure where wires lie along each other.

use core::f64::consts::FRAC_PI_4;

use super::state::ExtensibleState;
use crate::mechanics::line_contact::{WireSurface, hertz_pressure, inward_to_neighbour};

/// Where on a wire's surface the pull is greatest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fibre {
    /// The side away from the ply's axis.
    Outer,
    /// The side towards the axis.
    Inner,
    /// The whole surface: no bending.
    All,
}

impl Fibre {
    /// The name used in JSON: `outer`, `inner` or `all`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Outer => "outer",
            Self::Inner => "inner",
            Self::All => "all",
        }
    }
}

/// Stresses at the surface of a solid round wire, each over the wire's own Young's modulus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WireStress {
    /// Along the wire, the same all over the section: from stretch, and in a core from what presses on its sides.
    pub stretch: f64,
    /// From bending, at the fibre where it pulls.
    pub bending: f64,
    /// Shear from twist, at the surface.
    pub twist: f64,
    /// Pressure from the sides, evenly spread: of a core that strands lie on. A strand is pulled most where nothing lies on it.
    pub sides: f64,
    /// Where stretch and bending add up.
    pub fibre: Fibre,
}

impl WireStress {
    /// Greatest pull along the wire: stretch and bending.
    #[must_use]
    pub fn greatest(&self) -> f64 {
        self.stretch + self.bending
    }

    /// Von Mises' equivalent stress at the worst fibre, of pull or thrust; a pressure alike from all sides and along the wire is none.
    #[must_use]
    pub fn equivalent(&self) -> f64 {
        let axial = (self.stretch + self.sides).abs() + self.bending;
        libm::sqrt(axial * axial + 3.0 * self.twist * self.twist)
    }
}

impl ExtensibleState {
    /// Stresses in a strand that is a solid round wire, over its Young's modulus: e, (λκ − κ₀) r and G/E (u₃ − u₀) r, with G/E = γ/2.
    ///
    /// ```
    /// use nply::mechanics::{ExtensiblePly, Load, StretchingStrand, Twist};
    /// let yarn = ExtensiblePly::new(3, StretchingStrand::solid_round(0.3)?)?;
    /// let state = yarn.states(Twist::Pretwist(-0.2), Load { force: 0.05, moment: 0.0 })?[0];
    /// assert!((state.strand_stress().bending - state.bending()).abs() < 1e-16); // straight fibres, bent
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn strand_stress(&self) -> WireStress {
        let bending = self.bending();
        let fibre = if bending > 0.0 {
            Fibre::Outer
        } else if bending < 0.0 {
            Fibre::Inner
        } else {
            Fibre::All
        };
        let twist = 0.5 * self.ply.strand().stiffness_ratio() * self.torsion().abs();
        WireStress { stretch: self.strain, bending: bending.abs(), twist, sides: 0.0, fibre }
    }

    /// Stresses in a core that is a solid round wire, over its own Young's modulus; `None` without a core that works.
    #[must_use]
    pub fn core_stress(&self) -> Option<WireStress> {
        let (core, lay) = self.ply.core().zip(self.ply.formed())?;
        let works = core.axial_stiffness() > 0.0;
        let turn = (self.rotation() - lay.rotation()) / lay.angle.cos();
        works.then(|| WireStress {
            stretch: self.core_force() / core.axial_stiffness(),
            bending: 0.0,
            // G/E = GJ/EA · 2/r_c² for a solid round section
            twist: 2.0 * core.torsional_stiffness() / core.axial_stiffness() / core.radius() * turn.abs(),
            sides: self.squeeze() / core.axial_stiffness(),
            fibre: Fibre::All,
        })
    }

    /// Force between two neighbours per length of the line along which they touch, r³/B; 0 where they do not.
    ///
    /// [`interstrand_pressure`](Self::interstrand_pressure) is per unstretched strand length; the line (13) is shorter.
    #[must_use]
    pub fn neighbour_line_load(&self) -> f64 {
        self.interstrand_pressure() / self.line_length(self.touching.contact_line_radius() * self.thickness())
    }

    /// Force of a strand on the core per length of the line along which it lies, r³/B; 0 where it does not.
    #[must_use]
    pub fn core_line_load(&self) -> f64 {
        self.core_radius().map_or(0.0, |radius| self.core_pressure() / self.line_length(radius))
    }

    /// Length of a helix of the ply's lay at a radius, per unstretched strand length.
    fn line_length(&self, radius: f64) -> f64 {
        libm::hypot(self.extension(), radius * self.turn)
    }

    /// Greatest pressure between neighbours by Hertz's line contact of like solid round wires, over their Young's modulus; `None` where
    /// they do not press.
    ///
    /// p₀ = √(w E*/(π R*)), E* = E/(2(1 − ν²)). Surfaces that touch along a line differ there in curvature across it alone, so that 1/R* is
    /// the sum of their principal curvatures: of each wire 1/r − κ cos φ/(1 − r κ cos φ), φ being the angle from its inner side to the line.
    #[must_use]
    pub fn neighbour_hertz_pressure(&self) -> Option<f64> {
        let curvature = 2.0 * self.surface().facing(inward_to_neighbour(&self.touching));
        self.hertz(self.neighbour_line_load(), curvature)
    }

    /// The same between strand and core of like solid round material; `None` where a strand does not press on it.
    #[must_use]
    pub fn core_hertz_pressure(&self) -> Option<f64> {
        let curvature = self.surface().facing(1.0) + 1.0 / self.core_radius()?;
        self.hertz(self.core_line_load(), curvature)
    }

    fn surface(&self) -> WireSurface {
        WireSurface {
            radius: self.thickness(),
            curvature: self.angle().sin() * self.angle().sin() / self.radius_ratio(),
        }
    }

    /// p₀/E, with B = πEr⁴/4 of a solid round wire as unit.
    fn hertz(&self, line_load: f64, curvature: f64) -> Option<f64> {
        let material = [1.0 / FRAC_PI_4, self.ply.strand().poissons_ratio()];
        Some(FRAC_PI_4 * hertz_pressure(line_load, curvature, [material; 2])?)
    }
}
