//! Euler's buckling of the ply as a whole, between two bounds.

use core::f64::consts::PI;

use super::{Equilibrium, SupportedState};
use crate::DomainError;
use crate::geometry::HelicalAngle;

/// Bounds on the bending stiffness of the ply as a whole, in units of B.
///
/// They are no estimate of the stiffness itself: friction between the strands decides where in between it lies. The upper one is of solid
/// round strands. Of others, such as yarns of loose fibres or molecules, EA is not tied to B, and it bounds nothing.
///
/// ```
/// use nply::mechanics::{Load, Ply, Twist};
/// let state = Ply::new(3, 0.75)?.equilibria(Twist::Pretwist(-1.0), Load::NONE)?[0];
/// let bounds = state.bending_bounds();
/// assert!(bounds.sliding < 3.0 && bounds.locked > 3.0);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BendingBounds {
    /// Strands that slide freely, each bending as a helical spring: nB cos θ/(1 + ½ sin²θ (1/γ − 1)). From the mean over a turn
    /// of (t·M)²/C + (1 − (t·M)²)/B with ⟨(t·M)²⟩ = ½ sin²θ, t the tangent: Timoshenko & Gere, *Theory of Elastic Stability*,
    /// on helical springs.
    pub sliding: f64,
    /// Solid round strands that cannot slide, by parallel axes: n (B + ½ EA R²), with EA r² = 4B of a solid round strand nB (1 + 2ρ²).
    pub locked: f64,
}

impl BendingBounds {
    fn new(strands: u32, angle: HelicalAngle, radius_ratio: f64, gamma: f64) -> Self {
        let n = f64::from(strands);
        let (s, c) = (angle.sin(), angle.cos());
        Self {
            sliding: n * c / (1.0 + 0.5 * s * s * (1.0 / gamma - 1.0)),
            locked: n * (1.0 + 2.0 * radius_ratio * radius_ratio),
        }
    }

    /// The least thrust, −f > 0, under which a ply of given length (units of r), hinged at both ends, buckles as a whole while it
    /// carries the end moment m: Greenhill's P = B_ply ((π/ℓ)² − (m/2B_ply)²), for a sliding and for a locked ply. Negative where the
    /// moment alone is enough and a tension has to hold it. Greenhill 1883; Timoshenko & Gere, *Theory of Elastic Stability*.
    ///
    /// # Errors
    /// [`DomainError`] unless the length is greater than 0 and the moment is finite.
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// let bounds = Ply::new(3, 0.75)?.equilibria(Twist::Pretwist(-1.0), Load::NONE)?[0].bending_bounds();
    /// let [sliding, locked] = bounds.buckling_thrust(100.0, 0.0)?;
    /// assert!((sliding - bounds.sliding * (std::f64::consts::PI / 100.0).powi(2)).abs() < 1e-15 && locked > sliding);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn buckling_thrust(&self, ply_length: f64, moment: f64) -> Result<[f64; 2], DomainError> {
        let positive = ply_length > 0.0 && ply_length < f64::INFINITY;
        DomainError::check(positive, "ply_length", ply_length, "greater than 0 and finite")?;
        DomainError::check(moment.is_finite(), "moment", moment, "finite")?;
        let wave = PI / ply_length;
        Ok([self.sliding, self.locked].map(|stiffness| {
            let turn = 0.5 * moment / stiffness;
            stiffness * (wave - turn) * (wave + turn)
        }))
    }
}

impl Equilibrium {
    /// Bounds on the ply's bending stiffness in this state.
    #[must_use]
    pub fn bending_bounds(&self) -> BendingBounds {
        let contact = &self.contact;
        BendingBounds::new(contact.strands(), contact.angle(), contact.radius_ratio(), self.stiffness_ratio)
    }
}

impl SupportedState {
    /// As [`Equilibrium::bending_bounds`]; a core's own stiffness is not in it.
    #[must_use]
    pub fn bending_bounds(&self) -> BendingBounds {
        BendingBounds::new(self.strands(), self.angle(), self.radius_ratio(), self.stiffness_ratio())
    }
}
