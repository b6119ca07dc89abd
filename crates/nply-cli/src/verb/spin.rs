//! `nply spin`: the ply twist that balances the twist of its singles.

use clap::{ArgMatches, Command};
use nply_sheet::{Key, PlyingReport, Table};

use super::Verb;
use crate::arguments::{format, json, with_keys, without_stretch};
use crate::failure::Failure;
use crate::input;
use crate::output::{self, Format};

const LONG: &str = "\
For spinners and twisters. From the twist of the singles (--turns-per-length \"8 tpi Z\"): the ply twist that balances it, take-up,
resulting titre, ply angle and diameter, and what the rule of two thirds would make of it. From a wanted ply (--ply-turns-per-length \"5 tpi S\", or
an angle and --hand): the twist its singles need. From both: how far the ply is from balance, and what it does when let go. Singles
have a diameter, or a linear density (tex, den, \"Ne 30\") with the density of the fibre.";

const EXAMPLES: &str = "\
Examples:
  nply spin --strands 2 --stiffness-ratio 1 --diameter \"0.5 mm\" --turns-per-length \"8 tpi Z\"
  nply spin --strands 3 --stiffness-ratio 1 --linear-density \"Ne 8\" --density \"1.54 g/cm^3\" --packing-fraction 0.6 \\
      --ply-turns-per-length \"6 tpi S\"";

pub(super) const VERB: Verb = Verb {
    name: "spin",
    about: "Singles twist and ply twist in balance, for spinners",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    let wanted = |key: &Key| {
        matches!(key.table, Table::Ply | Table::Strand | Table::Twist | Table::Lay) && key.name != "strand_twist"
    };
    without_stretch(with_keys(command, wanted)).arg(format()).arg(json()).after_help(EXAMPLES)
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let report = input.spec.check_plying().and_then(PlyingReport::of).map_err(|error| input.refused(error))?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}
