//! `nply writhe`: the writhe of curves in files.

use clap::{ArgMatches, Command};
use nply_sheet::WritheReport;

use super::Verb;
use crate::arguments::{format, json};
use crate::curves::{self, FILES};
use crate::failure::Failure;
use crate::output::{self, Format};

const ABOUT: &str = "\
Prints the writhe of each curve, closed or open, exact for the polygon, with a bound for its rounding error. A right-handed
trefoil has positive writhe, a right-handed plectoneme (whose strands run in opposite directions) negative writhe.";

pub(super) const VERB: Verb =
    Verb { name: "writhe", about: "The writhe of curves in a file", long: ABOUT, examples: false, arguments, run };

/// Curves worked out between two looks at the clock and at Ctrl-C.
const ROUND: usize = 64;

fn arguments(command: Command) -> Command {
    let command = command.long_about(format!("{ABOUT}\n\n{FILES}"));
    curves::with_extension(curves::with_files(command)).arg(format()).arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let set = curves::read(arguments)?;
    let extension = curves::extension(arguments, &set)?;
    let mut report = WritheReport::new(set, extension).map_err(Failure::Premise)?;
    let all: Vec<usize> = (0..report.len()).collect();
    report.writhes = curves::each(arguments, &all, "curves", ROUND, |curve| report.writhe(*curve))?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}
