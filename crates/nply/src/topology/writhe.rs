//! The writhe of a curve, (A.4).

use core::f64::consts::PI;

use super::closure_point::closures;
use super::crossing::{Blind, Crossings, Seen, self_crossings};
use super::segments::half_solid_angle_with_bound;
use super::shadow::look;
use super::view::{View, views};
use super::{Curve, CurveError};
use crate::geometry::Vector;

/// The writhe of a curve, with a bound for its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Writhe {
    /// Wr.
    pub value: f64,
    /// What rounding can have done to it at most, to first order; what it does as a rule is far less.
    pub bound: f64,
    /// The difference between the values found along two directions: what rounding did do.
    pub discrepancy: f64,
    /// How often the curve is seen to cross itself along each of the two; an open curve with the lines that close it for the count.
    pub crossings: [u64; 2],
}

impl Curve {
    #[doc = include_str!("../equations/eqA04.md")]
    ///
    /// For a polygon that is exact, without sampling or quadrature, and without a sum over pairs: along any direction d
    ///
    /// ```text
    /// Wr = (crossings seen along d, right-handed less left-handed) − (turns of the constant vector d about the curve)
    /// ```
    ///
    /// (Klenin & Langowski, Biopolymers 54 (2000) 307, method 2a). An open curve is closed by two segments, whose own share is then taken off
    /// again. All is done along two directions; the two values must agree, and the mean is given.
    ///
    /// ```
    /// use nply::topology::Curve;
    /// // a right-handed trefoil of six straight segments
    /// let knot = [[-2.0, -1.0, 0.0], [2.0, -1.0, 0.2], [0.2, 2.0, -0.4], [-0.9, -2.0, 0.4], [0.9, -2.0, -0.6], [-0.4, 2.0, 0.5]];
    /// let writhe = Curve::closed(knot.to_vec())?.writhe()?;
    /// assert!((writhe.value - 3.0).abs() < 0.7 && writhe.bound < 1e-13);
    /// # Ok::<(), nply::topology::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Touch`] where segments have a point in common.
    pub fn writhe(&self) -> Result<Writhe, CurveError> {
        let points = self.scaled();
        if self.is_closed() { closed(&points) } else { open(&points) }
    }
}

/// What one direction shows.
#[derive(Clone, Copy)]
struct Sight {
    crossings: Crossings,
    value: f64,
    bound: f64,
}

impl Sight {
    /// Both together: the mean.
    fn with(self, other: Self) -> Writhe {
        Writhe {
            value: 0.5 * (self.value + other.value),
            bound: 0.5 * (self.bound + other.bound),
            discrepancy: (self.value - other.value).abs(),
            crossings: [self.crossings.count, other.crossings.count],
        }
    }

    /// A closed polygon seen along one direction.
    fn of(points: &[Vector], view: View) -> Result<Self, Blind> {
        let (shadow, twist) = look::<true>(points, points.len(), view).ok_or(Blind::Degenerate)?;
        let crossings = self_crossings(Seen { points, segments: points.len(), shadow: &shadow }, view)?;
        Ok(Self { crossings, value: crossings.signed as f64 - twist.turns, bound: twist.bound })
    }
}

/// The first two directions that show something.
fn two_sights(mut sights: impl Iterator<Item = Result<Sight, Blind>>) -> Result<Writhe, CurveError> {
    let mut next = || {
        for sight in sights.by_ref() {
            match sight {
                Ok(sight) => return Ok(sight),
                Err(Blind::Degenerate) => {}
                Err(Blind::Touch(error)) => return Err(error),
            }
        }
        Err(CurveError::Undecided)
    };
    let first = next()?;
    Ok(first.with(next()?))
}

fn closed(points: &[Vector]) -> Result<Writhe, CurveError> {
    two_sights(views(&[points]).into_iter().map(|view| Sight::of(points, view)))
}

/// An open polygon is closed over a point outside, another one for each direction; what the two segments add is summed and taken off.
fn open(points: &[Vector]) -> Result<Writhe, CurveError> {
    let (first, last) = (points[0], points[points.len() - 1]);
    if points.len() > 3 && first.iter().zip(last).all(|(x, y)| *x == y) {
        // its ends meet: the same segments as those of a closed curve
        return closed(&points[..points.len() - 1]);
    }
    let mut round = points.to_vec();
    round.push(first);
    let own = points.len() - 1;
    two_sights(views(&[points]).into_iter().zip(closures(points)).map(|(view, apex)| {
        round[own + 1] = apex;
        let mut sight = Sight::of(&round, view).map_err(|blind| match blind {
            // a closing segment that touches is badly chosen, no more
            Blind::Touch(CurveError::Touch { segments, .. }) if segments.iter().any(|&k| k >= own) => Blind::Degenerate,
            other => other,
        })?;
        let (mut sum, mut bound) = (0.0, 0.0);
        for (k, ends) in points.windows(2).enumerate() {
            for (closing, neighbour) in [([last, apex], own - 1), ([apex, first], 0)] {
                if k != neighbour {
                    let (angle, error) = half_solid_angle_with_bound([ends[0], ends[1]], closing);
                    sum += angle;
                    bound += error;
                }
            }
        }
        sight.value -= sum / PI;
        sight.bound += (bound + points.len() as f64 * f64::EPSILON * sum.abs()) / PI;
        Ok(sight)
    }))
}
