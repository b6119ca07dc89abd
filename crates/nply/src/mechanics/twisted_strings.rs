//! Limp strings wound up by a motor under a dead force.

use core::f64::consts::PI;

use crate::DomainError;
use crate::geometry::{Contact, HelicalAngle, SpecialLays, check_strands};

#[doc = include_str!("../equations/twisted_strings.md")]
///
/// Strings that start parallel and touching and are turned from there: the side of the branch up to the most turns. Lengths are in
/// units of r, forces in units of the end force F > 0. Contact is that of [`Contact`], accurate as there; near the most turns the
/// angle is known to the root of that accuracy, as a maximum is.
///
/// ```
/// use nply::mechanics::TwistedStrings;
/// let pair = TwistedStrings::new(2, 0.5)?; // half a radian per string radius of string length
/// assert!((pair.extension() - 0.75_f64.sqrt()).abs() < 1e-15); // p = √(L² − θ²r²)
/// assert!((pair.lever() - 0.5 / 0.75_f64.sqrt()).abs() < 1e-15); // torque/force = θ r²/p
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwistedStrings {
    contact: Contact,
    rotation: f64,
}

impl TwistedStrings {
    /// From n ≥ 2 and the rotation Y of one end against the other, of either hand's size: rad per string length, times r; 0 for parallel
    /// strings.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, and on `rotation` unless it is 0, or from 1e-140 to [`most_turns`](Self::most_turns).
    pub fn new(strands: u32, rotation: f64) -> Result<Self, DomainError> {
        let contact = if rotation == 0.0 {
            Contact::at_angle(strands, HelicalAngle::steep(0.0))?
        } else {
            Contact::from_rotation(strands, rotation)?[0]
        };
        Ok(Self { contact, rotation })
    }

    /// At the angle where something that grows with the turns takes a value: a stroke, a torque, a tension; `None` where it does not up to
    /// the [`most_turns`](Self::most_turns).
    ///
    /// # Errors
    /// [`DomainError`] on `strands`.
    ///
    /// ```
    /// use nply::mechanics::TwistedStrings;
    /// let pair = TwistedStrings::reaching(2, |strings| strings.contraction(), 0.2)?.ok_or("not reached")?;
    /// assert!((pair.extension() - 0.8).abs() < 1e-14 && (pair.rotation() - 0.6).abs() < 1e-14); // √(1 − 0.8²)
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn reaching(strands: u32, of: impl Fn(&Self) -> f64, value: f64) -> Result<Option<Self>, DomainError> {
        let most = Self::most_turns(strands)?;
        let at = |radians: f64| {
            let contact = Contact::at_angle(strands, HelicalAngle::new(radians)?)?;
            Ok::<_, DomainError>(Self { contact, rotation: contact.angle().sin() / contact.radius_ratio() })
        };
        let (mut low, mut high) = (0.0, most.contact().helical_angle());
        if !(of(&Self::new(strands, 0.0)?) <= value && value <= of(&most)) {
            return Ok(None);
        }
        loop {
            let middle = 0.5 * (low + high);
            if !(low < middle && middle < high) {
                return at(high).map(Some);
            }
            if of(&at(middle)?) < value { low = middle } else { high = middle }
        }
    }

    /// As far as they can be turned: the greatest sin θ/ρ (q = 1), where the moment is without bound.
    ///
    /// ```
    /// use nply::mechanics::TwistedStrings;
    /// assert!((TwistedStrings::most_turns(2)?.contact().angle().degrees() - 50.6229).abs() < 5e-5);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    ///
    /// # Errors
    /// [`DomainError`] on `strands`.
    pub fn most_turns(strands: u32) -> Result<Self, DomainError> {
        let contact = SpecialLays::of(strands)?.zero_twist();
        Ok(Self { contact, rotation: contact.angle().sin() / contact.radius_ratio() })
    }

    /// How the strings touch.
    #[must_use]
    pub const fn contact(&self) -> &Contact {
        &self.contact
    }

    /// Y = sin θ/ρ: rad per string length, times r.
    #[must_use]
    pub const fn rotation(&self) -> f64 {
        self.rotation
    }

    /// Length between the ends over string length, cos θ.
    #[must_use]
    pub const fn extension(&self) -> f64 {
        self.contact.angle().cos()
    }

    /// Stroke over string length, 1 − cos θ, with all its digits for few turns.
    #[must_use]
    pub fn contraction(&self) -> f64 {
        let half = libm::sin(0.5 * self.contact.helical_angle());
        2.0 * half * half
    }

    /// M/(F r) = ρ tan θ/(1 − q): torque over force, and stroke over motor angle; both in r. Infinite at the most turns.
    #[must_use]
    pub fn lever(&self) -> f64 {
        let rest = 1.0 - self.contact.shift_ratio_squared();
        // at the most turns rounding could leave either sign
        if rest > 1e-12 { self.contact.radius_ratio() * self.contact.angle().tan() / rest } else { f64::INFINITY }
    }

    /// T/F: the tension in each string over the end force, by virtual work on its length. Infinite at the most turns.
    #[must_use]
    pub fn string_tension(&self) -> f64 {
        let turning = if self.rotation > 0.0 { self.rotation * self.lever() } else { 0.0 };
        (self.extension() + turning) / f64::from(self.contact.strands())
    }
}

/// The same strings by the formula in use: the helix keeps the radius R of parallel strings, so that a string is the hypotenuse of a
/// triangle of the sides p and θ_m R.
///
/// Source: Würtz et al., *The twisted string actuation system: modeling and control*, IEEE/ASME AIM 2010, for two strings (R = r). For
/// two strings it is exact up to 45°; for more it leaves out that the ply grows thicker as it is turned.
///
/// ```
/// use nply::mechanics::ConstantRadius;
/// let pair = ConstantRadius::new(2)?;
/// assert!((pair.steepest().degrees() - 57.52).abs() < 5e-3); // tan α = π/2; the strings jam at 50.62° before
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantRadius {
    strands: u32,
    /// R/r
    radius: f64,
}

impl ConstantRadius {
    /// Of n ≥ 2 strings: R = r/sin(π/n).
    ///
    /// # Errors
    /// [`DomainError`] on `strands`.
    pub fn new(strands: u32) -> Result<Self, DomainError> {
        check_strands(strands)?;
        Ok(Self { strands, radius: Contact::at(strands, HelicalAngle::steep(0.0)).radius_ratio() })
    }

    /// p/L = √(1 − (R Y)²) of a rotation Y ≥ 0; `None` where there is no such triangle.
    #[must_use]
    pub fn extension(&self, rotation: f64) -> Option<f64> {
        let sin = self.radius * rotation;
        (0.0..=1.0).contains(&sin).then(|| libm::sqrt((1.0 - sin) * (1.0 + sin)))
    }

    /// M/(F r) = R² Y/(p/L); `None` as above.
    #[must_use]
    pub fn lever(&self, rotation: f64) -> Option<f64> {
        self.extension(rotation).map(|extension| self.radius * self.radius * rotation / extension)
    }

    /// The angle at which the formula lets the turns of a string lie on each other, a pitch of n diameters: tan α = πR/(n r).
    #[must_use]
    pub fn steepest(&self) -> HelicalAngle {
        HelicalAngle::steep(libm::atan(PI * self.radius / f64::from(self.strands)))
    }

    /// The rotation that goes with it, sin α/R.
    #[must_use]
    pub fn most_turns(&self) -> f64 {
        self.steepest().sin() / self.radius
    }
}
