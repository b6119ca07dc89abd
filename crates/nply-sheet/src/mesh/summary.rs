//! What was written, in a few lines.

use core::fmt::Write as _;

use super::{Chain, FileUnit, Subject, Surface};
use crate::preferred::six_digits;

/// The ply that is shown: which state, its lay.
fn headline(ply: &Subject) -> String {
    let hand = if ply.handedness.sign() > 0.0 { "right-handed (Z)" } else { "left-handed (S)" };
    let state = ply.state.map_or_else(String::new, |(number, count)| format!(", state {number} of {count}"));
    let title: String = ply.title.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    if !ply.layers.is_empty() {
        return format!("{title}: layers as they lie, from the inside");
    }
    format!("{title}{state}: {hand}, helical angle {}°", six_digits(ply.angle.degrees()))
}

/// What is said of how near surfaces are: of a ply one row, of layers one for each.
fn nearness(ply: &Subject, unit: &FileUnit) -> Vec<(String, String)> {
    let length = |value: f64| format!("{} {}", six_digits(value * unit.per_radius), unit_name(unit));
    if ply.layers.is_empty() {
        let label = "least distance of strands' centrelines".to_owned();
        return vec![(label, length(2.0 + ply.neighbour_gap()))];
    }
    let row = |(at, layer): (usize, &super::LayerLine)| {
        let hand = if layer.handedness.sign() > 0.0 { "Z" } else { "S" };
        let rods = if layer.strands { "strands" } else { "wires" };
        let label = format!("layer {}: {} {rods}, {hand}, {}°", at + 1, layer.rods, six_digits(layer.angle.degrees()));
        let gap = if layer.is_touching() { "they touch".to_owned() } else { format!("gap {}", length(layer.gap)) };
        (label, gap)
    };
    ply.layers.iter().enumerate().map(row).collect()
}

/// Below the rows, what was taken of which nothing was said.
fn say_found_lays(out: &mut String, ply: &Subject) {
    let found = ply.found_lays();
    if !found.is_empty() {
        let _ = writeln!(out, "\n{}", found.join("\n"));
    }
}

fn unit_name(unit: &FileUnit) -> &str {
    if unit.name == "r" { "strand radii" } else { &unit.name }
}

/// What a file of a surface holds: counts, volume, deviation, the least gap, its unit.
#[must_use]
pub fn surface_summary(ply: &Subject, surface: &Surface<'_>, unit: &FileUnit) -> String {
    let mut out = format!("{}\n\n", headline(ply));
    let u = unit_name(unit);
    let [corners, triangles] = surface.counts();
    let length = |value: f64| format!("{} {u}", six_digits(value * unit.per_radius));
    let exact: f64 = surface.assembly.wires.iter().map(|wire| wire.tube.volume()).sum();
    let cubic = unit.per_radius * unit.per_radius * unit.per_radius;
    let [inside, outside] = surface.deviation();
    let [low, high] = surface.assembly.heights();
    let rows = [
        ("wires", surface.parts.len().to_string()),
        ("corners, triangles", format!("{corners}, {triangles}")),
        ("ply length", length(high - low)),
        ("outer diameter", length(2.0 * surface.assembly.reach())),
        (
            "volume (of the exact tubes)",
            format!("{} ({}) {u}³", six_digits(surface.volume() * cubic), six_digits(exact * cubic)),
        ),
        ("triangles lie inside the tubes by up to", length(-inside)),
        ("and outside by up to", length(outside)),
    ];
    let rows = rows.into_iter().map(|(label, value)| (label.to_owned(), value));
    for (label, value) in rows.chain(nearness(ply, unit)).chain([("coordinates in".to_owned(), u.to_owned())]) {
        let _ = writeln!(out, "  {label:44}{value}");
    }
    say_found_lays(&mut out, ply);
    out
}

/// What a file of centrelines holds.
#[must_use]
pub fn chain_summary(ply: &Subject, chains: &[Chain], unit: &FileUnit) -> String {
    let mut out = format!("{}\n\n", headline(ply));
    let nodes: usize = chains.iter().map(|chain| chain.points.len()).sum();
    let elements: usize = chains.iter().map(|chain| (chain.points.len() - 1) / chain.element.chords() as usize).sum();
    let u = unit_name(unit);
    let rows = [
        ("wires", chains.len().to_string()),
        ("nodes, elements", format!("{nodes}, {elements}")),
        (
            if ply.layers.is_empty() { "strand radius" } else { "radius of the outermost wires" },
            format!("{} {u}", six_digits(unit.per_radius)),
        ),
    ];
    let rows = rows.into_iter().map(|(label, value)| (label.to_owned(), value));
    for (label, value) in rows.chain(nearness(ply, unit)).chain([("coordinates in".to_owned(), u.to_owned())]) {
        let _ = writeln!(out, "  {label:44}{value}");
    }
    say_found_lays(&mut out, ply);
    out
}
