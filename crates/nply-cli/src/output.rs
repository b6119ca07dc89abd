//! The answer, on standard output.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write as _};
use std::path::{Path, PathBuf};

use clap::{Arg, ArgMatches};
use nply_sheet::Report;

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

/// Bytes that are no text.
pub(crate) fn write_bytes(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(bytes).and_then(|()| out.flush()).map_err(Failure::of_output)
}

/// `--output`.
pub(crate) fn file(help: &'static str) -> Arg {
    Arg::new("output").long("output").short('o').value_name("FILE").help(help)
}

/// A report, as it is asked for.
pub(crate) fn write_report(arguments: &ArgMatches, report: &Report) -> Result<(), Failure> {
    write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}

/// Draws the picture, where one is asked for.
pub(crate) fn plot(arguments: &ArgMatches, svg: impl Fn() -> String) -> Result<(), Failure> {
    let Some(path) = arguments.get_one::<String>("plot") else { return Ok(()) };
    let mut draft = Draft::new(path)?;
    draft.write(svg().as_bytes())?;
    draft.keep()
}

/// A file that gets its name when it is whole: until then it stands beside it as a `.part`, and is removed if nothing comes of it. What is
/// no file (a pipe, a device) is written to as it is.
pub(crate) struct Draft {
    file: Option<BufWriter<File>>,
    /// where it stands until it is whole
    draft: Option<PathBuf>,
    path: PathBuf,
}

impl Draft {
    pub(crate) fn new(path: &str) -> Result<Self, Failure> {
        let given = PathBuf::from(path);
        let cannot = |error| Failure::File { what: format!("cannot write {}", shown(&given)), error };
        let refused = |kind, why: &str| cannot(io::Error::new(kind, why.to_owned()));
        if path.is_empty() {
            return Err(refused(io::ErrorKind::InvalidInput, "the file has no name"));
        }
        // a link is followed, so that what it points to is replaced and not the link
        let path = fs::canonicalize(&given).unwrap_or_else(|_| given.clone());
        let draft = match fs::metadata(&path) {
            Ok(there) if there.is_dir() => return Err(refused(io::ErrorKind::IsADirectory, "it is a folder")),
            Ok(there) if !there.is_file() => None,
            _ => {
                let mut draft = path.clone().into_os_string();
                draft.push(format!(".{}.part", std::process::id()));
                Some(PathBuf::from(draft))
            }
        };
        let file = match &draft {
            Some(draft) => File::create(draft),
            None => File::options().write(true).open(&path),
        };
        Ok(Self { file: Some(BufWriter::new(file.map_err(cannot)?)), draft, path })
    }

    pub(crate) fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        io::Write::write_all(self, bytes).map_err(|error| self.cannot(error))
    }

    /// Gives the file its name.
    pub(crate) fn keep(mut self) -> Result<(), Failure> {
        let Some(file) = self.file.take() else { return Ok(()) };
        let whole = file.into_inner().map_err(io::IntoInnerError::into_error);
        let done = match &self.draft {
            Some(draft) => whole.and_then(|file| file.sync_all()).and_then(|()| fs::rename(draft, &self.path)),
            None => whole.map(drop),
        };
        done.map_err(|error| {
            self.discard(); // nothing is left that could be taken for the file
            self.cannot(error)
        })
    }

    fn discard(&self) {
        if let Some(draft) = &self.draft {
            let _ = fs::remove_file(draft);
        }
    }

    fn cannot(&self, error: io::Error) -> Failure {
        Failure::File { what: format!("cannot write {}", shown(&self.path)), error }
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
            self.discard();
        }
    }
}

/// A file's name for a message, without what would steer a terminal.
fn shown(path: &Path) -> String {
    path.display().to_string().replace(|c: char| c.is_control(), "?")
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
