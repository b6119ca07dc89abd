//! Predictor and corrector by arc length, with everything that happens between two steps located.

use super::Route;
use super::course::{Course, Stop};
use super::regime::{FLATTEST, Regime};
use super::station::{Event, Mark, Station};
use crate::DomainError;
use crate::mechanics::Support;
use crate::numerics::linear::Vector;

/// A branch, from a start to where the walk ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace<S = Station> {
    /// States along the branch, in order; the first is the start.
    pub stations: Vec<S>,
    /// What happened between them, in order.
    pub events: Vec<Event<S>>,
    /// Why the walk ended.
    pub end: End,
}

impl<S> Trace<S> {
    /// Adds an event, if it is not the last one seen again.
    pub(super) fn push(&mut self, event: Event<S>)
    where
        S: Stop,
    {
        let same =
            |last: &Event<S>| last.mark == event.mark && last.station.is_at(&event.station) && event.jump.is_none();
        if !self.events.last().is_some_and(same) {
            self.events.push(event);
        }
    }

    /// Whether a station is where the last one is.
    fn near_last(&self, station: &S) -> bool
    where
        S: Stop,
    {
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
    /// Strands are stretched to less than half or more than double their length: linear elasticity means nothing there.
    Overstretched,
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
            Self::Overstretched => "overstretched",
            Self::Stalled => "stalled",
        }
    }
}

/// The shortest step, and the most of them.
const SHORTEST: f64 = 1e-11;
const MOST_STEPS: usize = 100_000;
/// Changes of contacts in one place before the walk gives up.
const MOST_CHANGES: usize = 4;

/// A walk in progress.
pub(in crate::mechanics) struct Walk<'a, C> {
    pub(super) course: &'a C,
    pub(super) route: &'a Route,
    pub(super) regime: Regime,
    pub(super) z: Vector,
    /// the direction of the branch, on in the sense of the walk
    pub(super) ahead: Vector,
    /// whether the walk goes in the sense of [`direction`] (1.0) or against it (−1.0): the same all along a branch, so that a step onto
    /// another one shows
    pub(super) sense: f64,
}

impl<'a, C: Course> Walk<'a, C> {
    /// Follows the branch from a start on it, by pseudo-arclength continuation; `at` is its helical angle.
    ///
    /// # Errors
    /// [`DomainError`] on the route, and on `start` if it is no state of this course.
    pub(in crate::mechanics) fn from(
        course: &'a C,
        route: &'a Route,
        regime: Regime,
        z: Vector,
    ) -> Result<Trace<C::Stop>, DomainError> {
        route.check()?;
        let refused = |what| DomainError { quantity: "start", value: z[0].abs(), allowed: what };
        let mut walk = Self { course, route, regime, z, ahead: [0.0; 4], sense: 1.0 };
        walk.z = walk.settled(z).ok_or_else(|| refused("a state in equilibrium at the beginning of the path"))?;
        walk.ahead = walk.tangent(&walk.z).ok_or_else(|| refused("a state from which the path leads on"))?;
        if walk.ahead[3] < 0.0 {
            walk.turn_round();
        }
        Ok(walk.run())
    }

    fn run(mut self) -> Trace<C::Stop> {
        let mut trace = Trace { stations: vec![self.station(&self.z)], events: Vec::new(), end: End::Stalled };
        let (mut step, mut changes_here) = (0.25 * self.route.step, 0);
        for _ in 0..MOST_STEPS {
            let stride = self.stride(step).and_then(|(z, ahead)| Some((z, ahead, self.between(&z, &ahead, step)?)));
            let Some((next, ahead, mut found)) = stride else {
                step *= 0.5;
                if step < SHORTEST {
                    if self.course.strands() == 2 && self.round_the_corner(&mut trace) {
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
            if let Some((at, ..)) = border {
                found.retain(|event| event.1 <= at);
            }
            let mut changed = false;
            for (mark, at, z) in found {
                if mark == Mark::Fold && self.course.locked(self.regime) {
                    trace.end = End::UnboundedLoad;
                    return trace;
                }
                let station = self.station(&z);
                let before = trace.stations.len();
                let past = z[3] + self.ahead[3].signum() * 1e-11;
                let stable = trace.stations.last().is_some_and(Stop::is_stable);
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
                let jump = ended.then(|| self.course.landings(&station, past));
                trace.push(Event { mark, station, before, jump });
                if barred || mark == Mark::Arrival && self.route.stop_at_arrival {
                    trace.stations.push(station);
                    trace.end = match (barred, self.course.locked(self.regime)) {
                        (true, true) => End::UnboundedLoad,
                        (true, false) => End::Stalled,
                        _ => End::Arrival,
                    };
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
            if let Some((_, z, end)) = border {
                trace.stations.push(self.station(&z));
                trace.end = end;
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

    /// Where a step leaves what may be walked on, if it does.
    fn border(&self, next: &Vector, step: f64) -> Option<(f64, Vector, End)> {
        let end = self.outside(next)?;
        let (mut inside, mut outside, mut place) = (0.0, step, *next);
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            match self.arrive(middle) {
                Some(z) if self.outside(&z) == Some(end) => (outside, place) = (middle, z),
                _ => inside = middle,
            }
        }
        Some((outside, place, end))
    }

    /// Beyond the stretch that may be walked on, or beyond what the strands allow.
    fn outside(&self, z: &Vector) -> Option<End> {
        let (low, high) = self.route.window;
        if (low..=high).contains(&z[3]) { self.course.outside(z) } else { Some(End::LeftWindow) }
    }

    fn ended(&self) -> Option<End> {
        let [signed, rotation, ..] = self.z;
        if signed.abs() >= FLATTEST {
            Some(End::FlatRings)
        } else if self.regime.support() == Support::Free && rotation * signed.signum() < 1e-6 * libm::sin(signed.abs())
        {
            Some(End::Apart)
        } else if self.course.unbounded(&self.z) {
            Some(End::UnboundedLoad)
        } else {
            None
        }
    }
}
