//! The one place where numbers get dimensions.

use crate::DomainError;

/// Turns the theory's dimensionless results (r = B = 1) into dimensional ones: units of length r and of force B/r².
///
/// Any consistent system of units serves; with r in m and B in N m² everything comes out in SI.
///
/// ```
/// use nply::Scale;
/// let yarn = Scale::new(1e-4, 2e-10)?; // r = 0.1 mm, B = 2e-10 N m²
/// assert!((yarn.force(1.0) - 0.02).abs() < 1e-16);
/// assert!((yarn.moment(0.5) - 1e-6).abs() < 1e-20);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    strand_radius: f64,
    bending_stiffness: f64,
}

impl Scale {
    /// From the strand radius r (length) and the strand's bending stiffness B (force·length²).
    ///
    /// # Errors
    /// [`DomainError`] unless both are finite and greater than zero.
    pub fn new(strand_radius: f64, bending_stiffness: f64) -> Result<Self, DomainError> {
        let positive = |value: f64| value > 0.0 && value < f64::INFINITY;
        DomainError::check(positive(strand_radius), "strand_radius", strand_radius, "greater than 0 and finite")?;
        DomainError::check(
            positive(bending_stiffness),
            "bending_stiffness",
            bending_stiffness,
            "greater than 0 and finite",
        )?;
        Ok(Self { strand_radius, bending_stiffness })
    }

    /// r, the unit of length.
    #[must_use]
    pub const fn strand_radius(self) -> f64 {
        self.strand_radius
    }

    /// B, the strand's bending stiffness: force·length².
    #[must_use]
    pub const fn bending_stiffness(self) -> f64 {
        self.bending_stiffness
    }

    /// A length: `value`·r.
    #[must_use]
    pub fn length(self, value: f64) -> f64 {
        value * self.strand_radius
    }

    /// A curvature, twist or turns per length: `value`/r.
    #[must_use]
    pub fn per_length(self, value: f64) -> f64 {
        value / self.strand_radius
    }

    /// A force, such as F₀ from f, (39): `value`·B/r².
    #[must_use]
    pub fn force(self, value: f64) -> f64 {
        value * self.bending_stiffness / self.strand_radius / self.strand_radius
    }

    /// A moment, such as M₀ from m, (39), or a torsional stiffness per length: `value`·B/r.
    #[must_use]
    pub fn moment(self, value: f64) -> f64 {
        value * self.bending_stiffness / self.strand_radius
    }

    /// A stiffness against bending or torsion (force·length²): `value`·B.
    #[must_use]
    pub fn stiffness(self, value: f64) -> f64 {
        value * self.bending_stiffness
    }

    /// A force per length, such as p from p r³/B, (41): `value`·B/r³.
    #[must_use]
    pub fn force_per_length(self, value: f64) -> f64 {
        self.force(value) / self.strand_radius
    }

    /// An energy per strand length (a force): `value`·B/r².
    #[must_use]
    pub fn energy_per_length(self, value: f64) -> f64 {
        self.force(value)
    }
}
