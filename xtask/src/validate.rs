//! `cargo xtask validate`: every published number beside ours, as Markdown or, with `--json`, as JSON.
//! Built as the tests are: the theory is fast there too, and nothing more has to be compiled.

use crate::step::{Outcome, cargo};

const BUILD: [&str; 8] = ["build", "--quiet", "--package", "nply-cli", "--bin", "nply", "--example", "validate"];
const RUN: [&str; 6] = ["run", "--quiet", "--package", "nply-cli", "--example", "validate"];

/// Nothing but the table goes to standard output, so that it can be kept.
pub(crate) fn run(arguments: &[&str]) -> Outcome {
    for command in [&mut cargo(BUILD), cargo(RUN).arg("--").args(arguments)] {
        let status = command.status().map_err(|error| error.to_string())?;
        if !status.success() {
            return Err(format!("the published numbers: ended with {status}"));
        }
    }
    Ok(())
}
