//! Every state in which all closed contacts push.

use super::{Place, Support, SupportedState, check_core, core_contact, free};
use crate::geometry::{Contact, HelicalAngle};
use crate::mechanics::atlas::{Atlas, Condition};
use crate::mechanics::equilibrium::weights;
use crate::mechanics::potential::Potential;
use crate::mechanics::{Balance, Ends, Equilibrium, Load, Ply, Twist};
use crate::numerics::dual::Dual;
use crate::{DomainError, Handedness};

/// Radial balance at a fixed ρ, (40): the weights as in contact.
#[derive(Clone, Copy, Debug)]
struct AtRadius(f64);

impl Condition<5> for AtRadius {
    fn terms(&self, contact: &Contact) -> [Dual; 5] {
        let rho = self.0;
        let n = f64::from(contact.strands());
        let (sin, cos) = (contact.angle().sin(), contact.angle().cos());
        let (s, c) = (Dual::new(sin, cos), Dual::new(cos, -sin));
        let cos2 = c * c - s * s;
        [2.0 * n * (s * s * s * c), n * (s * c * cos2), n * rho * cos2, rho * rho * s, -(rho * c)]
    }
}

impl Ply {
    /// Every state in which all closed contacts push: touching neighbours, on the core, on both, or free, each hand.
    ///
    /// `ends` are the loads, or how the ends are [held](Ends) otherwise; `core_radius` in units of r, `None` without a core.
    /// Right-handed states first, then by angle. The ply's own balance is of no account: where only neighbours touch it is
    /// contact balance, where only the core carries it is radial. Where a displacement is held and neighbours touch on the
    /// core too, the one rotation, or length, that this fixes is left out.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite, the displacement can be that of a ply, the core's radius is greater than
    /// 0 and no external pressure acts.
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Support, Twist};
    /// // the 6-ply of Figure 11 on a core of radius 1.1: it keeps the angle the core fixes while both contacts push
    /// let rope = Ply::new(6, 0.75)?;
    /// let load = Load { force: 8.7, moment: 7.1 };
    /// let states = rope.supported_states(Twist::Pretwist(-0.2), load, Some(1.1))?;
    /// let both = states.iter().find(|s| s.support() == Support::Both).expect("inside the wedge");
    /// assert!((both.angle().degrees() - 20.0).abs() < 0.05 && both.core_pressure() > 0.0);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn supported_states(
        &self,
        twist: Twist,
        ends: impl Into<Ends>,
        core_radius: Option<f64>,
    ) -> Result<Vec<SupportedState>, DomainError> {
        let ends = ends.into();
        self.check(twist, ends.given())?;
        ends.check()?;
        self.check_unpressed()?;
        let on_core = core_radius.map(check_core).transpose()?;
        let search = Search { ply: self, twist, on_core };
        let mut states = Vec::new();
        search.touching(ends, &mut states)?;
        if let Some(rho) = on_core {
            search.on_core(ends, rho, &mut states);
            search.on_both(ends, rho, &mut states);
        }
        search.free(ends, &mut states);
        states.sort_by(SupportedState::in_order);
        Ok(states)
    }

    /// Every touching state with the ends held in a given way, of both hands where the rotation does not say which: as
    /// [`equilibria`](Self::equilibria), with the other of load and displacement known.
    ///
    /// A rotation has two angles, below and above that of the most turns; a length has one of each hand.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite; on `rotation` beyond the most turns the strands can take; on `extension`
    /// unless between 0 and 1.
    ///
    /// ```
    /// use nply::mechanics::{Ends, Ply, Twist};
    /// let yarn = Ply::new(3, 0.75)?;
    /// let states = yarn.equilibria_held(Twist::Pretwist(-0.5), Ends::Rotation { rotation: 0.3, force: 0.0 })?;
    /// assert!(states.len() == 2 && states.iter().all(|s| (s.rotation() - 0.3).abs() < 1e-15));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn equilibria_held(&self, twist: Twist, ends: impl Into<Ends>) -> Result<Vec<Equilibrium>, DomainError> {
        let ends = ends.into();
        self.check(twist, ends.given())?;
        ends.check()?;
        match ends {
            Ends::Loads(load) => self.equilibria(twist, load),
            Ends::Rotation { rotation, force } => {
                let hand = Handedness::of_sign(rotation);
                let contacts = Contact::from_rotation(self.strands(), rotation.abs())?;
                contacts.iter().map(|contact| self.moment_at(contact.angle(), hand, twist, force)).collect()
            }
            Ends::Length { extension, moment } => {
                let angle = HelicalAngle::of_cosine(extension);
                Handedness::BOTH.into_iter().map(|hand| self.force_at(angle, hand, twist, moment)).collect()
            }
        }
    }
}

/// What stays the same for all supports.
struct Search<'p> {
    ply: &'p Ply,
    twist: Twist,
    on_core: Option<f64>,
}

impl Search<'_> {
    /// The state at a place, if its contacts push and no other obstacle is in the way.
    fn keep(
        &self,
        support: Support,
        handedness: Handedness,
        angle: HelicalAngle,
        radius_ratio: f64,
        load: Load,
        states: &mut Vec<SupportedState>,
    ) {
        let (strands, gamma) = (self.ply.strands(), self.ply.stiffness_ratio());
        let place = Place { strands, handedness, angle, radius_ratio, on_core: self.on_core };
        let state = SupportedState::new(support, place, gamma, self.twist, load);
        let clear = match support {
            Support::Neighbours => self.on_core.is_none_or(|least| radius_ratio >= least),
            Support::Core => radius_ratio > state.touching.radius_ratio(),
            Support::Both => true,
            Support::Free => {
                radius_ratio >= state.touching.radius_ratio() && self.on_core.is_none_or(|least| radius_ratio >= least)
            }
        };
        if clear && state.interstrand_pressure >= 0.0 && state.core_pressure >= 0.0 {
            states.push(state);
        }
    }

    /// Neighbours touch and push; the core, if any, is loose.
    fn touching(&self, ends: Ends, states: &mut Vec<SupportedState>) -> Result<(), DomainError> {
        let ply = Ply::with_balance(self.ply.strands(), self.ply.stiffness_ratio(), Balance::Contact)?;
        let mut keep = |state: Equilibrium| {
            if !state.is_separated() {
                let contact = state.contact();
                let (hand, rho) = (state.handedness(), contact.radius_ratio());
                self.keep(Support::Neighbours, hand, contact.angle(), rho, state.load(), states);
            }
        };
        match ends {
            Ends::Loads(load) => ply.each_equilibrium(self.twist, load, keep),
            // more turns than touching strands take is no such state; what else is refused is refused here too
            held => {
                // data were checked: what is refused still is more turns than touching strands take, or the very most, at which no moment
                // is large enough
                ply.equilibria_held(self.twist, held).unwrap_or_default().into_iter().for_each(&mut keep);
                Ok(())
            }
        }
    }

    /// Strands on the core, apart from each other.
    fn on_core(&self, ends: Ends, rho: f64, states: &mut Vec<SupportedState>) {
        let gamma = self.ply.stiffness_ratio();
        // at given θ on the core ∂E/∂θ = 0, εE_Θ + εE_Y cos θ/ρ, tells the load that holds it there
        let missing = |ends: Ends, hand: Handedness, angle: HelicalAngle| {
            let load = ends.given();
            let at = Potential::new(self.ply.strands(), gamma, self.twist, load).on(hand, angle, rho);
            let turning = at.by_angle + at.by_rotation * angle.cos() / rho;
            let n = f64::from(self.ply.strands());
            match ends {
                Ends::Length { .. } => Load { force: -n * turning / (hand.sign() * angle.sin()), ..load },
                _ => Load { moment: n * turning * rho / angle.cos(), ..load },
            }
        };
        match ends {
            Ends::Loads(load) => {
                let weights = weights(gamma, self.twist, load);
                Atlas::new(self.ply.strands(), AtRadius(rho)).solve(weights, |handedness, at| {
                    self.keep(Support::Core, handedness, at.angle, rho, load, states);
                });
            }
            Ends::Rotation { rotation, .. } => {
                let (hand, sin) = (Handedness::of_sign(rotation), rotation.abs() * rho);
                if sin < 1.0 {
                    let angle = HelicalAngle::of_sine(sin);
                    self.keep(Support::Core, hand, angle, rho, missing(ends, hand, angle), states);
                }
            }
            Ends::Length { extension, .. } => {
                let angle = HelicalAngle::of_cosine(extension);
                for hand in Handedness::BOTH {
                    self.keep(Support::Core, hand, angle, rho, missing(ends, hand, angle), states);
                }
            }
        }
    }

    /// Strands on the core that touch each other too, under dead loads.
    fn on_both(&self, ends: Ends, rho: f64, states: &mut Vec<SupportedState>) {
        let Ends::Loads(load) = ends else { return };
        let Some(contact) = core_contact(self.ply.strands(), rho) else { return };
        for hand in Handedness::BOTH {
            self.keep(Support::Both, hand, contact.angle(), rho, load, states);
        }
    }

    /// Free helices.
    fn free(&self, ends: Ends, states: &mut Vec<SupportedState>) {
        free::helices(self.ply, self.twist, ends, |helix| {
            let rho = helix.angle.sin() / helix.rotation;
            if rho < f64::INFINITY {
                self.keep(Support::Free, helix.handedness, helix.angle, rho, helix.load, states);
            }
        });
    }
}
