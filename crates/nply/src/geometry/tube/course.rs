//! What a tube's centreline can be, and the frame its surface is measured in.

use super::DoubleHelix;
use crate::geometry::{Centreline, Vector};

/// The centreline of a tube: a helix or straight line, or a helix about a helix.
///
/// Each is run through by a parameter t in units of r: the arclength of the helix, or for a helix about a helix that of the helix it
/// winds about.
///
/// ```
/// use nply::Handedness::Right;
/// use nply::geometry::{Centreline, Contact, Course};
/// let course = Course::from(Centreline::new(&Contact::new(3, 0.5)?, Right, 0));
/// let place = course.place(2.0);
/// assert!((place.speed - 1.0).abs() < 1e-15);
/// let (t, distance) = course.nearest([place.position[0] + 1.5 * place.binormal[0], place.position[1] + 1.5 * place.binormal[1],
///     place.position[2] + 1.5 * place.binormal[2]]);
/// assert!((t - 2.0).abs() < 1e-12 && (distance - 1.5).abs() < 1e-12);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Course {
    /// A helix about the axis, or the axis itself.
    Helix(Centreline),
    /// A helix about a helix: a wire of a rope's outer strand.
    DoubleHelix(DoubleHelix),
}

impl From<Centreline> for Course {
    fn from(centreline: Centreline) -> Self {
        Self::Helix(centreline)
    }
}

impl From<DoubleHelix> for Course {
    fn from(double: DoubleHelix) -> Self {
        Self::DoubleHelix(double)
    }
}

/// A place on a course: where it is, where it goes, and the two directions across it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The point, in units of r.
    pub position: Vector,
    /// The unit tangent, towards growing t.
    pub tangent: Vector,
    /// The unit normal towards the axis the course winds about; for a single helix that of Frenet.
    pub inward: Vector,
    /// tangent × inward.
    pub binormal: Vector,
    /// The length of the derivative by t.
    pub speed: f64,
}

impl Course {
    /// The place at parameter t.
    #[must_use]
    pub fn place(&self, t: f64) -> Place {
        match self {
            Self::Helix(helix) => {
                let frame = helix.frame(t);
                Place {
                    position: helix.position(t),
                    tangent: frame.tangent,
                    inward: frame.normal,
                    binormal: frame.binormal,
                    speed: 1.0,
                }
            }
            Self::DoubleHelix(double) => double.place(t),
        }
    }

    /// The parameter of the point nearest to a point in space, and the distance to it, in units of r.
    #[must_use]
    pub fn nearest(&self, point: Vector) -> (f64, f64) {
        match self {
            Self::Helix(helix) => helix.nearest(point),
            Self::DoubleHelix(double) => double.nearest(point),
        }
    }

    /// The distance of a point from the course near a parameter.
    pub(super) fn distance_near(&self, point: Vector, t: f64) -> f64 {
        match self {
            Self::Helix(helix) => helix.nearest(point).1,
            Self::DoubleHelix(double) => double.foot(point, t).1,
        }
    }

    /// The mean height gained per t, greater than 0: cos θ of the helix.
    #[must_use]
    pub const fn rise(&self) -> f64 {
        match self {
            Self::Helix(helix) => helix.rise(),
            Self::DoubleHelix(double) => double.axis().rise(),
        }
    }

    /// The greatest distance from the ply's axis, in units of r.
    #[must_use]
    pub fn outermost(&self) -> f64 {
        match self {
            Self::Helix(helix) => helix.radius(),
            Self::DoubleHelix(double) => double.axis().radius() + double.radius(),
        }
    }

    /// Whether every stretch of t is like any other of that length.
    #[must_use]
    pub const fn is_uniform(&self) -> bool {
        matches!(self, Self::Helix(_))
    }

    /// Greatest turn of the tangent per t, rad per r: bounds the size of a step along it.
    pub(super) fn turning(&self) -> f64 {
        match self {
            Self::Helix(helix) => helix.azimuth_rate().abs(),
            Self::DoubleHelix(double) => double.axis().azimuth_rate().abs() + double.rate().abs(),
        }
    }
}
