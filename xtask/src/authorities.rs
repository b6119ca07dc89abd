//! `cargo xtask authorities`: remakes the golden tables by their own scripts, which share nothing with the crates, and
//! compares them with those committed. Needs Python 3 with `venv`; the environment is kept in `.venv`.

use crate::step::{Outcome, root, run as step};
use crate::venv;

pub(crate) fn run() -> Outcome {
    let here = root().join("authorities");
    venv::with(&here.join("requirements.txt"))?;
    step("golden tables", venv::python().arg(here.join("make_tables.py")).arg("--check"))
}
