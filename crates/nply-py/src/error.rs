//! Refusals of the theory and the paperwork as Python's exceptions, with the same sentences.

use nply::DomainError;
use nply_sheet::curves::ReadError;
use nply_sheet::{ErrorKind, Place, SpecError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Where the classes of exceptions stand.
const CLASSES: &str = "nply.errors";

/// An exception of a class of [`CLASSES`], with attributes.
fn raised(class: &str, message: &str, attributes: impl FnOnce(&Bound<'_, PyDict>) -> PyResult<()>) -> PyErr {
    let made = Python::attach(|py| {
        let class = py.import(CLASSES)?.getattr(class)?;
        let given = PyDict::new(py);
        attributes(&given)?;
        Ok(PyErr::from_value(class.call((message,), Some(&given))?))
    });
    made.unwrap_or_else(|error: PyErr| error)
}

/// Curves are understood, and what is asked of them does not exist.
pub fn of_curves(sentence: &str) -> PyErr {
    raised("CurveError", sentence, |_| Ok(()))
}

/// A file of curves that is refused.
pub fn of_reading(error: &ReadError) -> PyErr {
    raised("ReadError", &error.to_string(), |given| given.set_item("line", error.line()))
}

/// A premise of the theory that is broken; `row` says in which element of an array, counted in its flat order.
pub fn of_domain(error: &DomainError, row: Option<usize>) -> PyErr {
    raised("DomainError", &error.to_string(), |given| {
        given.set_item("quantity", error.quantity)?;
        given.set_item("value", error.value)?;
        given.set_item("allowed", error.allowed)?;
        given.set_item("row", row)
    })
}

/// An input that is refused. `text` is that of the document; `None` where there is none that the user has seen.
pub fn of_spec(error: &SpecError, text: Option<&str>) -> PyErr {
    let help = error.help().map(spelled);
    let sentence = spelled(error.message());
    let whole = |head: String| help.as_ref().map_or_else(|| head.clone(), |help| format!("{head}; {help}"));
    let (message, flag) = match error.place() {
        Place::File { .. } if text.is_none() => (whole(sentence.clone()), None),
        Place::File { .. } => (spelled(&error.to_string()), None),
        Place::Flag(flag) => (spelled(&error.to_string()), Some(flag.replace('-', "_"))),
    };
    raised("SpecError", &message, |given| {
        given.set_item("kind", name(error.kind()))?;
        given.set_item("sentence", sentence)?;
        given.set_item("help", help)?;
        given.set_item("key", error.key())?;
        given.set_item("argument", flag)?;
        let place = match error.place() {
            Place::File { name, line, column, .. } if text.is_some() => Some((name.as_ref(), *line, *column)),
            _ => None,
        };
        given.set_item("file", place.map(|(file, ..)| file))?;
        given.set_item("line", place.map(|(_, line, _)| line))?;
        given.set_item("column", place.map(|(.., column)| column))?;
        given.set_item("rendered", spelled(&error.render(text.unwrap_or(""))))?;
        given.set_item("exit_code", error.exit_code())
    })
}

/// The kind's name, as Rust has it, in small letters.
fn name(kind: ErrorKind) -> &'static str {
    match kind {
        ErrorKind::Syntax => "syntax",
        ErrorKind::UnknownKey => "unknown_key",
        ErrorKind::WrongType => "wrong_type",
        ErrorKind::WrongUnit => "wrong_unit",
        ErrorKind::Missing => "missing",
        ErrorKind::Contradiction => "contradiction",
        _ => "domain",
    }
}

/// Flags of the command as the arguments they are here: `--lay-length` is `lay_length`.
pub fn spelled(sentence: &str) -> String {
    let mut parts = sentence.split("--");
    let mut said = parts.next().unwrap_or("").to_owned();
    for part in parts {
        let end = part.find(|c: char| !(c.is_ascii_lowercase() || c == '-')).unwrap_or(part.len());
        let (flag, rest) = part.split_at(end);
        if flag.starts_with(|c: char| c.is_ascii_lowercase()) && !said.ends_with('-') {
            said.push_str(&flag.replace('-', "_"));
            said.push_str(rest);
        } else {
            said.push_str("--");
            said.push_str(part);
        }
    }
    said.replace("this flag", "this argument")
}
