//! Smooth curves, sampled until their writhe is known to a tolerance.

use super::{Curve, CurveError};
use crate::DomainError;
use crate::geometry::Vector;

/// A polygon on a smooth curve, and the smooth curve's writhe.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    /// The finest polygon that was taken.
    pub polygon: Curve,
    /// Wr of the smooth curve, extrapolated from polygons of n, 2n, 4n … segments, whose error falls as 1/n², 1/n⁴ ….
    pub writhe: f64,
    /// An estimate of its error: the greater of the last two changes of the extrapolated value, and what rounding can do.
    pub error: f64,
    /// By how much the polygon's own writhe is off.
    pub polygon_error: f64,
}

/// Segments to begin and to end with.
const FEWEST: usize = 64;
const MOST: usize = 1 << 21;

impl Curve {
    /// A smooth closed curve, given by its place at t from 0 to 1, where it must come back to its beginning as smoothly.
    ///
    /// ```
    /// use nply::topology::Curve;
    /// use std::f64::consts::TAU;
    /// // a right-handed trefoil on a torus of radii 2 and 1
    /// let knot = Curve::sample_closed(
    ///     |t| {
    ///         let ((s2, c2), (s3, c3)) = (libm::sincos(2.0 * TAU * t), libm::sincos(3.0 * TAU * t));
    ///         [(2.0 + c3) * c2, (2.0 + c3) * s2, -s3]
    ///     },
    ///     1e-9,
    /// )?;
    /// assert!((knot.writhe - 3.518_239_231).abs() < 1e-9 && knot.error < 1e-9);
    /// # Ok::<(), nply::topology::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Domain`] unless the tolerance is above 0; [`CurveError::NotConverged`] where two million segments are not enough, as on a curve with
    /// corners; whatever is wrong with its polygons.
    pub fn sample_closed(position: impl Fn(f64) -> Vector, tolerance: f64) -> Result<Sampled, CurveError> {
        sample(position, tolerance, true)
    }

    /// A smooth open curve, given by its place at t from 0 to 1, both included.
    ///
    /// # Errors
    /// As for [`Curve::sample_closed`].
    pub fn sample_open(position: impl Fn(f64) -> Vector, tolerance: f64) -> Result<Sampled, CurveError> {
        sample(position, tolerance, false)
    }
}

fn sample(position: impl Fn(f64) -> Vector, tolerance: f64, closed: bool) -> Result<Sampled, CurveError> {
    DomainError::check(tolerance > 0.0, "tolerance", tolerance, "above 0")?;
    let place = |k: usize, n: usize| position(k as f64 / n as f64);
    let mut n = FEWEST;
    let mut points: Vec<Vector> = (0..n + usize::from(!closed)).map(|k| place(k, n)).collect();
    // Romberg's row: the polygon's own writhe, then freed of errors of order 1/n², 1/n⁴, 1/n⁶
    let mut row: Vec<f64> = Vec::new();
    let mut last_change = f64::INFINITY;
    loop {
        let polygon = if closed { Curve::closed(points.clone()) } else { Curve::open(points.clone()) }?;
        let found = polygon.writhe()?;
        let mut next = vec![found.value];
        for (old, factor) in row.iter().zip([3.0, 15.0, 63.0]) {
            let best = next[next.len() - 1];
            next.push(best + (best - old) / factor);
        }
        let writhe = next[next.len() - 1];
        let change = row.last().map_or(f64::INFINITY, |old| (writhe - old).abs());
        let error = change.max(last_change).max(found.discrepancy);
        if error <= tolerance {
            let polygon_error = (found.value - writhe).abs();
            return Ok(Sampled { polygon, writhe, error, polygon_error });
        }
        if n >= MOST {
            return Err(CurveError::NotConverged { points: points.len(), change, tolerance });
        }
        next.truncate(4);
        (row, last_change) = (next, change);
        // a new point between each two
        n *= 2;
        let between = (0..n / 2).map(|k| place(2 * k + 1, n));
        let mut finer = Vec::with_capacity(points.len() * 2);
        let mut old = points.iter();
        for point in between {
            finer.extend(old.next().copied());
            finer.push(point);
        }
        finer.extend(old);
        points = finer;
    }
}
