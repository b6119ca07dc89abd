//! `nply locus`: the loads at which touching strands part.

use clap::{ArgMatches, Command};
use nply_sheet::{Key, LocusReport, Table};

use super::Verb;
use crate::arguments::{count, format, json, plot, with_keys};
use crate::failure::Failure;
use crate::input;
use crate::output::{self, Format};

const LONG: &str = "\
Prints the loads at which touching strands just stop pressing on each other (p = 0), for both hands, from straight
strands to flat rings: the special points as a table, the whole curve as CSV or JSON, and a picture with --plot. Only the
twist of the strands is looked at.";

pub(super) const VERB: Verb = Verb {
    name: "locus",
    about: "The loads at which touching strands part",
    long: LONG,
    examples: true,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    let wanted =
        |key: &Key| !matches!(key.table, Table::Lay | Table::Ends | Table::Support) && key.name != "separation";
    with_keys(command, wanted)
        .arg(count("points", "Angles on each curve (200)", u32::MAX.into()))
        .arg(plot())
        .arg(format())
        .arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let points = arguments.get_one::<u32>("points").map_or(LocusReport::POINTS, |points| *points as usize);
    let report =
        input.spec.check().and_then(|case| LocusReport::of(&case, points)).map_err(|error| input.refused(error))?;
    output::plot(arguments, || report.picture().svg())?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}
