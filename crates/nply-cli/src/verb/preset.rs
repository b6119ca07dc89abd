//! `nply preset`: published plies and strands, as documents to start from.

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgMatches, Command};
use nply_sheet::{PRESETS, Preset, list_presets};

use super::Verb;
use crate::arguments::json;
use crate::failure::Failure;
use crate::output;

const LONG: &str = "\
Without a name, lists the documents that come with the program, each with the command that reads it. With a name, prints that
document (TOML, with the source of its numbers), to be read by another command or kept as a file to start from.";

const EXAMPLES: &str = "\
Examples:
  nply preset
  nply preset dna-plectoneme | nply solve -
  nply preset tyre-cord-840d-2 > cord.toml";

pub(super) const VERB: Verb = Verb {
    name: "preset",
    about: "Published plies and strands, with their sources, to start from",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    let names = PossibleValuesParser::new(PRESETS.iter().map(|preset| preset.name));
    let name = Arg::new("name").value_name("NAME").value_parser(names).hide_possible_values(true);
    let name = name.help("Which one to print; all are listed without");
    command.arg(name).arg(json().help("Write the list as JSON")).after_help(EXAMPLES)
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    match arguments.get_one::<String>("name").and_then(|name| Preset::named(name)) {
        Some(preset) => output::write(preset.text),
        None => output::write(&list_presets(arguments.get_flag("json"))),
    }
}
