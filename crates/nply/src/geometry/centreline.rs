//! A strand's centreline, (1)–(3), and its Frenet frame.

use core::f64::consts::TAU;

use super::Contact;
use crate::Handedness;

/// A vector in the fixed frame, z along the ply's axis; lengths in units of r.
pub type Vector = [f64; 3];

/// The centreline of one strand of a ply.
///
/// ```
/// use nply::Handedness::Right;
/// use nply::geometry::{Centreline, Contact};
/// let contact = Contact::new(3, 0.5)?;
/// let first = Centreline::new(&contact, Right, 0);
/// // one lay length further up, after 2πR/sin θ of strand, it is back above its start
/// let s = contact.lay_length() / 0.5_f64.cos();
/// let (a, b) = (first.position(0.0), first.position(s));
/// assert!((a[0] - b[0]).abs() < 1e-13 && (a[1] - b[1]).abs() < 1e-13 && (b[2] - contact.lay_length()).abs() < 1e-12);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Centreline {
    radius: f64,
    sin: f64,
    cos: f64,
    eps: f64,
    /// 2πi/n
    phase: f64,
}

/// Tangent, normal (towards the axis) and binormal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrenetFrame {
    /// r′ = d₃, (14), (15).
    pub tangent: Vector,
    /// r″/|r″|, as (9) should read.
    pub normal: Vector,
    /// r′ × normal.
    pub binormal: Vector,
}

impl Centreline {
    #[doc = include_str!("../equations/eq01.md")]
    ///
    #[doc = include_str!("../equations/eq02.md")]
    ///
    #[doc = include_str!("../equations/eq03.md")]
    ///
    /// `strand` counts from 0 and is taken modulo n.
    #[must_use]
    pub fn new(contact: &Contact, handedness: Handedness, strand: u32) -> Self {
        let n = contact.strands();
        Self {
            radius: contact.radius_ratio(),
            sin: contact.angle().sin(),
            cos: contact.angle().cos(),
            eps: handedness.sign(),
            phase: TAU * f64::from(strand % n) / f64::from(n),
        }
    }

    /// ψ(s) of (1) and the strand's own turn 2πi/n, rad.
    #[must_use]
    pub fn azimuth(&self, s: f64) -> f64 {
        self.eps * s * self.sin / self.radius + self.phase
    }

    /// r(s), (1) and (2); s in units of r.
    #[must_use]
    pub fn position(&self, s: f64) -> Vector {
        let [sin_psi, cos_psi] = self.direction(s);
        [self.eps * self.radius * sin_psi, -self.eps * self.radius * cos_psi, s * self.cos]
    }

    /// The Frenet frame at s.
    #[must_use]
    pub fn frame(&self, s: f64) -> FrenetFrame {
        let [sin_psi, cos_psi] = self.direction(s);
        let (eps, sin, cos) = (self.eps, self.sin, self.cos);
        FrenetFrame {
            tangent: [sin * cos_psi, sin * sin_psi, cos],
            normal: [-eps * sin_psi, eps * cos_psi, 0.0],
            binormal: [-eps * cos * cos_psi, -eps * cos * sin_psi, eps * sin],
        }
    }

    /// sin ψ and cos ψ.
    fn direction(&self, s: f64) -> [f64; 2] {
        let (sin_psi, cos_psi) = libm::sincos(self.azimuth(s));
        [sin_psi, cos_psi]
    }
}
