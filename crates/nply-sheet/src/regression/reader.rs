//! A file of measurements, cell by cell: its header, and the numbers below it.

use std::sync::Arc;

use super::columns::{Column, dimension, of_bare};
use super::error::observables;
use super::heading::{Heading, is_none, joined, names, suffix};
use super::{Given, Observable};
use crate::key::nearest;
use crate::spec::hand;
use crate::{ErrorKind, Place, Quantity, QuantityError, SpecError, Unit, quoted};

/// Larger files are no measurements made by hand; they would take long.
const MOST_ROWS: usize = 1_000_000;

/// What a word of the header is.
struct Head {
    given: Given,
    error: bool,
    unit: Option<Unit>,
    place: Place,
}

/// Reads a file.
pub(super) struct Reader<'t> {
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
    pub(super) const fn new(name: &'t Arc<str>, text: &'t str) -> Self {
        Self { name, text, commas: false }
    }

    fn error(&self, kind: ErrorKind, cell: Cell<'_>, message: impl Into<String>) -> SpecError {
        let place = Place::in_file(self.name, self.text, cell.at..cell.at + cell.text.len());
        SpecError::new(kind, place, message)
    }

    /// The columns, and the line of each row.
    pub(super) fn read(mut self) -> Result<(Vec<Column>, Vec<usize>), SpecError> {
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
        let Some(Heading { given, rest, unit }) = Heading::of(word.text) else {
            let joined = joined(word.text);
            let help = match joined.as_str() {
                "turns" => Some("the twist put in stands in turns_per_length, turns over the strand length; turns of the ply in ply_turns".to_owned()),
                "end_rotation" | "surface_angle" => Some("the twist put in stands in turns_per_length or pretwist".to_owned()),
                "retraction" | "retraction_percent" => Some("write length_ratio, 1 less the retraction".to_owned()),
                _ => nearest(&joined, names().into_iter().map(|(name, _)| name)).map(|name| format!("did you mean `{name}`?")),
            };
            let message = format!(
                "{} is no column known here; those are {}, each with its errors as `…_error`, the twists pretwist, turns_per_length and \
                 strand_twist, and `note`",
                quoted(word.text.trim()),
                observables()
            );
            return Err(SpecError::new(ErrorKind::UnknownKey, place, message).with_help(help));
        };
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
            (None, "") => None,
            (Some(text), _) if is_none(text) => None,
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
        let quantity = quantity.map_err(|why: QuantityError| {
            refuse(of_no_hand(head, &point, cell.text).unwrap_or_else(|| why.to_string()))
        })?;
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

/// What is to be said of a number with S or Z where a column takes neither.
fn of_no_hand(head: &Head, text: &str, written: &str) -> Option<String> {
    let (number, Some(_)) = hand::split(text) else { return None };
    Quantity::parse(number).ok()?;
    let written = quoted(written);
    Some(match head.given {
        _ if head.error => format!("{written} says a hand, and an error has none: write it without the letter"),
        Given::State(Observable::Moment) => format!(
            "{written} says a hand, and this column has none but a sign: write it without the letter, positive where it turns to the right"
        ),
        _ => format!("{written} says a hand, and this column has none: write it without the letter"),
    })
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
