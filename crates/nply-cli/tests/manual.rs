//! Completions and pages of the manual: made from the commands, and taken by those who read them.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use command::{call, out};

fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// What a program says, where there is such a program on this machine.
fn run(program: &str, arguments: &[&str]) -> Option<Output> {
    Command::new(program).args(arguments).output().ok()
}

/// The commands, as the help lists them.
fn commands() -> Vec<String> {
    let help = out(&["--help"]);
    let list = help.split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let first = list.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    first.filter_map(|line| line.split_whitespace().next()).map(str::to_owned).filter(|name| name != "help").collect()
}

/// What bash offers where the last of these words is being typed; the script stands in a file.
fn offered(script: &str, words: &[&str]) -> Vec<String> {
    let typed = words.iter().map(|word| format!("'{word}'")).collect::<Vec<_>>().join(" ");
    let (last, before) = (words.len() - 1, words[words.len() - 2]);
    let current = words[last];
    let call = format!("COMP_WORDS=({typed}); COMP_CWORD={last}; _nply nply '{current}' '{before}'");
    let program = format!("source '{script}'; {call}; printf '%s\\n' \"${{COMPREPLY[@]}}\"");
    let output = run("bash", &["--norc", "-c", &program]).expect("bash, which has just read the script");
    assert!(output.status.success() && output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap().lines().map(str::to_owned).collect()
}

#[test]
fn bash_completes_commands_flags_and_words() {
    let script = out(&["completions", "bash"]);
    let path = folder("completions").join("nply.bash");
    fs::write(&path, &script).unwrap();
    let Some(parsed) = run("bash", &["-n", path.to_str().unwrap()]) else { return };
    assert!(parsed.status.success(), "{}", String::from_utf8_lossy(&parsed.stderr));

    let script = path.to_str().unwrap();
    assert_eq!(offered(script, &["nply", "so"]), ["solve"]);
    assert_eq!(offered(script, &["nply", "solve", "--ply-turns-per-s"]), ["--ply-turns-per-strand-length"]);
    assert_eq!(offered(script, &["nply", "solve", "--format", ""]), ["table", "json", "csv"]);
    let all = offered(script, &["nply", ""]);
    for command in commands() {
        assert!(all.contains(&command), "{command}");
    }
}

#[test]
fn every_shell_has_a_script_of_every_command() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = out(&["completions", shell]);
        for command in commands() {
            assert!(script.contains(&command), "{shell} {command}");
        }
        assert!(script.contains("support-core-diameter"), "{shell}");
    }
    assert_eq!(call(&["completions", "tcsh"]).code, 2);
    assert_eq!(call(&["completions"]).code, 2);
}

#[test]
fn each_command_has_a_page_that_groff_takes_without_a_word() {
    let folder = folder("man");
    out(&["man", "--output", folder.to_str().unwrap()]);
    let mut pages: Vec<String> =
        fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    pages.sort();
    let mut expected: Vec<String> = commands().iter().map(|command| format!("nply-{command}.1")).collect();
    expected.push("nply.1".to_owned());
    expected.sort();
    assert_eq!(pages, expected);
    for page in pages {
        let path = folder.join(&page);
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.is_ascii(), "{page}");
        for heading in [".SH NAME", ".SH SYNOPSIS", ".SH DESCRIPTION", ".SH \"EXIT STATUS\""] {
            assert!(text.contains(heading), "{page}: {heading}");
        }
        let Some(set) = run("groff", &["-man", "-ww", "-z", path.to_str().unwrap()]) else { continue };
        assert!(set.status.success() && set.stderr.is_empty(), "{page}: {}", String::from_utf8_lossy(&set.stderr));
    }
    // the page on standard output is the main one
    assert_eq!(out(&["man"]), fs::read_to_string(folder.join("nply.1")).unwrap());
    // a folder that cannot be made is trouble with files
    let file = folder.join("nply.1").join("below");
    assert_eq!(call(&["man", "--output", file.to_str().unwrap()]).code, 3);
}

#[test]
fn the_page_of_markdown_has_every_command_and_every_flag_of_its_help() {
    let page = out(&["man", "--format", "markdown"]);
    for command in commands() {
        let own = page.split(&format!("\n## nply {command}\n")).nth(1).unwrap_or_else(|| panic!("{command}"));
        let own = own.split("\n## ").next().unwrap();
        let help = out(&[&command, "--help"]);
        let flags = help
            .lines()
            .filter_map(|line| line.trim_start().strip_prefix("--").or(line.trim_start().strip_prefix("-o, --")));
        let names: Vec<&str> = flags.filter_map(|line| line.split([' ', '[', ',']).next()).collect();
        for name in names {
            assert!(own.contains(&format!("--{name}")), "{command}: --{name}");
        }
    }
    // defaults and words that are taken stand with their flag
    assert!(
        page.contains(
            "- `--format <FORMAT>`: How to write the answer (one of `table`, `json`, `csv`; default `table`)"
        )
    );
    assert!(page.contains("| `FORCE` | a force, such as \"1.2 kN\" |"));
    assert!(page.contains("Exit status: 0 an answer"));
}
