//! `cargo xtask soak [ROUNDS]`: the laws on other random states each round. A failure names its seed.

use std::time::{SystemTime, UNIX_EPOCH};

use crate::step::{Outcome, cargo, run as step};

const TESTS: [&str; 12] =
    ["test", "-p", "nply", "--test", "laws", "--test", "topology", "--test", "trace", "--test", "row", "--quiet"];

pub(crate) fn run(rounds: &str) -> Outcome {
    let rounds: u64 = rounds.parse().map_err(|_| format!("\"{rounds}\" is no number of rounds"))?;
    let first = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    for seed in first..first + rounds {
        step(&format!("seed {seed}"), cargo(TESTS).env("PROPTEST_RNG_SEED", seed.to_string()))?;
    }
    Ok(())
}
