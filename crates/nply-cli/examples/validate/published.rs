//! authorities/published.toml, as read.

use serde::Deserialize;

/// Numbers and where they stand.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Published {
    #[serde(rename = "source")]
    pub(crate) sources: Vec<Source>,
    #[serde(rename = "number")]
    pub(crate) numbers: Vec<Number>,
}

/// Who published it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Source {
    pub(crate) id: String,
    pub(crate) cite: String,
    pub(crate) link: Option<String>,
}

/// How the published value came here.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Trust {
    /// Read at the source or in a public copy of it.
    Source,
    /// Read in a report on it.
    Press,
    /// Worked out from the formula printed there.
    Formula,
    /// Quoted from memory of the literature.
    Memory,
}

/// One published number, and what gives ours.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Number {
    pub(crate) id: String,
    pub(crate) group: String,
    pub(crate) source: String,
    /// Where in the source, or for which data.
    pub(crate) place: Option<String>,
    pub(crate) quantity: String,
    pub(crate) unit: String,
    /// Its digits as printed.
    pub(crate) published: String,
    /// How it stands there, where that is not a decimal number.
    pub(crate) printed: Option<String>,
    /// An exact number rather than one of so many digits.
    #[serde(default)]
    pub(crate) exact: bool,
    pub(crate) trust: Trust,
    /// One command, or several joined by bars, the first word of each `nply`.
    pub(crate) command: Option<String>,
    /// Where in the command's JSON or CSV.
    pub(crate) path: Option<String>,
    /// The library's call where no command gives the number.
    pub(crate) theory: Option<String>,
    /// From the unit there to the published one.
    pub(crate) times: Option<f64>,
    /// The command gives the angle to the axis, the source that to the plane across it.
    #[serde(default)]
    pub(crate) complement: bool,
    /// The source's own tolerance, and where it is from.
    pub(crate) within: Option<f64>,
    pub(crate) within_because: Option<String>,
    /// Ours less published, as stated.
    pub(crate) difference: Option<f64>,
    pub(crate) why: Option<String>,
}

impl Published {
    pub(crate) fn read(text: &str) -> Result<Self, String> {
        toml::from_str(text).map_err(|error| error.to_string())
    }

    pub(crate) fn source(&self, number: &Number) -> Option<&Source> {
        self.sources.iter().find(|source| source.id == number.source)
    }

    /// Groups in the order of their first number.
    pub(crate) fn groups(&self) -> Vec<&str> {
        let mut groups: Vec<&str> = Vec::new();
        for number in &self.numbers {
            if !groups.contains(&number.group.as_str()) {
                groups.push(&number.group);
            }
        }
        groups
    }
}

/// A printed number: its value, and how many decimals it is good for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Printed {
    pub(crate) value: f64,
    pub(crate) decimals: usize,
}

/// Exact numbers are compared to so many decimals.
const DECIMALS_OF_EXACT: usize = 9;

impl Number {
    pub(crate) fn value(&self) -> Result<Printed, String> {
        let text = self.published.as_str();
        let value = text.parse().map_err(|_| format!("{}: \"{text}\" is not a number", self.id))?;
        let after_point = text.split_once('.').map_or(0, |(_, digits)| digits.len());
        Ok(Printed { value, decimals: if self.exact { DECIMALS_OF_EXACT } else { after_point } })
    }
}

impl Printed {
    /// One unit of the last printed digit.
    pub(crate) fn last_digit(self) -> f64 {
        (0..self.decimals).fold(1.0, |unit, _| unit / 10.0)
    }
}
