//! One point of the curve whose inverse a row is: the datum that holds a given angle.

use super::{Along, Row};
use crate::geometry::Contact;
use crate::mechanics::{Equilibrium, Load, Ply, Twist};
use crate::{DomainError, Handedness};

impl Ply {
    /// The value of one datum, all others held, that keeps touching strands in equilibrium in a given shape, and the state it makes:
    /// x(θ) = −A/B, the function that [`each_equilibrium_along`](Self::each_equilibrium_along) inverts. Over all angles it runs through
    /// every state, over folds too.
    ///
    /// What this ply, `twist` and `load` say of that datum is ignored: along a pretwist or strand twist that is all of `twist`. The value
    /// keeps some 13 digits, less where it is greater than a million.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite; on `strands` if the contact is between others than this ply has; on `helical_angle`
    /// where the datum does nothing to the balance, as at its poles; and on `stiffness_ratio` where that would have to be 0 or less.
    ///
    /// ```
    /// use nply::Handedness::Right;
    /// use nply::geometry::Contact;
    /// use nply::mechanics::{Along, Load, Ply, Twist};
    /// // a strand twist that balances three strands at 30°
    /// let ply = Ply::new(3, 0.75)?;
    /// let contact = Contact::new(3, 30_f64.to_radians())?;
    /// let (twist, _) = ply.equilibrium_along(Along::StrandTwist, contact, Right, Twist::Pretwist(0.0), Load::NONE)?;
    /// let states = ply.equilibria(Twist::StrandTwist(twist), Load::NONE)?;
    /// assert!(states.iter().any(|state| (state.contact().angle().degrees() - 30.0).abs() < 1e-11));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn equilibrium_along(
        &self,
        along: Along,
        contact: Contact,
        handedness: Handedness,
        twist: Twist,
        load: Load,
    ) -> Result<(f64, Equilibrium), DomainError> {
        let same = contact.strands() == self.strands();
        DomainError::check(same, "strands", f64::from(contact.strands()), "that of the ply")?;
        let row = Row::new(self, along, twist, load);
        self.check(row.twist, row.load)?;
        // the balance is linear in the datum: two of its values are the line
        let at = |x: f64| row.state(x, contact, false, handedness).scaled_balance().value;
        let (a, a_and_b) = (at(0.0), at(1.0));
        let b = a_and_b - a;
        DomainError::check(
            b.abs() > 4.0 * f64::EPSILON * (a.abs() + a_and_b.abs()),
            "helical_angle",
            contact.helical_angle(),
            "an angle at which the datum matters: not one it only reaches at infinity",
        )?;
        let x = -a / b;
        let allowed = "finite, and greater than 0 if it is the stiffness ratio";
        DomainError::check(x.is_finite() && (along != Along::StiffnessRatio || x > 0.0), along.name(), x, allowed)?;
        Ok((x, row.state(x, contact, false, handedness)))
    }
}
