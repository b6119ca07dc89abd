//! Packages from npm: of the page, and of the book.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::step::{Outcome, answers, hear, root, run as step};

/// What this machine lacks of Node and npm.
pub(crate) fn lacks_node() -> Option<String> {
    const WANTED: [u32; 2] = [20, 19];
    let Some(said) = hear(Command::new("node").arg("--version")) else {
        return Some("Node is missing: install Node 20.19 or later, with npm".to_owned());
    };
    let version: Vec<u32> =
        said.trim().trim_start_matches('v').split('.').map_while(|part| part.parse().ok()).collect();
    if version.get(..2).is_none_or(|version| version < &WANTED[..]) {
        return Some(format!("Node {} is too old: install Node 20.19 or later", said.trim()));
    }
    (!answers(&mut npm(&root(), ["--version"]))).then(|| "npm is missing: it comes with Node".to_owned())
}

/// npm, called in a folder that has a `package.json`.
pub(crate) fn npm<const N: usize>(folder: &Path, arguments: [&str; N]) -> Command {
    let mut command = Command::new(if cfg!(windows) { "npm.cmd" } else { "npm" });
    command.args(arguments).current_dir(folder);
    command
}

/// The packages of the lock file, where other ones or none are there.
pub(crate) fn packages(folder: &Path) -> Outcome {
    let lock = read(&folder.join("package-lock.json"))?;
    let installed = folder.join("node_modules/.lock-installed");
    if fs::read(&installed).is_ok_and(|installed| installed == lock) {
        return Ok(());
    }
    step(
        &format!("packages of {}", folder.file_name().unwrap_or_default().display()),
        &mut npm(folder, ["ci", "--no-audit", "--no-fund"]),
    )?;
    write(&installed, &lock)
}

fn read(path: &Path) -> Result<Vec<u8>, String> {
    fs::read(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}

pub(crate) fn write(path: &Path, bytes: &[u8]) -> Outcome {
    fs::write(path, bytes).map_err(|error| format!("cannot write {}: {error}", path.display()))
}
