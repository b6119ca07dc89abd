//! `cargo xtask test`: the cheap checks first, then the tests, then the command as a reader will call it.

use crate::book;
use crate::python;
use crate::step::{Outcome, answers, built, cargo, run as step, run_and_hear};
use crate::web;

/// The main job, as the README opens with it.
const MAIN_JOB: [&str; 5] = ["run", "--release", "--", "solve", "examples/three-ply-yarn.toml"];

pub(crate) fn run() -> Outcome {
    components()?;
    step("format", &mut cargo(["fmt", "--all", "--check"]))?;
    step("lints", &mut cargo(["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"]))?;
    // first the page, so that what is tested has it in it
    let page_stands = web::build_for_tests()?;
    // the book's programs are the examples that these tests build
    let examples = built().join("debug/examples");
    step("tests", cargo(["test", "--workspace"]).env("NPLY_EXAMPLES", &examples))?;
    step("documentation", cargo(["doc", "--workspace", "--lib", "--no-deps"]).env("RUSTDOCFLAGS", "-D warnings"))?;
    if page_stands {
        web::test()?;
    }
    step("release build", &mut cargo(["build", "--release"]))?;
    run_and_hear("main job", &mut cargo(MAIN_JOB))?;
    python::run("dev")?;
    // last, so that its programs in Python find the package; what was slow in the tests' own book is kept for it
    if page_stands {
        book::run(Some(&examples))?;
    }
    println!("\nxtask: every step passed");
    Ok(())
}

/// Formatter and linter are components that a toolchain can lack; say so before anything else is built.
fn components() -> Outcome {
    for (tool, component) in [("fmt", "rustfmt"), ("clippy", "clippy")] {
        if !answers(&mut cargo([tool, "--version"])) {
            return Err(format!("{component} is missing: add it with `rustup component add {component}`"));
        }
    }
    Ok(())
}
