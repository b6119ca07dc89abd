//! One state followed from row to row, along what varies fastest.

use core::ops::Range;

use super::Study;
use super::plan::{NO_STABLE_STATE, NO_STATE, Plan, RowStates};
use super::sink::{Answers, Sink};
use crate::report::Found;
use crate::table::Values;

/// What was followed, up to a row.
#[derive(Clone, Copy, Debug, Default)]
pub struct Trail {
    next: u64,
    here: Option<Place>,
}

/// ±θ and the ply's rotation.
type Place = [f64; 2];

/// A state that moves by more than this, in rad, from one look to the next might be another one: then it is looked at halfway.
const STEP: f64 = 0.02;
/// How much farther off the next state must be.
const APART: f64 = 4.0;
/// How often a step between two rows is halved. A branch that ends is followed to within the square root of the last half.
const HALVINGS: u32 = 24;

impl Study {
    /// Rows with the one state that is followed. Each run of the last datum starts by itself, so that the answer does not depend on the stretch.
    pub(super) fn follow(&self, plan: &Plan, trail: &mut Trail, rows: Range<u64>, cells: &[Values]) -> Answers {
        let length = self.run_length();
        let mut sink = Sink::new(&plan.outputs, (rows.end - rows.start) as usize);
        if trail.next != rows.start {
            *trail = Trail { next: rows.start, here: None };
            let begins = rows.start - rows.start % length;
            for row in begins..rows.start {
                let (cells, at) = (self.values(row..row + 1), row);
                trail.here = self.step(plan, trail.here, at, &cells, 0, None);
            }
        }
        for row in rows.clone() {
            trail.here = self.step(plan, trail.here, row, cells, (row - rows.start) as usize, Some(&mut sink));
        }
        trail.next = rows.end;
        sink.finish(true)
    }

    /// The state of a row, where it lies, and none where the next row begins anew.
    fn step(
        &self,
        plan: &Plan,
        before: Option<Place>,
        row: u64,
        cells: &[Values],
        at: usize,
        sink: Option<&mut Sink<'_>>,
    ) -> Option<Place> {
        let before = before.filter(|_| !row.is_multiple_of(self.run_length()));
        let found = match plan.row_states(cells, at) {
            Ok(found) => found,
            Err(reason) => {
                if let Some(sink) = sink {
                    sink.refuse(at, reason);
                }
                return None;
            }
        };
        let states = found.each();
        let chosen = match before {
            Some(before) => {
                let halfway = |share: f64| self.between(plan, cells, at, row - 1, share);
                let arrived = arrive(&halfway, before, (0.0, 1.0), &places(&states), HALVINGS);
                arrived.and_then(|place| nearest(&places(&states), place).map(|(number, ..)| number))
            }
            None => begin(&states),
        };
        let reason = match (before, states.is_empty()) {
            (Some(_), _) => "branch ended",
            (None, true) => NO_STATE,
            (None, false) => NO_STABLE_STATE,
        };
        match (chosen.and_then(|number| Some((number, *states.get(number)?))), sink) {
            (Some((number, state)), sink) => {
                if let Some(sink) = sink {
                    sink.push(at, i64::try_from(number + 1).ok(), state, &found.given, found.known);
                }
                Some(state.place())
            }
            (None, sink) => {
                if let Some(sink) = sink {
                    sink.refuse(at, reason.to_owned());
                }
                None
            }
        }
    }

    /// The states so far on the way from a row to the next.
    fn between(&self, plan: &Plan, cells: &[Values], at: usize, row: u64, share: f64) -> Option<RowStates> {
        let runs = &self.written.runs;
        let length = self.run_length();
        let numbers: Option<Vec<Option<f64>>> = match self.layout {
            super::Layout::Grid => {
                let place = row % length;
                let last = runs.len().checked_sub(1)?;
                (0..runs.len())
                    .map(|run| if run == last { runs[run].between(place, share).map(Some) } else { Some(None) })
                    .collect()
            }
            _ => runs
                .iter()
                .map(|run| if run.count() == Some(1) { Some(None) } else { run.between(row, share).map(Some) })
                .collect(),
        };
        plan.states_between(cells, at, &numbers?)
    }
}

fn places(states: &[Found<'_>]) -> Vec<Place> {
    states.iter().map(|state| state.place()).collect()
}

/// The state a run begins with: the stable one of least energy, or else the first that presses.
fn begin(states: &[Found<'_>]) -> Option<usize> {
    let energy = |found: &Found<'_>| match found {
        Found::Contact(_) => f64::INFINITY,
        Found::Touching(state) => state.energy().total(),
        Found::Supported(state) => state.energy().total(),
        Found::Stretched(state) => state.energy().total(),
    };
    let pressing = |found: &Found<'_>| !matches!(found, Found::Touching(state) if state.is_separated());
    let stable = states.iter().enumerate().filter(|(_, found)| found.is_stable());
    let least = stable.min_by(|(_, a), (_, b)| energy(a).total_cmp(&energy(b))).map(|(at, _)| at);
    least.or_else(|| states.iter().position(pressing)).or_else(|| (!states.is_empty()).then_some(0))
}

fn distance(a: Place, b: Place) -> f64 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}

/// The nearest of some places: which, how far, and how far the next.
fn nearest(places: &[Place], to: Place) -> Option<(usize, f64, f64)> {
    let mut found: Option<(usize, f64, f64)> = None;
    for (at, place) in places.iter().enumerate() {
        let far = distance(*place, to);
        found = Some(match found {
            None => (at, far, f64::INFINITY),
            Some((_, first, _)) if far < first => (at, far, first),
            Some((which, first, second)) => (which, first, second.min(far)),
        });
    }
    found
}

/// Where a state has come to at the end of a stretch between two rows, at whose end there are states at these places.
fn arrive(
    states_at: &dyn Fn(f64) -> Option<RowStates>,
    from: Place,
    (start, end): (f64, f64),
    at_end: &[Place],
    halvings: u32,
) -> Option<Place> {
    let sure = |places: &[Place]| {
        let (at, far, next) = nearest(places, from)?;
        (far <= STEP && next >= APART * far).then(|| places[at])
    };
    let middle = 0.5 * (start + end);
    if let Some(there) = sure(at_end) {
        // and halfway it lies between the two
        let small = distance(there, from) <= 1e-3 * STEP;
        let checked = small || {
            let found = states_at(middle)?;
            let places = places(&found.each());
            sure(&places).is_some_and(|half| distance(half, there) <= STEP)
        };
        if checked {
            return Some(there);
        }
    }
    if halvings == 0 {
        return None;
    }
    let found = states_at(middle)?;
    let half = arrive(states_at, from, (start, middle), &places(&found.each()), halvings - 1)?;
    arrive(states_at, half, (middle, end), at_end, halvings - 1)
}
