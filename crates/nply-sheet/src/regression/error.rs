//! Why there are no estimates.

use super::{Observable, Parameter};

/// Why measurements give no estimates; each displays as one sentence.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RegressionError {
    /// It was not to go on.
    #[error("the search was stopped")]
    Stopped,
    /// Nothing is asked for.
    #[error("nothing is to be estimated: name one or more of {}", names())]
    NothingAsked,
    /// Two forms of one number.
    #[error("{first} and {second} are one number in two forms: estimate one of them")]
    Twice {
        /// One.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
    /// A number is neither given nor a column.
    #[error("{0} is neither given nor estimated from a start: give it, a rough value where it is to be estimated")]
    Missing(
        /// Its name.
        &'static str,
    ),
    /// A number cannot be written in the form asked for.
    #[error("{0} cannot be estimated while the twist is given in another way: give the start as {0}")]
    Form(
        /// Its name.
        &'static str,
    ),
    /// The twist runs from row to row.
    #[error("{0} is a column of the data and held in each row: it cannot be estimated too")]
    Column(
        /// Its name.
        &'static str,
    ),
    /// A column twice.
    #[error("the column {0} is given twice")]
    SameColumn(
        /// Its name.
        &'static str,
    ),
    /// Columns of different lengths.
    #[error("the column {name} has {found} rows, the first {expected}")]
    Length {
        /// Its name.
        name: &'static str,
        /// Its rows.
        found: usize,
        /// Those of the first.
        expected: usize,
    },
    /// An error that is none.
    #[error("line {line}: an error of {value} in {name}; one greater than 0 is wanted")]
    Uncertainty {
        /// Its line.
        line: usize,
        /// The column.
        name: &'static str,
        /// What was given.
        value: f64,
    },
    /// No column is measured.
    #[error(
        "no column is measured: give errors with one, as a column `{0}_error` or by --error, or say --measured {0}"
    )]
    NothingMeasured(
        /// A column there is.
        &'static str,
    ),
    /// Several columns without errors cannot be weighed.
    #[error(
        "{first} and {second} are measured without errors and cannot be weighed against each other: give errors with them"
    )]
    Unweighed {
        /// One.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
    /// One with errors, one without.
    #[error(
        "{without} is measured without errors beside {with}, which has them: give errors with both, or hold {without}"
    )]
    HalfWeighed {
        /// One.
        without: &'static str,
        /// The other.
        with: &'static str,
    },
    /// The strand length is needed.
    #[error("the strand length is missing, without which {0} says nothing of the shape: give it")]
    NoLength(
        /// The column.
        &'static str,
    ),
    /// More is held than a state can keep.
    #[error("line {line}: {} are held, and a state keeps no more than {}", .held.join(", "), if *.shapes { "one shape, since strands do not stretch" } else { "two of them" })]
    Overheld {
        /// Its line.
        line: usize,
        /// What is held.
        held: Vec<&'static str>,
        /// whether two shapes are held, of strands that do not stretch
        shapes: bool,
    },
    /// Too little in a row.
    #[error("line {line} has {found} of two numbers that fix a state: give a load or a shape more, held or measured")]
    Underfixed {
        /// Its line.
        line: usize,
        /// How many there are.
        found: usize,
    },
    /// More parameters than data.
    #[error(
        "{unknown} numbers are to be estimated from {known} that are measured and not used up by the rows' own states: give more rows, or estimate fewer"
    )]
    TooFew {
        /// To be estimated.
        unknown: usize,
        /// What is left of the measured numbers.
        known: usize,
    },
    /// A row has no equilibrium.
    #[error("{}: no state of touching strands has what is held there, at the start values nor at others tried: look at signs and units, give a start nearer to the truth, or leave the row out", said(.lines))]
    NoState {
        /// Their lines.
        lines: Vec<usize>,
    },
    /// A row whose measurement no ply comes near to.
    #[error("line {line}: {}", out_of_reach(.name, &.measured.to_string(), &.limit.to_string(), *.least))]
    OutOfReach {
        /// Its line.
        line: usize,
        /// What was measured.
        name: &'static str,
        /// The number, SI.
        measured: f64,
        /// Where what can be ends, SI.
        limit: f64,
        /// Whether that is the least, else the greatest.
        least: bool,
    },
    /// There is no answer, and with turns counted the other way there is one.
    #[error("{error}. {}", of_signs(.columns))]
    Signs {
        /// Columns with a sign.
        columns: Vec<&'static str>,
        /// Why there is no answer.
        error: Box<Self>,
    },
    /// Known with an error, and held.
    #[error("{0} is held, and what is held counts as exact: name it in --estimate too")]
    KnownNotAsked(
        /// Its name.
        &'static str,
    ),
    /// An error that is none.
    #[error("an error of {value} in {name}; one greater than 0 is wanted")]
    KnownTo {
        /// Its name.
        name: &'static str,
        /// What was given.
        value: f64,
    },
    /// Known with an error beside measurements without.
    #[error("{0} is known with an error, and the measurements have none to weigh it against: give errors with them")]
    KnownUnweighed(
        /// Its name.
        &'static str,
    ),
    /// No rows.
    #[error("there is no row of measurements")]
    NoRows,
    /// The theory refuses a number.
    #[error("{0}")]
    Domain(#[from] nply::DomainError),
}

impl RegressionError {
    /// What a command should end with: 1 where understood, but no ply has it, else 2.
    #[must_use]
    pub const fn exit_code(&self) -> u8 {
        match self {
            Self::NoState { .. } | Self::OutOfReach { .. } | Self::Domain(_) => 1,
            Self::Signs { error, .. } => error.exit_code(),
            _ => 2,
        }
    }

    /// The first line it is about, where there is one.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        match self {
            Self::Uncertainty { line, .. }
            | Self::Overheld { line, .. }
            | Self::Underfixed { line, .. }
            | Self::OutOfReach { line, .. } => Some(*line),
            Self::Signs { error, .. } => error.line(),
            Self::NoState { lines } => lines.first().copied(),
            _ => None,
        }
    }
}

fn said(numbers: &[usize]) -> String {
    lines(numbers)
}

/// The limit that is no state.
pub(super) const fn limit_of(flat: bool) -> &'static str {
    if flat { "flat rings (90°)" } else { "straight strands (0°)" }
}

/// What is said of a measurement that no ply comes near to, its numbers in some unit.
pub(super) fn out_of_reach(name: &str, measured: &str, limit: &str, least: bool) -> String {
    format!(
        "no ply of these strands has {name} {measured}: it is {} {limit}, at whatever angle; look at size, unit and sign, or leave the row out",
        if least { "at least" } else { "at most" }
    )
}

/// What is to be asked where turns counted the other way fit.
pub(super) fn of_signs(columns: &[&'static str]) -> String {
    format!(
        "With the signs of {} turned round the measurements fit: are they right? S is negative, and a ply let go winds against the twist in its \
         strands",
        columns.join(" and ")
    )
}

fn names() -> String {
    Parameter::ALL.map(Parameter::name).join(", ")
}

/// `line 7`, `lines 3, 4 and 9`, `lines 3, 4, 5, 6, 7 and 12 more`.
pub(super) fn lines(lines: &[usize]) -> String {
    const MOST: usize = 8;
    let said: Vec<String> = lines.iter().take(MOST).map(usize::to_string).collect();
    match (&said[..], lines.len()) {
        ([one], 1) => format!("line {one}"),
        (said, all) if all > MOST => format!("lines {} and {} more", said.join(", "), all - MOST),
        ([first @ .., last], _) => format!("lines {} and {last}", first.join(", ")),
        ([], _) => "no line".to_owned(),
    }
}

/// The columns that can be held or measured, for a message.
pub(super) fn observables() -> String {
    Observable::ALL.map(Observable::name).join(", ")
}
