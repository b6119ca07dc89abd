//! `nply schema`: what documents and reports look like, for programs.

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgMatches, Command};
use nply_sheet::schema::{DOCUMENTS, REPORTS, Subject};

use super::Verb;
use crate::failure::Failure;
use crate::output;

const LONG: &str = "\
Prints the JSON Schema (2020-12) of a kind of document that is read, or of the JSON report that a command writes; without either, lists
them. A document's schema refuses unknown keys, as the reader does; a report's allows for names that later versions add. An editor that
knows schemas (Taplo, and what is built on it) completes and checks a document whose first line is `#:schema ply.schema.json`.";

const EXAMPLES: &str = "\
Examples:
  nply schema
  nply schema --document ply > ply.schema.json
  nply schema --report solve > solve.schema.json
  nply schema --document ply --format markdown";

pub(super) const VERB: Verb = Verb {
    name: "schema",
    about: "JSON Schemas of documents and reports",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    let one_of = |name: &'static str, all: &'static [Subject], help: &'static str| {
        let names = PossibleValuesParser::new(all.iter().map(|subject| subject.name));
        Arg::new(name).long(name).value_name("KIND").value_parser(names).help(help)
    };
    let format = Arg::new("format").long("format").value_name("FORMAT").default_value("json");
    command
        .arg(one_of("document", &DOCUMENTS, "What is read: a kind of document"))
        .arg(one_of("report", &REPORTS, "What is written: the report of a command").conflicts_with("document"))
        .arg(
            format
                .value_parser(PossibleValuesParser::new(["json", "markdown"]))
                .help("The schema, or its names as tables of Markdown"),
        )
        .after_help(EXAMPLES)
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let named = |flag: &str, all: &'static [Subject]| {
        arguments.get_one::<String>(flag).and_then(|name| Subject::named(all, name))
    };
    let is_markdown = arguments.get_one::<String>("format").is_some_and(|format| format == "markdown");
    match named("document", &DOCUMENTS).or_else(|| named("report", &REPORTS)) {
        Some(subject) if is_markdown => output::write(&subject.markdown()),
        Some(subject) => output::write(&format!("{:#}\n", subject.schema())),
        None => output::write(&list()),
    }
}

/// All that have a schema, a line each.
fn list() -> String {
    let lines = |flag: &'static str, all: &'static [Subject]| {
        all.iter().map(move |subject| (format!("--{flag} {}", subject.name), subject.about))
    };
    let lines: Vec<(String, &str)> = lines("document", &DOCUMENTS).chain(lines("report", &REPORTS)).collect();
    let width = lines.iter().map(|(call, _)| call.len()).max().unwrap_or(0);
    lines.iter().map(|(call, about)| format!("nply schema {call:width$}  {about}\n")).collect()
}
