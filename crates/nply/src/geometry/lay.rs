//! The contact that a given lay, or a given radius, asks for.

use core::f64::consts::{FRAC_PI_4, PI};

use super::contact::{Regular, check_strands};
use super::{Contact, HelicalAngle};
use crate::DomainError;
use crate::numerics::dual::Dual;
use crate::numerics::root::bracketed;

impl Contact {
    /// From the radius ratio ρ = R/r, such as a core of radius (ρ − 1)r sets.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, and on `radius_ratio` unless it is finite and at least 1/sin(π/n), that of straight
    /// strands; for two strands unless it is above 1, which every angle up to π/4 has.
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
        } else {
            let allowed = "finite and at least 1/sin(pi/n), the radius ratio of straight strands that touch";
            let reached = radius_ratio >= least * (1.0 - 4.0 * f64::EPSILON); // 1/sin(π/n) is itself rounded
            DomainError::check(reached && finite, "radius_ratio", radius_ratio, allowed)?;
            if radius_ratio <= least {
                return Ok(straight);
            }
        }
        Ok(where_rising(strands, radius_ratio, |at| at.radius * at.cos.recip()))
    }

    /// From the lay length in units of r: ply length per turn of a strand.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, and on `lay_length` unless it is finite and greater than 2n, that of n flat rings on
    /// top of each other.
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
            lay_length > 2.0 * f64::from(strands) && lay_length < f64::INFINITY,
            "lay_length",
            lay_length,
            "finite and greater than 2n strand radii, where the strands are flat rings on top of each other",
        )?;
        // 2π over the lay length: tan θ/ρ
        Ok(where_rising(strands, 2.0 * PI / lay_length, |at| at.sin * at.radius.recip()))
    }

    /// From the lay ratio: lay length over the ply's outer diameter 2(R + r).
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, and on `lay_ratio` unless it is finite and greater than 0.
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
        // π over the lay ratio: tan θ (1 + ρ)/ρ
        Ok(where_rising(strands, PI / lay_ratio, |at| at.sin * (at.cos.recip() + at.radius.recip())))
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
        HelicalAngle::flat(bracketed(f, 0.0, FRAC_PI_4, false, 0.5).0)
    } else {
        let f = |t| {
            let here = on(HelicalAngle::steep(t));
            Dual::new(here.value - value, here.slope)
        };
        HelicalAngle::steep(bracketed(f, 0.0, FRAC_PI_4, false, 0.5).0)
    };
    Contact::at(strands, angle)
}
