//! `nply trace`: a ply followed along a path.

use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use nply_sheet::{Table, TraceReport, Walk};

use super::Verb;
use crate::arguments::{corners, format, json, plot, with_keys};
use crate::failure::Failure;
use crate::input;
use crate::output::{self, Format};

const LONG: &str = "\
Follows a ply from the data of FILE (or flags) to others, leg by leg, by the smallest steps needed: through folds, over
contacts that open and close. Where it leads is said by --to-force, --to-pretwist and the like, or by [[path]] tables
in FILE, one a leg. Prints what happens on the way, each event where it happens: strands part or meet, on the core or
off it, a fold (the stable states end, and the ply jumps: where to is said), 45 degrees, no more turns, straight.

Contacts push and never pull. With --kept (always in radial balance) neighbours stay together even where they would
have to pull, as in the paper.";

pub(super) const VERB: Verb =
    Verb { name: "trace", about: "Follow a ply along a path", long: LONG, examples: true, arguments, run };

fn arguments(command: Command) -> Command {
    let command = with_keys(command, |key| key.table != Table::Lay && key.name != "separation");
    corners(command, "to-", "Where the path leads")
        .arg(
            Arg::new("start")
                .long("start")
                .value_name("STATE")
                .value_parser(value_parser!(u32).range(1..))
                .help("The number of the state to start from, of those listed; the first stable one if absent"),
        )
        .arg(
            Arg::new("kept")
                .long("kept")
                .action(ArgAction::SetTrue)
                .help("Keep neighbours together even where they would have to pull"),
        )
        .arg(
            Arg::new("curvature-limit")
                .long("curvature-limit")
                .value_name("STRAIN")
                .value_parser(value_parser!(f64))
                .help("Say where the bending strain of the outer fibre, strand radius times curvature, passes this"),
        )
        .arg(
            Arg::new("strain-limit")
                .long("strain-limit")
                .value_name("STRAIN")
                .value_parser(value_parser!(f64))
                .help("Say where the strain of the outermost fibre, from stretch and bending together, passes this"),
        )
        .arg(plot())
        .arg(format())
        .arg(json())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let leg = input::corner(arguments, "to-")?;
    let walk = Walk {
        start: arguments.get_one::<u32>("start").map(|start| *start as usize),
        kept: arguments.get_flag("kept"),
        curvature_limit: arguments.get_one::<f64>("curvature-limit").copied(),
        strain_limit: arguments.get_one::<f64>("strain-limit").copied(),
    };
    let report = input
        .spec
        .check_path(leg.as_ref())
        .and_then(|cases| TraceReport::of(cases, walk))
        .map_err(|error| input.refused(error))?;
    output::plot(arguments, || report.picture().svg())?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}
