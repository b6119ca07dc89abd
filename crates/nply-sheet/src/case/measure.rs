//! Taking the units off: every datum measured by the strand itself.

use nply::Scale;

use crate::spec::{Entry, Spec, Value};
use crate::{Datum, ErrorKind, Kind, Quantity, SpecError};

/// The strand as a measure: lengths by r, forces by B/r², as far as r and B are known.
pub(super) struct Measure<'s> {
    pub(super) spec: &'s Spec,
    pub(super) radius: Option<f64>,
    pub(super) scale: Option<Scale>,
}

impl Measure<'_> {
    /// The size, in SI, of the dimensionless 1 of a kind.
    fn unit(&self, kind: Kind) -> Option<f64> {
        match kind {
            Kind::Length => self.radius,
            Kind::TurnsPerLength | Kind::Twist => self.radius.map(|radius| 1.0 / radius),
            Kind::Force => self.scale.map(|scale| scale.force(1.0)),
            Kind::Moment => self.scale.map(|scale| scale.moment(1.0)),
            Kind::ForcePerLength => self.scale.map(|scale| scale.force_per_length(1.0)),
            _ => Some(1.0),
        }
    }

    /// A datum, dimensionless. Turns per length stay as they are written when bare, and are in rad when measured.
    pub(super) fn dimensionless(&self, entry: &Entry) -> Result<f64, SpecError> {
        let kind = entry.key.kind;
        let Value::Quantity(quantity) = &entry.value else { return Ok(f64::NAN) };
        match (quantity, self.unit(kind)) {
            (Quantity::Measured { si, .. }, Some(unit)) => entry.measurable(entry.finite(si / unit)?),
            (Quantity::Measured { .. }, None) => Err(self.no_measure(entry)),
            (Quantity::Bare(value), None) => Ok(*value),
            // nothing is nothing in every unit
            (Quantity::Bare(value), Some(_)) if *value == 0.0 => Ok(*value),
            (Quantity::Bare(_), Some(_)) => Err(entry.error(
                ErrorKind::WrongUnit,
                format!("{} has no unit, but the strand has: what is wanted is {}", entry.said(), kind.wanted()),
            )),
        }
    }

    /// A unit was written, but the strand has none to measure it by.
    pub(super) fn no_measure(&self, entry: &Entry) -> SpecError {
        let ask = |datum| self.spec.ask_for(datum);
        let (missing, bare) = match entry.key.kind {
            Kind::Length => (ask(Datum::Radius), "in strand radii"),
            Kind::TurnsPerLength => (ask(Datum::Radius), "in turns per strand radius"),
            Kind::Twist => (ask(Datum::Radius), "in radians per strand radius"),
            kind => {
                let stiffness = format!(
                    "{} (or {}, or {})",
                    ask(Datum::BendingStiffness),
                    self.spec.call(Datum::YoungsModulus),
                    self.spec.call(Datum::BendingPersistenceLength)
                );
                let missing = match self.radius {
                    Some(_) => stiffness,
                    None => format!("{} and {stiffness}", ask(Datum::Radius)),
                };
                let bare = match kind {
                    Kind::Force => "in units of B/r^2",
                    Kind::Moment => "in units of B/r",
                    _ => "in units of B/r^3",
                };
                (missing, bare)
            }
        };
        let message = format!(
            "{} has a unit, but the strand has none to measure it by: give {missing}, or write a bare number {bare}",
            entry.said()
        );
        entry.error(ErrorKind::Missing, message)
    }

    /// A rotation or length of the whole strand or ply, per strand length L/r.
    pub(super) fn over_strand_length(
        &self,
        entry: &Entry,
        value: f64,
        strand_length: Option<f64>,
    ) -> Result<f64, SpecError> {
        let Some(length) = strand_length else {
            let why = match entry.key.kind {
                Kind::Length => format!("without which {} says nothing of the shape", entry.said()),
                _ => format!("over which {} is spread", entry.said()),
            };
            let give = self.spec.ask_for(Datum::StrandLength);
            let message = format!("the strand length is missing, {why}: give {give}");
            return Err(self.spec.missing(Datum::StrandLength, message));
        };
        Ok(value / length)
    }

    /// L/r.
    pub(super) fn strand_length(&self) -> Result<Option<f64>, SpecError> {
        let Some(entry) = self.spec.get(Datum::StrandLength) else { return Ok(None) };
        entry.positive(self.dimensionless(entry)?).map(Some)
    }
}
