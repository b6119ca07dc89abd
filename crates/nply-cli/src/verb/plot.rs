//! `nply plot`: what runs against what is asked.

use std::path::Path;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use nply::Handedness;
use nply::mechanics::Balance;
use nply_sheet::graph::{GraphFlags, Scales};
use nply_sheet::plot::Theme;

use super::Verb;
use crate::arguments::with_keys;
use crate::failure::Failure;
use crate::input;
use crate::output::{self, Draft};

const LONG: &str = "\
Draws what is asked of every state while one datum runs: whole curves with their folds, every state of both hands, dashed where
neighbours would have to pull on each other, or without those with --touching. Where a lay runs and only the shape is asked, with no twist
and no load, all is geometry and nothing dashed. Several numbers of strands, hands and balances go in one picture; several things asked
stand above each other. Without --output the picture is shown in the terminal.";

const EXAMPLES: &str = "\
Examples:
  nply plot examples/three-ply-yarn.toml --sweep \"pretwist=-3..3\" --ask helical_angle,interstrand_pressure -o yarn.svg
  nply plot rope.toml --sweep \"load.force=0..2 kN\" --ask helical_angle,outer_diameter
  nply plot --strands 2,3,6 --stiffness-ratio 0.75 --sweep \"pretwist=-3..3\" --ask helical_angle --balance both -o angle.png
  nply plot --strands 3 --stiffness-ratio 0.75 --force 0 --moment 0 --sweep \"helical_angle=1 deg..60 deg\" --ask pretwist

What runs: any of the loads, the twist, the held ends, the lay, the stiffness ratio, written as in the file (`load.force`) or as its flag.
What can be asked: every column of `nply solve --format csv`, with or without its unit.";

pub(super) const VERB: Verb = Verb {
    name: "plot",
    about: "Curves of every state while one datum runs",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    let listed = ["strands", "balance", "hand"];
    let list = |name: &'static str, id: &'static str| Arg::new(id).long(name).value_delimiter(',');
    let switch =
        |name: &'static str, help: &'static str| Arg::new(name).long(name).action(ArgAction::SetTrue).help(help);
    with_keys(command, |key| !listed.contains(&key.flag) && key.name != "separation")
        .after_help(EXAMPLES)
        .arg(
            Arg::new("sweep")
                .long("sweep")
                .required(true)
                .value_name("KEY=FROM..TO")
                .help("What runs, and from where to where; a unit at the end stands for both"),
        )
        .arg(list("ask", "ask").required(true).value_name("NAMES").help("What is asked of each state"))
        .arg(
            Arg::new("against")
                .long("against")
                .value_name("NAME")
                .help("What stands on the axis below, if not what runs"),
        )
        .arg(
            list("strands", "plies")
                .value_name("N,N")
                .value_parser(value_parser!(u32).range(1..=1_000_000))
                .help("Numbers of strands, if not that of the file"),
        )
        .arg(
            list("balance", "balances")
                .value_name("contact|radial|both")
                .value_parser(PossibleValuesParser::new(["contact", "radial", "both"]))
                .help("Which balance, or both"),
        )
        .arg(
            list("hand", "hands")
                .value_name("right|left|both")
                .value_parser(PossibleValuesParser::new([
                    PossibleValue::new("right").aliases(["Z", "z"]),
                    PossibleValue::new("left").aliases(["S", "s"]),
                    PossibleValue::new("both"),
                ]))
                .help("Which hand, Z for right and S for left; both if not said"),
        )
        .arg(switch("touching", "Leave out the states on which neighbours would have to pull on each other"))
        .arg(
            Arg::new("output")
                .long("output")
                .short('o')
                .value_name("FILE")
                .help("Where to write: the picture, or the numbers if the name ends in .csv"),
        )
        .arg(switch("term", "Show the picture in the terminal, besides"))
        .arg(switch("dark", "Draw on dark ground"))
        .arg(switch("log-x", "Equal lengths for equal ratios, below"))
        .arg(switch("log-y", "The same on the left"))
        .arg(output::zoom())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let words = |name: &str| arguments.get_many::<String>(name).into_iter().flatten().cloned().collect::<Vec<String>>();
    let both =
        |words: &[String], name: &str| words.iter().any(|word| word.eq_ignore_ascii_case(name) || word == "both");
    let (hands, balances) = (words("hands"), words("balances"));
    let flags = GraphFlags {
        sweep: arguments.get_one::<String>("sweep").cloned().unwrap_or_default(),
        ask: words("ask"),
        against: arguments.get_one::<String>("against").cloned(),
        strands: arguments.get_many::<u32>("plies").into_iter().flatten().copied().collect(),
        balances: Balance::BOTH.into_iter().filter(|balance| both(&balances, balance.name())).collect(),
        hands: [(Handedness::Right, ["right", "Z"]), (Handedness::Left, ["left", "S"])]
            .into_iter()
            .filter(|(_, names)| names.iter().any(|name| both(&hands, name)))
            .map(|(hand, _)| hand)
            .collect(),
        touching: arguments.get_flag("touching"),
        scales: Scales { log_x: arguments.get_flag("log-x"), log_y: arguments.get_flag("log-y") },
    };
    let graph = input.spec.check_graph(&flags).map_err(|error| input.refused(error))?;
    let curves = graph.curves();
    let output = arguments.get_one::<String>("output");
    if let Some(path) = output {
        if Path::new(path).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv")) {
            let mut draft = Draft::new(path)?;
            draft.write(graph.csv(&curves).as_bytes())?;
            draft.keep()?;
        } else {
            let theme = if arguments.get_flag("dark") { Theme::Dark } else { Theme::Light };
            output::picture(path, &graph.picture(&curves).svg_in(theme), arguments)?;
        }
    }
    if output.is_none() || arguments.get_flag("term") {
        let (width, height) = output::terminal();
        let charts = graph.charts(&curves);
        let each = (height / charts.len().max(1)).max(12);
        let text: Vec<String> = charts.iter().map(|chart| chart.text(width, each)).collect();
        return output::write(&text.join("\n"));
    }
    Ok(())
}
