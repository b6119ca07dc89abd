//! `nply support`: what carries the strands of one ply.

use clap::{ArgMatches, Command};
use nply_sheet::{Report, Table};

use super::Verb;
use crate::arguments::{format, json, with_keys};
use crate::failure::Failure;
use crate::input;
use crate::output;

const LONG: &str = "\
Prints every state in which all closed contacts push and none pulls: strands carried by their
neighbours, by a core, by both, or free (the ply has opened), of both hands; whether each is
stable under dead loads, with ends that cannot turn, with the length held, and with the strands'
torque held; and the loads at which that changes. Give the twist of the strands, and the loads or
how the ends are held.

A core is given by --support-core-radius or --support-core-diameter (or [support] in FILE):
whether strands lie on it is found. That is not --core-radius, which belongs to the lay and says
that touching strands do lie on it.";

pub(super) const VERB: Verb = Verb {
    name: "support",
    about: "What carries the strands: neighbours, a core, both, or nothing",
    long: LONG,
    examples: true,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    with_keys(command, |key| key.table != Table::Lay).arg(format()).arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let report = input.spec.check_supports().and_then(Report::of).map_err(|error| input.refused(error))?;
    output::write_report(arguments, &report)
}
