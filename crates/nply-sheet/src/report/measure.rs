//! What kind of number a column holds: its unit when dimensionless, in SI, and in the reader's own units.

use core::f64::consts::TAU;

use nply::Scale;

use crate::{Dimension, PreferredUnits, Unit};

/// The dimension of a reported quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Measure {
    /// A pure number.
    Number,
    /// A pure number, in hundredths.
    Percent,
    /// Degrees.
    Degrees,
    /// Whole turns.
    Turns,
    /// A length, in r.
    Length,
    /// Turns per length, in turns/r.
    TurnsPerLength,
    /// Curvature, in 1/r.
    PerLength,
    /// A force, in B/r².
    Force,
    /// A moment, in B/r.
    Moment,
    /// A force per length, in B/r³.
    ForcePerLength,
    /// A stiffness against torsion, in B.
    Stiffness,
    /// A stress, in B/r⁴.
    Stress,
    /// Radians per force, in r²/B; degrees where a person reads it.
    AnglePerForce,
    /// Radians per moment, in r/B; degrees where a person reads it.
    AnglePerMoment,
}

/// What a person reads: a factor on the dimensionless value, and the unit's name.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Times the dimensionless value.
    pub factor: f64,
    /// The unit's name, empty for a pure number.
    pub unit: String,
}

/// The sizes that are known: r in m and perhaps B in N m².
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Known {
    /// r and B.
    pub scale: Option<Scale>,
    /// r alone, m.
    pub strand_radius: Option<f64>,
}

impl Measure {
    /// The factor to SI and the SI unit, for what has a dimension whose scale is known.
    #[must_use]
    pub fn si(self, known: Known) -> Option<(f64, &'static str)> {
        let scale = known.scale;
        Some(match self {
            Self::Number | Self::Percent | Self::Degrees | Self::Turns => return None,
            Self::Length => (known.strand_radius?, "m"),
            Self::TurnsPerLength => (1.0 / known.strand_radius?, "turns/m"),
            Self::PerLength => (1.0 / known.strand_radius?, "1/m"),
            Self::Force => (scale?.force(1.0), "N"),
            Self::Moment => (scale?.moment(1.0), "N m"),
            Self::ForcePerLength => (scale?.force_per_length(1.0), "N/m"),
            Self::Stiffness => (scale?.stiffness(1.0), "N m^2"),
            Self::Stress => (scale?.force_per_length(1.0) / scale?.strand_radius(), "Pa"),
            Self::AnglePerForce => (1.0 / scale?.force(1.0), "rad/N"),
            Self::AnglePerMoment => (1.0 / scale?.moment(1.0), "rad/(N m)"),
        })
    }

    /// How a person reads values of which `largest` is the largest: in their own units where the scale is known.
    #[must_use]
    pub fn reading(self, known: Known, units: &PreferredUnits, largest: f64) -> Reading {
        let dimension = match self {
            Self::Number | Self::Percent | Self::Degrees | Self::Turns => None,
            Self::Length => Some(Dimension::LENGTH),
            Self::TurnsPerLength => Some(Dimension::ANGLE_PER_LENGTH),
            Self::PerLength => Some(Dimension::PER_LENGTH),
            Self::Force | Self::AnglePerForce => Some(Dimension::FORCE),
            Self::Moment | Self::AnglePerMoment => Some(Dimension::MOMENT),
            Self::ForcePerLength => Some(Dimension::FORCE_PER_LENGTH),
            Self::Stiffness => Some(Dimension::STIFFNESS),
            Self::Stress => Some(Dimension::PRESSURE),
        };
        let per_load = matches!(self, Self::AnglePerForce | Self::AnglePerMoment);
        let (Some(dimension), Some((si, _))) = (dimension, self.si(known)) else {
            return self.dimensionless();
        };
        if per_load {
            // degrees per unit of the load, whose size is the natural one where none was written
            let unit = units.unit(dimension, 1.0 / si);
            return Reading { factor: (si * unit.to_si(1.0)).to_degrees(), unit: per("deg", &unit.to_string()) };
        }
        // a person's units of turns are angles, in rad
        let si = if self == Self::TurnsPerLength { TAU * si } else { si };
        if self == Self::PerLength {
            let unit = units.unit(Dimension::LENGTH, 1.0 / si);
            return Reading { factor: si * unit.to_si(1.0), unit: per("1", &unit.to_string()) };
        }
        // where all are zero, the unit is that of the natural size
        let unit = units.unit(dimension, si * if largest > 0.0 { largest } else { 1.0 });
        Reading { factor: unit.of_si(si), unit: unit.to_string() }
    }

    /// The size by which a row's unit is chosen, beside rows of these measures and sizes under one heading: what is summed or compared there has one
    /// unit, that of the largest. Lengths, from a gap to a lay, are each read by themselves; one that is zero goes with the others.
    pub(crate) fn size_among(self, own: f64, rows: &[(Self, f64)]) -> f64 {
        if self == Self::Length && own > 0.0 {
            return own;
        }
        rows.iter().filter(|(measure, _)| *measure == self).fold(own, |most, (_, size)| most.max(*size))
    }

    /// How a person reads a rotation per length in rad/r: as turns per length.
    pub(crate) fn turning(known: Known, units: &PreferredUnits, largest: f64) -> Reading {
        let Reading { factor, unit } = Self::TurnsPerLength.reading(known, units, largest / TAU);
        Reading { factor: factor / TAU, unit }
    }

    /// How a person reads a twist: as turns per length where the strand has a size, else as the pure number of the theory.
    pub(crate) fn twist(known: Known, units: &PreferredUnits, largest: f64) -> Reading {
        match known.strand_radius {
            Some(_) => Self::turning(known, units, largest),
            None => Self::Number.reading(known, units, largest),
        }
    }

    /// The factor from the dimensionless value to a unit; `None` where the sizes it takes are not known.
    pub(crate) fn factor(self, known: Known, unit: &Unit) -> Option<f64> {
        let (si, _) = self.si(known)?;
        // units of turns are angles, in rad
        Some(unit.of_si(if self == Self::TurnsPerLength { TAU * si } else { si }))
    }

    /// What its units measure; none of a pure number.
    pub(crate) fn dimension(self) -> Option<Dimension> {
        let angle = Dimension::ANGLE_PER_LENGTH.times(Dimension::LENGTH, 1);
        match self {
            Self::Number | Self::Percent | Self::Degrees | Self::Turns => None,
            Self::Length => Some(Dimension::LENGTH),
            Self::TurnsPerLength => Some(Dimension::ANGLE_PER_LENGTH),
            Self::PerLength => Some(Dimension::PER_LENGTH),
            Self::Force => Some(Dimension::FORCE),
            Self::Moment => Some(Dimension::MOMENT),
            Self::ForcePerLength => Some(Dimension::FORCE_PER_LENGTH),
            Self::Stiffness => Some(Dimension::STIFFNESS),
            Self::Stress => Some(Dimension::PRESSURE),
            Self::AnglePerForce => angle?.times(Dimension::FORCE, -1),
            Self::AnglePerMoment => angle?.times(Dimension::MOMENT, -1),
        }
    }

    fn dimensionless(self) -> Reading {
        let (factor, unit) = match self {
            Self::Number => (1.0, ""),
            Self::Percent => (1.0, "%"),
            Self::Degrees => (1.0, "deg"),
            Self::Turns => (1.0, "turns"),
            Self::Length => (1.0, "r"),
            Self::TurnsPerLength => (1.0, "turns/r"),
            Self::PerLength => (1.0, "1/r"),
            Self::Force => (1.0, "B/r²"),
            Self::Moment => (1.0, "B/r"),
            Self::ForcePerLength => (1.0, "B/r³"),
            Self::Stiffness => (1.0, "B"),
            Self::Stress => (1.0, "B/r⁴"),
            Self::AnglePerForce => (1_f64.to_degrees(), "deg r²/B"),
            Self::AnglePerMoment => (1_f64.to_degrees(), "deg r/B"),
        };
        Reading { factor, unit: unit.to_owned() }
    }
}

/// A unit below another: `deg/N`, `deg/(N mm)`.
fn per(above: &str, below: &str) -> String {
    let single = below.chars().all(char::is_alphanumeric);
    if single { format!("{above}/{below}") } else { format!("{above}/({below})") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reader_gets_their_own_units() {
        let scale = Scale::new(1e-3, 2e-6).unwrap(); // 1 mm, 2 N mm²: forces in 2 N
        let known = Known { scale: Some(scale), strand_radius: Some(1e-3) };
        let units = PreferredUnits::default();
        let force = Measure::Force.reading(known, &units, 0.5);
        assert_eq!((force.factor, force.unit.as_str()), (2.0, "N"));
        let angle = Measure::AnglePerForce.reading(known, &units, 1.0);
        assert!((angle.factor - 1_f64.to_degrees() / 2.0).abs() < 1e-12, "{angle:?}");
        assert_eq!(angle.unit, "deg/N");
        let turns = Measure::TurnsPerLength.reading(known, &units, 1.0);
        assert!((turns.factor - 1.0).abs() < 1e-12 && turns.unit == "turns/mm", "{turns:?}");
        assert_eq!(Measure::Moment.reading(Known::default(), &units, 1.0).unit, "B/r");
    }
}
