//! What a file says: TOML, table by table.

use std::borrow::Cow;
use std::sync::Arc;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::sweep::SweepSpec;
use super::{Entry, MOST_LEGS, MapSpec, Spec, Value, read_text};
use crate::key::nearest;
use crate::{ErrorKind, KEYS, Key, Kind, Place, SpecError, Table};

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
        let document = parse(text, &place)?;
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
                ("sweep", DeValue::Table(content)) => {
                    spec.sweep = Some(Box::new(SweepSpec::read(content, text, &place, place(header.span()))?));
                }
                _ => spec.read_table(header, value, text, &place)?,
            }
        }
        Ok(spec)
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
        Self::from_toml(file_name, utf8(file_name, bytes)?)
    }
}

/// Bytes that are meant to be text.
pub(crate) fn utf8<'b>(file_name: &str, bytes: &'b [u8]) -> Result<&'b str, SpecError> {
    core::str::from_utf8(bytes).map_err(|error| {
        let end = error.valid_up_to();
        let valid = bytes.get(..end).and_then(|valid| core::str::from_utf8(valid).ok()).unwrap_or("");
        let place = Place::in_file(&Arc::from(file_name), valid, end..end);
        let message = "this is not UTF-8 text: save the file as UTF-8 and try again";
        SpecError::new(ErrorKind::Syntax, place, message)
    })
}

/// A text as TOML, not yet understood.
pub(crate) fn parse<'t>(
    text: &'t str,
    place: &impl Fn(core::ops::Range<usize>) -> Place,
) -> Result<Spanned<DeTable<'t>>, SpecError> {
    DeTable::parse(text).map_err(|error| {
        let bytes = error.span().unwrap_or(0..0);
        let help = match error.message() {
            "duplicate key" => Some("it stands above already: remove one of the two".to_owned()),
            _ => unquoted(text, bytes.start),
        };
        let message = format!("this is not TOML: {}", one_line(error.message()));
        SpecError::new(ErrorKind::Syntax, place(bytes), message).with_help(help)
    })
}

/// The keys of `[map]`, and what they mean.
pub(crate) const MAP_KEYS: [(&str, &str); 4] = [
    ("from", "What one corner of the rectangle changes; nothing, if it is left out"),
    ("to", "What the opposite corner changes: two data, of which the first runs across and the second up"),
    ("columns", "Points across; 200 if absent"),
    ("rows", "Points up; 200 if absent"),
];

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
                    let [rest @ .., last] = MAP_KEYS.map(|(name, _)| name);
                    let known = format!("{} and {last}", rest.join(", "));
                    let message = format!("{} is no key of [map], which has {known}", ticked(written));
                    return Err(SpecError::new(ErrorKind::UnknownKey, place(key.span()), message).of_key(written));
                }
            }
        }
        Ok(map)
    }
}

/// The entries of a table in the order of the file.
pub(crate) fn in_order<'t, 'i>(table: &'t DeTable<'i>) -> Vec<(&'t Spanned<Cow<'i, str>>, &'t Spanned<DeValue<'i>>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}

/// The commonest slip: a value with a unit or a word, without quotation marks or with those of a word processor.
fn unquoted(text: &str, at: usize) -> Option<String> {
    let start = text.get(..at)?.rfind('\n').map_or(0, |newline| newline + 1);
    let (key, value) = text.get(start..)?.lines().next()?.split_once('=')?;
    let is_name = |key: &str| Key::every().any(|known| known.name == key.rsplit('.').next().unwrap_or(key).trim());
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
pub(crate) fn ticked(name: &str) -> String {
    let shown = crate::quoted(name);
    format!("`{}`", shown.trim_matches('"'))
}

pub(crate) fn unknown_table(written: &str, is_table: bool, place: Place) -> SpecError {
    let belongs = tables_of(written).filter(|_| !is_table);
    let help = match &belongs {
        Some(tables) => Some(format!("it belongs below {tables}")),
        None => {
            nearest(written, Table::ALL.into_iter().map(Table::name)).map(|name| format!("did you mean `[{name}]`?"))
        }
    };
    let tables = "the tables are [ply], [strand], [twist], [lay], [load], [ends] and [support], for studies [[path]], [map] and [sweep]";
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

pub(crate) fn unknown_key(table: Table, written: &str, place: Place) -> SpecError {
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
pub(crate) fn read_toml(
    key: &'static Key,
    value: &Spanned<DeValue<'_>>,
    text: &str,
    place: Place,
) -> Result<Entry, SpecError> {
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
