//! `nply mesh`: a ply as a shape for other programs.

use std::io::{self, IsTerminal as _};
use std::path::Path;

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use nply::geometry::{Ends, Fit};
use nply_sheet::mesh::{
    Assembly, Element, FileUnit, Fineness, Layered, LineFormat, Spacing, Subject, Surface, SurfaceFormat, Wanted,
    chain_summary, chains, surface_summary,
};
use nply_sheet::{ErrorKind, Place, SpecError};

use super::Verb;
use crate::arguments::{count, with_keys};
use crate::failure::Failure;
use crate::input::{self, Described, Input};
use crate::interrupt;
use crate::output::{self, Draft};

const LONG: &str = "\
Writes the strands of a ply, and a core, as closed surfaces in triangles, for printing, finite elements and viewers:
STL, PLY, OBJ, GLB (coloured, in metres), VTK and VTU (with curvature, and pressures of a state that was solved); or with --centrelines as
nodes: CSV, XYZ, PDB, VTP and INP (beam elements for Abaqus and CalculiX). The end of the file's name tells which.

The ply is given as for `nply contact` (a lay), or as for `nply solve`, and then --state says which of its states is
meant: if nothing is said, the first whose strands need not pull on each other. Lengths that flags say are written with
their unit (\"20 mm\"), or bare in strand radii where the strand has no size.

A file with [[layer]], as `nply fit-check` reads it, is a layered strand or a rope: all its wires are shown as they are laid,
those of its strands as helices about helices, over one lay length of the outermost layer if no length is said.";

pub(super) const VERB: Verb = Verb {
    name: "mesh",
    about: "A ply as a shape for other programs: triangles or centrelines",
    long: LONG,
    examples: true,
    arguments,
    run,
};

/// What only a surface has.
const OF_SURFACES: [&str; 8] = ["contact-lines", "cut", "stripes", "chord-error", "facets", "segments", "fit", "ends"];

/// How much of which ply: flags of every command that shows its shape.
pub(super) fn shown(command: Command) -> Command {
    const MOST_STATES: i64 = 1_000;
    const MOST_STRIPES: i64 = 24;
    with_keys(command, |_| true)
        .arg(count("state", "Which of the states that are found, as `nply solve` numbers them", MOST_STATES))
        .arg(
            Arg::new("length")
                .allow_hyphen_values(true)
                .long("length")
                .value_name("LENGTH")
                .help("How much of the ply, along its axis"),
        )
        .arg(
            Arg::new("lay-lengths")
                .allow_hyphen_values(true)
                .long("lay-lengths")
                .value_name("NUMBER")
                .value_parser(value_parser!(f64))
                .help("The same in lay lengths, turns of a strand (3; 1 of a layered strand)"),
        )
        .arg(
            Arg::new("core")
                .long("core")
                .value_name("RADIUS")
                .num_args(0..=1)
                .default_missing_value("")
                .help("Put in a core; without a radius, one that fills the hole"),
        )
        .arg(count("stripes", "Lines painted along the material of each strand, as its twist turns them", MOST_STRIPES))
}

fn arguments(command: Command) -> Command {
    const FACETS: i64 = 100_000;
    let formats = SurfaceFormat::ALL.map(SurfaceFormat::extension).into_iter();
    let formats = formats.chain(LineFormat::ALL.map(LineFormat::extension));
    shown(command)
        .arg(output::file("Where to write it; the end of the name tells the format"))
        .arg(
            Arg::new("format")
                .long("format")
                .value_name("FORMAT")
                .value_parser(PossibleValuesParser::new(formats))
                .help("The format, if the file's name does not tell it; without a file, on standard output"),
        )
        .arg(Arg::new("unit").long("unit").value_name("UNIT").help(
            "The unit of coordinates: mm, nm, …, or r for strand radii (that of the input; m for GLB, Å for PDB)",
        ))
        .arg(
            Arg::new("chord-error").allow_hyphen_values(true).long("chord-error").value_name("LENGTH").help(
                "How far triangles may lie off the surface: a length, or a bare share of the strand radius (0.01)",
            ),
        )
        .arg(count("facets", "Facets round a strand, 3 or more, instead of a chord error", FACETS))
        .arg(count("segments", "Segments per lay length, instead of a chord error", FACETS))
        .arg(
            Arg::new("fit")
                .long("fit")
                .value_name("FIT")
                .value_parser(PossibleValuesParser::new(["surface", "inside", "outside", "volume"]))
                .default_value("surface")
                .help("Corners on the surface; all inside or outside of it; or through it, with the volume kept"),
        )
        .arg(
            Arg::new("ends")
                .long("ends")
                .value_name("ENDS")
                .value_parser(PossibleValuesParser::new(["flush", "square"]))
                .default_value("flush")
                .help("Ends cut off across the ply, or square to each strand"),
        )
        .arg(
            Arg::new("contact-lines")
                .long("contact-lines")
                .action(ArgAction::SetTrue)
                .help("Add the helices along which surfaces touch (OBJ, GLB, VTK, VTU)"),
        )
        .arg(
            Arg::new("cut")
                .allow_hyphen_values(true)
                .long("cut")
                .value_name("HEIGHT")
                .action(ArgAction::Append)
                .help("Add the outlines in the plane at this height (OBJ, GLB, VTK, VTU); can be given again"),
        )
        .arg(
            Arg::new("centrelines")
                .long("centrelines")
                .action(ArgAction::SetTrue)
                .conflicts_with_all(OF_SURFACES)
                .help("Nodes on the centrelines instead of surfaces (CSV, XYZ, PDB, VTP, INP)"),
        )
        .arg(
            count("elements-per-pitch", "Elements per lay length of a centreline (48)", FACETS).requires("centrelines"),
        )
        .arg(element_type().requires("centrelines"))
}

/// Which beams are written.
pub(super) fn element_type() -> Arg {
    Arg::new("element-type")
        .long("element-type")
        .value_name("TYPE")
        .ignore_case(true)
        .value_parser(PossibleValuesParser::new(Element::ALL.map(Element::name)))
        .help("Beams of two nodes (B31, what is taken: Abaqus) or of three, the middle one on the helix (B32: Abaqus and CalculiX)")
}

/// The beams that are chosen.
pub(super) fn element(arguments: &ArgMatches) -> Element {
    let said = text(arguments, "element-type");
    let known = |name: &str| Element::ALL.into_iter().find(|element| element.name().eq_ignore_ascii_case(name));
    said.and_then(known).unwrap_or_default()
}

/// What a flag's text is.
pub(super) fn text<'a>(arguments: &'a ArgMatches, name: &str) -> Option<&'a str> {
    arguments.try_get_one::<String>(name).ok().flatten().map(String::as_str)
}

/// How much of the ply, with what on it.
pub(super) fn wanted(arguments: &ArgMatches) -> Wanted<'_> {
    let square = text(arguments, "ends") == Some("square");
    Wanted {
        length: text(arguments, "length"),
        lay_lengths: arguments.get_one::<f64>("lay-lengths").copied(),
        core: text(arguments, "core"),
        ends: if square { Ends::Square } else { Ends::Flush },
        stripes: arguments.get_one::<u32>("stripes").copied().unwrap_or(0),
        contact_lines: matches!(arguments.try_get_one::<bool>("contact-lines"), Ok(Some(true))),
        cuts: arguments
            .try_get_many::<String>("cut")
            .ok()
            .flatten()
            .map_or_else(Vec::new, |cuts| cuts.map(String::as_str).collect()),
    }
}

/// The ply or layered strand that is described, and as much of it as is wanted.
pub(super) fn shape(
    arguments: &ArgMatches,
    described: &Described,
    wanted: &Wanted<'_>,
) -> Result<(Subject, Assembly), SpecError> {
    match described {
        Described::Ply(spec) => {
            let ply = Subject::of(spec, state(arguments))?;
            let assembly = Assembly::of(&ply, wanted)?;
            Ok((ply, assembly))
        }
        Described::Layered(_) if state(arguments).is_some() => {
            let message = "a layered strand is shown as it is laid, and has no states: leave it out";
            Err(refusal("state", ErrorKind::Contradiction, message))
        }
        Described::Layered(spec) => {
            let strand = Layered::of(spec)?;
            let assembly = strand.assembly(wanted)?;
            Ok((strand.subject().clone(), assembly))
        }
    }
}

/// The state that is chosen.
fn state(arguments: &ArgMatches) -> Option<usize> {
    arguments.get_one::<u32>("state").map(|state| *state as usize)
}

pub(super) fn refusal(name: &str, kind: ErrorKind, message: impl Into<String>) -> SpecError {
    SpecError::new(kind, Place::Flag(name.to_owned()), message)
}

/// The format that is said, or that the end of the file's name tells.
pub(super) fn format<'a>(arguments: &'a ArgMatches, known: &[&str]) -> Result<&'a str, SpecError> {
    let path = text(arguments, "output").filter(|path| *path != "-");
    let told = path.and_then(|path| Path::new(path).extension()).and_then(|extension| extension.to_str());
    let list = known.join(", ");
    match (text(arguments, "format"), told) {
        (Some(format), _) if known.contains(&format) => Ok(format),
        (Some(format), _) => {
            let message = format!("{format} has no place for this; what has one is {list}");
            Err(refusal("format", ErrorKind::Contradiction, message))
        }
        (None, Some(told)) => known.iter().position(|known| known.eq_ignore_ascii_case(told)).map_or_else(
            || {
                let message = format!("`.{told}` tells no format that has a place for this; what has one is {list}");
                Err(refusal("output", ErrorKind::WrongType, message))
            },
            |_| Ok(told),
        ),
        (None, None) => {
            let message = format!("say where to write it, by --output FILE, or how, by --format; known are {list}");
            Err(refusal("output", ErrorKind::Missing, message))
        }
    }
}

/// Writes a file, and the summary to the terminal; without a file, the file itself to standard output.
pub(super) fn deliver(arguments: &ArgMatches, bytes: &[u8], binary: bool, summary: &str) -> Result<(), Failure> {
    match text(arguments, "output") {
        Some(path) if path != "-" => {
            let mut draft = Draft::new(path)?;
            draft.write(bytes)?;
            draft.keep()?;
            output::write(summary)
        }
        _ if binary && io::stdout().is_terminal() => {
            let message = "this format is no text for a terminal: give a file by --output, or a pipe";
            Err(Failure::Refused(refusal("output", ErrorKind::Missing, message), String::new()))
        }
        _ => output::write_bytes(bytes),
    }
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    interrupt::listen();
    let input = input::read_described(arguments)?;
    let (bytes, binary, summary) = made(arguments, &input).map_err(|error| input.refused(error))?;
    deliver(arguments, &bytes, binary, &summary)
}

/// The file, whether it is binary, and what is said of it.
fn made(arguments: &ArgMatches, input: &Input<Described>) -> Result<(Vec<u8>, bool, String), SpecError> {
    let wanted = wanted(arguments);
    let lines = arguments.get_flag("centrelines");
    // a name that no format has is refused before anything is worked out
    let known: Vec<&str> = if lines {
        LineFormat::ALL.map(LineFormat::extension).into()
    } else {
        let formats = SurfaceFormat::ALL.into_iter().filter(|format| {
            let lines = wanted.contact_lines || !wanted.cuts.is_empty();
            (format.takes_lines() || !lines) && (format.takes_stripes() || wanted.stripes == 0)
        });
        formats.map(SurfaceFormat::extension).collect()
    };
    let format = format(arguments, &known)?;
    let (ply, assembly) = shape(arguments, &input.spec, &wanted)?;
    let unit = |own| FileUnit::of(&ply, text(arguments, "unit"), own);
    if let Some(format) =
        LineFormat::ALL.into_iter().find(|known| lines && known.extension().eq_ignore_ascii_case(format))
    {
        let unit = unit(format.own_unit())?;
        let per_lay_length = arguments.get_one::<u32>("elements-per-pitch").copied();
        let spacing = Spacing { per_lay_length, element: element(arguments) };
        let chains = chains(&ply, &assembly, spacing)?;
        let bytes = format.write(&assembly.title, &chains, &unit)?;
        return Ok((bytes, false, chain_summary(&ply, &chains, &unit)));
    }
    let found = SurfaceFormat::ALL.into_iter().find(|known| known.extension().eq_ignore_ascii_case(format));
    let format = found.unwrap_or(SurfaceFormat::Stl);
    let unit = unit(format.own_unit())?;
    let fit = match text(arguments, "fit") {
        Some("inside") => Fit::Inside,
        Some("outside") => Fit::Outside,
        Some("volume") => Fit::Volume,
        _ => Fit::Surface,
    };
    let fineness = Fineness {
        chord_error: text(arguments, "chord-error"),
        around: arguments.get_one::<u32>("facets").copied(),
        segments: arguments.get_one::<u32>("segments").copied(),
        fit,
    };
    let surface = Surface::of(&ply, &assembly, fineness)?;
    Ok((format.write(&surface, &unit), format.is_binary(), surface_summary(&ply, &surface, &unit)))
}
