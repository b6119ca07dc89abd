//! `nply actuator`: strings that a motor twists together under a load.

use clap::{Arg, ArgMatches, Command};
use nply_sheet::{Key, Kind, StringsGoal, StringsReport, Table};

use super::Verb;
use crate::arguments::{count, format, json, value_name, with_keys, without_stretch};
use crate::failure::Failure;
use crate::input;
use crate::output::{self, Format};

const LONG: &str = "\
For twisted string actuators. Strings of a given number, diameter and length (--strand-length) start parallel and touching, and a
motor twists them under a load (--force): stroke, stroke per motor turn, motor torque and tension of the strings against motor
turns, up to --motor-turns, to a wanted --stroke, to the --torque of the motor or the --tension a string bears, or to the most that go in; beside it the formula of a constant radius. Strings are limp unless their
bending and twisting stiffness are given; then their ends are clamped in the motor (--turns-per-length, 0 if absent), or swivel
(--strand-twist 0).";

const EXAMPLES: &str = "\
Examples:
  nply actuator --strands 2 --diameter \"1 mm\" --strand-length \"0.5 m\" --force \"20 N\"
  nply actuator --strands 3 --diameter \"1 mm\" --strand-length \"0.5 m\" --force \"20 N\" --motor-turns 50 --steps 25 --format csv
  nply actuator --strands 2 --diameter \"1 mm\" --strand-length \"0.5 m\" --force \"20 N\" --stroke \"50 mm\"";

/// What may be given in place of turns.
const GOALS: [(&str, &str); 3] = [
    ("stroke", "Turn until the load has come so far: \"30 mm\""),
    ("torque", "Turn until limp strings ask so much of the motor: \"5 N mm\""),
    ("tension", "Turn until each string is pulled so hard: \"12 N\""),
];

/// More are no table.
const MOST_STEPS: i64 = 100_000;

pub(super) const VERB: Verb = Verb {
    name: "actuator",
    about: "Strings twisted by a motor under a load: stroke, torque, greatest turns",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    let wanted = |key: &Key| match key.table {
        Table::Ply => ["title", "strands"].contains(&key.name),
        Table::Strand | Table::Twist => true,
        Table::Load => key.name == "force",
        Table::Ends => !key.name.starts_with("length"),
        _ => false,
    };
    without_stretch(with_keys(command, wanted))
        .arg(motor_turns())
        .args(GOALS.map(|(name, help)| {
            let others = GOALS.map(|(name, _)| name).into_iter().filter(move |other| *other != name);
            Arg::new(name)
                .allow_hyphen_values(true)
                .long(name)
                .value_name("QUANTITY")
                .conflicts_with_all(others)
                .help(help)
        }))
        .arg(count("steps", "Equal steps from no turns to the last (10)", MOST_STEPS))
        .arg(format())
        .arg(json())
        .after_help(EXAMPLES)
}

/// A flag of its own and no alias, so that what is refused is told by the name that was typed.
fn motor_turns() -> Arg {
    Arg::new("motor-turns")
        .long("motor-turns")
        .value_name(value_name(Kind::Turns))
        .allow_hyphen_values(true)
        .conflicts_with("ply-turns")
        .help("Turns of the motor, another name of --ply-turns")
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let steps = arguments.get_one::<u32>("steps").map_or(StringsReport::STEPS, |steps| *steps as usize);
    let goal = GOALS.iter().find_map(|(name, _)| Some((*name, arguments.get_one::<String>(name)?)));
    let goal = goal.map(|(name, text)| StringsGoal::read(name, text)).transpose();
    let report = goal.and_then(|goal| {
        let strings = input.spec.check_strings()?;
        match goal {
            Some(goal) => StringsReport::up_to(strings, goal, steps),
            None => StringsReport::of(strings, steps),
        }
    });
    let report = report.map_err(|error| input.refused(error))?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}
