//! What the walk asks of the states it follows, whatever strands they are made of.

use super::regime::Regime;
use super::station::Mark;
use super::walk::End;
use super::{Route, Station};
use crate::Handedness;
use crate::mechanics::{Stability, Support};
use crate::numerics::linear::Vector;

/// A state on the way, as the walk looks at it.
pub(in crate::mechanics) trait Stop: Copy {
    fn along(&self) -> f64;
    fn put_along(&mut self, along: f64);
    /// εθ
    fn signed_angle(&self) -> f64;
    /// ε sin θ/ρ, of stretched strands per unstretched length
    fn turned(&self) -> f64;
    fn stability(&self) -> Option<Stability>;

    /// Whether two are the same place, to rounding.
    fn is_at(&self, other: &Self) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
        near(self.along(), other.along())
            && near(self.signed_angle(), other.signed_angle())
            && near(self.turned(), other.turned())
    }

    fn is_stable(&self) -> bool {
        self.stability() == Some(Stability::Stable)
    }
}

impl Stop for Station {
    fn along(&self) -> f64 {
        self.along
    }

    fn put_along(&mut self, along: f64) {
        self.along = along;
    }

    fn signed_angle(&self) -> f64 {
        self.handedness.sign() * self.angle.radians()
    }

    fn turned(&self) -> f64 {
        self.rotation()
    }

    fn stability(&self) -> Option<Stability> {
        self.stability
    }
}

/// States along a path of data: three equations between four coordinates, which are Θ = εθ, the ply's rotation Y = ε λ sin θ/ρ, a third by
/// the kind of strands, and the share of the path.
pub(in crate::mechanics) trait Course {
    type Stop: Stop;

    /// n
    fn strands(&self) -> u32;

    /// Values and rows of the three equations of a regime.
    fn equations(&self, regime: Regime, z: &Vector) -> ([f64; 3], [Vector; 3]);

    /// What may happen in a regime: each mark with a number whose change of sign is the event. Contacts change where theirs,
    /// positive as long as they hold, turns negative.
    fn marks(&self, regime: Regime, z: &Vector, route: &Route) -> Vec<(Mark, f64)>;

    fn station(&self, regime: Regime, z: &Vector) -> Self::Stop;

    /// The states at the data of a share of the path.
    fn states_at(&self, along: f64) -> Vec<Self::Stop>;

    /// Whether the third coordinate is where no walk goes on.
    fn outside(&self, z: &Vector) -> Option<End>;

    /// Whether the third coordinate has run away.
    fn unbounded(&self, z: &Vector) -> bool;

    /// Whether contacts and held ends leave no motion, so that loads grow without bound where the path turns.
    fn locked(&self, regime: Regime) -> bool;

    /// Stable states at the data just past a place, nearest angle first.
    fn landings(&self, from: &Self::Stop, along: f64) -> Vec<Self::Stop> {
        let mut stops = self.states_at(along);
        // straight strands, flat rings, and what rounding leaves of the state itself, are no place to jump to
        let between = |s: &Self::Stop| {
            let angle = s.signed_angle().abs();
            angle > 1e-6 && core::f64::consts::FRAC_PI_2 - angle > 1e-6
        };
        stops.retain(|s| s.is_stable() && between(s) && !s.is_at(from));
        stops.iter_mut().for_each(|stop| stop.put_along(along));
        let far = |s: &Self::Stop| (s.signed_angle() - from.signed_angle()).abs();
        stops.sort_by(|a, b| far(a).total_cmp(&far(b)));
        stops
    }
}

/// The hand of a signed angle.
pub(in crate::mechanics) fn hand(signed: f64) -> Handedness {
    if signed < 0.0 { Handedness::Left } else { Handedness::Right }
}

/// Whether strands touch their neighbours.
pub(in crate::mechanics) const fn touch(support: Support) -> bool {
    matches!(support, Support::Neighbours | Support::Both)
}
