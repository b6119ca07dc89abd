//! Predictor and corrector by arc length, with everything that happens between two steps located.

use core::f64::consts::FRAC_PI_4;

use super::regime::{FLATTEST, Here, Regime};
use super::station::{Event, Mark, Station};
use super::{Contacts, Path, Route};
use crate::DomainError;
use crate::mechanics::{Stability, Support};
use crate::numerics::linear::{Vector, direction, dot, solve};

/// A branch, from a start to where the walk ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// States along the branch, in order; the first is the start.
    pub stations: Vec<Station>,
    /// What happened between them, in order.
    pub events: Vec<Event>,
    /// Why the walk ended.
    pub end: End,
}

impl Trace {
    /// Adds an event, if it is not the last one seen again.
    fn push(&mut self, event: Event) {
        let same = |last: &Event| last.mark == event.mark && last.station.is_at(&event.station) && event.jump.is_none();
        if !self.events.last().is_some_and(same) {
            self.events.push(event);
        }
    }

    /// Whether a station is where the last one is.
    fn near_last(&self, station: &Station) -> bool {
        self.stations.last().is_some_and(|last| last.is_at(station))
    }
}

/// Why a walk ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// At the far end of the path.
    Arrival,
    /// The branch left the stretch that may be walked on, such as back through its beginning after a fold.
    LeftWindow,
    /// The strands lie as flat rings, π/2 − θ < 1e-9.
    FlatRings,
    /// Free helices open without bound: ρ > 1e6.
    Apart,
    /// The load that holds the displacement grows beyond all bounds.
    UnboundedLoad,
    /// Shorter and shorter steps, or a great many of them, went no further.
    Stalled,
}

impl End {
    /// The name used in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Arrival => "arrival",
            Self::LeftWindow => "left_window",
            Self::FlatRings => "flat_rings",
            Self::Apart => "apart",
            Self::UnboundedLoad => "unbounded_load",
            Self::Stalled => "stalled",
        }
    }
}

/// The shortest step, and the most of them.
const SHORTEST: f64 = 1e-11;
const MOST_STEPS: usize = 100_000;
/// Changes of contacts in one place before the walk gives up.
const MOST_CHANGES: usize = 4;
/// A found load of 10⁹ times the size of the loads on the path is without bound: its area hyperbolic sine.
const UNBOUNDED: f64 = 21.4;
/// A direction along which the share of the path does not change, but for rounding.
const NOISE: f64 = 1e-10;
/// A turn of the direction (cosine) that asks for a shorter step.
const STRAIGHT_ON: f64 = 0.985;

impl Path {
    /// Follows the branch from a start on it, by pseudo-arclength continuation.
    ///
    /// # Errors
    /// [`DomainError`] on `step`, `window`, `curvature_limit`, and on `start` if it is no state of this path.
    pub fn trace(&self, start: &Station, route: &Route) -> Result<Trace, DomainError> {
        let (low, high) = route.window;
        DomainError::check(
            low <= 0.0 && high >= 1.0 && high - low < 1e9,
            "window",
            low,
            "from at most 0 to at least 1",
        )?;
        DomainError::check((1e-6..=0.2).contains(&route.step), "step", route.step, "between 1e-6 and 0.2")?;
        if let Some(limit) = route.curvature_limit {
            DomainError::check(limit > 0.0, "curvature_limit", limit, "greater than 0")?;
        }
        let regime = match self.contacts {
            Contacts::Unilateral => Regime::On(start.support),
            Contacts::Kept(balance) => Regime::Kept(balance),
        };
        let unit = self.load_unit(start);
        let place = [start.handedness.sign() * start.angle.radians(), start.rotation()];
        let mut walk = Walk {
            path: self,
            route,
            unit,
            regime,
            z: self.coordinates(place, start.load),
            ahead: [0.0; 4],
            sense: 1.0,
        };
        walk.z[2] = libm::asinh(walk.z[2] / unit);
        let refused = |what| DomainError { quantity: "start", value: start.angle.radians(), allowed: what };
        walk.z = walk.settled(walk.z).ok_or_else(|| refused("a state in equilibrium at the beginning of the path"))?;
        walk.ahead = walk.tangent(&walk.z).ok_or_else(|| refused("a state from which the path leads on"))?;
        if walk.ahead[3] < 0.0 {
            walk.turn_round();
        }
        Ok(walk.run())
    }

    /// The size of loads on this path, so that a step in a found load is of the size of other steps.
    fn load_unit(&self, start: &Station) -> f64 {
        let size = |data: &super::Data| data.ends.given().force.abs() + data.ends.given().moment.abs();
        1.0 + size(&self.from).max(size(&self.to)) + start.load.force.abs() + start.load.moment.abs()
    }

    /// Stable states at the data just past a place, nearest angle first.
    fn landings(&self, from: &Station, along: f64) -> Vec<Station> {
        let past = Self { from: self.data(along), to: self.to, ..*self };
        let mut stations = past.starts().unwrap_or_default();
        // straight strands, and what rounding leaves of the state itself, are no place to jump to
        stations.retain(|s| s.stability == Some(Stability::Stable) && s.angle.radians() > 1e-6 && !s.is_at(from));
        let signed = |station: &Station| station.handedness.sign() * station.angle.radians();
        stations.iter_mut().for_each(|station| station.along = along);
        stations.sort_by(|a, b| (signed(a) - signed(from)).abs().total_cmp(&(signed(b) - signed(from)).abs()));
        stations
    }
}

/// A walk in progress.
struct Walk<'a> {
    path: &'a Path,
    route: &'a Route,
    /// the size of the found load's coordinate
    unit: f64,
    regime: Regime,
    z: Vector,
    /// the direction of the branch, on in the sense of the walk
    ahead: Vector,
    /// whether the walk goes in the sense of [`direction`] (1.0) or against it (−1.0): the same all along a branch, so that a step onto
    /// another one shows
    sense: f64,
}

impl Walk<'_> {
    fn run(mut self) -> Trace {
        let mut trace = Trace { stations: vec![self.station(&self.z)], events: Vec::new(), end: End::Stalled };
        let (mut step, mut changes_here) = (0.25 * self.route.step, 0);
        for _ in 0..MOST_STEPS {
            let stride = self.stride(step).and_then(|(z, ahead)| Some((z, ahead, self.between(&z, &ahead, step)?)));
            let Some((next, ahead, mut found)) = stride else {
                step *= 0.5;
                if step < SHORTEST {
                    if self.path.strands == 2 && self.round_the_corner(&mut trace) {
                        step = 0.25 * self.route.step;
                        continue;
                    }
                    // helices that had to turn through straight strands that lean
                    if self.regime == Regime::On(Support::Free) && self.z[1].abs() < 1e-3 * libm::sin(self.z[0].abs()) {
                        trace.end = End::Apart;
                    }
                    return trace;
                }
                continue;
            };
            let border = self.border(&next, step);
            if let Some((at, _)) = border {
                found.retain(|event| event.1 <= at);
            }
            let mut changed = false;
            for (mark, at, z) in found {
                let station = self.station(&z);
                let before = trace.stations.len();
                let past = z[3] + self.ahead[3].signum() * 1e-11;
                let stable = trace.stations.last().is_some_and(|last| last.stability == Some(Stability::Stable));
                let (ended, barred) = match mark {
                    Mark::ContactChange(support) => {
                        changed = true;
                        let barred = !self.change(support, z);
                        (stable && (barred || !self.stable_ahead()), barred)
                    }
                    Mark::Fold => (self.stable_before(&z, at), false),
                    Mark::Buckling => (stable, false),
                    _ => (false, false),
                };
                let jump = ended.then(|| self.path.landings(&station, past));
                trace.push(Event { mark, station, before, jump });
                if barred || mark == Mark::Arrival && self.route.stop_at_arrival {
                    trace.stations.push(station);
                    trace.end = if barred { End::Stalled } else { End::Arrival };
                    return trace;
                }
            }
            if changed {
                changes_here = if trace.near_last(&self.station(&self.z)) { changes_here + 1 } else { 0 };
                trace.stations.push(self.station(&self.z));
                if changes_here > MOST_CHANGES {
                    return trace; // contacts that open and close on the spot
                }
                step = 0.25 * self.route.step;
                continue;
            }
            if let Some((_, z)) = border {
                trace.stations.push(self.station(&z));
                trace.end = End::LeftWindow;
                return trace;
            }
            (self.z, self.ahead) = (next, ahead);
            trace.stations.push(self.station(&self.z));
            if let Some(end) = self.ended() {
                trace.end = end;
                return trace;
            }
            step = (1.5 * step).min(self.route.step);
        }
        trace
    }

    /// Where a step leaves the stretch that may be walked on, if it does.
    fn border(&self, next: &Vector, step: f64) -> Option<(f64, Vector)> {
        let (low, high) = self.route.window;
        if (low..=high).contains(&next[3]) {
            return None;
        }
        let limit = if next[3] < low { low } else { high };
        let beyond = |z: &Vector| (z[3] < limit) == (next[3] < limit);
        let (mut inside, mut outside, mut place) = (0.0, step, *next);
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            match self.arrive(middle) {
                Some(z) if beyond(&z) => (outside, place) = (middle, z),
                _ => inside = middle,
            }
        }
        Some((outside, place))
    }

    fn ended(&self) -> Option<End> {
        let [signed, rotation, load, _] = self.z;
        if signed.abs() >= FLATTEST {
            Some(End::FlatRings)
        } else if self.regime.support() == Support::Free && rotation * signed.signum() < 1e-6 * libm::sin(signed.abs())
        {
            Some(End::Apart)
        } else if load.abs() > UNBOUNDED {
            Some(End::UnboundedLoad)
        } else {
            None
        }
    }

    fn station(&self, z: &Vector) -> Station {
        self.path.station(self.regime, self.physical(z))
    }

    /// Coordinates with the found load itself: loads of the size of those on the path are walked evenly, larger ones by their order of
    /// magnitude.
    fn physical(&self, z: &Vector) -> Vector {
        [z[0], z[1], libm::sinh(z[2]) * self.unit, z[3]]
    }

    fn here(&self, z: &Vector) -> Here {
        Here::new(self.path, self.physical(z))
    }

    /// Values and rows of the three equations.
    fn equations(&self, z: &Vector) -> ([f64; 3], [Vector; 3]) {
        let equations = self.here(z).equations(self.regime);
        let values = [0, 1, 2].map(|i| equations[i].value);
        let unit = libm::cosh(z[2]) * self.unit;
        let rows = equations.map(|e| [e.slopes[0], e.slopes[1], e.slopes[2] * unit, e.slopes[3]]);
        (values, rows)
    }

    fn tangent(&self, z: &Vector) -> Option<Vector> {
        direction(&self.equations(z).1)
    }

    /// The place on the branch at a distance along `ahead`.
    fn arrive(&self, step: f64) -> Option<Vector> {
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
    fn settled(&self, z: Vector) -> Option<Vector> {
        self.settled_at(z, [0.0, 0.0, 0.0, 1.0])
    }

    /// A state in equilibrium near a place, at the same angle.
    fn settled_at_angle(&self, z: Vector) -> Option<Vector> {
        self.settled_at(z, [1.0, 0.0, 0.0, 0.0])
    }

    /// A state in equilibrium near a place, with one coordinate kept; where that does not fix it, the nearest.
    fn settled_at(&self, mut z: Vector, kept: Vector) -> Option<Vector> {
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

    fn turn_round(&mut self) {
        self.ahead = self.ahead.map(|x| -x);
        self.sense = -self.sense;
    }

    /// The direction at a place, in the sense of the walk.
    fn onward(&self, z: &Vector) -> Option<Vector> {
        self.tangent(z).map(|ahead| ahead.map(|x| self.sense * x))
    }

    /// The next place and the direction there, if the step is short enough for the branch's bends.
    fn stride(&mut self, step: f64) -> Option<(Vector, Vector)> {
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
            let corner = (self.z[0].abs() - FRAC_PI_4) * (next[0].abs() - FRAC_PI_4) <= 0.0 && self.path.strands == 2;
            return (aside < 1e-3 * step && !corner).then(|| {
                self.sense = -self.sense;
                (next, ahead.map(|x| -x))
            });
        }
        // at a corner of the branch no step is short enough
        (step < 1e-8).then_some((next, ahead))
    }

    /// The numbers whose change of sign is an event, with the fold's.
    fn marks(&self, z: &Vector, ahead: &Vector) -> Vec<(Mark, f64)> {
        let mut marks = self.here(z).marks(self.regime, self.route.curvature_limit);
        marks.extend([(Mark::Fold, ahead[3]), (Mark::Arrival, z[3] - 1.0), (Mark::Straight, z[0])]);
        marks
    }

    /// Two strands at π/4, where the radius begins to grow: the branch has a corner, at which it may turn back sharply. Goes to the
    /// other side, if this is the place; a fold if the path turns there.
    fn round_the_corner(&mut self, trace: &mut Trace) -> bool {
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
            let ended = trace.stations.last().is_some_and(|last| last.stability == Some(Stability::Stable));
            let jump = ended.then(|| self.path.landings(&station, corner[3] + before.signum() * 1e-11));
            trace.push(Event { mark: Mark::Fold, station, before: at, jump });
        }
        trace.push(Event { mark: Mark::Diagonal, station, before: at, jump: None });
        trace.stations.push(self.station(&self.z));
        true
    }

    /// Everything that happens between here and `next`, in order, up to the first change of contacts; `None` if it cannot be
    /// located in so long a step.
    fn between(&self, next: &Vector, ahead: &Vector, step: f64) -> Option<Vec<(Mark, f64, Vector)>> {
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
                let at_corner = self.path.strands == 2 && *mark == Mark::Fold && (z[0].abs() - FRAC_PI_4).abs() < 1e-7;
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
    fn locate(&self, i: usize, negative_end: bool, step: f64, next: &Vector) -> Option<(f64, Vector)> {
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
    fn change(&mut self, support: Support, z: Vector) -> bool {
        let old = self.regime.support();
        self.regime = Regime::On(support);
        self.z = self.settled(z).unwrap_or(z);
        let Some(ahead) = self.tangent(&self.z) else { return false };
        let probe = (1e-4 * self.z[0].abs()).clamp(1e-10, 1e-6);
        // the contact that opens must open, the one that closes must press
        let watched = |walk: &Self, z: &Vector| {
            let marks = walk.here(z).marks(walk.regime, None);
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
    fn stable_ahead(&self) -> bool {
        self.arrive(1e-6).is_some_and(|z| self.station(&z).stability == Some(Stability::Stable))
    }

    /// Whether the branch just before a place within this step is stable.
    fn stable_before(&self, z: &Vector, at: f64) -> bool {
        let z = self.arrive((at - 1e-6).max(0.0)).unwrap_or(*z);
        self.station(&z).stability == Some(Stability::Stable)
    }
}
