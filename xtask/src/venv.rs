//! The Python environment of the workshop, kept in `.venv`: standard `venv` and `pip`, nothing else.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::step::{Outcome, answers, root, run as step};

/// The Python that environments are made with.
fn system() -> &'static str {
    if cfg!(windows) { "python" } else { "python3" }
}

/// Whether there is a Python at all.
pub(crate) fn is_there() -> bool {
    answers(Command::new(system()).arg("--version"))
}

/// The environment's own folder of programs.
fn programs() -> PathBuf {
    root().join(".venv").join(if cfg!(windows) { "Scripts" } else { "bin" })
}

/// The environment's Python, for a command that is run in the root.
pub(crate) fn python() -> Command {
    let mut command = Command::new(programs().join(if cfg!(windows) { "python.exe" } else { "python" }));
    command.current_dir(root());
    command
}

/// Makes the environment where it is not there yet, and puts what a list asks for into it.
pub(crate) fn with(requirements: &Path) -> Outcome {
    if !answers(python().arg("--version")) {
        step("Python environment", Command::new(system()).args(["-m", "venv", "--clear"]).arg(root().join(".venv")))?;
    }
    let install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"];
    step("Python packages", python().args(install).arg(requirements))
}
