//! `nply writhe`: the writhe of curves in files.

use clap::{Arg, ArgAction, ArgMatches, Command};
use nply::topology::{AverageCrossings, CrossingShare};
use nply_sheet::{WritheQuestion, WritheReport};
use rayon::prelude::*;

use super::Verb;
use crate::arguments::{format, json};
use crate::curves;
use crate::failure::Failure;
use crate::interrupt;
use crate::output::{self, Format};

const ABOUT: &str = "\
Prints the writhe of each curve, closed or open, exact for the polygon, with a bound for its rounding error. A right-handed
trefoil has positive writhe, a right-handed plectoneme (whose strands run in opposite directions) negative writhe.";

pub(super) const VERB: Verb =
    Verb { name: "writhe", about: "The writhe of curves in a file", long: ABOUT, examples: false, arguments, run };

/// Curves worked out between two looks at the clock and at Ctrl-C.
const ROUND: usize = 64;
/// The same for columns of pairs, some 10⁸ pairs at most for a curve of 10⁵ segments.
const COLUMNS: usize = 16;

fn arguments(command: Command) -> Command {
    let command = command.long_about(curves::about(ABOUT));
    curves::with_extension(curves::with_files(command))
        .arg(
            Arg::new("axis")
                .long("axis")
                .value_name("X,Y,Z")
                .allow_hyphen_values(true)
                .value_parser(vector)
                .help("Print the polar writhe along this axis too (Berger & Prior 2006)"),
        )
        .arg(
            Arg::new("ribbon")
                .long("ribbon")
                .action(ArgAction::SetTrue)
                .conflicts_with("extend")
                .help("Curves come in twos, a centreline and the edge of its ribbon: print its twist and link too"),
        )
        .arg(
            Arg::new("average-crossings")
                .long("average-crossings")
                .action(ArgAction::SetTrue)
                .help("Print the average crossing number too: a sum over all pairs of segments"),
        )
        .arg(format())
        .arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let set = curves::read(arguments)?;
    let question = WritheQuestion {
        extension: curves::extension(arguments, &set)?,
        axis: arguments.get_one::<[f64; 3]>("axis").copied(),
        ribbon: arguments.get_flag("ribbon"),
    };
    let mut report = WritheReport::new(set, question).map_err(Failure::Premise)?;
    let all: Vec<usize> = (0..report.len()).collect();
    report.found = curves::each(arguments, &all, "curves", ROUND, |curve| report.writhing(*curve))?;
    if arguments.get_flag("average-crossings") {
        for number in all {
            report.found[number].average_crossings = Some(average(arguments, &report.average_crossings(number))?);
        }
    }
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}

/// All pairs of a curve's segments, on all cores; added up in one order, however many there are.
fn average(arguments: &ArgMatches, work: &AverageCrossings) -> Result<CrossingShare, Failure> {
    let all = work.columns();
    let bar = curves::bar(arguments, usize::try_from(work.pairs(0..all)).unwrap_or(usize::MAX), "pairs");
    let mut sum = CrossingShare::default();
    for first in (0..all).step_by(COLUMNS) {
        interrupt::check().inspect_err(|_| bar.finish_and_clear())?;
        let last = (first + COLUMNS).min(all);
        let shares: Vec<CrossingShare> = (first..last).into_par_iter().map(|k| work.share(k..k + 1)).collect();
        sum = shares.into_iter().fold(sum, |sum, share| sum + share);
        bar.inc(work.pairs(first..last));
    }
    bar.finish_and_clear();
    Ok(sum)
}

/// Three finite numbers between commas.
fn vector(text: &str) -> Result<[f64; 3], String> {
    let numbers: Vec<f64> =
        text.split(',').map_while(|word| word.trim().parse().ok()).filter(|x: &f64| x.is_finite()).collect();
    let wanted = || "three numbers between commas are wanted, such as 0,0,1".to_owned();
    if text.split(',').count() == 3 { numbers.try_into().map_err(|_| wanted()) } else { Err(wanted()) }
}
