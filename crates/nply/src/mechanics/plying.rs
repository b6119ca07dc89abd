//! The spinner's two twists: of the strands before plying, and of the ply.

use super::{Balance, Ply};
use crate::DomainError;
use crate::geometry::{Contact, HelicalAngle, SpecialLays};
use crate::numerics::dual::Dual;
use crate::numerics::root::bracketed;

impl Ply {
    #[doc = include_str!("../equations/twist_ratio.md")]
    ///
    /// From the helical angle of a balanced ply; `None` from the angle on that no balanced ply of these strands reaches
    /// ([`steepest_balanced`](Self::steepest_balanced)). Accurate to 1e-14 but next to that angle, where it vanishes.
    ///
    /// ```
    /// use nply::geometry::HelicalAngle;
    /// use nply::mechanics::Ply;
    /// let ratio = |degrees: f64, gamma| Ply::new(2, gamma)?.twist_ratio(HelicalAngle::new(degrees.to_radians())?)
    ///     .ok_or(nply::DomainError { quantity: "helical_angle", value: degrees, allowed: "less than 45 degrees" });
    /// assert!((ratio(30.0, 1.0)? - 2.0 / 3.0).abs() < 1e-15);
    /// assert!((ratio(26.3657, 0.75)? - 2.0 / 3.0).abs() < 1e-6);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn twist_ratio(&self, angle: HelicalAngle) -> Option<f64> {
        let steepest = self.steepest_balanced();
        (angle.radians() < steepest.radians()).then(|| self.ratio(&Contact::at(self.strands(), angle)).value)
    }

    /// The angle at which a balanced ply has a given ratio of ply twist to strand twist.
    ///
    /// # Errors
    /// [`DomainError`] unless the ratio is greater than 0 and less than 1.
    ///
    /// ```
    /// use nply::mechanics::{Balance, Ply};
    /// // two thirds, as spinners say, is one angle for each number of strands
    /// let degrees = |n| Ply::with_balance(n, 1.0, Balance::Radial)?.angle_of_twist_ratio(2.0 / 3.0).map(|angle| angle.degrees());
    /// assert!((degrees(2)? - 30.0).abs() < 1e-12 && (degrees(4)? - 30.0).abs() < 1e-12);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn angle_of_twist_ratio(&self, ratio: f64) -> Result<HelicalAngle, DomainError> {
        DomainError::check(ratio > 0.0 && ratio < 1.0, "twist_ratio", ratio, "greater than 0 and less than 1")?;
        let f = |theta| {
            let here = self.ratio(&Contact::at(self.strands(), HelicalAngle::steep(theta)));
            Dual::new(ratio - here.value, -here.slope)
        };
        let high = self.steepest_balanced().radians();
        Ok(HelicalAngle::steep(bracketed(f, 0.0, high, false, 0.5 * high).0))
    }

    /// The angle that balanced plies approach as their strands are twisted harder, and none passes: 45° in radial balance, that of the
    /// most torsion ([`SpecialLays::most_torsion`]) in contact balance.
    ///
    /// ```
    /// use nply::mechanics::Ply;
    /// assert!((Ply::new(3, 0.75)?.steepest_balanced().degrees() - 37.8756).abs() < 5e-5);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn steepest_balanced(&self) -> HelicalAngle {
        match (self.balance(), SpecialLays::of(self.strands())) {
            (Balance::Contact, Ok(lays)) => lays.most_torsion().angle(),
            _ => HelicalAngle::steep(core::f64::consts::FRAC_PI_4),
        }
    }

    /// The ratio, with its slope.
    fn ratio(&self, contact: &Contact) -> Dual {
        let at = contact.regular();
        let (ss, cc) = (at.sin * at.sin, at.cos * at.cos);
        let q_cc = match self.balance() {
            Balance::Contact => ss * at.share,
            Balance::Radial => 0.0 * ss,
        };
        let twisting = self.stiffness_ratio() * (cc - ss - q_cc);
        twisting * (ss * (2.0 * cc - q_cc) + cc * twisting).recip()
    }
}
