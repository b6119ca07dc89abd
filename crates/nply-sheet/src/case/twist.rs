//! The twist put into the strands, from whichever datum gives it.

use core::f64::consts::{FRAC_PI_2, TAU};

use nply::mechanics::Twist;

use super::measure::Measure;
use super::only_one;
use crate::key::Group;
use crate::spec::Entry;
use crate::{Datum, ErrorKind, SpecError};

/// The twist, if one is given; `strand_length` is L/r.
pub(super) fn of(measure: &Measure<'_>, strand_length: Option<f64>) -> Result<Option<Twist>, SpecError> {
    let Some(entry) = only_one(measure.spec, Group::Twist, "the twist")? else { return Ok(None) };
    // φ̄a = rotation·r/L
    let over_length = |entry: &Entry, rotation: f64| measure.over_strand_length(entry, rotation, strand_length);
    let given = entry.number();
    let twist = match entry.key.datum {
        Datum::SurfaceAngle => {
            if !(given > -FRAC_PI_2 && given < FRAC_PI_2) {
                let message = format!("{}: a stripe on the strand stands between -90 and 90 degrees", entry.said());
                return Err(entry.error(ErrorKind::Domain, message));
            }
            Twist::Pretwist(libm::tan(given)) // (49)
        }
        Datum::TurnsPerLength => {
            let per_radius = measure.dimensionless(entry)?;
            Twist::Pretwist(if entry.is_measured() { per_radius } else { TAU * per_radius })
        }
        Datum::Turns => Twist::Pretwist(over_length(entry, if entry.is_measured() { given } else { TAU * given })?),
        Datum::EndRotation => Twist::Pretwist(over_length(entry, given)?),
        Datum::StrandTwist => Twist::StrandTwist(twist_of_strand(measure, entry)?),
        _ => Twist::Pretwist(given),
    };
    let (Twist::Pretwist(value) | Twist::StrandTwist(value)) = twist;
    entry.finite(value)?;
    if measure.radius.is_some() {
        entry.measurable(value)?;
    }
    Ok(Some(twist))
}

/// r u₃: always a number, so that a bare one stands for itself whether or not the strand has a radius.
fn twist_of_strand(measure: &Measure<'_>, entry: &Entry) -> Result<f64, SpecError> {
    if entry.is_measured() { measure.dimensionless(entry) } else { Ok(entry.number()) }
}
