//! The workshop's commands. Standard library only, so that a fresh checkout starts at once.
//!
//!     cargo xtask test          every check: format, lints, tests, documentation, the command on a real file, the page in a browser
//!     cargo xtask soak 10       the laws ten times over, on other random states each time
//!     cargo xtask certify 1000000   the solver against roots proved by interval arithmetic, on random plies
//!     cargo xtask web           builds the page of `nply explore` into web/dist
//!     cargo xtask python        the Python package: its wheel, installed and tested
//!     cargo xtask bench         the benches
//!     cargo xtask figures       draws the figures of docs/figures anew
//!     cargo xtask authorities   remakes the golden tables and compares them with those committed

mod authorities;
mod bench;
mod certify;
mod figures;
mod python;
mod soak;
mod step;
mod test;
mod venv;
mod web;

use std::process::ExitCode;

const USAGE: &str =
    "usage: cargo xtask <test|soak [rounds]|certify [plies] [seed]|web|python|bench|figures|authorities>";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let outcome = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["test"] => test::run(),
        ["soak"] => soak::run("10"),
        ["soak", rounds] => soak::run(rounds),
        ["certify", ref arguments @ ..] => certify::run(arguments),
        ["web"] => web::build(),
        ["bench"] => bench::run(),
        ["figures"] => figures::run(),
        ["authorities"] => authorities::run(),
        ["python"] => python::run("wheel"),
        ["help" | "--help" | "-h"] => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("\nxtask: {failure}");
            ExitCode::FAILURE
        }
    }
}
