//! How often a curve is seen to cross itself, as a mean over all directions: a sum over pairs of segments.

use core::f64::consts::PI;
use core::ops::{Add, Range};

use super::Curve;
use super::pair_kernel::{BLOCK, Block};
use crate::geometry::Vector;

/// The average crossing number of a curve, piece by piece, so that a caller may share the work out, show how far it is and stop.
///
/// ```
/// use nply::topology::{AverageCrossings, CrossingShare, Curve};
/// let knot = [[-2.0, -1.0, 0.0], [2.0, -1.0, 0.2], [0.2, 2.0, -0.4], [-0.9, -2.0, 0.4], [0.9, -2.0, -0.6], [-0.4, 2.0, 0.5]];
/// let curve = Curve::closed(knot.to_vec())?;
/// let work = AverageCrossings::new(&curve);
/// let whole = (0..work.columns()).map(|k| work.share(k..k + 1)).fold(CrossingShare::default(), |a, b| a + b);
/// assert!((whole.value - curve.average_crossing_number().value).abs() < 1e-14);
/// assert!(whole.value >= curve.writhe()?.value.abs());
/// # Ok::<(), nply::topology::CurveError>(())
/// ```
#[derive(Clone, Debug)]
pub struct AverageCrossings {
    /// of size about one; of a closed curve the first once more at the end
    points: Vec<Vector>,
    closed: bool,
}

/// A share of an average crossing number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CrossingShare {
    /// Crossings, both hands alike.
    pub value: f64,
    /// What rounding can have done to it, to first order.
    pub bound: f64,
}

impl Add for CrossingShare {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, bound: self.bound + other.bound }
    }
}

impl AverageCrossings {
    /// The work for a curve.
    #[must_use]
    pub fn new(curve: &Curve) -> Self {
        Self { points: curve.of_size_one(), closed: curve.is_closed() }
    }

    /// Into how many columns the pairs are sorted; later ones hold more.
    #[must_use]
    pub fn columns(&self) -> usize {
        (self.points.len() - 1).div_ceil(BLOCK)
    }

    /// How many pairs some columns hold, for a measure of progress.
    #[must_use]
    pub fn pairs(&self, columns: Range<usize>) -> u64 {
        let before = |column: usize| {
            let segments = (column * BLOCK).min(self.points.len() - 1) as u64;
            segments * segments.saturating_sub(1) / 2
        };
        before(columns.end) - before(columns.start.min(columns.end))
    }

    /// What some columns add.
    #[must_use]
    pub fn share(&self, columns: Range<usize>) -> CrossingShare {
        let segments = self.points.len() - 1;
        let mut share = CrossingShare::default();
        for column in columns.start..columns.end.min(self.columns()) {
            let start = column * BLOCK;
            let rows = &self.points[..(start + BLOCK).min(segments)];
            let round = |row: usize, segment: usize| self.closed && row == 0 && segment + 1 == segments;
            let part = Block::new(&self.points, start).sum::<true>(rows, |row| row + 2, round, &mut []);
            share = share + CrossingShare { value: part.sum / PI, bound: part.bound / PI };
        }
        share
    }
}

impl Curve {
    /// The average crossing number: how often the curve is seen to cross itself, as a mean over all directions; the integral (A.4) with its
    /// integrand taken as positive. A sum over all pairs of segments; where they touch, the bound tells that rounding decides.
    #[must_use]
    pub fn average_crossing_number(&self) -> CrossingShare {
        let work = AverageCrossings::new(self);
        work.share(0..work.columns())
    }
}
