//! Polylines given by the numbers of their points: VTK and OBJ.

use std::collections::HashMap;

use nply::geometry::Vector;

use super::text::counted;
use super::{Draft, Found};

/// A polyline by its points' numbers, each known to be there.
pub(super) struct Cell {
    pub(super) points: Vec<usize>,
    pub(super) name: Option<String>,
    pub(super) line: Option<usize>,
}

/// The curves of cells. Pieces of two points each that share their ends are joined, as far as no third meets them there.
pub(super) fn curves(points: &[Vector], cells: Vec<Cell>) -> Found {
    let mut found = Found::default();
    let (pieces, whole): (Vec<Cell>, Vec<Cell>) = cells.into_iter().partition(|cell| cell.points.len() == 2);
    let count = pieces.len();
    let joined = join(pieces);
    if joined.len() < count {
        found.notes.push(format!("{} of two points are joined end to end.", counted(count, "piece")));
    }
    let draft = |cell: Cell| Draft {
        points: cell.points.iter().map(|at| points[*at]).collect(),
        name: cell.name,
        line: cell.line,
        diameter: None,
    };
    found.drafts = joined.into_iter().chain(whole).map(draft).collect();
    // in the file's order as far as lines say it
    if found.drafts.iter().all(|draft| draft.line.is_some()) {
        found.drafts.sort_by_key(|draft| draft.line);
    }
    found
}

/// Pieces joined where exactly two meet; a ring repeats its first point at the end.
pub(super) fn join(pieces: Vec<Cell>) -> Vec<Cell> {
    let mut at_point: HashMap<usize, Vec<usize>> = HashMap::new();
    for (i, piece) in pieces.iter().enumerate() {
        for point in &piece.points {
            at_point.entry(*point).or_default().push(i);
        }
    }
    let passes = |point: usize| at_point.get(&point).is_some_and(|pieces| pieces.len() == 2);
    let next = |point: usize, from: usize| at_point.get(&point)?.iter().copied().find(|piece| *piece != from);
    let mut used = vec![false; pieces.len()];
    let mut joined = Vec::new();
    let mut walk = |start: usize, first: usize, used: &mut Vec<bool>| {
        let mut points = vec![first];
        let (mut piece, mut point) = (start, first);
        loop {
            used[piece] = true;
            let ends = &pieces[piece].points;
            point = if ends[0] == point { ends[1] } else { ends[0] };
            points.push(point);
            match next(point, piece) {
                Some(other) if passes(point) && !used[other] => piece = other,
                _ => break,
            }
        }
        let cell = &pieces[start];
        joined.push(Cell { points, name: cell.name.clone(), line: cell.line });
    };
    // chains first, from the end at which they begin; what remains are rings
    for i in 0..pieces.len() {
        let ends = [pieces[i].points[0], pieces[i].points[1]];
        if !used[i] && !passes(ends[0]) {
            walk(i, ends[0], &mut used);
        }
    }
    for i in 0..pieces.len() {
        let ends = [pieces[i].points[0], pieces[i].points[1]];
        if !used[i] && !passes(ends[1]) {
            walk(i, ends[1], &mut used);
        }
    }
    for i in 0..pieces.len() {
        if !used[i] {
            walk(i, pieces[i].points[0], &mut used);
        }
    }
    joined
}
