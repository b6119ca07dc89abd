//! What a step meets: found, located, and gone over.

use core::f64::consts::FRAC_PI_4;

use super::course::{Course, Stop};
use super::regime::Regime;
use super::station::{Event, Mark};
use super::walk::{Trace, Walk};
use crate::mechanics::Support;
use crate::numerics::linear::{Vector, dot};

/// A direction along which the share of the path does not change, but for rounding.
const NOISE: f64 = 1e-10;

impl<C: Course> Walk<'_, C> {
    /// The numbers whose change of sign is an event, with the fold's.
    pub(super) fn marks(&self, z: &Vector, ahead: &Vector) -> Vec<(Mark, f64)> {
        let mut marks = self.course.marks(self.regime, z, self.route);
        marks.extend([(Mark::Fold, ahead[3]), (Mark::Arrival, z[3] - 1.0), (Mark::Straight, z[0])]);
        marks
    }

    /// Two strands at π/4, where the radius begins to grow: the branch has a corner, at which it may turn back sharply. Goes to the
    /// other side, if this is the place; a fold if the path turns there.
    pub(super) fn round_the_corner(&mut self, trace: &mut Trace<C::Stop>) -> bool {
        const NEAR: f64 = 1e-7;
        let past = self.z[0].abs() - FRAC_PI_4;
        if past.abs() > NEAR || self.regime.support() != Support::Neighbours {
            return false;
        }
        let (side, onward) = (self.z[0].signum() * FRAC_PI_4, self.ahead[0].signum());
        let [_, y, load, along] = self.z;
        let Some(corner) = self.settled_at_angle([side, y, load, along]) else { return false };
        let Some(z) = self.settled_at_angle([side + onward * NEAR, y, load, along]) else { return false };
        self.z = z;
        let Some(ahead) = self.tangent(&z) else { return false };
        let before = self.ahead[3];
        (self.ahead, self.sense) = (ahead, 1.0);
        if ahead[0] * onward < 0.0 {
            self.turn_round();
        }
        let (station, at) = (self.station(&corner), trace.stations.len());
        if before * self.ahead[3] < 0.0 {
            let ended = trace.stations.last().is_some_and(Stop::is_stable);
            let jump = ended.then(|| self.course.landings(&station, corner[3] + before.signum() * 1e-11));
            trace.push(Event { mark: Mark::Fold, station, before: at, jump });
        }
        trace.push(Event { mark: Mark::Diagonal, station, before: at, jump: None });
        trace.stations.push(self.station(&self.z));
        true
    }

    /// Everything that happens between here and `next`, in order, up to the first change of contacts; `None` if it cannot be
    /// located in so long a step.
    pub(super) fn between(&self, next: &Vector, ahead: &Vector, step: f64) -> Option<Vec<(Mark, f64, Vector)>> {
        let (before, after) = (self.marks(&self.z, &self.ahead), self.marks(next, ahead));
        let mut found = Vec::new();
        for (i, ((mark, a), (_, b))) in before.iter().zip(&after).enumerate() {
            let crossed = match mark {
                // a contact that does not hold any more, whatever it was before
                Mark::ContactChange(_) => *b < 0.0,
                Mark::Fold if a.abs() < NOISE && b.abs() < NOISE => false,
                _ => *a < 0.0 && *b >= 0.0 || *a > 0.0 && *b <= 0.0,
            };
            if crossed {
                let (at, mut z) = self.locate(i, *b < 0.0, step, next)?;
                let at_corner =
                    self.course.strands() == 2 && *mark == Mark::Fold && (z[0].abs() - FRAC_PI_4).abs() < 1e-7;
                if *mark == Mark::Diagonal || at_corner {
                    // two strands have a corner here, next to which a step converges slowly
                    z = self.settled_at_angle([z[0].signum() * FRAC_PI_4, z[1], z[2], z[3]]).unwrap_or(z);
                }
                found.push((*mark, at, z));
            }
        }
        found.sort_by(|a, b| a.1.total_cmp(&b.1));
        let until = found.iter().position(|(mark, ..)| matches!(mark, Mark::ContactChange(_)));
        found.truncate(until.map_or(found.len(), |i| i + 1));
        Some(found)
    }

    /// Where number `i` of the marks changes sign within a step, by halving.
    pub(super) fn locate(&self, i: usize, negative_end: bool, step: f64, next: &Vector) -> Option<(f64, Vector)> {
        let (mut low, mut high, mut place) = (0.0, step, *next);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            let z = self.arrive(middle)?;
            let mut ahead = self.tangent(&z)?;
            if dot(&ahead, &self.ahead) < 0.0 {
                ahead = ahead.map(|x| -x);
            }
            let (_, value) = *self.marks(&z, &ahead).get(i)?;
            if (value < 0.0) == negative_end {
                (high, place) = (middle, z);
            } else {
                low = middle;
            }
        }
        Some((high, place))
    }

    /// Goes over to other contacts at a place, in the sense in which they hold; whether there is such a sense.
    pub(super) fn change(&mut self, support: Support, z: Vector) -> bool {
        let old = self.regime.support();
        self.regime = Regime::On(support);
        self.z = self.settled(z).unwrap_or(z);
        let Some(ahead) = self.tangent(&self.z) else { return false };
        let probe = (1e-4 * self.z[0].abs()).clamp(1e-10, 1e-6);
        // the contact that opens must open, the one that closes must press
        let watched = |walk: &Self, z: &Vector| {
            let marks = walk.course.marks(walk.regime, z, walk.route);
            marks.iter().find(|(mark, _)| *mark == Mark::ContactChange(old)).map(|(_, value)| *value)
        };
        for sense in [1.0, -1.0] {
            (self.ahead, self.sense) = (ahead.map(|x| sense * x), sense);
            let Some(probe) = self.arrive(probe) else { continue };
            if watched(self, &probe).is_some_and(|value| value > 0.0) {
                return true;
            }
        }
        false
    }

    /// Whether the branch just ahead is stable.
    pub(super) fn stable_ahead(&self) -> bool {
        self.arrive(1e-6).is_some_and(|z| self.station(&z).is_stable())
    }

    /// Whether the branch just before a place within this step is stable.
    pub(super) fn stable_before(&self, z: &Vector, at: f64) -> bool {
        let z = self.arrive((at - 1e-6).max(0.0)).unwrap_or(*z);
        self.station(&z).is_stable()
    }
}
