//! `nply figure`: the paper's figures and tables, worked out anew.

use std::path::{Path, PathBuf};

use clap::{Arg, ArgAction, ArgMatches, Command};
use nply_sheet::figure::{Figure, html, markdown};
use nply_sheet::plot::{Theme, png};
use nply_sheet::{ErrorKind, Place, SpecError};

use super::Verb;
use crate::failure::Failure;
use crate::output::{self, Draft};

const LONG: &str = "\
Works out a figure or table of Neukirch and van der Heijden's paper anew. --output names the picture's file; the numbers drawn are
written beside it as CSV. Without it the picture goes to standard output as SVG, or the numbers with --csv. `nply figure all
--output FOLDER` writes every figure, and a gallery of them as HTML and Markdown. Where the two balances differ, both are drawn.";

pub(super) const VERB: Verb =
    Verb { name: "figure", about: "The paper's figures, worked out anew", long: LONG, examples: false, arguments, run };

fn arguments(command: Command) -> Command {
    let figure = Arg::new("figure").required(true).value_name("FIGURE").help("1 to 15, table1, table2, or all");
    let output = Arg::new("output").long("output").short('o').value_name("FILE");
    let switch =
        |name: &'static str, help: &'static str| Arg::new(name).long(name).action(ArgAction::SetTrue).help(help);
    command
        .arg(figure)
        .arg(output.help("Where to write: a file that ends in .svg, .png or .csv; for all of them, a folder"))
        .arg(switch("csv", "Print the numbers, not the picture").conflicts_with("output"))
        .arg(switch("svg-only", "Of all figures, write the pictures as SVG and the page of Markdown alone"))
        .arg(switch("dark", "Draw on dark ground"))
        .arg(output::zoom())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let Some(name) = arguments.get_one::<String>("figure") else { return Ok(()) }; // required: not reached
    let theme = if arguments.get_flag("dark") { Theme::Dark } else { Theme::Light };
    let output = arguments.get_one::<String>("output");
    if name == "all" {
        let Some(folder) = output else {
            return Err(refused(ErrorKind::Missing, "output", "all figures need a folder: name it by --output"));
        };
        return write_all(Path::new(folder), arguments, theme);
    }
    let figure = named(name)?;
    match output {
        None if arguments.get_flag("csv") => output::write(&figure.csv()),
        None => output::write(&figure.svg(theme)),
        Some(path) => {
            if !ends_in(path, "csv") {
                output::picture(path, &figure.svg(theme), arguments)?;
            }
            keep(&Path::new(path).with_extension("csv"), figure.csv().as_bytes())
        }
    }
}

fn named(name: &str) -> Result<Figure, Failure> {
    let bare = name.trim_start_matches("figure").trim_start_matches("fig").trim_matches(['-', ' ', '.']);
    let bare = bare.to_lowercase().replace([' ', '-'], "");
    match Figure::named(&bare) {
        Ok(Some(figure)) => Ok(figure),
        Ok(None) => {
            let message = format!("{name}: there is no such figure; there are 1 to 15, table1, table2 and all");
            Err(refused(ErrorKind::Domain, "figure", &message))
        }
        Err(error) => Err(refused(ErrorKind::Domain, "figure", &error.to_string())),
    }
}

fn refused(kind: ErrorKind, flag: &str, message: &str) -> Failure {
    Failure::Refused(SpecError::new(kind, Place::Flag(flag.to_owned()), message), String::new())
}

fn ends_in(path: &str, ending: &str) -> bool {
    Path::new(path).extension().is_some_and(|found| found.eq_ignore_ascii_case(ending))
}

fn keep(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let mut draft = Draft::new(&path.to_string_lossy())?;
    draft.write(bytes)?;
    draft.keep()
}

/// Every figure as SVG, PNG and CSV, with two galleries.
fn write_all(folder: &Path, arguments: &ArgMatches, theme: Theme) -> Result<(), Failure> {
    std::fs::create_dir_all(folder)
        .map_err(|error| Failure::File { what: format!("cannot make {}", folder.display()), error })?;
    let svg_only = arguments.get_flag("svg-only");
    let mut figures = Vec::new();
    for name in Figure::names() {
        let figure = named(name)?;
        let file = |ending: &str| -> PathBuf { folder.join(format!("{}.{ending}", figure.file_name())) };
        let svg = figure.svg(theme);
        keep(&file("svg"), svg.as_bytes())?;
        if svg_only {
            figures.push(figure);
            continue;
        }
        keep(&file("csv"), figure.csv().as_bytes())?;
        let pixels = png(&svg, output::zoom_of(arguments)).map_err(|error| Failure::File {
            what: format!("cannot draw {}", file("png").display()),
            error: std::io::Error::other(error),
        })?;
        keep(&file("png"), &pixels)?;
        figures.push(figure);
    }
    if !svg_only {
        keep(&folder.join("index.html"), html(&figures).as_bytes())?;
    }
    keep(&folder.join("README.md"), markdown(&figures, "svg").as_bytes())
}
