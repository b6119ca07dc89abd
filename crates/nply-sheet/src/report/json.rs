//! The report for programs. Every number is the shortest text that reads back as the same double.

use serde_json::{Map, Value, json};

use super::column::Entry;
use super::verdict::Verdicts;
use super::{Report, margin};
use nply::Handedness;
use nply::mechanics::Twist;

use crate::Question;

/// The version of this layout: it changes when a key is renamed or removed, not when one is added.
const SCHEMA_VERSION: u32 = 1;

/// Who wrote this, and in which layout.
pub(crate) fn header() -> Map<String, Value> {
    let mut top = Map::new();
    top.insert("program".into(), json!("nply"));
    top.insert("version".into(), json!(env!("CARGO_PKG_VERSION")));
    top.insert("schema_version".into(), json!(SCHEMA_VERSION));
    top
}

impl Report {
    /// The report as JSON. Numbers are dimensionless (r = B = 1, angles named `_deg` in degrees, others in rad); where the
    /// scale is known each state has an `si` object too, whose units stand in `si_units`. A quantity that has no value,
    /// such as a flexibility at a fold, is null.
    #[must_use]
    pub fn json(&self) -> String {
        if let Some(supported) = &self.solution.supported {
            return super::support::json(self, supported);
        }
        if let Some(stretched) = &self.solution.stretched {
            return super::support::json(self, stretched);
        }
        let case = &self.case;
        let mut top = header();
        top.insert("balance".into(), json!(case.balance.name()));
        if let Some(title) = &case.title {
            top.insert("title".into(), json!(title));
        }
        top.insert("strands".into(), json!(case.strands));
        top.insert("stiffness_ratio".into(), json!(case.stiffness_ratio));
        if let Some(pressure) = case.external_pressure {
            top.insert("external_pressure".into(), json!(pressure));
        }
        top.insert("question".into(), question(case.question));
        if let Some(radius) = case.strand_radius {
            top.insert("strand_radius_m".into(), json!(radius));
        }
        if let Some(scale) = case.scale {
            top.insert("bending_stiffness_N_m2".into(), json!(scale.bending_stiffness()));
        }
        let entries = self.entries();
        let units: Map<String, Value> = entries
            .iter()
            .filter_map(|entry| Some((entry.name.to_owned(), json!(entry.measure.si(self.known())?.1))))
            .collect();
        if !units.is_empty() {
            top.insert("si_units".into(), Value::Object(units));
        }
        top.insert("straight_holds".into(), json!(self.solution.straight));
        let states = self.solution.states.iter().enumerate();
        top.insert("states".into(), states.map(|(i, state)| self.state(i, state, &entries)).collect());
        top.insert("notes".into(), json!(self.notes));
        format!("{:#}\n", Value::Object(top))
    }

    fn state(&self, i: usize, state: &nply::mechanics::Equilibrium, entries: &[Entry]) -> Value {
        let mut object = Map::new();
        let sign = if state.handedness() == Handedness::Right { 1 } else { -1 };
        object.insert("handedness".into(), json!(sign));
        object.insert("lay".into(), json!(state.handedness().lay_letter().to_string()));
        object.insert("separated".into(), json!(state.is_separated() && !super::at_separation(&self.case)));
        let verdict = state.stability().map(|_| super::text::verdict(state));
        object.insert("stability".into(), json!(verdict));
        let held = Verdicts::of(state).named().map(|(name, _, verdict)| {
            let name = name.to_owned();
            (name, json!(verdict.map(|verdict| verdict.name())))
        });
        object.insert("stability_by_holding".into(), Value::Object(held.into_iter().collect()));
        object.insert("fold".into(), json!(state.is_fold()));
        object.insert("helical_angle".into(), json!(state.contact().helical_angle()));
        let mut si = Map::new();
        for entry in entries {
            let value = entry.values[i];
            object.insert(entry.name.into(), json!(value));
            if let Some((factor, _)) = entry.measure.si(self.known()) {
                si.insert(entry.name.into(), json!(value.map(|v| v * factor)));
            }
        }
        let margins = margin::json(&self.margins(state), self.known(), self.case.strand_length);
        object.insert("margins".into(), margins);
        object.insert("flexibility".into(), json!(state.flexibility()));
        object.insert("flexibility_as_published".into(), json!(state.flexibility_as_published()));
        if !si.is_empty() {
            object.insert("si".into(), Value::Object(si));
        }
        Value::Object(object)
    }
}

/// What was given, by name.
pub(super) fn question(question: Question) -> Value {
    let twist = |twist| match twist {
        Twist::Pretwist(value) => ("pretwist", value),
        Twist::StrandTwist(value) => ("strand_twist", value),
    };
    let (find, given) = match question {
        Question::States { twist: t, load } => {
            ("states", vec![twist(t), ("force", load.force), ("moment", load.moment)])
        }
        Question::MomentAt { twist: t, force, .. } => ("moment", vec![twist(t), ("force", force)]),
        Question::ForceAt { twist: t, moment, .. } => ("force", vec![twist(t), ("moment", moment)]),
        Question::PretwistAt { load, .. } => ("pretwist", vec![("force", load.force), ("moment", load.moment)]),
        Question::SeparationAtForce { twist: t, force } => ("separation", vec![twist(t), ("force", force)]),
        Question::SeparationAtMoment { twist: t, moment } => ("separation", vec![twist(t), ("moment", moment)]),
        Question::Held { twist: t, ends } => {
            (super::found(question).unwrap_or("states"), [vec![twist(t)], super::support::held(ends)].concat())
        }
        Question::Supported { twist: t, ends, core_radius } => {
            let core = core_radius.map(|radius| ("core_radius", radius));
            let given = [vec![twist(t)], super::support::held(ends), core.into_iter().collect()].concat();
            ("supported_states", given)
        }
        Question::Stretched { twist: t, grips, .. } => {
            ("supported_states", [vec![twist(t)], super::stretch::held(grips)].concat())
        }
    };
    let given: Map<String, Value> = given.into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect();
    json!({ "find": find, "given": given })
}
