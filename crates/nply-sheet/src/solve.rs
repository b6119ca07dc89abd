//! From the case to its states.

use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Balance, Equilibrium, Ply};
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
        let on = |lay: Lay, hand: Option<Handedness>, state: &dyn Fn(HelicalAngle, Handedness) -> Found| {
            let angle = lay.contact(self.strands)?.angle();
            let hands = match hand {
                Some(hand) => vec![hand],
                None if angle.sin() == 0.0 => vec![Handedness::Right], // straight strands are one state
                None => Handedness::BOTH.to_vec(),
            };
            hands.into_iter().map(|hand| state(angle, hand)).collect::<Result<Vec<_>, _>>()
        };
        let mut straight = None;
        let mut other_balance = None;
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
            Question::MomentAt { lay, hand, twist, force } => {
                on(lay, hand, &|angle, hand| ply.moment_at(angle, hand, twist, force))?
            }
            Question::ForceAt { lay, hand, twist, moment } => {
                on(lay, hand, &|angle, hand| ply.force_at(angle, hand, twist, moment))?
            }
            Question::PretwistAt { lay, hand, load } => {
                on(lay, hand, &|angle, hand| ply.pretwist_at(angle, hand, load))?
            }
            Question::SeparationAtForce { twist, force } => ply.separation_at_force(twist, force)?,
            Question::SeparationAtMoment { twist, moment } => ply.separation_at_moment(twist, moment)?,
        };
        Ok(Solution { states, straight, other_balance })
    }

    fn ply(&self, balance: Balance) -> Result<Ply, DomainError> {
        let ply = Ply::with_balance(self.strands, self.stiffness_ratio, balance)?;
        self.external_pressure.map_or(Ok(ply.clone()), |pressure| ply.with_external_pressure(pressure))
    }
}

type Found = Result<Equilibrium, DomainError>;
