//! The cut across the ply, normal to its axis, (9)–(11).

use core::f64::consts::TAU;

use super::lay::where_rising;
use super::{Contact, HelicalAngle, check_strands};
use crate::{DomainError, Handedness};

/// The outline of a strand where a plane normal to the ply's axis cuts it. Lengths in units of r.
///
/// ```
/// use nply::Handedness::Right;
/// use nply::geometry::{Contact, Section};
/// let steep = Section::new(&Contact::new(3, 20_f64.to_radians())?, Right);
/// assert!(steep.is_convex()); // Figure 5a
/// let flat = Section::new(&Contact::new(3, 60_f64.to_radians())?, Right);
/// assert!(!flat.is_convex()); // Figure 5b
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    strands: u32,
    radius: f64,
    sin: f64,
    cos: f64,
    eps: f64,
}

impl Section {
    #[doc = include_str!("../equations/eq09.md")]
    ///
    #[doc = include_str!("../equations/eq10.md")]
    ///
    #[doc = include_str!("../equations/eq11.md")]
    #[must_use]
    pub fn new(contact: &Contact, handedness: Handedness) -> Self {
        Self {
            strands: contact.strands(),
            radius: contact.radius_ratio(),
            sin: contact.angle().sin(),
            cos: contact.angle().cos(),
            eps: handedness.sign(),
        }
    }

    /// As [`Section::new`], of strands that lie on a helix radius of their own: on a core, or free.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, and unless the helix radius (over r) is finite and not negative.
    ///
    /// ```
    /// use nply::Handedness::Left;
    /// use nply::geometry::{Contact, HelicalAngle, Section};
    /// let angle = HelicalAngle::new(0.6)?;
    /// let contact = Contact::at_angle(5, angle)?;
    /// let laid = Section::on_helix(5, contact.radius_ratio(), angle, Left)?;
    /// assert_eq!(laid, Section::new(&contact, Left));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn on_helix(
        strands: u32,
        radius_ratio: f64,
        angle: HelicalAngle,
        handedness: Handedness,
    ) -> Result<Self, DomainError> {
        check_strands(strands)?;
        let allowed = "finite and not less than 0";
        DomainError::check((0.0..f64::INFINITY).contains(&radius_ratio), "radius_ratio", radius_ratio, allowed)?;
        Ok(Self { strands, radius: radius_ratio, sin: angle.sin(), cos: angle.cos(), eps: handedness.sign() })
    }

    /// (11): the arclength of the material section through which the plane at height z₀ meets the surface at angle α.
    #[must_use]
    pub fn arclength(&self, height: f64, alpha: f64) -> f64 {
        (height - self.eps * libm::cos(alpha) * self.sin) / self.cos
    }

    /// (10): the surface of strand 0 at arclength s and angle α about its section, α = π/2 towards the axis.
    #[must_use]
    pub fn surface(&self, s: f64, alpha: f64) -> [f64; 3] {
        self.turned_surface(s, alpha, 0.0)
    }

    /// The point at angle α in [0, 2π] of the outline of strand `strand` (from 0, modulo n) in the plane at height z₀.
    #[must_use]
    pub fn outline(&self, strand: u32, height: f64, alpha: f64) -> [f64; 2] {
        let phase = TAU * f64::from(strand % self.strands) / f64::from(self.strands);
        let [x, y, _] = self.turned_surface(self.arclength(height, alpha), alpha, phase);
        [x, y]
    }

    fn turned_surface(&self, s: f64, alpha: f64, phase: f64) -> [f64; 3] {
        let (sin_psi, cos_psi) = libm::sincos(self.eps * s * self.sin / self.radius + phase);
        let (sin_alpha, cos_alpha) = libm::sincos(alpha);
        let (radial, hoop) = (self.radius - sin_alpha, -cos_alpha * self.cos);
        [
            self.eps * (radial * sin_psi + hoop * cos_psi),
            self.eps * (hoop * sin_psi - radial * cos_psi),
            s * self.cos + self.eps * cos_alpha * self.sin,
        ]
    }

    /// Whether the outline is convex. It turns hollow first where it is nearest to the axis.
    #[must_use]
    pub fn is_convex(&self) -> bool {
        // with k = sin²θ/(ρ cos θ), the outline's curvature there has the sign of 1 − 2k cos θ − (ρ − 1)k²
        let k = self.sin * self.sin / (self.radius * self.cos);
        2.0 * k * self.cos + (self.radius - 1.0) * k * k <= 1.0
    }

    /// The θ above which the cut of an n-ply is no longer convex: 51.1577° for n = 3.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`.
    ///
    /// ```
    /// use nply::geometry::Section;
    /// assert!((Section::non_convex_angle(3)?.degrees() - 51.1577).abs() < 5e-5);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn non_convex_angle(strands: u32) -> Result<HelicalAngle, DomainError> {
        check_strands(strands)?;
        Ok(Self::turns_hollow(strands).angle())
    }

    /// The contact at which the outline turns hollow.
    pub(super) fn turns_hollow(strands: u32) -> Contact {
        where_rising(strands, 1.0, |at| {
            // k = sin²θ/(ρ cos θ); (ρ − 1)k² = (ρ cos θ − cos θ) k²/cos θ
            let k = at.sin * at.sin * at.radius.recip();
            2.0 * (k * at.cos) + (at.radius - at.cos) * k * k * at.cos.recip()
        })
    }
}
