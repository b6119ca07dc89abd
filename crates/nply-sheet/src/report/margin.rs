//! How far a state is from coming apart and from its other limits, for a reader and for a program.

use core::f64::consts::TAU;

use nply::Handedness;
use nply::mechanics::{Change, Equilibrium, Limit, Margin};
use serde_json::{Map, Value, json};

use super::csv::unit_suffix;
use super::text::Row;
use super::{Known, Measure};
use crate::PreferredUnits;
use crate::preferred::six_digits;

/// The margins of one state, in the order of [`Change::ALL`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Margins([Option<Margin>; 5]);

/// Which way a datum goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    Below,
    Above,
    /// Towards straight strands.
    Out,
    /// Away from them.
    In,
}

/// The rows of a reader's table.
const ROWS: [(&str, Change, Way); 10] = [
    ("force may fall by", Change::Force, Way::Below),
    ("force may rise by", Change::Force, Way::Above),
    ("force may fall by, ends not turning", Change::ForceEndsHeld, Way::Below),
    ("force may rise by, ends not turning", Change::ForceEndsHeld, Way::Above),
    ("moment may fall by", Change::Moment, Way::Below),
    ("moment may rise by", Change::Moment, Way::Above),
    ("turns per strand length to take out", Change::Turns, Way::Out),
    ("turns per strand length to add", Change::Turns, Way::In),
    ("pretwist may fall by", Change::Pretwist, Way::Below),
    ("pretwist may rise by", Change::Pretwist, Way::Above),
];

impl Margins {
    /// None at all for a state that is separated or at a fold, or under an external pressure.
    pub(super) fn of(state: &Equilibrium) -> Self {
        Self(Change::ALL.map(|change| state.margin(change).ok().flatten()))
    }

    /// For a state that has nothing to lose.
    pub(super) const NONE: Self = Self([None; 5]);

    fn limit(&self, change: Change, below: bool) -> Option<Limit> {
        self.get(change).and_then(|margin| if below { margin.below } else { margin.above })
    }

    /// How far a datum can go on one side.
    pub(super) fn change(&self, change: Change, below: bool) -> Option<f64> {
        self.limit(change, below).map(|limit| change_of(change, &limit))
    }

    /// What is met there, by name.
    pub(super) fn cause(&self, change: Change, below: bool) -> Option<&'static str> {
        self.limit(change, below).map(|limit| limit.cause.name())
    }

    fn get(&self, change: Change) -> Option<Margin> {
        Change::ALL.iter().zip(self.0).find(|(other, _)| **other == change).and_then(|(_, margin)| margin)
    }
}

/// The limit on one side.
fn on(margin: Margin, way: Way, handedness: Handedness) -> Option<Limit> {
    match (way, handedness) {
        (Way::Below, _) | (Way::Out, Handedness::Right) | (Way::In, Handedness::Left) => margin.below,
        (Way::Above, _) | (Way::In, Handedness::Right) | (Way::Out, Handedness::Left) => margin.above,
    }
}

/// What is met, in a word.
fn word(limit: &Limit) -> &'static str {
    match limit.cause.name() {
        "separation" => "opens",
        "fold" => "jumps",
        "most_turns" => "most turns",
        other => other,
    }
}

/// The change as it is written: turns of the end and not radians.
fn change_of(change: Change, limit: &Limit) -> f64 {
    if change == Change::Turns { limit.change / TAU } else { limit.change }
}

pub(super) const fn measure(change: Change) -> Measure {
    match change {
        Change::Force | Change::ForceEndsHeld => Measure::Force,
        Change::Moment => Measure::Moment,
        Change::Turns => Measure::TurnsPerLength,
        Change::Pretwist => Measure::Number,
    }
}

/// The moment at a limit; at the most turns no moment is large enough.
fn moment(limit: &Limit) -> Option<f64> {
    (limit.cause.name() != "most_turns").then_some(limit.state.load().moment)
}

/// A table's rows: how far, and what is met there. Rows in which nothing is met are left out.
pub(super) fn rows(
    states: &[Equilibrium],
    margins: &[Margins],
    known: Known,
    units: &PreferredUnits,
    strand_length: Option<f64>,
) -> Vec<Row> {
    let limits_of = |change: Change, way: Way| -> Vec<Option<Option<Limit>>> {
        let pairs = states.iter().zip(margins);
        pairs.map(|(state, margins)| margins.get(change).map(|margin| on(margin, way, state.handedness()))).collect()
    };
    let kind_of = |change: Change| {
        let turned = change == Change::Pretwist && known.strand_radius.is_some();
        if turned { (Measure::TurnsPerLength, 1.0 / TAU) } else { (measure(change), 1.0) }
    };
    let size = |change: Change, limit: &Limit| (kind_of(change).1 * change_of(change, limit)).abs();
    // ways up and down are compared: one unit for both
    let beside: Vec<(Measure, f64)> = ROWS
        .into_iter()
        .flat_map(|(_, change, way)| {
            let met = limits_of(change, way).into_iter().flatten().flatten();
            met.map(move |limit| (kind_of(change).0, size(change, &limit))).collect::<Vec<_>>()
        })
        .collect();
    let mut rows = Vec::new();
    for (label, change, way) in ROWS {
        let limits = limits_of(change, way);
        if limits.iter().flatten().flatten().next().is_none() {
            continue;
        }
        let kind = kind_of(change).0;
        let size = |limit: &Limit| size(change, limit);
        let reading = kind.reading(known, units, kind.size_among(0.0, &beside));
        let cells = |text: &dyn Fn(&Limit) -> String| {
            let cell = |limit: &Option<Option<Limit>>| match limit {
                Some(Some(limit)) => text(limit),
                Some(None) => "no limit".to_owned(),
                None => "–".to_owned(),
            };
            limits.iter().map(cell).collect()
        };
        let text = |limit: &Limit| format!("{} {}", four_digits(size(limit) * reading.factor), word(limit));
        rows.push(Row { label: label.to_owned(), unit: reading.unit.clone(), cells: cells(&text) });
        if let (Change::Turns, Some(length)) = (change, strand_length) {
            let label = label.replace("per strand length", "in all");
            let text = |limit: &Limit| four_digits(size(limit) * length);
            rows.push(Row { label, unit: "turns".to_owned(), cells: cells(&text) });
        }
    }
    rows
}

/// Four significant digits: a margin is read beside what it is a margin of.
fn four_digits(value: f64) -> String {
    six_digits(format!("{value:.3e}").parse().unwrap_or(value))
}

/// The margins by name, each `null` or both sides.
pub(super) fn json(margins: &Margins, known: Known, strand_length: Option<f64>) -> Value {
    let object = Change::ALL.map(|change| {
        let side = |limit: Option<Limit>| limit.map(|limit| limit_json(change, &limit, known, strand_length));
        let value =
            margins.get(change).map(|margin| json!({ "below": side(margin.below), "above": side(margin.above) }));
        (change.name().to_owned(), json!(value))
    });
    Value::Object(object.into_iter().collect())
}

fn limit_json(change: Change, limit: &Limit, known: Known, strand_length: Option<f64>) -> Value {
    let mut object = Map::new();
    let numbers = [
        ("change", measure(change), Some(change_of(change, limit))),
        ("force", Measure::Force, Some(limit.state.load().force)),
        ("moment", Measure::Moment, moment(limit)),
    ];
    object.insert("cause".into(), json!(limit.cause.name()));
    object.insert("helical_angle_deg".into(), json!(limit.state.contact().angle().degrees()));
    let mut si = Map::new();
    for (name, measure, value) in numbers {
        let value = super::column::written(value);
        object.insert(name.into(), json!(value));
        if let Some((factor, _)) = measure.si(known) {
            si.insert(name.into(), json!(value.map(|value| value * factor)));
        }
    }
    if change == Change::Turns {
        let total = strand_length.map(|length| change_of(change, limit) * length);
        object.insert("change_total".into(), json!(super::column::written(total)));
    }
    if !si.is_empty() {
        object.insert("si".into(), Value::Object(si));
    }
    Value::Object(object)
}

/// The names of a table's columns: per limit the change and its cause, and the change in SI where the scale is known.
pub(super) fn csv_head(known: Known) -> Vec<String> {
    sides()
        .flat_map(|(change, side)| {
            let name = format!("margin_{}_{side}", change.name());
            let si = measure(change).si(known).map(|(_, unit)| format!("{name}_{}", unit_suffix(unit)));
            [Some(name.clone()), Some(format!("{name}_cause")), si].into_iter().flatten()
        })
        .collect()
}

/// The cells below [`csv_head`]; empty where there is no limit.
pub(super) fn csv_cells(margins: &Margins, known: Known) -> Vec<String> {
    sides()
        .flat_map(|(change, side)| {
            let below = side == "below";
            let value = super::column::written(margins.change(change, below));
            let text = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:?}"));
            let cause = margins.cause(change, below).unwrap_or_default().to_owned();
            let si = measure(change).si(known).map(|(factor, _)| text(value.map(|value| value * factor)));
            [Some(text(value)), Some(cause), si].into_iter().flatten()
        })
        .collect()
}

fn sides() -> impl Iterator<Item = (Change, &'static str)> {
    Change::ALL.into_iter().flat_map(|change| [(change, "below"), (change, "above")])
}
