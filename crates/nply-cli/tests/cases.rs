//! The cases that every door must answer with the same bytes: the command's answers are those on file. The package for Python and the page read
//! the same list.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use serde_json::Value;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The command line of a case.
fn words(case: &Value) -> Vec<String> {
    let mut words = vec![case["verb"].as_str().unwrap().to_owned()];
    words.extend(case["document"].as_str().map(str::to_owned));
    for (flag, value) in case["arguments"].as_object().unwrap() {
        match value {
            Value::Bool(true) => words.push(format!("--{flag}")),
            value => words.push(format!("--{flag}={}", value.as_str().unwrap())),
        }
    }
    words.push("--json".to_owned());
    words
}

#[test]
fn the_answers_are_those_on_file() {
    let folder = root().join("tests/cases");
    let list: Value = serde_json::from_str(&fs::read_to_string(folder.join("list.json")).unwrap()).unwrap();
    let cases = list["cases"].as_array().unwrap();
    assert!(cases.len() > 20);
    for case in cases {
        let words = words(case);
        let output = Command::new(env!("CARGO_BIN_EXE_nply")).args(&words).current_dir(root()).output().unwrap();
        assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
        let file = folder.join(format!("{}.json", case["name"].as_str().unwrap()));
        if std::env::var("NPLY_CASES").is_ok_and(|said| said == "write") {
            fs::write(&file, &output.stdout).unwrap();
        }
        let wanted = fs::read(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        assert!(output.stdout == wanted, "nply {} answers otherwise than {}", words.join(" "), file.display());
    }
    // and no answer is left of a case that has gone
    let answers = fs::read_dir(&folder).unwrap().filter(|entry| {
        let name = entry.as_ref().unwrap().file_name().into_string().unwrap();
        name.ends_with(".json") && name != "list.json"
    });
    assert_eq!(answers.count(), cases.len());
}
