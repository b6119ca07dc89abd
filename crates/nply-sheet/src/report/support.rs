//! What carries the strands: the report of states on their supports.

use core::f64::consts::TAU;
use core::fmt::Write as _;

use nply::Handedness;
use nply::mechanics::{Ends, Holding, Stability, Support, SupportedState, Twist, Wedge};
use serde_json::{Map, Value, json};

use super::csv::unit_suffix;
use super::item::{Item, Reader, item, numbers, of_hand, units, words};
use super::json::{header, question};
use super::text::{Emphasis, hand, lay_out, title};
use super::{Known, Measure, Report, found};
use crate::preferred::six_digits;
use crate::solve::{Opening, Supported};
use crate::{Case, Question};

/// Every number of a state, in the order of the report.
const STATE: &[Item<SupportedState>] = {
    use Measure::{Degrees, Force, ForcePerLength, Length, Moment, Number, PerLength, Percent, TurnsPerLength};
    const SHAPE: &str = "Shape";
    const TWIST: &str = "Twist";
    const LOADS: &str = "Loads and contacts";
    const ENERGY: &str = "Energy of one strand, per strand length";
    const SECOND: &str = "Second variation of energy";
    &[
        item(SHAPE, "helical_angle_deg", "helical angle (lay angle)", Degrees, |s| Some(s.angle().degrees())),
        item(SHAPE, "pitch_angle_deg", "pitch angle", Degrees, |s| Some(s.angle().pitch_angle().to_degrees())),
        item(SHAPE, "lay_length", "lay length", Length, |s| Some(s.lay_length())),
        item(SHAPE, "turns_per_strand_length", "turns per strand length", TurnsPerLength, |s| {
            Some(s.rotation().abs() / TAU)
        }),
        item(SHAPE, "radius_ratio", "helix radius/strand radius", Number, |s| Some(s.radius_ratio())),
        item(SHAPE, "outer_diameter", "outer diameter", Length, |s| Some(2.0 * (s.radius_ratio() + 1.0))),
        item(SHAPE, "neighbour_gap", "gap between neighbours", Length, |s| Some(s.neighbour_gap())),
        item(SHAPE, "core_gap", "gap to the core", Length, SupportedState::core_gap),
        item(SHAPE, "extension", "ply length/strand length", Number, |s| Some(s.extension())),
        item(SHAPE, "retraction_percent", "retraction", Percent, |s| Some(retraction(s))),
        item(SHAPE, "rotation", "", Number, |s| Some(s.rotation())),
        item(SHAPE, "curvature", "curvature of a strand", PerLength, |s| Some(s.curvature())),
        item(SHAPE, "torsion", "", PerLength, |s| Some(s.torsion())),
        item(TWIST, "pretwist", "pretwist (tan of the surface angle)", Number, |s| Some(s.pretwist())),
        item(TWIST, "strand_twist", "strand twist r u₃", Number, |s| Some(s.strand_twist())),
        item(TWIST, "strand_twist_per_length", "strand twist per strand length", TurnsPerLength, |s| {
            Some(s.strand_twist() / TAU)
        }),
        item(LOADS, "force", "end force (tension +)", Force, |s| Some(s.load().force)),
        item(LOADS, "moment", "end moment (right-handed +)", Moment, |s| Some(s.load().moment)),
        item(LOADS, "resultant_pressure", "resultant pressure p", ForcePerLength, |s| Some(s.resultant_pressure())),
        item(LOADS, "interstrand_pressure", "pressure of each neighbour p₁", ForcePerLength, |s| {
            Some(s.interstrand_pressure())
        }),
        item(LOADS, "core_pressure", "pressure of the core p_c", ForcePerLength, |s| Some(s.core_pressure())),
        item(ENERGY, "bending_energy", "bending", Force, |s| Some(s.energy().bending)),
        item(ENERGY, "torsion_energy", "torsion", Force, |s| Some(s.energy().torsion)),
        item(ENERGY, "load_energy", "end loads", Force, |s| Some(s.energy().load)),
        item(ENERGY, "total_energy", "total", Force, |s| Some(s.energy().total())),
        item(SECOND, "second_variation_dead_loads", "under dead loads", Force, |s| {
            s.second_variation(Holding::DeadLoads)
        }),
        item(SECOND, "second_variation_rotation_held", "ends cannot turn", Force, |s| {
            s.second_variation(Holding::Rotation)
        }),
        item(SECOND, "second_variation_length_held", "length held", Force, |s| s.second_variation(Holding::Length)),
        item(SECOND, "second_variation_strand_twist_held", "strand twist held", Force, |s| {
            strand_twist_held(s)?.second_variation(Holding::DeadLoads)
        }),
    ]
};

/// The state with its strands' twisting moment held; none where that is what was given.
fn strand_twist_held(state: &SupportedState) -> Option<SupportedState> {
    matches!(state.twist(), Twist::Pretwist(_)).then(|| state.with_strand_twist_held())
}

/// A verdict: its name in JSON and CSV, its words, and how it is reached.
pub(super) type Verdict<S> = (&'static str, &'static str, fn(&S) -> Option<Stability>);

/// A state on its supports, of whatever strands: what is said of it.
pub(super) trait Carried: Sized + 'static {
    /// Every number, in the order of the report.
    const NUMBERS: &'static [Item<Self>];
    /// What may be held while it is disturbed; dead loads first.
    const VERDICTS: &'static [Verdict<Self>];

    fn hand(&self) -> Handedness;
    fn carried_by(&self) -> Support;
    fn radians(&self) -> f64;
}

impl Carried for SupportedState {
    const NUMBERS: &'static [Item<Self>] = STATE;
    const VERDICTS: &'static [Verdict<Self>] = VERDICTS;

    fn hand(&self) -> Handedness {
        self.handedness()
    }

    fn carried_by(&self) -> Support {
        self.support()
    }

    fn radians(&self) -> f64 {
        self.angle().radians()
    }
}

/// What may be held while a state is disturbed.
const VERDICTS: &[Verdict<SupportedState>] = &[
    ("dead_loads", "under dead loads", |s| Some(s.stability(Holding::DeadLoads))),
    ("rotation_held", "ends cannot turn", |s| Some(s.stability(Holding::Rotation))),
    ("length_held", "length held", |s| Some(s.stability(Holding::Length))),
    ("strand_twist_held", "strand twist held", |s| Some(strand_twist_held(s)?.stability(Holding::DeadLoads))),
];

/// Every number of a wedge of loads.
pub(super) const WEDGE: &[Item<Wedge>] = {
    use Measure::{Degrees, Force, Moment};
    const TIP: &str = "";
    const NEIGHBOURS: &str = "Edge where neighbours just touch, from the tip in the direction";
    const CORE: &str = "Edge where the core is just touched, from the tip in the direction";
    &[
        item(TIP, "helical_angle_deg", "helical angle (lay angle)", Degrees, |w| Some(w.angle.degrees())),
        item(TIP, "tip_force", "force at the tip", Force, |w| Some(w.tip.force)),
        item(TIP, "tip_moment", "moment at the tip", Moment, |w| Some(w.tip.moment)),
        item(NEIGHBOURS, "neighbours_just_touch_force", "force", Force, |w| Some(w.neighbours_just_touch.force)),
        item(NEIGHBOURS, "neighbours_just_touch_moment", "moment", Moment, |w| Some(w.neighbours_just_touch.moment)),
        item(CORE, "core_just_touches_force", "force", Force, |w| Some(w.core_just_touches.force)),
        item(CORE, "core_just_touches_moment", "moment", Moment, |w| Some(w.core_just_touches.moment)),
    ]
};

/// Every number of an opening.
pub(super) const OPENING: &[Item<Opening>] = &[
    item("", "helical_angle_deg", "helical angle (lay angle)", Measure::Degrees, |s| Some(s.angle.degrees())),
    item("", "radius_ratio", "helix radius/strand radius", Measure::Number, |s| Some(s.radius_ratio)),
    item("", "force", "end force (tension +)", Measure::Force, |s| Some(s.load.force)),
    item("", "moment", "end moment (right-handed +)", Measure::Moment, |s| Some(s.load.moment)),
];

/// How much shorter the ply is than its strands, in percent, regular for small angles.
fn retraction(state: &SupportedState) -> f64 {
    let half = libm::sin(0.5 * state.angle().radians());
    200.0 * half * half
}

/// What carries the strands, in a word for a reader.
const fn carried_by(support: Support) -> &'static str {
    match support {
        Support::Neighbours => "neighbours",
        Support::Core => "core",
        Support::Both => "both",
        Support::Free => "none (free)",
    }
}

/// The report as an aligned table.
pub(super) fn text<S: Carried>(report: &Report, supported: &Supported<S>, emphasis: bool) -> String {
    let (case, states) = (&report.case, &supported.states);
    let emphasis = &Emphasis(emphasis);
    let reader = Reader { known: report.known(), units: &case.units, emphasis };
    let mut out = String::new();
    let _ = writeln!(out, "{}", emphasis.heading(&headline(case, &reader)));
    if !states.is_empty() {
        let numbers: Vec<String> = (1..=states.len()).map(|number| number.to_string()).collect();
        let mut head = vec![
            words("state", numbers.iter().map(String::as_str)),
            words("hand", states.iter().map(|s| hand(s.hand()))),
            words("carried by", states.iter().map(|s| carried_by(s.carried_by()))),
        ];
        for (_, label, of) in S::VERDICTS.iter().filter(|(_, _, of)| states.iter().any(|s| of(s).is_some())) {
            head.push(words(label, states.iter().map(|s| of(s).map_or("–", Stability::name))));
        }
        lay_out(&mut out, &reader.parts(head, S::NUMBERS, states, found(case.question)), emphasis);
    }
    reader.table(
        &mut out,
        "Loads under which neighbours and core both carry: a wedge, between two edges from its tip",
        WEDGE,
        &supported.wedges,
        |wedge| wedge.handedness,
    );
    for (kept, openings) in openings(supported) {
        for (support, what) in LETS_GO {
            let heading = format!("{what} with the {kept} kept");
            let mine: Vec<Opening> = openings.iter().filter(|opening| opening.lets_go == support).copied().collect();
            reader.table(&mut out, &heading, OPENING, &mine, |opening| opening.handedness);
        }
    }
    for note in &report.notes {
        let _ = writeln!(out, "\n{note}");
    }
    out
}

/// What is given at the ends, by name.
pub(super) fn held(ends: Ends) -> Vec<(&'static str, f64)> {
    match ends {
        Ends::Loads(load) => vec![("force", load.force), ("moment", load.moment)],
        Ends::Rotation { rotation, force } => vec![("rotation", rotation), ("force", force)],
        Ends::Length { extension, moment } => vec![("extension", extension), ("moment", moment)],
    }
}

/// What may let go.
const LETS_GO: [(Support, &str); 2] = [
    (Support::Neighbours, "Where touching strands part (p = 0)"),
    (Support::Core, "Where strands lift off the core (p_c = 0)"),
];

/// The openings, by the load that is kept.
fn openings<S>(supported: &Supported<S>) -> [(&'static str, &[Opening]); 2] {
    [("force", &supported.openings_at_force), ("moment", &supported.openings_at_moment)]
}

const fn core_radius(case: &Case) -> Option<f64> {
    match case.question {
        Question::Supported { core_radius, .. } => core_radius,
        Question::Stretched { ply, .. } => match ply.core() {
            Some(core) => Some(core.radius()),
            None => None,
        },
        _ => None,
    }
}

/// Title, strands and core.
fn headline(case: &Case, reader: &Reader<'_>) -> String {
    let core = core_radius(case).map_or_else(
        || "no core".to_owned(),
        |radius| {
            let reading = Measure::Length.reading(reader.known, reader.units, radius);
            format!("core radius {} {}", six_digits(radius * reading.factor), reading.unit)
        },
    );
    let gamma = six_digits(case.stiffness_ratio);
    format!("{}{} strands, stiffness ratio {gamma}, {core}", title(case), case.strands)
}

/// The report as JSON.
pub(super) fn json<S: Carried>(report: &Report, supported: &Supported<S>) -> String {
    let (case, known) = (&report.case, report.known());
    let mut top = header();
    if let Some(title) = &case.title {
        top.insert("title".into(), json!(title));
    }
    top.insert("strands".into(), json!(case.strands));
    top.insert("stiffness_ratio".into(), json!(case.stiffness_ratio));
    top.insert("core_radius".into(), json!(core_radius(case)));
    top.insert("question".into(), question(case.question));
    if let Some(radius) = case.strand_radius {
        top.insert("strand_radius_m".into(), json!(radius));
    }
    if let Some(scale) = case.scale {
        top.insert("bending_stiffness_N_m2".into(), json!(scale.bending_stiffness()));
    }
    let units: Map<String, Value> =
        units(S::NUMBERS, known).chain(units(WEDGE, known)).chain(units(OPENING, known)).collect();
    if !units.is_empty() {
        top.insert("si_units".into(), Value::Object(units));
    }
    top.insert("straight_holds".into(), json!(report.solution.straight));
    top.insert("states".into(), supported.states.iter().map(|state| object(state, known)).collect());
    let wedge = |wedge: &Wedge| Value::Object(numbers(of_hand(wedge.handedness), WEDGE, wedge, known));
    top.insert("wedges".into(), supported.wedges.iter().map(wedge).collect());
    let opening = |kept: &str, state: &Opening| {
        let mut object = of_hand(state.handedness);
        object.insert("kept".into(), json!(kept));
        object.insert("lets_go".into(), json!(state.lets_go.name()));
        Value::Object(numbers(object, OPENING, state, known))
    };
    let all = openings(supported).into_iter().flat_map(|(kept, states)| states.iter().map(move |s| opening(kept, s)));
    top.insert("openings".into(), all.collect());
    top.insert("notes".into(), json!(report.notes));
    format!("{:#}\n", Value::Object(top))
}

fn object<S: Carried>(state: &S, known: Known) -> Value {
    let mut object = of_hand(state.hand());
    object.insert("support".into(), json!(state.carried_by().name()));
    let first = S::VERDICTS.first().and_then(|(_, _, of)| of(state));
    object.insert("stability".into(), json!(first.map(Stability::name)));
    let verdicts = S::VERDICTS.iter().map(|(name, _, of)| ((*name).to_owned(), json!(of(state).map(Stability::name))));
    object.insert("stability_by_holding".into(), Value::Object(verdicts.collect()));
    object.insert("helical_angle".into(), json!(state.radians()));
    Value::Object(numbers(object, S::NUMBERS, state, known))
}

/// The states as CSV: wedges and openings are left to JSON.
pub(super) fn csv<S: Carried>(report: &Report, supported: &Supported<S>) -> String {
    let (case, known) = (&report.case, report.known());
    let si: Vec<_> = S::NUMBERS.iter().filter_map(|item| Some((item, item.measure.si(known)?))).collect();
    let held = S::VERDICTS.get(1..).unwrap_or_default();
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:?}"));
    let mut head: Vec<String> =
        ["strands", "stiffness_ratio", "core_radius", "state", "handedness", "lay", "support"].map(String::from).into();
    head.push("stability".to_owned());
    head.extend(held.iter().map(|(name, ..)| format!("stability_{name}")));
    head.extend(S::NUMBERS.iter().map(|item| item.name.to_owned()));
    head.extend(si.iter().map(|(item, (_, unit))| format!("{}_{}", item.name, unit_suffix(unit))));
    let mut out = head.join(",") + "\n";
    for (i, state) in supported.states.iter().enumerate() {
        let mut cells = vec![
            case.strands.to_string(),
            case.stiffness_ratio.to_string(),
            number(core_radius(case)),
            (i + 1).to_string(),
            state.hand().sign().to_string(),
            state.hand().lay_letter().to_string(),
            state.carried_by().name().to_owned(),
        ];
        cells.extend(S::VERDICTS.iter().map(|(_, _, of)| of(state).map_or("", Stability::name).to_owned()));
        cells.extend(S::NUMBERS.iter().map(|item| number(item.of(state))));
        cells.extend(si.iter().map(|(item, (factor, _))| number(item.of(state).map(|value| value * factor))));
        out += &(cells.join(",") + "\n");
    }
    out
}

/// Which states are pushed harder than a ply of this length, hinged at its ends, bears as a whole while its strands slide freely.
fn buckling(case: &Case, states: &[SupportedState]) -> Option<String> {
    let length = case.strand_length?;
    let beyond = |state: &SupportedState| {
        let thrusts = state.bending_bounds().buckling_thrust(length * state.extension(), state.load().moment);
        thrusts.is_ok_and(|[sliding, _]| -state.load().force > sliding)
    };
    let numbers = states.iter().enumerate().filter(|(_, state)| beyond(state)).map(|(i, _)| (i + 1).to_string());
    let numbers: Vec<String> = numbers.collect();
    let state = if numbers.len() == 1 { "state" } else { "states" };
    (!numbers.is_empty()).then(|| {
        format!(
            "In {state} {} the ply may buckle as a whole: its loads are beyond what it bears with hinged ends while its strands slide \
             freely (the stiffness of a core is not counted).",
            numbers.join(", ")
        )
    })
}

/// What a reader should know, a sentence each.
pub(super) fn notes(case: &Case, straight: Option<bool>, supported: &Supported) -> Vec<String> {
    let Question::Supported { ends, core_radius, .. } = case.question else { return Vec::new() };
    let is = |support| supported.states.iter().any(|state| state.support() == support);
    let mut notes = Vec::new();
    let mut say = |holds: bool, note: &str| {
        if holds {
            notes.push(note.to_owned());
        }
    };
    say(
        supported.states.is_empty(),
        "No state: neither neighbours nor a core can hold helical strands under these data, nor do they stand free; the ply runs away or \
         snaps into a shape that is no uniform helix.",
    );
    say(
        straight == Some(true),
        "Straight strands side by side (helical angle 0) are in equilibrium too: the end moment is n times what holds the twist of one \
         strand.",
    );
    say(
        is(Support::Free) && ends.holding() == Holding::DeadLoads,
        "Free helices are unstable under dead loads as a rule: a ply that opens under a dead weight does not stop there but runs away. \
         With its length held, or ends that cannot turn, it can stay open.",
    );
    say(
        core_radius.is_some() && supported.wedges.is_empty(),
        "Touching strands cannot lie on this core: straight ones leave as large a hole already, so that neighbours and core never carry \
         together.",
    );
    say(
        !supported.wedges.is_empty() && ends.holding() != Holding::DeadLoads,
        "The one angle at which touching strands lie on the core, where neighbours and core share the load in any proportion, is left out \
         where ends are held.",
    );
    say(
        openings(supported).iter().any(|(_, states)| !states.is_empty()),
        "Where strands part, or lift off their core, is also where an opened ply closes: free helices that just touch press with nothing. Which \
         of these loads is met first depends on the way there.",
    );
    say(
        supported.states.len() > 1 && ends.holding() != Holding::DeadLoads,
        "The energy of the end loads counts the load that is found as well, which differs from state to state: compare states by the rest.",
    );
    say(
        !supported.states.is_empty(),
        if case.strands > 3 {
            "Stable means among uniform plies of equal helices with the given twist held (or the strands' torque, where it says so); buckling \
             as a whole, local loops and the collapse of a hole are not covered."
        } else {
            "Stable means among uniform plies of equal helices with the given twist held (or the strands' torque, where it says so); buckling \
             as a whole and local loops are not covered."
        },
    );
    notes.extend(buckling(case, &supported.states));
    notes
}
