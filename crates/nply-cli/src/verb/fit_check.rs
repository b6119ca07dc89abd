//! `nply fit-check`: do wires fit beside each other on their core?

use clap::{ArgMatches, Command};
use nply_sheet::{FitReport, Key, Table};

use super::Verb;
use crate::arguments::{format, json, with_construction_keys};
use crate::failure::Failure;
use crate::input;
use crate::output::{self, Format};

const LONG: &str = "\
Says whether the wires of a strand fit beside each other on its core, exactly and in three dimensions: the gap between
neighbours (negative: they overlap), what the wires lie on, the lay radius and the core (king wire) at which they just touch,
diameters, lay angle, fill factor, wire length and mass; and what the flat and the ellipse formula in use would miss. Layers
are laid on layers. The strand is read from FILE (TOML: [core] and one [[layer]] for each layer), from flags, or both.

What is not given is found: the core for a gap that is wanted, the lay length at which neighbours just touch on a
core, the wires' diameter for an outer diameter. Numbers may be bare, then all are in one unit of length, or all have units.

Examples:
  nply fit-check --core-diameter 5.1 --wire-diameter 5 --strands 6 --lay-length 210
  nply fit-check --wire-diameter \"3.73 mm\" --strands 6 --lay-length \"115 mm\" --gap \"0.05 mm\"
  nply fit-check --outer-diameter \"12.7 mm\" --strands 6 --lay-ratio 14 --gap 0 --core-material steel --wire-material steel
  nply fit-check --core-diameter 3.34 --wire-diameter 3.34 --strands 6 --strands 12 --lay-ratio 21 --lay-ratio 13
  nply fit-check examples/conductor-cardinal.toml";

pub(super) const VERB: Verb = Verb {
    name: "fit-check",
    about: "Whether wires fit beside each other on a core, layer by layer",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    with_construction_keys(command, wanted).arg(format()).arg(json())
}

/// All but loads and what is found from them.
fn wanted(key: &Key) -> bool {
    key.table != Table::Load && !["torque_factor", "balanced_layer"].contains(&key.name)
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read_construction(arguments)?;
    let report = input.spec.check_fit().map(FitReport::of).map_err(|error| input.refused(error))?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}
