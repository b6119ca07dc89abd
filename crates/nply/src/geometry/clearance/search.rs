//! Nearest pairs of segments, and overlapping ones.

use core::f64::consts::FRAC_PI_2;
use core::ops::Range;

use super::segment::approach;
use super::tree::{Node, Piece, SEVERAL};
use super::{Approach, Clearance, Wires};
use crate::numerics::vector::{add, sub, times};

/// What is known so far bounds what is worth a look.
struct Bounds {
    nearest: f64,
    tightest: f64,
    own_nearest: f64,
    own_tightest: f64,
}

impl Bounds {
    fn of(found: &Clearance, scale: f64) -> Self {
        let distance = |known: &Option<Approach>| known.as_ref().map_or(f64::INFINITY, |known| scale * known.distance);
        // all that overlap are wanted, and the tightest in any case
        let gap = |known: &Option<Approach>| known.as_ref().map_or(f64::INFINITY, |known| (scale * known.gap).max(0.0));
        Self {
            nearest: distance(&found.nearest),
            tightest: gap(&found.tightest),
            own_nearest: distance(&found.own_nearest),
            own_tightest: gap(&found.own_tightest),
        }
    }
}

impl Wires {
    /// Searches what the given segments have near them, as far as it is not farther than what is known already.
    ///
    /// Segments are counted in an order of the index, each pair once, so that disjoint ranges that together make
    /// `0..self.segments()` find everything once their findings are [merged](Clearance::merge). `known` may be what other ranges
    /// found: it only saves work.
    #[must_use]
    pub fn search(&self, segments: Range<usize>, known: &Clearance) -> Clearance {
        let mut found = Clearance {
            nearest: known.nearest.clone(),
            tightest: known.tightest.clone(),
            own_nearest: known.own_nearest.clone(),
            own_tightest: known.own_tightest.clone(),
            ..Clearance::default()
        };
        let mut bounds = Bounds::of(&found, self.scale);
        let mut stack: Vec<(u32, f64)> = Vec::new();
        for at in segments.start..segments.end.min(self.tree.pieces.len()) {
            self.around(at, &mut found, &mut bounds, &mut stack);
        }
        found
    }

    /// What a piece has near it among the pieces behind it.
    fn around(&self, at: usize, found: &mut Clearance, bounds: &mut Bounds, stack: &mut Vec<(u32, f64)>) {
        let piece = &self.tree.pieces[at];
        let own_box = piece.bounds();
        let radius = self.radius[piece.wire as usize];
        stack.clear();
        stack.push((0, 0.0));
        while let Some((index, away)) = stack.pop() {
            let node = &self.tree.nodes[index as usize];
            if node.last as usize <= at + 1 || !self.wanted(piece, radius, node, away, bounds) {
                continue;
            }
            if node.second == 0 {
                for other in (node.first as usize).max(at + 1)..node.last as usize {
                    let other = &self.tree.pieces[other];
                    let away = own_box.distance(&other.bounds());
                    self.meet(piece, other, away, found, bounds);
                }
                continue;
            }
            let child = |index: u32| (index, own_box.distance(&self.tree.nodes[index as usize].bounds));
            let (one, other) = (child(index + 1), child(node.second));
            // the nearer one is looked at first: what it finds may spare the other
            let [near, far] = if one.1 <= other.1 { [one, other] } else { [other, one] };
            stack.push(far);
            stack.push(near);
        }
    }

    /// Whether anything in a node so far away can matter.
    fn wanted(&self, piece: &Piece, radius: f64, node: &Node, away: f64, bounds: &Bounds) -> bool {
        let others =
            node.wire != piece.wire && (away <= bounds.nearest || away - radius - node.radius <= bounds.tightest);
        others
            || (node.wire == piece.wire || node.wire == SEVERAL) && self.own_wanted(piece, radius, node, away, bounds)
    }

    fn own_wanted(&self, piece: &Piece, radius: f64, node: &Node, away: f64, bounds: &Bounds) -> bool {
        let near = away <= bounds.own_nearest || away - 2.0 * radius <= bounds.own_tightest;
        // all of it may belong to the neighbourhood along the wire
        let neighbours = node.wire == piece.wire
            && (node.arc[1] - piece.arc[0]).max(piece.arc[1] - node.arc[0]) < neighbourhood(radius);
        radius > 0.0 && near && !neighbours
    }

    /// Two pieces whose boxes are so far apart.
    fn meet(&self, one: &Piece, other: &Piece, away: f64, found: &mut Clearance, bounds: &mut Bounds) {
        let own = one.wire == other.wire;
        let touch = self.radius[one.wire as usize] + self.radius[other.wire as usize];
        let (nearest, tightest) =
            if own { (bounds.own_nearest, bounds.own_tightest) } else { (bounds.nearest, bounds.tightest) };
        if away > nearest && away - touch > tightest || own && (touch == 0.0 || self.neighbours(one, other)) {
            return;
        }
        // in the order of wires and segments, so that the answer does not depend on the tree's
        let (one, other) = if (one.wire, one.place) <= (other.wire, other.place) { (one, other) } else { (other, one) };
        let (square, fractions) = approach(one.ends, other.ends);
        let distance = square.sqrt();
        if distance > nearest && distance - touch > tightest {
            return;
        }
        let point = |piece: &Piece, fraction: f64| {
            let [a, b] = piece.ends;
            times(1.0 / self.scale, add(a, times(fraction, sub(b, a))))
        };
        let approach = Approach {
            wires: [one.wire as usize, other.wire as usize],
            segments: [one.place as usize, other.place as usize],
            fractions,
            points: [point(one, fractions[0]), point(other, fractions[1])],
            distance: distance / self.scale,
            gap: (distance - touch) / self.scale,
        };
        let overlap = distance - touch < -self.rounding;
        if own {
            found.offer_own(approach, overlap)
        } else {
            found.offer(approach, overlap)
        }
        *bounds = Bounds::of(found, self.scale);
    }

    /// Whether two pieces of a wire are neighbours along it.
    fn neighbours(&self, one: &Piece, other: &Piece) -> bool {
        let wire = one.wire as usize;
        let (first, second) = if one.place < other.place { (one, other) } else { (other, one) };
        let between = second.arc[0] - first.arc[1];
        let round = self.ring[wire].map_or(f64::INFINITY, |length| length - (second.arc[1] - first.arc[0]));
        between.min(round) < neighbourhood(self.radius[wire])
    }
}

/// A wire that is bent as sharply as it can be, with its own radius, is back at a diameter's distance after half a turn: πr.
fn neighbourhood(radius: f64) -> f64 {
    2.0 * FRAC_PI_2 * radius
}
