//! All equilibria of a ply for any data that fix it.

use super::atlas::{Atlas, Condition, Solution};
use super::balance::Pressurised;
use super::{Balance, Load, Ply, Twist};
use crate::geometry::{Contact, HelicalAngle};
use crate::numerics::dual::Dual;
use crate::numerics::isolate::Pair;
use crate::{DomainError, Handedness};

/// A state of the uniform ply in equilibrium: geometry, hand, twist and loads, everything else follows.
///
/// All quantities are dimensionless (r = B = 1); see [`Scale`](crate::Scale).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium {
    pub(super) contact: Contact,
    pub(super) handedness: Handedness,
    pub(super) stiffness_ratio: f64,
    pub(super) twist: Twist,
    pub(super) load: Load,
    pub(super) balance: Balance,
    pub(super) external_pressure: f64,
    pub(super) fold: bool,
}

impl Equilibrium {
    /// The touching strands.
    #[must_use]
    pub const fn contact(&self) -> &Contact {
        &self.contact
    }

    /// ε.
    #[must_use]
    pub const fn handedness(&self) -> Handedness {
        self.handedness
    }

    /// γ = C/B.
    #[must_use]
    pub const fn stiffness_ratio(&self) -> f64 {
        self.stiffness_ratio
    }

    /// The end loads.
    #[must_use]
    pub const fn load(&self) -> Load {
        self.load
    }

    /// What is held of the twist when the loads change: the pretwist or the strands' twist itself.
    #[must_use]
    pub const fn twist(&self) -> Twist {
        self.twist
    }

    /// The balance that was used.
    #[must_use]
    pub const fn balance(&self) -> Balance {
        self.balance
    }

    /// p_e r³/B, outward positive.
    #[must_use]
    pub const fn external_pressure(&self) -> f64 {
        self.external_pressure
    }

    /// Whether this is a limit point: two states that have met, to within rounding.
    #[must_use]
    pub const fn is_fold(&self) -> bool {
        self.fold
    }

    #[doc = include_str!("../equations/eq49.md")]
    ///
    /// φ̄a, dimensionless.
    #[must_use]
    pub fn pretwist(&self) -> f64 {
        match self.twist {
            Twist::Pretwist(pretwist) => pretwist,
            Twist::StrandTwist(strand_twist) => strand_twist - self.handedness.sign() * self.contact.torsion(),
        }
    }

    #[doc = include_str!("../equations/eq45.md")]
    ///
    /// r u₃, dimensionless.
    #[must_use]
    pub fn strand_twist(&self) -> f64 {
        match self.twist {
            Twist::Pretwist(pretwist) => pretwist + self.handedness.sign() * self.contact.torsion(),
            Twist::StrandTwist(strand_twist) => strand_twist,
        }
    }

    /// The balance cos²θ·G, zero in equilibrium, with its slope dθ along the branch at the given loads and twist.
    pub(super) fn scaled_balance(&self) -> Dual {
        self.weighted_terms().into_iter().fold(Dual::new(0.0, 0.0), |sum, term| sum + term)
    }

    /// The slope of cos²θ·G, and what rounding may make of it.
    pub(super) fn slope_and_rounding(&self) -> (f64, f64) {
        let terms = self.weighted_terms();
        let size: f64 = terms.iter().map(|term| term.slope.abs()).sum();
        (terms.iter().map(|term| term.slope).sum(), f64::EPSILON * size)
    }

    /// The terms of cos²θ·G times their weights; the last is that of an external pressure.
    fn weighted_terms(&self) -> [Dual; 6] {
        let Pair { even, odd } = weights(self.stiffness_ratio, self.twist, self.load);
        let terms = self.balance.terms(&self.contact);
        let pressure = if self.external_pressure == 0.0 {
            Dual::new(0.0, 0.0)
        } else {
            // the pressurised condition carries cos⁴θ
            let secant = self.contact.regular().cos.recip();
            self.external_pressure * (Pressurised.terms(&self.contact)[5] * secant * secant)
        };
        core::array::from_fn(|k| match terms.get(k) {
            Some(term) => (even[k] + self.handedness.sign() * odd[k]) * *term,
            None => pressure,
        })
    }

    /// The left side of (47), or of the contact balance, at this state: zero but for rounding.
    #[must_use]
    pub fn balance_residual(&self) -> f64 {
        let c = self.contact.angle().cos();
        self.scaled_balance().value / (c * c)
    }

    #[doc = include_str!("../equations/eq64.md")]
    ///
    /// dG/dθ per rad, along the branch, at given loads and given [`twist`](Self::twist).
    #[must_use]
    pub fn balance_slope(&self) -> f64 {
        let c = self.contact.angle().cos();
        self.scaled_balance().slope / (c * c)
    }
}

impl Equilibrium {
    /// A state whose angle was found elsewhere, without a pressure from outside.
    #[inline]
    pub(super) const fn found(
        contact: Contact,
        fold: bool,
        handedness: Handedness,
        (stiffness_ratio, twist, load): (f64, Twist, Load),
        balance: Balance,
    ) -> Self {
        Self { contact, handedness, stiffness_ratio, twist, load, balance, external_pressure: 0.0, fold }
    }

    /// Right-handed first, then by angle; a fold on the border of two panels, seen from both, is kept once.
    pub(super) fn sort(states: &mut Vec<Self>) {
        let angle = |s: &Self| s.contact.helical_angle();
        states.sort_by(|a, b| {
            let left = |s: &Self| s.handedness == Handedness::Left;
            left(a).cmp(&left(b)).then(angle(a).total_cmp(&angle(b)))
        });
        states.dedup_by(|b, a| a.fold && b.fold && a.handedness == b.handedness && angle(b) - angle(a) < 1e-7);
    }
}

/// The weights of a balance's five terms, (1, γ, εγφ̄a, f, εm) or (1, 0, εγ r u₃, f, εm), as even and odd in ε.
pub(super) fn weights(gamma: f64, twist: Twist, load: Load) -> Pair<5> {
    let (love, held) = twist.weights(gamma);
    Pair { even: [1.0, love, 0.0, load.force, 0.0], odd: [0.0, 0.0, held, 0.0, load.moment] }
}

impl Ply {
    /// Every state with the given twist under given end loads, every angle in (0, π/2), both hands: right-handed first,
    /// then by angle. No state is an answer: an empty list. Straight strands are not in it, see
    /// [`straight_holds`](Self::straight_holds).
    ///
    /// How none is missed: on each of six panels of the branch the balance is a polynomial of degree 11 to within a
    /// known error. The signs of its Bernstein coefficients bound the number of roots; where they leave it open the
    /// derivative's signs or the exact height of the single extremum decide, or the panel is halved. A state where two
    /// roots meet within rounding is given once, as a [fold](Equilibrium::is_fold). States within 1e-150 rad of flat rings
    /// (θ = π/2) are left out, within 1e-60 rad in radial balance without a force and a twist. Next to straight strands the terms that
    /// cancel are taken together; a moment within rounding (four units in the last place) of nγφ̄a is the one that
    /// [holds](Self::straight_holds) them.
    ///
    /// # Errors
    /// [`DomainError`] unless the twist, γ times the twist, and the loads are finite.
    ///
    /// ```
    /// use nply::mechanics::{Balance, Load, Ply, Twist};
    /// // Figure 8: in radial balance each pretwist has two balanced angles, of opposite hands, on either side of 45°
    /// let states = Ply::with_balance(2, 0.75, Balance::Radial)?.equilibria(Twist::Pretwist(-1.0), Load::NONE)?;
    /// assert_eq!(states.len(), 2);
    /// assert!(states[0].contact().angle().degrees() < 45.0 && states[1].contact().angle().degrees() > 45.0);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn equilibria(&self, twist: Twist, load: Load) -> Result<Vec<Equilibrium>, DomainError> {
        let mut states = Vec::with_capacity(4);
        self.each_equilibrium(twist, load, |state| states.push(state))?;
        Equilibrium::sort(&mut states);
        Ok(states)
    }

    /// As [`equilibria`](Self::equilibria), without a list: every state is handed to `found`, in no order.
    ///
    /// # Errors
    /// As [`equilibria`](Self::equilibria).
    #[inline]
    pub fn each_equilibrium(
        &self,
        twist: Twist,
        load: Load,
        mut found: impl FnMut(Equilibrium),
    ) -> Result<(), DomainError> {
        self.check(twist, load)?;
        let weights = weights(self.stiffness_ratio(), twist, load);
        let state = |handedness, at: Solution| {
            found(self.state(Contact::at(self.strands(), at.angle), at.double, handedness, twist, load));
        };
        if self.external_pressure() == 0.0 {
            self.atlas().solve(weights, state);
        } else {
            let ([e0, e1, e2, e3, e4], [o0, o1, o2, o3, o4]) = (weights.even, weights.odd);
            let pressed = Pair { even: [e0, e1, e2, e3, e4, self.external_pressure()], odd: [o0, o1, o2, o3, o4, 0.0] };
            Atlas::new(self.strands(), Pressurised).solve(pressed, state);
        }
        Ok(())
    }

    /// Whether straight strands side by side (θ = 0) are in equilibrium, as they are under m = nγφ̄a and any force: the
    /// moment that holds the ply before it is let go.
    #[must_use]
    pub fn straight_holds(&self, twist: Twist, load: Load) -> bool {
        let (Twist::Pretwist(straight) | Twist::StrandTwist(straight)) = twist;
        let held = f64::from(self.strands()) * self.stiffness_ratio() * straight;
        (load.moment - held).abs() <= 4.0 * f64::EPSILON * held.abs()
    }

    /// The moment that holds the ply at an angle, with the twist and the force given.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite, and on `helical_angle` where the moment does no work on it: at the
    /// angle of the most turns, q = 1, in contact balance.
    ///
    /// ```
    /// use nply::geometry::HelicalAngle;
    /// use nply::mechanics::{Ply, Twist};
    /// use nply::Handedness::Right;
    /// let rope = Ply::new(2, 0.75)?;
    /// let state = rope.moment_at(HelicalAngle::new(0.0)?, Right, Twist::Pretwist(-0.2), 1.0)?;
    /// assert!((state.load().moment - 2.0 * 0.75 * -0.2).abs() < 1e-15); // straight: m = nγφ̄a
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn moment_at(
        &self,
        angle: HelicalAngle,
        handedness: Handedness,
        twist: Twist,
        force: f64,
    ) -> Result<Equilibrium, DomainError> {
        let load = Load { force, moment: 0.0 };
        let moment = self.missing(
            Contact::at(self.strands(), angle),
            handedness,
            twist,
            load,
            4,
            "an angle at which the moment does work: not that of the most turns (q = 1)",
        )?;
        self.finished(
            Contact::at(self.strands(), angle),
            handedness,
            twist,
            Load { force, moment: handedness.sign() * moment },
        )
    }

    /// The force that holds the ply at an angle, with the twist and the moment given.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite, and on `helical_angle` = 0, where the force does no work.
    pub fn force_at(
        &self,
        angle: HelicalAngle,
        handedness: Handedness,
        twist: Twist,
        moment: f64,
    ) -> Result<Equilibrium, DomainError> {
        let load = Load { force: 0.0, moment };
        let force = self.missing(
            Contact::at(self.strands(), angle),
            handedness,
            twist,
            load,
            3,
            "greater than 0: the force does no work on straight strands",
        )?;
        self.finished(Contact::at(self.strands(), angle), handedness, twist, Load { force, moment })
    }

    /// The pretwist with which the ply keeps an angle under given loads.
    ///
    /// # Errors
    /// [`DomainError`] unless the loads are finite, and on `helical_angle` at the limit for large pretwist (π/4 in
    /// radial balance), where no pretwist is large enough.
    ///
    /// ```
    /// use nply::geometry::HelicalAngle;
    /// use nply::mechanics::{Load, Ply};
    /// use nply::Handedness::Right;
    /// // γ = 1, n = 2: tan 2θ = −2εφ̄a, below (67)
    /// let angle = HelicalAngle::new(0.5 * 1_f64.atan())?;
    /// let state = Ply::new(2, 1.0)?.pretwist_at(angle, Right, Load::NONE)?;
    /// assert!((state.pretwist() + 0.5).abs() < 1e-15);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn pretwist_at(
        &self,
        angle: HelicalAngle,
        handedness: Handedness,
        load: Load,
    ) -> Result<Equilibrium, DomainError> {
        self.pretwist_on(Contact::at(self.strands(), angle), handedness, load)
    }

    /// As [`pretwist_at`](Self::pretwist_at) for a given contact, such as [`Contact::line`] beyond π/4.
    ///
    /// # Errors
    /// As [`pretwist_at`](Self::pretwist_at), and on `strands` if the contact is between others than this ply has.
    ///
    /// ```
    /// use nply::geometry::{Contact, HelicalAngle};
    /// use nply::mechanics::{Balance, Load, Ply};
    /// use nply::Handedness::Right;
    /// // Figure 6d: on the trivial branch p₁ → −½ as the strands become rings
    /// let rings = Contact::line(HelicalAngle::from_pitch_angle(1e-6)?);
    /// let state = Ply::with_balance(2, 0.75, Balance::Radial)?.pretwist_on(rings, Right, Load::NONE)?;
    /// assert!((state.interstrand_pressure() + 0.5).abs() < 1e-11);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn pretwist_on(
        &self,
        contact: Contact,
        handedness: Handedness,
        load: Load,
    ) -> Result<Equilibrium, DomainError> {
        let same = contact.strands() == self.strands();
        DomainError::check(same, "strands", f64::from(contact.strands()), "that of the ply")?;
        let allowed = "an angle some pretwist can hold: not the limiting angle of large pretwist";
        let held = self.missing(contact, handedness, Twist::Pretwist(0.0), load, 2, allowed)?;
        let pretwist = handedness.sign() * held / self.stiffness_ratio();
        self.finished(contact, handedness, Twist::Pretwist(pretwist), load)
    }

    /// The weight number `k` of the balance when all others are given and its own is zero.
    fn missing(
        &self,
        contact: Contact,
        handedness: Handedness,
        twist: Twist,
        load: Load,
        k: usize,
        allowed: &'static str,
    ) -> Result<f64, DomainError> {
        self.check(twist, load)?;
        let state = self.state(contact, false, handedness, twist, load);
        let term = self.balance().terms(&state.contact)[k].value;
        let (factor, size) = self.balance().factor(&state.contact, k);
        DomainError::check(
            factor.abs() > 4.0 * f64::EPSILON * size,
            "helical_angle",
            contact.helical_angle(),
            allowed,
        )?;
        Ok(-state.scaled_balance().value / term)
    }

    /// A state from solved data, if they can be written as numbers.
    fn finished(
        &self,
        contact: Contact,
        handedness: Handedness,
        twist: Twist,
        load: Load,
    ) -> Result<Equilibrium, DomainError> {
        self.check(twist, load)?;
        Ok(self.state(contact, false, handedness, twist, load))
    }

    #[inline]
    pub(super) fn state(
        &self,
        contact: Contact,
        fold: bool,
        handedness: Handedness,
        twist: Twist,
        load: Load,
    ) -> Equilibrium {
        Equilibrium {
            contact,
            handedness,
            stiffness_ratio: self.stiffness_ratio(),
            twist,
            load,
            balance: self.balance(),
            external_pressure: self.external_pressure(),
            fold,
        }
    }

    /// Data that are numbers.
    #[inline]
    pub(super) fn check(&self, twist: Twist, load: Load) -> Result<(), DomainError> {
        let (name, value) = match twist {
            Twist::Pretwist(value) => ("pretwist", value),
            Twist::StrandTwist(value) => ("strand_twist", value),
        };
        DomainError::check(
            (value * self.stiffness_ratio()).is_finite(),
            name,
            value,
            "finite, and times the stiffness ratio",
        )?;
        DomainError::check(load.force.is_finite(), "force", load.force, "finite")?;
        DomainError::check(load.moment.is_finite(), "moment", load.moment, "finite")
    }
}
