//! A number with its unit, as a person writes it.

mod dimension;
mod double;
mod error;
mod symbol;
mod unit;

pub use dimension::Dimension;
pub use error::QuantityError;
pub use symbol::{KnownUnit, known_units, unit_prefixes};
pub use unit::Unit;

/// What was read: a number with a unit, in SI, or a bare number.
///
/// ```
/// use nply_sheet::{Dimension, Quantity};
/// assert_eq!(Quantity::parse("3 nm")?.si(), 3e-9); // the nearest double, not 3·1e-9
/// assert_eq!(Quantity::parse("50 pN nm^2")?.dimension(), Dimension::STIFFNESS);
/// assert_eq!(Quantity::parse("0.75")?, Quantity::Bare(0.75));
/// # Ok::<(), nply_sheet::QuantityError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    /// A number without a unit.
    Bare(f64),
    /// A number with a unit.
    Measured {
        /// The value in SI: m, N, s, rad, K and their products.
        si: f64,
        /// The unit it was written in.
        unit: Unit,
    },
}

/// Mantissa and exponent of a decimal number at the head of a text, and the rest.
struct Decimal<'t> {
    mantissa: String,
    exponent: i64,
    rest: &'t str,
}

fn digits(text: &str) -> (&str, &str) {
    text.split_at(text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len()))
}

impl<'t> Decimal<'t> {
    fn read(text: &'t str) -> Option<Self> {
        let (sign, after_sign) = match text.strip_prefix(['-', '\u{2212}']) {
            Some(rest) => ("-", rest),
            None => ("", text.strip_prefix('+').unwrap_or(text)),
        };
        let (whole, mut rest) = digits(after_sign);
        let mut fraction = "";
        if let Some(after_point) = rest.strip_prefix('.') {
            (fraction, rest) = digits(after_point);
        }
        if whole.is_empty() && fraction.is_empty() {
            return None;
        }
        let mut exponent = 0;
        if let Some(after_e) = rest.strip_prefix(['e', 'E']) {
            let (negative, after_sign) = match after_e.strip_prefix(['-', '\u{2212}']) {
                Some(after) => (true, after),
                None => (false, after_e.strip_prefix('+').unwrap_or(after_e)),
            };
            let (power, after) = digits(after_sign);
            if !power.is_empty() {
                let size = power.parse::<i64>().unwrap_or(i64::MAX / 4).min(i64::MAX / 4);
                exponent = if negative { -size } else { size };
                rest = after;
            }
        }
        // a leading zero, because ".5" and "5." are written too
        Some(Self { mantissa: format!("{sign}0{whole}.{fraction}0"), exponent, rest })
    }

    fn value(&self) -> Option<f64> {
        format!("{}e{}", self.mantissa, self.exponent).parse().ok()
    }

    fn is_zero(&self) -> bool {
        self.mantissa.chars().all(|c| !c.is_ascii_digit() || c == '0')
    }
}

impl Quantity {
    /// Reads a number, an optional blank and a unit expression (see [`Unit::parse`]). Degrees Celsius and Fahrenheit
    /// become kelvin.
    ///
    /// # Errors
    /// [`QuantityError`], one sentence saying what was read and what to write.
    ///
    /// ```
    /// use nply_sheet::Quantity;
    /// assert_eq!(Quantity::parse("25 degC")?.si(), 298.15);
    /// assert_eq!(Quantity::parse("90°")?.si(), core::f64::consts::FRAC_PI_2);
    /// assert!(Quantity::parse("NaN mm").is_err());
    /// # Ok::<(), nply_sheet::QuantityError>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, QuantityError> {
        let read = text.trim();
        let quoted = || crate::quoted(read);
        if read.is_empty() {
            return Err(QuantityError::Empty);
        }
        let Some(decimal) = Decimal::read(read) else {
            let word = read.trim_start_matches(['+', '-', '\u{2212}']).to_ascii_lowercase();
            let word = word.split(|c: char| !c.is_alphabetic()).next().unwrap_or("");
            return Err(match word {
                "nan" | "inf" | "infinity" => QuantityError::NotFinite { read: quoted() },
                _ => QuantityError::NotANumber { read: quoted() },
            });
        };
        let after = decimal.rest.trim_start();
        // one comma between digits may be a decimal one; any other parts two numbers
        let listed = |rest: &str| {
            let number = |part: &str| Decimal::read(part.trim()).is_some();
            rest.split_once(',').is_some_and(|(_, next)| next.starts_with(' ') || next.contains(',') || number(next))
        };
        match after.strip_prefix(',') {
            Some(rest) if rest.starts_with(' ') || rest.contains(',') => {
                return Err(QuantityError::List { read: quoted() });
            }
            Some(_) => return Err(QuantityError::Comma { read: quoted() }),
            None if listed(after) => return Err(QuantityError::List { read: quoted() }),
            None => {}
        }
        let in_range = |value: f64| value.is_finite() && (value != 0.0 || decimal.is_zero());
        if after.is_empty() {
            let value = decimal.value().ok_or_else(|| QuantityError::NotANumber { read: quoted() })?;
            return if in_range(value) {
                Ok(Self::Bare(value))
            } else {
                Err(QuantityError::OutOfRange { read: quoted() })
            };
        }
        if let Some(decimal) = Self::of_fraction(&decimal) {
            return Err(QuantityError::Fraction { read: quoted(), decimal });
        }
        let unit = Unit::parse(after)?;
        match unit.si_of_decimal(&decimal.mantissa, decimal.exponent) {
            // 0 K may well come out of −273.15 °C
            Some(si) if in_range(si) || (si == 0.0 && unit.dimension() == Dimension::TEMPERATURE) => {
                Ok(Self::Measured { si, unit })
            }
            _ => Err(QuantityError::OutOfRange { read: quoted() }),
        }
    }

    /// A titre: a linear density such as `94 tex` or `840 D` (denier, which is `den` elsewhere), or a yarn count, which is a length per mass: `Ne 30` or `30 Ne` (hanks of 840 yards
    /// per pound) and `Nm 40` or `40 Nm` (km per kg), in tex then.
    ///
    /// # Errors
    /// [`QuantityError`] as of [`Quantity::parse`]; a folded count such as `30/2` is refused, but for `30/1`, which is the single's.
    ///
    /// ```
    /// use nply_sheet::Quantity;
    /// assert_eq!(Quantity::parse_linear_density("Nm 40")?.si(), 25e-6); // 25 tex
    /// assert!((Quantity::parse_linear_density("Ne 30")?.si() - 19.685e-6).abs() < 1e-9);
    /// # Ok::<(), nply_sheet::QuantityError>(())
    /// ```
    pub fn parse_linear_density(text: &str) -> Result<Self, QuantityError> {
        const NE: f64 = 0.453_592_37 / (840.0 * 0.9144); // kg/m of count 1, exact by definition of pound and yard
        const NM: f64 = 1e-3;
        let read = text.trim();
        let count = [("Ne", NE), ("NeC", NE), ("Nm", NM)].into_iter().find_map(|(name, of_one)| {
            let apart = |rest: &str| rest.starts_with(|c: char| c.is_whitespace() || c.is_ascii_digit());
            let before = read.strip_prefix(name).filter(|rest| apart(rest));
            let behind = || read.strip_suffix(name).filter(|rest| rest.ends_with(|c: char| !c.is_alphabetic()));
            Some((before.or_else(behind)?.trim(), of_one))
        });
        // 30/2, with or without the name of its count; metric counts have the fold before it, 2/28, and weavers write cotton ones so too.
        // No yarn is folded of more strands than its count, so that the smaller is the fold. Of one, it is the single's
        let name = ["NeC", "Ne", "Nm"].into_iter().find(|name| count.is_some() && read.contains(name));
        let parts = count.map_or(read, |(count, _)| count).split_once('/');
        let count = match parts.map(|(a, b)| (a.trim().parse::<u32>(), b.trim().parse::<u32>())) {
            Some((Ok(first), Ok(second))) => {
                let (number, strands) = if (1..second).contains(&first) { (second, first) } else { (first, second) };
                match (count, strands) {
                    (Some((_, of_one)), 1) => Some((number.to_string(), of_one)),
                    (Some(_), strands) => {
                        let single = format!("{} {number}", name.unwrap_or("Ne"));
                        return Err(QuantityError::Folded { read: crate::quoted(read), single, strands });
                    }
                    (None, strands) => {
                        return Err(QuantityError::CountOfNoSystem {
                            read: crate::quoted(read),
                            count: number,
                            strands,
                        });
                    }
                }
            }
            _ => count.map(|(count, of_one)| (count.to_owned(), of_one)),
        };
        let Some((count, of_one)) = count else {
            if let Some(resultant) = Self::resultant(read) {
                return Err(resultant);
            }
            // a lay in diameters elsewhere
            let denier = read.strip_suffix(['D', 'd']).filter(|rest| rest.ends_with(|c: char| !c.is_alphabetic()));
            return denier.map_or_else(|| Self::parse(text), |number| Self::parse(&format!("{number}den")));
        };
        let Self::Bare(number) = Self::parse(&count)? else {
            return Err(QuantityError::NotANumber { read: crate::quoted(read) });
        };
        let si = of_one / number;
        if si.is_finite() && si != 0.0 {
            Ok(Self::Measured { si, unit: Unit::parse("tex")? })
        } else {
            Err(QuantityError::OutOfRange { read: crate::quoted(read) })
        }
    }

    /// `5/32 in`, or `1 5/32 in`, from its first number on: `0.15625 in`.
    fn of_fraction(first: &Decimal<'_>) -> Option<String> {
        let above =
            |number: &Decimal<'_>| Some((number.value()?, number.rest.trim_start().strip_prefix('/')?.to_owned()));
        let (whole, (above, behind)) = match above(first) {
            Some(fraction) => (0.0, fraction),
            None => (first.value()?, above(&Decimal::read(first.rest.trim_start())?)?),
        };
        let below = Decimal::read(behind.trim_start())?;
        let unit = below.rest.trim_start();
        // -1 1/2 is -1.5
        let fraction = above / below.value()?;
        let value = if whole < 0.0 { whole - fraction } else { whole + fraction };
        let six_digits: f64 = format!("{value:.5e}").parse().ok()?;
        let read = value.is_finite() && (unit.is_empty() || Unit::parse(unit).is_ok());
        read.then(|| format!("{six_digits} {unit}").trim_end().to_owned())
    }

    /// `R 74 tex/2`: 74 tex for a ply of two.
    fn resultant(read: &str) -> Option<QuantityError> {
        let (ply, strands) = read.strip_prefix('R')?.split_once('/')?;
        let strands = strands.trim().parse().ok().filter(|strands| *strands > 1)?;
        let Ok(Self::Measured { si, unit }) = Self::parse(ply) else { return None };
        let share = unit.of_si(si / f64::from(strands));
        let four_digits: f64 = format!("{share:.3e}").parse().unwrap_or(share);
        let at_most = format!("{four_digits} {unit}");
        Some(QuantityError::Resultant { read: crate::quoted(read), at_most, strands })
    }

    /// The number itself if bare, else the value in SI (m, N, s, rad, K and their products).
    #[must_use]
    pub const fn si(&self) -> f64 {
        match self {
            Self::Bare(value) => *value,
            Self::Measured { si, .. } => *si,
        }
    }

    /// What kind of thing it is; a bare number is [`Dimension::NUMBER`].
    #[must_use]
    pub const fn dimension(&self) -> Dimension {
        match self {
            Self::Bare(_) => Dimension::NUMBER,
            Self::Measured { unit, .. } => unit.dimension(),
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::float_cmp, reason = "these are exact: the nearest double is claimed")]
    use core::f64::consts::{FRAC_PI_2, TAU};

    use proptest::prelude::*;

    use super::*;
    use symbol::every_unit;

    fn si(text: &str) -> f64 {
        Quantity::parse(text).unwrap_or_else(|error| panic!("{text}: {error}")).si()
    }

    #[test]
    fn the_nearest_double_comes_out() {
        for (text, value) in [
            ("0.5 mm", 0.5e-3),
            ("2.9 nm", 2.9e-9),
            ("3 nm", 3e-9),
            ("70 GPa", 70e9),
            ("50 pN nm^2", 50e-30),
            ("1.2 kN", 1.2e3),
            ("4.1 pN nm", 4.1e-21),
            ("4.1 pN·nm", 4.1e-21),
            ("298 K", 298.0),
            ("25 degC", 298.15),
            ("-273.15 °C", 0.0),
            ("12.5mm", 12.5e-3),
            ("3 Å", 3e-10),
            ("1 N·m", 1.0),
            ("2 kgf", 19.6133),
            ("1 in", 0.0254),
            ("1 ft", 0.3048),
            ("3 um", 3e-6),
            ("3 µm", 3e-6),
            ("3 \u{3bc}m", 3e-6),
            ("1e-3 m", 1e-3),
            ("1E3m", 1e3),
            ("5 N/mm", 5e3),
            ("1 MPa", 1e6),
            ("3 dyn", 3e-5),
            ("7 cN", 7e-2),
            ("90°", FRAC_PI_2),
            ("180 deg", TAU / 2.0),
            ("0.25 rev", FRAC_PI_2),
            ("200 turns/m", 200.0 * TAU),
            ("200 tpm", 200.0 * TAU),
            ("205000 N/mm2", 205e9),
            ("2 t", 2e3),
            ("90 %", 0.9),
            ("90%", 0.9),
            ("\u{2212}5 mm", -5e-3),
            (".5 mm", 5e-4),
            ("5. mm", 5e-3),
            ("+5 mm", 5e-3),
            ("0 mm", 0.0),
        ] {
            assert_eq!(si(text), value, "{text}");
        }
        assert!((si("5 turns/inch") / (5.0 * TAU / 0.0254) - 1.0).abs() < 4e-16);
        assert!((si("10 tpi") / (10.0 * TAU / 0.0254) - 1.0).abs() < 4e-16);
        assert!((si("20 deg") - 20_f64.to_radians()).abs() < 1e-16);
        assert!((si("77 degF") - 298.15).abs() < 1e-12);
        assert!((si("1 ksi") - 6_894_757.293_168_361).abs() < 1e-8);
        assert_eq!(si("1e300 fm"), 1e285);
    }

    #[test]
    fn what_is_no_quantity_is_refused_in_a_sentence() {
        for (text, part) in [
            ("", "nothing is written"),
            ("   ", "nothing is written"),
            ("mm", "does not begin with a number"),
            ("abc", "does not begin with a number"),
            ("-", "does not begin with a number"),
            (".", "does not begin with a number"),
            ("NaN", "not a finite number"),
            ("nan mm", "not a finite number"),
            ("-inf N", "not a finite number"),
            ("0,5 mm", "decimal point"),
            ("12 000 N", "is wanted here"),
            ("1,5,2 mm", "is a list"),
            ("6, 12", "is a list"),
            ("60 mm,34 mm", "is a list"),
            ("3 bp", "0.34 nm"),
            ("1.2.3 mm", "is wanted here"),
            ("5 kTB", "no unit known"),
            ("1e999 m", "too large or too small"),
            ("1e-999 m", "too large or too small"),
            ("1e999", "too large or too small"),
            ("1e400 am", "too large or too small"),
            ("1e99999999999999999999999 m", "too large or too small"),
        ] {
            let said = Quantity::parse(text).unwrap_err().to_string();
            assert!(said.contains(part), "{text:?}: {said}");
        }
    }

    /// What rope and wire trades write: taken where it is plain, else with what to write, of the same size.
    #[test]
    fn customary_units_are_taken_or_another_of_their_size_is_said() {
        assert_eq!(si("28.6 Mpsi"), si("28.6 Msi"));
        assert_eq!(si("30 kpsi"), si("30 ksi"));
        assert_eq!(si("1250 daN"), 12_500.0);
        assert_eq!(si("3 daNm"), 30.0);
        for (word, meant) in [("mpsi", "Mpsi"), ("te", "tf"), ("tonnef", "tf"), ("klbf", "kip")] {
            let said = Quantity::parse(&format!("5 {word}")).unwrap_err().to_string();
            assert!(said.contains(&format!("did you mean `{meant}`?")), "{said}");
        }
        for (word, said) in [("kdaN", "10 kN"), ("tonf", "`tf` for 1000 kgf"), ("tons", "2240 lbf")] {
            let refusal = Quantity::parse(&format!("5 {word}")).unwrap_err().to_string();
            assert!(refusal.contains(said), "{refusal}");
        }
        // a unit behind a prefix that it does not take is not proposed without it
        for word in ["kkgf", "Mlbf", "mpsi", "kin", "Mft"] {
            let refusal = Quantity::parse(&format!("5 {word}")).unwrap_err().to_string();
            let bare = word.get(1..).unwrap();
            assert!(!refusal.contains(&format!("`{bare}`")), "{refusal}");
        }
    }

    #[test]
    fn the_sentence_says_what_was_read_what_it_is_and_what_is_wanted() {
        let wrong = |read: &str, found| {
            QuantityError::WrongDimension { read: crate::quoted(read), found, wanted: "a length, such as \"0.5 mm\"" }
                .to_string()
        };
        assert_eq!(wrong("3 N", Dimension::FORCE), r#""3 N" is a force; what is wanted is a length, such as "0.5 mm""#);
        assert!(wrong("70 tex", Dimension::LINEAR_DENSITY).contains("`linear_density`"));
        assert!(wrong("70 kg", Dimension::MASS).contains("kgf"));
    }

    /// The distance in steps between neighbouring doubles of one sign.
    fn ulps(a: f64, b: f64) -> u64 {
        a.abs().to_bits().abs_diff(b.abs().to_bits())
    }

    /// Numbers of either sign and any size that no unit carries out of range.
    fn any_size() -> impl Strategy<Value = f64> {
        (any::<bool>(), 1.0_f64..10.0, -260_i32..260).prop_map(|(negative, mantissa, ten)| {
            let size: f64 = format!("{mantissa}e{ten}").parse().unwrap();
            if negative { -size } else { size }
        })
    }

    proptest! {
        #[test]
        fn a_number_in_any_unit_comes_back(value in any_size(), at in 0..every_unit().len()) {
            let unit = &every_unit()[at];
            let quantity = Quantity::parse(&format!("{value:e} {unit}")).unwrap();
            let Quantity::Measured { si, unit } = quantity else { panic!("a unit was written") };
            if unit.to_si(0.0) == 0.0 {
                prop_assert!(ulps(unit.of_si(si), value) <= 2, "{value:e} {unit} came back as {:e}", unit.of_si(si));
                prop_assert!(ulps(unit.to_si(value), si) <= 2);
                prop_assert_eq!(si.is_sign_negative(), value.is_sign_negative());
            }
        }

        #[test]
        fn a_power_of_ten_costs_no_digit(value in any_size()) {
            let shifted: f64 = format!("{value}e-30").parse().unwrap();
            prop_assert_eq!(si(&format!("{value} pN nm^2")), shifted);
            prop_assert_eq!(si(&format!("{value:e}pN·nm²")), shifted);
        }

        #[test]
        fn no_text_panics(text in ".*") {
            let _ = Quantity::parse(&text);
            let _ = Quantity::parse(&format!("1{text}"));
            let _ = Quantity::parse(&format!("1 m{text}"));
        }

        #[test]
        fn no_text_made_of_units_panics(text in "[0-9eE.+^/*·²⁻ mNµK°C-]{0,30}") {
            let _ = Quantity::parse(&text);
        }
    }
}
