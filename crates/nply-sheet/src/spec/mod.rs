//! What was written, and where: the same from a file as from flags.

pub(crate) mod file;
pub(crate) mod hand;
mod relative;
pub(crate) mod sweep;
mod toml_text;
mod units;
mod written;

use nply::Handedness;
use nply::mechanics::Balance;

pub(crate) use file::MAP_KEYS;

use crate::key::{Group, nearest};
use crate::{Datum, Dimension, ErrorKind, KEYS, Key, Kind, Place, Quantity, QuantityError, SpecError, Table};
use sweep::SweepSpec;
pub(crate) use toml_text::toml_text;

/// A value, read according to the kind of its key.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Quantity(Quantity),
    Balance(Balance),
    Hand(Handedness),
    Text(String),
    Switch(bool),
}

/// One datum as it was given.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Entry {
    pub(crate) key: &'static Key,
    pub(crate) value: Value,
    pub(crate) place: Place,
    /// As written, for messages: `"0.5 mm"` with its marks, `3` without.
    pub(crate) written: String,
}

impl Entry {
    /// Key and value as written: `radius = "0.5 mm"` or `--radius "0.5 mm"`.
    pub(crate) fn said(&self) -> String {
        match self.place {
            Place::File { .. } => format!("`{} = {}`", self.key.name, self.written),
            Place::Flag(ref flag) => format!("`--{flag} {}`", self.written),
        }
    }

    /// Whether it holds the ends in their rotation.
    pub(crate) const fn turns_ends(&self) -> bool {
        matches!(self.key.datum, Datum::PlyRotation | Datum::PlyTurns | Datum::PlyTurnsPerStrandLength)
    }

    /// An error about this datum, at its place.
    pub(crate) fn error(&self, kind: ErrorKind, message: impl Into<String>) -> SpecError {
        SpecError::new(kind, self.place.clone(), message).of_key(self.key.name)
    }

    /// The number of a datum, in SI or bare; NaN for one that is no number (its kind rules that out).
    pub(crate) fn number(&self) -> f64 {
        match &self.value {
            Value::Quantity(quantity) => quantity.si(),
            _ => f64::NAN,
        }
    }

    /// Whether it was written with a unit.
    pub(crate) fn is_measured(&self) -> bool {
        matches!(self.value, Value::Quantity(Quantity::Measured { .. }))
    }

    /// Whether it was written as this very number, without a unit.
    pub(crate) fn is_bare(&self, value: f64) -> bool {
        !self.is_measured() && self.number().to_bits() == value.to_bits()
    }

    /// The value, if it is greater than zero and finite.
    pub(crate) fn positive(&self, value: f64) -> Result<f64, SpecError> {
        if value > 0.0 && value < f64::INFINITY {
            return Ok(value);
        }
        let what = self.key.name.replace('_', " ");
        Err(self.error(ErrorKind::Domain, format!("{}: a {what} must be greater than 0", self.said())))
    }

    /// The value, if what follows from it can be given back in the units of a strand that has a size.
    pub(crate) fn measurable(&self, value: f64) -> Result<f64, SpecError> {
        const MOST: f64 = 1e60;
        if value.abs() <= MOST {
            return Ok(value);
        }
        let message = format!(
            "{} is {value:e} by the strand's own measure; where the strand has a size, numbers of {:e} to {MOST:e} are taken",
            self.said(),
            -MOST
        );
        Err(self.error(ErrorKind::Domain, message))
    }

    /// The value, if it is finite still after it was made dimensionless.
    pub(crate) fn finite(&self, value: f64) -> Result<f64, SpecError> {
        if value.is_finite() {
            return Ok(value);
        }
        let message = format!("{} is too large or too small to be calculated with", self.said());
        Err(self.error(ErrorKind::Domain, message))
    }
}

/// A description of one ply as it was written, each datum with its place; understood word by word, but not yet as a whole.
///
/// ```
/// use nply_sheet::Spec;
/// let text = "[ply]\nstrands = 2\n[strand]\nstiffness_ratio = 0.75\n[twist]\nsurface_angle = \"20 deg\"\n";
/// let from_file = Spec::from_toml("ply.toml", text)?.check()?;
/// let flags = [("strands", "2"), ("stiffness-ratio", "0.75"), ("surface-angle", "20 deg")];
/// let from_flags = Spec::from_flags(flags)?.check()?;
/// assert_eq!(from_file.question, from_flags.question);
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Spec {
    pub(crate) entries: Vec<Entry>,
    /// Where each table begins, as far as the file has it.
    tables: Vec<(Table, Place)>,
    /// The beginning of the file; `None` where all came from flags.
    start: Option<Place>,
    /// `[[path]]`: what changes, leg by leg.
    pub(crate) legs: Vec<Self>,
    /// `[map]`: what changes over a rectangle.
    pub(crate) map: Option<Box<MapSpec>>,
    /// `[sweep]`: what changes from row to row of a table.
    pub(crate) sweep: Option<Box<SweepSpec>>,
}

/// The most legs of a path.
pub(crate) const MOST_LEGS: usize = 1000;

/// `[map]`: the corners of a rectangle of data, and how finely it is divided.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MapSpec {
    pub(crate) from: Spec,
    pub(crate) to: Spec,
    /// Points across, and where that is said.
    pub(crate) columns: Option<(f64, Place)>,
    /// Points up, likewise.
    pub(crate) rows: Option<(f64, Place)>,
    pub(crate) place: Place,
}

impl Spec {
    /// Nothing given yet.
    fn empty(start: Option<Place>) -> Self {
        Self { entries: Vec::new(), tables: Vec::new(), start, legs: Vec::new(), map: None, sweep: None }
    }

    /// Reads flags with their values, named as in [`KEYS`], with or without dashes in front; a switch may have an empty value.
    ///
    /// # Errors
    /// [`SpecError`] naming the flag: unknown, given twice, or with a value of the wrong sort or unit.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// let error = Spec::from_flags([("--pretwst", "-1")]).unwrap_err();
    /// assert_eq!(error.to_string(), "--pretwst: this flag is not known; did you mean `--pretwist`?");
    /// ```
    pub fn from_flags<'f>(flags: impl IntoIterator<Item = (&'f str, &'f str)>) -> Result<Self, SpecError> {
        Self::from_prefixed_flags("", flags)
    }

    /// As [`Spec::from_flags`], of flags that stand for a corner of a study: `--to-force` with the prefix `to-`. The names are given
    /// without the prefix.
    ///
    /// # Errors
    /// As [`Spec::from_flags`].
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// let error = Spec::from_prefixed_flags("to-", [("force", "2 mm")]).unwrap_err();
    /// assert!(error.to_string().starts_with("--to-force: "));
    /// ```
    pub fn from_prefixed_flags<'f>(
        prefix: &str,
        flags: impl IntoIterator<Item = (&'f str, &'f str)>,
    ) -> Result<Self, SpecError> {
        let mut spec = Self::empty(None);
        for (flag, value) in flags {
            let flag = flag.strip_prefix("--").unwrap_or(flag);
            let place = Place::Flag(format!("{prefix}{flag}"));
            let Some(key) = KEYS.iter().find(|key| key.flag == flag) else {
                let help =
                    nearest(flag, KEYS.iter().map(|key| key.flag)).map(|name| format!("did you mean `--{name}`?"));
                return Err(SpecError::new(ErrorKind::UnknownKey, place, "this flag is not known")
                    .of_key(flag)
                    .with_help(help));
            };
            let entry = Entry { key, value: read_text(key, value, &place)?, place, written: crate::quoted(value) };
            if spec.get(key.datum).is_some() {
                return Err(entry.error(ErrorKind::Contradiction, "this flag is given twice; give it once"));
            }
            spec.entries.push(entry);
        }
        Ok(spec)
    }

    /// Whether it says what changes, beside what there is: `[[path]]`, `[map]` or `[sweep]`.
    ///
    /// ```
    /// let text = "ply.strands = 3\n[[path]]\nload.force = 1\n";
    /// assert!(nply_sheet::Spec::from_toml("ply.toml", text)?.is_study());
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    #[must_use]
    pub fn is_study(&self) -> bool {
        !self.legs.is_empty() || self.map.is_some() || self.sweep.is_some()
    }

    /// This description with `flags` laid over it: a datum given by a flag takes the place of the same datum, and of any
    /// other of which only one can be given (a flag `--turns` replaces the file's `pretwist`).
    ///
    /// ```
    /// use nply_sheet::{Question, Spec};
    /// use nply::mechanics::{Load, Twist};
    /// let text = "[ply]\nstrands = 2\n[strand]\nstiffness_ratio = 1\n[twist]\nsurface_angle = \"20 deg\"\n";
    /// let flags = Spec::from_flags([("pretwist", "-0.5")])?;
    /// let case = Spec::from_toml("ply.toml", text)?.overridden_by(&flags).check()?;
    /// assert_eq!(case.question, Question::States { twist: Twist::Pretwist(-0.5), load: Load::NONE });
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    #[must_use]
    pub fn overridden_by(&self, flags: &Self) -> Self {
        // strands that stretch may have their length and their rotation held at once
        let both = self.stretches() || flags.stretches();
        let replaced = |entry: &Entry| {
            flags.entries.iter().any(|flag| {
                let same_group = flag.key.group.is_some() && flag.key.group == entry.key.group;
                let beside = both && flag.turns_ends() != entry.turns_ends();
                flag.key.datum == entry.key.datum || same_group && !beside
            })
        };
        let mut merged = self.clone();
        merged.entries.retain(|entry| !replaced(entry));
        merged.entries.extend(flags.entries.iter().cloned());
        merged.start = merged.start.or_else(|| flags.start.clone());
        // a size takes the place of a titre's, and a titre with its density that of a size
        let replaces = |datum| flags.get(datum).is_some();
        let from_flag = |entry: &Entry| matches!(entry.place, Place::Flag(_));
        if flags.entries.iter().any(|flag| flag.key.group == Some(Group::Size)) {
            let of_titre = [Datum::Density, Datum::PackingFraction];
            merged.entries.retain(|entry| from_flag(entry) || !of_titre.contains(&entry.key.datum));
        } else if replaces(Datum::Density) {
            merged.entries.retain(|entry| from_flag(entry) || entry.key.group != Some(Group::Size));
        }
        // a temperature that no persistence length asks for any more goes with it
        let persistent = [Datum::BendingPersistenceLength, Datum::TwistPersistenceLength];
        let lost = |datum: &Datum| self.get(*datum).is_some();
        let still = persistent.iter().any(|datum| merged.get(*datum).is_some()) || merged.is_thermal();
        if persistent.iter().any(lost) && !still {
            merged
                .entries
                .retain(|entry| entry.key.datum != Datum::Temperature || matches!(entry.place, Place::Flag(_)));
        }
        merged
    }

    /// Where it is said that strands are to stretch.
    pub(crate) fn place_of_stretch(&self) -> Place {
        self.get(Datum::Stretch).map_or_else(|| self.head(), |entry| entry.place.clone())
    }

    /// Whether strands are to stretch.
    pub(crate) fn stretches(&self) -> bool {
        self.get(Datum::Stretch).is_some_and(|entry| entry.value == Value::Switch(true))
    }

    /// The same place with nothing given.
    pub(crate) fn nothing_given(&self) -> Self {
        Self::empty(self.start.clone())
    }

    /// The datum, if it was given.
    pub(crate) fn get(&self, datum: Datum) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.key.datum == datum)
    }

    /// The first datum of a table that was given.
    pub(crate) fn first_of(&self, table: Table) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.key.table == table)
    }

    /// How to ask for a datum: `radius` in [strand], or `--radius` where all is flags.
    pub(crate) fn ask_for(&self, datum: Datum) -> String {
        let Some(key) = Key::of(datum) else { return String::new() };
        if self.start.is_some() {
            format!("`{}` in [{}]", key.name, key.table.name())
        } else {
            format!("`--{}`", key.flag)
        }
    }

    /// The name of a datum in the language of the input: `radius`, or `--radius` where all is flags.
    pub(crate) fn call(&self, datum: Datum) -> String {
        match (Key::of(datum), &self.start) {
            (Some(key), Some(_)) => format!("`{}`", key.name),
            (Some(key), None) => format!("`--{}`", key.flag),
            (None, _) => String::new(),
        }
    }

    /// Where a datum that is missing would stand: under its table, else at the head of the file, else its own flag.
    pub(crate) fn missing(&self, datum: Datum, message: impl Into<String>) -> SpecError {
        let (name, flag, table) = Key::of(datum).map_or(("", "", Table::Ply), |key| (key.name, key.flag, key.table));
        let header = self.tables.iter().find(|(found, _)| *found == table).map(|(_, place)| place.clone());
        let place = header.or_else(|| self.start.clone()).unwrap_or_else(|| Place::Flag(flag.to_owned()));
        SpecError::new(ErrorKind::Missing, place, message).of_key(name)
    }

    /// The head of the file, or the first flag.
    pub(crate) fn head(&self) -> Place {
        let first = || self.entries.first().map(|entry| entry.place.clone());
        self.start.clone().or_else(first).unwrap_or_else(|| Place::Flag("strands".to_owned()))
    }
}

/// A value written as text, read as its key asks.
pub(crate) fn read_text(key: &'static Key, text: &str, place: &Place) -> Result<Value, SpecError> {
    let error = |kind, said: String| {
        // a flag stands before its message already
        let message = match place {
            Place::File { .. } => format!("`{}`: {said}", key.name),
            Place::Flag(_) => said,
        };
        SpecError::new(kind, place.clone(), message).of_key(key.name)
    };
    let other_word = || {
        error(
            ErrorKind::WrongType,
            format!("{} is not understood; what is wanted is {}", crate::quoted(text), key.kind.wanted()),
        )
    };
    let word = text.trim().to_lowercase();
    match key.kind {
        Kind::Text => return Ok(Value::Text(text.to_owned())),
        Kind::Switch => {
            return match word.as_str() {
                "true" | "" => Ok(Value::Switch(true)),
                "false" => Ok(Value::Switch(false)),
                _ => Err(other_word()),
            };
        }
        Kind::Balance => {
            let found = Balance::BOTH.into_iter().find(|balance| balance.name() == word);
            return found.map(Value::Balance).ok_or_else(other_word);
        }
        Kind::Hand => {
            return match word.as_str() {
                "right" | "z" => Ok(Value::Hand(Handedness::Right)),
                "left" | "s" => Ok(Value::Hand(Handedness::Left)),
                _ => Err(other_word()),
            };
        }
        _ => {}
    }
    let (number, hand) = if key.takes_hand() { hand::split(text) } else { (text, None) };
    let parsed = match key.kind {
        Kind::LinearDensity => Quantity::parse_linear_density(number),
        _ => Quantity::parse(number),
    };
    let quantity = parsed.map_err(|found| {
        let kind = match found {
            QuantityError::NotFinite { .. } | QuantityError::OutOfRange { .. } => ErrorKind::Domain,
            QuantityError::UnknownUnit { .. } => ErrorKind::WrongUnit,
            QuantityError::NotANumber { .. } => ErrorKind::WrongType,
            _ => ErrorKind::Syntax,
        };
        let wanted = || Some(format!("what is wanted is {}", key.kind.wanted()));
        match found {
            // a comma in a whole number parts two of them
            QuantityError::Comma { read } | QuantityError::List { read } if key.kind == Kind::Count => {
                let several = if key.table == Table::Layer { ", once for each layer" } else { "" };
                error(kind, QuantityError::List { read }.to_string()).with_help(wanted().map(|wanted| wanted + several))
            }
            // what units there are is said of this key's own
            QuantityError::UnknownUnit { unit, nearest: None } => {
                error(kind, format!("{unit} is no unit known here")).with_help(wanted())
            }
            QuantityError::NotANumber { .. } | QuantityError::Empty | QuantityError::List { .. } => {
                error(kind, found.to_string()).with_help(wanted())
            }
            _ => error(kind, found.to_string()),
        }
    })?;
    // 90 % is 0.9
    let quantity = match quantity {
        Quantity::Measured { si, unit }
            if unit.dimension() == Dimension::NUMBER && key.kind.dimension() == Some(Dimension::NUMBER) =>
        {
            Quantity::Bare(si)
        }
        other => other,
    };
    let right = match &quantity {
        Quantity::Bare(_) => key.kind.may_be_bare(),
        Quantity::Measured { unit, .. } => {
            key.kind.dimension() == Some(unit.dimension()) || key.kind.is_relative(unit.dimension())
        }
    };
    if right {
        let handed = hand::signed(quantity, number, hand);
        return handed.map(Value::Quantity).map_err(|said| error(ErrorKind::Contradiction, said));
    }
    let found = quantity.dimension();
    let said = QuantityError::WrongDimension { read: crate::quoted(text.trim()), found, wanted: key.kind.wanted() };
    // another key of the same table may be the one that takes it; what only strands that stretch have is seldom meant
    let takes = |other: &Key| found != Dimension::NUMBER && other.kind.dimension() == Some(found);
    let other =
        Key::every().find(|other| other.table == key.table && other.datum != Datum::AxialStiffness && takes(other));
    let help = match (other, place) {
        _ if key.kind == Kind::Angle && found == Dimension::NUMBER => {
            Some(format!("did you mean \"{} deg\" or \"{0} rad\"?", quantity.si()))
        }
        (Some(other), Place::File { .. }) => Some(format!("did you mean `{}`?", other.name)),
        (Some(other), Place::Flag(_)) => Some(format!("did you mean `--{}`?", other.flag)),
        (None, _) => None,
    };
    Err(error(ErrorKind::WrongUnit, said.to_string()).with_help(help))
}
