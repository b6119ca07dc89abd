//! One step: a name, a command, a time. The first step that fails stops the run and gives its name.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

/// Why a run stopped, as a sentence.
pub(crate) type Outcome = Result<(), String>;

/// The workspace's root, whatever folder the command was called from.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(|| PathBuf::from("."), Path::to_path_buf)
}

/// Where cargo puts what it builds.
pub(crate) fn built() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), |folder| root().join(folder))
}

/// The command as a release: the one that `NPLY` names, or built for this.
pub(crate) fn command() -> Result<PathBuf, String> {
    if let Some(named) = std::env::var_os("NPLY") {
        return Ok(PathBuf::from(named));
    }
    run("release build", &mut cargo(["build", "--release", "--package", "nply-cli"]))?;
    Ok(built().join("release").join(format!("nply{}", std::env::consts::EXE_SUFFIX)))
}

/// The cargo that started this program, called in the root.
pub(crate) fn cargo<const N: usize>(arguments: [&str; N]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).current_dir(root());
    command
}

/// Runs a command, its output passed through.
pub(crate) fn run(name: &str, command: &mut Command) -> Outcome {
    timed(name, || {
        let status = command.status().map_err(|error| cannot_start(command, &error))?;
        if status.success() { Ok(()) } else { Err(format!("ended with {status}")) }
    })
}

/// Runs a command that must succeed and say something on its standard output, which is passed through.
pub(crate) fn run_and_hear(name: &str, command: &mut Command) -> Outcome {
    timed(name, || {
        let output = command.stderr(Stdio::inherit()).output().map_err(|error| cannot_start(command, &error))?;
        std::io::stdout().write_all(&output.stdout).map_err(|error| error.to_string())?;
        if !output.status.success() {
            return Err(format!("ended with {}", output.status));
        }
        if output.stdout.trim_ascii().is_empty() { Err("succeeded but printed nothing".into()) } else { Ok(()) }
    })
}

/// Whether a command can be run at all; its output is thrown away.
pub(crate) fn answers(command: &mut Command) -> bool {
    command.stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok_and(|status| status.success())
}

/// What a command says, where it succeeds.
pub(crate) fn hear(command: &mut Command) -> Option<String> {
    let output = command.stderr(Stdio::null()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).into_owned())
}

fn timed(name: &str, work: impl FnOnce() -> Outcome) -> Outcome {
    println!("\n== {name}");
    let start = Instant::now();
    let outcome = work();
    let seconds = start.elapsed().as_secs_f64();
    match outcome {
        Ok(()) => {
            println!("== {name}: ok, {seconds:.1} s");
            Ok(())
        }
        Err(reason) => Err(format!("step `{name}` failed after {seconds:.1} s: {reason}")),
    }
}

fn cannot_start(command: &Command, error: &std::io::Error) -> String {
    format!("cannot start `{}`: {error}", command.get_program().to_string_lossy())
}
