//! A datum that runs from one number to another.

use core::f64::consts::TAU;

use nply::mechanics::{Along, Data, Ends, Load, Twist};

use crate::report::{Known, Measure, Reading};
use crate::spec::Entry;
use crate::{Case, ErrorKind, SpecError};

/// A datum that a map can run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "each is the datum of the same name; `label` says it in words")]
#[non_exhaustive]
pub enum MapDatum {
    Force,
    Moment,
    Rotation,
    Extension,
    Pretwist,
    StrandTwist,
    StiffnessRatio,
    CoreRadius,
}

impl MapDatum {
    /// All, in the order of the report.
    pub(super) const ALL: [Self; 8] = [
        Self::Force,
        Self::Moment,
        Self::Rotation,
        Self::Extension,
        Self::Pretwist,
        Self::StrandTwist,
        Self::StiffnessRatio,
        Self::CoreRadius,
    ];

    /// The name in tables, as in JSON elsewhere.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Force => "force",
            Self::Moment => "moment",
            Self::Rotation => "rotation",
            Self::Extension => "extension",
            Self::Pretwist => "pretwist",
            Self::StrandTwist => "strand_twist",
            Self::StiffnessRatio => "stiffness_ratio",
            Self::CoreRadius => "core_radius",
        }
    }

    /// The name for a reader.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::Force => "end force",
            Self::Moment => "end moment",
            Self::Rotation => "turns per strand length",
            Self::Extension => "ply length/strand length",
            Self::Pretwist => "pretwist",
            Self::StrandTwist => "strand twist",
            Self::StiffnessRatio => "stiffness ratio C/B",
            Self::CoreRadius => "core radius",
        }
    }

    /// How a reader reads values of which `largest` is the largest.
    pub(super) fn reading(self, case: &Case, largest: f64) -> Reading {
        let known = Known { scale: case.scale, strand_radius: case.strand_radius };
        match self {
            Self::Rotation => Measure::turning(known, &case.units, largest),
            Self::Pretwist | Self::StrandTwist => Measure::twist(known, &case.units, largest),
            _ => self.measure().reading(known, &case.units, largest),
        }
    }

    const fn measure(self) -> Measure {
        match self {
            Self::Force => Measure::Force,
            Self::Moment => Measure::Moment,
            Self::CoreRadius => Measure::Length,
            _ => Measure::Number,
        }
    }

    /// What it is in some data; `None` where they give no such thing.
    pub(super) fn get(self, data: &Data) -> Option<f64> {
        match (self, data.ends, data.twist) {
            (Self::Force, Ends::Loads(Load { force, .. }) | Ends::Rotation { force, .. }, _) => Some(force),
            (Self::Moment, Ends::Loads(Load { moment, .. }) | Ends::Length { moment, .. }, _) => Some(moment),
            (Self::Rotation, Ends::Rotation { rotation, .. }, _) => Some(rotation),
            (Self::Extension, Ends::Length { extension, .. }, _) => Some(extension),
            (Self::Pretwist, _, Twist::Pretwist(twist)) | (Self::StrandTwist, _, Twist::StrandTwist(twist)) => {
                Some(twist)
            }
            (Self::StiffnessRatio, ..) => Some(data.stiffness_ratio),
            (Self::CoreRadius, ..) => data.core_radius,
            _ => None,
        }
    }

    /// The data with another value of it.
    pub(crate) fn set(self, mut data: Data, value: f64) -> Data {
        match (self, &mut data.ends) {
            (Self::Force, Ends::Loads(Load { force, .. }) | Ends::Rotation { force, .. }) => *force = value,
            (Self::Moment, Ends::Loads(Load { moment, .. }) | Ends::Length { moment, .. }) => *moment = value,
            (Self::Rotation, Ends::Rotation { rotation, .. }) => *rotation = value,
            (Self::Extension, Ends::Length { extension, .. }) => *extension = value,
            (Self::Pretwist, _) => data.twist = Twist::Pretwist(value),
            (Self::StrandTwist, _) => data.twist = Twist::StrandTwist(value),
            (Self::StiffnessRatio, _) => data.stiffness_ratio = value,
            (Self::CoreRadius, _) => data.core_radius = Some(value),
            _ => {}
        }
        data
    }

    /// The datum in which the balance is linear, if it is.
    pub(crate) const fn along(self) -> Option<Along> {
        match self {
            Self::Force => Some(Along::Force),
            Self::Moment => Some(Along::Moment),
            Self::Pretwist => Some(Along::Pretwist),
            Self::StrandTwist => Some(Along::StrandTwist),
            Self::StiffnessRatio => Some(Along::StiffnessRatio),
            Self::Rotation | Self::Extension | Self::CoreRadius => None,
        }
    }
}

/// One side of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// What runs.
    pub datum: MapDatum,
    /// Its first value, dimensionless.
    pub from: f64,
    /// Its last value, dimensionless.
    pub to: f64,
    /// How many values, ends included.
    pub count: u32,
}

impl Axis {
    /// The one datum in which two sets of data differ.
    pub(crate) fn between(start: &Data, end: &Data, entry: &Entry, count: u32) -> Result<Self, SpecError> {
        let changed = |datum: &MapDatum| datum.get(start).map(f64::to_bits) != datum.get(end).map(f64::to_bits);
        let mut found = MapDatum::ALL.into_iter().filter(changed);
        match (found.next(), found.next()) {
            (Some(datum), None) => match (datum.get(start), datum.get(end)) {
                (Some(from), Some(to)) => Ok(Self { datum, from, to, count }),
                _ => Err(Self::refused(entry)),
            },
            (None, _) => {
                let message = format!("{}: it does not change; give another number where it begins", entry.said());
                Err(entry.error(ErrorKind::Contradiction, message))
            }
            _ => Err(Self::refused(entry)),
        }
    }

    fn refused(entry: &Entry) -> SpecError {
        let message = format!(
            "{}: where the map begins another datum is given in its place: give this one there too",
            entry.said()
        );
        entry.error(ErrorKind::Contradiction, message)
    }

    /// The value at a place, from 0.
    #[must_use]
    pub fn value(&self, place: usize) -> f64 {
        match self.count {
            0 | 1 => self.from,
            count => {
                let last = f64::from(count - 1);
                let share = place as f64 / last;
                // both ends exactly
                self.from * (1.0 - share) + self.to * share
            }
        }
    }

    /// How a reader reads it.
    #[must_use]
    pub fn reading(&self, case: &Case) -> Reading {
        self.datum.reading(case, self.from.abs().max(self.to.abs()))
    }

    /// The factor to SI and the SI unit, where it has one.
    #[must_use]
    pub fn si(&self, case: &Case) -> Option<(f64, &'static str)> {
        let known = Known { scale: case.scale, strand_radius: case.strand_radius };
        match self.datum {
            // rad/r in the theory
            MapDatum::Rotation | MapDatum::Pretwist | MapDatum::StrandTwist => {
                Measure::TurnsPerLength.si(known).map(|(factor, unit)| (factor / TAU, unit))
            }
            datum => datum.measure().si(known),
        }
    }
}
