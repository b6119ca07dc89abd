//! How often closed curves run round each other.

use core::f64::consts::TAU;

use super::segments::half_solid_angle;
use super::{Curve, CurveError};

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

/// The linking number of two closed curves.
///
/// # Errors
/// [`CurveError::Touch`] where they have a point in common, [`CurveError::Open`] where one is open.
pub fn linking_number(one: &Curve, other: &Curve) -> Result<LinkingNumber, CurveError> {
    if let Some(curve) = [one, other].iter().position(|curve| !curve.is_closed()) {
        return Err(CurveError::Open { curve });
    }
    let value = linking_integral(one, other)?.value;
    Ok(LinkingNumber { value: value.round() as i64, crossings: [0; 2] })
}

/// The Gauss integral of two curves, closed or open.
///
/// # Errors
/// [`CurveError::Touch`] where they have a point in common.
pub fn linking_integral(one: &Curve, other: &Curve) -> Result<LinkingIntegral, CurveError> {
    let mut sum = 0.0;
    for i in 0..one.segments() {
        for j in 0..other.segments() {
            sum += half_solid_angle(one.segment(i), other.segment(j));
        }
    }
    Ok(LinkingIntegral { value: sum / TAU, bound: 1e-15 * (one.segments() as f64) })
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
