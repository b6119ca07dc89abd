//! Where curves are seen to cross, found by boxes round their pieces and decided exactly.

use super::CurveError;
use super::orientation::{hand, touch, turn};
use super::shadow::{PIECE, Piece, Shadow, Sight, least, most};
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
    let mut count = Count { one: curve, other: curve, view, same: true, found: Crossings::default(), blind: None };
    count.within(curve.shadow.levels() - 1, 0);
    count.result()
}

/// How often two closed curves are seen to cross each other along one direction.
pub(crate) fn mutual_crossings(points: [&[Vector]; 2], sights: [&Sight; 2]) -> Result<Crossings, Blind> {
    let [one, other] = [0, 1].map(|k| Seen { points: points[k], segments: points[k].len(), shadow: &sights[k].shadow });
    let view = sights[0].view;
    let mut count = Count { one, other, view, same: false, found: Crossings::default(), blind: None };
    count.between([one.shadow.levels() - 1, 0], [other.shadow.levels() - 1, 0]);
    count.result()
}

struct Count<'a> {
    one: Seen<'a>,
    other: Seen<'a>,
    view: View,
    same: bool,
    found: Crossings,
    /// what ended the count
    blind: Option<Blind>,
}

impl Count<'_> {
    fn result(self) -> Result<Crossings, Blind> {
        self.blind.map_or(Ok(self.found), Err)
    }

    /// One piece with itself. Like all below: whether to go on.
    fn within(&mut self, level: usize, at: usize) -> bool {
        if self.one.shadow.level(level)[at].ways != 0 {
            return true;
        }
        if level == 0 {
            return self.leaves(at, at);
        }
        let (left, right) = (2 * at, 2 * at + 1);
        self.within(level - 1, left)
            && (right >= self.one.shadow.level(level - 1).len()
                || (self.within(level - 1, right)
                    && (self.joined_one_way(level - 1, left) || self.between([level - 1, left], [level - 1, right]))))
    }

    /// Whether a piece and the next run one way.
    fn joined_one_way(&self, level: usize, at: usize) -> bool {
        let pieces = self.one.shadow.level(level);
        pieces[at].ways & pieces[at + 1].ways != 0
    }

    /// Two pieces; of one curve they are on the same level, the second behind the first.
    fn between(&mut self, one: [usize; 2], other: [usize; 2]) -> bool {
        let ([level, i], [other_level, j]) = (one, other);
        if level == 0 && other_level == 0 {
            return self.leaves(i, j);
        }
        // the larger one is opened, or both
        let open = |own: usize, than: usize, shadow: &Shadow, at: usize| {
            if own >= than && own > 0 {
                (own - 1, 2 * at, (2 * at + 2).min(shadow.level(own - 1).len()))
            } else {
                (own, at, at + 1)
            }
        };
        let (shadow, other_shadow) = (self.one.shadow, self.other.shadow);
        let (level, from, to) = open(level, other_level, shadow, i);
        let (other_level, other_from, other_to) = open(other_level, one[0], other_shadow, j);
        let (pieces, other_pieces) = (shadow.level(level), other_shadow.level(other_level));
        for (i, a) in (from..to).zip(&pieces[from..to]) {
            for (j, b) in (other_from..other_to).zip(&other_pieces[other_from..other_to]) {
                // pieces that join and run one way cannot cross
                let one_way = self.same
                    && a.ways & b.ways != 0
                    && (i + 1 == j || (i == 0 && j + 1 == pieces.len() && self.closed()));
                if !a.apart(b) && !one_way && !self.between([level, i], [other_level, j]) {
                    return false;
                }
            }
        }
        true
    }

    fn closed(&self) -> bool {
        self.one.segments == self.one.points.len()
    }

    /// The segments of two least pieces.
    fn leaves(&mut self, i: usize, j: usize) -> bool {
        let (one, other) = (self.one, self.other);
        let other_piece = &other.shadow.level(0)[j];
        // those of the first that come near the second at all, then those of the second that come near these
        let mut near = [(0, *other_piece); PIECE];
        let mut count = 0;
        self.each_box(one, i, |segment, own| {
            if !own.apart(other_piece) {
                near[count] = (segment, own);
                count += 1;
            }
        });
        if count == 0 {
            return true;
        }
        // places within the pieces, for the least room
        let mut pairs = [(0_u8, 0_u8); PIECE * PIECE];
        let mut found = 0;
        self.each_box(other, j, |second, own| {
            for &(first, segment) in &near[..count] {
                pairs[found] = ((first - i * PIECE) as u8, (second - j * PIECE) as u8);
                found += usize::from(!segment.apart(&own));
            }
        });
        pairs[..found]
            .iter()
            .map(|&(first, second)| (i * PIECE + usize::from(first), j * PIECE + usize::from(second)))
            .all(|(first, second)| (self.same && self.neighbours(first, second)) || self.pair(first, second))
    }

    /// Whether two segments of one curve share a point by right, or are counted the other way round.
    fn neighbours(&self, first: usize, second: usize) -> bool {
        second <= first + 1 || (first == 0 && second + 1 == self.one.segments && self.closed())
    }

    /// Boxes round the segments of a least piece, as far blurred as the piece.
    #[inline(always)]
    fn each_box(&self, curve: Seen<'_>, piece: usize, mut take: impl FnMut(usize, Piece)) {
        let View { u, v, .. } = self.view;
        let start = piece * PIECE;
        let segments = PIECE.min(curve.segments - start);
        let blur = curve.shadow.blur();
        let shadow = |p: Vector| [dot(u, p), dot(v, p)];
        let next = start + segments;
        let last = curve.points[if next < curve.points.len() { next } else { 0 }];
        let mut from = shadow(curve.points[start]);
        for (k, &p) in curve.points[start + 1..next].iter().chain([&last]).enumerate() {
            let to = shadow(p);
            let low = [least(from[0], to[0]) - blur, least(from[1], to[1]) - blur];
            let high = [most(from[0], to[0]) + blur, most(from[1], to[1]) + blur];
            take(start + k, Piece { low, high, ways: 0 });
            from = to;
        }
    }

    /// Two segments: whether they are seen to cross, and with which hand.
    fn pair(&mut self, first: usize, second: usize) -> bool {
        let ends = |curve: Seen<'_>, k: usize| {
            [curve.points[k], curve.points[if k + 1 < curve.points.len() { k + 1 } else { 0 }]]
        };
        let ([a, b], [p, q]) = (ends(self.one, first), ends(self.other, second));
        let d = self.view.d;
        let across = turn(a, b, p, d) * turn(a, b, q, d);
        if across > 0 {
            return true;
        }
        let along = turn(p, q, a, d) * turn(p, q, b, d);
        if along > 0 {
            return true;
        }
        if across < 0 && along < 0 {
            let hand = hand(a, b, p, q);
            if hand != 0 {
                self.found.count += 1;
                self.found.signed += i64::from(hand);
                return true;
            }
        } else if !touch([a, b], [p, q]) {
            self.blind = Some(Blind::Degenerate);
            return false;
        }
        let curves = [0, usize::from(!self.same)];
        self.blind = Some(Blind::Touch(CurveError::Touch { curves, segments: [first, second] }));
        false
    }
}
