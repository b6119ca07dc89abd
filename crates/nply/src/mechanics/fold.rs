//! Folds (limit points): where two states meet and end as one datum changes.

use super::atlas::{Atlas, Condition};
use super::equilibrium::weights;
use super::{Balance, Equilibrium, Load, Ply, Twist};
use crate::geometry::Contact;
use crate::numerics::dual::Dual;
use crate::{DomainError, Handedness};

/// G = 0 and dG/dθ = 0 with the weight number `free` eliminated: Σ wₖ (tₖ′ t − tₖ t′) = 0, t the term of that weight.
#[derive(Clone, Copy, Debug)]
struct Fold {
    balance: Balance,
    free: usize,
}

impl Condition<5> for Fold {
    fn terms(&self, contact: &Contact) -> [Dual; 5] {
        let terms = self.balance.curved_terms(contact);
        let free = terms[self.free];
        terms.map(|term| {
            let value = term.slope * free.value - term.value * free.slope;
            Dual::new(value, term.bend * free.value - term.value * free.bend)
        })
    }
}

impl Ply {
    /// Every fold that the force passes at a given twist and moment: the greatest or least force among neighbouring angles.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite, or under an external pressure.
    ///
    /// ```
    /// use nply::mechanics::{Ply, Twist};
    /// let rope = Ply::new(3, 0.75)?;
    /// for fold in rope.folds_at_moment(Twist::Pretwist(-0.2), 0.1)? {
    ///     // one state more, and one less, on either side of it
    ///     let count = |force| rope.equilibria(fold.twist(), nply::mechanics::Load { force, ..fold.load() }).map(|s| s.len());
    ///     let force = fold.load().force;
    ///     assert_eq!(count(force - 1e-6)?.abs_diff(count(force + 1e-6)?), 2);
    /// }
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn folds_at_moment(&self, twist: Twist, moment: f64) -> Result<Vec<Equilibrium>, DomainError> {
        let find = |contact: Contact, hand| self.force_at(contact.angle(), hand, twist, moment);
        self.folds(twist, Load { force: 0.0, moment }, 3, find)
    }

    /// Every fold that the moment passes at a given twist and force.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite, or under an external pressure.
    ///
    /// ```
    /// use nply::mechanics::{Balance, Ply, Twist};
    /// let folds = Ply::with_balance(3, 0.75, Balance::Radial)?.folds_at_force(Twist::Pretwist(-0.2), 0.0)?;
    /// assert!(folds.iter().all(|fold| fold.is_fold() && fold.balance_slope().abs() < 1e-10));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn folds_at_force(&self, twist: Twist, force: f64) -> Result<Vec<Equilibrium>, DomainError> {
        let find = |contact: Contact, hand| self.moment_at(contact.angle(), hand, twist, force);
        self.folds(twist, Load { force, moment: 0.0 }, 4, find)
    }

    /// Every fold that the pretwist passes under given loads.
    ///
    /// # Errors
    /// [`DomainError`] unless the loads are finite, or under an external pressure.
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply};
    /// let folds = Ply::new(3, 0.75)?.folds_at_loads(Load { force: 0.0, moment: 0.1 })?;
    /// assert!(folds.iter().all(|fold| fold.is_fold() && fold.balance_slope().abs() < 1e-10));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn folds_at_loads(&self, load: Load) -> Result<Vec<Equilibrium>, DomainError> {
        let find = |contact: Contact, hand| self.pretwist_at(contact.angle(), hand, load);
        self.folds(Twist::Pretwist(0.0), load, 2, find)
    }

    fn folds(
        &self,
        twist: Twist,
        load: Load,
        free: usize,
        find: impl Fn(Contact, Handedness) -> Result<Equilibrium, DomainError>,
    ) -> Result<Vec<Equilibrium>, DomainError> {
        self.check(twist, load)?;
        self.check_unpressed()?;
        let condition = Fold { balance: self.balance(), free };
        let mut states = Vec::new();
        Atlas::new(self.strands(), condition).solve(weights(self.stiffness_ratio(), twist, load), |hand, at| {
            // where the free datum does no work it is no fold but a pole
            if let Ok(state) = find(Contact::at(self.strands(), at.angle), hand) {
                states.push(Equilibrium { fold: true, ..state });
            }
        });
        Equilibrium::sort(&mut states);
        Ok(states)
    }
}
