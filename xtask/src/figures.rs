//! `cargo xtask figures`: the paper's figures, drawn anew into docs/figures.

use crate::step::{Outcome, cargo, run as step};

const DRAW: [&str; 9] =
    ["run", "--release", "--package", "nply-cli", "--", "figure", "all", "--svg-only", "--output=docs/figures"];

pub(crate) fn run() -> Outcome {
    step("figures", &mut cargo(DRAW))
}
