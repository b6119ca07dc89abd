//! The verge of separation: states in which a contact is closed and presses with nothing.

use super::obstacle;
use super::ply::ExtensiblePly;
use super::potential::{Potential, Spot};
use super::state::{ExtensibleState, LEAST_STRAIN, MOST_STRAIN};
use crate::geometry::{Contact, HelicalAngle};
use crate::mechanics::{Load, Support, Twist};
use crate::numerics::dual::Dual;
use crate::numerics::isolate::{Basis, Pair, Panel};
use crate::numerics::jet2::Jet2;
use crate::{DomainError, Handedness};

impl ExtensiblePly {
    /// The state of a hand at an angle in which strands just stop pressing on their neighbours, or on the core (`support`), with the loads
    /// that bring it there: a free helix that touches. `None` where no strain within what is looked at (−1/2 to 1) allows it.
    ///
    /// # Errors
    /// [`DomainError`] on `support` unless it is [`Support::Neighbours`], or [`Support::Core`] of a ply that has one, and unless the twist is
    /// finite and the angle greater than 0.
    ///
    /// ```
    /// use nply::mechanics::{ExtensiblePly, Ply, StretchingStrand, Support, Twist};
    /// use nply::{Handedness, geometry::HelicalAngle};
    /// let angle = HelicalAngle::new(0.4)?;
    /// let paper = Ply::new(3, 0.75)?.separation_at(angle, Handedness::Left, Twist::Pretwist(-1.0))?;
    /// let yarn = ExtensiblePly::new(3, StretchingStrand::inextensible(0.75)?)?;
    /// let verge = yarn.parting_at(Support::Neighbours, angle, Handedness::Left, Twist::Pretwist(-1.0))?.expect("a verge");
    /// assert!((verge.load().force - paper.load().force).abs() < 1e-13);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn parting_at(
        &self,
        support: Support,
        angle: HelicalAngle,
        handedness: Handedness,
        twist: Twist,
    ) -> Result<Option<ExtensibleState>, DomainError> {
        self.check_parting(support, twist)?;
        DomainError::check(angle.sin() > 0.0, "helical_angle", angle.radians(), "greater than 0")?;
        let parting = Parting::new(self, support, handedness, twist);
        Ok(parting.verge(angle).map(|verge| parting.state(angle, &verge)))
    }

    /// Every state of both hands, at a given force, in which strands just stop pressing on their neighbours, or on the core; the moment is
    /// found. Right-handed first, then by angle.
    ///
    /// # Errors
    /// As [`parting_at`](Self::parting_at), and unless the force is finite.
    pub fn parting_at_force(
        &self,
        support: Support,
        twist: Twist,
        force: f64,
    ) -> Result<Vec<ExtensibleState>, DomainError> {
        DomainError::check(force.is_finite(), "force", force, "finite")?;
        self.partings(support, twist, |verge, _| verge.force - Dual::new(force, 0.0))
    }

    /// The same at a given moment; the force is found.
    ///
    /// # Errors
    /// As [`parting_at`](Self::parting_at), and unless the moment is finite.
    pub fn parting_at_moment(
        &self,
        support: Support,
        twist: Twist,
        moment: f64,
    ) -> Result<Vec<ExtensibleState>, DomainError> {
        DomainError::check(moment.is_finite(), "moment", moment, "finite")?;
        self.partings(support, twist, |verge, hand| verge.moment - Dual::new(hand.sign() * moment, 0.0))
    }

    fn check_parting(&self, support: Support, twist: Twist) -> Result<(), DomainError> {
        let (Twist::Pretwist(given) | Twist::StrandTwist(given)) = twist;
        DomainError::check(given.is_finite(), "twist", given, "finite")?;
        let known = match support {
            Support::Neighbours => true,
            Support::Core => self.core().is_some(),
            Support::Both | Support::Free => false,
        };
        DomainError::check(known, "support", f64::NAN, "neighbours, or the core of a ply that has one")
    }

    fn partings(
        &self,
        support: Support,
        twist: Twist,
        condition: impl Fn(&Verge, Handedness) -> Dual,
    ) -> Result<Vec<ExtensibleState>, DomainError> {
        self.check_parting(support, twist)?;
        let mut states = Vec::new();
        for hand in Handedness::BOTH {
            let parting = Parting::new(self, support, hand, twist);
            let chart = Chart { parting: &parting, condition: |verge: &Verge| condition(verge, hand) };
            for panel in 0..PANELS {
                // the ends themselves, straight strands and flat rings, are no verge
                let place = |i: u32| 1e-6 + (core::f64::consts::FRAC_PI_2 - 2e-6) * f64::from(i) / f64::from(PANELS);
                let fitted = Panel::fit(&chart, place(panel), place(panel + 1));
                fitted.roots(&chart, &Pair { even: [1.0], odd: [0.0] }, &mut |side, root| {
                    let angle = HelicalAngle::steep(root.at);
                    if let (true, Some(verge)) = (side > 0.0, parting.verge(angle)) {
                        states.push(parting.state(angle, &verge));
                    }
                });
            }
        }
        // a core in the way takes the place of neighbours before these part, and the other way round
        states.retain(|state| match support {
            Support::Neighbours => state.core_gap().is_none_or(|gap| gap >= 0.0),
            _ => state.neighbour_gap() >= 0.0,
        });
        states.sort_by(ExtensibleState::in_order);
        Ok(states)
    }
}

/// π/4, where the contact of two strands has a corner, is a border of panels.
const PANELS: u32 = 8;

struct Parting<'p> {
    ply: &'p ExtensiblePly,
    support: Support,
    hand: Handedness,
    twist: Twist,
    /// without loads
    potential: Potential,
}

/// Strain, rotation, and the loads with their slopes by the angle, for the right hand.
struct Verge {
    strain: f64,
    rotation: f64,
    force: Dual,
    moment: Dual,
}

struct Chart<'a, F> {
    parting: &'a Parting<'a>,
    condition: F,
}

impl<F: Fn(&Verge) -> Dual> Basis<1> for Chart<'_, F> {
    fn at(&self, t: f64) -> [Dual; 1] {
        let nothing = Dual::new(f64::NAN, f64::NAN);
        [self.parting.verge(HelicalAngle::steep(t)).map_or(nothing, |verge| (self.condition)(&verge))]
    }
}

impl<'p> Parting<'p> {
    fn new(ply: &'p ExtensiblePly, support: Support, hand: Handedness, twist: Twist) -> Self {
        let potential = Potential::new(ply, hand, twist, Load::NONE);
        Self { ply, support, hand, twist, potential }
    }

    /// ∂E/∂θ = ∂E/∂e = 0 without the force: P λ s = T Y s − κ̃ Y c and P c = α e, P being what pulls at a strand.
    fn pull(&self, angle: HelicalAngle, strain: f64) -> (Jet2, Jet2, Jet2) {
        let (s, c) = (angle.sin(), angle.cos());
        let sin = Jet2 { value: s, a: c, b: 0.0, aa: -s, ab: 0.0, bb: 0.0 };
        let cos = Jet2 { value: c, a: -s, b: 0.0, aa: -c, ab: 0.0, bb: 0.0 };
        let lambda = Jet2 { value: 1.0 + strain, a: 0.0, b: 1.0, aa: 0.0, ab: 0.0, bb: 0.0 };
        let y = match self.support {
            Support::Core => obstacle::core(self.ply, angle, strain),
            _ => obstacle::neighbours(self.ply, angle, strain),
        };
        let bent = y * sin - Jet2::constant(self.potential.curvature);
        let torque = self.potential.love * (y * cos) + Jet2::constant(self.potential.held);
        let pull = (torque * sin - bent * cos) * y * (lambda * sin).recip();
        (y, pull, cos)
    }

    fn verge(&self, angle: HelicalAngle) -> Option<Verge> {
        let stretches = self.potential.stretches();
        let slack = |e: f64| {
            let (_, pull, cos) = self.pull(angle, e);
            // αe/c − P, over α
            let stretched = Jet2 { value: e, a: 0.0, b: 1.0, aa: 0.0, ab: 0.0, bb: 0.0 } * cos.recip();
            stretched - (1.0 / self.potential.axial) * pull
        };
        let mut strain = 0.0;
        if stretches {
            let (mut low, mut high) = (LEAST_STRAIN, MOST_STRAIN);
            if !(slack(low).value <= 0.0 && slack(high).value >= 0.0) {
                return None;
            }
            for _ in 0..80 {
                let at = slack(strain);
                if at.value > 0.0 {
                    high = strain;
                } else {
                    low = strain;
                }
                let newton = strain - at.value / at.b;
                let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
                let done = (next - strain).abs() <= 2.0 * f64::EPSILON * strain.abs().max(1e-300);
                strain = next;
                if done {
                    break;
                }
            }
        }
        let (y, pull, cos) = self.pull(angle, strain);
        let by_angle = if stretches {
            let at = slack(strain);
            -at.a / at.b
        } else {
            0.0
        };
        let along = |jet: &Jet2| Dual::new(jet.value, jet.a + jet.b * by_angle);
        let (s, c) = (Dual::new(angle.sin(), angle.cos()), along(&cos));
        let lambda = Dual::new(1.0 + strain, by_angle);
        let force = along(&pull) + self.potential.core_pull(lambda * c);
        let y = along(&y);
        let n = f64::from(self.ply.strands());
        // ∂E/∂Y = 0
        let bent = y * s - Dual::new(self.potential.curvature, 0.0);
        let torque = self.potential.love * (y * c) + Dual::new(self.potential.held, 0.0);
        let moment = bent * s + torque * c + self.potential.core_moment(y);
        Some(Verge { strain, rotation: y.value, force: n * force, moment: n * moment })
    }

    fn state(&self, angle: HelicalAngle, verge: &Verge) -> ExtensibleState {
        let spot = Spot { sin: angle.sin(), cos: angle.cos(), rotation: verge.rotation, strain: verge.strain };
        ExtensibleState {
            ply: *self.ply,
            support: self.support,
            handedness: self.hand,
            touching: Contact::at(self.ply.strands(), angle),
            turn: spot.rotation,
            strain: spot.strain,
            twist: self.twist,
            load: Load { force: verge.force.value, moment: self.hand.sign() * verge.moment.value },
            shares: [0.0; 2],
        }
    }
}
