//! What is wrong with a file of curves, and where.

use core::fmt;
use std::sync::Arc;

/// Where in a file of curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Spot {
    /// The file as a whole.
    File,
    /// A line of a text, and a column in characters where one is meant; both counted from 1.
    Line {
        /// Line.
        line: usize,
        /// Column.
        column: Option<usize>,
    },
    /// A byte of a binary file, counted from 0.
    Byte(usize),
}

/// A file of curves that cannot be taken as it is: one sentence, its place, and what was expected there.
///
/// ```
/// use nply_sheet::curves::Curves;
/// let error = Curves::read("wires.csv", b"x,y,z\n0,0,0\n0,0,one\n", None).unwrap_err();
/// assert_eq!(error.to_string(), "wires.csv:3:5: \"one\" is no number; z is wanted here");
/// assert_eq!((error.line(), error.exit_code()), (Some(3), 2));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}{}: {}", shown(.0.file.as_ref()), .0.spot, .0.message)]
pub struct ReadError(Box<Parts>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct Parts {
    file: Arc<str>,
    spot: Spot,
    message: String,
}

impl fmt::Display for Spot {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => Ok(()),
            Self::Line { line, column: None } => write!(out, ":{line}"),
            Self::Line { line, column: Some(column) } => write!(out, ":{line}:{column}"),
            Self::Byte(byte) => write!(out, ", byte {byte}"),
        }
    }
}

/// A file's name without what would steer a terminal.
fn shown(name: &str) -> String {
    name.replace(|c: char| c.is_control(), "?")
}

impl ReadError {
    pub(super) fn new(file: &Arc<str>, spot: Spot, message: String) -> Self {
        Self(Box::new(Parts { file: Arc::clone(file), spot, message }))
    }

    /// Where it stands.
    #[must_use]
    pub fn spot(&self) -> Spot {
        self.0.spot
    }

    /// The sentence alone.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// Line in a text, counted from 1; `None` in a binary file.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        match self.0.spot {
            Spot::Line { line, .. } => Some(line),
            _ => None,
        }
    }

    /// What a command should end with: 2, the input is not understood.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        2
    }
}
