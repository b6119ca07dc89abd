//! How often closed curves run round each other.

use core::f64::consts::TAU;

use super::closure_point::{CLOSURES, closures};
use super::crossing::{Blind, Crossings, mutual_crossings};
use super::segments::AngleSum;
use super::shadow::look;
use super::view::{View, views};
use super::{Curve, CurveError};
use crate::geometry::Vector;

/// The linking number of two closed curves: an integer, counted from their crossings along two directions that must agree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LinkingNumber {
    /// Lk: half the crossings, right-handed ones less left-handed ones.
    pub value: i64,
    /// How often the curves are seen to cross each other, along either direction.
    pub crossings: [u64; 2],
}

/// The Gauss integral of two curves, closed or open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkingIntegral {
    /// The double integral (A.4) with one curve as r(s), the other as r(t).
    pub value: f64,
    /// What rounding can have done to it at most.
    pub bound: f64,
}

/// The linking number of two closed curves, by their crossings seen along two directions: an integer, without rounding.
///
/// Reversing one of the curves turns its sign, as does a mirror.
///
/// ```
/// use nply::topology::{Curve, linking_number};
/// let flat = Curve::closed(vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]])?;
/// let upright = Curve::closed(vec![[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [1.0, 5.0, 0.0]])?;
/// // up through a square that runs anticlockwise
/// assert_eq!(linking_number(&flat, &upright)?.value, 1);
/// assert_eq!(linking_number(&flat, &upright.reversed())?.value, -1);
/// # Ok::<(), nply::topology::CurveError>(())
/// ```
///
/// # Errors
/// [`CurveError::Touch`] where they have a point in common, [`CurveError::Open`] where one is open.
pub fn linking_number(one: &Curve, other: &Curve) -> Result<LinkingNumber, CurveError> {
    if let Some(curve) = [one, other].iter().position(|curve| !curve.is_closed()) {
        return Err(CurveError::Open { curve });
    }
    let [a, b] = one.scaled_pair(other);
    let [first, second] = counts(&a, &b)?;
    if first.signed != second.signed || first.signed % 2 != 0 {
        return Err(CurveError::Undecided);
    }
    Ok(LinkingNumber { value: first.signed / 2, crossings: [first.count, second.count] })
}

/// Crossings between two closed polygons along the first two directions that show something.
fn counts(a: &[Vector], b: &[Vector]) -> Result<[Crossings; 2], CurveError> {
    let mut first = None;
    for views in views(&[a, b]) {
        for count in count(a, b, views) {
            match (count, first) {
                (Ok(crossings), None) => first = Some(crossings),
                (Ok(crossings), Some(first)) => return Ok([first, crossings]),
                (Err(Blind::Degenerate), _) => {}
                (Err(Blind::Touch(error)), _) => return Err(error),
            }
        }
    }
    Err(CurveError::Undecided)
}

/// Crossings between two closed polygons along two directions.
fn count(a: &[Vector], b: &[Vector], views: [View; 2]) -> [Result<Crossings, Blind>; 2] {
    let [one, other] = [a, b].map(|points| look::<false>(points, points.len(), views));
    [0, 1].map(|k| mutual_crossings([a, b], [&one[k], &other[k]]))
}

/// The Gauss integral of two curves, closed or open: the double integral (A.4) with one curve as r(s), the other as r(t).
///
/// Open curves are closed by three segments each; the linking number of the closed ones is counted, and what those segments add is summed and
/// taken off.
///
/// ```
/// use nply::topology::{Curve, linking_integral};
/// // two long perpendicular lines, one a unit above the other: seen to cross from all but a few directions, half of a crossing
/// let over = Curve::open(vec![[-1e6, 0.0, 1.0], [1e6, 0.0, 1.0]])?;
/// let under = Curve::open(vec![[0.0, -1e6, 0.0], [0.0, 1e6, 0.0]])?;
/// assert!((linking_integral(&over, &under)?.value - 0.5).abs() < 1e-5);
/// # Ok::<(), nply::topology::CurveError>(())
/// ```
///
/// # Errors
/// [`CurveError::Touch`] where they have a point in common.
pub fn linking_integral(one: &Curve, other: &Curve) -> Result<LinkingIntegral, CurveError> {
    if one.is_closed() && other.is_closed() {
        return linking_number(one, other).map(|link| LinkingIntegral { value: link.value as f64, bound: 0.0 });
    }
    let [a, b] = one.scaled_pair(other);
    let [ways, other_ways] = [(one, &a), (other, &b)].map(|(curve, points)| Closing::of(points, curve.is_closed()));
    for k in 0..CLOSURES {
        let (x, y) = (&ways[k % ways.len()], &other_ways[(k + k / 4) % other_ways.len()]);
        match counts(&x.closed(&a), &y.closed(&b)) {
            // a closing segment that touches is badly chosen, no more
            Err(CurveError::Touch { segments, .. })
                if segments[0] >= one.segments() || segments[1] >= other.segments() => {}
            Err(error) => return Err(error),
            Ok([first, second]) => {
                if first.signed != second.signed {
                    return Err(CurveError::Undecided);
                }
                let mut sum = AngleSum::default();
                for (curve, points, closing) in [(one, &a, y), (other, &b, x)] {
                    for &segment in &closing.segments {
                        sum.rows(points, segment);
                        if curve.is_closed() {
                            sum.pair([points[points.len() - 1], points[0]], segment);
                        }
                    }
                }
                for &p in &x.segments {
                    for &q in &y.segments {
                        sum.pair(p, q);
                    }
                }
                let value = 0.5 * first.signed as f64 - sum.angle / TAU;
                let bound = sum.bound() / TAU;
                return Ok(LinkingIntegral { value, bound });
            }
        }
    }
    Err(CurveError::Undecided)
}

/// How an open curve is closed: over two points outside.
struct Closing {
    over: Vec<Vector>,
    segments: Vec<[Vector; 2]>,
}

impl Closing {
    /// Some ways, the best first; none is needed for a closed curve.
    fn of(points: &[Vector], closed: bool) -> Vec<Self> {
        if closed {
            return vec![Self { over: Vec::new(), segments: Vec::new() }];
        }
        let (first, last) = (points[0], points[points.len() - 1]);
        let over = |[p, q]: [Vector; 2]| Self { over: vec![p, q], segments: vec![[last, p], [p, q], [q, first]] };
        closures(points).into_iter().map(over).collect()
    }

    fn closed(&self, points: &[Vector]) -> Vec<Vector> {
        [points, &self.over].concat()
    }
}

/// The linking numbers of several closed curves, each with each; zero on the diagonal.
///
/// # Errors
/// As for [`linking_number`], with the curves' own places in the list.
pub fn linking_matrix(curves: &[Curve]) -> Result<Vec<Vec<i64>>, CurveError> {
    let mut matrix = vec![vec![0; curves.len()]; curves.len()];
    for i in 0..curves.len() {
        for j in 0..i {
            let link = linking_number(&curves[j], &curves[i]).map_err(|error| error.of_curves([j, i]))?;
            matrix[i][j] = link.value;
            matrix[j][i] = link.value;
        }
    }
    Ok(matrix)
}
