//! Why a text is no quantity, or not the one that is wanted.

use super::Dimension;

/// Why a text is no quantity, or not the one that is wanted; each displays as one sentence.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// Nothing was written.
    #[error("nothing is written where a number is wanted, such as \"0.5\" or \"0.5 mm\"")]
    Empty,
    /// It does not begin with a number.
    #[error("{read} does not begin with a number, as in \"0.5\" or \"0.5 mm\"")]
    NotANumber {
        /// What was read, quoted.
        read: String,
    },
    /// A decimal comma.
    #[error("{read} has a comma; write a decimal point, as in \"0.5 mm\"")]
    Comma {
        /// What was read, quoted.
        read: String,
    },
    /// Several numbers.
    #[error("{read} is a list, and one number is wanted")]
    List {
        /// What was read, quoted.
        read: String,
    },
    /// A fraction, 5/32, which may have a whole number before it.
    #[error("{read} has a fraction; write a decimal number, \"{decimal}\"")]
    Fraction {
        /// What was read, quoted.
        read: String,
        /// The same to six digits, with its unit.
        decimal: String,
    },
    /// NaN or infinity.
    #[error("{read} is not a finite number; no ply has it")]
    NotFinite {
        /// What was read, quoted.
        read: String,
    },
    /// Beyond the range of a double once it is in SI.
    #[error("{read} is too large or too small to be calculated with")]
    OutOfRange {
        /// What was read, quoted.
        read: String,
    },
    /// A word that is no unit.
    #[error("{unit} is no unit known here{}", instead(*nearest))]
    UnknownUnit {
        /// The word, quoted.
        unit: String,
        /// The unit most likely meant.
        nearest: Option<&'static str>,
    },
    /// A unit expression without a clear meaning.
    #[error("the unit {unit} cannot be read: {reason}")]
    BadUnit {
        /// The expression, quoted.
        unit: String,
        /// What is wrong and what to write.
        reason: &'static str,
    },
    /// A count of a ply in place of that of one strand.
    #[error("{read} is a folded count, that of a ply: give the count of one strand, \"{single}\"{}", beside(*.strands))]
    Folded {
        /// What was read, quoted.
        read: String,
        /// The count of one strand.
        single: String,
        /// How many there are; 0 where that is what was written.
        strands: u32,
    },
    /// A count without its system.
    #[error("{read} does not say in which system it counts: write \"Ne {count}\" (cotton, hanks of 840 yards per pound) or \"Nm {count}\" (metric, km per kg){}", beside(*.strands))]
    CountOfNoSystem {
        /// What was read, quoted.
        read: String,
        /// The count of one strand.
        count: u32,
        /// How many there are; 1 for a single.
        strands: u32,
    },
    /// The resultant count of a ply, `R 74 tex/2`, in place of that of one strand.
    #[error(
        "{read} is a folded count, that of a ply: give the count of one strand, \"{at_most}\" less take-up, and {strands} strands"
    )]
    Resultant {
        /// What was read, quoted.
        read: String,
        /// The share of one strand in the ply's count. Its own is less: twist shortens the strands, and the ply is the heavier for it.
        at_most: String,
        /// How many there are.
        strands: u32,
    },
    /// A quantity of another kind than wanted.
    #[error("{read} is {found}; what is wanted is {wanted}{}", advice(*found, read))]
    WrongDimension {
        /// What was read, quoted.
        read: String,
        /// What it is.
        found: Dimension,
        /// What was wanted, with an example: `a length, such as "0.5 mm"`.
        wanted: &'static str,
    },
}

/// The strands that a folded count says, where it says any.
fn beside(strands: u32) -> String {
    match strands {
        0 | 1 => String::new(),
        strands => format!(", and {strands} strands"),
    }
}

/// What to write for a unit that is not known.
fn instead(nearest: Option<&'static str>) -> String {
    match nearest {
        Some(name) => format!("; did you mean `{name}`?"),
        None => "; write it in units such as mm, N, Pa, deg, turns or K".to_owned(),
    }
}

/// What to do with a quantity that is not asked for anywhere.
fn advice(found: Dimension, read: &str) -> &'static str {
    match found {
        // these are tonnes per metre
        Dimension::LINEAR_DENSITY if read.contains("t/m") => "; turns per metre are written `tpm` or `turns/m`",
        Dimension::LINEAR_DENSITY => "; a titre is given as `linear_density`, with the `density` of the fibre",
        Dimension::MASS => "; for a weight write kgf, tf or lbf",
        Dimension::PER_LENGTH => "; write rad/m or turns/m for a twist",
        _ => "",
    }
}
