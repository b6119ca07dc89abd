//! The commands of `nply`, a file each: what it takes, what it does.

mod actuator;
mod clearance;
mod completions;
mod contact;
#[cfg(feature = "explore")]
mod explore;
mod figure;
mod fit;
mod fit_check;
mod lays;
mod link;
mod locus;
mod man;
mod map;
mod mesh;
mod nodes;
mod page;
mod plot;
mod preset;
mod render;
mod schema;
mod solve;
mod spin;
mod stiffness;
mod support;
mod sweep;
mod trace;
mod writhe;

use clap::{ArgMatches, Command};

use crate::failure::Failure;
use crate::output;

/// One command.
struct Verb {
    name: &'static str,
    /// a line for the list
    about: &'static str,
    /// what `--help` says first
    long: &'static str,
    /// whether the general examples stand below
    examples: bool,
    /// adds what it takes; only called where the command is
    arguments: fn(Command) -> Command,
    run: fn(&ArgMatches) -> Result<(), Failure>,
}

/// All, in the order of the help page.
static VERBS: &[&Verb] = &[
    &solve::VERB,
    &support::VERB,
    &trace::VERB,
    &map::VERB,
    &sweep::VERB,
    &plot::VERB,
    &locus::VERB,
    &contact::VERB,
    &lays::VERB,
    &spin::VERB,
    &actuator::VERB,
    &fit::VERB,
    &preset::VERB,
    &fit_check::VERB,
    &stiffness::VERB,
    &writhe::VERB,
    &link::VERB,
    &clearance::VERB,
    &mesh::VERB,
    &nodes::VERB,
    &render::VERB,
    &figure::VERB,
    #[cfg(feature = "explore")]
    &explore::VERB,
    &schema::VERB,
    &completions::VERB,
    &man::VERB,
];

const EXAMPLES: &str = "\
Examples:
  nply solve examples/three-ply-yarn.toml
  nply solve rope.toml --force \"1.2 kN\" --json
  nply solve --strands 3 --stiffness-ratio 0.75 --pretwist -1
  nply support rope.toml --support-core-diameter \"4 mm\" --ply-length \"0.9 m\" --strand-length \"1 m\"
  nply contact --strands 6 --diameter \"2 mm\" --lay-length \"40 mm\"
  nply fit-check examples/strand-7-wire.toml
  nply trace examples/birdcage.toml --to-force \"-20 kN\" --plot path.svg
  nply map rope.toml --to-force \"2 kN\" --to-moment \"3 N m\" --output map.parquet --plot map.svg
  nply sweep examples/studies/yarn-twist.toml --output yarn.parquet
  nply mesh examples/three-ply-yarn.toml --stripes 2 --output yarn.glb
  nply clearance wires.csv --diameter \"2 mm\" --unit mm
  nply writhe knot.vtp --json
  nply explore examples/three-ply-yarn.toml --open

Exit status: 0 an answer (no state in equilibrium is one), 1 no such ply can be, 2 the input is not understood,
3 a file cannot be read or written, 130 interrupted.";

/// What stands at the end of the examples.
fn exit_status() -> &'static str {
    EXAMPLES.split("Exit status: ").nth(1).unwrap_or_default()
}

/// `nply` with its commands. What a command takes is only made when it is called.
pub(crate) fn command() -> Command {
    let nply = Command::new("nply")
        .version(env!("CARGO_PKG_VERSION"))
        .about("Geometry and mechanics of ropes, yarns, cords, DNA: n elastic strands coiled round each other")
        .after_help(EXAMPLES)
        .subcommand_required(true)
        .arg_required_else_help(true);
    VERBS.iter().fold(nply, |nply, verb| {
        let command = Command::new(verb.name).about(verb.about).long_about(verb.long);
        let command = if verb.examples { command.after_help(EXAMPLES) } else { command };
        nply.subcommand(command.defer(verb.arguments))
    })
}

/// Does what was asked.
pub(crate) fn run(matches: &ArgMatches) -> Result<(), Failure> {
    let Some((name, arguments)) = matches.subcommand() else { return Ok(()) }; // one is required: not reached
    let Some(verb) = VERBS.iter().find(|verb| verb.name == name) else { return Ok(()) }; // all that are known are there
    output::spares_input(arguments)?;
    (verb.run)(arguments)
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_command_line_is_consistent() {
        super::command().debug_assert();
    }
}
