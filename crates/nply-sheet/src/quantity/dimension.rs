//! What kind of thing a quantity is, apart from its size.

use core::fmt;

/// Exponents over length, force, time, angle and temperature. A mass is force·time²/length; turns and degrees are angles,
/// so that "200 turns/m" is an angle per length and not a bare curvature.
///
/// ```
/// use nply_sheet::Dimension;
/// let moment = Dimension::FORCE.times(Dimension::LENGTH, 1);
/// assert_eq!(moment, Some(Dimension::MOMENT));
/// assert_eq!(Dimension::PRESSURE.to_string(), "a pressure");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Dimension {
    /// Exponent of length (m).
    pub length: i16,
    /// Exponent of force (N).
    pub force: i16,
    /// Exponent of time (s).
    pub time: i16,
    /// Exponent of angle (rad).
    pub angle: i16,
    /// Exponent of temperature (K).
    pub temperature: i16,
}

impl Dimension {
    /// A pure number.
    pub const NUMBER: Self = Self { length: 0, force: 0, time: 0, angle: 0, temperature: 0 };
    /// Length, in m.
    pub const LENGTH: Self = Self { length: 1, ..Self::NUMBER };
    /// Length squared, in m².
    pub const AREA: Self = Self { length: 2, ..Self::NUMBER };
    /// One over length, in 1/m.
    pub const PER_LENGTH: Self = Self { length: -1, ..Self::NUMBER };
    /// Force, in N.
    pub const FORCE: Self = Self { force: 1, ..Self::NUMBER };
    /// Pressure or modulus, in Pa.
    pub const PRESSURE: Self = Self { length: -2, ..Self::FORCE };
    /// Force per length, in N/m.
    pub const FORCE_PER_LENGTH: Self = Self { length: -1, ..Self::FORCE };
    /// Moment (or energy), in N m.
    pub const MOMENT: Self = Self { length: 1, ..Self::FORCE };
    /// Bending or torsional stiffness, force·length², in N m².
    pub const STIFFNESS: Self = Self { length: 2, ..Self::FORCE };
    /// Angle, in rad.
    pub const ANGLE: Self = Self { angle: 1, ..Self::NUMBER };
    /// Angle per length, in rad/m.
    pub const ANGLE_PER_LENGTH: Self = Self { length: -1, ..Self::ANGLE };
    /// Absolute temperature, in K.
    pub const TEMPERATURE: Self = Self { temperature: 1, ..Self::NUMBER };
    /// Time, in s.
    pub const TIME: Self = Self { time: 1, ..Self::NUMBER };
    /// Mass, in kg = N s²/m.
    pub const MASS: Self = Self { force: 1, time: 2, length: -1, ..Self::NUMBER };
    /// Mass per length, in kg/m.
    pub const LINEAR_DENSITY: Self = Self { length: -2, ..Self::MASS };
    /// Mass per volume, in kg/m³.
    pub const DENSITY: Self = Self { length: -4, ..Self::MASS };
    /// Force per linear density, in N m/kg: the stress of textile people, cN/tex.
    pub const SPECIFIC_STRESS: Self = Self { length: 2, time: -2, ..Self::NUMBER };

    /// Multiplied by `other` to the given power; `None` where an exponent passes what a quantity could mean (±99).
    ///
    /// ```
    /// use nply_sheet::Dimension;
    /// assert_eq!(Dimension::FORCE.times(Dimension::LENGTH, -2), Some(Dimension::PRESSURE));
    /// assert_eq!(Dimension::FORCE.times(Dimension::LENGTH, 100), None);
    /// ```
    #[must_use]
    pub fn times(self, other: Self, power: i16) -> Option<Self> {
        let sum = |a: i16, b: i16| a.checked_add(b.checked_mul(power)?).filter(|e| (-99..=99).contains(e));
        Some(Self {
            length: sum(self.length, other.length)?,
            force: sum(self.force, other.force)?,
            time: sum(self.time, other.time)?,
            angle: sum(self.angle, other.angle)?,
            temperature: sum(self.temperature, other.temperature)?,
        })
    }

    /// The field's words for it, where there are any.
    const fn words(self) -> Option<&'static str> {
        const NAMED: [(Dimension, &str); 17] = [
            (Dimension::NUMBER, "a pure number"),
            (Dimension::LENGTH, "a length"),
            (Dimension::AREA, "an area"),
            (Dimension::PER_LENGTH, "one over a length"),
            (Dimension::FORCE, "a force"),
            (Dimension::PRESSURE, "a pressure"),
            (Dimension::FORCE_PER_LENGTH, "a force per length"),
            (Dimension::MOMENT, "a moment"),
            (Dimension::STIFFNESS, "a stiffness (force times length squared)"),
            (Dimension::ANGLE, "an angle"),
            (Dimension::ANGLE_PER_LENGTH, "an angle per length"),
            (Dimension::TEMPERATURE, "a temperature"),
            (Dimension::TIME, "a time"),
            (Dimension::MASS, "a mass"),
            (Dimension::LINEAR_DENSITY, "a linear density (mass per length)"),
            (Dimension::DENSITY, "a density (mass per volume)"),
            (Dimension::SPECIFIC_STRESS, "a specific stress (force per linear density)"),
        ];
        let mut at = 0;
        while at < NAMED.len() {
            if NAMED[at].0.same(self) {
                return Some(NAMED[at].1);
            }
            at += 1;
        }
        None
    }

    const fn same(self, other: Self) -> bool {
        self.length == other.length
            && self.force == other.force
            && self.time == other.time
            && self.angle == other.angle
            && self.temperature == other.temperature
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(words) = self.words() {
            return out.write_str(words);
        }
        out.write_str("a quantity of dimension")?;
        let parts = [
            ("force", self.force),
            ("length", self.length),
            ("time", self.time),
            ("angle", self.angle),
            ("temperature", self.temperature),
        ];
        for (name, exponent) in parts {
            match exponent {
                0 => {}
                1 => write!(out, " {name}")?,
                _ => write!(out, " {name}^{exponent}")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_named_dimension_is_said_in_words_and_the_rest_by_exponents() {
        assert_eq!(Dimension::LINEAR_DENSITY.to_string(), "a linear density (mass per length)");
        assert_eq!(Dimension::FORCE.times(Dimension::FORCE, 1).unwrap().to_string(), "a quantity of dimension force^2");
        assert_eq!(Dimension::MASS.times(Dimension::LENGTH, -1), Some(Dimension::LINEAR_DENSITY));
    }
}
