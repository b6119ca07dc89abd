//! The contact that a given lay, or a given radius, asks for.

use core::f64::consts::{FRAC_PI_4, PI};

use super::contact::{Regular, check_strands};
use super::{Contact, HelicalAngle, SpecialLays};
use crate::DomainError;
use crate::numerics::dual::Dual;
use crate::numerics::root::bracketed;

impl Contact {
    /// From the radius ratio ρ = R/r, such as a core of radius (ρ − 1)r sets.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, and on `radius_ratio` unless it is at least 1/sin(π/n), that of straight strands, and
    /// at most 1e140; for two strands unless it is above 1, which every angle up to π/4 has.
    ///
    /// ```
    /// use nply::geometry::Contact;
    /// let cored = Contact::from_radius_ratio(6, 2.1)?; // Figure 11
    /// assert!((cored.angle().degrees() - 20.0).abs() < 0.05);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn from_radius_ratio(strands: u32, radius_ratio: f64) -> Result<Self, DomainError> {
        check_strands(strands)?;
        let straight = Self::at(strands, HelicalAngle::steep(0.0));
        let least = straight.radius_ratio();
        let finite = radius_ratio < f64::INFINITY;
        if strands == 2 {
            let allowed = "finite and greater than 1 for two strands: at 1 they touch along a line at every angle up to \
                           pi/4, so that the radius does not tell the angle";
            DomainError::check(radius_ratio > 1.0 && finite, "radius_ratio", radius_ratio, allowed)?;
            Self::check_flattest(radius_ratio, "radius_ratio", radius_ratio)?;
            if radius_ratio < 1.1 {
                return Ok(Self::from_hole(radius_ratio - 1.0));
            }
        } else {
            let allowed = "finite and at least 1/sin(pi/n), the radius ratio of straight strands that touch";
            let reached = radius_ratio >= least * (1.0 - 4.0 * f64::EPSILON); // 1/sin(π/n) is itself rounded
            DomainError::check(reached && finite, "radius_ratio", radius_ratio, allowed)?;
            Self::check_flattest(radius_ratio, "radius_ratio", radius_ratio)?;
            if radius_ratio <= least {
                return Ok(straight);
            }
        }
        Ok(where_rising(strands, radius_ratio, |at| at.radius * at.cos.recip()))
    }

    /// From the lay length in units of r: ply length per turn of a strand.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, and on `lay_length` unless it is greater than 2n (by 64 units in the last place), that of n flat
    /// rings on top of each other, and at most 1e140.
    ///
    /// ```
    /// use nply::geometry::Contact;
    /// let rope = Contact::from_lay_length(3, 20.0)?;
    /// assert!((rope.lay_length() - 20.0).abs() < 1e-13);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn from_lay_length(strands: u32, lay_length: f64) -> Result<Self, DomainError> {
        check_strands(strands)?;
        DomainError::check(
            // nearer than some units in the last place the pitch angle, which grows as the root of the rest, is lost
            lay_length > 2.0 * f64::from(strands) * (1.0 + 64.0 * f64::EPSILON) && lay_length < f64::INFINITY,
            "lay_length",
            lay_length,
            "finite and greater (by more than rounding) than 2n strand radii, where the strands are flat rings on top of each other",
        )?;
        Self::check_flattest(lay_length, "lay_length", lay_length)?;
        // 2π over the lay length: tan θ/ρ
        Ok(where_rising(strands, 2.0 * PI / lay_length, |at| at.sin * at.radius.recip()))
    }

    /// Refuses what would be too far from 1 for its square to be a number.
    fn check_flattest(size: f64, quantity: &'static str, value: f64) -> Result<(), DomainError> {
        DomainError::check(
            (1e-140..=1e140).contains(&size),
            quantity,
            value,
            "within 140 orders of magnitude of the strand's size",
        )
    }

    /// Two strands past the pitchfork, from the radius of the hole between them, of which ρ near 1 keeps no digits.
    fn from_hole(hole: f64) -> Self {
        let at = |pitch| Self::at(2, HelicalAngle::flat(pitch));
        let f = |pitch| {
            let contact = at(pitch);
            Dual::new(contact.hole_radius() - hole, -contact.radius_ratio_slope())
        };
        at(bracketed(f, 0.5, FRAC_PI_4, true, 0.78).0) // 0.5 rad of pitch has ρ = 1.38
    }

    /// From the lay ratio: lay length over the ply's outer diameter 2(R + r).
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, and on `lay_ratio` unless it is between 1e-140 and 1e140.
    ///
    /// ```
    /// use nply::geometry::Contact;
    /// let rope = Contact::from_lay_ratio(6, 7.0)?;
    /// assert!((rope.lay_ratio() - 7.0).abs() < 1e-13);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn from_lay_ratio(strands: u32, lay_ratio: f64) -> Result<Self, DomainError> {
        check_strands(strands)?;
        let positive = lay_ratio > 0.0 && lay_ratio < f64::INFINITY;
        DomainError::check(positive, "lay_ratio", lay_ratio, "finite and greater than 0")?;
        Self::check_flattest(lay_ratio, "lay_ratio", lay_ratio)?;
        // π over the lay ratio: tan θ (1 + ρ)/ρ
        Ok(where_rising(strands, PI / lay_ratio, |at| at.sin * (at.cos.recip() + at.radius.recip())))
    }
}

impl Contact {
    /// The two contacts with a given rotation of the ply's end, sin θ/ρ: rad per strand length, times r. One lies at or below the
    /// angle of the most turns (q = 1), the other at or above it.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, and on `rotation` unless it is between 1e-140 and the most turns that the strands can take.
    ///
    /// ```
    /// use nply::geometry::Contact;
    /// let [low, high] = Contact::from_rotation(3, 0.4)?;
    /// assert!(low.angle().degrees() < 47.2 && high.angle().degrees() > 47.2); // most turns: 47.2°
    /// assert!((low.angle().sin() / low.radius_ratio() - 0.4).abs() < 1e-15);
    /// assert!(Contact::from_rotation(3, 0.6).is_err());
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn from_rotation(strands: u32, rotation: f64) -> Result<[Self; 2], DomainError> {
        let most = SpecialLays::of(strands)?.zero_twist();
        let limit = most.angle().sin() / most.radius_ratio();
        let allowed = "greater than 0 (at least 1e-140) and not more than the most turns that the strands can take";
        DomainError::check((1e-140..=limit).contains(&rotation), "rotation", rotation, allowed)?;
        let on = |angle| {
            let here = Self::at(strands, angle).curved().rotation();
            Dual::new(here.value - rotation, here.slope)
        };
        let below = bracketed(|t| on(HelicalAngle::steep(t)), 0.0, most.helical_angle(), false, rotation).0;
        let f = |t| {
            let here = on(HelicalAngle::flat(t));
            Dual::new(here.value, -here.slope)
        };
        let above = bracketed(f, HelicalAngle::FLATTEST, most.pitch_angle(), false, 0.5).0;
        Ok([Self::at(strands, HelicalAngle::steep(below)), Self::at(strands, HelicalAngle::flat(above))])
    }
}

/// The contact at which a quantity that rises along the whole branch, without bound or not, takes a value it does take.
pub(super) fn where_rising(strands: u32, value: f64, quantity: impl Fn(&Regular) -> Dual) -> Contact {
    let on = |angle| quantity(&Contact::at(strands, angle).regular());
    let flat = on(HelicalAngle::steep(FRAC_PI_4)).value < value;
    let angle = if flat {
        // by the pitch angle, and by the reciprocals, which stay finite
        let f = |t| {
            let inverse = on(HelicalAngle::flat(t)).recip();
            Dual::new(inverse.value - 1.0 / value, -inverse.slope)
        };
        HelicalAngle::flat(bracketed(f, HelicalAngle::FLATTEST, FRAC_PI_4, false, 0.5).0)
    } else {
        let f = |t| {
            let here = on(HelicalAngle::steep(t));
            Dual::new(here.value - value, here.slope)
        };
        HelicalAngle::steep(bracketed(f, 0.0, FRAC_PI_4, false, 0.5).0)
    };
    Contact::at(strands, angle)
}
