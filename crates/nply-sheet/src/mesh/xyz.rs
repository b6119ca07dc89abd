//! Nodes line by line: XYZ, and CSV.

use core::fmt::Write as _;

use super::{Chain, FileUnit, said};

/// The number of nodes, a line of words, then an element's letter and the place of each. Strands are told apart by letters of elements:
/// C for strands, N for a core.
pub(super) fn write(title: &str, chains: &[Chain], unit: &FileUnit) -> Vec<u8> {
    let count: usize = chains.iter().map(|chain| chain.points.len()).sum();
    let mut out = format!("{count}\n{}\n", said(title, unit));
    for chain in chains {
        for point in &chain.points {
            let [x, y, z] = unit.point(*point);
            let _ = writeln!(out, "{} {x} {y} {z}", if chain.number == 0 { 'N' } else { 'C' });
        }
    }
    out.into_bytes()
}

/// Wire, node, arclength, place, tangent; the unit stands in the names.
pub(super) fn table(chains: &[Chain], unit: &FileUnit) -> Vec<u8> {
    let u = super::in_words(unit).replace("strand radii", "r");
    let mut out = format!("wire,node,arclength_{u},x_{u},y_{u},z_{u},tangent_x,tangent_y,tangent_z,radius_{u}\n");
    for chain in chains {
        let radius = chain.radius * unit.per_radius;
        for (i, (point, t)) in chain.points.iter().zip(&chain.tangents).enumerate() {
            let [x, y, z] = unit.point(*point);
            let s = chain.arclengths[i] * unit.per_radius;
            let _ = writeln!(out, "{},{i},{s},{x},{y},{z},{},{},{},{radius}", chain.name, t[0], t[1], t[2]);
        }
    }
    out.into_bytes()
}
