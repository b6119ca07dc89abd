//! Walking a path of strands that stretch.

use nply::mechanics::{
    Axial, Contacts, End, ExtensiblePly, ExtensibleState, Grips, Route, StretchData, StretchPath, StretchStation,
    Turning,
};

use super::{Leg, Walk, Walked, choose, no_beginning, same_twist};
use crate::{Case, Datum, ErrorKind, Question, SpecError, Table};

impl Walked<StretchStation> {
    pub(super) fn of(cases: Vec<Case>, walk: Walk, route: &Route) -> Result<Self, SpecError> {
        if walk.kept {
            let message = "strands that stretch are carried by contacts that push only: leave it out";
            return Err(SpecError::new(ErrorKind::Contradiction, crate::Place::Flag("kept".to_owned()), message));
        }
        let mut data = Vec::with_capacity(cases.len());
        for case in &cases {
            data.push(given(case)?);
        }
        let (Some(first), Some(&(ply, mut from))) = (cases.first(), data.first()) else {
            return Err(no_beginning());
        };
        for (case, (other, to)) in cases.iter().zip(&data) {
            same_twist(case, from.twist, to.twist)?;
            if *other != ply {
                let changed = |entry: &crate::spec::Entry| {
                    entry.key.table == Table::Support || entry.key.datum == Datum::StiffnessRatio
                };
                return Err(case.refuse(changed, |said| {
                    format!("{said} cannot change along a path of strands that stretch: there twist, loads and ends do")
                }));
            }
        }
        let path = |from, to, case: &Case| StretchPath::new(&ply, from, to).map_err(|error| case.locate(&error));
        let starts = path(from, from, first)?.starts().map_err(|error| first.locate(&error))?;
        let chosen = choose(&starts, walk.start)?;
        let mut here = starts.get(chosen).copied();
        let mut legs = Vec::new();
        for (case, &(_, to)) in cases.iter().zip(&data).skip(1) {
            let Some(start) = here else { break };
            from.grips = taken_over(from.grips, to.grips, &start.state);
            let to = StretchData { grips: unnamed_stay(from.grips, to.grips, case), ..to };
            let path = path(from, to, case)?;
            let start = StretchStation { along: 0.0, ..start };
            let trace = path.trace(&start, route).map_err(|error| case.locate(&error))?;
            here = trace.stations.last().copied().filter(|_| trace.end == End::Arrival);
            legs.push(Leg { held: path.held(), trace });
            from = to;
        }
        let contacts = Contacts::Unilateral;
        let mut walked = Self { contacts, starts, chosen, legs, notes: Vec::new(), cases };
        walked.notes = walked.told();
        Ok(walked)
    }
}

/// The ply and the data of a case.
fn given(case: &Case) -> Result<(ExtensiblePly, StretchData), SpecError> {
    let Question::Stretched { ply, twist, grips } = case.question else {
        let stretch = |entry: &crate::spec::Entry| entry.key.datum == Datum::Stretch;
        return Err(
            case.refuse(stretch, |said| format!("{said} cannot change along a path: give it from the beginning"))
        );
    };
    Ok((ply, StretchData { twist, grips }))
}

/// What a leg begins with where it holds what was free, or frees what was held: the state keeps it.
fn taken_over(from: Grips, to: Grips, start: &ExtensibleState) -> Grips {
    Grips {
        axial: match (from.axial, to.axial) {
            (Axial::Force(_), Axial::Extension(_)) => Axial::Extension(start.extension()),
            (Axial::Extension(_), Axial::Force(_)) => Axial::Force(start.load().force),
            _ => from.axial,
        },
        turning: match (from.turning, to.turning) {
            (Turning::Moment(_), Turning::Rotation(_)) => Turning::Rotation(start.rotation()),
            (Turning::Rotation(_), Turning::Moment(_)) => Turning::Moment(start.load().moment),
            _ => from.turning,
        },
    }
}

/// What a leg leads to, with the loads that nobody gave as they are.
fn unnamed_stay(from: Grips, to: Grips, case: &Case) -> Grips {
    Grips {
        axial: match to.axial {
            Axial::Force(_) if !case.gives(Datum::Force) => from.axial,
            axial => axial,
        },
        turning: match to.turning {
            Turning::Moment(_) if !case.gives(Datum::Moment) => from.turning,
            turning => turning,
        },
    }
}
