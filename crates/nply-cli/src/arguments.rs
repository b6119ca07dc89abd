//! Flags that several commands take, most of them made from the one list of keys.

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, Command, value_parser};
use nply_sheet::construction::CONSTRUCTION_KEYS;
use nply_sheet::{KEYS, Key, Kind, Table};

pub(crate) fn plot() -> Arg {
    Arg::new("plot").long("plot").value_name("FILE").help("Draw a picture (SVG, or PNG if the name ends in .png)")
}

pub(crate) fn count(name: &'static str, help: &'static str, most: i64) -> Arg {
    Arg::new(name).long(name).value_name("N").value_parser(value_parser!(u32).range(1..=most)).help(help)
}

/// One flag with a prefix for each key that can change within a study.
pub(crate) fn corners(command: Command, prefix: &str, heading: &'static str) -> Command {
    KEYS.iter().filter(|key| key.may_change()).fold(command, |command, key| {
        let name = format!("{prefix}{}", key.flag);
        let flag = Arg::new(name.clone()).long(name).help(key.help).help_heading(heading).hide_short_help(true);
        command.arg(flag.allow_hyphen_values(true).value_name(value_name(key.kind)))
    })
}

pub(crate) fn format() -> Arg {
    Arg::new("format")
        .long("format")
        .value_name("FORMAT")
        .value_parser(PossibleValuesParser::new(["table", "json", "csv"]))
        .default_value("table")
        .help("How to write the answer")
}

pub(crate) fn json() -> Arg {
    Arg::new("json").long("json").action(ArgAction::SetTrue).help("Write JSON (the same as --format json)")
}

/// FILE and one flag a key.
pub(crate) fn with_keys(command: Command, wanted: impl Fn(&Key) -> bool) -> Command {
    let file = Arg::new("file").value_name("FILE").help("A TOML file with the ply; `-` reads standard input");
    KEYS.iter().filter(|key| wanted(key)).fold(command.arg(file), |command, key| {
        let flag = Arg::new(key.flag).long(key.flag).help(key.help).help_heading(heading(key.table));
        command.arg(match key.kind {
            Kind::Switch => flag.num_args(0..=1).default_missing_value("true").value_name("true|false"),
            _ => flag.allow_hyphen_values(true).value_name(value_name(key.kind)),
        })
    })
}

/// The same where strands do not stretch: what only those that do have is refused, and the help says where it is taken.
pub(crate) fn without_stretch(command: Command) -> Command {
    ["stretch", "axial-stiffness", "thinning-ratio"].into_iter().fold(command, |command, name| {
        command.mut_arg(name, |flag| {
            flag.help("Not taken here: strands that stretch are asked of `nply support` and `nply trace`")
        })
    })
}

/// FILE and one flag a key of a layered strand; those of a layer may be repeated.
pub(crate) fn with_construction_keys(command: Command, wanted: impl Fn(&Key) -> bool) -> Command {
    let file = Arg::new("file").value_name("FILE").help("A TOML file with the strand; `-` reads standard input");
    CONSTRUCTION_KEYS.iter().filter(|key| wanted(key)).fold(command.arg(file), |command, key| {
        let flag = Arg::new(key.flag).long(key.flag).help(key.help).help_heading(heading(key.table));
        let flag = if key.table == Table::Layer { flag.action(ArgAction::Append) } else { flag };
        // a layer's key is `wires` in a file
        let flag = if key.name == "wires" { flag.visible_alias(key.name) } else { flag };
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
        Table::Formed => "Lay in which a ply of strands that stretch was made",
        Table::Load => "Load",
        Table::Ends => "Ends that are held (one; of strands that stretch, rotation and length)",
        Table::Support => "A core the strands may lie on",
        Table::Construction => "Strand",
        Table::Core => "Core",
        Table::Layer => "Layer (repeat a flag once for each layer, from the inside; a flag given once holds for all)",
    }
}

pub(crate) const fn value_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Count => "N",
        Kind::Balance => "contact|radial",
        Kind::Hand => "right|left|Z|S",
        Kind::Text => "TEXT",
        Kind::Length => "LENGTH",
        Kind::Stiffness => "STIFFNESS",
        Kind::Pressure | Kind::Modulus => "PRESSURE",
        Kind::LinearDensity => "LINEAR DENSITY",
        Kind::Density => "DENSITY",
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
