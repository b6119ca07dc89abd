//! Segments of all wires in a tree of boxes.

use crate::numerics::vector::{Vector, times};

use super::Wire;

/// More segments than this in a box are shared out between two.
const LEAF: usize = 4;

/// A node of more than one wire.
pub(super) const SEVERAL: u32 = u32::MAX;

/// One segment, in the tree's scale.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) ends: [Vector; 2],
    pub(super) wire: u32,
    /// its place in the wire
    pub(super) place: u32,
    /// arclength of the wire up to its beginning and its end
    pub(super) arc: [f64; 2],
}

/// A box with sides along the axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Box3 {
    pub(super) low: Vector,
    pub(super) high: Vector,
}

/// A box and what is in it: pieces `first..last`. The node behind it is its first child, where it has any.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) bounds: Box3,
    pub(super) first: u32,
    pub(super) last: u32,
    /// the second child; 0 for a leaf
    pub(super) second: u32,
    /// the one wire in it, or `SEVERAL`
    pub(super) wire: u32,
    /// the greatest radius of its wires
    pub(super) radius: f64,
    /// of one wire: the arclengths between which it lies
    pub(super) arc: [f64; 2],
}

#[derive(Clone, Debug)]
pub(super) struct Tree {
    pub(super) pieces: Vec<Piece>,
    pub(super) nodes: Vec<Node>,
}

impl Box3 {
    fn of(ends: &[Vector; 2]) -> Self {
        let [a, b] = ends;
        Self {
            low: [a[0].min(b[0]), a[1].min(b[1]), a[2].min(b[2])],
            high: [a[0].max(b[0]), a[1].max(b[1]), a[2].max(b[2])],
        }
    }

    fn with(&self, other: &Self) -> Self {
        let (l, h, m, k) = (self.low, self.high, other.low, other.high);
        Self {
            low: [l[0].min(m[0]), l[1].min(m[1]), l[2].min(m[2])],
            high: [h[0].max(k[0]), h[1].max(k[1]), h[2].max(k[2])],
        }
    }

    /// The distance between two boxes, not more than that of anything in them; 0 where they overlap.
    #[inline]
    pub(super) fn distance(&self, other: &Self) -> f64 {
        let gap = |axis: usize| (self.low[axis] - other.high[axis]).max(other.low[axis] - self.high[axis]).max(0.0);
        let (x, y, z) = (gap(0), gap(1), gap(2));
        // rounding up by some ulps must not cut off what lies just within
        (1.0 - 1e-14) * (x * x + y * y + z * z).sqrt()
    }
}

impl Piece {
    #[inline]
    pub(super) fn bounds(&self) -> Box3 {
        Box3::of(&self.ends)
    }
}

impl Tree {
    /// Of wires whose points are brought to about 1 by `scale`.
    pub(super) fn new(wires: &[Wire<'_>], scale: f64, radius: &[f64], arcs: &[Vec<f64>]) -> Self {
        let mut pieces = Vec::with_capacity(wires.iter().map(Wire::segments).sum());
        for (w, wire) in wires.iter().enumerate() {
            for i in 0..wire.segments() {
                let ends = wire.segment(i).map(|point| times(scale, point));
                let arc = [arcs[w][i], arcs[w][i + 1]];
                pieces.push(Piece { ends, wire: w as u32, place: i as u32, arc });
            }
        }
        let mut tree = Self { nodes: Vec::with_capacity(2 * pieces.len() / LEAF + 2), pieces };
        let all = tree.pieces.len();
        tree.node(0, all, radius);
        tree
    }

    /// Makes the node of a stretch of pieces, which it puts in order, and all below it.
    fn node(&mut self, first: usize, last: usize, radius: &[f64]) {
        let pieces = &mut self.pieces[first..last];
        let Some(start) = pieces.first() else { return };
        let (mut bounds, mut wire, mut arc) = (start.bounds(), start.wire, start.arc);
        let mut middles = Box3::of(&[middle(start); 2]);
        let mut thickest = 0.0_f64;
        for piece in pieces.iter() {
            bounds = bounds.with(&piece.bounds());
            middles = middles.with(&Box3::of(&[middle(piece); 2]));
            thickest = thickest.max(radius[piece.wire as usize]);
            arc = [arc[0].min(piece.arc[0]), arc[1].max(piece.arc[1])];
            wire = if wire == piece.wire { wire } else { SEVERAL };
        }
        let at = self.nodes.len();
        let node = Node { bounds, first: first as u32, last: last as u32, second: 0, wire, radius: thickest, arc };
        self.nodes.push(node);
        if last - first <= LEAF {
            return;
        }
        // across the longest side, half to either side
        let extent = |axis: usize| middles.high[axis] - middles.low[axis];
        let axis = (1..3).fold(0, |longest, axis| if extent(axis) > extent(longest) { axis } else { longest });
        let half = pieces.len() / 2;
        pieces.select_nth_unstable_by(half, |a, b| {
            let order = middle(a)[axis].total_cmp(&middle(b)[axis]);
            order.then(a.wire.cmp(&b.wire)).then(a.place.cmp(&b.place))
        });
        self.node(first, first + half, radius);
        self.nodes[at].second = self.nodes.len() as u32;
        self.node(first + half, last, radius);
    }
}

fn middle(piece: &Piece) -> Vector {
    let [a, b] = piece.ends;
    [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])]
}
