//! The writhe of a curve, (A.4).

use core::f64::consts::PI;

use super::closure_point::closures;
use super::crossing::{Blind, Crossings, self_crossings};
use super::segments::AngleSum;
use super::shadow::look;
use super::view::{View, views};
use super::{Curve, CurveError};
use crate::geometry::Vector;
use crate::numerics::vector::{norm, sub};

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
    /// (Klenin & Langowski, Biopolymers 54 (2000) 307, method 2a). An open curve is closed by three segments, whose own share is then taken off
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

/// What one direction tells.
#[derive(Clone, Copy)]
struct Value {
    crossings: Crossings,
    value: f64,
    bound: f64,
}

impl Value {
    /// Both together: the mean.
    fn with(self, other: Self) -> Writhe {
        Writhe {
            value: 0.5 * (self.value + other.value),
            bound: 0.5 * (self.bound + other.bound),
            discrepancy: (self.value - other.value).abs(),
            crossings: [self.crossings.count, other.crossings.count],
        }
    }
}

/// A closed polygon along two directions.
fn along(points: &[Vector], views: [View; 2]) -> [Result<Value, Blind>; 2] {
    look::<true>(points, points.len(), views).map(|sight| {
        let sight = sight.clear().ok_or(Blind::Degenerate)?;
        let (crossings, twist) = (self_crossings(points, &sight)?, sight.twist);
        Ok(Value { crossings, value: crossings.signed as f64 - twist.turns, bound: twist.bound })
    })
}

/// The first two directions that tell something.
fn first_two(values: impl Iterator<Item = Result<Value, Blind>>) -> Result<Writhe, CurveError> {
    let mut first: Option<Value> = None;
    for value in values {
        match (value, first) {
            (Ok(value), None) => first = Some(value),
            (Ok(value), Some(first)) => return Ok(first.with(value)),
            (Err(Blind::Degenerate), _) => {}
            (Err(Blind::Touch(error)), _) => return Err(error),
        }
    }
    Err(CurveError::Undecided)
}

fn closed(points: &[Vector]) -> Result<Writhe, CurveError> {
    first_two(views(&[points]).into_iter().flat_map(|views| along(points, views)))
}

/// An open polygon is closed over two points outside; what the three segments add is summed and taken off. Once more over other points.
fn open(points: &[Vector]) -> Result<Writhe, CurveError> {
    let (first, last) = (points[0], points[points.len() - 1]);
    if points.len() > 3 && norm(sub(first, last)) <= 0.0 {
        // its ends meet: the same segments as those of a closed curve
        return closed(&points[..points.len() - 1]);
    }
    let mut round = points.to_vec();
    round.extend([first, last]);
    let own = points.len() - 1;
    let views = views(&[points]);
    first_two(closures(points).into_iter().enumerate().map(|(k, [p, q])| {
        (round[own + 1], round[own + 2]) = (p, q);
        let [one, other] = along(&round, views[k % views.len()]);
        let mut value = one.or(other).map_err(|blind| match blind {
            // a closing segment that touches is badly chosen, no more
            Blind::Touch(CurveError::Touch { segments, .. }) if segments.iter().any(|&k| k >= own) => Blind::Degenerate,
            other => other,
        })?;
        let mut sum = AngleSum::default();
        sum.pair([last, p], [q, first]);
        // less each one's neighbour
        sum.rows(&points[..own], [last, p]);
        sum.rows(points, [p, q]);
        sum.rows(&points[1..], [q, first]);
        value.value -= sum.angle / PI;
        value.bound += sum.bound() / PI;
        Ok(value)
    }))
}
