//! How near wires come to each other: the least distance of polylines, and which of them overlap.

mod search;
mod segment;
mod tree;

use std::collections::BTreeMap;

use super::Vector;
use crate::DomainError;
use crate::numerics::vector::{cross, norm, sub, times};
pub(super) use segment::approach;
use tree::Tree;

/// A wire: its centreline as a polyline, and its diameter (0: a line without one), in one unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wire<'p> {
    /// The points of its centreline.
    pub points: &'p [Vector],
    /// Whether the last point is joined to the first.
    pub closed: bool,
    /// Its diameter, at least 0.
    pub diameter: f64,
}

/// Wires, in an index by place: their nearest pairs are found without looking at all of them.
///
/// ```
/// use nply::geometry::{Clearance, Wire, Wires};
/// // two straight wires that cross at a distance of 3
/// let (a, b) = ([[-9.0, 0.0, 0.0], [9.0, 0.0, 0.0]], [[0.0, -9.0, 3.0], [0.0, 9.0, 3.0]]);
/// let wire = |points| Wire { points, closed: false, diameter: 4.0 };
/// let wires = Wires::new(&[wire(&a), wire(&b)])?;
/// let found = wires.search(0..wires.segments(), &Clearance::default());
/// let nearest = found.nearest().ok_or("two wires have a distance")?;
/// assert_eq!((nearest.distance, nearest.gap, found.overlaps().count()), (3.0, -1.0, 1));
/// assert_eq!(nearest.points, [[0.0, 0.0, 0.0], [0.0, 0.0, 3.0]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Wires {
    tree: Tree,
    /// radii in the tree's scale
    radius: Vec<f64>,
    /// lengths of the closed ones, in the tree's scale
    ring: Vec<Option<f64>>,
    /// a power of two that brings the greatest coordinate to about 1, so that no square overflows or vanishes
    scale: f64,
    /// what rounding can do to a distance, in the tree's scale
    rounding: f64,
    bends: Vec<Bend>,
}

/// How a polyline turns at its points.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Bend {
    sagitta: f64,
    radius: f64,
}

/// Two segments, the points at which they are nearest, and what is between.
#[derive(Clone, Debug, PartialEq)]
pub struct Approach {
    /// The two wires, counted from 0; twice the same where a wire comes near itself.
    pub wires: [usize; 2],
    /// The segments of each, counted from 0: segment i runs from point i to the next.
    pub segments: [usize; 2],
    /// How far along each segment, from 0 to 1.
    pub fractions: [f64; 2],
    /// The two points.
    pub points: [Vector; 2],
    /// Their distance.
    pub distance: f64,
    /// The distance less half of either diameter; negative where the wires overlap.
    pub gap: f64,
}

/// What a search has found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Clearance {
    nearest: Option<Approach>,
    tightest: Option<Approach>,
    own_nearest: Option<Approach>,
    own_tightest: Option<Approach>,
    overlaps: BTreeMap<[usize; 2], Approach>,
}

impl Wire<'_> {
    fn segments(&self) -> usize {
        self.points.len() - usize::from(!self.closed)
    }

    fn segment(&self, i: usize) -> [Vector; 2] {
        let n = self.points.len();
        [self.points[i], self.points[if i + 1 < n { i + 1 } else { 0 }]]
    }
}

impl Wires {
    /// Puts wires into an index: n log n steps for n segments, some 200 bytes each.
    ///
    /// # Errors
    /// [`DomainError`] where a wire has fewer than two points, a coordinate is not finite or beyond 1e300, a diameter is negative or not
    /// finite, or where there are 2³² segments or more.
    pub fn new(wires: &[Wire<'_>]) -> Result<Self, DomainError> {
        for wire in wires {
            let points = wire.points.len();
            DomainError::check(points >= 2, "points", points as f64, "at least 2 in each wire")?;
            for x in wire.points.iter().flatten() {
                DomainError::check(x.abs() <= 1e300, "coordinate", *x, "finite, and within 1e300 of 0")?;
            }
            DomainError::check(
                (0.0..=1e300).contains(&wire.diameter),
                "diameter",
                wire.diameter,
                "at least 0 and finite",
            )?;
        }
        let segments = wires.iter().fold(0_usize, |sum, wire| sum.saturating_add(wire.segments()));
        DomainError::check(segments < u32::MAX as usize, "segments", segments as f64, "less than 2^32")?;
        DomainError::check(wires.len() < u32::MAX as usize, "wires", wires.len() as f64, "less than 2^32")?;
        let reach =
            wires.iter().flat_map(|wire| wire.points.iter().flatten()).fold(0.0_f64, |most, x| most.max(x.abs()));
        let thickest = wires.iter().fold(0.0_f64, |most, wire| most.max(wire.diameter));
        let largest = reach.max(thickest);
        let scale = if largest > 0.0 { libm::ldexp(1.0, (-libm::ilogb(largest)).min(1023)) } else { 1.0 };
        let arcs: Vec<Vec<f64>> = wires.iter().map(|wire| arclengths(wire, scale)).collect();
        let radius: Vec<f64> = wires.iter().map(|wire| 0.5 * scale * wire.diameter).collect();
        let ring = wires.iter().zip(&arcs).map(|(wire, arc)| arc.last().copied().filter(|_| wire.closed)).collect();
        Ok(Self {
            tree: Tree::new(wires, scale, &radius, &arcs),
            bends: wires.iter().map(|wire| Bend::of(wire, scale)).collect(),
            radius,
            ring,
            scale,
            // three differences of coordinates up to 2, squared and summed, and the radii
            rounding: 16.0 * f64::EPSILON,
        })
    }

    /// How many segments all wires have together.
    #[must_use]
    pub fn segments(&self) -> usize {
        self.tree.pieces.len()
    }

    /// How far a smooth wire may lie off its chords: the greatest height of the arc through three points in a row above the longer of their
    /// two chords. Smooth wires can be nearer or farther than their polylines by as much as both heights together.
    #[must_use]
    pub fn sagitta(&self, wire: usize) -> f64 {
        self.bends.get(wire).map_or(0.0, |bend| bend.sagitta)
    }

    /// The least radius of the circles through three points in a row; infinite for a straight wire. Where it is less than half the diameter a
    /// wire's inner side folds over.
    #[must_use]
    pub fn bend_radius(&self, wire: usize) -> f64 {
        self.bends.get(wire).map_or(f64::INFINITY, |bend| bend.radius)
    }

    /// The length along a wire, measured from either of two points, within which it is no overlap to be near itself: πr, half a turn of the
    /// sharpest bend a wire of radius r can have.
    #[must_use]
    pub fn neighbourhood(&self, wire: usize) -> f64 {
        self.radius.get(wire).map_or(0.0, |radius| core::f64::consts::PI * radius / self.scale)
    }
}

/// Arclength up to each point, in the tree's scale; one more for a closed wire.
fn arclengths(wire: &Wire<'_>, scale: f64) -> Vec<f64> {
    let mut arc = 0.0;
    let lengths = (0..wire.segments()).map(|i| {
        let [a, b] = wire.segment(i);
        arc += norm(sub(times(scale, b), times(scale, a)));
        arc
    });
    core::iter::once(0.0).chain(lengths.collect::<Vec<_>>()).collect()
}

impl Bend {
    /// The extremes over the points of a wire.
    fn of(wire: &Wire<'_>, scale: f64) -> Self {
        let straight = Self { sagitta: 0.0, radius: f64::INFINITY };
        let segments = wire.segments();
        let turns = if wire.closed { segments } else { segments - 1 };
        let edge = |i: usize| {
            let [a, b] = wire.segment(i);
            sub(times(scale, b), times(scale, a))
        };
        let whole = (0..turns).fold(straight, |bend, i| {
            let (a, b) = (edge(i), edge(if i + 1 < segments { i + 1 } else { 0 }));
            let across = crate::numerics::vector::add(a, b);
            let (la, lb, lc) = (norm(a), norm(b), norm(across));
            // the circle through three points: κ = 2|a × b|/(|a||b||a + b|)
            let twice_area = 2.0 * norm(cross(a, b));
            if twice_area == 0.0 {
                return bend;
            }
            let radius = la * lb * lc / twice_area;
            let half = (0.5 * la.max(lb) / radius).min(1.0);
            let sagitta = radius * half * half / (1.0 + (1.0 - half * half).sqrt());
            Self { sagitta: bend.sagitta.max(sagitta), radius: bend.radius.min(radius) }
        });
        Self { sagitta: whole.sagitta / scale, radius: whole.radius / scale }
    }
}

impl Clearance {
    /// The two points of different wires at the least distance; none where there is one wire.
    #[must_use]
    pub fn nearest(&self) -> Option<&Approach> {
        self.nearest.as_ref()
    }

    /// The two points of different wires with the least gap: those of the least distance where all diameters are the same.
    #[must_use]
    pub fn tightest(&self) -> Option<&Approach> {
        self.tightest.as_ref()
    }

    /// The two points of one wire at the least distance, farther apart along it than its [neighbourhood](Wires::neighbourhood); none
    /// for wires without a diameter, and for those that are too short.
    #[must_use]
    pub fn own_nearest(&self) -> Option<&Approach> {
        self.own_nearest.as_ref()
    }

    /// As [`own_nearest`](Self::own_nearest), of the least gap.
    #[must_use]
    pub fn own_tightest(&self) -> Option<&Approach> {
        self.own_tightest.as_ref()
    }

    /// Each two wires that overlap by more than rounding, at their least gap, in the order of the wires.
    pub fn overlaps(&self) -> impl Iterator<Item = &Approach> {
        self.overlaps.values().filter(|approach| approach.wires[0] != approach.wires[1])
    }

    /// Each wire that overlaps with itself beyond its neighbourhood, at its least gap.
    pub fn own_overlaps(&self) -> impl Iterator<Item = &Approach> {
        self.overlaps.values().filter(|approach| approach.wires[0] == approach.wires[1])
    }

    /// Takes in what another range of segments has found.
    pub fn merge(&mut self, other: Self) {
        let pairs = [
            (&mut self.nearest, other.nearest),
            (&mut self.tightest, other.tightest),
            (&mut self.own_nearest, other.own_nearest),
            (&mut self.own_tightest, other.own_tightest),
        ];
        for (at, (known, found)) in pairs.into_iter().enumerate() {
            keep(known, found, if at % 2 == 0 { |a| a.distance } else { |a| a.gap });
        }
        for approach in other.overlaps.into_values() {
            self.overlap(approach);
        }
    }

    fn offer(&mut self, approach: Approach, overlap: bool) {
        keep(&mut self.nearest, Some(approach.clone()), |a| a.distance);
        keep(&mut self.tightest, Some(approach.clone()), |a| a.gap);
        if overlap {
            self.overlap(approach);
        }
    }

    fn offer_own(&mut self, approach: Approach, overlap: bool) {
        keep(&mut self.own_nearest, Some(approach.clone()), |a| a.distance);
        keep(&mut self.own_tightest, Some(approach.clone()), |a| a.gap);
        if overlap {
            self.overlap(approach);
        }
    }

    fn overlap(&mut self, approach: Approach) {
        match self.overlaps.get_mut(&approach.wires) {
            Some(known) if before(&approach, known, |a| a.gap) => *known = approach,
            Some(_) => {}
            None => drop(self.overlaps.insert(approach.wires, approach)),
        }
    }
}

/// The lesser of two; of equals that of the lesser wires and segments.
fn before(one: &Approach, other: &Approach, by: fn(&Approach) -> f64) -> bool {
    by(one).total_cmp(&by(other)).then((one.wires, one.segments).cmp(&(other.wires, other.segments))).is_lt()
}

fn keep(known: &mut Option<Approach>, found: Option<Approach>, by: fn(&Approach) -> f64) {
    if let Some(found) = found
        && known.as_ref().is_none_or(|known| before(&found, known, by))
    {
        *known = Some(found);
    }
}
