//! Documents: what can be written, what was written, and what it comes to.

use nply_sheet::{KEYS, Kind, PRESETS, Preset, Quantity, Report, Spec, SpecError};
use serde_json::{Value, json};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::refusal;

/// Every key of a ply as JSON, in the order of a file: `flag`, `table`, `name`, `kind`, `wanted`, `help`, and whether it takes a unit.
#[wasm_bindgen]
#[must_use]
pub fn keys() -> String {
    let one = |key: &nply_sheet::Key| {
        json!({
            "flag": key.flag,
            "table": key.table.name(),
            "name": key.name,
            "kind": kind(key.kind),
            "wanted": key.kind.wanted(),
            "help": key.help,
        })
    };
    Value::Array(KEYS.iter().map(one).collect()).to_string()
}

/// What a field for it is like: `text`, `switch`, `count`, `number`, `balance`, `hand`; else a quantity.
const fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Text => "text",
        Kind::Switch => "switch",
        Kind::Count => "count",
        Kind::Number => "number",
        Kind::Balance => "balance",
        Kind::Hand => "hand",
        _ => "quantity",
    }
}

/// The plies that come with the program, as JSON: `name`, `about`, `source`, `command`, `text`.
#[wasm_bindgen]
#[must_use]
pub fn presets() -> String {
    let one = |preset: &Preset| {
        json!({
            "name": preset.name,
            "about": preset.about(),
            "source": preset.source(),
            "command": preset.command(),
            "text": preset.text,
        })
    };
    Value::Array(PRESETS.iter().map(one).collect()).to_string()
}

/// What a document says, as JSON: `data`, a list of `flag` and `text`, and `study`, whether paths or maps stand in it that are left out.
#[wasm_bindgen]
#[must_use]
pub fn read(name: &str, text: &str) -> String {
    let read = || -> Result<Value, SpecError> {
        let written = Spec::written(name, text)?;
        let data: Vec<Value> = written.iter().map(|(key, text)| json!({ "flag": key.flag, "text": text })).collect();
        Ok(json!({ "data": data, "study": Spec::from_toml(name, text)?.is_study() }))
    };
    read().map_or_else(|error| refusal::of_document(&error, text), |read| read.to_string())
}

/// Every state of a document: `report`, as `nply solve --json` prints it; `other`, the angles in the other balance (signed: left-handed
/// ones negative, in degrees), where both were worked out; and `data`, what was written: `flag`, `text` and, of quantities, `number`, its `unit`
/// and `factor`, one of that unit in SI.
#[wasm_bindgen]
#[must_use]
pub fn solve(name: &str, text: &str) -> String {
    match solved(name, text) {
        Ok(answer) => answer,
        Err(error) => refusal::of_document(&error, text),
    }
}

fn solved(name: &str, text: &str) -> Result<String, SpecError> {
    let spec = Spec::from_toml(name, text)?;
    let data: Vec<Value> = Spec::written(name, text)?.iter().map(|(key, text)| datum(key.flag, text)).collect();
    let case = spec.check()?;
    let solution = case.solve().map_err(|error| case.locate(&error))?;
    let other: Option<Vec<f64>> = solution.other_balance.map(|states| {
        let signed =
            |state: &nply::mechanics::Equilibrium| state.handedness().sign() * state.contact().angle().degrees();
        states.iter().map(signed).collect()
    });
    let report = Report::of(case)?.json();
    Ok(format!("{{\"report\":{report},\"other\":{},\"data\":{}}}", json!(other), json!(data)))
}

/// A datum with its number apart from its unit, where it is a quantity; a hand behind it stays in the text.
fn datum(flag: &str, text: &str) -> Value {
    let bare = text.trim_end_matches([' ', 'S', 'Z']);
    match Quantity::parse(bare) {
        Ok(Quantity::Bare(number)) => json!({ "flag": flag, "text": text, "number": number }),
        Ok(Quantity::Measured { si, unit }) => {
            let (number, factor) = (unit.of_si(si), unit.to_si(1.0));
            json!({ "flag": flag, "text": text, "number": number, "unit": unit.as_str(), "factor": factor })
        }
        Err(_) => json!({ "flag": flag, "text": text }),
    }
}
