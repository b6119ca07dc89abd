//! The workshop's commands. Standard library only, so that a fresh checkout starts at once.
//!
//!     cargo xtask test          every check: format, lints, tests, documentation, the command on a real file, the page in a browser
//!     cargo xtask soak 10       the laws ten times over, on other random states each time
//!     cargo xtask kill 100      studies killed and interrupted a hundred times, and gone on with to the same bytes
//!     cargo xtask hostile       inputs of gigabytes, refused or streamed in bounded memory
//!     cargo xtask certify 1000000   the solver against roots proved by interval arithmetic, on random plies
//!     cargo xtask web           builds the page of `nply explore` into web/dist
//!     cargo xtask book          the book, into target/book/html: every command in it run, every formula set
//!     cargo xtask python        the Python package: its wheel, installed and tested
//!     cargo xtask bench         the benches
//!     cargo xtask race 5        ours and scripts in Python in turn; writes authorities/speed.md
//!     cargo xtask release       all that a release gives away, made and tried in target/release-kit; nothing is published
//!     cargo xtask figures       draws the figures of docs/figures anew
//!     cargo xtask validate      every published number beside ours, as Markdown; --json as JSON
//!     cargo xtask authorities   remakes the golden tables and compares them with those committed

mod authorities;
mod bench;
mod book;
mod certify;
mod figures;
mod hostile;
mod kill;
mod npm;
mod python;
mod race;
mod release;
mod soak;
mod step;
mod test;
mod validate;
mod venv;
mod web;

use std::process::ExitCode;

const USAGE: &str = "usage: cargo xtask <test|soak [rounds]|kill [times [seed]]|hostile|web|book|python|bench|race [rounds]|figures|validate [--json]|authorities|release|certify [plies] [seed]>";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let outcome = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["test"] => test::run(),
        ["soak"] => soak::run("10"),
        ["soak", rounds] => soak::run(rounds),
        ["kill"] => kill::run("100", "1"),
        ["kill", times] => kill::run(times, "1"),
        ["kill", times, seed] => kill::run(times, seed),
        ["hostile"] => hostile::run(),
        ["certify", ref arguments @ ..] => certify::run(arguments),
        ["web"] => web::build(),
        ["book"] => book::run(None),
        ["bench"] => bench::run(),
        ["race"] => race::run("5"),
        ["race", rounds] => race::run(rounds),
        ["figures"] => figures::run(),
        ["validate"] => validate::run(&[]),
        ["validate", "--json"] => validate::run(&["--json"]),
        ["authorities"] => authorities::run(),
        ["release"] => release::run(),
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
