//! n = 1: the densest packing of a single helical tube, (8).

use core::f64::consts::PI;

use super::HelicalAngle;
use crate::numerics::dual::Dual;
use crate::numerics::root::bracketed;

/// The helical tube that touches its own next turn and is curved as sharply as a tube can be, both at once.
///
/// ```
/// use nply::geometry::DensestHelix;
/// let helix = DensestHelix::new();
/// assert!((helix.helical_angle() - 1.190458).abs() < 5e-7);
/// assert!((helix.arclength_shift() - 5.685134).abs() < 5e-7);
/// assert!((helix.radius_ratio() - 0.862185).abs() < 5e-7);
/// assert!((helix.pitch() / helix.radius_ratio() - 2.512).abs() < 5e-4); // Maritan et al., Nature 406 (2000) 287
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DensestHelix {
    angle: HelicalAngle,
    anomaly: f64,
}

impl DensestHelix {
    #[doc = include_str!("../equations/eq08.md")]
    #[must_use]
    pub fn new() -> Self {
        // explicit in E: tan²θ = (2π − E)/sin E by (5), 1/ρ² = sin²(E/2) + (2π − E) sin E/4 by (4), ρ = sin²θ
        let excess = |t: f64| {
            let (sin, cos) = libm::sincos(t);
            let rest = 2.0 * PI - t;
            let sin_squared = Dual::new(rest, -1.0) * Dual::new(sin + rest, cos - 1.0).recip();
            let inverse_square = Dual::new(0.5 * (1.0 - cos) + 0.25 * rest * sin, 0.25 * (sin + rest * cos));
            sin_squared * sin_squared * inverse_square - Dual::new(1.0, 0.0)
        };
        // at E = 0 the tube is a flat ring with ρ unbounded, at E = 2 it is sharper than a tube can be
        let (anomaly, _) = bracketed(excess, 0.0, 2.0, false, 1.0);
        let tan = libm::sqrt((2.0 * PI - anomaly) / libm::sin(anomaly));
        Self { angle: HelicalAngle::flat(libm::atan(1.0 / tan)), anomaly }
    }

    /// θ with its complement.
    #[must_use]
    pub const fn angle(&self) -> HelicalAngle {
        self.angle
    }

    /// θ in rad.
    #[must_use]
    pub const fn helical_angle(&self) -> f64 {
        self.angle.radians()
    }

    /// x: arclength between touching sections over R.
    #[must_use]
    pub fn arclength_shift(&self) -> f64 {
        (2.0 * PI - self.anomaly) / self.angle.sin()
    }

    /// ρ = R/r = sin²θ.
    #[must_use]
    pub fn radius_ratio(&self) -> f64 {
        self.angle.sin() * self.angle.sin()
    }

    /// Axial distance between turns, in units of r.
    #[must_use]
    pub fn pitch(&self) -> f64 {
        2.0 * PI * self.angle.sin() * self.angle.cos()
    }
}

impl Default for DensestHelix {
    fn default() -> Self {
        Self::new()
    }
}
