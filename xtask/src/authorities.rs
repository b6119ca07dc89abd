//! `cargo xtask authorities`: remakes the golden tables by their own scripts, which share nothing with the crates, and
//! compares them with those committed. Needs Python 3 with `venv`; the environment is kept in `.venv`.

use std::process::Command;

use crate::step::{Outcome, root, run as step};

pub(crate) fn run() -> Outcome {
    let venv = root().join(".venv");
    let python = venv.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if !python.exists() {
        let system = if cfg!(windows) { "python" } else { "python3" };
        step("Python environment", Command::new(system).args(["-m", "venv"]).arg(&venv))?;
    }
    let here = root().join("authorities");
    step(
        "Python packages",
        Command::new(&python).args(["-m", "pip", "install", "--quiet", "-r"]).arg(here.join("requirements.txt")),
    )?;
    step("golden tables", Command::new(&python).arg(here.join("make_tables.py")).arg("--check"))
}
