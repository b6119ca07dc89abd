//! `nply link`: how curves in files are linked with each other.

use clap::{ArgMatches, Command};
use nply_sheet::LinkReport;

use super::Verb;
use crate::arguments::{format, json};
use crate::curves;
use crate::failure::Failure;
use crate::output::{self, Format};

const ABOUT: &str = "\
Prints the linking number of each two curves: an integer, counted, for closed curves; the Gauss integral where one of them is
open. Curves can come from several files. Strands that wind right-handed about each other and run the same way have a positive
number. The strands of a duplex in a PDB file, each from 5' to 3', run against each other, which turns the sign: --reverse B
reads one of them backwards; a circle needs --closed.";

pub(super) const VERB: Verb =
    Verb { name: "link", about: "How curves in files are linked", long: ABOUT, examples: false, arguments, run };

/// Pairs worked out between two looks at the clock and at Ctrl-C.
const ROUND: usize = 256;

fn arguments(command: Command) -> Command {
    let command = command.long_about(curves::about(ABOUT));
    curves::with_extension(curves::with_files(command)).arg(format()).arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let set = curves::read(arguments)?;
    let extension = curves::extension(arguments, &set)?;
    let mut report = LinkReport::new(set, extension).map_err(Failure::Premise)?;
    let pairs: Vec<[usize; 2]> = report.pairs().collect();
    report.links = curves::each(arguments, &pairs, "pairs", ROUND, |pair| report.link(*pair))?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}
