//! Curves from files, and how far long work on them has come.

use std::fs::File;
use std::io::{self, Read as _};

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, ArgMatches, Command};
use indicatif::{ProgressBar, ProgressStyle};
use nply::topology::Along;
use nply_sheet::Extension;
use nply_sheet::curves::{Closing, CurveSet, Curves, Format};
use rayon::prelude::*;

use crate::failure::Failure;
use crate::interrupt;

/// Which files are read, said once for all commands on curves.
const FILES: &str = "\
FILE holds polylines: rows x y z (CSV, or separated by blanks; a column named curve, strand, wire or chain, or blank
lines, stand between several), XYZ, PDB (the trace of each chain), VTK and VTP lines, OBJ `l` lines, beams of INP
(`*NODE`, `*ELEMENT`), NumPy .npy of shape (N, 3) or (K, N, 3). A curve whose last point repeats the first is closed.";

/// What a command's `--help` says first: what it does, and which files it reads.
pub(crate) fn about(what: &str) -> String {
    // the lines of the source are none of the reader's
    [what, FILES].map(|text| text.replace('\n', " ")).join("\n\n")
}

/// A file of more than 4 GiB is not read at once.
const LARGEST: u64 = 1 << 32;

/// FILE…, how to read it, and what is closed.
pub(crate) fn with_files(command: Command) -> Command {
    let flag = |name: &'static str, help: &'static str| {
        Arg::new(name).long(name).action(ArgAction::SetTrue).help(help).help_heading("Curves")
    };
    command
        .arg(
            Arg::new("files")
                .value_name("FILE")
                .action(ArgAction::Append)
                .num_args(1..)
                .required(true)
                .help("Files with curves; `-` reads standard input"),
        )
        .arg(
            Arg::new("read-as")
                .long("read-as")
                .value_name("FORMAT")
                .value_parser(PossibleValuesParser::new(Format::ALL.map(Format::name)))
                .help("The files' format, where name and beginning do not tell it")
                .help_heading("Curves"),
        )
        .arg(
            Arg::new("unit")
                .long("unit")
                .value_name("UNIT")
                .help("The unit of the coordinates, for the report: mm")
                .help_heading("Curves"),
        )
        .arg(flag("closed", "Join the last point of every curve to its first").conflicts_with("open"))
        .arg(flag("open", "Take every curve as open"))
        .arg(
            Arg::new("reverse")
                .long("reverse")
                .value_name("CURVE")
                .action(ArgAction::Append)
                .allow_hyphen_values(true)
                .help("Read this curve, by its name in the report, from its last point to its first (repeatable)")
                .help_heading("Curves"),
        )
        .arg(interrupt::jobs())
        .arg(Arg::new("quiet").long("quiet").short('q').action(ArgAction::SetTrue).help("No progress bar"))
}

/// Reads all files.
pub(crate) fn read(arguments: &ArgMatches) -> Result<CurveSet, Failure> {
    let format = arguments.get_one::<String>("read-as").and_then(|name| Format::named(name));
    let mut files = Vec::new();
    for path in arguments.get_many::<String>("files").into_iter().flatten() {
        let (name, bytes) = if path == "-" {
            ("standard input", load(io::stdin()))
        } else {
            (path.as_str(), File::open(path).and_then(load))
        };
        let shown = name.replace(|c: char| c.is_control(), "?");
        let bytes = bytes.map_err(|error| Failure::File { what: format!("cannot read {shown}"), error })?;
        files.push((shown, Curves::read(name, &bytes, format).map_err(Failure::Unreadable)?));
    }
    let closing = match (arguments.get_flag("closed"), arguments.get_flag("open")) {
        (true, _) => Closing::Closed,
        (_, true) => Closing::Open,
        _ => Closing::AsWritten,
    };
    let unit = arguments.get_one::<String>("unit").map(String::as_str);
    let backwards: Vec<&str> =
        arguments.get_many::<String>("reverse").into_iter().flatten().map(String::as_str).collect();
    CurveSet::of(files, unit, closing)
        .and_then(|set| set.reversed(&backwards))
        .map_err(|error| Failure::Refused(error, String::new()))
}

fn load(file: impl io::Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.take(LARGEST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LARGEST {
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, "it is larger than 4 GiB"));
    }
    Ok(bytes)
}

/// `--extend` and `--extend-along`.
pub(crate) fn with_extension(command: Command) -> Command {
    command
        .arg(
            Arg::new("extend")
                .long("extend")
                .value_name("LENGTH")
                .allow_hyphen_values(true)
                .help("Prolong both ends of open curves by this length, straight")
                .help_heading("Curves"),
        )
        .arg(
            Arg::new("extend-along")
                .long("extend-along")
                .value_name("WHAT")
                .value_parser(PossibleValuesParser::new(["tangents", "chord"]))
                .requires("extend")
                .help("Along their end segments (tangents, the default) or along the line through the ends (chord)")
                .help_heading("Curves"),
        )
}

/// What is to be done to the ends.
pub(crate) fn extension(arguments: &ArgMatches, set: &CurveSet) -> Result<Option<Extension>, Failure> {
    let Some(text) = arguments.get_one::<String>("extend") else { return Ok(None) };
    let length = set.length("extend", text).map_err(|error| Failure::Refused(error, String::new()))?;
    let chord = arguments.get_one::<String>("extend-along").is_some_and(|along| along == "chord");
    Ok(Some(Extension { length, along: if chord { Along::Chord } else { Along::Tangents } }))
}

/// Pieces of work shared out among threads, a round at a time; between rounds the bar is moved and Ctrl-C is heard.
pub(crate) fn each<T: Sync, R: Send>(
    arguments: &ArgMatches,
    all: &[T],
    what: &str,
    round: usize,
    work: impl Fn(&T) -> Result<R, String> + Sync,
) -> Result<Vec<R>, Failure> {
    interrupt::prepare(arguments);
    let bar = bar(arguments, all.len(), what);
    let mut done = Vec::with_capacity(all.len());
    for some in all.chunks(round) {
        interrupt::check().inspect_err(|_| bar.finish_and_clear())?;
        let found: Result<Vec<R>, String> = some.par_iter().map(&work).collect();
        done.extend(found.inspect_err(|_| bar.finish_and_clear()).map_err(Failure::Premise)?);
        bar.inc(some.len() as u64);
    }
    bar.finish_and_clear();
    Ok(done)
}

/// A bar for so many steps of a kind, on a terminal and unless it is not wanted.
pub(crate) fn bar(arguments: &ArgMatches, steps: usize, what: &str) -> ProgressBar {
    let bar = if arguments.get_flag("quiet") { ProgressBar::hidden() } else { ProgressBar::new(steps as u64) };
    if let Ok(style) = ProgressStyle::with_template(&format!("{{wide_bar}} {{pos}}/{{len}} {what}, {{eta}} left")) {
        bar.set_style(style);
    }
    bar
}
