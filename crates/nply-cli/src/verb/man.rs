//! `nply man`: pages of the manual, made from what the commands say of themselves.

use std::fmt::Write as _;
use std::io;
use std::path::Path;

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgMatches, Command};
use clap_mangen::Man;
use clap_mangen::roff::{Roff, roman};

use super::{Verb, page};
use crate::failure::Failure;
use crate::output::{self, Draft};

const LONG: &str = "\
Prints the manual's page of `nply`, or with --output writes it into a folder together with a page of each command, nply-solve.1 and so
on, for `man -l`, or for `man` itself if the folder is man1 of a directory it searches. --format markdown prints all commands on one page
of Markdown instead.";

const EXAMPLES: &str = "\
Examples:
  nply man | man -l -
  nply man --output ~/.local/share/man/man1
  nply man --format markdown > commands.md";

pub(super) const VERB: Verb =
    Verb { name: "man", about: "Pages of the manual", long: LONG, examples: false, arguments, run };

fn arguments(command: Command) -> Command {
    let format = Arg::new("format").long("format").value_name("FORMAT").default_value("roff");
    let folder = Arg::new("output").long("output").short('o').value_name("FOLDER");
    command
        .arg(folder.help("Write a page for each command into this folder, which is made where it is not there"))
        .arg(
            format
                .value_parser(PossibleValuesParser::new(["roff", "markdown"]))
                .help("Pages as man reads them, or one page of Markdown with every command"),
        )
        .after_help(EXAMPLES)
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let mut nply = super::command().disable_help_subcommand(true);
    nply.build();
    let folder = arguments.get_one::<String>("output").map(Path::new);
    if arguments.get_one::<String>("format").is_some_and(|format| format == "markdown") {
        let text = page::markdown(&nply);
        return match folder {
            None => output::write(&text),
            Some(folder) => keep(folder, "commands.md", text.as_bytes()),
        };
    }
    let Some(folder) = folder else { return output::write_bytes(&roff(&nply)?) };
    keep(folder, "nply.1", &roff(&nply)?)?;
    for command in nply.get_subcommands() {
        keep(folder, &format!("nply-{}.1", command.get_name()), &roff(command)?)?;
    }
    Ok(())
}

fn keep(folder: &Path, name: &str, bytes: &[u8]) -> Result<(), Failure> {
    std::fs::create_dir_all(folder)
        .map_err(|error| Failure::File { what: format!("cannot make {}", output::shown(folder)), error })?;
    let mut draft = Draft::new(&folder.join(name).to_string_lossy())?;
    draft.write(bytes)?;
    draft.keep()
}

/// One page. Its synopsis names no flag, as there may be a hundred of them; examples stand line by line.
fn roff(command: &Command) -> Result<Vec<u8>, Failure> {
    let usage = page::usage(command);
    let man = Man::new(command.clone().override_usage(usage))
        .manual("nply")
        .source(concat!("nply ", env!("CARGO_PKG_VERSION")));
    let mut out = Vec::new();
    let all = |out: &mut Vec<u8>| -> io::Result<()> {
        man.render_title(out)?;
        man.render_name_section(out)?;
        man.render_synopsis_section(out)?;
        man.render_description_section(out)?;
        man.render_options_section(out)?;
        if command.has_subcommands() {
            man.render_subcommands_section(out)?;
        }
        for part in page::after(command) {
            section(out, part.heading, &part.text, part.is_code)?;
        }
        if command.get_name() != "nply" {
            section(out, "EXIT STATUS", super::exit_status(), false)?;
            section(out, "SEE ALSO", "nply(1)", false)?;
        }
        Ok(())
    };
    all(&mut out).map_err(|error| Failure::File { what: "cannot write the page".to_owned(), error })?;
    Ok(ascii(&String::from_utf8_lossy(&out)).into_bytes())
}

/// Letters beyond ASCII by their numbers: what reads pages is not always told their coding.
fn ascii(page: &str) -> String {
    let mut out = String::with_capacity(page.len());
    for c in page.chars() {
        if c.is_ascii() {
            out.push(c);
        } else {
            let _ = write!(out, "\\[u{:04X}]", u32::from(c));
        }
    }
    out
}

fn section(out: &mut Vec<u8>, heading: &str, text: &str, is_code: bool) -> io::Result<()> {
    let mut roff = Roff::default();
    roff.control("SH", [heading.to_uppercase().as_str()]);
    if is_code {
        roff.control("nf", []);
    }
    for line in text.lines() {
        if line.is_empty() && !is_code {
            roff.control("PP", [])
        } else {
            roff.text([roman(line)])
        };
    }
    if is_code {
        roff.control("fi", []);
    }
    roff.to_writer(out)
}
