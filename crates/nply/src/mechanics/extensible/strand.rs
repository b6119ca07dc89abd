//! What strands and core are made of, once they stretch.

use crate::geometry::HelicalAngle;
use crate::{DomainError, Handedness};

/// A strand that stretches, bends and twists, in units of its radius r and bending stiffness B.
///
/// ```
/// use nply::mechanics::StretchingStrand;
/// let wire = StretchingStrand::solid_round(0.3)?;
/// assert_eq!(wire.axial_stiffness(), 4.0); // EA r²/B of any solid round wire
/// assert!((wire.stiffness_ratio() - 1.0 / 1.3).abs() < 1e-16);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StretchingStrand {
    stiffness_ratio: f64,
    axial_stiffness: f64,
    poissons_ratio: f64,
}

impl StretchingStrand {
    /// γ = C/B, α = EA r²/B and Poisson's ratio ν, by which the strand thins: its radius is r(1 − ν e) at strain e.
    ///
    /// α = ∞ are the strands of the paper, which do not stretch.
    ///
    /// # Errors
    /// [`DomainError`] unless γ > 0 is finite, α > 0 and −1 < ν ≤ 1/2.
    pub fn new(stiffness_ratio: f64, axial_stiffness: f64, poissons_ratio: f64) -> Result<Self, DomainError> {
        let positive = |value: f64| value > 0.0 && value < f64::INFINITY;
        DomainError::check(positive(stiffness_ratio), "stiffness_ratio", stiffness_ratio, "greater than 0 and finite")?;
        DomainError::check(
            axial_stiffness > 0.0,
            "axial_stiffness",
            axial_stiffness,
            "greater than 0 (infinite for strands that do not stretch)",
        )?;
        check_poisson(poissons_ratio)?;
        Ok(Self { stiffness_ratio, axial_stiffness, poissons_ratio })
    }

    /// A solid round wire or fibre: α = 4, γ = 1/(1 + ν).
    ///
    /// # Errors
    /// [`DomainError`] unless −1 < ν ≤ 1/2.
    pub fn solid_round(poissons_ratio: f64) -> Result<Self, DomainError> {
        check_poisson(poissons_ratio)?;
        Self::new(1.0 / (1.0 + poissons_ratio), 4.0, poissons_ratio)
    }

    /// The strands of the paper: γ alone, no stretch.
    ///
    /// # Errors
    /// [`DomainError`] unless γ > 0 is finite.
    pub fn inextensible(stiffness_ratio: f64) -> Result<Self, DomainError> {
        Self::new(stiffness_ratio, f64::INFINITY, 0.0)
    }

    /// γ = C/B.
    #[must_use]
    pub const fn stiffness_ratio(self) -> f64 {
        self.stiffness_ratio
    }

    /// α = EA r²/B, infinite where the strand does not stretch.
    #[must_use]
    pub const fn axial_stiffness(self) -> f64 {
        self.axial_stiffness
    }

    /// ν.
    #[must_use]
    pub const fn poissons_ratio(self) -> f64 {
        self.poissons_ratio
    }

    /// Whether it stretches at all.
    #[must_use]
    pub const fn stretches(self) -> bool {
        self.axial_stiffness < f64::INFINITY
    }
}

/// −1 < ν ≤ 1/2: between what an isotropic body can have.
pub(crate) fn check_poisson(poissons_ratio: f64) -> Result<(), DomainError> {
    DomainError::check(
        poissons_ratio > -1.0 && poissons_ratio <= 0.5,
        "poissons_ratio",
        poissons_ratio,
        "greater than -1 and at most 1/2",
    )
}

/// A straight core that carries its share: it stretches and twists with the ply, and thins.
///
/// In units of the strand's r and B; stress-free in the lay in which the ply was [formed](super::ExtensiblePly::formed_in).
///
/// ```
/// use nply::mechanics::WorkingCore;
/// // a king wire 5 % thicker than the wires around it, of the same steel: EA grows as r², GJ as r⁴
/// let king = WorkingCore::new(1.05, 4.0 * 1.05_f64.powi(2), 1.05_f64.powi(4) / 1.3, 0.3)?;
/// assert_eq!(king.radius(), 1.05);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkingCore {
    radius: f64,
    axial_stiffness: f64,
    torsional_stiffness: f64,
    poissons_ratio: f64,
}

impl WorkingCore {
    /// Radius in units of r, EA in B/r², GJ in B, Poisson's ratio.
    ///
    /// # Errors
    /// [`DomainError`] unless the radius is greater than 0, the stiffnesses are not negative, all are finite, and −1 < ν ≤ 1/2.
    pub fn new(
        radius: f64,
        axial_stiffness: f64,
        torsional_stiffness: f64,
        poissons_ratio: f64,
    ) -> Result<Self, DomainError> {
        let finite = |value: f64| (0.0..f64::INFINITY).contains(&value);
        DomainError::check(radius > 0.0 && finite(radius), "core_radius", radius, "greater than 0 and finite")?;
        for (name, value) in
            [("core_axial_stiffness", axial_stiffness), ("core_torsional_stiffness", torsional_stiffness)]
        {
            DomainError::check(finite(value), name, value, "at least 0 and finite")?;
        }
        check_poisson(poissons_ratio)?;
        Ok(Self { radius, axial_stiffness, torsional_stiffness, poissons_ratio })
    }

    /// A core that only keeps the strands out, and neither carries nor thins.
    ///
    /// # Errors
    /// [`DomainError`] unless the radius is greater than 0 and finite.
    pub fn rigid(radius: f64) -> Result<Self, DomainError> {
        Self::new(radius, 0.0, 0.0, 0.0)
    }

    /// Radius in units of r, unstrained.
    #[must_use]
    pub const fn radius(self) -> f64 {
        self.radius
    }

    /// EA in B/r².
    #[must_use]
    pub const fn axial_stiffness(self) -> f64 {
        self.axial_stiffness
    }

    /// GJ in B.
    #[must_use]
    pub const fn torsional_stiffness(self) -> f64 {
        self.torsional_stiffness
    }

    /// ν.
    #[must_use]
    pub const fn poissons_ratio(self) -> f64 {
        self.poissons_ratio
    }
}

/// The lay in which a ply was made: where its core is free of stress and to which its strands may be bent beforehand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FormedLay {
    /// ε₀.
    pub handedness: Handedness,
    /// θ₀.
    pub angle: HelicalAngle,
    /// ρ₀.
    pub radius_ratio: f64,
    /// How far strands were bent and twisted to this lay before they were put together: 0 straight strands, 1 stress-free in the lay.
    pub preforming: f64,
}

impl FormedLay {
    /// ε₀ sin θ₀/ρ₀: turns of the ply (in rad) per strand length.
    #[must_use]
    pub fn rotation(&self) -> f64 {
        self.handedness.sign() * self.angle.sin() / self.radius_ratio
    }

    /// κ₀: the curvature strands take by themselves.
    #[must_use]
    pub fn curvature(&self) -> f64 {
        self.preforming * self.angle.sin() * self.angle.sin() / self.radius_ratio
    }

    /// u₀: the twist strands take by themselves.
    #[must_use]
    pub fn twist(&self) -> f64 {
        self.preforming * self.rotation() * self.angle.cos()
    }
}
