//! Every unit that is understood, by what it measures, as a table in Markdown:
//!
//! ```text
//! cargo run -p nply-sheet --example units
//! ```
#![allow(clippy::print_stdout, reason = "the table is what it is for")]

use nply_sheet::{Dimension, KnownUnit, known_units, unit_prefixes};

/// What looks like another name or prefix before it: the sign for ångström and the Greek µ.
const TWINS: [&str; 2] = ["\u{212b}", "\u{3bc}"];

/// A unit's names; with `…` before the one that takes prefixes.
fn named(unit: &KnownUnit) -> String {
    let names = unit.names.iter().filter(|name| !TWINS.contains(name)).enumerate();
    let names =
        names.map(|(at, name)| if at == 0 && unit.takes_prefixes { format!("…`{name}`") } else { format!("`{name}`") });
    names.collect::<Vec<_>>().join(" = ")
}

fn main() {
    println!("| for | units |\n|---|---|");
    let mut said: Vec<Dimension> = Vec::new();
    for of in known_units() {
        if said.contains(&of.dimension) {
            continue;
        }
        said.push(of.dimension);
        let all = known_units().filter(|unit| unit.dimension == of.dimension);
        println!("| {} | {} |", of.dimension, all.map(|unit| named(&unit)).collect::<Vec<_>>().join("; "));
    }
    let prefixes: Vec<String> =
        unit_prefixes().filter(|prefix| !TWINS.contains(prefix)).map(|prefix| format!("`{prefix}`")).collect();
    println!("\nWith … a unit takes a prefix by its short name: {}.", prefixes.join(", "));
}
