//! `nply completions`: what a shell needs to complete commands and flags.

use clap::{Arg, ArgMatches, Command, value_parser};
use clap_complete::Shell;

use super::Verb;
use crate::failure::Failure;
use crate::output;

const LONG: &str = "\
Prints a script by which a shell completes the commands, flags and words of `nply` at the Tab key. Where it goes depends on the shell:
the examples keep it where each looks by itself, for the user alone.";

const EXAMPLES: &str = "\
Examples:
  nply completions bash > ~/.local/share/bash-completion/completions/nply
  nply completions zsh > ~/.zfunc/_nply
  nply completions fish > ~/.config/fish/completions/nply.fish
  nply completions powershell >> $PROFILE
  nply completions elvish > ~/.config/elvish/lib/nply.elv

zsh looks into ~/.zfunc once its ~/.zshrc has `fpath+=~/.zfunc` before `compinit`; elvish takes the file with `use nply` in its rc.elv.";

pub(super) const VERB: Verb = Verb {
    name: "completions",
    about: "A script by which a shell completes commands and flags",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    let shell = Arg::new("shell").value_name("SHELL").required(true).value_parser(value_parser!(Shell));
    command.arg(shell.help("Whose script it is")).after_help(EXAMPLES)
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let Some(shell) = arguments.get_one::<Shell>("shell") else { return Ok(()) }; // required: not reached
    let mut script = Vec::new();
    clap_complete::generate(*shell, &mut super::command(), "nply", &mut script);
    output::write_bytes(&script)
}
