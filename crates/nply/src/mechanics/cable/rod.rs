//! What a cable is made of: wires, or strands that count as one rod each.

use core::f64::consts::PI;

use super::super::extensible::check_poisson;
use crate::DomainError;

/// A rod of round outline, in any consistent units of length and force.
///
/// ```
/// use nply::mechanics::Rod;
/// // a steel wire of 5 mm: E = 200 GPa, ν = 0.3, in N and mm
/// let wire = Rod::solid_round(2.5, 200e3, 0.3)?;
/// assert!((wire.axial_stiffness() - 3.927e6).abs() < 1e3);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rod {
    radius: f64,
    axial: f64,
    bending: f64,
    torsional: f64,
    coupling: f64,
    poissons_ratio: f64,
    youngs_modulus: Option<f64>,
    area: f64,
    breaking_load: Option<f64>,
}

impl Rod {
    /// A solid round wire: EA = πEr², B = πEr⁴/4, C = B/(1 + ν).
    ///
    /// # Errors
    /// [`DomainError`] unless radius and modulus are greater than 0 and finite, and −1 < ν ≤ 1/2.
    pub fn solid_round(radius: f64, youngs_modulus: f64, poissons_ratio: f64) -> Result<Self, DomainError> {
        positive("youngs_modulus", youngs_modulus)?;
        check_poisson(poissons_ratio)?;
        let axial = PI * youngs_modulus * radius * radius;
        let bending = 0.25 * axial * radius * radius;
        let rod = Self::new(radius, axial, bending, bending / (1.0 + poissons_ratio), poissons_ratio)?;
        Ok(Self { youngs_modulus: Some(youngs_modulus), ..rod })
    }

    /// Radius, EA, bending stiffness B, torsional stiffness C, and Poisson's ratio: by how much the radius shrinks per strain, over itself.
    ///
    /// # Errors
    /// [`DomainError`] unless the radius and the stiffnesses are greater than 0 and finite, and −1 < ν ≤ 1/2.
    pub fn new(
        radius: f64,
        axial_stiffness: f64,
        bending_stiffness: f64,
        torsional_stiffness: f64,
        poissons_ratio: f64,
    ) -> Result<Self, DomainError> {
        positive("radius", radius)?;
        positive("axial_stiffness", axial_stiffness)?;
        positive("bending_stiffness", bending_stiffness)?;
        positive("torsional_stiffness", torsional_stiffness)?;
        check_poisson(poissons_ratio)?;
        Ok(Self::made(radius, [axial_stiffness, bending_stiffness, torsional_stiffness, 0.0], poissons_ratio))
    }

    /// EA, B, C and the coupling, known to be those of a rod.
    pub(super) const fn made(
        radius: f64,
        [axial, bending, torsional, coupling]: [f64; 4],
        poissons_ratio: f64,
    ) -> Self {
        Self {
            radius,
            axial,
            bending,
            torsional,
            coupling,
            poissons_ratio,
            youngs_modulus: None,
            area: PI * radius * radius,
            breaking_load: None,
        }
    }

    /// E of a solid round wire; `None` of what was given by its stiffnesses.
    #[must_use]
    pub const fn youngs_modulus(self) -> Option<f64> {
        self.youngs_modulus
    }

    /// The area that counts as wire, square to the rod: its outline's, or that of the wires of a strand; 0 of an [uncounted](Self::uncounted) core.
    #[must_use]
    pub const fn area(self) -> f64 {
        self.area
    }

    /// The same rod, whose section [counts](Self::area) for nothing: a core of fibre in a rope of wires, whose metallic section, modulus and breaking
    /// load are those of its wires.
    ///
    /// ```
    /// use nply::mechanics::Rod;
    /// let fibre = Rod::solid_round(2.1, 500.0, 0.0)?.uncounted();
    /// assert_eq!(fibre.area(), 0.0);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub const fn uncounted(self) -> Self {
        Self { area: 0.0, breaking_load: None, ..self }
    }

    /// The same rod, of a material with this tensile strength (force per area).
    ///
    /// # Errors
    /// [`DomainError`] unless it is greater than 0 and finite.
    ///
    /// ```
    /// use nply::mechanics::Rod;
    /// let wire = Rod::solid_round(2.0, 200e3, 0.3)?.of_strength(1770.0)?;
    /// assert!((wire.breaking_load().unwrap() - 22_242.5).abs() < 0.1);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn of_strength(self, tensile_strength: f64) -> Result<Self, DomainError> {
        positive("tensile_strength", tensile_strength)?;
        Ok(self.of_breaking_load(Some(tensile_strength * self.area)))
    }

    /// Tensile strength × section, of a strand summed over its wires; `None` where no strength is known.
    #[must_use]
    pub const fn breaking_load(self) -> Option<f64> {
        self.breaking_load
    }

    pub(super) const fn of_breaking_load(self, breaking_load: Option<f64>) -> Self {
        Self { breaking_load, ..self }
    }

    /// The same rod with another solid area.
    pub(super) const fn of_area(self, area: f64) -> Self {
        Self { area, ..self }
    }

    /// E and ν of a solid round wire.
    pub(super) fn material(self) -> Option<[f64; 2]> {
        self.youngs_modulus.map(|modulus| [modulus, self.poissons_ratio])
    }

    /// Radius.
    #[must_use]
    pub const fn radius(self) -> f64 {
        self.radius
    }

    /// EA, a force.
    #[must_use]
    pub const fn axial_stiffness(self) -> f64 {
        self.axial
    }

    /// B, force·length².
    #[must_use]
    pub const fn bending_stiffness(self) -> f64 {
        self.bending
    }

    /// C, force·length².
    #[must_use]
    pub const fn torsional_stiffness(self) -> f64 {
        self.torsional
    }

    /// Torque per strain, equal to tension per twist, force·length: 0 of a wire, positive of a right-handed strand.
    #[must_use]
    pub const fn coupling(self) -> f64 {
        self.coupling
    }

    /// By how much the radius shrinks per strain, over itself: Poisson's ratio of a wire. A strand's may be more than 1/2.
    #[must_use]
    pub const fn poissons_ratio(self) -> f64 {
        self.poissons_ratio
    }
}

fn positive(name: &'static str, value: f64) -> Result<(), DomainError> {
    DomainError::check(value > 0.0 && value < f64::INFINITY, name, value, "greater than 0 and finite")
}
