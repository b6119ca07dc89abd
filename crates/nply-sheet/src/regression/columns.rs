//! Measurements as people keep them: a header that names columns with their units, rows of numbers.

use std::sync::Arc;

use super::error::observables;
use super::{DataColumn, Given, Observable, Parameter, Role};
use crate::key::nearest;
use crate::spec::hand;
use crate::{Dimension, ErrorKind, Place, Quantity, QuantityError, SpecError, Unit, quoted};

/// A file of measurements, read: columns of numbers in SI with the line of each row.
///
/// ```
/// use nply_sheet::regression::Measurements;
/// let text = "force [N],force_error,lay_length_mm,lay_length_error_mm\n1.0,0.01,9.1,0.1\n2.0,0.01,9.6,0.1\n";
/// let data = Measurements::read("pull.csv", text.as_bytes())?;
/// assert_eq!((data.lines(), data.names()), (&[2, 3][..], vec!["force", "lay_length"]));
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Measurements {
    name: Arc<str>,
    text: String,
    columns: Vec<Column>,
    lines: Vec<usize>,
}

/// One column of numbers with its errors.
#[derive(Clone, Debug, PartialEq)]
struct Column {
    given: Given,
    values: Vec<f64>,
    errors: Option<Vec<f64>>,
    /// the unit it is written in; none for bare numbers
    unit: Option<Unit>,
    /// whether a number other than 0 stands bare
    bare: bool,
    place: Place,
}

/// What a word of the header is.
struct Head {
    given: Given,
    error: bool,
    unit: Option<Unit>,
    place: Place,
}

/// Larger files are no measurements made by hand; they would take long.
const MOST_ROWS: usize = 1_000_000;

impl Measurements {
    /// Reads text with a header, separated by commas, semicolons or tabs; lines that begin with `#` are remarks. A cell that is empty, or
    /// `NA`, is a number that is not known. Where commas part no cells they are read as decimal points; S and Z stand in place of the sign
    /// of turns and twists.
    ///
    /// # Errors
    /// [`SpecError`] with line and column: a name that is not known, a unit of another kind, a cell that is no number.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, SpecError> {
        let name: Arc<str> = Arc::from(name);
        let text = match core::str::from_utf8(bytes) {
            Ok(text) => text.strip_prefix('\u{feff}').unwrap_or(text).to_owned(),
            Err(error) => {
                let valid = String::from_utf8_lossy(&bytes[..error.valid_up_to()]).into_owned();
                let place = Place::in_file(&name, &valid, valid.len()..valid.len());
                return Err(SpecError::new(ErrorKind::Syntax, place, "this is not text in UTF-8"));
            }
        };
        let mut reader = Reader { name: &name, text: &text, commas: false };
        let (columns, lines) = reader.read()?;
        Ok(Self { columns, lines, name: Arc::clone(&name), text })
    }

    /// The line of each row, counted from 1.
    #[must_use]
    pub fn lines(&self) -> &[usize] {
        &self.lines
    }

    /// The columns' names, errors apart.
    #[must_use]
    pub fn names(&self) -> Vec<&'static str> {
        self.columns.iter().map(|column| column.given.name()).collect()
    }

    /// The file's name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The file's content.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The unit in which a column is written.
    pub(super) fn unit(&self, observable: Observable) -> Option<&Unit> {
        self.columns.iter().find(|column| column.given == Given::State(observable))?.unit.as_ref()
    }

    /// A refusal at a line of the file.
    pub(super) fn refuse(&self, line: Option<usize>, kind: ErrorKind, message: String) -> SpecError {
        let line = line.unwrap_or(1);
        let start = self.text.split_inclusive('\n').take(line - 1).map(str::len).sum::<usize>();
        let length = self.text.get(start..).and_then(|rest| rest.lines().next()).map_or(0, str::len);
        SpecError::new(kind, Place::in_file(&self.name, &self.text, start..start + length), message)
    }

    /// Columns for a regression: errors from the file or from `errors`, roles from these or from `measured`.
    pub(super) fn columns(&self, flags: &Roles, sized: bool, scaled: bool) -> Result<Vec<DataColumn>, SpecError> {
        let known = |name: &str| self.columns.iter().any(|column| column.given.name() == name);
        for (flag, name) in flags.named() {
            if !known(name) {
                let help = nearest(name, self.names().into_iter()).map(|name| format!("did you mean `{name}`?"));
                let message = format!("{} is no column of the data", quoted(name));
                return Err(
                    SpecError::new(ErrorKind::UnknownKey, Place::Flag(flag.to_owned()), message).with_help(help)
                );
            }
        }
        for column in &self.columns {
            check_unit(column, sized, scaled)?;
        }
        let any_error = self.columns.iter().any(|column| column.errors.is_some()) || !flags.errors.is_empty();
        let roles: Vec<Role> = self.columns.iter().map(|column| flags.role(column)).collect::<Result<_, _>>()?;
        let mut columns: Vec<DataColumn> = self
            .columns
            .iter()
            .zip(roles)
            .map(|(column, role)| DataColumn { given: column.given, values: column.values.clone(), role })
            .collect();
        // without any errors, the only shape beside loads is what was measured
        if !any_error && flags.measured.is_empty() {
            let is_shape = |column: &&mut DataColumn| matches!(column.given, Given::State(shape) if !shape.is_load());
            let mut shapes: Vec<&mut DataColumn> = columns.iter_mut().filter(is_shape).collect();
            if let [only] = &mut shapes[..]
                && !flags.held.iter().any(|held| held == only.given.name())
            {
                only.role = Role::Unweighted;
            }
        }
        Ok(columns)
    }
}

/// What flags say of columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Roles {
    pub(super) measured: Vec<String>,
    pub(super) held: Vec<String>,
    /// `name=value`, taken apart
    pub(super) errors: Vec<(String, String)>,
}

impl Roles {
    fn named(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let errors = self.errors.iter().map(|(name, _)| ("error", name.as_str()));
        let measured = self.measured.iter().map(|name| ("measured", name.as_str()));
        measured.chain(self.held.iter().map(|name| ("held", name.as_str()))).chain(errors)
    }

    fn role(&self, column: &Column) -> Result<Role, SpecError> {
        let name = column.given.name();
        let listed = |list: &[String]| list.iter().any(|word| word == name);
        let refuse = |flag: &str, message: String| {
            Err(SpecError::new(ErrorKind::Contradiction, Place::Flag(flag.to_owned()), message))
        };
        let said = self.errors.iter().find(|(word, _)| word == name);
        if let (Given::Twist(_), true) =
            (column.given, said.is_some() || listed(&self.measured) || column.errors.is_some())
        {
            let message = format!("{name} is put into the strands and held: it has no errors here");
            return match said {
                Some(_) => refuse("error", message),
                None if listed(&self.measured) => refuse("measured", message),
                None => Err(SpecError::new(ErrorKind::Contradiction, column.place.clone(), message)),
            };
        }
        if listed(&self.held) {
            return if listed(&self.measured) || said.is_some() {
                refuse("held", format!("{name} is held or measured, not both"))
            } else {
                Ok(Role::Held)
            };
        }
        match (said, &column.errors) {
            (Some(_), Some(_)) => {
                refuse("error", format!("the data have a column of errors of {name} already: remove one of them"))
            }
            (Some((_, text)), None) => error_of(column, text).map(Role::Measured),
            (None, Some(errors)) => Ok(Role::Measured(errors.clone())),
            (None, None) if listed(&self.measured) => Ok(Role::Unweighted),
            (None, None) => Ok(Role::Held),
        }
    }
}

/// `0.5 deg` for every row, or `2 %` of each number.
fn error_of(column: &Column, text: &str) -> Result<Vec<f64>, SpecError> {
    let name = column.given.name();
    let refuse = |kind, message: String| SpecError::new(kind, Place::Flag("error".to_owned()), message);
    let positive = |error: f64| {
        if error > 0.0 && error < f64::INFINITY {
            Ok(error)
        } else {
            Err(refuse(
                ErrorKind::Domain,
                format!("an error of {} in {name}; one greater than 0 is wanted", quoted(text)),
            ))
        }
    };
    if let Some(share) = text.trim().strip_suffix('%') {
        let share = Quantity::parse(share).map_err(|why| refuse(ErrorKind::Syntax, why.to_string()))?.si();
        let share = positive(share)? / 100.0;
        if column.values.contains(&0.0) {
            let message = format!("{} of {name} is no error where {name} is 0: give a size", quoted(text));
            return Err(refuse(ErrorKind::Domain, message));
        }
        return Ok(column.values.iter().map(|value| share * value.abs()).collect());
    }
    let quantity = Quantity::parse(text).map_err(|why| refuse(ErrorKind::Syntax, why.to_string()))?;
    let error = match (&quantity, &column.unit) {
        (Quantity::Bare(value), Some(unit)) => unit.to_si(*value),
        (Quantity::Bare(value), None) => value * of_bare(column.given),
        (Quantity::Measured { si, unit }, _) => {
            let wanted = dimension(column.given);
            if unit.dimension() != wanted || column.unit.is_none() && wanted != Dimension::ANGLE {
                let message = format!("{} is {}; the error of {name} is {wanted}", quoted(text), unit.dimension());
                return Err(refuse(ErrorKind::WrongUnit, message));
            }
            *si
        }
    };
    Ok(vec![positive(error)?; column.values.len()])
}

fn dimension(given: Given) -> Dimension {
    match given {
        Given::State(observable) => observable.dimension(),
        Given::Twist(parameter) => parameter.dimension(),
    }
}

fn of_bare(given: Given) -> f64 {
    match given {
        Given::State(observable) => observable.of_bare(),
        Given::Twist(Parameter::TurnsPerLength) => core::f64::consts::TAU,
        Given::Twist(_) => 1.0,
    }
}

/// A unit where the strand has a size, none where it has none.
fn check_unit(column: &Column, sized: bool, scaled: bool) -> Result<(), SpecError> {
    let dimension = dimension(column.given);
    let name = column.given.name();
    let measured = match dimension {
        Dimension::NUMBER => return Ok(()),
        Dimension::ANGLE => {
            if column.bare && column.given != Given::State(Observable::PlyTurns) {
                let message = format!("{name} has no unit: write it as `{name}_deg` or `{name} [rad]`");
                return Err(SpecError::new(ErrorKind::WrongUnit, column.place.clone(), message));
            }
            return Ok(());
        }
        Dimension::FORCE | Dimension::MOMENT => scaled,
        _ => sized,
    };
    let load = matches!(dimension, Dimension::FORCE | Dimension::MOMENT);
    let message = match (measured, column.unit.is_some(), column.bare) {
        (true, false, true) => {
            format!("{name} has no unit, but the strand has: write it as `{name} [{}]`", example(dimension))
        }
        (false, true, _) if load && sized => {
            format!(
                "{name} has a unit, but the strand has no stiffness to measure it by: give bending_stiffness, roughly where it is to be estimated"
            )
        }
        (false, true, _) => {
            format!(
                "{name} has a unit, but the strand has no size to measure it by: give it, roughly where it is to be estimated, or write bare numbers in units of r = B = 1"
            )
        }
        (false, false, true) if load && sized => {
            format!("{name} has no unit, but the strand has a size: write its unit, and give bending_stiffness")
        }
        _ => return Ok(()),
    };
    Err(SpecError::new(ErrorKind::WrongUnit, column.place.clone(), message))
}

fn example(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::FORCE => "N",
        Dimension::MOMENT => "N mm",
        Dimension::LENGTH => "mm",
        _ => "turns/m",
    }
}

/// Reads a file.
struct Reader<'t> {
    name: &'t Arc<str>,
    text: &'t str,
    /// whether a comma in a cell is that of a decimal: it parts no cells
    commas: bool,
}

/// A cell with where it stands.
#[derive(Clone, Copy)]
struct Cell<'t> {
    text: &'t str,
    at: usize,
}

impl<'t> Reader<'t> {
    fn error(&self, kind: ErrorKind, cell: Cell<'_>, message: impl Into<String>) -> SpecError {
        let place = Place::in_file(self.name, self.text, cell.at..cell.at + cell.text.len());
        SpecError::new(kind, place, message)
    }

    fn read(&mut self) -> Result<(Vec<Column>, Vec<usize>), SpecError> {
        let mut heads: Option<(char, Vec<Option<Head>>)> = None;
        let mut cells: Vec<Vec<f64>> = Vec::new();
        let mut bare: Vec<bool> = Vec::new();
        let mut units: Vec<Option<Unit>> = Vec::new();
        let mut lines = Vec::new();
        let mut at = 0;
        for (i, line) in self.text.split_inclusive('\n').enumerate() {
            let start = at;
            at += line.len();
            let content = line.trim_end_matches(['\n', '\r']);
            if content.trim().is_empty() || content.trim_start().starts_with('#') {
                continue;
            }
            let Some((separator, heads)) = &heads else {
                let separator = [';', '\t'].into_iter().find(|c| content.contains(*c)).unwrap_or(',');
                self.commas = separator != ',';
                let read = self.heads(&split(content, separator, start))?;
                cells = vec![Vec::new(); read.len()];
                bare = vec![false; read.len()];
                units = read.iter().map(|head| head.as_ref().and_then(|head| head.unit.clone())).collect();
                heads = Some((separator, read));
                continue;
            };
            let row = split(content, *separator, start);
            if row.iter().all(|cell| cell.text.is_empty()) {
                continue;
            }
            if row.len() != heads.len() {
                let whole = Cell { text: content, at: start };
                let message = format!("this line has {} cells, the header {}", row.len(), heads.len());
                return Err(self.error(ErrorKind::Syntax, whole, message));
            }
            if lines.len() == MOST_ROWS {
                let whole = Cell { text: content, at: start };
                return Err(self.error(ErrorKind::Domain, whole, "more than a million rows are not taken"));
            }
            lines.push(i + 1);
            for (k, (cell, head)) in row.iter().zip(heads).enumerate() {
                let Some(head) = head else { continue };
                let value = self.number(*cell, head, &mut units[k])?;
                if head.error && value <= 0.0 {
                    let message = format!(
                        "an error of {} in {}; one greater than 0 is wanted",
                        quoted(cell.text),
                        head.given.name()
                    );
                    return Err(self.error(ErrorKind::Domain, *cell, message));
                }
                let has_unit = units[k].is_some();
                bare[k] |= !has_unit && value.is_finite() && value != 0.0;
                cells[k].push(value);
            }
        }
        let Some((_, heads)) = heads else {
            let nothing = Cell { text: "", at: 0 };
            let message = format!(
                "there is no header; it names the columns: {}, each perhaps with its errors, as in `force [N],force_error`",
                observables()
            );
            return Err(self.error(ErrorKind::Missing, nothing, message));
        };
        if lines.is_empty() {
            let nothing = Cell { text: "", at: self.text.len() };
            return Err(self.error(ErrorKind::Missing, nothing, "there is no row below the header"));
        }
        let mut columns: Vec<Column> = Vec::new();
        for (k, head) in heads.iter().enumerate() {
            let Some(Head { given, error: false, place, .. }) = head else { continue };
            let errors =
                heads.iter().position(|other| other.as_ref().is_some_and(|other| other.error && other.given == *given));
            columns.push(Column {
                given: *given,
                values: core::mem::take(&mut cells[k]),
                errors: errors.map(|at| core::mem::take(&mut cells[at])),
                unit: units[k].clone(),
                bare: bare[k],
                place: place.clone(),
            });
        }
        Ok((columns, lines))
    }

    /// The header.
    fn heads(&self, words: &[Cell<'t>]) -> Result<Vec<Option<Head>>, SpecError> {
        let mut heads: Vec<Option<Head>> = Vec::new();
        for word in words {
            let head = self.head(*word)?;
            if let Some(new) = &head
                && let Some(old) = heads.iter().flatten().find(|old| old.given == new.given && old.error == new.error)
            {
                let name = old.given.name();
                let message = if new.error {
                    format!("the errors of {name} stand in two columns: keep one")
                } else {
                    format!("{name} stands in two columns: keep one")
                };
                return Err(self.error(ErrorKind::Contradiction, *word, message));
            }
            heads.push(head);
        }
        for head in heads.iter().flatten().filter(|head| head.error) {
            if !heads.iter().flatten().any(|other| !other.error && other.given == head.given) {
                let name = head.given.name();
                let message = format!("these are errors of {name}, and there is no column {name}");
                return Err(SpecError::new(ErrorKind::Missing, head.place.clone(), message));
            }
        }
        // errors are in the unit of what they are errors of, if nothing else is said
        let written: Vec<(Given, Option<Unit>)> =
            heads.iter().flatten().filter(|head| !head.error).map(|head| (head.given, head.unit.clone())).collect();
        for head in heads.iter_mut().flatten().filter(|head| head.error && head.unit.is_none()) {
            head.unit = written.iter().find(|(given, _)| *given == head.given).and_then(|(_, unit)| unit.clone());
        }
        Ok(heads)
    }

    /// A word of the header; `None` for a column of remarks, headed `#...`, `note` or `comment`.
    fn head(&self, word: Cell<'t>) -> Result<Option<Head>, SpecError> {
        let place = Place::in_file(self.name, self.text, word.at..word.at + word.text.len());
        let lower = word.text.trim().to_lowercase();
        if ["note", "notes", "comment", "comments", "remark", "remarks"].contains(&lower.as_str()) {
            return Ok(None);
        }
        let (stem, unit) = match word.text.split_once(['[', '(']) {
            Some((stem, unit)) => (stem.trim(), Some(unit.trim_end_matches([']', ')', ' ']).trim())),
            None => (word.text.trim(), None),
        };
        let joined = stem.to_lowercase().replace([' ', '-'], "_");
        let twists = [Parameter::Pretwist, Parameter::TurnsPerLength, Parameter::StrandTwist].map(Given::Twist);
        let own = Observable::ALL.map(Given::State).into_iter().chain(twists).map(|given| (given.name(), given));
        // as reports call them
        let reported = [
            ("extension", Given::State(Observable::LengthRatio)),
            ("turns_per_ply_length", Given::State(Observable::PlyTurnsPerLength)),
        ];
        let names: Vec<(&str, Given)> = own.chain(reported).collect();
        // the longest name that begins it
        let begins = |(name, _): &&(&str, Given)| {
            joined.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
        };
        let Some((name, given)) = names.iter().filter(begins).max_by_key(|(name, _)| name.len()).copied() else {
            let help = match joined.as_str() {
                "turns" => Some("the twist put in stands in turns_per_length, turns over the strand length; turns of the ply in ply_turns".to_owned()),
                "end_rotation" | "surface_angle" => Some("the twist put in stands in turns_per_length or pretwist".to_owned()),
                "retraction" | "retraction_percent" => Some("write length_ratio, 1 less the retraction".to_owned()),
                _ => nearest(&joined, names.iter().map(|(name, _)| *name)).map(|name| format!("did you mean `{name}`?")),
            };
            let message = format!(
                "{} is no column known here; those are {}, each with its errors as `…_error`, the twists pretwist, turns_per_length and \
                 strand_twist, and `note`",
                quoted(word.text.trim()),
                observables()
            );
            return Err(SpecError::new(ErrorKind::UnknownKey, place, message).with_help(help));
        };
        let rest = stem.get(name.len()..).unwrap_or("").trim_start_matches(['_', ' ', '-']);
        let tails = ["error", "errors", "sigma", "std", "uncertainty"];
        let lower = rest.to_lowercase();
        // `force_error`, `force_error_N` and `force_N_error`
        let ahead = tails.iter().find(|tail| lower == **tail || lower.starts_with(&format!("{tail}_")));
        let behind = tails.iter().find(|tail| lower.ends_with(&format!("_{tail}")));
        let (rest, error) = match (ahead, behind) {
            (Some(tail), _) => (rest.get(tail.len()..).unwrap_or("").trim_start_matches('_'), true),
            (None, Some(tail)) => (rest.get(..rest.len() - tail.len() - 1).unwrap_or(""), true),
            (None, None) => (rest, false),
        };
        let unit = match (unit, rest) {
            (Some(_), rest) if !rest.is_empty() => {
                let message =
                    format!("{} says {} and a unit: write the unit alone", quoted(word.text.trim()), quoted(rest));
                return Err(SpecError::new(ErrorKind::Syntax, place, message));
            }
            (Some("" | "-" | "1"), _) | (None, "") => None,
            (Some(text), _) => Some(self.unit(text, &place)?),
            (None, text) => Some(self.unit(&suffix(text), &place)?),
        };
        if let Some(unit) = &unit
            && unit.dimension() != dimension(given)
        {
            let message =
                format!("{} is {}; {} is {}", quoted(unit.as_str()), unit.dimension(), given.name(), dimension(given));
            return Err(SpecError::new(ErrorKind::WrongUnit, place, message));
        }
        Ok(Some(Head { given, error, unit, place }))
    }

    fn unit(&self, text: &str, place: &Place) -> Result<Unit, SpecError> {
        Unit::parse(text).map_err(|why| SpecError::new(ErrorKind::WrongUnit, place.clone(), why.to_string()))
    }

    /// A cell: a number in the column's unit, or with a unit of its own; NaN where nothing is known.
    fn number(&self, cell: Cell<'t>, head: &Head, unit: &mut Option<Unit>) -> Result<f64, SpecError> {
        if cell.text.is_empty() || ["na", "n/a", "nan", "-", "–"].contains(&cell.text.to_lowercase().as_str()) {
            return Ok(f64::NAN);
        }
        let name = head.given.name();
        let point = if self.commas { cell.text.replacen(',', ".", 1) } else { cell.text.to_owned() };
        let (text, letter) = if has_letter(head) { hand::split(&point) } else { (&*point, None) };
        let refuse = |why: String| self.error(ErrorKind::Syntax, cell, format!("{name}: {why}"));
        // a decimal is read once, with its unit
        let quantity = match (Quantity::parse(text), &head.unit) {
            (Ok(Quantity::Bare(value)), Some(unit)) => Quantity::parse(&format!("{text} {unit}"))
                .or_else(|_| Ok(Quantity::Measured { si: unit.to_si(value), unit: unit.clone() })),
            (read, _) => read,
        };
        let quantity = quantity.map_err(|why: QuantityError| refuse(why.to_string()))?;
        match hand::signed(quantity, text, letter).map_err(refuse)? {
            Quantity::Bare(value) => Ok(value * of_bare(head.given)),
            Quantity::Measured { si, unit: own } => {
                if own.dimension() != dimension(head.given) {
                    let message = format!(
                        "{name}: {} is {}; {name} is {}",
                        quoted(cell.text),
                        own.dimension(),
                        dimension(head.given)
                    );
                    return Err(self.error(ErrorKind::WrongUnit, cell, message));
                }
                unit.get_or_insert(own);
                Ok(si)
            }
        }
    }
}

/// Whether S and Z say which way a column's turns go.
fn has_letter(head: &Head) -> bool {
    !head.error
        && match head.given {
            Given::State(observable) => observable.is_signed(),
            Given::Twist(_) => true,
        }
}

/// `N_mm` and `turns_per_m` as units.
fn suffix(text: &str) -> String {
    text.replace("_per_", "/").replace('_', " ")
}

/// Cells without blanks and quotation marks around them.
fn split(line: &str, separator: char, start: usize) -> Vec<Cell<'_>> {
    let mut cells = Vec::new();
    let mut push = |from: usize, to: usize| {
        let text = line.get(from..to).unwrap_or("");
        let blanks = text.len() - text.trim_start().len();
        let (mut text, mut at) = (text.trim(), start + from + blanks);
        if let Some(inner) = text.strip_prefix('"').and_then(|text| text.strip_suffix('"')) {
            at += 1 + inner.len() - inner.trim_start().len();
            text = inner.trim();
        }
        cells.push(Cell { text, at });
    };
    let (mut from, mut marks) = (0, false);
    for (at, c) in line.char_indices() {
        if c == '"' {
            marks = !marks;
        } else if c == separator && !marks {
            push(from, at);
            from = at + c.len_utf8();
        }
    }
    push(from, line.len());
    cells
}
