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

    /// A bound of how it winds, rad per t: its azimuth about the axis, and that about the strand it belongs to.
    #[must_use]
    pub fn turning(&self) -> f64 {
        match self {
            Self::Helix(helix) => helix.azimuth_rate().abs(),
            Self::DoubleHelix(double) => double.axis().azimuth_rate().abs() + double.rate().abs(),
        }
    }

    /// Whether a turn about the ply's axis and a shift along it take one course to the other.
    ///
    /// ```
    /// use nply::Handedness::Right;
    /// use nply::geometry::{Centreline, Contact, Course};
    /// let contact = Contact::new(3, 0.5)?;
    /// let [first, second] = [0, 1].map(|strand| Course::from(Centreline::new(&contact, Right, strand)));
    /// assert!(first.is_like(&second) && !first.is_like(&Course::from(Centreline::axis())));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn is_like(&self, other: &Self) -> bool {
        let same = |a: f64, b: f64| a.to_bits() == b.to_bits();
        let alike = |a: &Centreline, b: &Centreline| {
            same(a.radius(), b.radius()) && same(a.azimuth_rate(), b.azimuth_rate()) && same(a.rise(), b.rise())
        };
        match (self, other) {
            (Self::Helix(a), Self::Helix(b)) => alike(a, b),
            // a wire farther round its strand is the same wire farther along it
            (Self::DoubleHelix(a), Self::DoubleHelix(b)) => {
                alike(a.axis(), b.axis()) && same(a.radius(), b.radius()) && same(a.rate(), b.rate()) && a.rate() != 0.0
            }
            _ => false,
        }
    }

    /// The length of the course between two parameters, in units of r; negative backwards. Of a helix about a helix by Gauss's rule of
    /// three points, on steps that turn by a quarter of a radian at most.
    #[must_use]
    pub fn length(&self, from: f64, to: f64) -> f64 {
        const NODE: f64 = 0.774_596_669_241_483_4; // √(3/5)
        if self.is_uniform() {
            return to - from;
        }
        let steps = 1.0 + libm::ceil(4.0 * (to - from).abs() * self.turning());
        let h = (to - from) / steps;
        let speed = |t: f64| self.place(t).speed;
        let mut sum = 0.0;
        let mut step = 0.5;
        while step < steps {
            let (middle, off) = (from + step * h, 0.5 * NODE * h);
            sum += (5.0 * (speed(middle - off) + speed(middle + off)) + 8.0 * speed(middle)) / 18.0;
            step += 1.0;
        }
        sum * h
    }

    /// The parameter at which it passes a height.
    ///
    /// ```
    /// use nply::Handedness::Right;
    /// use nply::geometry::{Centreline, Course, DoubleHelix, HelicalAngle};
    /// let strand = Centreline::helix(6.0, HelicalAngle::new(0.3)?, Right, 0.0)?;
    /// let wire = Course::from(DoubleHelix::new(strand, 2.0, -0.15, 0.4)?);
    /// assert!((wire.place(wire.at_height(12.0)).position[2] - 12.0).abs() < 1e-12);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn at_height(&self, height: f64) -> f64 {
        const ROUNDS: u32 = 60;
        let mut t = height / self.rise();
        if self.is_uniform() {
            return t;
        }
        for _ in 0..ROUNDS {
            let place = self.place(t);
            let step = (height - place.position[2]) / (place.speed * place.tangent[2]);
            t += step;
            if step.abs() <= 3e-14 * (1.0 + t.abs()) {
                break;
            }
        }
        t
    }

    /// As [`nearest`](Self::nearest), of a point close to the course at parameter t, and from there: of a helix about a helix the foot
    /// is found much sooner.
    #[must_use]
    pub fn nearest_from(&self, point: Vector, t: f64) -> (f64, f64) {
        match self {
            Self::Helix(helix) => helix.nearest(point),
            Self::DoubleHelix(double) => double.foot(point, t),
        }
    }

    /// The stretch of t after which a screw takes the course onto itself: nothing of a helix, a turn about its strand of a helix about a helix.
    pub(super) fn period(&self) -> f64 {
        match self {
            Self::Helix(_) => 0.0,
            Self::DoubleHelix(double) => core::f64::consts::TAU / double.rate().abs(),
        }
    }

    /// The radius of a helix that lines along a tube are about as curved as, in units of r.
    pub(super) fn bend_reach(&self, radius: f64) -> f64 {
        let reach = self.outermost() + radius;
        match self {
            Self::Helix(_) => reach,
            Self::DoubleHelix(double) => {
                let about_axis = double.axis().azimuth_rate() / self.bend_turning();
                double.radius() + radius + double.axis().radius() * about_axis * about_axis
            }
        }
    }

    /// And how that helix turns, rad per t.
    pub(super) fn bend_turning(&self) -> f64 {
        match self {
            Self::Helix(helix) => helix.azimuth_rate().abs(),
            Self::DoubleHelix(double) => {
                let about_strand = (double.rate() + double.axis().torsion()).abs();
                about_strand.max(double.axis().azimuth_rate().abs()).max(f64::MIN_POSITIVE)
            }
        }
    }
}
