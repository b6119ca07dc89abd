//! Where strands part: states with p = 0, and so p₁ = 0, the same in both balances.

use super::atlas::{Atlas, Condition};
use super::{Equilibrium, Load, Ply, Twist};
use crate::geometry::{Contact, HelicalAngle};
use crate::numerics::dual::Dual;
use crate::numerics::isolate::Pair;
use crate::{DomainError, Handedness};

/// p = 0 and balance, the moment eliminated, (48): n sin²θ cos θ − εγ(r u₃) nρ sin θ + fρ² = 0, times cos²θ, for the
/// weights (1, γ, εγφ̄a, f) when the pretwist is given and (1, 0, εγ r u₃, f) when the strand twist is.
#[derive(Clone, Copy, Debug)]
struct AtForce;

impl Condition<4> for AtForce {
    fn terms(&self, contact: &Contact) -> [Dual; 4] {
        let at = contact.regular();
        let n = f64::from(contact.strands());
        let (s, c, radius) = (at.sin, at.cos, at.radius);
        let bending = n * (s * s * c * c * c);
        [bending, -bending, -(n * (radius * s * c)), radius * radius]
    }
}

/// p = 0 by (37): n sin³θ + εγ(r u₃) nρ cos θ − εmρ = 0, times cos θ, for the weights (1, γ, εγφ̄a, εm) when the
/// pretwist is given and (1, 0, εγ r u₃, εm) when the strand twist is.
#[derive(Clone, Copy, Debug)]
struct AtMoment;

impl Condition<4> for AtMoment {
    fn terms(&self, contact: &Contact) -> [Dual; 4] {
        let at = contact.regular();
        let n = f64::from(contact.strands());
        let (s, c, radius) = (at.sin, at.cos, at.radius);
        [n * (s * s * s * c), n * (s * c * c * c), n * (radius * c), -radius]
    }
}

/// p = 0 and balance, the strands' twist eliminated: n sin²θ − εmρ sin θ + fρ² cos θ = 0, times cos θ, for the weights
/// (1, f, εm), whatever γ.
#[derive(Clone, Copy, Debug)]
struct AtLoads;

impl Condition<3> for AtLoads {
    fn terms(&self, contact: &Contact) -> [Dual; 3] {
        let at = contact.regular();
        let n = f64::from(contact.strands());
        let (s, c, radius) = (at.sin, at.cos, at.radius);
        [n * (s * s * c), radius * radius, -(radius * s)]
    }
}

/// The slopes dθ of the loads at separation, for the weights (1, love, εh): f = n(εh y + (love − 1) y²c) and
/// εm = n(y(s² + love c²) + εh c) with y = sin θ/ρ and γ r u₃ = love·εyc + h.
#[derive(Clone, Copy, Debug)]
enum Extreme {
    Force,
    Moment,
}

impl Condition<3> for Extreme {
    fn terms(&self, contact: &Contact) -> [Dual; 3] {
        let at = contact.curved();
        let (s, c, y) = (at.sin, at.cos, at.rotation());
        match self {
            Self::Force => {
                let bending = (y * y * c).derivative();
                [-bending, bending, y.derivative()]
            }
            Self::Moment => [(y * s * s).derivative(), (y * c * c).derivative(), c.derivative()],
        }
    }
}

impl Ply {
    /// Every state on the verge of separation (p = 0) under a given force; its moment is found.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite, or under an external pressure, which adds to p.
    ///
    /// ```
    /// use nply::mechanics::{Ply, Twist};
    /// // untwisted strands under compression open where the force is −n(1 − γ) sin²θ cos θ/ρ², (48)
    /// let states = Ply::new(2, 0.5)?.separation_at_force(Twist::Pretwist(0.0), -0.2)?;
    /// let angle = states[0].contact().angle();
    /// assert!((angle.sin().powi(2) * angle.cos() - 0.2).abs() < 1e-15);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn separation_at_force(&self, twist: Twist, force: f64) -> Result<Vec<Equilibrium>, DomainError> {
        self.separations(
            twist,
            Load { force, moment: 0.0 },
            AtForce,
            |love, held| Pair { even: [1.0, love, 0.0, force], odd: [0.0, 0.0, held, 0.0] },
            |state| Load { force, moment: state.separation_moment() },
        )
    }

    /// Every state on the verge of separation (p = 0) under a given moment; its force is found.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite, or under an external pressure, which adds to p.
    ///
    /// ```
    /// use nply::mechanics::{Ply, Twist};
    /// let states = Ply::new(3, 0.75)?.separation_at_moment(Twist::Pretwist(-0.2), 0.1)?;
    /// assert!(states.iter().all(|s| s.interstrand_pressure().abs() < 1e-15 && s.balance_residual().abs() < 1e-13));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn separation_at_moment(&self, twist: Twist, moment: f64) -> Result<Vec<Equilibrium>, DomainError> {
        self.separations(
            twist,
            Load { force: 0.0, moment },
            AtMoment,
            |love, held| Pair { even: [1.0, love, 0.0, 0.0], odd: [0.0, 0.0, held, moment] },
            |state| Load { force: state.separation_force(), moment },
        )
    }

    /// Every state on the verge of separation (p = 0) under given loads; its pretwist is found.
    ///
    /// # Errors
    /// [`DomainError`] unless the loads are finite, or under an external pressure, which adds to p.
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply};
    /// let states = Ply::new(3, 0.75)?.separation_at_loads(Load { force: -0.2, moment: 0.1 })?;
    /// assert!(states.iter().all(|s| s.interstrand_pressure().abs() < 1e-15 && s.balance_residual().abs() < 1e-13));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn separation_at_loads(&self, load: Load) -> Result<Vec<Equilibrium>, DomainError> {
        let weights = |_, _| Pair { even: [1.0, load.force, 0.0], odd: [0.0, 0.0, load.moment] };
        let mut states = self.separations(Twist::Pretwist(0.0), load, AtLoads, weights, |_| load)?;
        for state in &mut states {
            state.twist = Twist::Pretwist(state.separation_pretwist());
        }
        states.retain(|state| state.pretwist().is_finite());
        Ok(states)
    }

    /// The states at which the force, and those at which the moment, on the verge of separation is greatest or least among
    /// neighbouring angles: the turning points of the locus p = 0 of Figures 9 and 10. It has no cusps but for single values of the
    /// pretwist, at which both turn together.
    ///
    /// # Errors
    /// [`DomainError`] unless the twist is finite, or under an external pressure, which adds to p.
    ///
    /// ```
    /// use nply::mechanics::{Ply, Twist};
    /// let [by_force, by_moment] = Ply::new(3, 0.75)?.separation_extremes(Twist::Pretwist(-0.2))?;
    /// assert!((by_force[0].contact().angle().degrees() - 43.99).abs() < 0.01);
    /// assert!((by_moment[0].contact().angle().degrees() - 53.46).abs() < 0.01);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn separation_extremes(&self, twist: Twist) -> Result<[Vec<Equilibrium>; 2], DomainError> {
        let loads = |state: &Equilibrium| Load { force: state.separation_force(), moment: state.separation_moment() };
        let weights = |love, held| Pair { even: [1.0, love, 0.0], odd: [0.0, 0.0, held] };
        let [by_force, by_moment] = [Extreme::Force, Extreme::Moment]
            .map(|extreme| self.separations(twist, Load::NONE, extreme, weights, loads));
        Ok([by_force?, by_moment?])
    }

    /// The state of a given angle on the verge of separation: its force and moment are found. Over all angles these loads are the
    /// locus p = 0 of Figures 9 and 10.
    ///
    /// # Errors
    /// [`DomainError`] unless the twist is finite, or under an external pressure, which adds to p.
    ///
    /// ```
    /// use nply::Handedness::Right;
    /// use nply::geometry::HelicalAngle;
    /// use nply::mechanics::{Ply, Twist};
    /// // the square of Figure 9: straight strands part under no force, m = nγφ̄a
    /// let state = Ply::new(2, 0.75)?.separation_at(HelicalAngle::new(0.0)?, Right, Twist::Pretwist(-0.2))?;
    /// assert!(state.load().force == 0.0 && (state.load().moment + 0.3).abs() < 1e-15);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn separation_at(
        &self,
        angle: HelicalAngle,
        handedness: Handedness,
        twist: Twist,
    ) -> Result<Equilibrium, DomainError> {
        self.check(twist, Load::NONE)?;
        self.check_unpressed()?;
        let mut state = self.state(Contact::at(self.strands(), angle), false, handedness, twist, Load::NONE);
        state.load = Load { force: state.separation_force(), moment: state.separation_moment() };
        Ok(state)
    }

    /// Separation is of strands that nothing presses from outside.
    pub(super) fn check_unpressed(&self) -> Result<(), DomainError> {
        let allowed = "0 where separation or supports are asked for: it adds to the pressure between strands";
        DomainError::check(self.external_pressure() == 0.0, "external_pressure", self.external_pressure(), allowed)
    }

    fn separations<const K: usize>(
        &self,
        twist: Twist,
        given: Load,
        condition: impl Condition<K>,
        weights: impl Fn(f64, f64) -> Pair<K>,
        load: impl Fn(&Equilibrium) -> Load,
    ) -> Result<Vec<Equilibrium>, DomainError> {
        self.check(twist, given)?;
        self.check_unpressed()?;
        let (love, held) = twist.weights(self.stiffness_ratio());
        let mut states = Vec::new();
        Atlas::new(self.strands(), condition).solve(weights(love, held), |handedness, at| {
            let contact = Contact::at(self.strands(), at.angle);
            let mut state = self.state(contact, at.double, handedness, twist, given);
            state.load = load(&state);
            states.push(state);
        });
        Equilibrium::sort(&mut states);
        Ok(states)
    }
}

impl Equilibrium {
    /// The m at which p vanishes at this angle, hand and twist, by (37).
    fn separation_moment(&self) -> f64 {
        let (s, c, rho) = (self.contact.angle().sin(), self.contact.angle().cos(), self.contact.radius_ratio());
        let n = f64::from(self.contact.strands());
        let (eps, gamma, u3) = (self.handedness.sign(), self.stiffness_ratio, self.strand_twist());
        n * (eps * s * s * s / rho + gamma * u3 * c)
    }

    /// The pretwist at which p vanishes at this angle, hand and moment, by (37).
    fn separation_pretwist(&self) -> f64 {
        let (s, c, rho) = (self.contact.angle().sin(), self.contact.angle().cos(), self.contact.radius_ratio());
        let n = f64::from(self.contact.strands());
        let eps = self.handedness.sign();
        (self.load.moment / n - eps * s * s * s / rho) / (self.stiffness_ratio * c) - eps * self.contact.torsion()
    }

    /// The f that keeps this angle, hand and twist where p vanishes, by (48).
    fn separation_force(&self) -> f64 {
        let (s, c, rho) = (self.contact.angle().sin(), self.contact.angle().cos(), self.contact.radius_ratio());
        let n = f64::from(self.contact.strands());
        let (eps, gamma, u3) = (self.handedness.sign(), self.stiffness_ratio, self.strand_twist());
        n * s * (eps * gamma * u3 - s * c / rho) / rho
    }
}
