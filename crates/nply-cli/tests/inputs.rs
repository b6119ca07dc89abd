//! Every filed input ends as its drawer says.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs;
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

use command::{Answer, call, command, json, out, root, states};

/// Drawer and exit status.
const DRAWERS: [(&str, i32); 5] =
    [("ok", 0), ("parse_error", 2), ("unit_error", 2), ("domain_error", 1), ("no_equilibrium", 0)];

fn files(drawer: &str) -> Vec<String> {
    let folder = root().join("tests/inputs").join(drawer);
    let mut names: Vec<String> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".toml"))
        .map(|name| format!("tests/inputs/{drawer}/{name}"))
        .collect();
    names.sort();
    assert!(names.len() >= 2, "the drawer {drawer} is almost empty");
    names
}

/// What a file asks for: a path, a map, or the states.
fn command_of(file: &str) -> &'static str {
    // the one that is not text is no study
    let text = fs::read(root().join(file)).unwrap();
    let text = String::from_utf8_lossy(&text).into_owned();
    match () {
        () if text.contains("\n[[path]]\n") => "trace",
        () if text.contains("\n[map]\n") => "map",
        () => "solve",
    }
}

/// Whether a study finds anything; one that does not says so.
fn has_states(command: &str, file: &str) -> bool {
    if command == "map" {
        let table = out(&["map", file]);
        let mut rows = table.lines().map(|row| row.split(',').collect::<Vec<_>>());
        let head = rows.next().unwrap();
        let count = head.iter().position(|name| *name == "states").unwrap();
        let (empty, found): (Vec<_>, Vec<_>) = rows.partition(|row| row[count] == "0");
        assert!(empty.iter().all(|row| row[count + 1..].iter().all(|cell| cell.is_empty())), "{file}: {table}");
        assert!(empty.len() + found.len() >= 9, "{file}: {table}");
        return !found.is_empty();
    }
    let report = json(&["trace", file, "--json"]);
    let found = !report["starts"].as_array().unwrap().is_empty();
    assert_eq!(out(&["trace", file]).contains("No state to start from: "), !found, "{file}");
    assert_eq!(report["legs"].as_array().unwrap().is_empty(), !found, "{file}");
    found
}

#[test]
fn every_input_ends_as_its_drawer_says() {
    for (drawer, status) in DRAWERS {
        for file in files(drawer) {
            let command = command_of(&file);
            let Answer { code, out, err } = call(&[command, &file]);
            assert_eq!(code, status, "{file}: {err}");
            if status == 0 {
                assert!(err.is_empty() && !out.is_empty(), "{file}: {err}");
                if command != "solve" {
                    assert_eq!(has_states(command, &file), drawer == "ok", "{file}: {out}");
                    continue;
                }
                let report = json(&["solve", &file, "--json"]);
                assert_eq!(states(&report).is_empty(), drawer == "no_equilibrium", "{file}: {out}");
                let says_so = |text: &str| text.contains("No state: ");
                assert_eq!(says_so(&out), states(&report).is_empty(), "{file}: {out}");
                assert_eq!(
                    report["notes"].as_array().unwrap().iter().any(|note| says_so(note.as_str().unwrap())),
                    says_so(&out)
                );
            } else {
                assert!(out.is_empty(), "{file}: {out}");
                is_one_sentence(&file, &err);
            }
        }
    }
}

/// One sentence, and the line of the file it is about.
fn is_one_sentence(file: &str, err: &str) {
    assert_eq!(err.matches("error: ").count(), 1, "{err}");
    let mut lines = err.lines();
    let sentence = lines.next().unwrap().strip_prefix("error: ").expect(err);
    assert!(sentence.len() > 20, "{err}");
    let place = lines.next().unwrap().trim_start().strip_prefix("--> ").expect(err);
    let place = place.strip_prefix(file).expect(err).strip_prefix(':').unwrap();
    let (line, column) = place.split_once(':').expect(err);
    let (line, column): (usize, usize) = (line.parse().unwrap(), column.parse().unwrap());
    let text = fs::read(root().join(file)).unwrap();
    let text = String::from_utf8_lossy(&text).into_owned();
    // an empty file has a first line too
    let named = text.lines().nth(line - 1).unwrap_or_else(|| if line == 1 { "" } else { panic!("{err}") });
    assert!((1..=named.chars().count() + 1).contains(&column), "{err}");
    // what the theory refuses is said at the datum, not at the head of the file
    if file.contains("/domain_error/") {
        assert!(line > 1 && named.contains('=') && column > named.find('=').unwrap(), "{err}");
    }
    assert!(lines.all(|rest| rest.contains('|') || rest.contains("= help: ")), "{err}");
}

/// What once kept the search for roots busy for ever; each is answered at once.
#[test]
fn nothing_is_searched_without_end() {
    let folder = root().join("fuzz/seeds/toml");
    let mut count = 0;
    for entry in fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        let mut child = command(&["solve", path.to_str().unwrap(), "--json"]).stdout(Stdio::null()).spawn().unwrap();
        let begin = Instant::now();
        while child.try_wait().unwrap().is_none() {
            if begin.elapsed() > Duration::from_secs(10) {
                child.kill().unwrap();
                child.wait().unwrap();
                panic!("{} has no end", path.display());
            }
            sleep(Duration::from_millis(5));
        }
        assert!(child.wait().unwrap().success(), "{}", path.display());
        count += 1;
    }
    assert!(count >= 6);
}
