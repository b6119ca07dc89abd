//! The command line, made from the one list of keys.

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, Command, value_parser};
use nply_sheet::{KEYS, Key, Kind, Table};

const EXAMPLES: &str = "\
Examples:
  nply solve examples/three-ply-yarn.toml
  nply solve rope.toml --force \"1.2 kN\" --json
  nply solve --strands 3 --stiffness-ratio 0.75 --pretwist -1
  nply contact --strands 6 --diameter \"2 mm\" --lay-length \"40 mm\"

Exit status: 0 an answer (no state in equilibrium is one), 1 no such ply can be, 2 the input is not understood,
3 a file cannot be read or written.";

const SOLVE: &str = "\
Reads a ply from FILE (TOML), from flags, or from both (flags replace what the file says), and prints every state in
which it is in equilibrium, of both hands. Give the twist of the strands and the end loads (none: the balanced ply);
or the lay and two of twist, force and moment, and the third is found; or the lay alone, and the pretwist that
balances it is found.

A quantity is a number with its unit: \"0.5 mm\", \"70 GPa\", \"50 pN nm^2\", \"200 turns/m\", \"5 turns/inch\", \"20 deg\".
Where no size is given at all, bare numbers are dimensionless: r = B = 1.";

const CONTACT: &str = "\
Prints how neighbouring strands touch at a given lay: helix radius, arclength shift, contact line, hole, curvature.
With --strands 1 and no lay, the densest helix of a single tube.";

const LAYS: &str = "\
Prints the lays at which touching strands are special: zero twist (the most turns they can take), most torsion, most curvature,
close packed, the cut across the ply turning non-convex, and for two strands the lock-up of line contact. With
--strands 1, the densest helix of a single tube.";

/// `nply` with its subcommands.
pub(crate) fn command() -> Command {
    Command::new("nply")
        .version(env!("CARGO_PKG_VERSION"))
        .about("Geometry and mechanics of ropes, yarns, cords, DNA: n elastic strands coiled round each other")
        .after_help(EXAMPLES)
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(
            with_keys(
                Command::new("solve")
                    .about("Every equilibrium state of one ply")
                    .long_about(SOLVE)
                    .after_help(EXAMPLES),
                |_| true,
            )
            .arg(
                Arg::new("format")
                    .long("format")
                    .value_name("FORMAT")
                    .value_parser(PossibleValuesParser::new(["table", "json", "csv"]))
                    .default_value("table")
                    .help("How to write the answer"),
            )
            .arg(json()),
        )
        .subcommand(
            with_keys(
                Command::new("contact").about("Geometry alone: how strands touch at a lay").long_about(CONTACT),
                |key| key.table == Table::Lay || ["strands", "hand", "radius", "diameter"].contains(&key.name),
            )
            .arg(
                Arg::new("branches")
                    .long("branches")
                    .value_name("MOST")
                    .num_args(0..=1)
                    .default_missing_value("20")
                    .value_parser(value_parser!(u32).range(1..=100_000))
                    .help("List solutions of the contact condition too, nearest first, at most MOST (20)"),
            )
            .arg(json()),
        )
        .subcommand(
            with_keys(Command::new("lays").about("The distinguished lays of n strands").long_about(LAYS), |key| {
                key.name == "strands"
            })
            .arg(json()),
        )
}

fn json() -> Arg {
    Arg::new("json").long("json").action(ArgAction::SetTrue).help("Write JSON (the same as --format json)")
}

/// FILE and one flag a key.
fn with_keys(command: Command, wanted: impl Fn(&Key) -> bool) -> Command {
    let file = Arg::new("file").value_name("FILE").help("A TOML file with the ply; `-` reads standard input");
    KEYS.iter().filter(|key| wanted(key)).fold(command.arg(file), |command, key| {
        let flag = Arg::new(key.flag).long(key.flag).help(key.help).help_heading(heading(key.table));
        command.arg(match key.kind {
            Kind::Switch => flag.num_args(0..=1).default_missing_value("true").value_name("true|false"),
            _ => flag.allow_hyphen_values(true).value_name(value_name(key.kind)),
        })
    })
}

const fn heading(table: Table) -> &'static str {
    match table {
        Table::Ply => "Ply",
        Table::Strand => "Strand",
        Table::Twist => "Twist of the strands (one)",
        Table::Lay => "Lay, where the shape is given (one)",
        Table::Load => "Load",
    }
}

const fn value_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Count => "N",
        Kind::Balance => "contact|radial",
        Kind::Hand => "right|left|Z|S",
        Kind::Text => "TEXT",
        Kind::Length => "LENGTH",
        Kind::Stiffness => "STIFFNESS",
        Kind::Pressure => "PRESSURE",
        Kind::Temperature => "TEMPERATURE",
        Kind::Angle => "ANGLE",
        Kind::Turns => "TURNS",
        Kind::TurnsPerLength | Kind::Twist => "TURNS/LENGTH",
        Kind::Force => "FORCE",
        Kind::Moment => "MOMENT",
        Kind::ForcePerLength => "FORCE/LENGTH",
        _ => "NUMBER",
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_command_line_is_consistent() {
        super::command().debug_assert();
    }
}
