//! Open curves prolonged at both ends.

use super::{Curve, CurveError};
use crate::DomainError;
use crate::numerics::vector::{add, norm, sub, times};

/// Along what the ends of an open curve are prolonged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// Each along its own last segment.
    Tangents,
    /// Both along the line through the ends, away from each other.
    Chord,
}

impl Curve {
    /// The open curve with one straight segment of the given length more at either end.
    ///
    /// What its writhe tends to as the length grows is the writhe of a rod whose ends go on straight.
    ///
    /// ```
    /// use nply::topology::{Along, Curve};
    /// let hook = Curve::open(vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 2.0, 0.0]])?;
    /// assert_eq!(hook.extended(3.0, Along::Tangents)?.points()[4], [1.0, 5.0, 0.0]);
    /// # Ok::<(), nply::topology::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Closed`]; [`CurveError::Domain`] unless the length is above 0 and finite; [`CurveError::EndsMeet`] where the chord has no
    /// direction.
    pub fn extended(&self, length: f64, along: Along) -> Result<Self, CurveError> {
        if self.is_closed() {
            return Err(CurveError::Closed);
        }
        DomainError::check(length > 0.0 && length.is_finite(), "extension", length, "above 0 and finite")?;
        let [first, second] = self.segment(0);
        let [before, last] = self.segment(self.segments() - 1);
        let (back, on) = match along {
            Along::Tangents => (sub(first, second), sub(last, before)),
            Along::Chord => (sub(first, last), sub(last, first)),
        };
        if norm(on) == 0.0 {
            return Err(CurveError::EndsMeet);
        }
        let mut points = Vec::with_capacity(self.points().len() + 2);
        points.push(add(first, times(length / norm(back), back)));
        points.extend_from_slice(self.points());
        points.push(add(last, times(length / norm(on), on)));
        Self::open(points)
    }
}
