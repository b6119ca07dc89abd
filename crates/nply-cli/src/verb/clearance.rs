//! `nply clearance`: how near wires come to each other, and which overlap.

use clap::{Arg, ArgAction, ArgMatches, Command};
use nply::geometry::Clearance;
use nply_sheet::ClearanceReport;
use rayon::prelude::*;

use super::Verb;
use crate::arguments::{format, json};
use crate::curves::{self, bar};
use crate::failure::Failure;
use crate::interrupt;
use crate::output::{self, Format};

const ABOUT: &str = "\
Finds the least distance of any two different wires, where it is, and how many pairs overlap, given their diameter; and
whether a wire overlaps with itself, farther along it than half a turn of the sharpest bend it can have (pi times its
radius). Coordinates and diameters are in one unit, that of the file.";

pub(super) const VERB: Verb = Verb {
    name: "clearance",
    about: "The least distance of wires in a file, and which overlap",
    long: ABOUT,
    examples: false,
    arguments,
    run,
};

/// Segments that one thread looks at before it takes more.
const STRETCH: usize = 256;
/// Stretches between two looks at the clock and at Ctrl-C, and at what others have found.
const ROUND: usize = 32;

fn arguments(command: Command) -> Command {
    let command = command.long_about(curves::about(ABOUT));
    curves::with_files(command)
        .arg(
            Arg::new("diameter")
                .long("diameter")
                .short('d')
                .value_name("LENGTH")
                .action(ArgAction::Append)
                .allow_hyphen_values(true)
                .help("The wires' diameter; given several times, one for each curve; else that of the file: a column `diameter` or `radius`, or the radius above each set of an INP"),
        )
        .arg(format())
        .arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let set = curves::read(arguments)?;
    let diameters: Vec<&str> =
        arguments.get_many::<String>("diameter").into_iter().flatten().map(String::as_str).collect();
    let mut report = ClearanceReport::new(set, &diameters).map_err(|error| Failure::Refused(error, String::new()))?;
    interrupt::prepare(arguments);
    report.found = search(arguments, &report)?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}

/// All segments, on all cores. What is found does not depend on how many there are.
fn search(arguments: &ArgMatches, report: &ClearanceReport) -> Result<Clearance, Failure> {
    let all = report.wires.segments();
    let bar = bar(arguments, all, "segments");
    let mut found = Clearance::default();
    let mut first = 0;
    while first < all {
        interrupt::check().inspect_err(|_| bar.finish_and_clear())?;
        // the first round is one stretch alone: what it finds spares the others much
        let last = if first == 0 { STRETCH } else { first + ROUND * STRETCH }.min(all);
        let stretches: Vec<usize> = (first..last).step_by(STRETCH).collect();
        let more: Vec<Clearance> = stretches
            .into_par_iter()
            .map(|first| report.wires.search(first..(first + STRETCH).min(last), &found))
            .collect();
        more.into_iter().for_each(|more| found.merge(more));
        bar.inc((last - first) as u64);
        first = last;
    }
    bar.finish_and_clear();
    Ok(found)
}
