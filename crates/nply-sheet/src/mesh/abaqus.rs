//! Abaqus' input, which other finite-element programs and converters read too: nodes, and beam elements in sets.

use core::fmt::Write as _;

use super::{Chain, FileUnit, said};

/// Lines of sixteen numbers.
const PER_LINE: usize = 16;

/// Nodes and straight beams of two nodes (B31), each wire with its set of elements, its set of nodes and the radius of its round section as
/// a comment; names are in capitals as Abaqus shows them.
pub(super) fn write(title: &str, chains: &[Chain], unit: &FileUnit) -> Vec<u8> {
    let mut out = format!("*HEADING\n{}\n*NODE\n", said(title, unit));
    let mut first = Vec::new();
    let mut number = 1;
    for chain in chains {
        first.push(number);
        for point in &chain.points {
            let [x, y, z] = unit.point(*point);
            let _ = writeln!(out, "{number}, {x:?}, {y:?}, {z:?}");
            number += 1;
        }
    }
    let mut element = 1;
    for (chain, first) in chains.iter().zip(&first) {
        let set = chain.name.to_uppercase();
        let _ = writeln!(out, "** radius {:?}", chain.radius * unit.per_radius);
        let _ = writeln!(out, "*ELEMENT, TYPE=B31, ELSET={set}");
        for i in 1..chain.points.len() {
            let _ = writeln!(out, "{element}, {}, {}", first + i - 1, first + i);
            element += 1;
        }
    }
    for (chain, first) in chains.iter().zip(&first) {
        let _ = writeln!(out, "*NSET, NSET={}-NODES", chain.name.to_uppercase());
        let nodes: Vec<String> = (0..chain.points.len()).map(|i| (first + i).to_string()).collect();
        for line in nodes.chunks(PER_LINE) {
            let _ = writeln!(out, "{}", line.join(", "));
        }
    }
    // the ends, for whoever clamps and pulls
    for (name, node) in [("START", 0), ("END", usize::MAX)] {
        let _ = writeln!(out, "*NSET, NSET={name}");
        let nodes: Vec<String> = chains
            .iter()
            .zip(&first)
            .map(|(chain, first)| (first + node.min(chain.points.len() - 1)).to_string())
            .collect();
        for line in nodes.chunks(PER_LINE) {
            let _ = writeln!(out, "{}", line.join(", "));
        }
    }
    out.into_bytes()
}
