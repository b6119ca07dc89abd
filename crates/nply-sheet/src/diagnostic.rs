//! What is wrong with an input, and where.

use core::fmt;
use core::ops::Range;
use std::sync::Arc;

use annotate_snippets::renderer::Renderer;
use annotate_snippets::{AnnotationKind, Group, Level, Snippet};

/// Where a datum stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// In a file.
    File {
        /// The file's name, as it was given.
        name: Arc<str>,
        /// The bytes of the file that are meant.
        bytes: Range<usize>,
        /// Line, counted from 1.
        line: usize,
        /// Column in characters, counted from 1.
        column: usize,
    },
    /// On the command line.
    Flag(
        /// The flag's name without dashes in front: `strand-length`.
        String,
    ),
}

impl Place {
    /// Bytes of `text`, with line and column of the first of them.
    pub(crate) fn in_file(name: &Arc<str>, text: &str, bytes: Range<usize>) -> Self {
        let mut start = bytes.start.min(text.len());
        while !text.is_char_boundary(start) {
            start -= 1;
        }
        let before = text.get(..start).unwrap_or("");
        let line = before.matches('\n').count() + 1;
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let column = before.get(line_start..).unwrap_or("").chars().count() + 1;
        Self::File { name: Arc::clone(name), bytes, line, column }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File { name, line, column, .. } => write!(out, "{name}:{line}:{column}"),
            Self::Flag(flag) => write!(out, "--{flag}"),
        }
    }
}

/// What sort of mistake it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ErrorKind {
    /// The text cannot be taken apart: no TOML, no number, a unit without meaning.
    Syntax,
    /// A key, table or flag that is not known.
    UnknownKey,
    /// A value of the wrong sort, such as a word where a number is wanted.
    WrongType,
    /// A unit of another kind than wanted, none where one is needed, or one where the input has none to measure it by.
    WrongUnit,
    /// A datum without which there is no case.
    Missing,
    /// Too many data, or data that exclude each other.
    Contradiction,
    /// Understood, but no ply has it: the premise is broken.
    Domain,
}

/// One thing wrong with an input: one sentence, its place, and what to do.
///
/// Displays on one line as `file.toml:3:1: sentence` or `--pretwist: sentence`; [`SpecError::render`] shows the line of the file.
///
/// ```
/// use nply_sheet::{ErrorKind, Spec};
/// let error = Spec::from_toml("ply.toml", "[ply]\nstrand = 3\n").unwrap_err();
/// assert_eq!(error.kind(), ErrorKind::UnknownKey);
/// assert_eq!(error.to_string(), "ply.toml:2:1: `strand` is no key of [ply]; did you mean `strands`?");
/// assert_eq!(error.exit_code(), 2);
/// ```
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}{}", .0.titled(), .0.help.as_ref().map(|help| format!("; {help}")).unwrap_or_default())]
pub struct SpecError(Box<Parts>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct Parts {
    kind: ErrorKind,
    place: Place,
    key: Option<String>,
    message: String,
    help: Option<String>,
}

impl Parts {
    /// The sentence behind its place; a flag that it begins with is not said twice.
    fn titled(&self) -> String {
        let Self { place, message, .. } = self;
        match place {
            Place::Flag(flag) if message.starts_with(&format!("`--{flag}")) => message.clone(),
            _ => format!("{place}: {message}"),
        }
    }
}

impl SpecError {
    /// A refusal of a kind, at a place.
    ///
    /// ```
    /// use nply_sheet::{ErrorKind, Place, SpecError};
    /// let error = SpecError::new(ErrorKind::Contradiction, Place::Flag("plot".into()), "give another name");
    /// assert_eq!((error.exit_code(), error.to_string().as_str()), (2, "--plot: give another name"));
    /// ```
    pub fn new(kind: ErrorKind, place: Place, message: impl Into<String>) -> Self {
        Self(Box::new(Parts { kind, place, key: None, message: message.into(), help: None }))
    }

    pub(crate) fn of_key(mut self, key: &str) -> Self {
        self.0.key = Some(key.to_owned());
        self
    }

    pub(crate) fn with_help(mut self, help: Option<String>) -> Self {
        self.0.help = help.or(self.0.help);
        self
    }

    /// What sort of mistake it is.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        self.0.kind
    }

    /// Where it stands.
    #[must_use]
    pub fn place(&self) -> &Place {
        &self.0.place
    }

    /// The key it is about, as written, where there is one.
    #[must_use]
    pub fn key(&self) -> Option<&str> {
        self.0.key.as_deref()
    }

    /// The sentence alone.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// What to do, where it is not in the sentence itself: "did you mean `pretwist`?".
    #[must_use]
    pub fn help(&self) -> Option<&str> {
        self.0.help.as_deref()
    }

    /// Line in the file, counted from 1; `None` for a flag.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        match self.0.place {
            Place::File { line, .. } => Some(line),
            Place::Flag(_) => None,
        }
    }

    /// Column in the file, in characters, counted from 1; `None` for a flag.
    #[must_use]
    pub fn column(&self) -> Option<usize> {
        match self.0.place {
            Place::File { column, .. } => Some(column),
            Place::Flag(_) => None,
        }
    }

    /// What a command should end with: 1 where the premise is broken (understood, but no such ply can be), 2 where the input is
    /// not understood.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        match self.0.kind {
            ErrorKind::Domain => 1,
            _ => 2,
        }
    }

    /// Several lines of plain text with the line of the file that is meant; `text` is the file's content (anything, for a flag).
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// let text = "[ply]\nstrand = 3\n";
    /// let shown = Spec::from_toml("ply.toml", text).unwrap_err().render(text);
    /// assert!(shown.contains("2 | strand = 3\n  | ^^^^^^"));
    /// ```
    #[must_use]
    pub fn render(&self, text: &str) -> String {
        self.render_with(&Renderer::plain(), text)
    }

    /// As [`SpecError::render`], with terminal colours.
    #[must_use]
    pub fn render_styled(&self, text: &str) -> String {
        self.render_with(&Renderer::styled(), text)
    }

    fn render_with(&self, renderer: &Renderer, text: &str) -> String {
        let Parts { place, message, help, .. } = &*self.0;
        let group = match place {
            Place::File { name, bytes, .. } => {
                let mark = AnnotationKind::Primary.span(clamp(text, bytes));
                Level::ERROR.primary_title(message).element(Snippet::source(text).path(name.as_ref()).annotation(mark))
            }
            Place::Flag(_) => Group::with_title(Level::ERROR.primary_title(self.0.titled())),
        };
        let group = match help {
            Some(help) => group.element(Level::HELP.message(help)),
            None => group,
        };
        renderer.render(&[group])
    }
}

/// The range within the text and on the borders of its characters, whatever text it is.
fn clamp(text: &str, bytes: &Range<usize>) -> Range<usize> {
    let mut start = bytes.start.min(text.len());
    while !text.is_char_boundary(start) {
        start -= 1;
    }
    let mut end = bytes.end.clamp(start, text.len());
    while !text.is_char_boundary(end) {
        end += 1;
    }
    start..end
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str, bytes: Range<usize>) -> SpecError {
        let place = Place::in_file(&Arc::from("a.toml"), text, bytes);
        SpecError::new(ErrorKind::Missing, place, "something is missing").with_help(Some("write it".to_owned()))
    }

    #[test]
    fn line_and_column_count_characters_from_one() {
        let text = "ä = 1\n  ρρ = 2\n";
        let found = error(text, text.find('2').unwrap()..text.len());
        assert_eq!((found.line(), found.column()), (Some(2), Some(8)));
        assert_eq!(found.to_string(), "a.toml:2:8: something is missing; write it");
        let start = error("", 0..0);
        assert_eq!((start.line(), start.column()), (Some(1), Some(1)));
    }

    #[test]
    fn the_line_is_shown_with_a_mark_under_what_is_meant() {
        let text = "[ply]\nstrands = 3\n";
        let shown = error(text, 16..17).render(text);
        assert_eq!(
            shown,
            "error: something is missing\n --> a.toml:2:11\n  |\n2 | strands = 3\n  |           ^\n  |\n  = help: write it"
        );
        assert!(!shown.contains('\u{1b}'));
        assert!(error(text, 16..17).render_styled(text).contains('\u{1b}'));
    }

    #[test]
    fn a_flag_is_named_instead_of_a_line() {
        let found = SpecError::new(ErrorKind::Domain, Place::Flag("strands".to_owned()), "no such ply");
        assert_eq!(found.to_string(), "--strands: no such ply");
        assert_eq!(found.render(""), "error: --strands: no such ply");
        assert_eq!((found.exit_code(), found.line(), found.column()), (1, None, None));
    }

    #[test]
    fn a_flag_is_not_said_twice() {
        let at = |message: &str| SpecError::new(ErrorKind::Domain, Place::Flag("hand".to_owned()), message);
        assert_eq!(at("`--hand \"left\"` is too much").to_string(), "`--hand \"left\"` is too much");
        assert_eq!(at("`--hand \"left\"` is too much").render(""), "error: `--hand \"left\"` is too much");
        assert_eq!(at("`--turns` is too much").to_string(), "--hand: `--turns` is too much");
    }

    #[test]
    fn a_range_of_another_text_does_no_harm() {
        for text in ["", "é", "ä\r\nö\u{0}\t\u{1b}[31m"] {
            for start in 0..12 {
                for end in 0..12 {
                    let _ = error(text, start..end).render(text);
                }
            }
        }
    }
}
