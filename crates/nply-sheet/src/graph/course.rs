//! Every state along a datum, as curves of a parameter of their own.

use nply::Handedness;
use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Along, Data, Ends, Equilibrium, Load, Ply, Twist};

use crate::map::{Axis, MapDatum};
use crate::plot::sample::steps;
use crate::report::Measure;
use crate::{Case, Lay, Question};

/// How states are found.
#[derive(Clone, Debug)]
pub(super) enum Course {
    /// The datum is explicit in the angle, which is the parameter, in degrees.
    Angle { ply: Ply, datum: Given },
    /// What is held fixes the angle whatever the datum, which is the parameter.
    Value { ply: Ply, data: Data, axis: Axis, hold: Vec<(Handedness, HelicalAngle)> },
    /// The lay is the parameter.
    Lay { case: Box<Case>, from: Lay, to: Lay },
}

/// A datum that is explicit in the angle, and what is given besides.
#[derive(Clone, Copy, Debug)]
pub(super) enum Given {
    Load { along: Along, twist: Twist, load: Load },
    Rotation { twist: Twist, force: f64 },
    Extension { twist: Twist, moment: f64 },
}

/// A curve's datum and state at its parameter.
pub(super) type Place = (f64, Equilibrium);

impl Course {
    pub(super) fn of(ply: Ply, data: &Data, axis: Axis) -> Self {
        let twist = data.twist;
        match (axis.datum, axis.datum.along(), data.ends) {
            (MapDatum::Rotation, _, Ends::Rotation { force, .. }) => {
                Self::Angle { ply, datum: Given::Rotation { twist, force } }
            }
            (MapDatum::Extension, _, Ends::Length { moment, .. }) => {
                Self::Angle { ply, datum: Given::Extension { twist, moment } }
            }
            (_, Some(along), Ends::Loads(load)) => Self::Angle { ply, datum: Given::Load { along, twist, load } },
            _ => {
                let data = axis.datum.set(*data, axis.from);
                let hold = states(&ply, &data, &axis, axis.from)
                    .iter()
                    .map(|state| (state.handedness(), state.contact().angle()))
                    .collect();
                Self::Value { ply, data, axis, hold }
            }
        }
    }

    pub(super) fn lay(case: Case, from: Lay, to: Lay) -> Self {
        Self::Lay { case: Box::new(case), from, to }
    }

    /// How many curves it has of a hand.
    pub(super) fn curves(&self, hand: Handedness) -> usize {
        match self {
            Self::Value { hold, .. } => hold.iter().filter(|(side, _)| *side == hand).count(),
            _ => 1,
        }
    }

    /// Parameters that none of its features slips through.
    pub(super) fn parameters(&self, logarithmic: bool) -> Vec<f64> {
        match self {
            Self::Angle { .. } => {
                // closer together at both ends, where straight strands and flat rings are approached as squares
                let ends = [1e-6, 1e-3, 1e-2, 0.1, 0.25];
                let inner = steps(0.5, 89.5, 178);
                ends.into_iter().chain(inner).chain(ends.into_iter().rev().map(|end| 90.0 - end)).collect()
            }
            Self::Value { axis, .. } => steps(axis.from, axis.to, 60),
            Self::Lay { from, to, .. } => {
                let (from, to) = (size(*from), size(*to));
                if logarithmic && from > 0.0 && to > 0.0 {
                    let ends = [from, to].map(libm::log);
                    let inner = steps(ends[0], ends[1], 120).into_iter().map(libm::exp);
                    // both ends exactly
                    return core::iter::once(from).chain(inner.skip(1).take(119)).chain([to]).collect();
                }
                steps(from, to, 120)
            }
        }
    }

    /// Curve number `k` of a hand at its parameter.
    pub(super) fn at(&self, hand: Handedness, k: usize, parameter: f64) -> Option<Place> {
        match self {
            Self::Angle { ply, datum } => {
                let angle = if parameter > 45.0 {
                    HelicalAngle::from_pitch_angle((90.0 - parameter).to_radians())
                } else {
                    HelicalAngle::new(parameter.to_radians())
                };
                datum.at(ply, angle.ok()?, hand)
            }
            Self::Value { ply, data, axis, .. } => {
                let found = states(ply, data, axis, parameter);
                let mut found = found.into_iter().filter(|state| state.handedness() == hand);
                Some((parameter, found.nth(k)?))
            }
            Self::Lay { case, from, .. } => {
                let lay = of_size(*from, parameter);
                let mut case = case.clone();
                let place = match &mut case.question {
                    Question::MomentAt { lay, .. }
                    | Question::ForceAt { lay, .. }
                    | Question::PretwistAt { lay, .. } => lay,
                    _ => return None,
                };
                *place = lay;
                let states = case.solve().ok()?.states;
                Some((parameter, states.into_iter().find(|state| state.handedness() == hand)?))
            }
        }
    }
}

impl Given {
    fn at(self, ply: &Ply, angle: HelicalAngle, hand: Handedness) -> Option<Place> {
        match self {
            Self::Load { along, twist, load } => {
                let contact = Contact::at_angle(ply.strands(), angle).ok()?;
                ply.equilibrium_along(along, contact, hand, twist, load).ok()
            }
            Self::Rotation { twist, force } => {
                let state = ply.moment_at(angle, hand, twist, force).ok()?;
                Some((state.rotation(), state))
            }
            Self::Extension { twist, moment } => {
                let state = ply.force_at(angle, hand, twist, moment).ok()?;
                Some((state.extension(), state))
            }
        }
    }
}

fn states(ply: &Ply, data: &Data, axis: &Axis, value: f64) -> Vec<Equilibrium> {
    let data = axis.datum.set(*data, value);
    let ply = Ply::with_balance(ply.strands(), data.stiffness_ratio, ply.balance());
    ply.and_then(|ply| ply.equilibria_held(data.twist, data.ends)).unwrap_or_default()
}

/// A lay's number.
pub(super) const fn size(lay: Lay) -> f64 {
    match lay {
        Lay::HelicalAngle(size)
        | Lay::PitchAngle(size)
        | Lay::LayLength(size)
        | Lay::LayRatio(size)
        | Lay::RadiusRatio(size) => size,
    }
}

/// A lay of the same kind.
const fn of_size(lay: Lay, size: f64) -> Lay {
    match lay {
        Lay::HelicalAngle(_) => Lay::HelicalAngle(size),
        Lay::PitchAngle(_) => Lay::PitchAngle(size),
        Lay::LayLength(_) => Lay::LayLength(size),
        Lay::LayRatio(_) => Lay::LayRatio(size),
        Lay::RadiusRatio(_) => Lay::RadiusRatio(size),
    }
}

/// Its name in tables, for a reader, and its measure.
pub(super) const fn words(lay: Lay) -> (&'static str, &'static str, Measure) {
    match lay {
        Lay::HelicalAngle(_) => ("helical_angle", "helical angle", Measure::Degrees),
        Lay::PitchAngle(_) => ("pitch_angle", "pitch angle", Measure::Degrees),
        Lay::LayLength(_) => ("lay_length", "lay length", Measure::Length),
        Lay::LayRatio(_) => ("lay_ratio", "lay length/outer diameter", Measure::Number),
        Lay::RadiusRatio(_) => ("radius_ratio", "helix radius/strand radius", Measure::Number),
    }
}
