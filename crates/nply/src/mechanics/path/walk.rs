//! Predictor and corrector by arc length, with everything that happens between two steps located.

use super::regime::{FLATTEST, Regime};
use super::station::{Event, Mark, Station};
use super::{Contacts, Path, Route};
use crate::DomainError;
use crate::mechanics::{Stability, Support};
use crate::numerics::linear::Vector;

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
    pub(super) fn push(&mut self, event: Event) {
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
    pub(super) fn landings(&self, from: &Station, along: f64) -> Vec<Station> {
        let past = Self { from: self.data(along), to: self.to, ..*self };
        let mut stations = past.starts().unwrap_or_default();
        // straight strands, flat rings, and what rounding leaves of the state itself, are no place to jump to
        let between = |s: &Station| s.angle.radians() > 1e-6 && s.angle.pitch_angle() > 1e-6;
        stations.retain(|s| s.stability == Some(Stability::Stable) && between(s) && !s.is_at(from));
        let signed = |station: &Station| station.handedness.sign() * station.angle.radians();
        stations.iter_mut().for_each(|station| station.along = along);
        stations.sort_by(|a, b| (signed(a) - signed(from)).abs().total_cmp(&(signed(b) - signed(from)).abs()));
        stations
    }
}

/// A walk in progress.
pub(super) struct Walk<'a> {
    pub(super) path: &'a Path,
    pub(super) route: &'a Route,
    /// the size of the found load's coordinate
    pub(super) unit: f64,
    pub(super) regime: Regime,
    pub(super) z: Vector,
    /// the direction of the branch, on in the sense of the walk
    pub(super) ahead: Vector,
    /// whether the walk goes in the sense of [`direction`] (1.0) or against it (−1.0): the same all along a branch, so that a step onto
    /// another one shows
    pub(super) sense: f64,
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
}
