//! The helical angle, kept so that nothing is lost at either end nor at π/4.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use crate::DomainError;
use crate::numerics::quadrant::sincos;

/// What π/4 and π/2 as doubles leave out.
const FRAC_PI_4_REST: f64 = 3.061_616_997_868_383e-17;
const FRAC_PI_2_REST: f64 = 6.123_233_995_736_766e-17;

/// θ, the angle between the strand's tangent and the ply's axis (lay angle), with its complement, the pitch angle.
///
/// Built from either, so that a ply of nearly straight strands and one of nearly flat rings keep all their digits.
/// θ = 0 up to, not including, π/2.
///
/// ```
/// use nply::geometry::HelicalAngle;
/// let angle = HelicalAngle::new(30_f64.to_radians())?;
/// assert!((angle.sin() - 0.5).abs() < 1e-16);
/// let flat = HelicalAngle::from_pitch_angle(1e-20)?; // rings, almost
/// assert_eq!(flat.cos(), 1e-20);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HelicalAngle {
    helical: f64,
    pitch: f64,
    sin: f64,
    cos: f64,
    /// θ − π/4, from whichever angle was given, so that it is exact near zero
    past_diagonal: f64,
}

impl HelicalAngle {
    /// The least pitch angle whose square is still a number, rad.
    pub(crate) const FLATTEST: f64 = 1e-150;

    /// From θ in rad.
    ///
    /// # Errors
    /// [`DomainError`] unless 0 ≤ θ < π/2.
    #[inline(always)]
    pub fn new(helical_angle: f64) -> Result<Self, DomainError> {
        DomainError::check(
            (0.0..=FRAC_PI_2).contains(&helical_angle), // the double nearest to π/2 lies below π/2
            "helical_angle",
            helical_angle,
            "at least 0 and less than pi/2 (90 degrees)",
        )?;
        Ok(Self::steep(helical_angle))
    }

    /// From the pitch angle π/2 − θ in rad.
    ///
    /// # Errors
    /// [`DomainError`] unless 1e-150 ≤ π/2 − θ ≤ π/2; the square of a smaller angle would no longer be a number.
    #[inline]
    pub fn from_pitch_angle(pitch_angle: f64) -> Result<Self, DomainError> {
        DomainError::check(
            (Self::FLATTEST..=FRAC_PI_2).contains(&pitch_angle),
            "pitch_angle",
            pitch_angle,
            "greater than 0 (at least 1e-150) and at most pi/2 (90 degrees)",
        )?;
        Ok(Self::flat(pitch_angle))
    }

    /// From tan θ = `across`/`along`, both greater than 0, by whichever of the two angles is the smaller.
    pub(crate) fn of_tangent(across: f64, along: f64) -> Self {
        if across < along { Self::steep(libm::atan(across / along)) } else { Self::flat(libm::atan(along / across)) }
    }

    /// From cos θ in (0, 1], by whichever of the two angles is the smaller.
    pub(crate) fn of_cosine(cos: f64) -> Self {
        if cos > core::f64::consts::FRAC_1_SQRT_2 { Self::steep(libm::acos(cos)) } else { Self::flat(libm::asin(cos)) }
    }

    /// From sin θ in [0, 1), by whichever of the two angles is the smaller.
    pub(crate) fn of_sine(sin: f64) -> Self {
        if sin < core::f64::consts::FRAC_1_SQRT_2 { Self::steep(libm::asin(sin)) } else { Self::flat(libm::acos(sin)) }
    }

    /// θ already known to lie in [0, π/2): the strands stand steeply.
    #[inline(always)]
    pub(crate) fn steep(helical: f64) -> Self {
        let (sin, cos) = sincos(helical);
        Self {
            helical,
            pitch: (FRAC_PI_2 - helical) + FRAC_PI_2_REST,
            sin,
            cos,
            past_diagonal: (helical - FRAC_PI_4) - FRAC_PI_4_REST,
        }
    }

    /// π/2 − θ already known to lie in (0, π/2]: the strands lie flat.
    #[inline]
    pub(crate) fn flat(pitch: f64) -> Self {
        let (cos, sin) = sincos(pitch);
        Self {
            helical: (FRAC_PI_2 - pitch) + FRAC_PI_2_REST,
            pitch,
            sin,
            cos,
            past_diagonal: (FRAC_PI_4 - pitch) + FRAC_PI_4_REST,
        }
    }

    /// θ in rad.
    #[must_use]
    pub const fn radians(self) -> f64 {
        self.helical
    }

    /// θ in degrees.
    #[must_use]
    pub fn degrees(self) -> f64 {
        if self.helical <= FRAC_PI_4 { self.helical.to_degrees() } else { 90.0 - self.pitch.to_degrees() }
    }

    /// π/2 − θ in rad.
    #[must_use]
    pub const fn pitch_angle(self) -> f64 {
        self.pitch
    }

    /// sin θ.
    #[must_use]
    pub const fn sin(self) -> f64 {
        self.sin
    }

    /// cos θ, never zero.
    #[must_use]
    pub const fn cos(self) -> f64 {
        self.cos
    }

    /// tan θ.
    #[must_use]
    pub fn tan(self) -> f64 {
        self.sin / self.cos
    }

    /// cos 2θ, to full relative precision near θ = π/4, where it vanishes.
    #[inline]
    #[must_use]
    pub fn cos_double(self) -> f64 {
        -libm::sin(2.0 * self.past_diagonal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever an angle is made from, the smaller of helical and pitch angle has all its digits.
    #[test]
    fn small_angles_keep_their_digits() {
        let near =
            |got: f64, wanted: f64| assert!((got / wanted - 1.0).abs() < 4.0 * f64::EPSILON, "{got}, not {wanted}");
        for power in [20, 30, 40, 50] {
            let small = libm::exp2(-f64::from(power));
            // arccos(1 − x) = √(2x) (1 + x/12 + 3x²/160 + …)
            let arc = (2.0 * small).sqrt() * (1.0 + small / 12.0 + 3.0 * small * small / 160.0);
            near(HelicalAngle::of_cosine(1.0 - small).radians(), arc);
            near(HelicalAngle::of_sine(1.0 - small).pitch_angle(), arc);
        }
        for small in [1e-12, 1e-40, 1e-140] {
            near(HelicalAngle::of_cosine(small).pitch_angle(), small);
            near(HelicalAngle::of_sine(small).radians(), small);
            near(HelicalAngle::of_tangent(small, 1.0).radians(), small);
            near(HelicalAngle::of_tangent(1.0, small).pitch_angle(), small);
        }
    }
}
