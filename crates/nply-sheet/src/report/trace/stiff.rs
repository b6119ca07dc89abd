//! Walking a path of strands that do not stretch.

use nply::mechanics::{Balance, Clamped, Contacts, Data, End, Ends, Holding, Path, Route, Station};

use super::{Leg, Walk, Walked, choose, data_of, no_beginning, same_twist};
use crate::key::Group;
use crate::{Case, Datum, SpecError};

impl Walked<Station> {
    pub(super) fn of(cases: Vec<Case>, walk: Walk, route: &Route) -> Result<Self, SpecError> {
        let mut data = Vec::with_capacity(cases.len());
        for case in &cases {
            data.push(data_of(case)?);
        }
        let (Some(first), Some(&from)) = (cases.first(), data.first()) else {
            return Err(no_beginning());
        };
        let contacts = match (first.balance, walk.kept) {
            (Balance::Radial, _) => Contacts::Kept(Balance::Radial),
            (balance, true) => Contacts::Kept(balance),
            (Balance::Contact, false) => Contacts::Unilateral,
        };
        for (case, to) in cases.iter().zip(&data) {
            same_kind(case, &from, to)?;
        }
        let path =
            |from, to, case: &Case| Path::new(first.strands, from, to, contacts).map_err(|error| case.locate(&error));
        let starts = path(from, from, first)?.starts().map_err(|error| first.locate(&error))?;
        let chosen = choose(&starts, walk.start)?;
        let mut report = Self { contacts, starts, chosen, legs: Vec::new(), notes: Vec::new(), cases: Vec::new() };
        let mut here = report.starts.get(chosen).copied();
        let mut from = from;
        for (case, &to) in cases.iter().zip(&data).skip(1) {
            let Some(start) = here else { break };
            from.ends = taken_over(from.ends, to.ends, &start);
            let to = Data { ends: unnamed_stay(from.ends, to.ends, case), ..to };
            let path = path(from, to, case)?;
            let trace = path.trace(&Station { along: 0.0, ..start }, route).map_err(|error| case.locate(&error))?;
            here = trace.stations.last().copied().filter(|_| trace.end == End::Arrival);
            report.legs.push(Leg { held: clamped(path.holding()), trace });
            from = to;
        }
        report.cases = cases;
        report.notes = report.told();
        Ok(report)
    }
}

const fn clamped(holding: Holding) -> Clamped {
    Clamped { length: matches!(holding, Holding::Length), rotation: matches!(holding, Holding::Rotation) }
}

/// Whether a leg keeps what is given of the twist, and the core.
fn same_kind(case: &Case, from: &Data, to: &Data) -> Result<(), SpecError> {
    same_twist(case, from.twist, to.twist)?;
    if from.core_radius.is_some() != to.core_radius.is_some() {
        return Err(case.refuse(
            |entry| entry.key.group == Some(Group::Support),
            |said| {
                format!(
                    "{said} comes on the way: no leg brings a core where there was none; give it from the beginning"
                )
            },
        ));
    }
    Ok(())
}

/// What a leg begins with where it holds what was free, or frees what was held: the state keeps it.
fn taken_over(from: Ends, to: Ends, start: &Station) -> Ends {
    match to {
        _ if from.holding() == to.holding() => from,
        Ends::Loads(_) => Ends::Loads(start.load),
        Ends::Rotation { .. } => Ends::Rotation { rotation: start.rotation(), force: start.load.force },
        Ends::Length { .. } => Ends::Length { extension: start.extension(), moment: start.load.moment },
    }
}

/// What a leg leads to, with the loads that nobody gave as they are: one that held a displacement before is found, and stays.
fn unnamed_stay(from: Ends, mut to: Ends, case: &Case) -> Ends {
    let stays = |load: &mut f64, was: f64, datum| {
        if !case.gives(datum) {
            *load = was;
        }
    };
    match (from, &mut to) {
        (Ends::Loads(was), Ends::Loads(load)) => {
            stays(&mut load.force, was.force, Datum::Force);
            stays(&mut load.moment, was.moment, Datum::Moment);
        }
        (Ends::Rotation { force: was, .. }, Ends::Rotation { force, .. }) => stays(force, was, Datum::Force),
        (Ends::Length { moment: was, .. }, Ends::Length { moment, .. }) => stays(moment, was, Datum::Moment),
        _ => {}
    }
    to
}
