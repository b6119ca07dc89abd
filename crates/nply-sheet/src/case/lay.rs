//! The shape of the ply, from whichever datum gives it, and the hand.

use core::f64::consts::{FRAC_PI_2, TAU};

use nply::Handedness;

use super::measure::Measure;
use super::{Lay, helix, only_one};
use crate::key::Group;
use crate::spec::{Entry, Spec, Value};
use crate::{Datum, ErrorKind, SpecError};

/// A lay, the hand if one is given, and the datum that gave the lay.
#[derive(Clone, Copy)]
pub(super) struct GivenLay<'s> {
    pub(super) lay: Lay,
    pub(super) hand: Option<Handedness>,
    pub(super) entry: &'s Entry,
}

/// Whether a lay is given at all.
pub(super) fn is_given(spec: &Spec) -> bool {
    spec.entries.iter().any(|entry| entry.key.group == Some(Group::Lay)) || spec.get(Datum::HelixRadius).is_some()
}

/// The lay, if one is given.
pub(super) fn of<'s>(measure: &Measure<'s>) -> Result<Option<GivenLay<'s>>, SpecError> {
    let hand = match measure.spec.get(Datum::Hand) {
        Some(entry @ Entry { value: Value::Hand(hand), .. }) => Some((*hand, entry)),
        _ => None,
    };
    let other = only_one(measure.spec, Group::Lay, "the lay of the ply")?;
    helix::check(measure.spec, other)?;
    let Some(entry) = other.or_else(|| measure.spec.get(Datum::HelixRadius)) else {
        return match hand {
            Some((_, entry)) => {
                let message = format!(
                    "{} belongs to a given lay; without one the hand is an answer: remove it, or give {}",
                    entry.said(),
                    measure.spec.ask_for(Datum::LayLength),
                );
                Err(entry.error(ErrorKind::Contradiction, message))
            }
            None => Ok(None),
        };
    };
    let given = entry.number();
    let refuse = |why: &str| Err(entry.error(ErrorKind::Domain, format!("{}: {why}", entry.said())));
    let hand_by = format!("the hand is given by {}", measure.spec.call(Datum::Hand));
    // a negative length is most likely meant as a hand
    let positive = |value: f64| entry.positive(value).map_err(|refused| refused.with_help(Some(hand_by.clone())));
    let mut winds = hand.map(|(hand, _)| hand);
    let lay = match entry.key.datum {
        Datum::HelicalAngle | Datum::LayAngle => {
            if !(0.0..FRAC_PI_2).contains(&given) {
                return refuse(&format!("a helical angle must be at least 0 and less than 90 degrees; {hand_by}"));
            }
            Lay::HelicalAngle(given)
        }
        Datum::PitchAngle => {
            if !(given > 0.0 && given <= FRAC_PI_2) {
                return refuse(&format!("a pitch angle must be greater than 0 and at most 90 degrees; {hand_by}"));
            }
            Lay::PitchAngle(given)
        }
        Datum::LayLength => Lay::LayLength(positive(measure.dimensionless(entry)?)?),
        Datum::PlyTurnsPerLength => {
            let per_radius = measure.dimensionless(entry)?;
            if per_radius == 0.0 {
                return refuse(
                    "a ply without turns has no lay length; for straight strands give helical_angle = \"0 deg\"",
                );
            }
            let sign = if per_radius > 0.0 { Handedness::Right } else { Handedness::Left };
            if let Some((hand, said)) = hand
                && hand != sign
            {
                let message =
                    format!("{} and the sign of {} say opposite hands: correct one of them", said.said(), entry.said());
                return Err(entry.error(ErrorKind::Contradiction, message));
            }
            winds = Some(sign);
            let turn = if entry.is_measured() { TAU } else { 1.0 };
            Lay::LayLength(entry.finite(turn / per_radius.abs())?)
        }
        Datum::LayRatio => Lay::LayRatio(positive(given)?),
        Datum::CoreRadius => Lay::RadiusRatio(1.0 + entry.positive(measure.dimensionless(entry)?)?),
        Datum::CoreDiameter => Lay::RadiusRatio(1.0 + entry.positive(measure.dimensionless(entry)?)? / 2.0),
        Datum::HelixRadius => Lay::RadiusRatio(entry.positive(measure.dimensionless(entry)?)?),
        _ => Lay::RadiusRatio(entry.positive(given)?),
    };
    Ok(Some(GivenLay { lay, hand: winds, entry }))
}
