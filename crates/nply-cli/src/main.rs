//! The command `nply`: argv, files, terminal and exit codes; everything else is in `nply-sheet` and `nply`.

mod arguments;
mod failure;
mod input;
mod output;
mod study;

use std::process::ExitCode;

use clap::ArgMatches;
use nply_sheet::{LaysReport, Report, ShapeReport};

use failure::Failure;
use output::Format;

fn main() -> ExitCode {
    let matches = match arguments::command().try_get_matches() {
        Ok(matches) => matches,
        Err(error) => return Failure::usage(&error),
    };
    let done = match matches.subcommand() {
        Some(("solve", arguments)) => solve(arguments),
        Some(("support", arguments)) => support(arguments),
        Some(("trace", arguments)) => study::trace(arguments),
        Some(("map", arguments)) => study::map(arguments),
        Some(("locus", arguments)) => study::locus(arguments),
        Some(("contact", arguments)) => contact(arguments),
        Some(("lays", arguments)) => lays(arguments),
        _ => Ok(()), // a subcommand is required: not reached
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

/// `nply solve`: every state of one ply.
fn solve(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let report = input.spec.check().and_then(Report::of).map_err(|error| input.refused(error))?;
    write(&report, arguments)
}

/// `nply support`: what carries the strands of one ply.
fn support(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let report = input.spec.check_supports().and_then(Report::of).map_err(|error| input.refused(error))?;
    write(&report, arguments)
}

fn write(report: &Report, arguments: &ArgMatches) -> Result<(), Failure> {
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}

/// `nply contact`: geometry alone.
fn contact(arguments: &ArgMatches) -> Result<(), Failure> {
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

/// `nply lays`: the distinguished lays of n strands.
fn lays(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let report = input.spec.check_strands().map(LaysReport::of).map_err(|error| input.refused(error))?;
    output::write(&if arguments.get_flag("json") { report.json() } else { report.text(true) })
}
