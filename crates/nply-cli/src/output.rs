//! The answer, on standard output.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write as _};
use std::path::PathBuf;

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
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(Failure::of_output)
}

/// A file that gets its name when it is whole: until then it stands beside it as `NAME.part`, and is removed if nothing comes of it.
pub(crate) struct Draft {
    file: Option<BufWriter<File>>,
    draft: PathBuf,
    path: PathBuf,
}

impl Draft {
    pub(crate) fn new(path: &str) -> Result<Self, Failure> {
        let path = PathBuf::from(path);
        let mut draft = path.clone().into_os_string();
        draft.push(".part");
        let draft = PathBuf::from(draft);
        let cannot = |error| Failure::File { what: format!("cannot write {}", path.display()), error };
        if path.is_dir() {
            return Err(cannot(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder")));
        }
        let file = File::create(&draft).map_err(cannot)?;
        Ok(Self { file: Some(BufWriter::new(file)), draft, path })
    }

    pub(crate) fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        io::Write::write_all(self, bytes).map_err(|error| self.cannot(error))
    }

    /// Gives the file its name.
    pub(crate) fn keep(mut self) -> Result<(), Failure> {
        let Some(file) = self.file.take() else { return Ok(()) };
        let done = file
            .into_inner()
            .map_err(io::IntoInnerError::into_error)
            .and_then(|file| file.sync_all())
            .and_then(|()| fs::rename(&self.draft, &self.path));
        done.map_err(|error| {
            let _ = fs::remove_file(&self.draft); // nothing is left that could be taken for the file
            self.cannot(error)
        })
    }

    fn cannot(&self, error: io::Error) -> Failure {
        Failure::File { what: format!("cannot write {}", self.path.display()), error }
    }
}

impl io::Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.as_mut().map_or(Ok(0), |file| file.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.as_mut().map_or(Ok(()), io::Write::flush)
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        if self.file.take().is_some() {
            let _ = fs::remove_file(&self.draft);
        }
    }
}

/// Standard output, for much text in small pieces.
pub(crate) struct Lines(BufWriter<io::Stdout>);

impl Lines {
    pub(crate) fn new() -> Self {
        Self(BufWriter::new(io::stdout()))
    }

    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        self.0.flush().map_err(Failure::of_output)
    }
}

impl io::Write for Lines {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}
