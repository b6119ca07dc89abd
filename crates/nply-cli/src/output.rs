//! The answer, on standard output.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write as _};
use std::path::{Path, PathBuf};

use clap::{Arg, ArgMatches};
use nply_sheet::{ErrorKind, Place, Report, SpecError};

use crate::failure::Failure;
use crate::interrupt;

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

/// How large PNG pictures are.
pub(crate) fn zoom() -> Arg {
    Arg::new("zoom")
        .long("zoom")
        .value_name("NUMBER")
        .value_parser(magnification)
        .help("Pixels of a PNG to one of the SVG, 0.1 to 20 (2)")
}

fn magnification(text: &str) -> Result<f64, String> {
    let zoom: f64 = text.parse().map_err(|_| "what is wanted is a number, such as 2".to_owned())?;
    if (0.1..=20.0).contains(&zoom) { Ok(zoom) } else { Err("pictures are drawn 0.1 to 20 times as large".to_owned()) }
}

pub(crate) fn zoom_of(arguments: &ArgMatches) -> f64 {
    arguments.try_get_one::<f64>("zoom").ok().flatten().copied().unwrap_or(2.0)
}

/// How wide and high the terminal is, in characters, as far as it says.
pub(crate) fn terminal() -> (usize, usize) {
    let said = |name: &str| std::env::var(name).ok()?.parse::<usize>().ok().filter(|size| *size > 0);
    (said("COLUMNS").unwrap_or(80), said("LINES").unwrap_or(24))
}

/// Writes a picture: PNG if the name ends in .png, else SVG.
pub(crate) fn picture(path: &str, svg: &str, arguments: &ArgMatches) -> Result<(), Failure> {
    let ending = Path::new(path).extension();
    let is = |known: &str| ending.is_some_and(|ending| ending.eq_ignore_ascii_case(known));
    if ending.is_some() && !is("png") && !is("svg") {
        let flag = if matches!(arguments.try_contains_id("plot"), Ok(true)) { "plot" } else { "output" };
        let message =
            format!("pictures are SVG or PNG, by the end of the file's name: {} is neither", shown(Path::new(path)));
        return Err(Failure::Refused(
            SpecError::new(ErrorKind::WrongType, Place::Flag(flag.to_owned()), message),
            String::new(),
        ));
    }
    let is_png = is("png");
    let pixels = is_png.then(|| nply_sheet::plot::png(svg, zoom_of(arguments))).transpose();
    let pixels = pixels
        .map_err(|error| Failure::File { what: format!("cannot draw {path}"), error: io::Error::other(error) })?;
    let mut draft = Draft::new(path)?;
    draft.write(pixels.as_deref().unwrap_or(svg.as_bytes()))?;
    draft.keep()
}

/// Draws the picture, where one is asked for.
pub(crate) fn plot(arguments: &ArgMatches, svg: impl Fn() -> String) -> Result<(), Failure> {
    let Some(path) = arguments.get_one::<String>("plot") else { return Ok(()) };
    picture(path, &svg(), arguments)
}

/// Refuses to write over what is read, and two things to one file: whatever their names, links followed.
pub(crate) fn spares_input(arguments: &ArgMatches) -> Result<(), Failure> {
    const READ: [&str; 4] = ["file", "files", "data", "rows"];
    const WRITTEN: [&str; 2] = ["output", "plot"];
    let named = |id: &str| -> Vec<&str> {
        arguments.try_get_many::<String>(id).ok().flatten().into_iter().flatten().map(String::as_str).collect()
    };
    let refused = |flag: &str, message: String| {
        let place = Place::Flag(flag.to_owned());
        Err(Failure::Refused(SpecError::new(ErrorKind::Contradiction, place, message), String::new()))
    };
    let read: Vec<PathBuf> = READ.into_iter().flat_map(named).filter_map(|path| place_of(path.as_ref())).collect();
    let mut written: Vec<PathBuf> = Vec::new();
    for (flag, path) in WRITTEN.into_iter().flat_map(|flag| named(flag).into_iter().map(move |path| (flag, path))) {
        let Some(place) = place_of(path.as_ref()) else { continue };
        if read.contains(&place) {
            let message = format!("{} is read as well, and would be lost: give another name", shown(path.as_ref()));
            return refused(flag, message);
        }
        if written.contains(&place) {
            let message = format!(
                "two things would be written to the same file, {}: give one of them another name",
                shown(path.as_ref())
            );
            return refused(flag, message);
        }
        written.push(place);
    }
    Ok(())
}

/// Where a file stands or would stand; `None` for what is no file (a pipe, a device, a folder) or cannot be one.
pub(crate) fn place_of(path: &Path) -> Option<PathBuf> {
    match fs::metadata(path) {
        Ok(there) if !there.is_file() => None,
        Ok(_) => fs::canonicalize(path).ok(),
        Err(_) => {
            let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
            Some(fs::canonicalize(folder).ok()?.join(path.file_name()?))
        }
    }
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

    /// In pieces, so that Ctrl-C ends it between two of them.
    pub(crate) fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        const PIECE: usize = 1 << 20;
        for piece in bytes.chunks(PIECE) {
            interrupt::check()?;
            io::Write::write_all(self, piece).map_err(|error| self.cannot(error))?;
        }
        Ok(())
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
pub(crate) fn shown(path: &Path) -> String {
    path.display().to_string().replace(|c: char| c.is_control(), "?")
}

/// A remark that is no part of the answer, on standard error.
pub(crate) fn note(remark: &str) {
    let _ = writeln!(anstream::stderr(), "note: {remark}");
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
