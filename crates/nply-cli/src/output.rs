//! The answer, on standard output.

use std::io::{self, Write as _};

use clap::ArgMatches;

use crate::failure::Failure;

/// How the answer is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    Table,
    Json,
    Csv,
}

impl Format {
    pub(crate) fn of(arguments: &ArgMatches) -> Self {
        if arguments.get_flag("json") {
            return Self::Json;
        }
        match arguments.try_get_one::<String>("format").ok().flatten().map(String::as_str) {
            Some("json") => Self::Json,
            Some("csv") => Self::Csv,
            _ => Self::Table,
        }
    }
}

/// All at once; colours are left out where nobody sees them (a pipe, `NO_COLOR`).
pub(crate) fn write(text: &str) -> Result<(), Failure> {
    let mut out = anstream::stdout();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::ClosedPipe,
        _ => Failure::File { what: "cannot write the answer".to_owned(), error },
    })
}
