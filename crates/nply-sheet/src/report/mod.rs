//! What a person reads out: one report, rendered as a table, as JSON or as CSV.

mod catalogue;
mod clearance;
mod column;
mod csv;
mod curve;
mod figured;
mod fit;
mod item;
mod json;
mod lays;
mod link;
pub(crate) mod listed;
mod locus;
mod locus_picture;
mod margin;
mod measure;
mod plying;
mod shape;
mod stiffness;
mod stretch;
mod strings;
mod support;
mod text;
mod trace;
mod verdict;
mod writhe;

use nply::Handedness;
use nply::mechanics::{Axial, Balance, Ends, Equilibrium, Turning};

pub(crate) use catalogue::{Find, Found, Given, Listed, StateKind};
pub use clearance::ClearanceReport;
pub use column::{COLUMNS, Column, Section};
pub use curve::Extension;
pub use fit::FitReport;
pub use lays::LaysReport;
pub use link::{Link, LinkReport};
pub use locus::{AngleLine, LocusReport, SpecialPoint};
pub use measure::{Known, Measure, Reading};
pub use plying::PlyingReport;
pub use shape::ShapeReport;
pub use stiffness::StiffnessReport;
pub use strings::{StringsGoal, StringsReport};
pub(crate) use trace::data_of;
pub use trace::{TraceReport, Walk};
pub use writhe::{WritheQuestion, WritheReport, Writhing};

pub(crate) use csv::unit_suffix;
pub(crate) use json::header;
pub(crate) use text::{Emphasis, Row, lay_out};

use crate::{Case, Question, SpecError, solve::Solution};

/// The states of a case and all that is said of them. Nothing in it is text yet but for the notes.
///
/// ```
/// use nply_sheet::{Report, Spec};
/// let flags = [("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-1")];
/// let report = Report::of(Spec::from_flags(flags)?.check()?)?;
/// assert!(report.text(false).contains("30.613"));
/// let json: serde_json::Value = serde_json::from_str(&report.json())?;
/// assert_eq!(json["states"][0]["handedness"], 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Report {
    /// What was asked.
    pub case: Case,
    /// The answer.
    pub solution: Solution,
    /// What a reader should know about this answer, a sentence each.
    pub notes: Vec<String>,
}

/// Angles of the two balances that differ by more than this (degrees) are pointed out.
const NOTEWORTHY: f64 = 0.1;

impl Report {
    /// Solves a case and reports on it.
    ///
    /// # Errors
    /// [`SpecError`] where the theory refuses a premise, at the place of the datum it comes from.
    pub fn of(case: Case) -> Result<Self, SpecError> {
        let solution = case.solve().map_err(|error| case.locate(&error))?;
        let mut notes = notes(&case, &solution);
        notes.extend(packing(&case));
        Ok(Self { case, solution, notes })
    }

    fn known(&self) -> Known {
        Known { scale: self.case.scale, strand_radius: self.case.strand_radius }
    }

    fn entries(&self) -> Vec<column::Entry> {
        column::entries(&self.solution.states, self.case.strand_length)
    }

    /// None on the verge of separation, which is where a margin ends.
    fn margins(&self, state: &Equilibrium) -> margin::Margins {
        if at_separation(&self.case) { margin::Margins::NONE } else { margin::Margins::of(state) }
    }
}

/// What is taken for granted where a titre gives the size.
pub(super) fn packing(case: &Case) -> Option<String> {
    case.packing_fraction.map(packing_of)
}

fn packing_of(share: f64) -> String {
    let share = crate::preferred::six_digits(share);
    let solid = if share == "1" { " (solid)" } else { "" };
    format!(
        "The strand's diameter follows from its linear density at a packing fraction of {share}{solid}; the fibres of a yarn \
         leave room between them, the more the less it is twisted."
    )
}

/// The quantity a question finds besides the shape, by its column's name.
fn found(question: Question) -> Option<&'static str> {
    match question {
        Question::States { .. } => None,
        Question::MomentAt { .. } | Question::SeparationAtForce { .. } => Some("moment"),
        Question::ForceAt { .. } | Question::SeparationAtMoment { .. } => Some("force"),
        Question::PretwistAt { .. } => Some("pretwist"),
        Question::Held { ends, .. } | Question::Supported { ends, .. } => match ends {
            Ends::Loads(_) => None,
            Ends::Rotation { .. } => Some("moment"),
            Ends::Length { .. } => Some("force"),
        },
        // with both displacements held, both loads are found
        Question::Stretched { grips, .. } => match (grips.axial, grips.turning) {
            (Axial::Force(_), Turning::Rotation(_)) => Some("moment"),
            (Axial::Extension(_), Turning::Moment(_)) => Some("force"),
            _ => None,
        },
    }
}

fn notes(case: &Case, solution: &Solution) -> Vec<String> {
    if let Some(supported) = &solution.supported {
        return support::notes(case, solution.straight, supported);
    }
    if let Some(stretched) = &solution.stretched {
        return stretch::notes(case, stretched);
    }
    let mut notes = Vec::new();
    if solution.states.is_empty() {
        notes.push("No state: no helical angle of either hand is in equilibrium with these data.".to_owned());
    }
    if solution.straight == Some(true) {
        notes.push(
            "Straight strands side by side (helical angle 0) are in equilibrium too: the end moment is n times what holds the \
             twist of one strand."
                .to_owned(),
        );
    }
    let separated: Vec<String> = numbers(&solution.states, Equilibrium::is_separated);
    if !separated.is_empty() && found(case.question).is_none_or(|name| name == "pretwist" || !at_separation(case)) {
        notes.push(format!(
            "{} {} separated: touching neighbours would have to pull on each other (p₁ < 0).",
            states(&separated),
            if separated.len() == 1 { "is" } else { "are" },
        ));
    }
    let folds = numbers(&solution.states, Equilibrium::is_fold);
    if !folds.is_empty() {
        notes.push(format!(
            "{} {} at a fold: two states meet there, and its response to a change of load is unbounded.",
            states(&folds),
            if folds.len() == 1 { "is" } else { "are" },
        ));
    }
    if solution.states.iter().any(|state| state.stability().is_some()) {
        notes.push(
            "Stable means among uniform plies; the given twist is held, unless strand twist held is said. Where the ends cannot \
             turn, or the length is held, closed contacts leave no uniform motion. Buckling as a whole, local loops and the \
             collapse of a hole are not covered."
                .to_owned(),
        );
    }
    if let Some(length) = case.strand_length {
        notes.extend(buckling(&solution.states, length, case.may_be_solid()));
    }
    if case.balance == Balance::Radial && !solution.states.is_empty() {
        notes.push(
            "In radial balance p₁ is what neighbours would press if they alone carried p; where a core carries the strands, p \
             is the load on the core. Responses follow touching strands, whose radius changes with the angle."
                .to_owned(),
        );
    }
    if let Some(others) = &solution.other_balance {
        notes.extend(difference(case, &solution.states, others));
    }
    notes
}

/// Which touching states are pushed harder than a ply of this length bears as a whole; the upper bound is of `solid` strands alone.
fn buckling(states: &[Equilibrium], strand_length: f64, solid: bool) -> Vec<String> {
    let beyond = |state: &Equilibrium| {
        let bounds = column::buckling_thrust(state, strand_length).filter(|_| !state.is_separated());
        let known = if solid { 2 } else { 1 };
        bounds.map_or(0, |bounds| bounds.iter().take(known).filter(|bound| -state.load().force > **bound).count())
    };
    let (some, all) = (numbers(states, |state| beyond(state) == 1), numbers(states, |state| beyond(state) == 2));
    let said = |numbers: &[String], what: &str| {
        (!numbers.is_empty()).then(|| format!("{} {what}", self::states(numbers).replacen("State", "In state", 1)))
    };
    let may = if solid {
        "the ply may buckle as a whole: its loads are beyond what it bears if its strands slide freely, not what it bears if they \
         are solid, round and locked."
    } else {
        "the ply may buckle as a whole: its loads are beyond what it bears if its strands slide freely."
    };
    let does = "the ply buckles as a whole: its loads are beyond what it bears even if its strands are solid and round and cannot slide.";
    [said(&some, may), said(&all, does)].into_iter().flatten().collect()
}

fn at_separation(case: &Case) -> bool {
    matches!(case.question, Question::SeparationAtForce { .. } | Question::SeparationAtMoment { .. })
}

/// The numbers, from 1, of the states for which something holds.
fn numbers(states: &[Equilibrium], holds: impl Fn(&Equilibrium) -> bool) -> Vec<String> {
    states.iter().enumerate().filter(|(_, s)| holds(s)).map(|(i, _)| (i + 1).to_string()).collect()
}

fn states(numbers: &[String]) -> String {
    format!("State{} {}", if numbers.len() == 1 { "" } else { "s" }, numbers.join(", "))
}

/// One line where the balances differ noticeably, with both angles.
fn difference(case: &Case, own: &[Equilibrium], others: &[Equilibrium]) -> Option<String> {
    let name = case.balance.name();
    let other_name = if name == "contact" { "radial" } else { "contact" };
    let degrees = |state: &Equilibrium| state.contact().angle().degrees();
    let mut differing = Vec::new();
    for hand in Handedness::BOTH {
        let of = |states: &[Equilibrium]| -> Vec<f64> {
            states.iter().filter(|s| s.handedness() == hand).map(degrees).collect()
        };
        let (own, others) = (of(own), of(others));
        let side = if hand == Handedness::Right { "right" } else { "left" };
        if own.len() == others.len() {
            let pairs = own.iter().zip(&others).filter(|(a, b)| (*a - *b).abs() > NOTEWORTHY);
            differing.extend(pairs.map(|(a, b)| format!("{side}-handed {a:.3}° ({name}), {b:.3}° ({other_name})")));
        } else {
            let list = |angles: &[f64]| match angles {
                [] => "none".to_owned(),
                _ => angles.iter().map(|a| format!("{a:.3}°")).collect::<Vec<_>>().join(" and "),
            };
            differing.push(format!("{side}-handed {} ({name}), {} ({other_name})", list(&own), list(&others)));
        }
    }
    (!differing.is_empty()).then(|| format!("The balances differ: {}.", differing.join("; ")))
}
