//! PDB: a trace of atoms.

use core::fmt::Write as _;

use super::subject::flag;
use super::{Chain, FileUnit, said};
use crate::{ErrorKind, SpecError};

/// The letters of chains, in turn.
const LETTERS: &[u8; 62] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";

/// An alpha carbon a node, a chain a strand, joined to the next by CONECT. Columns are fixed (format 3.3), and what has no room in them is
/// refused.
pub(super) fn write(title: &str, chains: &[Chain], unit: &FileUnit) -> Result<Vec<u8>, SpecError> {
    const MOST_ATOMS: usize = 99_999;
    const MOST_RESIDUES: usize = 9_999;
    let atoms: usize = chains.iter().map(|chain| chain.points.len()).sum();
    let longest = chains.iter().map(|chain| chain.points.len()).max().unwrap_or(0);
    let full = |what: &str| {
        let message =
            format!("a PDB file has no room for {what}: give fewer elements, a shorter length, or another format");
        Err(flag("format", ErrorKind::Domain, message))
    };
    if atoms + chains.len() > MOST_ATOMS {
        return full(&format!("{atoms} atoms (at most {MOST_ATOMS}, with the ends of chains)"));
    }
    if longest > MOST_RESIDUES {
        return full(&format!("{longest} nodes of a strand (at most {MOST_RESIDUES})"));
    }
    if chains.len() > LETTERS.len() {
        return full(&format!("{} strands (at most {})", chains.len(), LETTERS.len()));
    }
    let mut out = format!("REMARK   1 {}\n", said(title, unit));
    let mut serial = 1;
    let mut bonds = String::new();
    for (chain, letter) in chains.iter().zip(LETTERS) {
        let letter = char::from(*letter);
        for (i, point) in chain.points.iter().enumerate() {
            let [x, y, z] = unit.point(*point);
            if [x, y, z].iter().any(|x| !(-999.999..9_999.999).contains(x)) {
                let message =
                    format!(
                        "a PDB file has no room for a coordinate of {} {}: say by --unit what its 1 stands for",
                        crate::preferred::six_digits(
                            [x, y, z].into_iter().fold(0.0, |a, b| if b.abs() > f64::abs(a) { b } else { a })
                        ),
                        unit.name
                    );
                return Err(flag("unit", ErrorKind::Domain, message));
            }
            let _ = writeln!(
                out,
                "ATOM  {serial:>5}  CA  GLY {letter}{:>4}    {x:8.3}{y:8.3}{z:8.3}  1.00  0.00           C  ",
                i + 1
            );
            if i + 1 < chain.points.len() {
                let _ = writeln!(bonds, "CONECT{serial:>5}{:>5}", serial + 1);
            }
            serial += 1;
        }
        let _ = writeln!(out, "TER   {serial:>5}      GLY {letter}{:>4}", chain.points.len());
        serial += 1;
    }
    out.push_str(&bonds);
    out.push_str("END\n");
    Ok(out.into_bytes())
}
