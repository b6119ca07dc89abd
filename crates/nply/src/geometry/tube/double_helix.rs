//! A helix about a helix: a wire in an outer strand of a rope.

use super::Place;
use crate::geometry::centreline::turn_between;
use crate::geometry::{Centreline, Vector};
use crate::numerics::foot;
use crate::numerics::vector::{cross, dot};
use crate::{DomainError, geometry::FrenetFrame};

/// A wire that winds about a strand, which winds about the ply's axis.
///
/// Run through by the arclength S of the strand's centreline: at S the wire stands at the angle φ₀ + λS round the strand, counted from the
/// strand's normal towards its binormal, at the radius a. With the strand's κ and τ its speed is ((1 − aκ cos φ)² + a²(λ + τ)²)^½.
///
/// ```
/// use nply::Handedness::Right;
/// use nply::geometry::{Centreline, DoubleHelix, HelicalAngle};
/// let strand = Centreline::helix(6.0, HelicalAngle::new(0.3)?, Right, 0.0)?;
/// let wire = DoubleHelix::new(strand, 2.0, -0.15, 0.0)?; // Lang's or ordinary lay: the sign says
/// let (point, middle) = (wire.place(4.0).position, strand.position(4.0));
/// let distance = (0..3).map(|i| (point[i] - middle[i]).powi(2)).sum::<f64>().sqrt();
/// assert!((distance - 2.0).abs() < 1e-14);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleHelix {
    axis: Centreline,
    radius: f64,
    rate: f64,
    phase: f64,
}

impl DoubleHelix {
    /// From the strand's centreline, the wire's helix radius about it in units of r, λ = dφ/dS in rad per r and φ₀ in rad.
    ///
    /// # Errors
    /// [`DomainError`] on `radius_ratio` unless it is at least 0 and less than the strand's radius of curvature; on `azimuth_rate` or
    /// `azimuth` unless they are finite.
    pub fn new(axis: Centreline, radius: f64, rate: f64, phase: f64) -> Result<Self, DomainError> {
        DomainError::check(
            (0.0..f64::INFINITY).contains(&radius) && radius * axis.curvature() < 1.0,
            "radius_ratio",
            radius,
            "at least 0 and less than the radius of curvature of the strand it winds about",
        )?;
        DomainError::check(rate.is_finite(), "azimuth_rate", rate, "finite")?;
        DomainError::check(phase.is_finite(), "azimuth", phase, "finite")?;
        Ok(Self { axis, radius, rate, phase })
    }

    /// The centreline of the strand.
    #[must_use]
    pub const fn axis(&self) -> &Centreline {
        &self.axis
    }

    /// The wire's helix radius about the strand, in units of r.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// λ = dφ/dS, rad per r.
    #[must_use]
    pub const fn rate(&self) -> f64 {
        self.rate
    }

    /// φ₀, rad.
    #[must_use]
    pub const fn phase(&self) -> f64 {
        self.phase
    }

    /// The place at strand arclength S.
    #[must_use]
    pub fn place(&self, s: f64) -> Place {
        let FrenetFrame { tangent, normal, binormal } = self.axis.frame(s);
        let (sin, cos) = libm::sincos(self.rate * s + self.phase);
        let along = |[t, n, b]: [f64; 3]| -> Vector {
            core::array::from_fn(|i| t * tangent[i] + n * normal[i] + b * binormal[i])
        };
        let out = along([0.0, cos, sin]);
        let start = self.axis.position(s);
        let ahead = 1.0 - self.radius * self.axis.curvature() * cos;
        let round = self.radius * (self.rate + self.axis.torsion());
        let speed = libm::sqrt(ahead * ahead + round * round);
        let inward = along([0.0, -cos, -sin]);
        let course = along([ahead / speed, -round * sin / speed, round * cos / speed]);
        Place {
            position: core::array::from_fn(|i| start[i] + self.radius * out[i]),
            tangent: course,
            inward,
            binormal: cross(course, inward),
            speed,
        }
    }

    /// S of the point nearest to a point in space, and the distance to it.
    ///
    /// The strand is taken for straight first, which makes it Kepler's equation again, from the two turns of the wire on either side;
    /// Newton's method then finds the feet on the wire as it is.
    #[must_use]
    pub fn nearest(&self, point: Vector) -> (f64, f64) {
        let (level, _) = self.axis.nearest(point);
        let frame = self.axis.frame(level);
        let from = self.axis.position(level);
        let off: Vector = core::array::from_fn(|i| point[i] - from[i]);
        let (n, b) = (dot(off, frame.normal), dot(off, frame.binormal));
        let (off_axis, phi) = (libm::hypot(n, b), libm::atan2(b, n));
        let mean = turn_between(self.rate * level + self.phase - phi);
        let starts = if self.rate == 0.0 {
            [level; 2]
        } else {
            let pitch = self.rate + self.axis.torsion();
            [mean, mean - core::f64::consts::TAU.copysign(mean)].map(|mean| {
                let inside = mean.abs().min(core::f64::consts::PI);
                let anomaly = foot::anomaly(off_axis * self.radius * pitch * pitch, inside).copysign(mean);
                level + (anomaly - mean) / self.rate
            })
        };
        let found = starts.map(|start| self.foot(point, start));
        if found[1].1 < found[0].1 { found[1] } else { found[0] }
    }

    /// The foot of the perpendicular from a point, from a start close to it.
    pub(super) fn foot(&self, point: Vector, start: f64) -> (f64, f64) {
        const STEPS: u32 = 40;
        const SETTLED: f64 = 1e-9; // the distance is settled to the square of this
        const NUDGE: f64 = 1e-4;
        let slope = |s: f64| {
            let place = self.place(s);
            let off: Vector = core::array::from_fn(|i| place.position[i] - point[i]);
            (place.speed * dot(off, place.tangent), place.speed * place.speed, dot(off, off))
        };
        let (mut s, mut best) = (start, slope(start));
        for _ in 0..STEPS {
            let bend = (slope(s + NUDGE).0 - slope(s - NUDGE).0) / (2.0 * NUDGE);
            // where the distance is no valley, the way down is still the gradient's
            let mut step = -best.0 / if bend > 0.1 * best.1 { bend } else { best.1 };
            let mut next = slope(s + step);
            while next.2 > best.2 && step.abs() > SETTLED {
                step *= 0.5;
                next = slope(s + step);
            }
            if step.abs() <= SETTLED {
                break;
            }
            (s, best) = (s + step, next);
        }
        (s, libm::sqrt(best.2))
    }
}
