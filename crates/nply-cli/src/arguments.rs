//! The command line, made from the one list of keys.

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, Command, value_parser};
use nply_sheet::{KEYS, Key, Kind, Table};

const EXAMPLES: &str = "\
Examples:
  nply solve examples/three-ply-yarn.toml
  nply solve rope.toml --force \"1.2 kN\" --json
  nply solve --strands 3 --stiffness-ratio 0.75 --pretwist -1
  nply support rope.toml --support-core-diameter \"4 mm\" --ply-length \"0.9 m\" --strand-length \"1 m\"
  nply contact --strands 6 --diameter \"2 mm\" --lay-length \"40 mm\"
  nply trace examples/birdcage.toml --to-force \"-20 kN\" --plot path.svg
  nply map rope.toml --to-force \"2 kN\" --to-moment \"3 N m\" --output map.parquet --plot map.svg

Exit status: 0 an answer (no state in equilibrium is one), 1 no such ply can be, 2 the input is not understood,
3 a file cannot be read or written, 130 interrupted.";

const SOLVE: &str = "\
Reads a ply from FILE (TOML), from flags, or from both (flags replace what the file says), and prints every state in
which it is in equilibrium, of both hands. Give the twist of the strands and the end loads (none: the balanced ply);
or the lay and two of twist, force and moment, and the third is found; or the lay alone, and the pretwist that
balances it is found. Ends may be held instead of loaded: give the ply's rotation or length, and the load that holds it
there is found.

A quantity is a number with its unit: \"0.5 mm\", \"70 GPa\", \"50 pN nm^2\", \"200 turns/m\", \"5 turns/inch\", \"20 deg\".
Where no size is given at all, bare numbers are dimensionless: r = B = 1.";

const SUPPORT: &str = "\
Prints every state in which all closed contacts push and none pulls: strands carried by their
neighbours, by a core, by both, or free (the ply has opened), of both hands; whether each is
stable under dead loads, with ends that cannot turn, with the length held, and with the strands'
torque held; and the loads at which that changes. Give the twist of the strands, and the loads or
how the ends are held.

A core is given by --support-core-radius or --support-core-diameter (or [support] in FILE):
whether strands lie on it is found. That is not --core-radius, which belongs to the lay and says
that touching strands do lie on it.";

const TRACE: &str = "\
Follows a ply from the data of FILE (or flags) to others, leg by leg, by the smallest steps needed: through folds, over
contacts that open and close. Where it leads is said by --to-force, --to-pretwist and the like, or by [[path]] tables
in FILE, one a leg. Prints what happens on the way, each event where it happens: strands part or meet, on the core or
off it, a fold (the stable states end, and the ply jumps: where to is said), 45 degrees, no more turns, straight.

Contacts push and never pull. With --kept (always in radial balance) neighbours stay together even where they would
have to pull, as in the paper.";

const MAP: &str = "\
Finds every state over a rectangle of two data, on all cores: the number of states, angle, pressure, stable or not,
separated or not. The corners are given by --from-... and --to-... flags (the first --to-... runs across, the second up)
or by `from` and `to` in [map] of FILE. Writes a table, one row a state, to --output (CSV, or Parquet if it ends in
.parquet) or to standard output, and a picture to --plot.";

const LOCUS: &str = "\
Prints the loads at which touching strands just stop pressing on each other (p = 0), for both hands, from straight
strands to flat rings: the special points as a table, the whole curve as CSV or JSON, and a picture with --plot. Only the
twist of the strands is looked at.";

const CONTACT: &str = "\
Prints how neighbouring strands touch at a given lay: helix radius, arclength shift, contact line, hole, curvature.
With --strands 1 and no lay, the densest helix of a single tube.";

const LAYS: &str = "\
Prints the lays at which touching strands are special: zero twist (the most turns they can take), most torsion, most curvature,
close packed, the cut across the ply turning non-convex, and for two strands the lock-up of line contact. With
--strands 1, the densest helix of a single tube.";

/// `nply` with its subcommands. What a subcommand takes is only made when it is called.
pub(crate) fn command() -> Command {
    let sub =
        |name: &'static str, about: &'static str, long: &'static str| Command::new(name).about(about).long_about(long);
    Command::new("nply")
        .version(env!("CARGO_PKG_VERSION"))
        .about("Geometry and mechanics of ropes, yarns, cords, DNA: n elastic strands coiled round each other")
        .after_help(EXAMPLES)
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(sub("solve", "Every equilibrium state of one ply", SOLVE).after_help(EXAMPLES).defer(solve))
        .subcommand(
            sub("support", "What carries the strands: neighbours, a core, both, or nothing", SUPPORT)
                .after_help(EXAMPLES)
                .defer(support),
        )
        .subcommand(sub("trace", "Follow a ply along a path", TRACE).after_help(EXAMPLES).defer(trace))
        .subcommand(sub("map", "Every state over two data", MAP).after_help(EXAMPLES).defer(map))
        .subcommand(sub("locus", "The loads at which touching strands part", LOCUS).after_help(EXAMPLES).defer(locus))
        .subcommand(sub("contact", "Geometry alone: how strands touch at a lay", CONTACT).defer(contact))
        .subcommand(sub("lays", "The distinguished lays of n strands", LAYS).defer(lays))
}

fn solve(command: Command) -> Command {
    with_keys(command, |_| true).arg(format()).arg(json())
}

fn support(command: Command) -> Command {
    with_keys(command, |key| key.table != Table::Lay).arg(format()).arg(json())
}

fn trace(command: Command) -> Command {
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
        .arg(plot())
        .arg(format())
        .arg(json())
}

fn map(command: Command) -> Command {
    const THREADS: i64 = 1024;
    let command = with_keys(command, |key| key.table != Table::Lay && key.name != "separation");
    let command = corners(command, "from-", "Where the rectangle begins");
    corners(command, "to-", "Where it ends: the first of these runs across, the second up")
        .arg(count("columns", "Points across (200)", u32::MAX.into()))
        .arg(count("rows", "Points up (200)", u32::MAX.into()))
        .arg(
            Arg::new("output")
                .long("output")
                .short('o')
                .value_name("FILE")
                .help("Where to write the table: CSV, or Parquet if the name ends in .parquet"),
        )
        .arg(plot())
        .arg(count("jobs", "Threads to use (all cores)", THREADS))
        .arg(Arg::new("quiet").long("quiet").short('q').action(ArgAction::SetTrue).help("No progress bar"))
}

fn locus(command: Command) -> Command {
    let wanted =
        |key: &Key| !matches!(key.table, Table::Lay | Table::Ends | Table::Support) && key.name != "separation";
    with_keys(command, wanted)
        .arg(count("points", "Angles on each curve (200)", u32::MAX.into()))
        .arg(plot())
        .arg(format())
        .arg(json())
}

fn contact(command: Command) -> Command {
    let wanted = |key: &Key| key.table == Table::Lay || ["strands", "hand", "radius", "diameter"].contains(&key.name);
    with_keys(command, wanted)
        .arg(
            Arg::new("branches")
                .long("branches")
                .value_name("MOST")
                .num_args(0..=1)
                .default_missing_value("20")
                .value_parser(value_parser!(u32).range(1..=100_000))
                .help("List solutions of the contact condition too, nearest first, at most MOST (20)"),
        )
        .arg(json())
}

fn lays(command: Command) -> Command {
    with_keys(command, |key| key.name == "strands").arg(json())
}

fn plot() -> Arg {
    Arg::new("plot").long("plot").value_name("FILE").help("Draw a picture (SVG)")
}

fn count(name: &'static str, help: &'static str, most: i64) -> Arg {
    Arg::new(name).long(name).value_name("N").value_parser(value_parser!(u32).range(1..=most)).help(help)
}

/// One flag with a prefix for each key that can change within a study.
fn corners(command: Command, prefix: &str, heading: &'static str) -> Command {
    KEYS.iter().filter(|key| key.may_change()).fold(command, |command, key| {
        let name = format!("{prefix}{}", key.flag);
        let flag = Arg::new(name.clone()).long(name).help(key.help).help_heading(heading).hide_short_help(true);
        command.arg(flag.allow_hyphen_values(true).value_name(value_name(key.kind)))
    })
}

fn format() -> Arg {
    Arg::new("format")
        .long("format")
        .value_name("FORMAT")
        .value_parser(PossibleValuesParser::new(["table", "json", "csv"]))
        .default_value("table")
        .help("How to write the answer")
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
        Table::Ends => "Ends that are held (one)",
        Table::Support => "A core the strands may lie on (one)",
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
