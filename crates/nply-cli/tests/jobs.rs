//! The chapters on jobs show what the commands print.
//!
//! `UPDATE_JOBS=1 cargo test -p nply-cli --test jobs` writes the blocks anew, to be read before they are kept.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs;

use command::{call_with, out, root};

/// Words of a shell's line, with double quotes around those that have blanks.
fn words(line: &str) -> Vec<String> {
    let mut found = vec![String::new()];
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ' ' if !quoted => found.push(String::new()),
            c => found.last_mut().unwrap().push(c),
        }
    }
    found.retain(|word| !word.is_empty());
    found
}

/// What a line prints; of a pipe, what the second command does.
fn printed(line: &str) -> String {
    let mut input = String::new();
    for part in line.split(" | ") {
        let words = words(part);
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        assert_eq!(words[0], "nply", "{line}");
        let answer = call_with(&words[1..], input.as_bytes());
        assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{line}");
        input = answer.out;
    }
    input
}

#[test]
fn every_chapter_shows_what_its_commands_print() {
    let (mut chapters, mut blocks) = (0, 0);
    for entry in fs::read_dir(root().join("docs/jobs")).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        let mut fresh = String::new();
        let mut last = None;
        for (i, block) in text.split("```").enumerate() {
            if i % 2 == 0 {
                fresh += block;
                continue;
            }
            let (kind, body) = block.split_once('\n').unwrap();
            let body = match (kind, last.take()) {
                ("sh", _) => {
                    last = Some(printed(body.trim()));
                    body.to_owned()
                }
                ("text", Some(answer)) => {
                    blocks += 1;
                    answer
                }
                other => panic!("{}: {} is neither command nor answer", path.display(), other.0),
            };
            fresh += &format!("```{kind}\n{body}```");
        }
        chapters += 1;
        if std::env::var_os("UPDATE_JOBS").is_some() {
            fs::write(&path, fresh).unwrap();
        } else {
            assert!(fresh == text, "{} does not show\n{fresh}", path.display());
        }
    }
    assert!(chapters >= 7 && blocks >= 11, "{chapters} chapters, {blocks} answers");
}

/// Each example of a job is answered by the command it names, and says where its numbers are from.
#[test]
fn every_example_of_a_job_runs() {
    let mut count = 0;
    for entry in fs::read_dir(root().join("examples/jobs")).unwrap() {
        let text = fs::read_to_string(entry.unwrap().path()).unwrap();
        let comment: Vec<&str> = text.lines().map_while(|line| line.strip_prefix('#')).collect();
        assert!(comment.iter().any(|line| line.starts_with(" Source: ")), "{text}");
        let command = comment.iter().find_map(|line| line.trim().strip_prefix("nply ")).expect("its command");
        let words = words(command);
        out(&words.iter().map(String::as_str).collect::<Vec<_>>());
        count += 1;
    }
    assert_eq!(count, 3, "an example that no chapter shows");
}
