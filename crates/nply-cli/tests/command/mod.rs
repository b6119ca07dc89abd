//! The command `nply` as a script calls it.
#![allow(dead_code, reason = "each test file uses its share")]

use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

use serde_json::Value;

/// What a call came to.
pub(crate) struct Answer {
    pub(crate) code: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

/// The command, called in the project's root, with no say of this terminal in its colours.
pub(crate) fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_nply"));
    command.args(arguments).current_dir(root());
    for name in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE", "TERM", "COLUMNS"] {
        command.env_remove(name);
    }
    command
}

pub(crate) fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

pub(crate) fn call(arguments: &[&str]) -> Answer {
    answer(&command(arguments).output().expect("the command starts"))
}

/// A call with a text on its standard input.
pub(crate) fn call_with(arguments: &[&str], input: &[u8]) -> Answer {
    let mut child = command(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    // a command that does not want it all closes the pipe
    let _ = child.stdin.take().expect("a pipe").write_all(input);
    answer(&child.wait_with_output().expect("the command ends"))
}

pub(crate) fn answer(output: &Output) -> Answer {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("UTF-8");
    let err = text(&output.stderr);
    assert!(!err.contains("panicked"), "{err}");
    Answer { code: output.status.code().expect("an exit status"), out: text(&output.stdout), err }
}

/// What a call that succeeds writes.
pub(crate) fn out(arguments: &[&str]) -> String {
    let Answer { code, out, err } = call(arguments);
    assert_eq!((code, err.as_str()), (0, ""), "{arguments:?}");
    out
}

/// What a call that succeeds writes, read as JSON.
pub(crate) fn json(arguments: &[&str]) -> Value {
    let text = out(arguments);
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// A number of an object.
pub(crate) fn number(object: &Value, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("{key} is no number: {}", object[key]))
}

pub(crate) fn states(report: &Value) -> &[Value] {
    report["states"].as_array().expect("an array")
}

/// Equal to `tolerance` of the expected value.
#[track_caller]
pub(crate) fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found:e} is not {expected:e}");
}
