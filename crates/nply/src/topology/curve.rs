//! A polygon in space, closed or open.

use std::borrow::Cow;

use super::CurveError;
use crate::geometry::Vector;
use crate::numerics::vector::{dot, norm, sub, times};

/// A curve made of straight segments, closed or open: finite points, none where its neighbour stands, no segment that runs back
/// along the one before it.
///
/// Lengths have any unit, the same for all three coordinates. Segment i runs from point i to point i + 1; the last segment of
/// a closed curve runs from the last point to the first.
///
/// ```
/// use nply::topology::Curve;
/// let square = Curve::closed(vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])?;
/// assert_eq!((square.segments(), square.length()), (4, 4.0));
/// assert!(Curve::open(vec![[0.0, 0.0, f64::NAN], [1.0, 0.0, 0.0]]).is_err());
/// # Ok::<(), nply::topology::CurveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    points: Vec<Vector>,
    closed: bool,
    /// the greatest coordinate, either sign
    reach: f64,
}

impl Curve {
    /// A closed curve: the last point is joined to the first, which is not repeated.
    ///
    /// # Errors
    /// [`CurveError`] for fewer than three points, a coordinate that is not finite or beyond 1e300, a point repeated by the next one, a
    /// segment shorter than 1e-40 of the greatest coordinate or running back along the one before it.
    pub fn closed(points: Vec<Vector>) -> Result<Self, CurveError> {
        Self::new(points, true)
    }

    /// An open curve.
    ///
    /// # Errors
    /// As for [`Curve::closed`], two points being enough.
    pub fn open(points: Vec<Vector>) -> Result<Self, CurveError> {
        Self::new(points, false)
    }

    fn new(points: Vec<Vector>, closed: bool) -> Result<Self, CurveError> {
        if points.len() < if closed { 3 } else { 2 } {
            return Err(CurveError::TooFew { points: points.len(), closed });
        }
        if points.len() > u32::MAX as usize / 4 {
            return Err(CurveError::TooMany { points: points.len() });
        }
        if let Some(point) = points.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
            return Err(CurveError::NotFinite { point });
        }
        let reach = points.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        if let Some(point) = points.iter().position(|p| !p.iter().all(|x| x.abs() <= 1e300)) {
            return Err(CurveError::OutOfReach { point });
        }
        let curve = Self { points, closed, reach };
        curve.check_segments()?;
        Ok(curve)
    }

    /// No segment without a length, none that runs back.
    fn check_segments(&self) -> Result<(), CurveError> {
        let points = self.scaled();
        let n = points.len();
        let least = 1e-40 * largest(&points);
        let edge = |i: usize| sub(points[if i + 1 < n { i + 1 } else { 0 }], points[i]);
        let mut last = if self.closed { edge(n - 1) } else { times(-1.0, edge(0)) };
        for i in 0..self.segments() {
            let next = edge(i);
            let longest = next[0].abs().max(next[1].abs()).max(next[2].abs());
            if longest <= least {
                return Err(if longest > 0.0 {
                    CurveError::OutOfReach { point: i }
                } else if i + 1 < n {
                    CurveError::Repeated { point: i + 1 }
                } else {
                    CurveError::EndRepeatsStart { point: i }
                });
            }
            if (self.closed || i > 0) && dot(last, next) < 0.0 {
                let before = points[if i > 0 { i - 1 } else { n - 1 }];
                if collinear(before, points[i], points[if i + 1 < n { i + 1 } else { 0 }]) {
                    return Err(CurveError::TurnsBack { point: i });
                }
            }
            last = next;
        }
        Ok(())
    }

    /// The points, in order.
    #[must_use]
    pub fn points(&self) -> &[Vector] {
        &self.points
    }

    /// Whether the last point is joined to the first.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// How many segments there are: as many as points, one less if the curve is open.
    #[must_use]
    pub fn segments(&self) -> usize {
        self.points.len() - usize::from(!self.closed)
    }

    /// Both ends of a segment; counted round if there are not as many.
    #[must_use]
    pub fn segment(&self, segment: usize) -> [Vector; 2] {
        let n = self.points.len();
        [self.points[segment % n], self.points[(segment + 1) % n]]
    }

    /// The length of all segments together.
    #[must_use]
    pub fn length(&self) -> f64 {
        let points = self.scaled();
        let inner: f64 = points.windows(2).map(|pair| norm(sub(pair[1], pair[0]))).sum();
        let last = if self.closed { norm(sub(points[0], points[points.len() - 1])) } else { 0.0 };
        (inner + last) / self.scale()
    }

    /// The same curve run through from its other end.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { points: self.points.iter().rev().copied().collect(), ..*self }
    }

    /// A power of two that brings the greatest coordinate to between 2⁻³² and 2³².
    fn scale(&self) -> f64 {
        power_of_two(self.reach)
    }

    /// The points, so scaled that products of lengths neither overflow nor vanish; no digit changes.
    pub(crate) fn scaled(&self) -> Cow<'_, [Vector]> {
        self.scaled_by(self.scale())
    }

    pub(crate) fn scaled_by(&self, scale: f64) -> Cow<'_, [Vector]> {
        #[expect(clippy::float_cmp, reason = "1 is exact")]
        if scale == 1.0 {
            Cow::Borrowed(&self.points)
        } else {
            Cow::Owned(self.points.iter().map(|&p| times(scale, p)).collect())
        }
    }

    /// The points, so scaled by a power of two that the curve's size is about one; of a closed curve the first once more at the end.
    pub(crate) fn of_size_one(&self) -> Vec<Vector> {
        let points = self.scaled();
        let first = points[0];
        let size = points.iter().flat_map(|&p| sub(p, first)).fold(0.0_f64, |most, x| most.max(x.abs()));
        let scale = libm::ldexp(1.0, -libm::ilogb(size));
        let round = self.closed.then_some(first);
        points.iter().copied().chain(round).map(|p| times(scale, p)).collect()
    }

    /// Both curves' points in one scale.
    pub(crate) fn scaled_pair<'a>(&'a self, other: &'a Self) -> [Cow<'a, [Vector]>; 2] {
        let scale = power_of_two(self.reach.max(other.reach));
        [self.scaled_by(scale), other.scaled_by(scale)]
    }
}

fn largest(points: &[Vector]) -> f64 {
    points.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()))
}

/// 1 between 2⁻³² and 2³², and what brings other numbers to about 1.
fn power_of_two(reach: f64) -> f64 {
    let exponent = if reach > 0.0 { libm::ilogb(reach) } else { 0 };
    if exponent.abs() <= 32 { 1.0 } else { libm::ldexp(1.0, (-exponent).min(1023)) }
}

/// Exactly: whether three points lie on a line, as their shadows on the three planes of coordinates do.
pub(crate) fn collinear(a: Vector, b: Vector, c: Vector) -> bool {
    [[0, 1], [1, 2], [2, 0]].iter().all(|&[x, y]| {
        let shadow = |p: Vector| robust::Coord { x: p[x], y: p[y] };
        robust::orient2d(shadow(a), shadow(b), shadow(c)) == 0.0
    })
}
