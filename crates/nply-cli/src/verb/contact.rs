//! `nply contact`: geometry alone.

use clap::{Arg, ArgMatches, Command, value_parser};
use nply_sheet::{Key, ShapeReport, Table};

use super::Verb;
use crate::arguments::{json, with_keys};
use crate::failure::Failure;
use crate::input;
use crate::output::{self, Format};

const LONG: &str = "\
Prints how neighbouring strands touch at a given lay: helix radius, arclength shift, contact line, hole, curvature.
With --strands 1 and no lay, the densest helix of a single tube.";

/// What tells number and size of the strands.
const SHAPE: [&str; 7] = ["strands", "hand", "radius", "diameter", "linear_density", "density", "packing_fraction"];

pub(super) const VERB: Verb = Verb {
    name: "contact",
    about: "Geometry alone: how strands touch at a lay",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    let wanted = |key: &Key| key.table == Table::Lay || SHAPE.contains(&key.name);
    with_keys(command, wanted)
        .mut_arg("strands", |strands| strands.help("Number of strands n, 2 or more; 1 for a single tube"))
        .arg(
            Arg::new("branches")
                .long("branches")
                .value_name("MOST")
                .num_args(0..=1)
                .default_missing_value("20")
                .value_parser(value_parser!(u32).range(1..=100_000))
                .help("List solutions of the contact condition too, nearest first, at most MOST (20)"),
        )
        .arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let most = arguments.get_one::<u32>("branches").map_or(0, |most| *most as usize);
    let report = input
        .spec
        .check_shape()
        .and_then(|shape| ShapeReport::of(shape, most))
        .map_err(|error| input.refused(error))?;
    output::write(&match Format::of(arguments) {
        Format::Json => report.json(),
        Format::Table | Format::Csv => report.text(true),
    })
}
