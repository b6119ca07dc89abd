//! The curve along which neighbours touch: a helix, (12) and (13).

use core::f64::consts::PI;

use super::{Contact, Vector};
use crate::Handedness;

/// The contact curve between strand 0 and strand 1; the others are turned by 2πi/n.
///
/// ```
/// use nply::Handedness::Left;
/// use nply::geometry::{Centreline, Contact, ContactLine};
/// let contact = Contact::new(4, 0.7)?;
/// let line = ContactLine::new(&contact, Left);
/// // every point of it is one strand radius away from the touching points of both centrelines
/// let (c, a) = (line.position(2.0), Centreline::new(&contact, Left, 0).position(2.0 - 0.5 * line.shift()));
/// let distance = (0..3).map(|i| (c[i] - a[i]).powi(2)).sum::<f64>().sqrt();
/// assert!((distance - 1.0).abs() < 1e-14);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLine {
    radius: f64,
    azimuth_rate: f64,
    phase: f64,
    rise: f64,
    eps: f64,
    shift: f64,
}

impl ContactLine {
    #[doc = include_str!("../equations/eq12.md")]
    ///
    #[doc = include_str!("../equations/eq13.md")]
    #[must_use]
    pub fn new(contact: &Contact, handedness: Handedness) -> Self {
        let (eps, rho) = (handedness.sign(), contact.radius_ratio());
        Self {
            radius: contact.contact_line_radius(),
            azimuth_rate: eps * contact.angle().sin() / rho,
            phase: PI / f64::from(contact.strands()),
            rise: contact.angle().cos(),
            eps,
            shift: -eps * contact.arclength_shift() * rho,
        }
    }

    /// Its radius in units of r; 0 in line contact.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// s₂ − s₁ = −εxR: how much further along strand 1 than along strand 0 the touching section lies, in units of r.
    #[must_use]
    pub const fn shift(&self) -> f64 {
        self.shift
    }

    /// The contact point whose two sections have the mean arclength s (units of r).
    #[must_use]
    pub fn position(&self, s: f64) -> Vector {
        let (sin, cos) = libm::sincos(self.azimuth_rate * s + self.phase);
        [self.eps * self.radius * sin, -self.eps * self.radius * cos, s * self.rise]
    }
}
