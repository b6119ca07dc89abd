//! Formulas in use beside the exact geometry: tables and pictures of the book's chapter "Beside other ways to compute it", as Markdown.
//!
//! ```text
//! cargo run -p nply-sheet --example compare -- layers
//! ```
#![allow(clippy::disallowed_methods, reason = "tables of a few digits")]

mod barrels;
mod elements;
mod layers;
mod page;
mod rods;
mod spinners;
mod strings;
mod wires;

use std::error::Error;
use std::io::Write as _;
use std::process::ExitCode;

fn main() -> ExitCode {
    let wish = std::env::args().nth(1).unwrap_or_default();
    let page: Result<String, Box<dyn Error>> = match wish.as_str() {
        "layers" => layers::page(),
        "wires" => wires::page(),
        "elements" => elements::page(),
        "rods" => rods::page(),
        "barrels" => barrels::page(),
        "strings" => strings::page(),
        "spinners" => spinners::page(),
        _ => Err("wanted is one of layers, wires, elements, rods, barrels, strings, spinners".into()),
    };
    match page {
        Ok(page) => {
            // a closed pipe is no error
            let _ = std::io::stdout().write_all(page.as_bytes());
            ExitCode::SUCCESS
        }
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "compare: {error}");
            ExitCode::from(2)
        }
    }
}
