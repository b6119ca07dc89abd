//! What went wrong, said on standard error, and the exit status it ends with.

use std::io::{self, Write as _};
use std::process::ExitCode;

use nply_sheet::SpecError;
use nply_sheet::curves::ReadError;
use nply_sheet::table::TableError;

/// Why there is no answer.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The input is refused; with the text of the file it stands in.
    Refused(SpecError, String),
    /// A file of curves is refused.
    Unreadable(ReadError),
    /// Curves are understood, and what is asked of them does not exist: the sentence.
    Premise(String),
    /// A file cannot be read or written.
    File { what: String, error: io::Error },
    /// Nobody reads the answer any more: no error.
    ClosedPipe,
    /// Ctrl-C.
    Interrupted,
    /// Ctrl-C, and something is kept: the sentence.
    Stopped(String),
    /// A table that should be read is none.
    Table(String),
}

/// The premise is broken.
const PREMISE: u8 = 1;
/// File trouble.
const FILE: u8 = 3;
/// Usage.
const USAGE: u8 = 2;
/// As of a program that Ctrl-C ended.
const INTERRUPTED: u8 = 130;

impl Failure {
    /// Says what is the matter and gives the exit status.
    pub(crate) fn report(self) -> ExitCode {
        let (text, status) = match self {
            Self::Refused(error, text) => (error.render_styled(&text), error.exit_code()),
            Self::Unreadable(error) => (format!("error: {error}"), error.exit_code()),
            Self::Premise(why) => (format!("error: {why}"), PREMISE),
            Self::File { what, error } => (format!("error: {what}: {error}"), FILE),
            Self::ClosedPipe => return ExitCode::SUCCESS,
            Self::Stopped(what) => (format!("interrupted: {what}"), INTERRUPTED),
            Self::Table(why) => (format!("error: {why}"), USAGE),
            Self::Interrupted => ("interrupted: nothing is kept".to_owned(), INTERRUPTED),
        };
        // where standard error is closed too there is nobody left to tell
        let _ = writeln!(anstream::stderr(), "{}", text.trim_end());
        ExitCode::from(status)
    }

    /// Of writing to standard output.
    pub(crate) fn of_output(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::ClosedPipe,
            _ => Self::File { what: "cannot write the answer".to_owned(), error },
        }
    }

    /// Of writing a table to a file.
    pub(crate) fn of_table_in(path: &str, error: TableError) -> Self {
        let error = match error {
            TableError::Write(error) => error,
            other => io::Error::other(other),
        };
        Self::File { what: format!("cannot write {path}"), error }
    }

    /// Of writing a table to standard output.
    pub(crate) fn of_table(error: TableError) -> Self {
        match error {
            TableError::Write(error) => Self::of_output(error),
            other => Self::File { what: "cannot write the table".to_owned(), error: io::Error::other(other) },
        }
    }

    /// Help and version go to standard output with status 0, anything else to standard error with status 2.
    pub(crate) fn usage(mut error: clap::Error) -> ExitCode {
        // a flag that is not known is no value: a tip to pass it as one leads nowhere
        error.remove(clap::error::ContextKind::Suggested);
        let _ = error.print();
        ExitCode::from(if error.use_stderr() { USAGE } else { 0 })
    }
}
