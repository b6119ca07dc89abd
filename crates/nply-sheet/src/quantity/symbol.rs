//! The table of units and prefixes, and their sizes as exact factors.

use super::Dimension;
use super::double::Double;

/// numerator/denominator·10^ten·(2π)^turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Factor {
    pub(super) numerator: f64,
    pub(super) denominator: f64,
    pub(super) ten: i32,
    pub(super) turns: i16,
}

impl Factor {
    pub(super) const ONE: Self = Self { numerator: 1.0, denominator: 1.0, ten: 0, turns: 0 };

    /// Times `other` to the power.
    pub(super) fn times(self, other: Self, power: i16) -> Self {
        let mut product = self;
        for _ in 0..power.unsigned_abs() {
            if power > 0 {
                product.numerator *= other.numerator;
                product.denominator *= other.denominator;
                product.ten += other.ten;
                product.turns += other.turns;
            } else {
                product.numerator *= other.denominator;
                product.denominator *= other.numerator;
                product.ten -= other.ten;
                product.turns -= other.turns;
            }
        }
        product
    }

    /// The size, and the power of ten that is still to be multiplied: 0 unless it passes what a double holds exactly.
    pub(super) fn size(self) -> (Double, i32) {
        const MOST_TENS: i32 = 22;
        let (folded, rest) = if self.ten.abs() <= MOST_TENS { (self.ten, 0) } else { (0, self.ten) };
        let mut over = Double::exactly(self.numerator);
        let mut under = Double::exactly(self.denominator);
        let tens = Double::exactly(times_ten_to(1.0, folded.abs()));
        if folded > 0 {
            over = over.times(tens);
        } else {
            under = under.times(tens);
        }
        for _ in 0..self.turns.unsigned_abs() {
            if self.turns > 0 {
                over = over.times(Double::TAU);
            } else {
                under = under.times(Double::TAU);
            }
        }
        (over.over(under), rest)
    }
}

/// One unit of the table.
struct Symbol {
    names: &'static [&'static str],
    factor: Factor,
    dimension: Dimension,
    prefixes: bool,
    zero: f64,
}

const fn symbol(names: &'static [&'static str], numerator: f64, ten: i32, dimension: Dimension) -> Symbol {
    Symbol {
        names,
        factor: Factor { numerator, denominator: 1.0, ten, turns: 0 },
        dimension,
        prefixes: false,
        zero: 0.0,
    }
}

impl Symbol {
    const fn over(mut self, denominator: f64) -> Self {
        self.factor.denominator = denominator;
        self
    }

    const fn turned(mut self) -> Self {
        self.factor.turns = 1;
        self
    }

    const fn prefixed(mut self) -> Self {
        self.prefixes = true;
        self
    }

    const fn starting_at(mut self, zero: f64) -> Self {
        self.zero = zero;
        self
    }
}

const LBF: f64 = 44_482_216_152_605.0; // ·10⁻¹³ N, exact by definition
const KGF: f64 = 980_665.0; // ·10⁻⁵ N, exact by definition

static SYMBOLS: [Symbol; 37] = [
    symbol(&["m", "metre", "metres", "meter", "meters"], 1.0, 0, Dimension::LENGTH).prefixed(),
    symbol(&["Å", "\u{212b}", "angstrom", "angstroms", "Angstrom"], 1.0, -10, Dimension::LENGTH),
    symbol(&["micron", "microns"], 1.0, -6, Dimension::LENGTH),
    symbol(&["in", "inch", "inches"], 254.0, -4, Dimension::LENGTH),
    symbol(&["ft", "foot", "feet"], 3048.0, -4, Dimension::LENGTH),
    symbol(&["yd", "yard", "yards"], 9144.0, -4, Dimension::LENGTH),
    symbol(&["mil", "mils", "thou"], 254.0, -7, Dimension::LENGTH),
    symbol(&["N", "newton", "newtons"], 1.0, 0, Dimension::FORCE).prefixed(),
    symbol(&["dyn"], 1.0, -5, Dimension::FORCE).prefixed(),
    symbol(&["lbf"], LBF, -13, Dimension::FORCE),
    symbol(&["ozf"], LBF, -13, Dimension::FORCE).over(16.0),
    symbol(&["kip", "kips"], LBF, -10, Dimension::FORCE),
    symbol(&["kgf", "kp"], KGF, -5, Dimension::FORCE),
    symbol(&["gf"], KGF, -8, Dimension::FORCE),
    symbol(&["tf"], KGF, -2, Dimension::FORCE),
    symbol(&["Pa"], 1.0, 0, Dimension::PRESSURE).prefixed(),
    symbol(&["bar"], 1.0, 5, Dimension::PRESSURE).prefixed(),
    symbol(&["psi"], LBF, -5, Dimension::PRESSURE).over(64_516.0),
    symbol(&["ksi", "kpsi"], LBF, -2, Dimension::PRESSURE).over(64_516.0),
    symbol(&["Msi", "Mpsi"], LBF, 1, Dimension::PRESSURE).over(64_516.0),
    symbol(&["J"], 1.0, 0, Dimension::MOMENT).prefixed(),
    // Boltzmann's constant, exact by definition; the temperature is that of the strands
    symbol(&["kT", "kBT"], 1_380_649.0, -29, Dimension { temperature: -1, ..Dimension::MOMENT }),
    symbol(&["rad", "radian", "radians"], 1.0, 0, Dimension::ANGLE).prefixed(),
    symbol(&["deg", "degs", "°", "degree", "degrees"], 1.0, 0, Dimension::ANGLE).over(360.0).turned(),
    symbol(&["turn", "turns", "rev", "revs", "revolution", "revolutions"], 1.0, 0, Dimension::ANGLE).turned(),
    symbol(&["tpm"], 1.0, 0, Dimension::ANGLE_PER_LENGTH).turned(),
    symbol(&["tpi"], 1.0, 4, Dimension::ANGLE_PER_LENGTH).over(254.0).turned(),
    symbol(&["K", "kelvin"], 1.0, 0, Dimension::TEMPERATURE).prefixed(),
    symbol(&["degC", "°C", "\u{2103}"], 1.0, 0, Dimension::TEMPERATURE).starting_at(273.15),
    symbol(&["degF", "°F", "\u{2109}"], 5.0, 0, Dimension::TEMPERATURE).over(9.0).starting_at(459.67),
    symbol(&["s"], 1.0, 0, Dimension::TIME).prefixed(),
    symbol(&["g"], 1.0, -3, Dimension::MASS).prefixed(),
    symbol(&["t", "tonne", "tonnes"], 1.0, 3, Dimension::MASS),
    symbol(&["lb", "lbs"], 45_359_237.0, -8, Dimension::MASS),
    symbol(&["tex"], 1.0, -6, Dimension::LINEAR_DENSITY).prefixed(),
    symbol(&["den", "denier"], 1.0, -6, Dimension::LINEAR_DENSITY).over(9.0),
    symbol(&["%"], 1.0, -2, Dimension::NUMBER),
];

const PREFIXES: [(&str, i32); 16] = [
    ("a", -18),
    ("f", -15),
    ("p", -12),
    ("n", -9),
    ("µ", -6),       // U+00B5, the micro sign
    ("\u{3bc}", -6), // the Greek letter
    ("u", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("da", 1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
];

/// Written often enough to be proposed in place of a slip.
const COMMON: [&str; 14] = ["nm", "µm", "um", "mm", "cm", "km", "pN", "nN", "mN", "cN", "kN", "kPa", "MPa", "GPa"];

/// What some people write for units that have another name here.
const OTHERWISE: [(&[&str], &str); 5] = [
    (&["A", "Ang", "ang", "Angs"], "Å"),
    (&["C"], "°C"),
    (&["F"], "°F"),
    (&["te", "Te", "tonnef", "tonneforce", "Tf"], "tf"),
    (&["klb", "klbs", "klbf"], "kip"),
];

/// Why a word that stands where a unit does, or all that stands there, is none, and what to write.
pub(super) fn no_unit(word: &str) -> Option<&'static str> {
    match word {
        "bp" | "kbp" | "kb" | "Mbp" | "nt" => {
            Some("a base pair is no unit of length here; write the length, which for B-DNA is about 0.34 nm for each")
        }
        "AWG" | "SWG" | "BWG" => Some("a gauge is no unit; write the diameter in mm or in"),
        "d" | "D" | "xd" | "xD" => Some("a lay in diameters is a pure number, `lay_ratio`"),
        "wpi" | "WPI" => Some(
            "wraps per inch are no thickness: where 33 lie side by side in an inch, each is 1/33 inch thick, \"0.0303 inch\"",
        ),
        "ton" | "tons" | "tonf" | "tonsf" => Some(
            "a ton is of several sizes: write `tf` for 1000 kgf, \"2 kip\" for a short ton of 2000 lbf, \"2240 lbf\" for a long one",
        ),
        "kdaN" | "kdN" => Some("a unit takes one prefix: 1 kdaN is \"10 kN\""),
        "cc" => Some("a cubic centimetre is `cm^3`, and g/cc is `g/cm^3`"),
        "per" => {
            Some("write `/` for `per`: turns per inch are `turns/inch` or `tpi`, turns per metre `turns/m` or `tpm`")
        }
        "T/m" => Some("turns are written `turns`, and turns per metre `turns/m` or `tpm`"),
        _ => None,
    }
}

/// A unit that is understood, as it is listed for readers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct KnownUnit {
    /// Its names, the usual one first.
    pub names: &'static [&'static str],
    /// What it measures.
    pub dimension: Dimension,
    /// Whether its first name takes the [prefixes](unit_prefixes).
    pub takes_prefixes: bool,
}

/// Every unit that is understood by itself; others are made of them by products, powers and `/`.
///
/// ```
/// use nply_sheet::{Dimension, Unit, known_units};
/// assert!(known_units().any(|unit| unit.names.contains(&"Msi") && unit.dimension == Dimension::PRESSURE));
/// assert!(known_units().all(|unit| unit.names.iter().all(|name| Unit::parse(name).is_ok())));
/// ```
pub fn known_units() -> impl Iterator<Item = KnownUnit> {
    SYMBOLS.iter().map(|symbol| KnownUnit {
        names: symbol.names,
        // what Boltzmann's constant is multiplied with is the temperature that is given beside it
        dimension: Dimension {
            temperature: if symbol.dimension.force == 0 { symbol.dimension.temperature } else { 0 },
            ..symbol.dimension
        },
        takes_prefixes: symbol.prefixes,
    })
}

/// The prefixes that units take, from the least to the greatest.
///
/// ```
/// assert!(nply_sheet::unit_prefixes().any(|prefix| nply_sheet::Unit::parse(&format!("{prefix}N")).is_ok()));
/// ```
pub fn unit_prefixes() -> impl Iterator<Item = &'static str> {
    PREFIXES.iter().map(|(prefix, _)| *prefix)
}

/// A symbol of the table with its prefix's power of ten.
pub(super) fn look_up(word: &str) -> Option<(Factor, Dimension, f64)> {
    let named = |name: &str| SYMBOLS.iter().find(|symbol| symbol.names.contains(&name));
    if let Some(symbol) = named(word) {
        return Some((symbol.factor, symbol.dimension, symbol.zero));
    }
    PREFIXES.iter().find_map(|(prefix, ten)| {
        // only the short symbol takes a prefix: `mm`, not `mmetre`
        let rest = word.strip_prefix(prefix)?;
        let symbol = SYMBOLS.iter().find(|symbol| symbol.prefixes && symbol.names.first() == Some(&rest))?;
        let factor = Factor { ten: symbol.factor.ten + ten, ..symbol.factor };
        Some((factor, symbol.dimension, symbol.zero))
    })
}

/// `Nm`, `kNmm`, `pNnm`: a force and a length written in one word.
pub(super) fn look_up_joined(word: &str) -> Option<[(Factor, Dimension); 2]> {
    let at = word.find('N')? + 1;
    let (force, length) = word.split_at(at);
    let (force, force_dimension, _) = look_up(force)?;
    let (length, length_dimension, _) = look_up(length)?;
    (force_dimension == Dimension::FORCE && length_dimension == Dimension::LENGTH)
        .then_some([(force, force_dimension), (length, length_dimension)])
}

/// Whether it is that unit behind a prefix, which the unit does not take: many times as large or small, and so not what is meant. (`mmm` is a slip.)
fn is_multiple_of(word: &str, name: &str) -> bool {
    !COMMON.contains(&name)
        && word.strip_suffix(name).is_some_and(|prefix| PREFIXES.iter().any(|(known, _)| *known == prefix))
}

/// The unit most likely meant by `word`.
pub(super) fn nearest(word: &str) -> Option<&'static str> {
    let known = || COMMON.iter().copied().chain(SYMBOLS.iter().flat_map(|symbol| symbol.names.iter().copied()));
    if let Some((_, name)) = OTHERWISE.iter().find(|(words, _)| words.contains(&word)) {
        return Some(name);
    }
    let lower = word.to_lowercase();
    known().find(|name| name.to_lowercase() == lower).or_else(|| {
        if word.chars().count() < 2 {
            return None;
        }
        let mut near = known().filter(|name| name.chars().count() > 1 && !is_multiple_of(word, name));
        near.find(|name| strsim::osa_distance(name, word) == 1)
    })
}

/// The powers of ten that are doubles.
const EXACT: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// value·10^ten, by one rounding where |ten| ≤ 22 (such powers of ten are doubles).
pub(super) fn times_ten_to(value: f64, ten: i32) -> f64 {
    // half of it at a time, so that the power itself never overflows
    let step = |value: f64, ten: i32| {
        let small = EXACT.get(ten.unsigned_abs() as usize).copied();
        let power: f64 = small.unwrap_or_else(|| format!("1e{}", ten.abs()).parse().unwrap_or(f64::INFINITY));
        if ten < 0 { value / power } else { value * power }
    };
    if ten.abs() <= 300 { step(value, ten) } else { step(step(value, ten / 2), ten - ten / 2) }
}

/// Every symbol, for the tests: each name, with every prefix it takes.
#[cfg(test)]
pub(super) fn every_unit() -> Vec<String> {
    let mut all = Vec::new();
    for symbol in &SYMBOLS {
        for name in symbol.names {
            all.push((*name).to_owned());
        }
        if symbol.prefixes {
            for (prefix, _) in PREFIXES {
                all.push(format!("{prefix}{}", symbol.names[0]));
            }
        }
    }
    all
}
