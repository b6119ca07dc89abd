//! A ply as it is estimated, and its states: everything explicit in two coordinates, with slopes.

use core::f64::consts::PI;

use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Balance, Equilibrium, ExtensiblePly, Ply, StretchingStrand, Twist, Variable};
use nply::{DomainError, Handedness};

use super::parameter::{Parameter, Slot};
use super::sensed::{SLOTS, Sensed};

/// What is known of the ply, and where estimates start from: SI, or the theory's units (r = B = 1) where the strand has no size.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    strands: u32,
    balance: Balance,
    /// which way it winds, where that is known
    pub hand: Option<Handedness>,
    /// L, where it is known
    pub strand_length: Option<f64>,
    /// Poisson's ratio by which strands thin
    pub thinning: f64,
    /// in which form each is kept while others are estimated
    forms: [Option<Parameter>; SLOTS],
    /// ln r, ln of B or E, ln of γ, C or G, the twist, ln EA
    slots: [f64; SLOTS],
}

impl Model {
    /// n touching strands, measured by themselves (r = B = 1) until [`with`](Self::with) gives them a size.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`.
    ///
    /// ```
    /// use nply::mechanics::Balance;
    /// use nply_sheet::regression::{Model, Parameter};
    /// let yarn = Model::new(3, Balance::Contact)?.with(Parameter::StiffnessRatio, 0.75)?.with(Parameter::Pretwist, -1.0)?;
    /// assert_eq!(yarn.value(Parameter::Radius), Some(1.0)); // all in strand radii, if nothing is said
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn new(strands: u32, balance: Balance) -> Result<Self, DomainError> {
        Ply::with_balance(strands, 1.0, balance)?;
        Ok(Self {
            strands,
            balance,
            hand: None,
            strand_length: None,
            thinning: 0.0,
            forms: [Some(Parameter::Radius), Some(Parameter::BendingStiffness), None, None, None],
            slots: [0.0; SLOTS],
        })
    }

    /// The same with a number given in a form, which it keeps: with a `youngs_modulus`, B follows the radius.
    ///
    /// # Errors
    /// [`DomainError`] unless finite, and greater than 0 but for a twist.
    pub fn with(mut self, parameter: Parameter, value: f64) -> Result<Self, DomainError> {
        let fit = if parameter.is_positive() { value > 0.0 && value < f64::INFINITY } else { value.is_finite() };
        let allowed = if parameter.is_positive() { "greater than 0 and finite" } else { "finite" };
        if !fit {
            return Err(DomainError { quantity: parameter.name(), value, allowed });
        }
        let value = if parameter == Parameter::Diameter { value / 2.0 } else { value };
        let k = parameter.slot() as usize;
        self.forms[k] = Some(parameter);
        self.slots[k] = if parameter.is_positive() { libm::log(value) } else { value };
        Ok(self)
    }

    /// The same with strands that stretch as solid round ones do: EA follows from B and r, EA r²/B = 4.
    #[must_use]
    pub fn solid(mut self) -> Self {
        self.forms[Slot::Axial as usize] = Some(Parameter::YoungsModulus);
        self
    }

    /// n.
    #[must_use]
    pub const fn strands(&self) -> u32 {
        self.strands
    }

    /// Which balance.
    #[must_use]
    pub const fn balance(&self) -> Balance {
        self.balance
    }

    /// Whether strands stretch.
    #[must_use]
    pub fn stretches(&self) -> bool {
        self.forms[Slot::Axial as usize].is_some()
    }

    /// Whether a number is given that this one takes the place of or is.
    #[must_use]
    pub fn gives(&self, parameter: Parameter) -> bool {
        self.forms[parameter.slot() as usize].is_some()
    }

    /// A number in any of its forms; `None` where nothing gives it.
    #[must_use]
    pub fn value(&self, parameter: Parameter) -> Option<f64> {
        self.value_at(&self.slots, parameter)
    }

    pub(super) const fn slots(&self) -> &[f64; SLOTS] {
        &self.slots
    }

    /// The same ply, its number in the form asked for, by the values it has.
    pub(super) fn in_form(self, parameter: Parameter) -> Option<Self> {
        let value = self.value(parameter)?;
        self.with(parameter, value).ok()
    }

    /// A number under other values of all slots; `None` where nothing gives it.
    pub(super) fn value_at(&self, slots: &[f64; SLOTS], parameter: Parameter) -> Option<f64> {
        let form = self.forms[parameter.slot() as usize]?;
        let strand = self.strand(slots, None);
        let [radius, bending, ratio, twist, axial] =
            [strand.radius, strand.bending, strand.ratio, strand.twist, strand.axial].map(|number| number.value);
        let fourth = radius * radius * (radius * radius);
        let in_strand = form == Parameter::StrandTwist;
        Some(match parameter {
            Parameter::Radius => radius,
            Parameter::Diameter => 2.0 * radius,
            Parameter::BendingStiffness => bending,
            Parameter::YoungsModulus => 4.0 * bending / (PI * fourth),
            Parameter::StiffnessRatio => ratio,
            Parameter::TorsionalStiffness => ratio * bending,
            Parameter::ShearModulus => 2.0 * ratio * bending / (PI * fourth),
            Parameter::Pretwist if !in_strand => twist,
            Parameter::TurnsPerLength if !in_strand => twist / radius,
            Parameter::StrandTwist if in_strand => twist / radius,
            Parameter::Pretwist | Parameter::TurnsPerLength | Parameter::StrandTwist => return None,
            Parameter::AxialStiffness => axial,
        })
    }

    /// The strand under values of all slots, its twist perhaps that of a row.
    pub(super) fn strand(&self, slots: &[f64; SLOTS], row: Option<(Parameter, f64)>) -> Strand {
        let slot = |which: Slot| Sensed::slot(slots[which as usize], which as usize);
        let (ln_radius, fourfold) = (slot(Slot::Radius), 4.0 * slot(Slot::Radius));
        let radius = ln_radius.exp();
        let bending = match self.forms[Slot::Bending as usize] {
            Some(Parameter::YoungsModulus) => PI / 4.0 * (slot(Slot::Bending) + fourfold).exp(),
            _ => slot(Slot::Bending).exp(),
        };
        let torsion = slot(Slot::Torsion);
        let ratio = match self.forms[Slot::Torsion as usize] {
            Some(Parameter::TorsionalStiffness) => torsion.exp() * bending.recip(),
            Some(Parameter::ShearModulus) => PI / 2.0 * ((torsion + fourfold).exp() * bending.recip()),
            _ => torsion.exp(),
        };
        let (form, given) = match row {
            Some((form, value)) => (form, Sensed::constant(value)),
            None => (self.forms[Slot::Twist as usize].unwrap_or(Parameter::Pretwist), slot(Slot::Twist)),
        };
        let twist = if form == Parameter::Pretwist { given } else { given * radius };
        let axial = match self.forms[Slot::Axial as usize] {
            Some(Parameter::YoungsModulus) => 4.0 * (bending * (radius * radius).recip()),
            _ => slot(Slot::Axial).exp(),
        };
        Strand { radius, bending, ratio, twist, held_in_strand: form == Parameter::StrandTwist, axial }
    }
}

/// r, B, γ, the twist of the theory and EA, with their slopes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Strand {
    pub(super) radius: Sensed,
    pub(super) bending: Sensed,
    ratio: Sensed,
    twist: Sensed,
    held_in_strand: bool,
    axial: Sensed,
}

impl Strand {
    /// The twist as the theory takes it.
    pub(super) fn twist(&self) -> Twist {
        if self.held_in_strand { Twist::StrandTwist(self.twist.value) } else { Twist::Pretwist(self.twist.value) }
    }

    /// What twists a strand that lies straight: γφ̄a, or γu₃.
    pub(super) fn torque(&self) -> Sensed {
        self.ratio * self.twist
    }

    /// Units of force and moment.
    pub(super) fn units(&self) -> [f64; 2] {
        let (r, b) = (self.radius.value, self.bending.value);
        [b / r / r, b / r]
    }

    pub(super) fn is_finite(&self) -> bool {
        [self.radius, self.bending, self.ratio, self.twist, self.axial].iter().all(Sensed::is_finite)
            && self.radius.value > 0.0
            && self.bending.value > 0.0
            && self.ratio.value > 0.0
            && self.axial.value > 0.0
    }
}

/// Where a state lies: its hand, ln tan θ, and a second coordinate, which is f, m or the strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    pub(super) hand: Handedness,
    pub(super) second: Second,
    pub(super) place: [f64; 2],
}

/// What the second coordinate is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Second {
    /// f; the moment follows.
    Force,
    /// m; the force follows.
    Moment,
    /// e, of strands that stretch; both loads follow.
    Strain,
}

/// All that can be read off a state, dimensionless but for r, B and the strand length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Readings {
    pub(super) force: Sensed,
    pub(super) moment: Sensed,
    pub(super) extension: Sensed,
    pub(super) rotation: Sensed,
    pub(super) angle: Sensed,
    pub(super) radius_ratio: Sensed,
    pub(super) outer: Sensed,
    pub(super) radius: Sensed,
    pub(super) bending: Sensed,
    pub(super) strand_length: f64,
    pub(super) hand: Handedness,
    /// p₁ r³/B
    pub(super) pressure: f64,
}

impl Readings {
    /// Ply length per rad round the axis, in r: λ cos θ over the turning, whichever way it goes.
    pub(super) fn lay(&self) -> Sensed {
        self.hand.sign() * (self.extension * self.rotation.recip())
    }
}

/// θ by ln tan θ, with all digits at both ends.
fn angle_of(t: f64) -> Option<HelicalAngle> {
    let angle = if t > 0.0 {
        HelicalAngle::from_pitch_angle(libm::atan(libm::exp(-t)))
    } else {
        HelicalAngle::new(libm::atan(libm::exp(t)))
    };
    angle.ok().filter(|angle| angle.sin() > 0.0 && angle.cos() > 0.0)
}

/// ln tan θ.
pub(super) fn place_of(angle: HelicalAngle) -> f64 {
    libm::log(angle.sin() / angle.cos())
}

impl Model {
    /// What is read off a state at a spot; `None` where there is none, or numbers run away.
    pub(super) fn readings(&self, charted: &Ply, strand: &Strand, spot: &Spot) -> Option<Readings> {
        if spot.is_straight() {
            return self.straight(strand, spot);
        }
        let angle = angle_of(spot.place[0]).filter(|_| strand.is_finite())?;
        let (s, c, eps) = (angle.sin(), angle.cos(), spot.hand.sign());
        let theta = Sensed::of(angle.radians(), [(s * c, Sensed::coordinate(spot.place[0], 0))]);
        let second = Sensed::coordinate(spot.place[1], 1);
        let contact = Contact::at_angle(self.strands, angle).ok()?;
        let rho = Sensed::of(contact.radius_ratio(), [(contact.radius_ratio_slope(), theta)]);
        let (sin, cos) = (Sensed::of(s, [(c, theta)]), Sensed::of(c, [(-s, theta)]));
        let (force, moment, stretch, thickness, pressure) = if spot.second == Second::Strain {
            let held = self.stretched(strand, angle, spot)?;
            let alpha = self.axial(strand);
            let parts = |slopes: [f64; 5]| {
                [
                    (slopes[0], theta),
                    (slopes[1], second),
                    (slopes[2], strand.ratio),
                    (slopes[3], strand.twist),
                    (slopes[4], alpha),
                ]
            };
            (
                Sensed::of(held.load.force, parts(held.force_slopes)),
                Sensed::of(held.load.moment, parts(held.moment_slopes)),
                Sensed::constant(1.0) + second,
                Sensed::constant(1.0) - self.thinning * second,
                held.interstrand_pressure,
            )
        } else {
            let (force, moment, state) = self.laid(charted, strand, angle, spot, theta, second)?;
            let one = Sensed::constant(1.0);
            (force, moment, one, one, state.interstrand_pressure())
        };
        let radius_ratio = thickness * rho;
        let readings = Readings {
            force,
            moment,
            extension: stretch * cos,
            rotation: eps * (stretch * sin * radius_ratio.recip()),
            angle: theta,
            radius_ratio,
            outer: radius_ratio + thickness,
            radius: strand.radius,
            bending: strand.bending,
            strand_length: self.strand_length.unwrap_or(f64::NAN),
            hand: spot.hand,
            pressure,
        };
        let all = [readings.force, readings.moment, readings.extension, readings.rotation, readings.radius_ratio];
        all.iter().all(Sensed::is_finite).then_some(readings)
    }

    /// α = EA r²/B.
    pub(super) fn axial(&self, strand: &Strand) -> Sensed {
        strand.axial * strand.radius * strand.radius * strand.bending.recip()
    }

    fn stretched(&self, strand: &Strand, angle: HelicalAngle, spot: &Spot) -> Option<nply::mechanics::TouchingLoads> {
        let alpha = self.axial(strand).value;
        let fibre = StretchingStrand::new(strand.ratio.value, alpha, self.thinning).ok()?;
        ExtensiblePly::new(self.strands, fibre).ok()?.loads_at(angle, spot.hand, spot.place[1], strand.twist()).ok()
    }

    /// The loads of strands that do not stretch: one is the coordinate, the other follows.
    fn laid(
        &self,
        charted: &Ply,
        strand: &Strand,
        angle: HelicalAngle,
        spot: &Spot,
        theta: Sensed,
        second: Sensed,
    ) -> Option<(Sensed, Sensed, Equilibrium)> {
        let ply = charted.with_stiffness_ratio(strand.ratio.value).ok()?;
        let (given, found) = match spot.second {
            Second::Moment => (Variable::Moment, Variable::Force),
            _ => (Variable::Force, Variable::Moment),
        };
        let state = match given {
            Variable::Moment => ply.force_at(angle, spot.hand, strand.twist(), second.value).ok()?,
            _ => ply.moment_at(angle, spot.hand, strand.twist(), second.value).ok()?,
        };
        let sensitivity = state.sensitivity();
        let slope = |by| sensitivity.slope(found, by);
        let value = if found == Variable::Force { state.load().force } else { state.load().moment };
        let other = Sensed::of(
            value,
            [
                (slope(Variable::HelicalAngle)?, theta),
                (slope(Variable::StiffnessRatio).unwrap_or(0.0), strand.ratio),
                (slope(Variable::Twist).unwrap_or(0.0), strand.twist),
                (slope(given)?, second),
            ],
        );
        let (force, moment) = if found == Variable::Force { (other, second) } else { (second, other) };
        Some((force, moment, state))
    }

    /// A spot with the given hand, angle and loads, its second coordinate chosen so that the other load follows well.
    pub(super) fn spot(
        &self,
        strand: &Strand,
        hand: Handedness,
        t: f64,
        [force, moment]: [Option<f64>; 2],
        steep: bool,
    ) -> Spot {
        let (second, value) = match (force, moment) {
            _ if self.stretches() => {
                let c = angle_of(t).map_or(1.0, |angle| angle.cos());
                let strain = force.unwrap_or(0.0) * c / (f64::from(self.strands) * self.axial(strand).value);
                (Second::Strain, if strain.is_finite() { strain.clamp(-0.2, 0.4) } else { 0.0 })
            }
            (_, Some(moment)) if steep || force.is_none() => (Second::Moment, moment),
            (force, _) => (Second::Force, force.unwrap_or(0.0)),
        };
        Spot { hand, second, place: [t, value] }
    }

    /// States under both loads, all of them, of strands that do not stretch; those that do are found from there.
    pub(super) fn states(&self, charted: &Ply, strand: &Strand, [force, moment]: [f64; 2]) -> Vec<Spot> {
        let load = nply::mechanics::Load { force, moment };
        let ply = charted.with_stiffness_ratio(strand.ratio.value);
        let states = ply.and_then(|ply| ply.equilibria(strand.twist(), load)).unwrap_or_default();
        let fit = |state: &&Equilibrium| self.hand.is_none_or(|hand| hand == state.handedness());
        states
            .iter()
            .filter(fit)
            .map(|state| {
                let per_force = state.sensitivity().slope(Variable::Moment, Variable::Force);
                let steep = per_force.is_none_or(|slope| slope.abs() > 3.0);
                let t = place_of(state.contact().angle());
                self.spot(strand, state.handedness(), t, [Some(force), Some(moment)], steep)
            })
            .collect()
    }
}
