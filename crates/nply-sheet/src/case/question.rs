//! What is asked: whatever of twist, force, moment and shape is not given.

use nply::mechanics::{Balance, ExtensiblePly, Load, Twist};

use super::Question;
use super::ends::{self, GivenEnds};
use super::lay::GivenLay;
use super::measure::Measure;
use super::support::GivenSupport;
use crate::spec::{Entry, Value};
use crate::{Datum, ErrorKind, SpecError, Table};

/// The one question that the given data leave open.
pub(super) fn of(
    measure: &Measure<'_>,
    twist: Option<Twist>,
    lay: Option<GivenLay<'_>>,
    ends: Option<GivenEnds<'_>>,
    support: Option<GivenSupport<'_>>,
) -> Result<Question, SpecError> {
    let spec = measure.spec;
    let [force, moment] = loads(measure)?;
    let twist_missing = |or: &str| twist_missing(measure, or);
    if let Some(support) = support {
        support.check(measure, lay)?;
        let ends = ends::with_loads(spec, ends, force, moment)?;
        let twist = twist.ok_or_else(|| twist_missing(""))?;
        return Ok(Question::Supported { twist, ends, core_radius: support.core_radius });
    }
    if let Some(ends) = ends {
        held_alone(measure, ends, lay)?;
        let ends = ends::with_loads(spec, Some(ends), force, moment)?;
        return Ok(Question::Held { twist: twist.ok_or_else(|| twist_missing(""))?, ends });
    }
    if let Some(separation) = spec.get(Datum::Separation)
        && separation.value == Value::Switch(true)
    {
        return at_separation(measure, separation, force, moment, twist, lay, twist_missing);
    }
    let Some(GivenLay { lay, hand, entry: lay_entry }) = lay else {
        let twist = twist.ok_or_else(|| twist_missing("; or give the lay, and the twist is found"))?;
        return Ok(Question::States {
            twist,
            load: Load { force: force.unwrap_or(0.0), moment: moment.unwrap_or(0.0) },
        });
    };
    match (twist, force, moment) {
        (None, None, None) => Ok(Question::PretwistAt { lay, hand, load: Load::NONE }),
        (None, Some(force), Some(moment)) => Ok(Question::PretwistAt { lay, hand, load: Load { force, moment } }),
        (Some(twist), Some(force), None) => Ok(Question::MomentAt { lay, hand, twist, force }),
        (Some(twist), None, Some(moment)) => Ok(Question::ForceAt { lay, hand, twist, moment }),
        (Some(_), Some(_), Some(_)) => {
            let twist = spec.first_of(Table::Twist).map(Entry::said).unwrap_or_default();
            let message = format!(
                "too many data: the lay and two of twist, force and moment determine the third; remove one of {}, {twist}, {} and {}",
                lay_entry.said(),
                spec.call(Datum::Force),
                spec.call(Datum::Moment),
            );
            Err(lay_entry.error(ErrorKind::Contradiction, message))
        }
        _ => {
            let (given, datum) = match (twist, force) {
                (Some(_), _) => (spec.first_of(Table::Twist), Datum::Force),
                (None, Some(_)) => (spec.get(Datum::Force), Datum::Moment),
                (None, None) => (spec.get(Datum::Moment), Datum::Force),
            };
            let others = match twist {
                Some(_) => format!("{} or {}", spec.call(Datum::Force), spec.call(Datum::Moment)),
                None => format!("{} or a twist", spec.call(datum)),
            };
            let message = format!(
                "beside {} two of twist, force and moment are needed, and the third is found; only {} is given: add {others} (0 if there is none), or leave the lay out and have it found",
                lay_entry.said(),
                given.map(Entry::said).unwrap_or_default(),
            );
            Err(spec.missing(datum, message))
        }
    }
}

/// The states of strands that stretch.
pub(super) fn stretched(
    measure: &Measure<'_>,
    ply: ExtensiblePly,
    twist: Option<Twist>,
    lay: Option<GivenLay<'_>>,
    support: Option<GivenSupport<'_>>,
    strand_length: Option<f64>,
) -> Result<Question, SpecError> {
    if let Some(support) = support {
        support.check(measure, lay)?;
    }
    let [force, moment] = loads(measure)?;
    let grips = ends::grips(measure, strand_length, force, moment)?;
    Ok(Question::Stretched { ply, twist: twist.ok_or_else(|| twist_missing(measure, ""))?, grips })
}

/// Force and moment, where they are given.
fn loads(measure: &Measure<'_>) -> Result<[Option<f64>; 2], SpecError> {
    let load = |datum| measure.spec.get(datum).map(|entry| measure.dimensionless(entry)).transpose();
    Ok([load(Datum::Force)?, load(Datum::Moment)?])
}

fn twist_missing(measure: &Measure<'_>, or: &str) -> SpecError {
    let spec = measure.spec;
    let message = format!(
        "the twist is missing: give {}, or {}, {}, {}, {} or {}{or}",
        spec.ask_for(Datum::Pretwist),
        spec.call(Datum::SurfaceAngle),
        spec.call(Datum::TurnsPerLength),
        spec.call(Datum::Turns),
        spec.call(Datum::EndRotation),
        spec.call(Datum::StrandTwist),
    );
    spec.missing(Datum::Pretwist, message)
}

/// What cannot be given beside ends that are held.
fn held_alone(measure: &Measure<'_>, ends: GivenEnds<'_>, lay: Option<GivenLay<'_>>) -> Result<(), SpecError> {
    let separation = measure.spec.get(Datum::Separation).filter(|entry| entry.value == Value::Switch(true));
    let message = |why: &str, other: &Entry| {
        let message = format!("{} {why}, and so does {}: remove one of them", ends.entry.said(), other.said());
        Err(ends.entry.error(ErrorKind::Contradiction, message))
    };
    match (lay, separation) {
        (Some(GivenLay { entry, .. }), _) => message("gives the shape of the ply", entry),
        (None, Some(separation)) => message("finds the load that goes with it", separation),
        (None, None) => Ok(()),
    }
}

/// `separation = true`: the load at which the strands just stop pressing on each other.
fn at_separation(
    measure: &Measure<'_>,
    separation: &Entry,
    force: Option<f64>,
    moment: Option<f64>,
    twist: Option<Twist>,
    lay: Option<GivenLay<'_>>,
    twist_missing: impl Fn(&str) -> SpecError,
) -> Result<Question, SpecError> {
    if let Some(GivenLay { entry: lay, .. }) = lay {
        let message = format!(
            "{} asks for the shape at which strands part, and {} gives it: remove one of them",
            separation.said(),
            lay.said()
        );
        return Err(separation.error(ErrorKind::Contradiction, message));
    }
    if let Some(pressure) = measure.spec.get(Datum::ExternalPressure) {
        let message =
            format!("{} and {} cannot be asked together: remove one of them", separation.said(), pressure.said());
        return Err(separation.error(ErrorKind::Contradiction, message));
    }
    let call = |datum| measure.spec.call(datum);
    match (force, moment) {
        (Some(_), Some(_)) => {
            let message = format!(
                "{} finds one of {} and {}, but both are given: remove the one to be found",
                separation.said(),
                call(Datum::Force),
                call(Datum::Moment)
            );
            Err(separation.error(ErrorKind::Contradiction, message))
        }
        (None, None) => {
            let message = format!(
                "{} needs one load, and finds the other: give {} or {} (0 if there is none)",
                separation.said(),
                call(Datum::Force),
                call(Datum::Moment)
            );
            Err(separation.error(ErrorKind::Missing, message))
        }
        (Some(force), None) => {
            Ok(Question::SeparationAtForce { twist: twist.ok_or_else(|| twist_missing(""))?, force })
        }
        (None, Some(moment)) => {
            Ok(Question::SeparationAtMoment { twist: twist.ok_or_else(|| twist_missing(""))?, moment })
        }
    }
}

/// p r³/B from outside, outward positive.
pub(super) fn external_pressure(measure: &Measure<'_>, balance: Balance) -> Result<Option<f64>, SpecError> {
    let Some(entry) = measure.spec.get(Datum::ExternalPressure) else { return Ok(None) };
    if balance != Balance::Contact {
        let message = format!(
            "{} is carried in the contact balance only: set {} to contact, or remove it",
            entry.said(),
            measure.spec.call(Datum::Balance)
        );
        return Err(entry.error(ErrorKind::Contradiction, message));
    }
    measure.dimensionless(entry).map(Some)
}
