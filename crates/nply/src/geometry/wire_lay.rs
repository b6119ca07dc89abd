//! How the wires of a layer are laid: by lay length, lay ratio or lay angle.

use core::f64::consts::{FRAC_PI_2, TAU};

use super::HelicalAngle;
use crate::DomainError;

/// The lay of a layer of wires, in one of the ways in which it is measured.
///
/// ```
/// use nply::geometry::WireLay;
/// // lay radius 3, wire radius 1: an outer diameter of 8
/// assert_eq!(WireLay::Ratio(10.0).length(3.0, 1.0)?, 80.0);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WireLay {
    /// P, the strand's length per turn of a wire; in the unit of the wires.
    Length(f64),
    /// P over the outer diameter 2(R + r) of the layer (EN 50182, IEC 61089).
    Ratio(f64),
    /// θ, of the wires' centrelines to the strand's axis, rad; between 0 and π/2.
    Angle(f64),
}

impl WireLay {
    /// P of wires of radius r on a lay radius R.
    ///
    /// # Errors
    /// [`DomainError`] unless the lay is finite and greater than 0, an angle less than π/2, and the length a number.
    pub fn length(self, lay_radius: f64, wire_radius: f64) -> Result<f64, DomainError> {
        let outer = 2.0 * (lay_radius + wire_radius);
        let length = match self.checked()? {
            Self::Length(length) => length,
            Self::Ratio(ratio) => ratio * outer,
            Self::Angle(theta) => {
                let angle = HelicalAngle::new(theta)?;
                TAU * lay_radius * angle.cos() / angle.sin()
            }
        };
        DomainError::check(length > 0.0 && length < f64::INFINITY, "lay_length", length, POSITIVE)?;
        Ok(length)
    }

    /// Itself, if it is one.
    pub(super) fn checked(self) -> Result<Self, DomainError> {
        let (name, value, most, allowed) = match self {
            Self::Length(length) => ("lay_length", length, f64::INFINITY, POSITIVE),
            Self::Ratio(ratio) => ("lay_ratio", ratio, f64::INFINITY, POSITIVE),
            Self::Angle(theta) => {
                ("lay_angle", theta, FRAC_PI_2, "greater than 0 (straight wires have no lay) and less than pi/2")
            }
        };
        DomainError::check(value > 0.0 && value < most, name, value, allowed)?;
        Ok(self)
    }
}

pub(super) const POSITIVE: &str = "finite and greater than 0";
