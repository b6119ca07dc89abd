//! `cargo xtask bench`: the benches, one after the other.

use crate::step::{Outcome, cargo, run as step};

pub(crate) fn run() -> Outcome {
    step("benches", &mut cargo(["bench", "--workspace"]))
}
