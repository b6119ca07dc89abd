//! What can be wrong with a curve, said with the place.

use core::fmt;

/// Why a curve, or a pair of curves, has no link, twist or writhe.
///
/// Points and segments count from 0; segment i runs from point i to the next one.
///
/// ```
/// use nply::topology::Curve;
/// let error = Curve::closed(vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]).unwrap_err();
/// assert_eq!(error.to_string(), "2 points are no closed curve: at least 3 are needed");
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CurveError {
    /// Too few points.
    TooFew {
        /// How many there are.
        points: usize,
        /// Whether the curve was to be closed.
        closed: bool,
    },
    /// More points than can be counted here.
    TooMany {
        /// How many there are.
        points: usize,
    },
    /// A coordinate is not a number, or is infinite.
    NotFinite {
        /// Which point.
        point: usize,
    },
    /// A coordinate is too large, or a segment too short beside the whole, to form products of three lengths.
    OutOfReach {
        /// Which point, or the first one of the segment.
        point: usize,
    },
    /// A point stands where the one before it stands.
    Repeated {
        /// The second of the two.
        point: usize,
    },
    /// The last point of a closed curve stands where the first one stands.
    EndRepeatsStart {
        /// The last one.
        point: usize,
    },
    /// A segment runs back along the one before it.
    TurnsBack {
        /// Where.
        point: usize,
    },
    /// Two segments have a point in common.
    Touch {
        /// Which curve each belongs to: both 0 where a curve touches itself.
        curves: [usize; 2],
        /// The two segments.
        segments: [usize; 2],
    },
    /// Along every direction that was tried an end of a segment is seen on another one, or all but so.
    Undecided,
    /// Something is asked of an open curve that closed ones alone have.
    Open {
        /// Which curve.
        curve: usize,
    },
    /// Something is asked of a closed curve that open ones alone have.
    Closed,
    /// Both ends of an open curve stand in one place, so that no line runs through them.
    EndsMeet,
    /// A segment runs across the axis of a polar writhe.
    Level {
        /// Which one.
        segment: usize,
    },
    /// A number that goes with the curve is outside its range.
    Domain(crate::DomainError),
    /// Vectors along a curve are not as many as its points or segments.
    FrameLength {
        /// How many vectors there are.
        vectors: usize,
        /// How many it takes.
        needed: usize,
    },
    /// A vector of a frame runs along the curve, or is zero, or not a number, so that it shows no direction across it.
    FrameAlong {
        /// Which vector.
        vector: usize,
    },
    /// A curve was not sampled to the tolerance that was asked for.
    NotConverged {
        /// How many points it had at last.
        points: usize,
        /// The change of writhe from half as many.
        change: f64,
        /// What was asked for.
        tolerance: f64,
    },
}

impl fmt::Display for CurveError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pair = |out: &mut fmt::Formatter<'_>, curves: &[usize; 2], segments: &[usize; 2]| {
            let [first, second] = segments;
            if curves[0] == curves[1] {
                write!(out, "segments {first} and {second} (counted from 0)")
            } else {
                let [one, other] = curves;
                write!(out, "segment {first} of curve {one} and segment {second} of curve {other} (counted from 0)")
            }
        };
        match self {
            Self::TooFew { points, closed: true } => {
                write!(out, "{points} points are no closed curve: at least 3 are needed")
            }
            Self::TooFew { points, closed: false } => {
                write!(out, "{points} points are no open curve: at least 2 are needed")
            }
            Self::TooMany { points } => write!(out, "{points} points are more than {} can be counted", u32::MAX / 4),
            Self::NotFinite { point } => {
                write!(out, "point {point} (counted from 0) has a coordinate that is infinite or not a number")
            }
            Self::OutOfReach { point } => write!(
                out,
                "point {point} (counted from 0) has a coordinate beyond 1e300, or starts a segment shorter than 1e-40 of \
                 the curve's size: scale the curve, or leave the point out"
            ),
            Self::Repeated { point } => {
                write!(out, "point {point} (counted from 0) repeats the one before it: leave one of them out")
            }
            Self::EndRepeatsStart { point } => write!(
                out,
                "the last point ({point}, counted from 0) repeats the first: a closed curve is joined without it, leave it out"
            ),
            Self::TurnsBack { point } => write!(
                out,
                "the curve runs back along itself at point {point} (counted from 0): segments that overlap have no writhe"
            ),
            Self::Touch { curves, segments } => {
                pair(out, curves, segments)?;
                write!(out, " touch or cross: which passes the other on which side is not defined")
            }
            Self::Undecided => write!(
                out,
                "along every direction that was tried an end of one segment is seen on another: crossings cannot be counted"
            ),
            Self::Open { curve } => {
                write!(out, "curve {curve} (counted from 0) is open: this is defined for closed curves alone")
            }
            Self::Closed => write!(out, "the curve is closed: it has no ends"),
            Self::EndsMeet => write!(out, "both ends of the curve stand in one place: no line runs through them"),
            Self::Level { segment } => write!(
                out,
                "segment {segment} (counted from 0) runs across the axis, where a polar writhe has no height for it: turn the axis a little"
            ),
            Self::Domain(error) => error.fmt(out),
            Self::FrameLength { vectors, needed } => {
                write!(out, "{vectors} vectors go with a curve that takes {needed}")
            }
            Self::FrameAlong { vector } => write!(
                out,
                "vector {vector} (counted from 0) shows no direction across the curve: it runs along it, is zero or no number"
            ),
            Self::NotConverged { points, change, tolerance } => write!(
                out,
                "with {points} points the writhe still changes by {change:.1e} when their number is doubled, more than {tolerance:e}"
            ),
        }
    }
}

impl std::error::Error for CurveError {}

impl CurveError {
    /// The same, said of two curves by their places in a list.
    #[must_use]
    pub fn of_curves(self, places: [usize; 2]) -> Self {
        match self {
            Self::Touch { curves, segments } => Self::Touch { curves: curves.map(|k| places[k]), segments },
            Self::Open { curve } => Self::Open { curve: places[curve] },
            other => other,
        }
    }
}

impl From<crate::DomainError> for CurveError {
    fn from(error: crate::DomainError) -> Self {
        Self::Domain(error)
    }
}
