//! `cargo xtask certify [PLIES] [SEED]`: the solver against roots that interval arithmetic has proved, on random plies.

use crate::step::{Outcome, cargo, run as step};

pub(crate) fn run(arguments: &[&str]) -> Outcome {
    step("certified roots", cargo(["run", "--release", "--quiet", "--package", "xtask-certify", "--"]).args(arguments))
}
