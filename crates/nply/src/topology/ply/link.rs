//! The ledger of link of a ply of any length, (A.28)–(A.32).

use core::f64::consts::TAU;

use super::{Contribution, PlyWrithe, check_strands};
use crate::DomainError;

/// Where the link of a ply is, in turns, all strands together: `link` = `strand_twist` + `closure_twist` + `writhe`.
///
#[doc = include_str!("../../equations/eqA28.md")]
///
/// Per strand length of a long ply, for a state in equilibrium: [`Equilibrium::link`](crate::mechanics::Equilibrium::link). Here at any length,
/// from geometry alone: the writhe is that of the strands at their very length. End sections, insert and closure add what does not grow with the length;
/// [`ClosedPly`](super::ClosedPly) is a curve to ask for it.
///
/// ```
/// use nply::Handedness::Right;
/// use nply::geometry::HelicalAngle;
/// use nply::topology::{PlyLink, PlyWrithe};
/// let angle = HelicalAngle::new(0.5)?;
/// let before = PlyLink::straight(3, -20.0)?; // each strand twisted by φ̄ = −20 rad
/// let after = before.wound(&PlyWrithe::new(3, angle, Right, 4.25)?)?;
/// assert_eq!(after.link, before.link);
/// assert!((after.strand_twist + after.closure_twist + after.writhe.writhe - after.link).abs() < 1e-14);
/// // (A.30), up to what stays bounded
/// let long = after.strand_twist - 3.0 * 4.25 * 0.5_f64.cos();
/// assert!((long + after.writhe.remainder - after.link).abs() < 1e-14 && after.writhe.remainder.abs() < 0.2);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlyLink {
    /// n.
    pub strands: u32,
    /// L_k.
    pub link: f64,
    /// T_w, of all n strands.
    pub strand_twist: f64,
    /// σT_c: that of the closure for odd n, 0 for even n.
    pub closure_twist: f64,
    /// W_r.
    pub writhe: Contribution,
}

impl PlyLink {
    #[doc = include_str!("../../equations/eqA31.md")]
    ///
    /// `end_rotation` is φ̄ in rad.
    ///
    /// # Errors
    /// [`DomainError`] on `strands` if it is 0 or above a million, and on `end_rotation` unless it is finite and not beyond 1e15.
    pub fn straight(strands: u32, end_rotation: f64) -> Result<Self, DomainError> {
        check_strands(strands)?;
        let within = (-1e15..=1e15).contains(&end_rotation);
        DomainError::check(within, "end_rotation", end_rotation, "between -1e15 and 1e15")?;
        let link = f64::from(strands) * end_rotation / TAU;
        let writhe = Contribution { leading: 0.0, remainder: 0.0, error_bound: 0.0, writhe: 0.0 };
        Ok(Self { strands, link, strand_twist: link, closure_twist: 0.0, writhe })
    }

    /// The same link in strands that have wound up into a ply: what writhe and closure take, the strands' twist gives.
    ///
    #[doc = include_str!("../../equations/eqA29.md")]
    ///
    #[doc = include_str!("../../equations/eqA30.md")]
    ///
    /// # Errors
    /// [`DomainError`] on `strands` if the ply has another number of them.
    pub fn wound(&self, ply: &PlyWrithe) -> Result<Self, DomainError> {
        let strands = f64::from(ply.strands());
        DomainError::check(
            ply.strands() == self.strands,
            "strands",
            strands,
            "that of the strands before they wind up",
        )?;
        let closure_twist = if self.strands % 2 == 1 { -ply.handedness().sign() * ply.turns() } else { 0.0 };
        let writhe = ply.total();
        // the leading terms first: for odd n the closure's twist cancels among them
        let grown = -ply.handedness().sign() * strands * ply.turns() * ply.angle().cos();
        let strand_twist = self.link - grown - writhe.remainder;
        Ok(Self { strand_twist, closure_twist, writhe, ..*self })
    }

    #[doc = include_str!("../../equations/eqA32.md")]
    ///
    /// Here at any length: 2πT_w/n, the twist of each strand over its whole length L, in rad: u₃L. It differs from (A.32) times L
    /// by −2π/n times the remainder of the writhe.
    ///
    /// ```
    /// use nply::Handedness::Right;
    /// use nply::geometry::Contact;
    /// use nply::topology::{PlyLink, PlyWrithe};
    /// let (contact, length) = (Contact::new(2, 0.5)?, 1e4);
    /// let twist = PlyLink::straight(2, -3000.0)?.wound(&PlyWrithe::of_ply(&contact, Right, length)?)?.twist_of_a_strand();
    /// assert!((twist / length - (-0.3 + contact.torsion())).abs() < 1e-4);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn twist_of_a_strand(&self) -> f64 {
        TAU * self.strand_twist / f64::from(self.strands)
    }
}
