//! A path: how a ply gets from one set of data to another, leg by leg.

mod picture;
mod stiff;
mod stop;
mod stretch;
mod table;
mod words;

use nply::mechanics::{
    Balance, Clamped, Contacts, Data, End, Ends, Event, Holding, Route, Stability, Station, StretchStation, Trace,
    Twist,
};

pub(super) use self::stop::Stop;
use self::words::{brief, happened, why};
use super::Known;
use crate::key::Group;
use crate::plot::Picture;
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
    /// Strain of the outermost fibre, from stretch and bending together, whose passing is to be told.
    pub strain_limit: Option<f64>,
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
    kind: Kind,
}

/// By what the strands are.
#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Stiff(Walked<Station>),
    Stretching(Walked<StretchStation>),
}

/// The path of one kind of strands.
#[derive(Clone, Debug, PartialEq)]
struct Walked<S> {
    cases: Vec<Case>,
    contacts: Contacts,
    starts: Vec<S>,
    chosen: usize,
    legs: Vec<Leg<S>>,
    notes: Vec<String>,
}

/// One leg that was walked.
#[derive(Clone, Debug, PartialEq)]
struct Leg<S> {
    held: Clamped,
    trace: Trace<S>,
}

impl TraceReport {
    /// Walks from the first case to the second, from there to the third, and so on.
    ///
    /// Cases are [`Question::States`], [`Question::Held`] or [`Question::Supported`], or all of them [`Question::Stretched`]. Where a leg
    /// holds a displacement that the one before did not, it is that of the state reached.
    ///
    /// # Errors
    /// [`SpecError`] where a case gives the shape or asks for separation, a leg changes the kind of twist or brings or takes a core, or
    /// a number is out of range.
    pub fn of(cases: Vec<Case>, walk: Walk) -> Result<Self, SpecError> {
        let Some(first) = cases.first() else {
            return Err(no_beginning());
        };
        for (limit, flag) in [(walk.curvature_limit, "curvature-limit"), (walk.strain_limit, "strain-limit")] {
            if let Some(limit) = limit.filter(|limit| !(*limit > 0.0 && limit.is_finite())) {
                let message = format!("{limit} limits nothing: give a bending strain greater than 0, such as 0.01");
                return Err(SpecError::new(ErrorKind::Domain, crate::Place::Flag(flag.to_owned()), message));
            }
        }
        let route =
            Route { curvature_limit: walk.curvature_limit, strain_limit: walk.strain_limit, ..Route::default() };
        Ok(Self {
            kind: match first.question {
                Question::Stretched { .. } => Kind::Stretching(Walked::<StretchStation>::of(cases, walk, &route)?),
                _ => Kind::Stiff(Walked::<Station>::of(cases, walk, &route)?),
            },
        })
    }

    /// The path of strands that do not stretch.
    const fn stiff(&self) -> Option<&Walked<Station>> {
        match &self.kind {
            Kind::Stiff(walked) => Some(walked),
            Kind::Stretching(_) => None,
        }
    }

    /// The states that one can start from; none of strands that stretch.
    #[must_use]
    pub fn starts(&self) -> &[Station] {
        self.stiff().map_or(&[], |walked| &walked.starts)
    }

    /// Every station, with the number of its leg (from 1), in the order of the walk; none of strands that stretch.
    pub fn stations(&self) -> impl Iterator<Item = (usize, &Station)> {
        self.stiff().into_iter().flat_map(Walked::stations)
    }

    /// Every event, with the number of its leg (from 1), in the order of the walk; none of strands that stretch.
    pub fn events(&self) -> impl Iterator<Item = (usize, &Event)> {
        self.stiff().into_iter().flat_map(Walked::events)
    }

    /// The last state reached; `None` where there was none to start from, and of strands that stretch.
    #[must_use]
    pub fn last(&self) -> Option<&Station> {
        self.stiff().and_then(Walked::last)
    }

    /// The legs of a path of strands that stretch, in order; none of those that do not.
    pub fn stretch_traces(&self) -> impl Iterator<Item = &Trace<StretchStation>> {
        let walked = match &self.kind {
            Kind::Stretching(walked) => Some(walked),
            Kind::Stiff(_) => None,
        };
        walked.into_iter().flat_map(|walked| walked.legs.iter().map(|leg| &leg.trace))
    }

    /// What a reader should know, a sentence each.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        match &self.kind {
            Kind::Stiff(walked) => &walked.notes,
            Kind::Stretching(walked) => &walked.notes,
        }
    }

    /// The path as a table: its start, what happens on the way, its end.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        match &self.kind {
            Kind::Stiff(walked) => walked.text(emphasis),
            Kind::Stretching(walked) => walked.text(emphasis),
        }
    }

    /// Every station as CSV.
    #[must_use]
    pub fn csv(&self) -> String {
        match &self.kind {
            Kind::Stiff(walked) => walked.csv(),
            Kind::Stretching(walked) => walked.csv(),
        }
    }

    /// Every station and event as JSON.
    #[must_use]
    pub fn json(&self) -> String {
        match &self.kind {
            Kind::Stiff(walked) => walked.json(),
            Kind::Stretching(walked) => walked.json(),
        }
    }

    /// The path as a picture: angle and pressures against the one datum that changes, or against the share of the path.
    #[must_use]
    pub fn picture(&self) -> Picture {
        match &self.kind {
            Kind::Stiff(walked) => walked.picture(),
            Kind::Stretching(walked) => walked.picture(),
        }
    }
}

impl<S: Stop> Walked<S> {
    fn stations(&self) -> impl Iterator<Item = (usize, &S)> {
        self.legs.iter().enumerate().flat_map(|(i, leg)| leg.trace.stations.iter().map(move |station| (i + 1, station)))
    }

    fn events(&self) -> impl Iterator<Item = (usize, &Event<S>)> {
        self.legs.iter().enumerate().flat_map(|(i, leg)| leg.trace.events.iter().map(move |event| (i + 1, event)))
    }

    fn last(&self) -> Option<&S> {
        self.legs.last().and_then(|leg| leg.trace.stations.last())
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

fn no_beginning() -> SpecError {
    let message = "a path needs a beginning and at least one leg";
    SpecError::new(ErrorKind::Missing, crate::Place::Flag("path".to_owned()), message)
}

/// The twist that is given.
const fn twist_of(case: &Case) -> Option<Twist> {
    match case.question {
        Question::States { twist, .. }
        | Question::MomentAt { twist, .. }
        | Question::ForceAt { twist, .. }
        | Question::SeparationAtForce { twist, .. }
        | Question::SeparationAtMoment { twist, .. }
        | Question::Held { twist, .. }
        | Question::Supported { twist, .. }
        | Question::Stretched { twist, .. } => Some(twist),
        Question::PretwistAt { .. } => None,
    }
}

/// What is held, by the name used in JSON.
const fn held_name(held: Clamped) -> &'static str {
    match (held.length, held.rotation) {
        (false, false) => Holding::DeadLoads.name(),
        (false, true) => Holding::Rotation.name(),
        (true, false) => Holding::Length.name(),
        (true, true) => "both_held",
    }
}

/// Refuses a leg that gives another kind of twist.
fn same_twist(case: &Case, from: Twist, to: Twist) -> Result<(), SpecError> {
    if core::mem::discriminant(&from) == core::mem::discriminant(&to) {
        return Ok(());
    }
    Err(case.refuse(
        |entry| entry.key.group == Some(Group::Twist),
        |said| {
            format!("{said} is another kind of twist than the path begins with: give the pretwist on all legs, or the strand twist on all")
        },
    ))
}

/// The state to start from.
fn choose<S: Stop>(starts: &[S], wanted: Option<usize>) -> Result<usize, SpecError> {
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
            let presses = |s: &S| s.verdict() == Some(Stability::Stable) && !s.separated();
            Ok(starts.iter().position(presses).or_else(|| starts.iter().position(|s| !s.separated())).unwrap_or(0))
        }
    }
}
