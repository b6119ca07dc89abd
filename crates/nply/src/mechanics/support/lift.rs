//! Where strands lift off their core: p_c = 0 on a core that neighbours do not share.

use super::{Place, Support, SupportedState, check_core};
use crate::geometry::Contact;
use crate::mechanics::atlas::{Atlas, Condition, Solution};
use crate::mechanics::{Load, Ply, Twist};
use crate::numerics::dual::Dual;
use crate::numerics::isolate::Pair;
use crate::{DomainError, Handedness};

/// p̂ = 0 and ∂E/∂θ = 0 at ρ of strands on the core, the moment eliminated, as (48): n sin²θ cos θ (1 − love) − εhnρ sin θ + fρ² = 0
/// for the weights (1, love, εh, f), γ r u₃ = love·ε sin θ cos θ/ρ + h.
#[derive(Clone, Copy, Debug)]
struct AtForce(f64);

/// The same with the force eliminated, (37): n sin³θ + love n sin θ cos²θ + εhnρ cos θ − εmρ = 0 for (1, love, εh, εm).
#[derive(Clone, Copy, Debug)]
struct AtMoment(f64);

impl Condition<4> for AtForce {
    fn terms(&self, contact: &Contact) -> [Dual; 4] {
        let (n, rho, [s, c]) = (f64::from(contact.strands()), self.0, sin_cos(contact));
        let bending = n * (s * s * c);
        [bending, -bending, -(n * rho * s), Dual::new(rho * rho, 0.0)]
    }
}

impl Condition<4> for AtMoment {
    fn terms(&self, contact: &Contact) -> [Dual; 4] {
        let (n, rho, [s, c]) = (f64::from(contact.strands()), self.0, sin_cos(contact));
        [n * (s * s * s), n * (s * c * c), n * rho * c, Dual::new(-rho, 0.0)]
    }
}

fn sin_cos(contact: &Contact) -> [Dual; 2] {
    let (s, c) = (contact.angle().sin(), contact.angle().cos());
    [Dual::new(s, c), Dual::new(c, -s)]
}

impl Ply {
    /// Every state in which strands that lie on a core, apart from each other, just stop pressing on it (p_c = 0) under a given force: the
    /// onset of birdcaging. The moment is found. A free helix closes on the core at the same loads.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite, the core's radius (units of r) is greater than 0 and no external pressure acts.
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// // a strand of six wires on a core, pushed: it lifts off where it would have to turn back
    /// let rope = Ply::new(6, 0.77)?;
    /// for state in rope.lift_off_at_force(Twist::Pretwist(-0.1), -0.01, 1.2)? {
    ///     assert!(state.core_pressure().abs() < 1e-15 && state.neighbour_gap() > 0.0);
    /// }
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn lift_off_at_force(
        &self,
        twist: Twist,
        force: f64,
        core_radius: f64,
    ) -> Result<Vec<SupportedState>, DomainError> {
        let weights = |love, held| Pair { even: [1.0, love, 0.0, force], odd: [0.0, 0.0, held, 0.0] };
        self.lift_offs(twist, Load { force, moment: 0.0 }, core_radius, AtForce, weights, |found| Load {
            force,
            ..found
        })
    }

    /// As [`lift_off_at_force`](Self::lift_off_at_force), under a given moment; the force is found.
    ///
    /// # Errors
    /// As [`lift_off_at_force`](Self::lift_off_at_force).
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// let rope = Ply::new(6, 0.77)?;
    /// let states = rope.lift_off_at_moment(Twist::Pretwist(-0.1), 0.2, 1.2)?;
    /// assert!(states.iter().all(|state| state.core_pressure().abs() < 1e-15));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn lift_off_at_moment(
        &self,
        twist: Twist,
        moment: f64,
        core_radius: f64,
    ) -> Result<Vec<SupportedState>, DomainError> {
        let weights = |love, held| Pair { even: [1.0, love, 0.0, 0.0], odd: [0.0, 0.0, held, moment] };
        self.lift_offs(twist, Load { force: 0.0, moment }, core_radius, AtMoment, weights, |found| Load {
            moment,
            ..found
        })
    }

    fn lift_offs<C: Condition<4>>(
        &self,
        twist: Twist,
        given: Load,
        core_radius: f64,
        condition: impl Fn(f64) -> C,
        weights: impl Fn(f64, f64) -> Pair<4>,
        loads: impl Fn(Load) -> Load,
    ) -> Result<Vec<SupportedState>, DomainError> {
        self.check(twist, given)?;
        self.check_unpressed()?;
        let rho = check_core(core_radius)?;
        let (love, held) = twist.weights(self.stiffness_ratio());
        let mut states = Vec::new();
        Atlas::new(self.strands(), condition(rho)).solve(weights(love, held), |handedness, at| {
            states.extend(self.lifted(handedness, at, rho, twist, &loads));
        });
        states.sort_by(SupportedState::in_order);
        Ok(states)
    }

    /// The state on the core at an angle with p_c = 0, if neighbours leave room for it. `loads` puts the load that was given in its place.
    fn lifted(
        &self,
        handedness: Handedness,
        at: Solution,
        rho: f64,
        twist: Twist,
        loads: impl Fn(Load) -> Load,
    ) -> Option<SupportedState> {
        let (n, eps) = (f64::from(self.strands()), handedness.sign());
        let (s, c) = (at.angle.sin(), at.angle.cos());
        let (love, held) = twist.weights(self.stiffness_ratio());
        let u3 = eps * love * s * c / rho + held; // γ r u₃
        let load = Load { force: n * s * (eps * u3 - s * c / rho) / rho, moment: n * (eps * s * s * s / rho + u3 * c) };
        let place =
            Place { strands: self.strands(), handedness, angle: at.angle, radius_ratio: rho, on_core: Some(rho) };
        let state = SupportedState::new(Support::Core, place, self.stiffness_ratio(), twist, loads(load));
        (state.touching.radius_ratio() < rho).then_some(state)
    }
}
