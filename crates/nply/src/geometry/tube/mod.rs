//! Strands as bodies: a tube swept along a helix, a straight line or a helix about a helix.

mod course;
mod double_helix;
mod mesh;

pub use course::{Course, Place};
pub use double_helix::DoubleHelix;
pub use mesh::{Facets, Fit, TubeMesh};

use super::Vector;
use crate::DomainError;

/// How a tube ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Ends {
    /// Cut off by planes across the ply's axis, as (9)–(11) cut it.
    #[default]
    Flush,
    /// Cut off square to its own centreline.
    Square,
}

/// A strand, wire or core with its surface. Lengths in units of r.
///
/// A place on it is given by the course's parameter t and the angle α round the section, counted as in (10): α = 0 along the binormal,
/// π/2 towards the axis. Material lines turn round the section: α = μ − twist·t stays on the line μ.
///
/// ```
/// use nply::Handedness::Right;
/// use nply::geometry::{Centreline, Contact, Section, Tube};
/// let contact = Contact::new(3, 0.5)?;
/// let tube = Tube::new(Centreline::new(&contact, Right, 0), 1.0, 0.0, 20.0)?;
/// let [a, b] = [tube.surface(3.0, 0.4), Section::new(&contact, Right).surface(3.0, 0.4)]; // (10)
/// assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-14));
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube {
    course: Course,
    radius: f64,
    from: f64,
    to: f64,
    /// t at the ends
    parameters: [f64; 2],
    twist: f64,
    ends: Ends,
}

impl Tube {
    /// A tube of the given radius between two heights along the ply's axis, with flush ends and untwisted: material lines keep their
    /// α.
    ///
    /// # Errors
    /// [`DomainError`] on `tube_radius` unless it is finite and greater than 0, on `ply_length` unless `to` − `from` is so.
    pub fn new(course: impl Into<Course>, radius: f64, from: f64, to: f64) -> Result<Self, DomainError> {
        let positive = |value: f64| value > 0.0 && value < f64::INFINITY;
        DomainError::check(positive(radius), "tube_radius", radius, "greater than 0 and finite")?;
        DomainError::check(positive(to - from), "ply_length", to - from, "greater than 0 and finite")?;
        let course = course.into();
        let parameters = [from, to].map(|height| course.at_height(height));
        Ok(Self { course, radius, from, to, parameters, twist: 0.0, ends: Ends::Flush })
    }

    /// The same with material lines that turn by `twist` rad per t against the frame, right-handed positive. For a strand of a ply this
    /// is its pretwist φ̄a: its twist less its torsion, (44).
    ///
    /// # Errors
    /// [`DomainError`] on `pretwist` unless it is finite.
    pub fn twisted(self, twist: f64) -> Result<Self, DomainError> {
        DomainError::check(twist.is_finite(), "pretwist", twist, "finite")?;
        Ok(Self { twist, ..self })
    }

    /// The same with other ends.
    #[must_use]
    pub const fn with_ends(self, ends: Ends) -> Self {
        Self { ends, ..self }
    }

    /// Its centreline.
    #[must_use]
    pub const fn course(&self) -> &Course {
        &self.course
    }

    /// Its radius, in units of r.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// The heights between which it reaches.
    #[must_use]
    pub const fn heights(&self) -> [f64; 2] {
        [self.from, self.to]
    }

    /// How its material lines turn against its frame, rad per t.
    #[must_use]
    pub const fn twist(&self) -> f64 {
        self.twist
    }

    /// How it ends.
    #[must_use]
    pub const fn ends(&self) -> Ends {
        self.ends
    }

    /// The parameters t of its centreline's ends.
    #[must_use]
    pub const fn parameters(&self) -> [f64; 2] {
        self.parameters
    }

    /// The length of its centreline, in units of r: (to − from)/cos θ for a helix.
    #[must_use]
    pub fn length(&self) -> f64 {
        let [start, end] = self.parameters;
        self.course.length(start, end)
    }

    /// πr² times its length: its volume, exactly, with square ends; and with flush ends about a helix, of which like planes cut off what
    /// they leave over, and very nearly about a helix about a helix.
    #[must_use]
    pub fn volume(&self) -> f64 {
        core::f64::consts::PI * self.radius * self.radius * self.length()
    }

    /// The point of the surface at parameter t and angle α, (10).
    #[must_use]
    pub fn surface(&self, t: f64, alpha: f64) -> Vector {
        self.inside(t, alpha, 1.0)
    }

    /// The unit normal of the surface there, outward.
    #[must_use]
    pub fn normal(&self, t: f64, alpha: f64) -> Vector {
        let place = self.course.place(t);
        let (sin, cos) = libm::sincos(alpha);
        core::array::from_fn(|i| sin * place.inward[i] + cos * place.binormal[i])
    }

    /// The point at a share of the radius (0 on the centreline, 1 on the surface).
    pub(super) fn inside(&self, t: f64, alpha: f64, share: f64) -> Vector {
        let place = self.course.place(t);
        let (sin, cos) = libm::sincos(alpha);
        let radius = share * self.radius;
        core::array::from_fn(|i| place.position[i] + radius * (sin * place.inward[i] + cos * place.binormal[i]))
    }

    /// The angle α of the material line μ at parameter t.
    #[must_use]
    pub fn section_angle(&self, t: f64, mu: f64) -> f64 {
        mu - self.twist * t
    }

    /// As [`distance`](Self::distance), of a point close to the place at t.
    pub(super) fn distance_from(&self, point: Vector, t: f64) -> f64 {
        self.course.nearest_from(point, t).1 - self.radius
    }

    /// How far a point lies outside the tube's surface, endless tube; negative inside. In units of r.
    #[must_use]
    pub fn distance(&self, point: Vector) -> f64 {
        self.course.nearest(point).1 - self.radius
    }
}
