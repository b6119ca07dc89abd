//! Where curves are seen to cross, found by boxes round their pieces and decided exactly.

use super::CurveError;
use super::orientation::{hand, touch, turn};
use super::shadow::{PIECE, Piece, Shadow, Sight};
use super::view::View;
use crate::numerics::vector::{Vector, dot};

/// A curve with its shadow.
#[derive(Clone, Copy)]
struct Seen<'a> {
    points: &'a [Vector],
    segments: usize,
    shadow: &'a Shadow,
}

/// Crossings that were counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Crossings {
    /// all of them
    pub(crate) count: u64,
    /// right-handed ones less left-handed ones
    pub(crate) signed: i64,
}

/// Why a view tells nothing.
pub(crate) enum Blind {
    /// An end of one segment is seen on another: look along another direction.
    Degenerate,
    /// Segments touch: there is nothing to tell.
    Touch(CurveError),
}

/// How often a curve is seen to cross itself.
pub(crate) fn self_crossings(points: &[Vector], sight: &Sight) -> Result<Crossings, Blind> {
    let curve = Seen { points, segments: points.len(), shadow: &sight.shadow };
    let view = sight.view;
    let mut count = Count { one: curve, other: curve, view, same: true, found: Crossings::default() };
    count.within(curve.shadow.levels() - 1, 0)?;
    Ok(count.found)
}

/// How often two closed curves are seen to cross each other along one direction.
pub(crate) fn mutual_crossings(points: [&[Vector]; 2], sights: [&Sight; 2]) -> Result<Crossings, Blind> {
    let [one, other] = [0, 1].map(|k| Seen { points: points[k], segments: points[k].len(), shadow: &sights[k].shadow });
    let mut count = Count { one, other, view: sights[0].view, same: false, found: Crossings::default() };
    count.between([one.shadow.levels() - 1, 0], [other.shadow.levels() - 1, 0])?;
    Ok(count.found)
}

struct Count<'a> {
    one: Seen<'a>,
    other: Seen<'a>,
    view: View,
    same: bool,
    found: Crossings,
}

impl Count<'_> {
    /// One piece with itself.
    fn within(&mut self, level: usize, at: usize) -> Result<(), Blind> {
        if self.one.shadow.level(level)[at].ways != 0 {
            return Ok(());
        }
        if level == 0 {
            return self.leaves(at, at);
        }
        let (left, right) = (2 * at, 2 * at + 1);
        self.within(level - 1, left)?;
        if right < self.one.shadow.level(level - 1).len() {
            self.within(level - 1, right)?;
            self.between([level - 1, left], [level - 1, right])?;
        }
        Ok(())
    }

    /// Two pieces; of one curve they are on the same level, the second behind the first.
    fn between(&mut self, one: [usize; 2], other: [usize; 2]) -> Result<(), Blind> {
        let ([level, i], [other_level, j]) = (one, other);
        let pieces = self.one.shadow.level(level);
        let other_pieces = self.other.shadow.level(other_level);
        let (a, b) = (&pieces[i], &other_pieces[j]);
        if a.apart(b) {
            return Ok(());
        }
        // pieces that join and run one way cannot cross
        if self.same && a.ways & b.ways != 0 && (i + 1 == j || (i == 0 && j + 1 == pieces.len() && self.closed())) {
            return Ok(());
        }
        if level == 0 && other_level == 0 {
            return self.leaves(i, j);
        }
        if level == other_level {
            for i in 2 * i..(2 * i + 2).min(self.one.shadow.level(level - 1).len()) {
                for j in 2 * j..(2 * j + 2).min(self.other.shadow.level(level - 1).len()) {
                    self.between([level - 1, i], [level - 1, j])?;
                }
            }
        } else if level > other_level {
            for i in 2 * i..(2 * i + 2).min(self.one.shadow.level(level - 1).len()) {
                self.between([level - 1, i], other)?;
            }
        } else {
            for j in 2 * j..(2 * j + 2).min(self.other.shadow.level(other_level - 1).len()) {
                self.between(one, [other_level - 1, j])?;
            }
        }
        Ok(())
    }

    fn closed(&self) -> bool {
        self.one.segments == self.one.points.len()
    }

    /// The segments of two least pieces.
    fn leaves(&mut self, i: usize, j: usize) -> Result<(), Blind> {
        let (one, other) = (self.one, self.other);
        let (piece, other_piece) = (&one.shadow.level(0)[i], &other.shadow.level(0)[j]);
        let boxes = self.boxes(other, j, other_piece);
        let segments = PIECE.min(one.segments - i * PIECE);
        for (k, segment) in self.boxes(one, i, piece).iter().enumerate().take(segments) {
            if segment.apart(other_piece) {
                continue;
            }
            let first = i * PIECE + k;
            for (l, box_of) in boxes.iter().enumerate().take(PIECE.min(other.segments - j * PIECE)) {
                let second = j * PIECE + l;
                if segment.apart(box_of) || (self.same && self.neighbours(first, second)) {
                    continue;
                }
                self.pair(first, second)?;
            }
        }
        Ok(())
    }

    /// Whether two segments of one curve share a point by right, or are counted the other way round.
    fn neighbours(&self, first: usize, second: usize) -> bool {
        second <= first + 1 || (first == 0 && second + 1 == self.one.segments && self.closed())
    }

    /// Boxes round the segments of a least piece, as far blurred as the piece.
    fn boxes(&self, curve: Seen<'_>, piece: usize, of: &Piece) -> [Piece; PIECE] {
        let View { u, v, .. } = self.view;
        let shadow = |at: usize| {
            let p = curve.points[at % curve.points.len()];
            [dot(u, p), dot(v, p)]
        };
        let start = piece * PIECE;
        let blur = curve.shadow.blur();
        let mut boxes = [*of; PIECE];
        let mut from = shadow(start);
        for (k, own) in boxes.iter_mut().enumerate().take(PIECE.min(curve.segments - start)) {
            let to = shadow(start + k + 1);
            own.low = [from[0].min(to[0]) - blur, from[1].min(to[1]) - blur];
            own.high = [from[0].max(to[0]) + blur, from[1].max(to[1]) + blur];
            from = to;
        }
        boxes
    }

    /// Two segments: whether they are seen to cross, and with which hand.
    fn pair(&mut self, first: usize, second: usize) -> Result<(), Blind> {
        let ends = |curve: Seen<'_>, k: usize| {
            [curve.points[k], curve.points[if k + 1 < curve.points.len() { k + 1 } else { 0 }]]
        };
        let ([a, b], [p, q]) = (ends(self.one, first), ends(self.other, second));
        let d = self.view.d;
        let across = turn(a, b, p, d) * turn(a, b, q, d);
        if across > 0 {
            return Ok(());
        }
        let along = turn(p, q, a, d) * turn(p, q, b, d);
        if along > 0 {
            return Ok(());
        }
        if across < 0 && along < 0 {
            let hand = hand(a, b, p, q);
            if hand != 0 {
                self.found.count += 1;
                self.found.signed += i64::from(hand);
                return Ok(());
            }
        } else if !touch([a, b], [p, q]) {
            return Err(Blind::Degenerate);
        }
        let curves = [0, usize::from(!self.same)];
        Err(Blind::Touch(CurveError::Touch { curves, segments: [first, second] }))
    }
}
