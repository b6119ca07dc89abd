//! The words of `[sweep]`: which states, in which order, which question, how spread.

use super::refused_at;
use crate::{ErrorKind, Place, SpecError, quoted};

/// How points are spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sample {
    /// Sobol's sequence with the direction numbers of Joe and Kuo (2008), shifted digit by digit by the seed: of any 2ᵏ points from a
    /// multiple of 2ᵏ on each of 2ᵏ equal parts of a range has one.
    Sobol,
    /// A Latin hypercube: each of as many equal parts of a range as there are points has one, in an order of its own.
    Latin,
}

impl Sample {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Sobol, Self::Latin];

    /// The name in files and flags.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sobol => "sobol",
            Self::Latin => "latin",
        }
    }
}

/// Which states of a row are told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum States {
    /// Every one, a row of the table each.
    #[default]
    All,
    /// Those that are stable.
    Stable,
    /// The one that is followed from the row before, along what varies fastest.
    Continued,
}

/// How the values of several data go together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Order {
    /// Each with each; the last varies fastest.
    #[default]
    Grid,
    /// The first with the first, the second with the second.
    Zip,
}

/// What is to be found in every row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Question {
    /// The shape of a given lay, as `nply contact`.
    Contact,
    /// The states of touching strands, as `nply solve`.
    States,
    /// The states on neighbours, a core, both or free, as `nply support`.
    Supports,
}

/// A word out of a list of words.
fn chosen<T: Copy>(written: &str, place: &Place, known: &[(&str, T)]) -> Result<T, SpecError> {
    let word = written.trim().to_lowercase();
    if let Some((_, found)) = known.iter().find(|(name, _)| *name == word) {
        return Ok(*found);
    }
    let names: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
    let (last, rest) = names.split_last().unwrap_or((&"", &[]));
    let message = format!("{} is not understood: what is wanted is {} or {last}", quoted(written), rest.join(", "));
    Err(refused_at(ErrorKind::WrongType, place, message))
}

impl States {
    /// All three.
    pub const ALL: [Self; 3] = [Self::All, Self::Stable, Self::Continued];

    /// The name in files and flags.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::All => "all",
            Self::Stable => "stable",
            Self::Continued => "continued",
        }
    }

    pub(crate) fn read(written: &str, place: &Place) -> Result<Self, SpecError> {
        chosen(written, place, &Self::ALL.map(|states| (states.name(), states)))
    }
}

impl Order {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Grid, Self::Zip];

    /// The name in files and flags.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Grid => "grid",
            Self::Zip => "zip",
        }
    }

    pub(crate) fn read(written: &str, place: &Place) -> Result<Self, SpecError> {
        chosen(written, place, &Self::ALL.map(|order| (order.name(), order)))
    }
}

impl Question {
    /// All three.
    pub const ALL: [Self; 3] = [Self::Contact, Self::States, Self::Supports];

    /// The name in files and flags.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Contact => "contact",
            Self::States => "states",
            Self::Supports => "supports",
        }
    }

    pub(crate) fn read(written: &str, place: &Place) -> Result<Self, SpecError> {
        chosen(written, place, &Self::ALL.map(|question| (question.name(), question)))
    }
}

impl Sample {
    pub(crate) fn read(written: &str, place: &Place) -> Result<Self, SpecError> {
        chosen(written, place, &Self::ALL.map(|sample| (sample.name(), sample)))
    }
}
