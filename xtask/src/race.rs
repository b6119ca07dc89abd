//! `cargo xtask race`: ours and short scripts in Python in turn, on the same inputs; writes authorities/speed.json and speed.md. No test: times are
//! those of a machine and an hour.

use crate::step::{Outcome, cargo, root, run as step};
use crate::venv;

pub(crate) fn run(rounds: &str) -> Outcome {
    let here = root().join("authorities/peers");
    venv::with(&here.join("requirements.txt"))?;
    step("the command", &mut cargo(["build", "--release"]))?;
    step("our side", &mut cargo(["build", "--release", "--package", "nply", "--example", "race"]))?;
    step("race", venv::python().arg(here.join("race.py")).arg(rounds))
}
