//! `nply nodes`: start geometry for finite elements.

use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use nply_sheet::mesh::{FileUnit, LineFormat, StartGeometry, StartWanted};
use nply_sheet::{Key, SpecError, Table};

use super::Verb;
use super::mesh::{deliver, element, element_type, format, text};
use crate::arguments::{count, json, with_keys};
use crate::failure::Failure;
use crate::input::{self, Described, Input};
use crate::output;

const LONG: &str = "\
Wires of straight elements lie closer than the helices they stand for: laid to touch, they overlap. This finds the least
helix radius at which the elements keep clear, by their diameter and twice the coating, of each other and of a core, at
the helical angle given, or at the lay length if that is given; says what part of the gap chords take; and writes the nodes
(INP, CSV, XYZ, PDB, VTP) with --output. With --lay-radius that radius is taken, and it is said whether it clears.

A file with [[layer]], as `nply fit-check` reads it, is a strand of layers: each is laid, at the lay length it has there,
clear of itself and of all that is below it. (The wires of a rope's strands are no helices: `nply mesh --centrelines`.)";

pub(super) const VERB: Verb = Verb {
    name: "nodes",
    about: "Start geometry of straight elements that do not overlap",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    const MOST: i64 = 1_000_000;
    let wanted = |key: &Key| {
        (key.table == Table::Lay && key.name != "helix_radius")
            || ["strands", "hand", "radius", "diameter"].contains(&key.name)
    };
    let text = |name: &'static str, value: &'static str, help: &'static str| {
        Arg::new(name).long(name).value_name(value).allow_hyphen_values(true).help(help)
    };
    with_keys(command, wanted)
        .arg(count("elements-per-pitch", "Elements per lay length, of layers per the shortest (24)", MOST))
        .arg(element_type())
        .arg(text("coating", "LENGTH", "Thickness of a coating on every wire"))
        .arg(
            text("core", "RADIUS", "A core wire along the axis; without a radius, one as thick as the others")
                .allow_hyphen_values(false)
                .num_args(0..=1)
                .default_missing_value(""),
        )
        .arg(
            text(
                "stagger",
                "ELEMENTS",
                "How much farther along each wire's nodes stand than those of the one before (0)",
            )
            .value_parser(value_parser!(f64)),
        )
        .arg(
            Arg::new("any-stagger")
                .long("any-stagger")
                .action(ArgAction::SetTrue)
                .conflicts_with("stagger")
                .help("Keep clear however the nodes of two wires stand to each other"),
        )
        .arg(text("lay-radius", "LENGTH", "Take this radius of the centrelines' helices, clear or not"))
        .arg(text("length", "LENGTH", "How much of the ply, along its axis"))
        .arg(
            text("lay-lengths", "NUMBER", "The same in lay lengths, turns of a wire (3)")
                .value_parser(value_parser!(f64)),
        )
        .arg(output::file("Where to write the nodes; the end of the name tells the format"))
        .arg(
            text("format", "FORMAT", "The format, if the file's name does not tell it")
                .value_parser(clap::builder::PossibleValuesParser::new(LineFormat::ALL.map(LineFormat::extension))),
        )
        .arg(text("unit", "UNIT", "The unit of coordinates: mm, nm, …, or r for strand radii"))
        .arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read_described(arguments)?;
    let (start, file, unit) = made(arguments, &input).map_err(|error| input.refused(error))?;
    let report = if arguments.get_flag("json") { start.json() } else { start.text(&unit) };
    match file {
        Some(bytes) => deliver(arguments, &bytes, false, &report),
        None => output::write(&report),
    }
}

/// The lay that is found, its nodes as a file if one is wanted, and the unit a person reads.
fn made(
    arguments: &ArgMatches,
    input: &Input<Described>,
) -> Result<(StartGeometry, Option<Vec<u8>>, FileUnit), SpecError> {
    let wanted = StartWanted {
        elements: arguments.get_one::<u32>("elements-per-pitch").copied(),
        element: element(arguments),
        coating: text(arguments, "coating"),
        core: text(arguments, "core"),
        stagger: arguments.get_one::<f64>("stagger").copied(),
        any_stagger: arguments.get_flag("any-stagger"),
        helix_radius: text(arguments, "lay-radius"),
        length: text(arguments, "length"),
        lay_lengths: arguments.get_one::<f64>("lay-lengths").copied(),
    };
    let start = match &input.spec {
        Described::Ply(spec) => StartGeometry::of(spec, &wanted)?,
        Described::Layered(strand) => StartGeometry::of_layers(strand, &wanted)?,
    };
    let said = text(arguments, "unit");
    let unit = FileUnit::of(start.ply(), said, None)?;
    if text(arguments, "output").is_none() && text(arguments, "format").is_none() {
        return Ok((start, None, unit));
    }
    let format = format(arguments, &LineFormat::ALL.map(LineFormat::extension))?;
    let found = LineFormat::ALL.into_iter().find(|known| known.extension().eq_ignore_ascii_case(format));
    let format = found.unwrap_or(LineFormat::Csv);
    let own = FileUnit::of(start.ply(), said, format.own_unit())?;
    let bytes = format.write(&start.title(), &start.chains()?, &own)?;
    Ok((start, Some(bytes), unit))
}
