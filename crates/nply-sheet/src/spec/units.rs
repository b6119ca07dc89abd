//! The units in which an input was written.

use super::{Entry, Spec, Value};
use crate::{Datum, PreferredUnits, Quantity};

impl PreferredUnits {
    /// The units written in an input.
    #[must_use]
    pub fn of(spec: &Spec) -> Self {
        let (last, first): (Vec<_>, Vec<_>) = spec.entries.iter().partition(|entry| {
            matches!(
                entry.key.datum,
                Datum::StrandLength
                    | Datum::AxialStiffness
                    | Datum::SupportCoreAxialStiffness
                    | Datum::PlyLength
                    | Datum::BendingPersistenceLength
                    | Datum::TwistPersistenceLength
            )
        });
        Self::first_written(first.into_iter().chain(last))
    }

    /// Per dimension the unit that stands first among entries.
    pub(crate) fn first_written<'e>(entries: impl Iterator<Item = &'e Entry>) -> Self {
        Self::of_units(entries.filter_map(|entry| match &entry.value {
            Value::Quantity(Quantity::Measured { unit, .. }) => Some(unit.clone()),
            _ => None,
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Dimension;

    fn units(flags: &[(&str, &str)]) -> PreferredUnits {
        PreferredUnits::of(&Spec::from_flags(flags.iter().copied()).unwrap())
    }

    #[test]
    fn the_first_written_unit_wins_but_the_strand_length_comes_last() {
        let units = units(&[
            ("strand-length", "2 m"),
            ("diameter", "0.1 in"),
            ("lay-length", "3 mm"),
            ("turns-per-length", "5 tpi"),
        ]);
        assert_eq!(units.format(Dimension::LENGTH, 0.0254), "1 in");
        assert_eq!(units.format(Dimension::ANGLE_PER_LENGTH, 7.0 * core::f64::consts::TAU / 0.0254), "7 tpi");
        assert!(units.written(Dimension::FORCE).is_none());
    }

    #[test]
    fn force_and_length_written_apart_go_together() {
        let units = units(&[("radius", "1 nm"), ("force", "3 pN")]);
        assert_eq!(units.format(Dimension::STIFFNESS, 2e-28), "200 pN nm^2");
        assert_eq!(units.format(Dimension::FORCE_PER_LENGTH, 1e-3), "1 pN/nm");
    }
}
