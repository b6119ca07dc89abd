//! One step along the branch: predictor, corrector, direction.

use core::f64::consts::FRAC_PI_4;

use super::course::Course;
use super::regime::Regime;
use super::walk::Walk;
use crate::mechanics::Support;
use crate::numerics::linear::{Vector, direction, dot, solve};
/// A turn of the direction (cosine) that asks for a shorter step.
const STRAIGHT_ON: f64 = 0.985;

impl<C: Course> Walk<'_, C> {
    pub(super) fn station(&self, z: &Vector) -> C::Stop {
        self.course.station(self.regime, z)
    }

    /// Values and rows of the three equations.
    pub(super) fn equations(&self, z: &Vector) -> ([f64; 3], [Vector; 3]) {
        self.course.equations(self.regime, z)
    }

    pub(super) fn tangent(&self, z: &Vector) -> Option<Vector> {
        direction(&self.equations(z).1)
    }

    /// The place on the branch at a distance along `ahead`.
    pub(super) fn arrive(&self, step: f64) -> Option<Vector> {
        let mut z: Vector = core::array::from_fn(|i| self.z[i] + step * self.ahead[i]);
        let mut last = f64::INFINITY;
        for _ in 0..12 {
            let (values, rows) = self.equations(&z);
            let gone: f64 = (0..4).map(|i| (z[i] - self.z[i]) * self.ahead[i]).sum();
            let right = [-values[0], -values[1], -values[2], step - gone];
            let delta = solve([rows[0], rows[1], rows[2], self.ahead], right)?;
            z = core::array::from_fn(|i| z[i] + delta[i]);
            let size = libm::sqrt(dot(&delta, &delta));
            if size <= 1e-15 || size < 1e-9 && size >= 0.25 * last {
                return Some(z);
            }
            last = size;
        }
        None
    }

    /// A state in equilibrium near a place, at the same share of the path.
    pub(super) fn settled(&self, z: Vector) -> Option<Vector> {
        self.settled_at(z, [0.0, 0.0, 0.0, 1.0])
    }

    /// A state in equilibrium near a place, at the same angle.
    pub(super) fn settled_at_angle(&self, z: Vector) -> Option<Vector> {
        self.settled_at(z, [1.0, 0.0, 0.0, 0.0])
    }

    /// A state in equilibrium near a place, with one coordinate kept; where that does not fix it, the nearest.
    pub(super) fn settled_at(&self, mut z: Vector, kept: Vector) -> Option<Vector> {
        for _ in 0..12 {
            let (values, rows) = self.equations(&z);
            let right = [-values[0], -values[1], -values[2], 0.0];
            let delta = solve([rows[0], rows[1], rows[2], kept], right)
                .or_else(|| solve([rows[0], rows[1], rows[2], direction(&rows)?], right))?;
            z = core::array::from_fn(|i| z[i] + delta[i]);
            if libm::sqrt(dot(&delta, &delta)) < 1e-12 {
                return Some(z);
            }
        }
        None
    }

    pub(super) fn turn_round(&mut self) {
        self.ahead = self.ahead.map(|x| -x);
        self.sense = -self.sense;
    }

    /// The direction at a place, in the sense of the walk.
    pub(super) fn onward(&self, z: &Vector) -> Option<Vector> {
        self.tangent(z).map(|ahead| ahead.map(|x| self.sense * x))
    }

    /// The next place and the direction there, if the step is short enough for the branch's bends.
    pub(super) fn stride(&mut self, step: f64) -> Option<(Vector, Vector)> {
        let next = self.arrive(step)?;
        let free = self.regime == Regime::On(Support::Free);
        let shared = self.regime == Regime::On(Support::Both);
        if free && next[0] * next[1] <= 0.0 || (free || shared) && next[0] * self.z[0] < 0.0 {
            return None; // helices that would turn through each other, or through straight strands
        }
        let ahead = self.onward(&next)?;
        let along = dot(&ahead, &self.ahead);
        if along > STRAIGHT_ON {
            return Some((next, ahead));
        }
        if along < -STRAIGHT_ON {
            // where branches cross the sense changes, and the walk goes straight on; another branch would lie aside
            let aside = (0..4).map(|i| (next[i] - self.z[i] - step * self.ahead[i]).abs()).fold(0.0, f64::max);
            let corner =
                (self.z[0].abs() - FRAC_PI_4) * (next[0].abs() - FRAC_PI_4) <= 0.0 && self.course.strands() == 2;
            return (aside < 1e-3 * step && !corner).then(|| {
                self.sense = -self.sense;
                (next, ahead.map(|x| -x))
            });
        }
        // at a corner of the branch no step is short enough
        (step < 1e-8).then_some((next, ahead))
    }
}
