//! The Python package as a user gets it: its wheel is built, installed into `.venv`, and tested there. Needs Python 3.10 or later with `venv`.

use std::fs;
use std::path::PathBuf;

use crate::step::{Outcome, cargo, root, run as step};
use crate::venv;

/// Where the package stands.
fn package() -> PathBuf {
    root().join("crates/nply-py")
}

/// Without a Python this is left out, and that is said; where `CI` is set it is a failure.
///
/// The wheel that is given away is built for speed; the tests' own is built as all that is tested is, in a third of the time.
pub(crate) fn run(profile: &str) -> Outcome {
    if !venv::is_there() {
        let said = "python3 is missing: the Python package is neither built nor tested";
        if std::env::var_os("CI").is_some() {
            return Err(said.to_owned());
        }
        println!("\n== {said}");
        return Ok(());
    }
    wheel(profile)?;
    let cache = root().join("target/mypy");
    let types = ["-m", "mypy", "--strict", "--package", "nply"];
    step("types of the package", venv::python().args(types).current_dir(package()).env("MYPY_CACHE_DIR", &cache))?;
    step(
        "examples of the package",
        venv::python()
            .args(["-m", "pytest", "-q", "-p", "no:cacheprovider", "--doctest-modules", "--pyargs", "nply"])
            .current_dir(package()),
    )?;
    // what the package says is compared with what the command says
    step("release build", &mut cargo(["build", "--release"]))?;
    let command = root().join("target/release").join(if cfg!(windows) { "nply.exe" } else { "nply" });
    let tests = ["-m", "pytest", "tests"];
    step(
        "tests of the package",
        venv::python().args(tests).current_dir(package()).env("NPLY_COMMAND", command).env("MYPY_CACHE_DIR", &cache),
    )
}

/// Builds the wheel and installs it into the environment.
pub(crate) fn wheel(profile: &str) -> Outcome {
    venv::with(&package().join("requirements.txt"))?;
    // an old wheel beside the new one would leave open which is meant
    let wheels = root().join("target/wheels");
    if wheels.exists() {
        fs::remove_dir_all(&wheels).map_err(|error| format!("cannot remove {}: {error}", wheels.display()))?;
    }
    let build = ["-m", "maturin", "build", "--quiet", "--locked", "--manifest-path", "crates/nply-py/Cargo.toml"];
    step("wheel", venv::python().args(build).args(["--profile", profile]).arg("--out").arg(&wheels))?;
    let wheel = fs::read_dir(&wheels).ok().and_then(|mut found| found.next()?.ok()).map(|found| found.path());
    let wheel = wheel.ok_or_else(|| format!("no wheel stands in {}", wheels.display()))?;
    let install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps", "--force-reinstall"];
    step("wheel installed", venv::python().args(install).arg(wheel))
}
