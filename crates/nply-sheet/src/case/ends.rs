//! How the ply's ends are held, from whichever datum says so.

use core::f64::consts::TAU;

use nply::mechanics::{Axial, Ends, Grips, Load, Turning};

use super::measure::Measure;
use super::only_one;
use crate::key::Group;
use crate::preferred::six_digits_within;
use crate::spec::{Entry, Spec, Value};
use crate::{Datum, ErrorKind, Quantity, SpecError};

/// What is held, and the datum that says so.
#[derive(Clone, Copy)]
pub(super) struct GivenEnds<'s> {
    held: Held,
    pub(super) entry: &'s Entry,
}

/// A displacement per strand length.
#[derive(Clone, Copy)]
enum Held {
    /// a·d_m
    Rotation(f64),
    /// a·d_f
    Extension(f64),
}

impl GivenEnds<'_> {
    /// a·d_m, where the rotation is held.
    pub(super) fn rotation(&self) -> Option<f64> {
        match self.held {
            Held::Rotation(rotation) => Some(rotation),
            Held::Extension(_) => None,
        }
    }
}

/// What is held, if anything is; `strand_length` is L/r.
pub(super) fn of<'s>(measure: &Measure<'s>, strand_length: Option<f64>) -> Result<Option<GivenEnds<'s>>, SpecError> {
    let Some(entry) = only_one(measure.spec, Group::Ends, "the way the ends are held")? else { return Ok(None) };
    Ok(Some(GivenEnds { held: held(measure, entry, strand_length)?, entry }))
}

fn held(measure: &Measure<'_>, entry: &Entry, strand_length: Option<f64>) -> Result<Held, SpecError> {
    let given = entry.number();
    let turn = if entry.is_measured() { 1.0 } else { TAU };
    let over_length = |value: f64| measure.over_strand_length(entry, value, strand_length);
    let held = match entry.key.datum {
        Datum::PlyRotation => Held::Rotation(over_length(given)?),
        Datum::PlyTurns => Held::Rotation(over_length(turn * given)?),
        Datum::PlyTurnsPerStrandLength => Held::Rotation(turn * measure.dimensionless(entry)?),
        Datum::PlyLength => Held::Extension(over_length(entry.positive(measure.dimensionless(entry)?)?)?),
        _ => Held::Extension(entry.positive(given)?),
    };
    let (Held::Rotation(value) | Held::Extension(value)) = held;
    entry.finite(value)?;
    Ok(held)
}

/// Along the axis and around it, each by itself: a load (0 where absent), or a displacement.
pub(super) fn grips(
    measure: &Measure<'_>,
    strand_length: Option<f64>,
    force: Option<f64>,
    moment: Option<f64>,
) -> Result<Grips, SpecError> {
    let spec = measure.spec;
    let mut grips = Grips::from(Load { force: force.unwrap_or(0.0), moment: moment.unwrap_or(0.0) });
    let mut seen: [Option<&Entry>; 2] = [None; 2];
    for entry in spec.entries.iter().filter(|entry| entry.key.group == Some(Group::Ends)) {
        let held = held(measure, entry, strand_length)?;
        let (side, found) = match held {
            Held::Rotation(rotation) => {
                grips.turning = Turning::Rotation(rotation);
                (0, Datum::Moment)
            }
            Held::Extension(extension) => {
                grips.axial = Axial::Extension(extension);
                (1, Datum::Force)
            }
        };
        if let Some(first) = seen[side].replace(entry) {
            let message =
                format!("{} and {} both hold the ends in one way: remove one of them", first.said(), entry.said());
            return Err(entry.error(ErrorKind::Contradiction, message));
        }
        if let Some(given) = spec.get(found) {
            return Err(found_already(entry, given, held));
        }
    }
    Ok(grips)
}

/// A load is given on the side on which a displacement is held.
fn found_already(entry: &Entry, given: &Entry, held: Held) -> SpecError {
    let held_so = match held {
        Held::Rotation(_) => "ends that cannot turn",
        Held::Extension(_) => "ends held at a distance",
    };
    let message = format!(
        "{} and {} cannot both be given: {held_so} take whatever {} they need, and that is found; remove one of them",
        entry.said(),
        given.said(),
        given.key.name,
    );
    given.error(ErrorKind::Contradiction, message)
}

/// What is given at the ends: dead loads (0 where absent), or a displacement and the load that does no work on it.
pub(super) fn with_loads(
    spec: &Spec,
    ends: Option<GivenEnds<'_>>,
    force: Option<f64>,
    moment: Option<f64>,
) -> Result<Ends, SpecError> {
    let Some(GivenEnds { held, entry }) = ends else {
        return Ok(Ends::Loads(Load { force: force.unwrap_or(0.0), moment: moment.unwrap_or(0.0) }));
    };
    let (found, ends) = match held {
        Held::Rotation(rotation) => (Datum::Moment, Ends::Rotation { rotation, force: force.unwrap_or(0.0) }),
        Held::Extension(extension) => (Datum::Force, Ends::Length { extension, moment: moment.unwrap_or(0.0) }),
    };
    spec.get(found).map_or(Ok(ends), |given| Err(found_already(entry, given, held)))
}

/// A rotation r·rad per strand length in the way in which a datum was written, rounded towards zero, as `12.3 turns`; `radius` is r
/// in m.
pub(super) fn as_written(entry: &Entry, rotation: f64, radius: Option<f64>, strand_length: Option<f64>) -> String {
    let whole = match entry.key.datum {
        Datum::PlyTurnsPerStrandLength if entry.is_measured() => rotation / radius.unwrap_or(1.0),
        Datum::PlyTurnsPerStrandLength => rotation,
        _ => rotation * strand_length.unwrap_or(1.0),
    };
    match &entry.value {
        Value::Quantity(Quantity::Measured { unit, .. }) => format!("{} {unit}", six_digits_within(unit.of_si(whole))),
        _ if entry.key.datum == Datum::PlyTurns => format!("{} turns", six_digits_within(whole / TAU)),
        _ => format!("{} turns per strand radius", six_digits_within(whole / TAU)),
    }
}
