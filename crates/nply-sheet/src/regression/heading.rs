//! How a column may be called: in the header of a file, and where flags speak of it.

use super::columns::dimension;
use super::{Given, Observable, Parameter};
use crate::Unit;

/// A column's word, taken apart.
pub(super) struct Heading<'w> {
    /// what its name says
    pub(super) given: Given,
    /// what stands behind the name: `mm`, `error`, or nothing
    pub(super) rest: &'w str,
    /// the unit in brackets
    pub(super) unit: Option<&'w str>,
}

/// Every name with what it says: the columns' own, and those by which reports call them.
pub(super) fn names() -> Vec<(&'static str, Given)> {
    let twists = [Parameter::Pretwist, Parameter::TurnsPerLength, Parameter::StrandTwist].map(Given::Twist);
    let own = Observable::ALL.map(Given::State).into_iter().chain(twists).map(|given| (given.name(), given));
    let reported = [
        ("extension", Given::State(Observable::LengthRatio)),
        ("turns_per_ply_length", Given::State(Observable::PlyTurnsPerLength)),
    ];
    own.chain(reported).collect()
}

/// A word before its brackets, in small letters and joined as names are.
pub(super) fn joined(word: &str) -> String {
    apart(word).0.to_lowercase().replace([' ', '-'], "_")
}

fn apart(word: &str) -> (&str, Option<&str>) {
    match word.split_once(['[', '(']) {
        Some((stem, unit)) => (stem.trim(), Some(unit.trim_end_matches([']', ')', ' ']).trim())),
        None => (word.trim(), None),
    }
}

impl<'w> Heading<'w> {
    /// By the longest name that begins it; `None` where none does.
    pub(super) fn of(word: &'w str) -> Option<Self> {
        let (stem, unit) = apart(word);
        let joined = joined(word);
        let begins = |(name, _): &(&str, Given)| {
            joined.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
        };
        let (name, given) = names().into_iter().filter(begins).max_by_key(|(name, _)| name.len())?;
        let rest = stem.get(name.len()..).unwrap_or("").trim_start_matches(['_', ' ', '-']);
        Some(Self { given, rest, unit })
    }
}

/// The column that a flag speaks of, by any word that may head it: `lay_length`, `Lay length [mm]`, `lay_length_mm`.
pub(super) fn column_named(word: &str) -> Option<Given> {
    let Heading { given, rest, unit } = Heading::of(word)?;
    let behind = match (rest, unit) {
        ("", unit) => unit.unwrap_or("").to_owned(),
        (rest, None) => suffix(rest),
        _ => return None,
    };
    let fits = |unit: Unit| unit.dimension() == dimension(given);
    (is_none(&behind) || Unit::parse(&behind).is_ok_and(fits)).then_some(given)
}

/// Whether what stands for a unit says that there is none.
pub(super) fn is_none(unit: &str) -> bool {
    ["", "-", "1"].contains(&unit)
}

/// `N_mm` and `turns_per_m` as units.
pub(super) fn suffix(text: &str) -> String {
    text.replace("_per_", "/").replace('_', " ")
}
