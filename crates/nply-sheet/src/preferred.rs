//! The units in which a report answers: those of the person who asked.

use crate::{Dimension, Unit};

/// Per dimension the unit that was written first in the input; where none was, one with a prefix that suits the value. Turns per length go by a length in
/// inches or feet.
///
/// Strand and core sizes go before the lengths of strand and ply, which are often in metres where all else is in millimetres.
///
/// ```
/// use nply_sheet::{Dimension, PreferredUnits, Spec};
/// let spec = Spec::from_flags([("radius", "0.5 mm"), ("force", "20 cN")])?;
/// let units = PreferredUnits::of(&spec);
/// assert_eq!(units.format(Dimension::LENGTH, 3.2e-3), "3.2 mm");
/// assert_eq!(units.format(Dimension::MOMENT, 1e-5), "1 cN mm"); // the two units together
/// assert_eq!(PreferredUnits::default().format(Dimension::FORCE, 1234.0), "1.234 kN");
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PreferredUnits {
    written: Vec<Unit>,
}

/// The units a value without a written one may be given in, from small to large.
fn ladder(dimension: Dimension) -> &'static [&'static str] {
    match dimension {
        Dimension::LENGTH => &["nm", "µm", "mm", "m"],
        Dimension::FORCE => &["pN", "nN", "µN", "mN", "N", "kN", "MN"],
        Dimension::MOMENT => &["pN nm", "pN µm", "nN µm", "nN mm", "µN mm", "mN mm", "N mm", "N m", "kN m", "MN m"],
        Dimension::STIFFNESS => {
            &["pN nm^2", "pN µm^2", "nN µm^2", "nN mm^2", "µN mm^2", "mN mm^2", "N mm^2", "N m^2", "kN m^2", "MN m^2"]
        }
        Dimension::FORCE_PER_LENGTH => &["µN/m", "mN/m", "N/m", "N/mm", "kN/mm"],
        Dimension::ANGLE_PER_LENGTH => &["turns/m", "turns/mm", "turns/µm", "turns/nm"],
        Dimension::PRESSURE => &["Pa", "kPa", "MPa", "GPa"],
        Dimension::ANGLE => &["deg"],
        _ => &[],
    }
}

impl PreferredUnits {
    /// Units as they were written, of which the first of each dimension counts.
    pub(crate) fn of_units(units: impl Iterator<Item = Unit>) -> Self {
        let mut written: Vec<Unit> = Vec::new();
        for unit in units {
            if written.iter().all(|known| known.dimension() != unit.dimension()) {
                written.push(unit);
            }
        }
        Self { written }
    }

    /// The unit that was written for this dimension, if one was.
    #[must_use]
    pub fn written(&self, dimension: Dimension) -> Option<&Unit> {
        self.written.iter().find(|unit| unit.dimension() == dimension)
    }

    /// The unit for a value (or for the largest of a column of values), in SI: the written one; else the written force and length
    /// together, where both were written and make one; else by the value's size.
    ///
    /// ```
    /// use nply_sheet::{Dimension, PreferredUnits};
    /// let units = PreferredUnits::default();
    /// let unit = units.unit(Dimension::LENGTH, 2.9e-9);
    /// assert_eq!((unit.as_str(), unit.of_si(2.9e-9)), ("nm", 2.9));
    /// ```
    #[must_use]
    pub fn unit(&self, dimension: Dimension, si: f64) -> Unit {
        if let Some(unit) = self.written(dimension) {
            return unit.clone();
        }
        // turns go by the length where that is nobody's metre: an inch's are turns per inch
        if let (Dimension::ANGLE_PER_LENGTH, Some(length)) = (dimension, self.written(Dimension::LENGTH))
            && !length.is_decimal()
            && let Ok(unit) = Unit::parse(&format!("turns/{length}"))
            && unit.dimension() == dimension
        {
            return unit;
        }
        if let (Some(force), Some(length)) = (self.written(Dimension::FORCE), self.written(Dimension::LENGTH)) {
            let together = match dimension {
                Dimension::MOMENT => Some(format!("{force} {length}")),
                // kN mm^2 is nobody's unit: prefixes are chosen by size, and only an lbf in^2 is no power of ten of N m^2
                Dimension::STIFFNESS if !(force.is_decimal() && length.is_decimal()) => {
                    Some(format!("{force} {length}^2"))
                }
                Dimension::FORCE_PER_LENGTH => Some(format!("{force}/{length}")),
                _ => None,
            };
            // a unit written as `N*m/m` does not take another part; then the size decides
            if let Some(unit) = together.and_then(|text| Unit::parse(&text).ok())
                && unit.dimension() == dimension
            {
                return unit;
            }
        }
        Self::by_size(dimension, si)
    }

    /// The unit for a property such as a stiffness, which a load does not change and whose unit the load's is not to change either: by its size, unless
    /// what was written is no decimal unit (lbf, inch).
    pub(crate) fn unit_by_size(&self, dimension: Dimension, si: f64) -> Unit {
        let of_loads = [Dimension::FORCE, Dimension::LENGTH, Dimension::MOMENT];
        let decimal = of_loads.iter().filter_map(|dimension| self.written(*dimension)).all(Unit::is_decimal);
        match self.written(dimension) {
            None if decimal => Self::by_size(dimension, si),
            Some(_) if decimal && of_loads.contains(&dimension) => Self::by_size(dimension, si),
            _ => self.unit(dimension, si),
        }
    }

    fn by_size(dimension: Dimension, si: f64) -> Unit {
        let mut chosen = Unit::si(dimension);
        for (step, text) in ladder(dimension).iter().enumerate() {
            if let Ok(unit) = Unit::parse(text)
                && (step == 0 || unit.of_si(si).abs() >= 0.9999)
            {
                chosen = unit;
            }
        }
        // nothing is known of the size of zero
        if si == 0.0 && !ladder(dimension).is_empty() && dimension != Dimension::ANGLE {
            Unit::si(dimension)
        } else {
            chosen
        }
    }

    /// A value in SI as text, with six significant digits and its unit.
    #[must_use]
    pub fn format(&self, dimension: Dimension, si: f64) -> String {
        let unit = self.unit(dimension, si);
        format!("{} {unit}", six_digits(unit.of_si(si)))
    }
}

/// Six significant digits, no zeros at the end, an exponent only where the digits would run away.
pub(crate) fn six_digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    let size = rounded.abs();
    if size == 0.0 {
        "0".to_owned()
    } else if (1e-4..1e7).contains(&size) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

/// Six significant digits of a limit greater than 0, the rest cut off: what is printed can be given.
pub(crate) fn six_digits_within(limit: f64) -> String {
    const SIX_AND_POINT: usize = 7;
    let written = format!("{limit:e}");
    let cut = written.split_once('e').and_then(|(mantissa, ten)| {
        let kept = mantissa.get(..SIX_AND_POINT).unwrap_or(mantissa);
        format!("{kept}e{ten}").parse().ok()
    });
    six_digits(cut.unwrap_or(limit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_step_of_a_ladder_is_a_unit_of_its_dimension_and_larger_than_the_last() {
        let dimensions = [
            Dimension::LENGTH,
            Dimension::FORCE,
            Dimension::MOMENT,
            Dimension::STIFFNESS,
            Dimension::FORCE_PER_LENGTH,
            Dimension::ANGLE_PER_LENGTH,
            Dimension::PRESSURE,
            Dimension::ANGLE,
        ];
        for dimension in dimensions {
            let mut last = 0.0;
            for text in ladder(dimension) {
                let unit = Unit::parse(text).unwrap();
                assert_eq!(unit.dimension(), dimension, "{text}");
                assert!(unit.to_si(1.0) > last, "{text}");
                last = unit.to_si(1.0);
            }
            let si = Unit::si(dimension);
            assert_eq!(si.dimension(), dimension);
            assert_eq!(Unit::parse(si.as_str()).unwrap().dimension(), dimension);
        }
    }

    #[test]
    fn a_limit_is_never_printed_past_itself() {
        for (limit, text) in [
            (117.629_052, "117.629"),
            (117.628_999, "117.628"),
            (9.999_999_6, "9.99999"),
            (100.0, "100"),
            (0.25, "0.25"),
            (1.234_567_8e-7, "1.23456e-7"),
        ] {
            assert_eq!(six_digits_within(limit), text);
        }
    }

    #[test]
    fn turns_go_by_a_length_that_is_no_metre() {
        let per_inch = 8.0 / 0.0254 * core::f64::consts::TAU;
        let format = |lengths: &[&str]| {
            let written = lengths.iter().map(|text| Unit::parse(text).unwrap());
            PreferredUnits::of_units(written).format(Dimension::ANGLE_PER_LENGTH, per_inch)
        };
        for (lengths, text) in [
            (&["inch"][..], "8 turns/inch"),
            (&["in"], "8 turns/in"),
            (&["ft"], "96 turns/ft"),
            (&["inch", "tpm"], "314.961 tpm"),
            (&["mm"], "314.961 turns/m"),
        ] {
            assert_eq!(format(lengths), text);
        }
    }

    #[test]
    fn the_size_decides_where_nothing_was_written() {
        let units = PreferredUnits::default();
        for (dimension, si, text) in [
            (Dimension::LENGTH, 2.9e-9, "2.9 nm"),
            (Dimension::LENGTH, 1e-12, "0.001 nm"),
            (Dimension::LENGTH, 1e-6, "1 µm"),
            (Dimension::LENGTH, -0.0125, "-12.5 mm"),
            (Dimension::LENGTH, 0.0, "0 m"),
            (Dimension::FORCE, 5e6, "5 MN"),
            (Dimension::FORCE, 2e-12, "2 pN"),
            (Dimension::MOMENT, 4.1e-21, "4.1 pN nm"),
            (Dimension::MOMENT, 3.0, "3 N m"),
            (Dimension::STIFFNESS, 2e-28, "200 pN nm^2"),
            (Dimension::ANGLE_PER_LENGTH, 200.0 * core::f64::consts::TAU, "200 turns/m"),
            (Dimension::ANGLE_PER_LENGTH, 3.3e7 * core::f64::consts::TAU, "33 turns/µm"),
            (Dimension::FORCE_PER_LENGTH, 5e3, "5 N/mm"),
            (Dimension::LENGTH, 1.0 / 3.0, "333.333 mm"),
        ] {
            assert_eq!(units.format(dimension, si), text);
        }
    }
}
