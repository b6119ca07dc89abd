//! From the case to its states.

use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{
    Axial, Balance, Ends, Equilibrium, ExtensiblePly, ExtensibleState, Grips, Load, Ply, Support, SupportedState,
    Turning, Twist, Wedge,
};
use nply::{DomainError, Handedness};

use crate::{Case, Lay, Question};

/// Every state that answers a case.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Solution {
    /// The states, right-handed first, then by angle. Empty where nothing is in equilibrium.
    pub states: Vec<Equilibrium>,
    /// Whether straight strands side by side are in equilibrium too (θ = 0); `None` where the shape was given.
    pub straight: Option<bool>,
    /// The same case in the other balance, where that was asked of all angles and no pressure acts from outside.
    pub other_balance: Option<Vec<Equilibrium>>,
    /// Where it was asked what carries the strands, the answer to that; `states` is empty then.
    pub supported: Option<Supported>,
    /// The same of strands that stretch.
    pub stretched: Option<Supported<ExtensibleState>>,
}

/// What carries the strands, and under which loads that changes.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Supported<S = SupportedState> {
    /// Every state in which all closed contacts push, right-handed first, then by angle.
    pub states: Vec<S>,
    /// The loads under which neighbours and core both carry, right-handed first; empty without a core, where touching strands
    /// cannot lie on it, and where strands stretch.
    pub wedges: Vec<Wedge>,
    /// Where touching strands that are clear of the core part, and where strands lift off the core, under the force given; the moment is
    /// found.
    pub openings_at_force: Vec<Opening>,
    /// The same under the moment given; the force is found.
    pub openings_at_moment: Vec<Opening>,
}

/// The states of a case, of whatever strands.
#[derive(Clone, Debug)]
pub(crate) enum States {
    Touching(Vec<Equilibrium>),
    Supported(Vec<SupportedState>),
    Stretched(Vec<ExtensibleState>),
}

/// Where a contact just stops pressing, and nothing else carries the strands.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Opening {
    /// What lets go: [`Support::Neighbours`] or [`Support::Core`].
    pub lets_go: Support,
    /// Which way the ply winds.
    pub handedness: Handedness,
    /// θ.
    pub angle: HelicalAngle,
    /// ρ = R/r.
    pub radius_ratio: f64,
    /// f and m.
    pub load: Load,
}

impl Opening {
    fn of_neighbours(state: &Equilibrium) -> Self {
        Self {
            lets_go: Support::Neighbours,
            handedness: state.handedness(),
            angle: state.contact().angle(),
            radius_ratio: state.contact().radius_ratio(),
            load: state.load(),
        }
    }

    /// With the load that is kept as it was given, without the rounding of its way back.
    fn of_stretched(state: &ExtensibleState, force: Option<f64>, moment: Option<f64>) -> Self {
        let found = state.load();
        Self {
            lets_go: state.support(),
            handedness: state.handedness(),
            angle: state.angle(),
            radius_ratio: state.radius_ratio(),
            load: Load { force: force.unwrap_or(found.force), moment: moment.unwrap_or(found.moment) },
        }
    }

    fn of_core(state: &SupportedState) -> Self {
        Self {
            lets_go: Support::Core,
            handedness: state.handedness(),
            angle: state.angle(),
            radius_ratio: state.radius_ratio(),
            load: state.load(),
        }
    }
}

impl Lay {
    /// The contact that this lay asks for.
    ///
    /// # Errors
    /// [`DomainError`] for a lay that no ply of so many strands can have.
    ///
    /// ```
    /// use nply_sheet::Lay;
    /// assert!((Lay::RadiusRatio(2.1).contact(6)?.angle().degrees() - 20.0).abs() < 0.05);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn contact(self, strands: u32) -> Result<Contact, DomainError> {
        match self {
            Self::HelicalAngle(angle) => Contact::new(strands, angle),
            Self::PitchAngle(angle) => Contact::at_angle(strands, HelicalAngle::from_pitch_angle(angle)?),
            Self::LayLength(length) => Contact::from_lay_length(strands, length),
            Self::LayRatio(ratio) => Contact::from_lay_ratio(strands, ratio),
            Self::RadiusRatio(ratio) => Contact::from_radius_ratio(strands, ratio),
        }
    }
}

impl Case {
    /// Every state that answers the case.
    ///
    /// # Errors
    /// [`DomainError`] where a premise is broken, such as a lay that no ply can have; [`Case::locate`] finds its place.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// let case = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-1")])?.check()?;
    /// let states = case.solve()?.states;
    /// assert!((states[0].contact().angle().degrees() - 30.6130).abs() < 5e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn solve(&self) -> Result<Solution, DomainError> {
        let ply = self.ply(self.balance)?;
        let mut straight = None;
        let mut other_balance = None;
        let mut supported = None;
        let mut stretched = None;
        let states = match self.question {
            Question::States { twist, load } => {
                straight = Some(ply.straight_holds(twist, load));
                if self.external_pressure.is_none() {
                    let other = match self.balance {
                        Balance::Contact => Balance::Radial,
                        Balance::Radial => Balance::Contact,
                    };
                    other_balance = Some(self.ply(other)?.equilibria(twist, load)?);
                }
                ply.equilibria(twist, load)?
            }
            Question::Supported { twist, ends, core_radius } => {
                if let Ends::Loads(load) = ends {
                    straight = Some(ply.straight_holds(twist, load));
                }
                supported = Some(Supported::of(&ply, twist, ends, core_radius)?);
                Vec::new()
            }
            Question::Stretched { ply, twist, grips } => {
                stretched = Some(Supported::of_stretched(&ply, twist, grips)?);
                Vec::new()
            }
            _ => self.touching(&ply)?,
        };
        Ok(Solution { states, straight, other_balance, supported, stretched })
    }

    /// The states alone, without what a report says besides.
    pub(crate) fn states(&self) -> Result<States, DomainError> {
        Ok(match self.question {
            Question::Supported { twist, ends, core_radius } => {
                States::Supported(self.ply(self.balance)?.supported_states(twist, ends, core_radius)?)
            }
            Question::Stretched { ply, twist, grips } => States::Stretched(ply.states(twist, grips)?),
            _ => States::Touching(self.touching(&self.ply(self.balance)?)?),
        })
    }

    /// The states of strands that touch their neighbours; none where the question is another.
    fn touching(&self, ply: &Ply) -> Result<Vec<Equilibrium>, DomainError> {
        let on = |lay: Lay, hand: Option<Handedness>, state: &dyn Fn(HelicalAngle, Handedness) -> Found| {
            let angle = lay.contact(self.strands)?.angle();
            let hands = match hand {
                Some(hand) => vec![hand],
                None if angle.sin() == 0.0 => vec![Handedness::Right], // straight strands are one state
                None => Handedness::BOTH.to_vec(),
            };
            hands.into_iter().map(|hand| state(angle, hand)).collect::<Result<Vec<_>, _>>()
        };
        match self.question {
            Question::States { twist, load } => ply.equilibria(twist, load),
            Question::MomentAt { lay, hand, twist, force } => {
                on(lay, hand, &|angle, hand| ply.moment_at(angle, hand, twist, force))
            }
            Question::ForceAt { lay, hand, twist, moment } => {
                on(lay, hand, &|angle, hand| ply.force_at(angle, hand, twist, moment))
            }
            Question::PretwistAt { lay, hand, load } => {
                on(lay, hand, &|angle, hand| ply.pretwist_at(angle, hand, load))
            }
            Question::SeparationAtForce { twist, force } => ply.separation_at_force(twist, force),
            Question::SeparationAtMoment { twist, moment } => ply.separation_at_moment(twist, moment),
            Question::Held { twist, ends } => ply.equilibria_held(twist, ends),
            Question::Supported { .. } | Question::Stretched { .. } => Ok(Vec::new()),
        }
    }

    pub(crate) fn ply(&self, balance: Balance) -> Result<Ply, DomainError> {
        let ply = Ply::with_balance(self.strands, self.stiffness_ratio, balance)?;
        self.external_pressure.map_or(Ok(ply.clone()), |pressure| ply.with_external_pressure(pressure))
    }
}

impl Supported {
    fn of(ply: &Ply, twist: Twist, ends: Ends, core_radius: Option<f64>) -> Result<Self, DomainError> {
        let wedges = core_radius.map(|core| ply.wedges(twist, core)).transpose()?.flatten();
        // a core in the way takes the place of the neighbours before these part
        let least = 1.0 + core_radius.unwrap_or(0.0);
        let openings = |parted: Vec<Equilibrium>, lifted: Vec<SupportedState>| -> Vec<Opening> {
            let clear = parted.iter().filter(|state| state.contact().radius_ratio() >= least);
            clear.map(Opening::of_neighbours).chain(lifted.iter().map(Opening::of_core)).collect()
        };
        let (force, moment) = match ends {
            Ends::Loads(load) => (Some(load.force), Some(load.moment)),
            Ends::Rotation { force, .. } => (Some(force), None),
            Ends::Length { moment, .. } => (None, Some(moment)),
        };
        let lift = |lifted: &dyn Fn(f64) -> Result<Vec<SupportedState>, DomainError>| {
            core_radius.map_or(Ok(Vec::new()), lifted)
        };
        let at_force = |force| -> Result<Vec<Opening>, DomainError> {
            let lifted = lift(&|core| ply.lift_off_at_force(twist, force, core))?;
            Ok(openings(ply.separation_at_force(twist, force)?, lifted))
        };
        let at_moment = |moment| -> Result<Vec<Opening>, DomainError> {
            let lifted = lift(&|core| ply.lift_off_at_moment(twist, moment, core))?;
            Ok(openings(ply.separation_at_moment(twist, moment)?, lifted))
        };
        Ok(Self {
            states: ply.supported_states(twist, ends, core_radius)?,
            wedges: wedges.map(Vec::from).unwrap_or_default(),
            openings_at_force: force.map_or(Ok(Vec::new()), at_force)?,
            openings_at_moment: moment.map_or(Ok(Vec::new()), at_moment)?,
        })
    }
}

impl Supported<ExtensibleState> {
    fn of_stretched(ply: &ExtensiblePly, twist: Twist, grips: Grips) -> Result<Self, DomainError> {
        let supports: &[Support] =
            if ply.core().is_some() { &[Support::Neighbours, Support::Core] } else { &[Support::Neighbours] };
        let (mut openings_at_force, mut openings_at_moment) = (Vec::new(), Vec::new());
        for support in supports {
            if let Axial::Force(force) = grips.axial {
                let parted = ply.parting_at_force(*support, twist, force)?;
                openings_at_force.extend(parted.iter().map(|s| Opening::of_stretched(s, Some(force), None)));
            }
            if let Turning::Moment(moment) = grips.turning {
                let parted = ply.parting_at_moment(*support, twist, moment)?;
                openings_at_moment.extend(parted.iter().map(|s| Opening::of_stretched(s, None, Some(moment))));
            }
        }
        let states = ply.states(twist, grips)?;
        Ok(Self { states, wedges: Vec::new(), openings_at_force, openings_at_moment })
    }
}

type Found = Result<Equilibrium, DomainError>;
