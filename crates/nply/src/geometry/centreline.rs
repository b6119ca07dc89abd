//! A strand's centreline, (1)–(3), and its Frenet frame.

use core::f64::consts::{PI, TAU};

use super::{Contact, HelicalAngle};
use crate::numerics::foot;
use crate::{DomainError, Handedness};

/// A vector in the fixed frame, z along the ply's axis; lengths in units of r.
pub type Vector = [f64; 3];

/// The centreline of one strand of a ply, or any helix about the ply's axis, or that axis.
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
    /// ε sin θ/R, 0 of a straight line
    rate: f64,
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
        let phase = TAU * f64::from(strand % n) / f64::from(n);
        Self::about_axis(contact.radius_ratio(), contact.angle(), handedness, phase)
    }

    /// A helix of any radius, touching or not: R/r, its angle, its hand, and its azimuth ψ at height 0 in rad.
    ///
    /// # Errors
    /// [`DomainError`] on `radius_ratio` unless it is finite and greater than 0, on `azimuth` unless it is finite.
    ///
    /// ```
    /// use nply::Handedness::Left;
    /// use nply::geometry::{Centreline, HelicalAngle};
    /// let wire = Centreline::helix(2.0, HelicalAngle::new(0.3)?, Left, 0.0)?;
    /// assert!((wire.curvature() - 0.3_f64.sin().powi(2) / 2.0).abs() < 1e-16); // sin²θ/R
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn helix(
        radius_ratio: f64,
        angle: HelicalAngle,
        handedness: Handedness,
        azimuth: f64,
    ) -> Result<Self, DomainError> {
        let positive = radius_ratio > 0.0 && radius_ratio < f64::INFINITY;
        DomainError::check(positive, "radius_ratio", radius_ratio, "greater than 0 and finite")?;
        DomainError::check(azimuth.is_finite(), "azimuth", azimuth, "finite")?;
        Ok(Self::about_axis(radius_ratio, angle, handedness, azimuth))
    }

    /// The ply's axis itself, the centreline of a core.
    #[must_use]
    pub const fn axis() -> Self {
        Self { radius: 0.0, rate: 0.0, sin: 0.0, cos: 1.0, eps: 1.0, phase: 0.0 }
    }

    fn about_axis(radius: f64, angle: HelicalAngle, handedness: Handedness, phase: f64) -> Self {
        let (sin, cos, eps) = (angle.sin(), angle.cos(), handedness.sign());
        Self { radius, rate: eps * sin / radius, sin, cos, eps, phase }
    }

    /// R/r; 0 of the axis.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// dψ/ds = ε sin θ/R, rad per r.
    #[must_use]
    pub const fn azimuth_rate(&self) -> f64 {
        self.rate
    }

    /// dz/ds = cos θ, greater than 0.
    #[must_use]
    pub const fn rise(&self) -> f64 {
        self.cos
    }

    /// r κ = sin²θ/ρ.
    #[must_use]
    pub fn curvature(&self) -> f64 {
        self.rate.abs() * self.sin
    }

    /// r τ = ε sin θ cos θ/ρ, with the sign of the hand.
    #[must_use]
    pub fn torsion(&self) -> f64 {
        self.rate * self.cos
    }

    /// ψ(s) of (1) and the strand's own turn 2πi/n, rad.
    #[must_use]
    pub fn azimuth(&self, s: f64) -> f64 {
        self.rate * s + self.phase
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

    /// The arclength of the centreline's point nearest to a point in space, and the distance to it.
    ///
    /// With the angle E from the given point round to the nearest one, and M the same to the point at equal height, nearness is
    /// Kepler's equation once more: E + e sin E = M, e = ϱ R (dψ/dz)², where ϱ is the given point's distance from the axis. Its root
    /// between 0 and M is the nearest of all; of two at the same distance, one is given.
    ///
    /// ```
    /// use nply::Handedness::Right;
    /// use nply::geometry::{Centreline, Contact};
    /// let contact = Contact::new(3, 0.6)?;
    /// let [first, second] = [0, 1].map(|strand| Centreline::new(&contact, Right, strand));
    /// let (s, distance) = second.nearest(first.position(5.0));
    /// assert!((distance - 2.0).abs() < 1e-14); // they touch,
    /// assert!((s - 5.0 + contact.arclength_shift() * contact.radius_ratio()).abs() < 1e-12); // xR apart along the strand
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn nearest(&self, point: Vector) -> (f64, f64) {
        let [x, y, z] = point;
        let off_axis = libm::hypot(x, y);
        let level = z / self.cos;
        let phi = libm::atan2(self.eps * x, -self.eps * y);
        let mean = turn_between(self.azimuth(level) - phi);
        let (s, anomaly) = if self.rate == 0.0 {
            (level, mean)
        } else {
            let pitch = self.rate / self.cos;
            let anomaly = foot::anomaly(off_axis * self.radius * pitch * pitch, mean.abs()).copysign(mean);
            (level + (anomaly - mean) / self.rate, anomaly)
        };
        let (across, half) = (off_axis - self.radius, libm::sin(0.5 * anomaly));
        let along = s * self.cos - z;
        (s, libm::sqrt(across * across + 4.0 * off_axis * self.radius * half * half + along * along))
    }

    /// sin ψ and cos ψ.
    fn direction(&self, s: f64) -> [f64; 2] {
        let (sin_psi, cos_psi) = libm::sincos(self.azimuth(s));
        [sin_psi, cos_psi]
    }
}

/// An angle less whole turns, from −π to π.
pub(super) fn turn_between(angle: f64) -> f64 {
    let rest = angle - TAU * libm::floor(angle / TAU + 0.5);
    rest.clamp(-PI, PI)
}
