//! Lays at which some quantity of touching strands is greatest.

use core::f64::consts::{FRAC_PI_4, PI};

use super::lay::where_rising;
use super::{Contact, HelicalAngle, Section, check_strands};
use crate::DomainError;

/// The distinguished lays of n touching strands, each where one quantity has its extreme along the main branch.
///
/// With q the arclength shift over the strand diameter, squared, and ρ′ = ρ q cot θ, each extreme is where a quantity that
/// only rises along the branch passes a number, so that each is found once and for sure.
///
/// ```
/// use nply::geometry::SpecialLays;
/// // pitch angles of the zero-twist ropes: 39.4°, 42.8°, 43.8° (Olsen & Bohr, arXiv:1003.5358; EPL 93 (2011) 60004)
/// let pitch = |n| SpecialLays::of(n).map(|lays| lays.zero_twist().pitch_angle().to_degrees());
/// assert!((pitch(2)? - 39.4).abs() < 0.05 && (pitch(3)? - 42.8).abs() < 0.05 && (pitch(4)? - 43.8).abs() < 0.05);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpecialLays {
    strands: u32,
}

impl SpecialLays {
    /// Of n ≥ 2 strands.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`.
    pub fn of(strands: u32) -> Result<Self, DomainError> {
        check_strands(strands)?;
        Ok(Self { strands })
    }

    /// q = 1, the shift is one diameter: the greatest sin θ/ρ. No more turns fit into strands of given length; twisting on
    /// neither winds nor unwinds the ply, the rope maker's *zero-twist* lay.
    #[must_use]
    pub fn zero_twist(&self) -> Contact {
        where_rising(self.strands, 1.0, |at| at.sin * at.sin * at.share * (at.cos * at.cos).recip())
    }

    /// tan²θ = 1 − q: the greatest sin θ cos θ/ρ, a strand's torsion. It is the limit for large pretwist in contact balance.
    ///
    /// ```
    /// use nply::geometry::SpecialLays;
    /// assert!((SpecialLays::of(3)?.most_torsion().angle().degrees() - 37.8756).abs() < 5e-5);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn most_torsion(&self) -> Contact {
        if self.strands == 2 {
            // line contact up to the corner, where q = 0 and tan θ = 1
            return Contact::at(2, HelicalAngle::steep(FRAC_PI_4));
        }
        // tan²θ + q = tan²θ (1 + q cot²θ)
        where_rising(self.strands, 1.0, |at| {
            let tan_squared = at.sin * at.sin * (at.cos * at.cos).recip();
            tan_squared + tan_squared * at.share
        })
    }

    /// q = 2: the greatest sin²θ/ρ, a strand's curvature.
    #[must_use]
    pub fn most_curvature(&self) -> Contact {
        where_rising(self.strands, 2.0, |at| at.sin * at.sin * at.share * (at.cos * at.cos).recip())
    }

    /// tan θ = 2ρ′/(1 + ρ): the densest packing of the tubes in their enclosing cylinder, [`packing_fraction`]. `None`
    /// for n ≥ 6, which pack the denser the straighter they lie.
    ///
    /// ```
    /// use nply::geometry::{SpecialLays, packing_fraction};
    /// let lay = SpecialLays::of(2)?.close_packed().expect("n < 6");
    /// assert!((packing_fraction(&lay) - 0.769).abs() < 5e-4 && SpecialLays::of(6)?.close_packed().is_none());
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn close_packed(&self) -> Option<Contact> {
        // 2ρ′/(1 + ρ) = tan θ · 2ρ (q cot²θ)/(1 + ρ), whose factor rises from 2cos²(π/n)/(1 + sin(π/n)) to 2
        let half = PI / f64::from(self.strands);
        let (sin, cos) = libm::sincos(half);
        let packs_closer_when_laid = 2.0 * cos * cos < (1.0 + sin) * (1.0 - 4.0 * f64::EPSILON);
        packs_closer_when_laid
            .then(|| where_rising(self.strands, 1.0, |at| 2.0 * (at.radius * at.share) * (at.cos + at.radius).recip()))
    }

    /// The cut across the ply turns non-convex, [`Section::non_convex_angle`].
    #[must_use]
    pub fn non_convex_cut(&self) -> Contact {
        Section::turns_hollow(self.strands)
    }

    /// Where line contact ends, for two strands: π/4, the lock-up of a double helix that touches along a line. Others
    /// have none: the corner is rounded off.
    #[must_use]
    pub fn lock_up(&self) -> Option<Contact> {
        (self.strands == 2).then(|| Contact::at(2, HelicalAngle::steep(FRAC_PI_4)))
    }
}

/// Volume of the tubes over that of the cylinder that encloses the ply: n/(cos θ (1 + ρ)²).
///
/// ```
/// use nply::geometry::{Contact, packing_fraction};
/// assert!((packing_fraction(&Contact::new(2, 0.0)?) - 0.5).abs() < 1e-15); // two circles in one
/// # Ok::<(), nply::DomainError>(())
/// ```
#[must_use]
pub fn packing_fraction(contact: &Contact) -> f64 {
    let outer = contact.outer_radius();
    f64::from(contact.strands()) / (contact.angle().cos() * outer * outer)
}
