//! The paper's strands, which do not stretch, as a course: the third coordinate is the load that is found where a displacement is held.

use super::course::Course;
use super::regime::{Here, Regime};
use super::station::Mark;
use super::walk::{End, Trace, Walk};
use super::{Contacts, Path, Route, Station};
use crate::DomainError;
use crate::numerics::linear::Vector;

/// A found load of 10⁹ times the size of the loads on the path is without bound: its area hyperbolic sine.
const UNBOUNDED: f64 = 21.4;

impl Path {
    /// Follows the branch from a start on it, by pseudo-arclength continuation.
    ///
    /// # Errors
    /// [`DomainError`] on `step`, `window`, `curvature_limit`, `strain_limit`, and on `start` if it is no state of this path.
    pub fn trace(&self, start: &Station, route: &Route) -> Result<Trace, DomainError> {
        let regime = match self.contacts {
            Contacts::Unilateral => Regime::On(start.support),
            Contacts::Kept(balance) => Regime::Kept(balance),
        };
        let course = Stiff { path: self, unit: self.load_unit(start) };
        let place = [start.handedness.sign() * start.angle.radians(), start.rotation()];
        let mut z = self.coordinates(place, start.load);
        z[2] = libm::asinh(z[2] / course.unit);
        Walk::from(&course, route, regime, z)
    }

    /// The size of loads on this path, so that a step in a found load is of the size of other steps.
    fn load_unit(&self, start: &Station) -> f64 {
        let size = |data: &super::Data| data.ends.given().force.abs() + data.ends.given().moment.abs();
        1.0 + size(&self.from).max(size(&self.to)) + start.load.force.abs() + start.load.moment.abs()
    }
}

/// A path with the size of the found load's coordinate.
struct Stiff<'a> {
    path: &'a Path,
    unit: f64,
}

impl Stiff<'_> {
    /// Coordinates with the found load itself: loads of the size of those on the path are walked evenly, larger ones by their order of
    /// magnitude.
    fn physical(&self, z: &Vector) -> Vector {
        [z[0], z[1], libm::sinh(z[2]) * self.unit, z[3]]
    }

    fn here(&self, z: &Vector) -> Here {
        Here::new(self.path, self.physical(z))
    }
}

impl Course for Stiff<'_> {
    type Stop = Station;

    fn strands(&self) -> u32 {
        self.path.strands
    }

    fn equations(&self, regime: Regime, z: &Vector) -> ([f64; 3], [Vector; 3]) {
        let equations = self.here(z).equations(regime);
        let values = [0, 1, 2].map(|i| equations[i].value);
        let unit = libm::cosh(z[2]) * self.unit;
        let rows = equations.map(|e| [e.slopes[0], e.slopes[1], e.slopes[2] * unit, e.slopes[3]]);
        (values, rows)
    }

    fn marks(&self, regime: Regime, z: &Vector, route: &Route) -> Vec<(Mark, f64)> {
        self.here(z).marks(regime, route)
    }

    fn station(&self, regime: Regime, z: &Vector) -> Station {
        self.path.station(regime, self.physical(z))
    }

    fn states_at(&self, along: f64) -> Vec<Station> {
        Path { from: self.path.data(along), ..*self.path }.starts().unwrap_or_default()
    }

    fn outside(&self, _: &Vector) -> Option<End> {
        None
    }

    fn unbounded(&self, z: &Vector) -> bool {
        z[2].abs() > UNBOUNDED
    }

    /// Never: the load that is found is walked along.
    fn locked(&self, _: Regime) -> bool {
        false
    }
}
