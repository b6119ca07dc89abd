//! Protein Data Bank files: the trace of each chain, Cα of proteins and P of nucleic acids.

use super::text::{Line, Source, Word, counted};
use super::{Draft, Found, ReadError};
use crate::quoted;

/// Numbers of residues that are missing are listed up to this many a chain.
const LISTED: usize = 3;

/// One residue's atoms, as far as they matter.
#[derive(Default)]
struct Residue {
    number: i64,
    insertion: u8,
    hetero: bool,
    alpha: Option<Atom>,
    phosphorus: Option<Atom>,
    /// N and C stand beside the Cα: an amino acid and no ion of calcium
    backbone: [bool; 2],
    /// O5′ stands beside the P: a nucleotide and no phosphate
    sugar: bool,
}

struct Atom {
    point: [f64; 3],
    occupancy: f64,
    line: usize,
    alternates: usize,
}

/// Residues of one chain up to its TER.
#[derive(Default)]
struct Chain {
    letter: String,
    residues: Vec<Residue>,
}

/// One curve a chain, of the first model.
pub(super) fn read(source: &Source<'_>) -> Result<Found, ReadError> {
    let mut chains: Vec<Chain> = Vec::new();
    let mut open: Option<usize> = None;
    let mut models = 0_usize;
    for line in source.lines() {
        let record = columns(line, 1, 6).trim_ascii_end();
        match record {
            b"MODEL" => models += 1,
            b"TER" if models < 2 => open = None,
            b"ATOM" | b"HETATM" if models < 2 => {
                let letter = word(line, 22, 22);
                // a chain goes on until its TER; what comes behind with the same letter is water, ions, or another molecule
                let at = match open.filter(|at| chains[*at].letter == letter) {
                    Some(at) => at,
                    None => {
                        let goes_on = chains.iter().rposition(|chain| chain.letter == letter);
                        match goes_on.filter(|_| record == b"HETATM") {
                            Some(at) => at,
                            None => {
                                chains.push(Chain { letter, residues: Vec::new() });
                                chains.len() - 1
                            }
                        }
                    }
                };
                // hetero atoms behind a TER belong to no trace
                let behind = open != Some(at) && record == b"HETATM" && !chains[at].residues.is_empty();
                if !behind {
                    open = Some(at);
                    chains[at].take(source, line, record == b"HETATM")?;
                }
            }
            b"END" => break,
            _ => {}
        }
    }
    let mut found = Found::default();
    if models > 1 {
        found.notes.push(format!("The first of {} is read.", counted(models, "model")));
    }
    for chain in chains {
        chain.trace(&mut found);
    }
    if found.drafts.is_empty() {
        return Err(
            source.whole("no chain has two Cα or P atoms; ATOM records in the columns of the PDB format are wanted")
        );
    }
    found.unit = Some("Å".to_owned());
    Ok(found)
}

impl Chain {
    /// Takes an atom, if it is one of those that matter.
    fn take(&mut self, source: &Source<'_>, line: Line<'_>, hetero: bool) -> Result<(), ReadError> {
        let (alpha, phosphorus) = match columns(line, 13, 16) {
            b" CA " => (true, false),
            b" P  " => (false, true),
            b" N  " | b" C  " | b" O5'" | b" O5*" => (false, false),
            _ => return Ok(()),
        };
        let written = word(line, 23, 26);
        let number = written.parse().map_err(|_| {
            source.at_column(line, 22, format!("{} is no residue's number (columns 23–26)", quoted(&written)))
        })?;
        let insertion = columns(line, 27, 27).first().copied().unwrap_or(b' ');
        let here = |residue: &Residue| (residue.number, residue.insertion) == (number, insertion);
        if !self.residues.last().is_some_and(here) {
            self.residues.push(Residue { number, insertion, hetero, ..Residue::default() });
        }
        let Some(residue) = self.residues.last_mut() else { return Ok(()) };
        match columns(line, 13, 16) {
            b" N  " => residue.backbone[0] = true,
            b" C  " => residue.backbone[1] = true,
            b" O5'" | b" O5*" => residue.sugar = true,
            _ => {}
        }
        if !(alpha || phosphorus) {
            return Ok(());
        }
        let mut point = [0.0; 3];
        for (value, (name, first)) in point.iter_mut().zip([("x", 31), ("y", 39), ("z", 47)]) {
            let text = word(line, first, first + 7);
            let wanted = format!("{name} (columns {first}–{})", first + 7);
            *value = source.number(line, Word { text: &text, at: first - 1 }, &wanted)?;
        }
        // where nothing is written an atom is there as a whole
        let occupancy = word(line, 55, 60);
        let occupancy = if occupancy.is_empty() {
            1.0
        } else {
            source.number(line, Word { text: &occupancy, at: 54 }, "the occupancy (columns 55–60)")?
        };
        let slot = if alpha { &mut residue.alpha } else { &mut residue.phosphorus };
        match slot {
            Some(atom) => {
                atom.alternates += 1;
                if occupancy > atom.occupancy {
                    (atom.point, atom.occupancy) = (point, occupancy);
                }
            }
            None => *slot = Some(Atom { point, occupancy, line: line.number, alternates: 0 }),
        }
        Ok(())
    }

    /// The chain's curve, and what is to be said of it.
    fn trace(mut self, found: &mut Found) {
        // hetero groups count where they are links of a chain: by their atoms, or between others, as selenomethionines in a file of Cα alone
        let links = |residue: &Residue| !residue.hetero;
        let inside = self.residues.iter().position(links).zip(self.residues.iter().rposition(links));
        let mut at = 0..;
        self.residues.retain(|residue| {
            let at = at.next();
            let between = inside.zip(at).is_some_and(|((first, last), at)| first < at && at < last);
            !residue.hetero || residue.backbone == [true; 2] || residue.sugar || between
        });
        let protein = self.residues.iter().any(|residue| residue.alpha.is_some());
        let atoms: Vec<(&Residue, &Atom)> = self
            .residues
            .iter()
            .filter_map(|residue| {
                Some((residue, if protein { residue.alpha.as_ref() } else { residue.phosphorus.as_ref() }?))
            })
            .collect();
        if atoms.len() < 2 {
            return;
        }
        let name = if self.letter.is_empty() { "blank".to_owned() } else { self.letter.clone() };
        let mut say = |what: String| found.notes.push(format!("Chain {name}: {what}."));
        let alternates = atoms.iter().filter(|(_, atom)| atom.alternates > 0).count();
        if alternates > 0 {
            let have = if alternates == 1 { "has" } else { "have" };
            say(format!(
                "{} {have} alternate positions; that of the highest occupancy is taken, of equals the first",
                counted(alternates, "residue")
            ));
        }
        let hetero = atoms.iter().filter(|(residue, _)| residue.hetero).count();
        if hetero > 0 {
            let are = if hetero == 1 { "is" } else { "are" };
            say(format!("{} among hetero atoms (HETATM) {are} taken in", counted(hetero, "residue")));
        }
        let jumps: Vec<String> = atoms
            .windows(2)
            .filter(|pair| !(0..=1).contains(&(pair[1].0.number - pair[0].0.number)))
            .map(|pair| format!("{} to {}", pair[0].0.number, pair[1].0.number))
            .collect();
        if !jumps.is_empty() {
            let more = jumps.len().saturating_sub(LISTED);
            let more = if more > 0 { format!(" and at {} more", counted(more, "place")) } else { String::new() };
            let listed = jumps[..jumps.len().min(LISTED)].join(", ");
            say(format!("its numbers jump from {listed}{more}; a straight piece goes across"));
        }
        found.drafts.push(Draft {
            name: Some(self.letter.clone()),
            points: atoms.iter().map(|(_, atom)| atom.point).collect(),
            diameter: None,
            line: atoms.first().map(|(_, atom)| atom.line),
        });
    }
}

/// Columns of a line, counted from 1, both included; what the line does not reach is left out.
fn columns<'b>(line: Line<'b>, first: usize, last: usize) -> &'b [u8] {
    let end = last.min(line.bytes.len());
    line.bytes.get(first - 1..end).unwrap_or(b"")
}

fn word(line: Line<'_>, first: usize, last: usize) -> String {
    String::from_utf8_lossy(columns(line, first, last)).trim().to_owned()
}
