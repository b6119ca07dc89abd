//! Which segments the writhe of a curve belongs to, by a tree of expansions with a bound.

use core::f64::consts::{PI, TAU};

use super::pair_kernel::{BLOCK, Block};
use super::{Curve, CurveError};
use crate::DomainError;
use crate::geometry::Vector;
use crate::numerics::taylor::{Monomials, Polynomial, TERMS, rest};
use crate::numerics::vector::{add, dot, norm, sub, times};

/// The writhe of a curve as a sum over its segments, each with all others: w(i) = (1/4π) Σⱼ ∬, half of what is shared by two.
///
/// The field of Biot and Savart of far pieces is expanded to degree eight, that of near ones summed pair by pair. Every expansion is taken only
/// where what it leaves out is bounded, so that the whole is within the tolerance. Memory grows with the number of segments, time a little faster.
/// The work falls into parts that a caller may share out among threads, showing how far it is.
///
/// ```
/// use nply::topology::{Curve, WritheMap};
/// let knot: Vec<_> = (0..900)
///     .map(|k| {
///         let t = f64::from(k) / 900.0 * std::f64::consts::TAU;
///         let ((s2, c2), (s3, c3)) = (libm::sincos(2.0 * t), libm::sincos(3.0 * t));
///         [(2.0 + c3) * c2, (2.0 + c3) * s2, -s3]
///     })
///     .collect();
/// let curve = Curve::closed(knot)?;
/// let map = WritheMap::new(&curve, 1e-6)?;
/// let shares: Vec<f64> = (0..map.parts()).flat_map(|part| map.part(part).shares).collect();
/// assert_eq!(shares.len(), curve.segments());
/// assert!((shares.iter().sum::<f64>() - curve.writhe()?.value).abs() < 1e-6);
/// # Ok::<(), nply::topology::CurveError>(())
/// ```
pub struct WritheMap {
    /// of size about one; of a closed curve the first once more at the end
    points: Vec<Vector>,
    closed: bool,
    /// what the expansions may leave out of the field, for each unit of length that makes it
    allowed: f64,
    monomials: Monomials,
    /// the least nodes first, then level by level, two by two, up to the whole
    nodes: Vec<Node>,
    levels: Vec<usize>,
}

/// The shares of some segments that follow each other.
#[derive(Clone, Debug, PartialEq)]
pub struct WritheShares {
    /// The first segment.
    pub first: usize,
    /// Its share, and those of the next ones.
    pub shares: Vec<f64>,
    /// What expansions and rounding can have done to all of them together.
    pub bound: f64,
}

struct Node {
    centre: Vector,
    radius: f64,
    length: f64,
    /// ∫ (r − centre)^β dr/β!, with the sign of the degree
    moments: Box<Polynomial>,
}

/// Segments of a part: two to the sixth least nodes.
const PART_LEVEL: usize = 6;

/// Gauss's five places and weights on (0, 1): exact to degree nine.
const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668_004, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_55, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

impl WritheMap {
    /// The work for a curve; the shares will add up to its writhe within `tolerance`, each within its part of that by length.
    ///
    /// # Errors
    /// [`CurveError::Domain`] unless the tolerance is above 0 and finite.
    pub fn new(curve: &Curve, tolerance: f64) -> Result<Self, CurveError> {
        DomainError::check(tolerance > 0.0 && tolerance.is_finite(), "tolerance", tolerance, "above 0 and finite")?;
        let (points, closed) = (curve.of_size_one(), curve.is_closed());
        let monomials = Monomials::new();
        let segments = points.len() - 1;
        let starts = (0..segments).step_by(BLOCK);
        let mut nodes: Vec<Node> =
            starts.map(|start| Node::of(&points[start..=(start + BLOCK).min(segments)], &monomials)).collect();
        let mut levels = vec![0, nodes.len()];
        while nodes.len() - levels[levels.len() - 2] > 1 {
            let (from, to) = (levels[levels.len() - 2], nodes.len());
            for k in (from..to).step_by(2) {
                let node = Node::join(&nodes[k..(k + 2).min(to)], &monomials);
                nodes.push(node);
            }
            levels.push(nodes.len());
        }
        let length = nodes[nodes.len() - 1].length;
        for node in &mut nodes {
            monomials.alternate(&mut node.moments);
        }
        let allowed = 4.0 * PI * tolerance / (length * length);
        Ok(Self { points, closed, allowed, monomials, nodes, levels })
    }

    /// How many parts the work falls into.
    #[must_use]
    pub fn parts(&self) -> usize {
        let level = self.part_level();
        self.levels[level + 1] - self.levels[level]
    }

    /// The shares of one part's segments; none past the last part.
    #[must_use]
    pub fn part(&self, part: usize) -> WritheShares {
        let first = part * (BLOCK << self.part_level());
        let mut shares = WritheShares { first, shares: Vec::new(), bound: 0.0 };
        if part < self.parts() {
            let top = (self.levels.len() - 2, 0);
            self.descend((self.part_level(), part), vec![top], Box::new([[0.0; 4]; TERMS]), 0.0, &mut shares);
        }
        shares
    }

    fn part_level(&self) -> usize {
        PART_LEVEL.min(self.levels.len() - 2)
    }

    fn node(&self, (level, at): (usize, usize)) -> &Node {
        &self.nodes[self.levels[level] + at]
    }

    fn children(&self, (level, at): (usize, usize)) -> impl Iterator<Item = (usize, usize)> {
        let count = self.levels[level] - self.levels[level - 1];
        (2 * at..(2 * at + 2).min(count)).map(move |child| (level - 1, child))
    }

    /// A target with the sources that are not yet in its series: each is expanded, or looked at piece by piece, or left to the target's own pieces.
    /// `left_out` bounds what the series leaves out of the field.
    fn descend(
        &self,
        target: (usize, usize),
        sources: Vec<(usize, usize)>,
        mut series: Box<Polynomial>,
        mut left_out: f64,
        shares: &mut WritheShares,
    ) {
        let node = self.node(target);
        let (mut open, mut near) = (sources, Vec::new());
        while let Some(source) = open.pop() {
            let other = self.node(source);
            let r = sub(node.centre, other.centre);
            let distance = norm(r);
            let x = (node.radius + other.radius) / distance;
            if x < 0.5 && rest(x) <= self.allowed * distance * distance {
                self.monomials.expand(&other.moments, r, &mut series);
                left_out += other.length * (rest(x) + ROUNDING) / (distance * distance);
            } else if source.0 > 0 && (other.radius >= node.radius || target.0 == 0) {
                open.extend(self.children(source));
            } else {
                near.push(source);
            }
        }
        if target.0 == 0 {
            self.sum_up(target.1, &near, &series, left_out, shares);
        } else {
            for child in self.children(target) {
                let s = sub(self.node(child).centre, node.centre);
                let series = Box::new(self.monomials.move_series(&series, s));
                self.descend(child, near.clone(), series, left_out, shares);
            }
        }
    }

    /// The shares of a least node's segments: the series' field along each, and near sources pair by pair.
    fn sum_up(
        &self,
        at: usize,
        near: &[(usize, usize)],
        series: &Polynomial,
        left_out: f64,
        shares: &mut WritheShares,
    ) {
        let segments = self.points.len() - 1;
        let start = at * BLOCK;
        let centre = self.nodes[at].centre;
        let rows = &self.points[start..=(start + BLOCK).min(segments)];
        let mut sums: Vec<f64> = rows
            .windows(2)
            .map(|ends| {
                let e = sub(ends[1], ends[0]);
                let field = GAUSS.iter().map(|&(place, weight)| {
                    let delta = sub(add(ends[0], times(place, e)), centre);
                    weight * dot(self.monomials.curl(series, delta), e)
                });
                0.5 * field.sum::<f64>()
            })
            .collect();
        shares.bound += 0.5 * self.nodes[at].length * left_out / TAU;
        for &(_, source) in near {
            let mut block = Block::new(&self.points, source * BLOCK);
            let joined = |row: usize, other: usize| {
                let apart = (start + row).abs_diff(other);
                apart <= 1 || (self.closed && apart + 1 == segments)
            };
            shares.bound += block.sum::<false>(rows, |_| 0, joined, &mut sums).bound / TAU;
        }
        shares.shares.extend(sums.iter().map(|sum| sum / TAU));
    }
}

/// What rounding can do to a series of degree eight whose terms fall at least by half, with a margin.
const ROUNDING: f64 = 1e-13;

impl Node {
    fn of(points: &[Vector], monomials: &Monomials) -> Self {
        let share = 1.0 / points.len() as f64;
        let centre = points.iter().fold([0.0; 3], |sum, &p| add(sum, times(share, p)));
        let mut moments = Box::new([[0.0; 4]; TERMS]);
        let mut length = 0.0;
        for ends in points.windows(2) {
            let e = sub(ends[1], ends[0]);
            length += norm(e);
            for (place, weight) in GAUSS {
                let values = monomials.values(sub(add(ends[0], times(place, e)), centre));
                for (moment, value) in moments.iter_mut().zip(values) {
                    for k in 0..3 {
                        moment[k] += weight * value * e[k];
                    }
                }
            }
        }
        let radius = points.iter().map(|&p| norm(sub(p, centre))).fold(0.0, f64::max);
        Self { centre, radius: radius * (1.0 + 1e-14), length, moments }
    }

    fn join(parts: &[Self], monomials: &Monomials) -> Self {
        let length: f64 = parts.iter().map(|part| part.length).sum();
        let centre = parts.iter().fold([0.0; 3], |sum, part| add(sum, times(part.length / length, part.centre)));
        let mut moments = Box::new([[0.0; 4]; TERMS]);
        let mut radius: f64 = 0.0;
        for part in parts {
            let s = sub(part.centre, centre);
            monomials.move_moments(&part.moments, s, &mut moments);
            radius = radius.max((norm(s) + part.radius) * (1.0 + 1e-14));
        }
        Self { centre, radius, length, moments }
    }
}
