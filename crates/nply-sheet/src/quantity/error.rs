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
    #[error(
        "{read} is a folded count, that of a ply: give the count of one strand, \"{single}\", and {strands} strands"
    )]
    Folded {
        /// What was read, quoted.
        read: String,
        /// The count of one strand.
        single: String,
        /// How many there are.
        strands: u32,
    },
    /// A quantity of another kind than wanted.
    #[error("{read} is {found}; what is wanted is {wanted}{}", advice(*found))]
    WrongDimension {
        /// What was read, quoted.
        read: String,
        /// What it is.
        found: Dimension,
        /// What was wanted, with an example: `a length, such as "0.5 mm"`.
        wanted: &'static str,
    },
}

/// What to write for a unit that is not known.
fn instead(nearest: Option<&'static str>) -> String {
    match nearest {
        Some(name) => format!("; did you mean `{name}`?"),
        None => "; write it in units such as mm, N, Pa, deg, turns or K".to_owned(),
    }
}

/// What to do with a quantity that is not asked for anywhere.
fn advice(found: Dimension) -> &'static str {
    match found {
        Dimension::LINEAR_DENSITY => "; a titre is given as `linear_density`, with the `density` of the fibre",
        Dimension::MASS => "; for a weight write kgf, tf or lbf",
        Dimension::PER_LENGTH => "; write rad/m or turns/m for a twist",
        _ => "",
    }
}
