//! `nply stiffness`: what a strand or rope carries, and how stiffly.

use clap::{ArgMatches, Command};
use nply_sheet::{Key, StiffnessReport};

use super::Verb;
use crate::arguments::{format, json, with_construction_keys};
use crate::failure::Failure;
use crate::input;
use crate::output::{self, Format};

const LONG: &str = "\
Says what a strand or rope of concentric layers carries, and how stiffly: EA, GJ and their coupling with ends that cannot turn
or are free to, torque factor, unlay; what core and layers share of the load; stresses in their wires from stretch, bending
and twist; what presses where, with Hertz's pressure along lines of contact; and the load at which a layer lifts off
(birdcaging). Layers have hands and lays of their own; wires may be preformed or not; a layer may be of strands ([layer.strand]).

The strand is read from FILE (TOML: [core], one [[layer]] for each layer, [load]), from flags, or both. Without a load, the
answer is about the lay as made. With --torque-factor 0 the lay of a layer is found at which a pull asks for no moment.

Examples:
  nply stiffness examples/strand-7-wire.toml --force \"100 kN\"
  nply stiffness examples/strand-7-wire.toml --force \"100 kN\" --moment 0
  nply stiffness examples/rope-6x7.toml --json
  nply stiffness examples/spiral-strand-1x19.toml --torque-factor 0 --balanced-layer 2";

pub(super) const VERB: Verb = Verb {
    name: "stiffness",
    about: "What a strand or rope carries, and how stiffly: EA, GJ, torque, stresses, load shares",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    let wanted = |key: &Key| !["outer_diameter", "diameter_ratio", "gap"].contains(&key.name);
    with_construction_keys(command, wanted).arg(format()).arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read_construction(arguments)?;
    let case = input.spec.check_cable().map_err(|error| input.refused(error))?;
    let report = StiffnessReport::of(&input.spec, case).map_err(|error| input.refused(error))?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}
