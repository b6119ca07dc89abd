//! Lines, words and numbers of a text, with the places where they stand.

use std::sync::Arc;

use super::ReadError;
use super::error::Spot;
use crate::quoted;

/// The bytes of a file, and its name for messages.
pub(super) struct Source<'b> {
    pub(super) name: Arc<str>,
    pub(super) bytes: &'b [u8],
}

/// One line of a text, without its end.
#[derive(Clone, Copy)]
pub(super) struct Line<'b> {
    /// counted from 1
    pub(super) number: usize,
    pub(super) bytes: &'b [u8],
}

/// A word of a line and the byte of the line at which it begins.
#[derive(Clone, Copy)]
pub(super) struct Word<'t> {
    pub(super) text: &'t str,
    pub(super) at: usize,
}

impl<'b> Source<'b> {
    pub(super) fn lines(&self) -> impl Iterator<Item = Line<'b>> + Clone + use<'b> {
        // an end of line at the end of the file begins no further line
        let text = self.bytes.strip_suffix(b"\n").unwrap_or(self.bytes);
        text.split(|byte| *byte == b'\n')
            .enumerate()
            .map(|(i, bytes)| Line { number: i + 1, bytes: bytes.strip_suffix(b"\r").unwrap_or(bytes) })
    }

    pub(super) fn whole(&self, message: impl Into<String>) -> ReadError {
        ReadError::new(&self.name, Spot::File, message.into())
    }

    pub(super) fn at_line(&self, line: usize, message: impl Into<String>) -> ReadError {
        ReadError::new(&self.name, Spot::Line { line, column: None }, message.into())
    }

    pub(super) fn at_byte(&self, byte: usize, message: impl Into<String>) -> ReadError {
        ReadError::new(&self.name, Spot::Byte(byte), message.into())
    }

    /// At a byte of a line, said as a column in characters.
    pub(super) fn at_column(&self, line: Line<'_>, byte: usize, message: impl Into<String>) -> ReadError {
        let before = &line.bytes[..byte.min(line.bytes.len())];
        let column = String::from_utf8_lossy(before).chars().count() + 1;
        ReadError::new(&self.name, Spot::Line { line: line.number, column: Some(column) }, message.into())
    }

    /// A line as text.
    pub(super) fn text(&self, line: Line<'b>) -> Result<&'b str, ReadError> {
        core::str::from_utf8(line.bytes).map_err(|error| {
            let message = "this is no text in UTF-8; is the file binary, or of another format than its name says?";
            self.at_column(line, error.valid_up_to(), message)
        })
    }

    /// A coordinate, or another number that must be finite; `wanted` says what: `x`, `the diameter`.
    pub(super) fn number(&self, line: Line<'_>, word: Word<'_>, wanted: &str) -> Result<f64, ReadError> {
        number(word.text).map_err(|why| self.at_column(line, word.at, format!("{why}; {wanted} is wanted here")))
    }
}

/// A finite number as text; Fortran's `1.5D+00` is one.
pub(super) fn number(text: &str) -> Result<f64, String> {
    let plain = text.parse::<f64>();
    let read = match plain {
        Err(_) if text.contains(['d', 'D']) && text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) => {
            text.replacen(['d', 'D'], "e", 1).parse()
        }
        other => other,
    };
    match read {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) if text.contains(|c: char| c.is_ascii_digit()) => Err(format!("{} is too large", quoted(text))),
        Ok(_) => Err(format!("{} is not finite", quoted(text))),
        Err(_) if text.is_empty() => Err("nothing is written".to_owned()),
        Err(_) if text.contains(',') && text.replace(',', ".").parse::<f64>().is_ok() => {
            Err(format!("{} has a decimal comma, write a point", quoted(text)))
        }
        Err(_) => Err(format!("{} is no number", quoted(text))),
    }
}

/// The words of a text between blanks.
pub(super) fn words(text: &str) -> impl Iterator<Item = Word<'_>> {
    text.split_ascii_whitespace()
        .map(move |word| Word { text: word, at: word.as_ptr() as usize - text.as_ptr() as usize })
}

/// Whether the first word of a line is this one.
pub(super) fn starts_with_word(line: &[u8], word: &str) -> bool {
    line.strip_prefix(word.as_bytes()).is_some_and(|rest| rest.first().is_none_or(u8::is_ascii_whitespace))
}

/// "1 point", "3 points".
pub(crate) fn counted(number: usize, one: &str) -> String {
    format!("{number} {one}{}", if number == 1 { "" } else { "s" })
}

/// "1 face is", "3 faces are".
pub(super) fn counted_is(number: usize, one: &str) -> String {
    format!("{} {}", counted(number, one), if number == 1 { "is" } else { "are" })
}
