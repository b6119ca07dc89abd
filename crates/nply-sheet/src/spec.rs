//! What was written, and where: the same from a file as from flags.

use std::borrow::Cow;
use std::sync::Arc;

use nply::Handedness;
use nply::mechanics::Balance;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::key::nearest;
use crate::{
    Case, Datum, Dimension, ErrorKind, KEYS, Key, Kind, Place, Quantity, QuantityError, Shape, SpecError, Table,
};

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

    /// An error about this datum, at its place.
    pub(crate) fn error(&self, kind: ErrorKind, message: impl Into<String>) -> SpecError {
        SpecError::new(kind, self.place.clone(), message).of_key(self.key.name)
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
}

/// The most legs of a path.
const MOST_LEGS: usize = 1000;

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
    /// Reads a file's text. `file_name` is used in messages only.
    ///
    /// # Errors
    /// [`SpecError`] with line and column: no TOML, an unknown key or table, a value of the wrong sort or unit, NaN or infinity.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// let error = Spec::from_toml("ply.toml", "[strand]\nradius = \"0.5 kN\"\n").unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     "ply.toml:2:10: `radius`: \"0.5 kN\" is a force; what is wanted is a length, such as \"0.5 mm\""
    /// );
    /// ```
    pub fn from_toml(file_name: &str, text: &str) -> Result<Self, SpecError> {
        let name: Arc<str> = Arc::from(file_name);
        let place = |bytes| Place::in_file(&name, text, bytes);
        let document = DeTable::parse(text).map_err(|error| {
            let bytes = error.span().unwrap_or(0..0);
            let help = match error.message() {
                "duplicate key" => Some("it stands above already: remove one of the two".to_owned()),
                _ => unquoted(text, bytes.start),
            };
            let message = format!("this is not TOML: {}", one_line(error.message()));
            SpecError::new(ErrorKind::Syntax, place(bytes), message).with_help(help)
        })?;
        let mut spec = Self::empty(Some(place(0..0)));
        for (header, value) in in_order(document.get_ref()) {
            let written: &str = header.get_ref();
            match (written, value.get_ref()) {
                ("path", DeValue::Array(legs)) if legs.len() > MOST_LEGS => {
                    let message = format!("a path of more than {MOST_LEGS} legs is not taken: split it");
                    return Err(SpecError::new(ErrorKind::Domain, place(header.span()), message).of_key(written));
                }
                ("path", DeValue::Array(legs)) => {
                    for leg in legs.iter() {
                        spec.legs.push(Self::corner(leg, text, &place, "a leg of [[path]]")?);
                    }
                }
                ("path", _) => {
                    let message = "a path has legs: write `[[path]]` once for each, and below it what changes, such as `load.force = \"2 N\"`";
                    return Err(SpecError::new(ErrorKind::WrongType, place(header.span()), message).of_key(written));
                }
                ("map", DeValue::Table(content)) => {
                    spec.map = Some(Box::new(MapSpec::read(content, text, &place, place(header.span()))?));
                }
                _ => spec.read_table(header, value, text, &place)?,
            }
        }
        Ok(spec)
    }

    /// Nothing given yet.
    fn empty(start: Option<Place>) -> Self {
        Self { entries: Vec::new(), tables: Vec::new(), start, legs: Vec::new(), map: None }
    }

    /// What changes at a corner of a study: tables as in the file itself.
    fn corner(
        value: &Spanned<DeValue<'_>>,
        text: &str,
        place: &impl Fn(core::ops::Range<usize>) -> Place,
        what: &str,
    ) -> Result<Self, SpecError> {
        let mut corner = Self::empty(Some(place(value.span())));
        let DeValue::Table(content) = value.get_ref() else {
            let message = format!("{what} says what changes, such as `load.force = \"2 N\"`");
            return Err(SpecError::new(ErrorKind::WrongType, place(value.span()), message));
        };
        for (header, value) in in_order(content) {
            corner.read_table(header, value, text, place)?;
        }
        match corner.entries.iter().find(|entry| !entry.key.may_change()) {
            None => Ok(corner),
            Some(entry) => {
                let message = format!(
                    "{} cannot change within a study: {what} takes loads, twist, ends, the support's core and the stiffness ratio",
                    entry.said()
                );
                Err(entry.error(ErrorKind::Contradiction, message))
            }
        }
    }

    fn read_table(
        &mut self,
        header: &Spanned<Cow<'_, str>>,
        value: &Spanned<DeValue<'_>>,
        text: &str,
        place: &impl Fn(core::ops::Range<usize>) -> Place,
    ) -> Result<(), SpecError> {
        let written: &str = header.get_ref();
        let Some(table) = Table::ALL.into_iter().find(|table| table.name() == written) else {
            let is_table = matches!(value.get_ref(), DeValue::Table(_));
            return Err(unknown_table(written, is_table, place(header.span())));
        };
        let DeValue::Table(content) = value.get_ref() else {
            let what =
                format!("`{written}` is a table of its own: write `[{written}]` once, and its keys on the lines below");
            return Err(SpecError::new(ErrorKind::WrongType, place(header.span()), what).of_key(written));
        };
        self.tables.push((table, place(header.span())));
        for (key, value) in in_order(content) {
            let written: &str = key.get_ref();
            let Some(known) = KEYS.iter().find(|known| known.table == table && known.name == written) else {
                return Err(unknown_key(table, written, place(key.span())));
            };
            self.entries.push(read_toml(known, value, text, place(value.span()))?);
        }
        Ok(())
    }

    /// As [`Spec::from_toml`], from bytes that may not be text at all.
    ///
    /// # Errors
    /// As [`Spec::from_toml`]; and a syntax error at the first byte that is not UTF-8.
    ///
    /// ```
    /// let error = nply_sheet::Spec::from_bytes("ply.toml", b"[ply]\nab\xff").unwrap_err();
    /// assert!(error.to_string().starts_with("ply.toml:2:3: this is not UTF-8 text"));
    /// ```
    pub fn from_bytes(file_name: &str, bytes: &[u8]) -> Result<Self, SpecError> {
        match core::str::from_utf8(bytes) {
            Ok(text) => Self::from_toml(file_name, text),
            Err(error) => {
                let end = error.valid_up_to();
                let valid = bytes.get(..end).and_then(|valid| core::str::from_utf8(valid).ok()).unwrap_or("");
                let place = Place::in_file(&Arc::from(file_name), valid, end..end);
                let message = "this is not UTF-8 text: save the file as UTF-8 and try again";
                Err(SpecError::new(ErrorKind::Syntax, place, message))
            }
        }
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
        let replaced = |entry: &Entry| {
            flags.entries.iter().any(|flag| {
                flag.key.datum == entry.key.datum || (flag.key.group.is_some() && flag.key.group == entry.key.group)
            })
        };
        let mut merged = self.clone();
        merged.entries.retain(|entry| !replaced(entry));
        merged.entries.extend(flags.entries.iter().cloned());
        merged.start = merged.start.or_else(|| flags.start.clone());
        // a temperature that no persistence length asks for any more goes with it
        let persistent = [Datum::BendingPersistenceLength, Datum::TwistPersistenceLength];
        let lost = |datum: &Datum| self.get(*datum).is_some();
        if persistent.iter().any(lost) && persistent.iter().all(|datum| merged.get(*datum).is_none()) {
            merged
                .entries
                .retain(|entry| entry.key.datum != Datum::Temperature || matches!(entry.place, Place::Flag(_)));
        }
        merged
    }

    /// Understands the description as a whole: dimensionless numbers and one question.
    ///
    /// # Errors
    /// [`SpecError`]: a datum is missing, data contradict each other or are too many, a unit stands where the input has no
    /// scale (or the reverse), or no ply can be like this.
    ///
    /// ```
    /// use nply_sheet::{ErrorKind, Spec};
    /// let spec = Spec::from_flags([("strands", "1"), ("stiffness-ratio", "1"), ("pretwist", "-1")])?;
    /// assert_eq!(spec.check().unwrap_err().kind(), ErrorKind::Domain);
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn check(&self) -> Result<Case, SpecError> {
        Case::of(self, false)
    }

    /// As [`Spec::check`], asking what carries the strands ([`Question::Supported`](crate::Question::Supported)) whether or not a
    /// core is given; without one, strands touch their neighbours or nothing.
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::check`], and where the shape is given, `separation` is asked, the balance is radial or an
    /// external pressure acts.
    ///
    /// ```
    /// use nply_sheet::{Report, Spec};
    /// let flags = [("strands", "2"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2"), ("force", "-0.3"), ("moment", "0.9")];
    /// let report = Report::of(Spec::from_flags(flags)?.check_supports()?)?;
    /// let json: serde_json::Value = serde_json::from_str(&report.json())?;
    /// let open = json["states"].as_array().and_then(|states| states.iter().find(|state| state["support"] == "none"));
    /// let angle = open.and_then(|state| state["helical_angle_deg"].as_f64()).unwrap_or(0.0);
    /// assert!((angle - 50.36).abs() < 0.01); // free helices
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn check_supports(&self) -> Result<Case, SpecError> {
        Case::of(self, true)
    }

    /// The number of strands alone, 1 to a million.
    ///
    /// # Errors
    /// [`SpecError`] if it is missing or no ply has it.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// assert_eq!(Spec::from_flags([("strands", "3")])?.check_strands()?, 3);
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn check_strands(&self) -> Result<u32, SpecError> {
        crate::case::strands(self, 1)
    }

    /// Understands the shape alone: number of strands, lay, and the strand's radius if given.
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::check`]; one strand is accepted.
    ///
    /// ```
    /// use nply_sheet::{Lay, Spec};
    /// let shape = Spec::from_flags([("strands", "2"), ("helical-angle", "45 deg")])?.check_shape()?;
    /// assert_eq!(shape.lay, Some(Lay::HelicalAngle(core::f64::consts::FRAC_PI_4)));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn check_shape(&self) -> Result<Shape, SpecError> {
        Shape::of(self)
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

impl MapSpec {
    fn read(
        content: &DeTable<'_>,
        text: &str,
        place: &impl Fn(core::ops::Range<usize>) -> Place,
        here: Place,
    ) -> Result<Self, SpecError> {
        let empty = || Spec::empty(Some(here.clone()));
        let mut map = Self { from: empty(), to: empty(), columns: None, rows: None, place: here.clone() };
        for (key, value) in in_order(content) {
            let written: &str = key.get_ref();
            let count = || match value.get_ref() {
                DeValue::Integer(number) => number.as_str().parse::<f64>().ok(),
                _ => None,
            };
            match written {
                "from" => map.from = Spec::corner(value, text, place, "`from` in [map]")?,
                "to" => map.to = Spec::corner(value, text, place, "`to` in [map]")?,
                "columns" | "rows" => {
                    let Some(count) = count() else {
                        let message = format!("`{written}`: what is wanted is a whole number, such as 200");
                        return Err(SpecError::new(ErrorKind::WrongType, place(value.span()), message).of_key(written));
                    };
                    *(if written == "rows" { &mut map.rows } else { &mut map.columns }) =
                        Some((count, place(value.span())));
                }
                _ => {
                    let message =
                        format!("{} is no key of [map], which has from, to, columns and rows", ticked(written));
                    return Err(SpecError::new(ErrorKind::UnknownKey, place(key.span()), message).of_key(written));
                }
            }
        }
        Ok(map)
    }
}

/// The entries of a table in the order of the file.
fn in_order<'t, 'i>(table: &'t DeTable<'i>) -> Vec<(&'t Spanned<Cow<'i, str>>, &'t Spanned<DeValue<'i>>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}

/// The commonest slip: a value with a unit or a word, without quotation marks or with those of a word processor.
fn unquoted(text: &str, at: usize) -> Option<String> {
    let start = text.get(..at)?.rfind('\n').map_or(0, |newline| newline + 1);
    let (key, value) = text.get(start..)?.lines().next()?.split_once('=')?;
    let is_name = |key: &str| KEYS.iter().any(|known| known.name == key.rsplit('.').next().unwrap_or(key).trim());
    let is_in_value = at > start + key.len();
    let value = value.split('#').next()?.trim();
    let value =
        value.trim_matches(['\u{201c}', '\u{201d}', '\u{201e}', '\u{2018}', '\u{2019}', '\u{ab}', '\u{bb}']).trim();
    let bare = !value.is_empty() && !value.contains(|c: char| "\"'[]{}=".contains(c) || c.is_control());
    (bare && is_in_value && is_name(key))
        .then(|| format!("put the value in quotation marks: {} = {}", key.trim(), crate::quoted(value)))
}

/// A message of several lines on one.
fn one_line(message: &str) -> String {
    message.lines().map(str::trim).collect::<Vec<_>>().join("; ")
}

/// A name in backticks, without control characters.
fn ticked(name: &str) -> String {
    let shown = crate::quoted(name);
    format!("`{}`", shown.trim_matches('"'))
}

fn unknown_table(written: &str, is_table: bool, place: Place) -> SpecError {
    let belongs = tables_of(written).filter(|_| !is_table);
    let help = match &belongs {
        Some(tables) => Some(format!("it belongs below {tables}")),
        None => {
            nearest(written, Table::ALL.into_iter().map(Table::name)).map(|name| format!("did you mean `[{name}]`?"))
        }
    };
    let tables =
        "the tables are [ply], [strand], [twist], [lay], [load], [ends] and [support], for studies [[path]] and [map]";
    let message = match belongs {
        Some(_) => format!("{} stands in no table", ticked(written)),
        None => format!("{} is no table of a ply: {tables}", ticked(written)),
    };
    SpecError::new(ErrorKind::UnknownKey, place, message).of_key(written).with_help(help)
}

/// The tables that have a key of this name, as in `[twist] or [ends]`.
fn tables_of(name: &str) -> Option<String> {
    let tables: Vec<String> =
        KEYS.iter().filter(|key| key.name == name).map(|key| format!("[{}]", key.table.name())).collect();
    (!tables.is_empty()).then(|| tables.join(" or "))
}

fn unknown_key(table: Table, written: &str, place: Place) -> SpecError {
    let of_table = || KEYS.iter().filter(move |key| key.table == table);
    let help = match tables_of(written) {
        Some(tables) => Some(format!("it belongs below {tables}")),
        None => nearest(written, of_table().map(|key| key.name)).map(|name| format!("did you mean `{name}`?")).or_else(
            || {
                let name = nearest(written, KEYS.iter().map(|key| key.name))?;
                let key = KEYS.iter().find(|key| key.name == name)?;
                Some(format!("did you mean `{name}`, which belongs below [{}]?", key.table.name()))
            },
        ),
    };
    let message = format!("{} is no key of [{}]", ticked(written), table.name());
    let all = || format!("its keys are {}", of_table().map(|key| key.name).collect::<Vec<_>>().join(", "));
    SpecError::new(ErrorKind::UnknownKey, place, message).of_key(written).with_help(Some(help.unwrap_or_else(all)))
}

/// A value of the file, read as its key asks.
fn read_toml(key: &'static Key, value: &Spanned<DeValue<'_>>, text: &str, place: Place) -> Result<Entry, SpecError> {
    let written = text.get(value.span()).unwrap_or("");
    let written = crate::quoted(written);
    // the marks of `quoted` go: the file's own are already there
    let written = written.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')).unwrap_or("").replace("\\\"", "\"");
    let wrong = |found: &str| {
        let message = format!("`{}` is {found}; what is wanted is {}", key.name, key.kind.wanted());
        SpecError::new(ErrorKind::WrongType, place.clone(), message).of_key(key.name)
    };
    let number = |digits: &str| -> Result<Value, SpecError> {
        match key.kind.dimension() {
            Some(_) => read_text(key, digits, &place),
            None => Err(wrong("a number")),
        }
    };
    let read = match value.get_ref() {
        DeValue::String(_) if key.kind == Kind::Switch => return Err(wrong("a text")),
        DeValue::String(content) => read_text(key, content, &place)?,
        DeValue::Float(float) => number(float.as_str())?,
        DeValue::Integer(integer) if integer.radix() == 10 => number(integer.as_str())?,
        DeValue::Integer(integer) => match i64::from_str_radix(integer.as_str(), integer.radix()) {
            Ok(whole) => number(&whole.to_string())?,
            Err(_) => return Err(wrong("a number too large to be read")),
        },
        DeValue::Boolean(switch) if key.kind == Kind::Switch => Value::Switch(*switch),
        DeValue::Boolean(_) => return Err(wrong("true or false")),
        DeValue::Datetime(_) => return Err(wrong("a date")),
        DeValue::Array(_) => return Err(wrong("a list")),
        DeValue::Table(_) => return Err(wrong("a table")),
    };
    Ok(Entry { key, value: read, place, written })
}

/// A value written as text, read as its key asks.
fn read_text(key: &'static Key, text: &str, place: &Place) -> Result<Value, SpecError> {
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
    let quantity = Quantity::parse(text).map_err(|found| {
        let kind = match found {
            QuantityError::NotFinite { .. } | QuantityError::OutOfRange { .. } => ErrorKind::Domain,
            QuantityError::UnknownUnit { .. } => ErrorKind::WrongUnit,
            QuantityError::NotANumber { .. } => ErrorKind::WrongType,
            _ => ErrorKind::Syntax,
        };
        let wanted = match found {
            QuantityError::NotANumber { .. } | QuantityError::Empty => {
                Some(format!("what is wanted is {}", key.kind.wanted()))
            }
            _ => None,
        };
        error(kind, found.to_string()).with_help(wanted)
    })?;
    let right = match &quantity {
        Quantity::Bare(_) => key.kind.may_be_bare(),
        Quantity::Measured { unit, .. } => key.kind.dimension() == Some(unit.dimension()),
    };
    if right {
        return Ok(Value::Quantity(quantity));
    }
    let found = quantity.dimension();
    let said = QuantityError::WrongDimension { read: crate::quoted(text.trim()), found, wanted: key.kind.wanted() };
    // another key of the same table may be the one that takes it
    let other = KEYS
        .iter()
        .find(|other| other.table == key.table && found != Dimension::NUMBER && other.kind.dimension() == Some(found));
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
