//! `nply lays`: the distinguished lays of n strands.

use clap::{ArgMatches, Command};
use nply_sheet::LaysReport;

use super::Verb;
use crate::arguments::{json, with_keys};
use crate::failure::Failure;
use crate::input;
use crate::output;

const LONG: &str = "\
Prints the lays at which touching strands are special: zero twist (the most turns they can take), most torsion, most curvature,
close packed, the cut across the ply turning non-convex, and for two strands the lock-up of line contact. With
--strands 1, the densest helix of a single tube.";

pub(super) const VERB: Verb =
    Verb { name: "lays", about: "The distinguished lays of n strands", long: LONG, examples: false, arguments, run };

fn arguments(command: Command) -> Command {
    with_keys(command, |key| key.name == "strands").arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let report = input.spec.check_strands().map(LaysReport::of).map_err(|error| input.refused(error))?;
    output::write(&if arguments.get_flag("json") { report.json() } else { report.text(true) })
}
