//! `nply solve`: every state of one ply.

use clap::{ArgMatches, Command};
use nply_sheet::Report;

use super::Verb;
use crate::arguments::{format, json, with_keys};
use crate::failure::Failure;
use crate::input;
use crate::output;

const LONG: &str = "\
Reads a ply from FILE (TOML), from flags, or from both (flags replace what the file says), and prints every state in
which it is in equilibrium, of both hands. Give the twist of the strands and the end loads (none: the balanced ply);
or the lay and two of twist, force and moment, and the third is found; or the lay alone, and the pretwist that
balances it is found. Ends may be held instead of loaded: give the ply's rotation or length, and the load that holds it
there is found.

A quantity is a number with its unit: \"0.5 mm\", \"70 GPa\", \"50 pN nm^2\", \"200 turns/m\", \"5 turns/inch\", \"20 deg\".
Where no size is given at all, bare numbers are dimensionless: r = B = 1.";

pub(super) const VERB: Verb =
    Verb { name: "solve", about: "Every equilibrium state of one ply", long: LONG, examples: true, arguments, run };

fn arguments(command: Command) -> Command {
    with_keys(command, |_| true).arg(format()).arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let report = input.spec.check().and_then(Report::of).map_err(|error| input.refused(error))?;
    output::write_report(arguments, &report)
}
