//! Every filed input ends as its drawer says, with the sentence kept in `messages.txt`.
//!
//! `UPDATE_MESSAGES=1 cargo test -p nply-sheet --test inputs` writes that file anew, to be read before it is kept.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use nply_sheet::{ErrorKind, Spec, SpecError, TraceReport, Walk};

fn drawer(name: &str) -> Vec<(String, String)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../tests/inputs").join(name);
    let mut files: Vec<_> = fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    files.sort();
    assert!(files.len() >= 2, "the drawer {name} is almost empty");
    let read = |path: PathBuf| {
        let file_name = format!("{name}/{}", path.file_name().unwrap().to_str().unwrap());
        (file_name, fs::read_to_string(path).unwrap())
    };
    files.into_iter().map(read).collect()
}

/// Understood as the file asks: a path is walked, a map laid out; what else is in it is understood in any case.
fn case(name: &str, text: &str) -> Result<(), SpecError> {
    assert!(text.starts_with("# "), "{name} must say in its first line what is the matter");
    let spec = Spec::from_toml(name, text)?;
    if text.contains("\n[[path]]\n") {
        return TraceReport::of(spec.check_path(None)?, Walk::default()).map(drop);
    }
    if text.contains("\n[map]\n") {
        return spec.check_map(None).map(drop);
    }
    spec.check().map(drop)
}

#[test]
fn what_is_right_is_understood() {
    for (name, text) in drawer("ok").into_iter().chain(drawer("no_equilibrium")) {
        if let Err(error) = case(&name, &text) {
            panic!("{}", error.render(&text));
        }
    }
}

#[test]
fn what_is_not_understood_ends_with_2() {
    for (name, text) in drawer("parse_error") {
        let error = case(&name, &text).expect_err(&name);
        assert_eq!(error.exit_code(), 2, "{error}");
        assert!(!matches!(error.kind(), ErrorKind::WrongUnit | ErrorKind::Domain), "{error}");
    }
    for (name, text) in drawer("unit_error") {
        let error = case(&name, &text).expect_err(&name);
        assert_eq!((error.kind(), error.exit_code()), (ErrorKind::WrongUnit, 2), "{error}");
    }
}

#[test]
fn what_no_ply_has_ends_with_1() {
    for (name, text) in drawer("domain_error") {
        match case(&name, &text) {
            Err(error) => assert_eq!((error.kind(), error.exit_code()), (ErrorKind::Domain, 1), "{error}"),
            // the theory is the one to know
            Ok(_) => assert!(text.lines().next().unwrap().ends_with("The theory refuses it."), "{name} is accepted"),
        }
    }
}

#[test]
fn each_sentence_is_kept() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/messages.txt");
    let mut said = String::new();
    for name in ["parse_error", "unit_error", "domain_error"] {
        for (name, text) in drawer(name) {
            if let Err(error) = case(&name, &text) {
                writeln!(said, "{error}").unwrap();
                assert_eq!(error.to_string().lines().count(), 1, "{error}");
                // the mark stands below the column that is named
                let shown = error.render(&text);
                let mark =
                    shown.lines().find(|line| line.contains('^') && line.trim_matches([' ', '|', '^']).is_empty());
                let mark = mark.unwrap_or_else(|| panic!("{shown}"));
                let bar = mark.find('|').unwrap();
                assert_eq!(mark.find('^').unwrap() - bar - 1, error.column().unwrap(), "{shown}");
                assert!(
                    shown.contains(&format!("--> {name}:{}:{}", error.line().unwrap(), error.column().unwrap())),
                    "{shown}"
                );
            }
        }
    }
    if std::env::var_os("UPDATE_MESSAGES").is_some() {
        fs::write(&path, &said).unwrap();
    }
    let kept = fs::read_to_string(&path).unwrap();
    for (now, before) in said.lines().zip(kept.lines()) {
        assert_eq!(now, before);
    }
    assert_eq!(said.lines().count(), kept.lines().count());
}
