//! What a command says of itself, as a page: its usage, what stands below its flags, and all commands in Markdown.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use clap::{Arg, Command};
use nply_sheet::KEYS;
use nply_sheet::construction::CONSTRUCTION_KEYS;

use super::{EXAMPLES, exit_status};
use crate::arguments::value_name;

/// A part of what stands below a command's flags.
pub(super) struct Part {
    pub(super) heading: &'static str,
    pub(super) text: String,
    /// whether its lines are commands
    pub(super) is_code: bool,
}

/// `nply solve [OPTIONS] [FILE]`.
pub(super) fn usage(command: &Command) -> String {
    let usage = command.clone().render_usage().to_string();
    let usage = usage.trim_start_matches("Usage:").trim();
    usage.lines().map(str::trim).collect::<Vec<_>>().join("\n")
}

/// What stands below the flags: examples, then what explains them. Of the examples that several commands share, a command has its own; the
/// main page has them all.
pub(super) fn after(command: &Command) -> Vec<Part> {
    let Some(text) = command.get_after_help().map(ToString::to_string) else { return Vec::new() };
    let shared = text == EXAMPLES;
    let own = format!("nply {} ", command.get_name());
    let (mut code, mut words, mut is_code) = (String::new(), Vec::new(), false);
    let text = text.split("\n\nExit status: ").next().unwrap_or_default();
    for paragraph in text.split("\n\n") {
        let mut prose = Vec::new();
        for line in paragraph.lines() {
            if line == "Examples:" {
                is_code = true;
            } else if is_code && line.starts_with("  ") {
                if !shared || command.get_name() == "nply" || line.trim_start().starts_with(&own) {
                    let _ = writeln!(code, "{}", line.trim_start());
                }
            } else {
                prose.push(line);
            }
        }
        is_code = false;
        if !prose.is_empty() {
            words.push(prose.join("\n"));
        }
    }
    let mut parts = Vec::new();
    if !code.is_empty() {
        parts.push(Part { heading: "Examples", text: code, is_code: true });
    }
    if !words.is_empty() {
        parts.push(Part { heading: "Notes", text: words.join("\n\n"), is_code: false });
    }
    if command.get_name() == "nply" {
        parts.push(Part { heading: "Exit status", text: exit_status().to_owned(), is_code: false });
    }
    parts
}

/// Every command on one page: usage, what it does, its flags with their defaults, examples.
pub(super) fn markdown(nply: &Command) -> String {
    let mut out = format!("{}.\n\n", nply.get_about().map(ToString::to_string).unwrap_or_default());
    let _ = writeln!(out, "```text\n{}\n```\n", usage(nply));
    out += "| command | what it does |\n|---|---|\n";
    for command in nply.get_subcommands() {
        let (name, about) = (command.get_name(), command.get_about().map(ToString::to_string).unwrap_or_default());
        let _ = writeln!(out, "| [`nply {name}`](#nply-{name}) | {} |", escaped(&about));
    }
    let _ = writeln!(out, "\nExit status: {}\n", exit_status());
    out += "What the words for values below stand for:\n\n| value | what is wanted |\n|---|---|\n";
    for (value, wanted) in values() {
        let _ = writeln!(out, "| `{}` | {} |", value.replace('|', "\\|"), escaped(wanted));
    }
    out.push('\n');
    for command in nply.get_subcommands() {
        one(&mut out, command);
    }
    out
}

/// The words for what flags take, each with what is wanted, from the lists of keys.
fn values() -> BTreeMap<&'static str, &'static str> {
    // a number is whatever has no word of its own
    let mut values: BTreeMap<_, _> =
        KEYS.iter().chain(&CONSTRUCTION_KEYS).map(|key| (value_name(key.kind), key.kind.wanted())).collect();
    values.remove("NUMBER");
    values.insert("NUMBER", nply_sheet::Kind::Number.wanted());
    values
}

fn one(out: &mut String, command: &Command) {
    let _ = writeln!(out, "## nply {}\n", command.get_name());
    let about = command.get_long_about().or_else(|| command.get_about()).map(ToString::to_string).unwrap_or_default();
    let _ = writeln!(out, "```text\n{}\n```\n\n{}\n", usage(command), escaped(&about));
    let shown = || command.get_arguments().filter(|argument| !argument.is_hide_set() && argument.get_id() != "help");
    let positional: Vec<&Arg> = shown().filter(|argument| argument.is_positional()).collect();
    list(out, "Arguments", &positional);
    let mut headings: Vec<Option<&str>> = vec![None];
    for heading in shown().filter(|argument| !argument.is_positional()).map(Arg::get_help_heading) {
        if !headings.contains(&heading) {
            headings.push(heading);
        }
    }
    for heading in headings {
        let of: Vec<&Arg> =
            shown().filter(|argument| !argument.is_positional() && argument.get_help_heading() == heading).collect();
        list(out, heading.unwrap_or("Options"), &of);
    }
    for part in after(command) {
        let _ = if part.is_code {
            writeln!(out, "**{}**\n\n```sh\n{}```\n", part.heading, part.text)
        } else {
            writeln!(out, "{}\n", escaped(&part.text))
        };
    }
}

fn list(out: &mut String, heading: &str, arguments: &[&Arg]) {
    if arguments.is_empty() {
        return;
    }
    let _ = writeln!(out, "**{heading}**\n");
    for argument in arguments {
        let help = argument.get_help().map(ToString::to_string).unwrap_or_default();
        let words: Vec<String> = argument
            .get_possible_values()
            .iter()
            .filter(|_| argument.get_action().takes_values() && !argument.is_hide_possible_values_set())
            .map(|value| format!("`{}`", value.get_name()))
            .collect();
        let defaults: Vec<String> =
            argument.get_default_values().iter().map(|value| format!("`{}`", value.to_string_lossy())).collect();
        let defaults = if argument.get_action().takes_values() { defaults } else { Vec::new() };
        let mut more = Vec::new();
        if !words.is_empty() {
            more.push(format!("one of {}", words.join(", ")));
        }
        if !defaults.is_empty() {
            more.push(format!("default {}", defaults.join(", ")));
        }
        let more = if more.is_empty() { String::new() } else { format!(" ({})", more.join("; ")) };
        let _ = writeln!(out, "- `{}`: {}{more}", written(argument), escaped(&help));
    }
    out.push('\n');
}

/// `-o, --output <FILE>`, `[FILE]`, `<DATA>`.
fn written(argument: &Arg) -> String {
    let names = argument.get_value_names().unwrap_or_default();
    let values = || names.iter().map(|name| format!("<{name}>")).collect::<Vec<_>>().join(" ");
    if argument.is_positional() {
        let several = if argument.get_num_args().is_some_and(|range| range.max_values() > 1) { "…" } else { "" };
        let name = names.first().map_or_else(|| argument.get_id().as_str().to_uppercase(), ToString::to_string);
        return if argument.is_required_set() { format!("<{name}>{several}") } else { format!("[{name}]{several}") };
    }
    let mut name = argument.get_short().map_or_else(String::new, |short| format!("-{short}, "));
    let _ = write!(name, "--{}", argument.get_long().unwrap_or_default());
    if argument.get_action().takes_values() {
        let may_be_absent = argument.get_num_args().is_some_and(|range| range.min_values() == 0);
        let _ = if may_be_absent { write!(name, " [{}]", values()) } else { write!(name, " {}", values()) };
    }
    name
}

/// Text whose brackets, underscores and asterisks are meant as they stand; what is between backticks is left alone.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for (at, piece) in text.split('`').enumerate() {
        if at > 0 {
            out.push('`');
        }
        if at % 2 == 1 {
            out += piece;
            continue;
        }
        for c in piece.chars() {
            if matches!(c, '<' | '>' | '[' | ']' | '*' | '_' | '|' | '$' | '\\') {
                out.push('\\');
            }
            out.push(c);
        }
    }
    out
}
