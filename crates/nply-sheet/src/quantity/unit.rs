//! Units as people write them: `mm`, `pN nm^2`, `turns/inch`, `°C`.

use core::fmt;

use super::double::Double;
use super::symbol::{Factor, look_up, look_up_joined, nearest, no_unit, times_ten_to};
use super::{Dimension, QuantityError};

/// A unit expression, read: its text, its dimension and its size in SI (m, N, s, rad, K).
///
/// The size is kept as numerator/denominator·10^ten·(2π)^turns in whole numbers, so that neither a power of ten nor a turn
/// costs a digit.
///
/// ```
/// use nply_sheet::{Dimension, Unit};
/// let unit = Unit::parse("pN nm^2")?;
/// assert_eq!(unit.dimension(), Dimension::STIFFNESS);
/// assert_eq!(unit.of_si(5e-29), 50.0);
/// # Ok::<(), nply_sheet::QuantityError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    text: String,
    dimension: Dimension,
    factor: Factor,
    /// Where the unit's scale starts below its own zero: 273.15 for °C.
    zero: f64,
}

/// A unit of more factors than this is nothing a ply knows.
const MOST_FACTORS: usize = 8;

/// Reads a unit expression from left to right.
struct Reader<'t> {
    whole: &'t str,
    rest: &'t str,
}

impl<'t> Reader<'t> {
    fn refuse(&self, reason: &'static str) -> QuantityError {
        QuantityError::BadUnit { unit: crate::quoted(self.whole), reason }
    }

    fn skip_blanks(&mut self) -> bool {
        let trimmed = self.rest.trim_start();
        let skipped = trimmed.len() < self.rest.len();
        self.rest = trimmed;
        skipped
    }

    fn take(&mut self, wanted: &[char]) -> bool {
        match self.rest.strip_prefix(wanted) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn word(&mut self) -> &'t str {
        let end = self
            .rest
            .find(|c: char| !(c.is_alphabetic() || c == '°' || c == '%' || c == '\u{2103}' || c == '\u{2109}'));
        let (word, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest;
        word
    }

    /// `^2`, `^-1`, `2`, `²`, `⁻¹`, or nothing, which is 1.
    fn power(&mut self) -> Result<i16, QuantityError> {
        const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
        let digits: String;
        // `mm2` is `mm^2`: no unit's name has a digit
        if self.take(&['^']) || self.rest.starts_with(|c: char| c.is_ascii_digit()) {
            let sign = if self.take(&['-', '\u{2212}']) { "-" } else { "" };
            let end = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
            let (number, rest) = self.rest.split_at(end);
            self.rest = rest;
            digits = format!("{sign}{number}");
        } else {
            let mut read = String::new();
            if self.take(&['⁻']) {
                read.push('-');
            }
            while let Some(c) = self.rest.chars().next() {
                let Some(digit) = SUPERSCRIPTS.iter().zip('0'..='9').find_map(|(s, d)| (*s == c).then_some(d)) else {
                    break;
                };
                read.push(digit);
                self.rest = self.rest.get(c.len_utf8()..).unwrap_or("");
            }
            if read.is_empty() {
                return Ok(1);
            }
            digits = read;
        }
        match digits.parse::<i16>() {
            Ok(power) if power != 0 && (-9..=9).contains(&power) => Ok(power),
            _ => Err(self.refuse("a power must be a whole number from -9 to 9 and not 0, as in \"mm^2\"")),
        }
    }
}

impl Unit {
    /// Reads a unit expression: symbols with SI prefixes where usual; products by blank, `*` or `·`; powers as `^2`, `2`, `²`,
    /// `^-1` or `⁻¹`; any number of `/`, each dividing by the one unit after it.
    ///
    /// # Errors
    /// [`QuantityError`] where a word is no unit or the expression has no clear meaning.
    ///
    /// ```
    /// use nply_sheet::{Dimension, Unit};
    /// assert_eq!(Unit::parse("N/mm")?.dimension(), Dimension::FORCE_PER_LENGTH);
    /// assert!(Unit::parse("Mpa").unwrap_err().to_string().contains("did you mean `MPa`?"));
    /// # Ok::<(), nply_sheet::QuantityError>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, QuantityError> {
        let whole = text.trim();
        let mut reader = Reader { whole, rest: whole };
        let mut unit = Self { text: whole.to_owned(), dimension: Dimension::NUMBER, factor: Factor::ONE, zero: 0.0 };
        if whole.is_empty() {
            return Err(reader.refuse("it is empty"));
        }
        // "5 /m" and "5 1/m"
        if let Some(rest) = whole.strip_prefix('1').map(str::trim_start).filter(|rest| rest.starts_with('/')) {
            reader.rest = rest;
        }
        let mut divides = reader.take(&['/']);
        let mut divided = divides;
        let mut offset = None;
        for count in 1.. {
            if count > MOST_FACTORS {
                return Err(reader.refuse("it has too many factors"));
            }
            reader.skip_blanks();
            let word = reader.word();
            if word.is_empty() {
                let number = divides && reader.rest.starts_with(|c: char| c.is_ascii_digit());
                return Err(reader.refuse(if number {
                    "behind `/` stands a unit without a number: 5 turns/(100 m) are written \"0.05 turns/m\""
                } else {
                    "a unit such as `mm` is wanted here"
                }));
            }
            if let Some(reason) = no_unit(word) {
                return Err(reader.refuse(reason));
            }
            let single = look_up(word);
            let joined = if single.is_none() { look_up_joined(word) } else { None };
            let power = reader.power()?;
            let sign = if divides { -1 } else { 1 };
            match (single, joined) {
                (Some((factor, dimension, zero)), _) => {
                    unit.multiply(factor, dimension, sign * power)
                        .ok_or_else(|| reader.refuse("its powers are too high"))?;
                    if zero != 0.0 {
                        offset = Some(zero);
                    }
                }
                (None, Some([force, length])) => {
                    unit.multiply(force.0, force.1, sign)
                        .and_then(|()| unit.multiply(length.0, length.1, sign * power))
                        .ok_or_else(|| reader.refuse("its powers are too high"))?;
                }
                (None, None) => {
                    return Err(QuantityError::UnknownUnit { unit: crate::quoted(word), nearest: nearest(word) });
                }
            }
            let blank = reader.skip_blanks();
            if reader.rest.is_empty() {
                if let Some(zero) = offset {
                    // a temperature of another zero stands alone: 1/°C has no meaning here
                    if count > 1 || power != 1 || divided {
                        return Err(reader.refuse("degrees with a zero of their own cannot be multiplied; use `K`"));
                    }
                    unit.zero = zero;
                }
                return Ok(unit);
            }
            divides = reader.take(&['/']);
            if divides {
                divided = true;
            } else {
                if !(reader.take(&['*', '·', '\u{22c5}', '\u{d7}']) || blank) {
                    return Err(reader.refuse("its parts must be joined by a blank, `*`, `·` or `/`"));
                }
                if divided {
                    return Err(reader.refuse(
                        "a product after `/` can be read in two ways; put it before, or repeat `/` as in \"N/m/s\"",
                    ));
                }
            }
        }
        Ok(unit)
    }

    /// The SI unit of a dimension, such as `N m^2`; an empty text for a pure number.
    ///
    /// ```
    /// use nply_sheet::{Dimension, Unit};
    /// assert_eq!(Unit::si(Dimension::FORCE_PER_LENGTH).as_str(), "N m^-1");
    /// ```
    #[must_use]
    pub fn si(dimension: Dimension) -> Self {
        let parts = [
            ("N", dimension.force),
            ("m", dimension.length),
            ("s", dimension.time),
            ("rad", dimension.angle),
            ("K", dimension.temperature),
        ];
        let written = parts.iter().filter(|(_, power)| *power != 0).map(|(name, power)| match power {
            1 => (*name).to_owned(),
            _ => format!("{name}^{power}"),
        });
        Self { text: written.collect::<Vec<_>>().join(" "), dimension, factor: Factor::ONE, zero: 0.0 }
    }

    fn multiply(&mut self, factor: Factor, dimension: Dimension, power: i16) -> Option<()> {
        self.dimension = self.dimension.times(dimension, power)?;
        self.factor = self.factor.times(factor, power);
        (self.factor.numerator.is_finite() && self.factor.denominator.is_finite()).then_some(())
    }

    /// Whether it is a power of ten of the SI unit: mm and kN are, inch and lbf are not.
    pub(crate) fn is_decimal(&self) -> bool {
        let Factor { numerator, denominator, turns, .. } = self.factor;
        #[allow(clippy::float_cmp, reason = "whole numbers")]
        let one = numerator == 1.0 && denominator == 1.0;
        one && turns == 0
    }

    /// What kind of thing it measures.
    #[must_use]
    pub const fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// As it was written.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// A number in this unit, given by decimal mantissa and exponent, in SI: the nearest double, but for angles in turns and
    /// degrees, psi, ozf, denier and °F, which may be the double next to it.
    pub(crate) fn si_of_decimal(&self, mantissa: &str, exponent: i64) -> Option<f64> {
        if let Some(exact) = self.decimal_times_whole(mantissa, exponent.saturating_add(i64::from(self.factor.ten))) {
            return Some(exact);
        }
        let (size, rest) = self.factor.size();
        let written = exponent.saturating_add(i64::from(rest));
        let number: f64 = format!("{mantissa}e{written}").parse().ok()?;
        Some(size.scale(number + self.zero))
    }

    /// Where the unit is a whole number of powers of ten (inch, lbf): the product in whole numbers, rounded once.
    fn decimal_times_whole(&self, mantissa: &str, exponent: i64) -> Option<f64> {
        const LARGEST_EXACT: f64 = 9_007_199_254_740_992.0; // 2⁵³
        let Factor { numerator, denominator, turns, .. } = self.factor;
        let whole =
            turns == 0 && denominator <= 1.0 && numerator <= LARGEST_EXACT && libm::trunc(numerator) >= numerator;
        if !whole || self.zero != 0.0 {
            return None;
        }
        let (sign, digits) = mantissa.strip_prefix('-').map_or(("", mantissa), |digits| ("-", digits));
        let (before, after) = digits.split_once('.').unwrap_or((digits, ""));
        let number: u128 = format!("{before}{after}").parse().ok()?;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole, from 1 to 2⁵³")]
        let product = number.checked_mul(numerator as u128)?;
        let places = i64::try_from(after.len()).ok()?;
        format!("{sign}{product}e{}", exponent.saturating_sub(places)).parse().ok()
    }

    /// A number in this unit, in SI.
    ///
    /// ```
    /// # use nply_sheet::Unit;
    /// assert_eq!(Unit::parse("mm")?.to_si(0.5), 5e-4);
    /// # Ok::<(), nply_sheet::QuantityError>(())
    /// ```
    #[must_use]
    pub fn to_si(&self, value: f64) -> f64 {
        let (size, rest) = self.factor.size();
        times_ten_to(size.scale(value + self.zero), rest)
    }

    /// A value in SI, in this unit; accurate to 2 ulp.
    ///
    /// ```
    /// # use nply_sheet::Unit;
    /// assert_eq!(Unit::parse("µm")?.of_si(1.25e-5), 12.5);
    /// assert_eq!(Unit::parse("turns/m")?.of_si(core::f64::consts::TAU), 1.0);
    /// # Ok::<(), nply_sheet::QuantityError>(())
    /// ```
    #[must_use]
    pub fn of_si(&self, value: f64) -> f64 {
        let (size, rest) = self.factor.size();
        times_ten_to(Double::exactly(1.0).over(size).scale(value), -rest) - self.zero
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.text)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::float_cmp, reason = "these are exact: the nearest double is claimed")]
    use core::f64::consts::TAU;

    use super::*;

    fn dimension(text: &str) -> Dimension {
        Unit::parse(text).unwrap().dimension()
    }

    #[test]
    fn products_quotients_and_powers() {
        for text in [
            "pN nm^2", "pN*nm^2", "pN·nm²", "pN nm nm", "N m^2", "nm² pN", "N m³/m", "Pa m^4", "MPa mm4", "N/m^-2",
            "Nm2",
        ] {
            assert_eq!(dimension(text), Dimension::STIFFNESS, "{text}");
        }
        for text in ["turns/m", "turn m^-1", "turns·m⁻¹", "rad/mm", "deg/inch", "tpi", "tpm", "rev/ft"] {
            assert_eq!(dimension(text), Dimension::ANGLE_PER_LENGTH, "{text}");
        }
        for text in ["Nm", "kNm", "pNnm", "N·m", "lbf in", "J", "mNm", "Nmm", "lbf·ft"] {
            assert_eq!(dimension(text), Dimension::MOMENT, "{text}");
        }
        assert_eq!(dimension("N/m/m"), Dimension::PRESSURE);
        assert_eq!(dimension("N/mm2"), Dimension::PRESSURE);
        assert_eq!(dimension("t/m3"), Dimension::DENSITY);
        assert_eq!(dimension("%"), Dimension::NUMBER);
        assert_eq!(dimension("1/m"), Dimension::PER_LENGTH);
        assert_eq!(dimension("/m"), Dimension::PER_LENGTH);
        assert_eq!(dimension("kg m/s/s"), Dimension::FORCE);
        assert_eq!(dimension("Nm^2"), Dimension::STIFFNESS);
    }

    #[test]
    fn what_has_no_clear_meaning_is_refused() {
        for (text, part) in [
            ("N/m s", "two ways"),
            ("mm0", "whole number"),
            ("turns/100m", "0.05 turns/m"),
            ("bp", "0.34 nm"),
            ("AWG", "diameter"),
            ("d", "`lay_ratio`"),
            ("mm^", "whole number"),
            ("mm^0", "whole number"),
            ("mm^99", "whole number"),
            ("mm^1.5", "joined"),
            ("degC/m", "zero of their own"),
            ("degC^2", "zero of their own"),
            ("1/degC", "zero of their own"),
            ("m m m m m m m m m", "too many factors"),
            ("mm/", "is wanted here"),
            ("", "empty"),
            ("N/(m s)", "is wanted here"),
            ("lbf^9 lbf^9 lbf^9 lbf^9 lbf^9", "too high"),
        ] {
            let said = Unit::parse(text).unwrap_err().to_string();
            assert!(said.contains(part), "{text}: {said}");
        }
    }

    #[test]
    fn a_slip_is_answered_with_the_nearest_unit() {
        for (text, meant) in [
            ("A", "Å"),
            ("Ang", "Å"),
            ("C", "°C"),
            ("F", "°F"),
            ("Mpa", "MPa"),
            ("NM", "nm"),
            ("mmm", "mm"),
            ("trns", "turns"),
            ("inchs", "inch"),
            ("kgff", "kgf"),
        ] {
            let Err(QuantityError::UnknownUnit { nearest, .. }) = Unit::parse(text) else { panic!("{text}") };
            assert_eq!(nearest, Some(meant), "{text}");
        }
    }

    #[test]
    fn sizes_by_definition() {
        let si = |text: &str| Unit::parse(text).unwrap().to_si(1.0);
        assert_eq!(si("in"), 0.0254);
        assert_eq!(si("ft"), 0.3048);
        assert_eq!(si("lbf"), 4.448_221_615_260_5);
        assert_eq!(si("kgf"), 9.80665);
        assert!((si("psi") - 6_894.757_293_168_361).abs() < 2e-12);
        assert!((si("Msi") / 6.894_757_293_168_361e9 - 1.0).abs() < 4e-16);
        assert_eq!(si("dyn"), 1e-5);
        assert_eq!(si("cN"), 1e-2);
        assert_eq!(si("Å"), 1e-10);
        assert_eq!(si("tex"), 1e-6);
        assert!((si("den") * 9.0 - 1e-6).abs() < 1e-21);
        assert_eq!(si("tpm"), TAU);
        assert!((si("tpi") - TAU / 0.0254).abs() < 1e-12);
    }
}
