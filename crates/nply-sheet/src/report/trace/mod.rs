//! A path: how a ply gets from one set of data to another, leg by leg.

mod picture;
mod table;
mod words;

use nply::mechanics::{Balance, Contacts, Data, End, Ends, Event, Holding, Path, Route, Stability, Station, Trace};

use self::words::{brief, happened, why};
use super::Known;
use crate::key::Group;
use crate::spec::Entry;
use crate::{Case, Datum, ErrorKind, Question, SpecError, Table};

/// How a path is to be walked.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Walk {
    /// The number (from 1) of the state to start from, in the order in which they are listed; the first stable one if not given.
    pub start: Option<usize>,
    /// Neighbours are kept together even where they would have to pull, as in the paper; always so in radial balance.
    pub kept: bool,
    /// r κ, the bending strain of the outer fibre, whose passing is to be told.
    pub curvature_limit: Option<f64>,
}

/// A ply followed along a path of one leg or more: the states on the way, what happens there, and where it ends.
///
/// ```
/// use nply_sheet::{Spec, TraceReport, Walk};
/// // three rods held straight with their twist in them, and let go
/// let spec = |moment| [("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-1"), ("moment", moment)];
/// let cases = [Spec::from_flags(spec("-2.25"))?.check()?, Spec::from_flags(spec("0"))?.check()?];
/// let walk = Walk { start: Some(2), ..Walk::default() };
/// let report = TraceReport::of(cases.into(), walk)?;
/// let last = report.last().expect("it starts");
/// assert!((last.angle.degrees() - 30.6130).abs() < 5e-5); // simulated: 30.6130°
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TraceReport {
    cases: Vec<Case>,
    contacts: Contacts,
    starts: Vec<Station>,
    chosen: usize,
    legs: Vec<Leg>,
    notes: Vec<String>,
}

/// One leg that was walked.
#[derive(Clone, Debug, PartialEq)]
struct Leg {
    holding: Holding,
    trace: Trace,
}

impl TraceReport {
    /// Walks from the first case to the second, from there to the third, and so on.
    ///
    /// Cases are [`Question::States`], [`Question::Held`] or [`Question::Supported`]. Where a leg holds a displacement that the one before
    /// did not, it is that of the state reached.
    ///
    /// # Errors
    /// [`SpecError`] where a case gives the shape or asks for separation, a leg changes the kind of twist or brings or takes a core, or
    /// a number is out of range.
    pub fn of(cases: Vec<Case>, walk: Walk) -> Result<Self, SpecError> {
        let mut data = Vec::with_capacity(cases.len());
        for case in &cases {
            data.push(data_of(case)?);
        }
        let (Some(first), Some(&from)) = (cases.first(), data.first()) else {
            let message = "a path needs a beginning and at least one leg";
            return Err(SpecError::new(ErrorKind::Missing, crate::Place::Flag("path".to_owned()), message));
        };
        let contacts = match (first.balance, walk.kept) {
            (Balance::Radial, _) => Contacts::Kept(Balance::Radial),
            (balance, true) => Contacts::Kept(balance),
            (Balance::Contact, false) => Contacts::Unilateral,
        };
        for (case, to) in cases.iter().zip(&data) {
            same_kind(case, &from, to)?;
        }
        if let Some(limit) = walk.curvature_limit.filter(|limit| !(*limit > 0.0 && limit.is_finite())) {
            let message = format!("{limit} limits nothing: give a bending strain greater than 0, such as 0.01");
            return Err(SpecError::new(ErrorKind::Domain, crate::Place::Flag("curvature-limit".to_owned()), message));
        }
        let route = Route { curvature_limit: walk.curvature_limit, ..Route::default() };
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
            let trace = path.trace(&Station { along: 0.0, ..start }, &route).map_err(|error| case.locate(&error))?;
            here = trace.stations.last().copied().filter(|_| trace.end == End::Arrival);
            report.legs.push(Leg { holding: path.holding(), trace });
            from = to;
        }
        report.cases = cases;
        report.notes = report.told();
        Ok(report)
    }

    /// The states that one can start from.
    #[must_use]
    pub fn starts(&self) -> &[Station] {
        &self.starts
    }

    /// Every station, with the number of its leg (from 1), in the order of the walk.
    pub fn stations(&self) -> impl Iterator<Item = (usize, &Station)> {
        self.legs.iter().enumerate().flat_map(|(i, leg)| leg.trace.stations.iter().map(move |station| (i + 1, station)))
    }

    /// Every event, with the number of its leg (from 1), in the order of the walk.
    pub fn events(&self) -> impl Iterator<Item = (usize, &Event)> {
        self.legs.iter().enumerate().flat_map(|(i, leg)| leg.trace.events.iter().map(move |event| (i + 1, event)))
    }

    /// The last state reached; `None` where there was none to start from.
    #[must_use]
    pub fn last(&self) -> Option<&Station> {
        self.legs.last().and_then(|leg| leg.trace.stations.last())
    }

    /// What a reader should know, a sentence each.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    fn known(&self) -> Known {
        let first = self.cases.first();
        Known { scale: first.and_then(|case| case.scale), strand_radius: first.and_then(|case| case.strand_radius) }
    }

    /// What should be known of the path.
    fn told(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if self.starts.is_empty() {
            notes.push("No state to start from: nothing is in equilibrium at the beginning of the path.".to_owned());
            return notes;
        }
        if self.starts.len() > 1 {
            let list: Vec<String> =
                self.starts.iter().enumerate().map(|(i, s)| format!("{} {}", i + 1, brief(s))).collect();
            notes.push(format!(
                "There are {} states to start from ({}); state {} is followed.",
                self.starts.len(),
                list.join(", "),
                self.chosen + 1
            ));
        }
        for (leg, event) in self.events() {
            let Some(jump) = &event.jump else { continue };
            let at = &event.station;
            let landing: Vec<String> = jump.iter().map(brief).collect();
            notes.push(match &landing[..] {
                [] => format!(
                    "On leg {leg} the stable states end at {}: {}, and no uniform stable state is left under these data. The ply runs \
                     away; the branch is followed on all the same.",
                    brief(at),
                    happened(event)
                ),
                _ => format!(
                    "On leg {leg} the stable states end at {}: {}, and it jumps. Stable there: {}. The branch is followed on all the same.",
                    brief(at),
                    happened(event),
                    landing.join(", ")
                ),
            });
        }
        if let Some(leg) = self.legs.last().filter(|leg| leg.trace.end != End::Arrival) {
            notes.push(format!("The path is not walked to its end: {}.", why(leg.trace.end)));
        }
        if self.contacts == Contacts::Kept(Balance::Radial) {
            notes.push(
                "In radial balance nothing is said of stability: it is not the slope of the strands' energy."
                    .to_owned(),
            );
        } else {
            notes.push(
                "Stable means among uniform plies, with the ends held as on the path; buckling as a whole, local loops and the collapse of \
                 a hole are not covered."
                    .to_owned(),
            );
        }
        notes
    }
}

/// The data of a case from which, or to which, a path can lead.
pub(crate) fn data_of(case: &Case) -> Result<Data, SpecError> {
    let (twist, ends, core_radius) = match case.question {
        Question::States { twist, load } => (twist, Ends::Loads(load), None),
        Question::Held { twist, ends } => (twist, ends, None),
        Question::Supported { twist, ends, core_radius } => (twist, ends, core_radius),
        Question::Stretched { .. } => return Err(super::stretch::not_here(case, "this path or map")),
        _ => {
            let asked = |entry: &Entry| entry.key.table == Table::Lay || entry.key.datum == Datum::Separation;
            return Err(case.refuse(asked, |said| {
                format!("{said} goes with no path or map: there twist and loads are given, and the shape is found; remove it")
            }));
        }
    };
    if case.external_pressure.is_some_and(|pressure| pressure != 0.0) {
        let pressure = |entry: &Entry| entry.key.datum == Datum::ExternalPressure;
        return Err(
            case.refuse(pressure, |said| format!("{said} cannot be taken into account on a path or map: remove it"))
        );
    }
    Ok(Data { stiffness_ratio: case.stiffness_ratio, twist, ends, core_radius })
}

/// Whether a leg keeps what is given of the twist, and the core.
fn same_kind(case: &Case, from: &Data, to: &Data) -> Result<(), SpecError> {
    if core::mem::discriminant(&from.twist) != core::mem::discriminant(&to.twist) {
        return Err(case.refuse(
            |entry| entry.key.group == Some(Group::Twist),
            |said| {
                format!("{said} is another kind of twist than the path begins with: give the pretwist on all legs, or the strand twist on all")
            },
        ));
    }
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

/// The state to start from.
fn choose(starts: &[Station], wanted: Option<usize>) -> Result<usize, SpecError> {
    match wanted {
        Some(number) if number >= 1 && number <= starts.len() => Ok(number - 1),
        // said below: there is none
        Some(_) if starts.is_empty() => Ok(0),
        Some(number) => {
            let message = match starts.len() {
                1 => format!("{number} is the number of no state: there is one to start from"),
                count => format!("{number} is the number of no state: there are {count} to start from, counted from 1"),
            };
            Err(SpecError::new(ErrorKind::Domain, crate::Place::Flag("start".to_owned()), message))
        }
        None => {
            let presses = |s: &Station| s.stability == Some(Stability::Stable) && s.interstrand_pressure >= 0.0;
            Ok(starts.iter().position(presses).or_else(|| starts.iter().position(|s| !s.is_separated())).unwrap_or(0))
        }
    }
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
