//! Schemas of what is written in: a ply with its studies, and a layered strand. A TOML file is taken as the JSON it stands for.

use serde_json::{Map, Value, json};

use super::node::{Object, list, words};
use super::table::WANTED;
use crate::construction::{CONSTRUCTION_KEYS, DEEPEST, MOST_LAYERS};
use crate::key::Group;
use crate::spec::sweep::SWEEP_KEYS;
use crate::spec::{MAP_KEYS, MOST_LEGS};
use crate::{Datum, KEYS, Key, Kind, Table, map, sweep};

/// What one key takes.
fn value(key: &Key) -> Value {
    let mut schema = match key.kind {
        Kind::Count => json!({ "type": ["integer", "string"] }),
        Kind::Text => json!({ "type": "string" }),
        Kind::Switch => json!({ "type": "boolean" }),
        Kind::Balance => any_case(&["contact", "radial"]),
        Kind::Hand => any_case(&["right", "left", "Z", "S"]),
        kind if kind.may_be_bare() => json!({ "type": ["number", "string"], "pattern": "\\S" }),
        _ => json!({ "type": "string", "pattern": "\\S" }),
    };
    schema["title"] = json!(key.name.replace('_', " "));
    schema["description"] = json!(format!("{}{WANTED}{}.", key.help, key.kind.wanted()));
    if let Some(dimension) = key.kind.dimension() {
        schema["x-unit-kind"] = json!(dimension.to_string());
    }
    schema
}

/// Words, which are taken in capitals too; an editor offers them as they stand.
fn any_case(known: &[&str]) -> Value {
    let letters = |word: &str| -> String {
        word.chars().map(|c| format!("[{}{}]", c.to_ascii_uppercase(), c.to_ascii_lowercase())).collect()
    };
    let pattern = known.iter().map(|word| letters(word)).collect::<Vec<_>>().join("|");
    json!({ "type": "string", "anyOf": [{ "enum": known }, { "pattern": format!("^\\s*({pattern})\\s*$") }] })
}

/// Data of which only one can be given. How the ends are held is left out: strands that stretch are held in two ways at once.
fn exclusive(keys: &[&Key]) -> Vec<Value> {
    let mut refused = Vec::new();
    for (at, key) in keys.iter().enumerate() {
        for other in &keys[at + 1..] {
            if key.group.is_some() && key.group == other.group && key.group != Some(Group::Ends) {
                refused.push(json!({ "not": { "required": [key.name, other.name] } }));
            }
        }
    }
    refused
}

/// One table of a document.
fn table(about: &str, keys: &[&Key]) -> Value {
    let object = keys.iter().fold(Object::new(about), |object, key| object.may(key.name, value(key)));
    let mut schema = object.closed();
    let refused = exclusive(keys);
    if !refused.is_empty() {
        schema["allOf"] = Value::Array(refused);
    }
    schema
}

fn keys_of(list: &'static [Key], of: Table) -> Vec<&'static Key> {
    list.iter().filter(|key| key.table == of).collect()
}

fn refer(name: &str) -> Value {
    json!({ "$ref": format!("#/$defs/{name}") })
}

/// A ply: what `nply solve`, `support`, `trace`, `map`, `plot`, `locus`, `contact`, `spin`, `actuator`, `fit`, `mesh` and `sweep` read.
pub(super) fn ply() -> Value {
    let mut defs = Map::new();
    let mut top = Object::new("");
    let mut corner = Object::new("What changes: loads, twist, ends, the support's core, the stiffness ratio");
    for of in Table::ALL {
        let keys = keys_of(&KEYS, of);
        defs.insert(of.name().into(), table(of.about(), &keys));
        top = top.may(of.name(), refer(of.name()));
        let changing: Vec<&Key> = keys.into_iter().filter(|key| key.may_change()).collect();
        if !changing.is_empty() {
            corner = corner.may(of.name(), table(of.about(), &changing));
        }
    }
    defs.insert("corner".into(), corner.closed());
    defs.insert("map".into(), map_table());
    defs.insert("sweep".into(), sweep_table());
    let mut legs =
        list("The legs of a path, one after the other: each says what has changed at its end", refer("corner"));
    legs["maxItems"] = json!(MOST_LEGS);
    let mut schema = top.may("path", legs).may("map", refer("map")).may("sweep", refer("sweep")).closed();
    schema["$defs"] = Value::Object(defs);
    schema
}

fn map_table() -> Value {
    let points = || json!({ "type": "integer", "minimum": 1, "maximum": map::MOST });
    let object = MAP_KEYS.iter().fold(Object::new("A rectangle of two data"), |object, (name, meaning)| {
        let mut schema = if matches!(*name, "from" | "to") { refer("corner") } else { points() };
        schema["description"] = json!(meaning);
        object.may(*name, schema)
    });
    object.closed()
}

fn sweep_table() -> Value {
    let count = || json!({ "type": "integer", "minimum": 0 });
    let word = |known: Vec<&str>| any_case(&known);
    let mut top =
        Object::new("A table with a row for each set of data: what varies, table by table, and what is asked");
    for (name, meaning) in SWEEP_KEYS {
        let mut schema = match name {
            "outputs" => list("", json!({ "type": "string" })),
            "states" => word(sweep::States::ALL.iter().map(|word| word.name()).collect()),
            "order" => word(sweep::Order::ALL.iter().map(|word| word.name()).collect()),
            "sample" => word(sweep::Sample::ALL.iter().map(|word| word.name()).collect()),
            "question" => word(sweep::Question::ALL.iter().map(|word| word.name()).collect()),
            "points" | "seed" => count(),
            _ => json!({ "type": "string" }),
        };
        schema["description"] = json!(meaning);
        top = top.may(name, schema);
    }
    for of in Table::ALL {
        let varies = keys_of(&KEYS, of).into_iter().filter(|key| !matches!(key.datum, Datum::Title | Datum::Stretch));
        let object = varies.fold(Object::new(of.about()), |object, key| object.may(key.name, run(key)));
        top = top.may(of.name(), object.closed());
    }
    top.closed()
}

/// A datum on a range, or in a list.
fn run(key: &Key) -> Value {
    let one = value(key);
    let range = Object::new("From one value to another")
        .with("from", one.clone())
        .with("to", one.clone())
        .may("count", json!({ "type": "integer", "minimum": 1, "description": "How many values, both ends among them; none for samples" }))
        .may("scale", words("How they are spaced", ["linear", "log"]));
    let mut range = range.closed();
    range["required"] = json!(["from", "to"]);
    let mut list = list("These values", one);
    list["minItems"] = json!(1);
    json!({ "title": key.name.replace('_', " "), "description": format!("{}, as it varies.", key.help), "anyOf": [range, list] })
}

/// A layered strand: what `nply fit-check`, `stiffness` and `mesh` read.
pub(super) fn construction() -> Value {
    let mut defs = Map::new();
    for depth in 0..=DEEPEST {
        for of in [Table::Core, Table::Layer] {
            let mut schema = table(of.about(), &keys_of(&CONSTRUCTION_KEYS, of));
            if depth < DEEPEST {
                let mut within = refer(&format!("strand_{}", depth + 1));
                within["description"] = json!("What it is made of, where it is a strand itself");
                schema["properties"]["strand"] = within;
            }
            defs.insert(format!("{}_{depth}", of.name()), schema);
        }
        let mut layers = list("The layers, from the inside", refer(&format!("layer_{depth}")));
        layers["maxItems"] = json!(MOST_LAYERS);
        let strand = Object::new("A strand within a strand")
            .may("construction", refer("construction"))
            .may("core", refer(&format!("core_{depth}")))
            .may("layer", layers);
        if depth > 0 {
            defs.insert(format!("strand_{depth}"), strand.closed());
            continue;
        }
        for of in [Table::Construction, Table::Load] {
            defs.insert(of.name().into(), table(of.about(), &keys_of(&CONSTRUCTION_KEYS, of)));
        }
        defs.insert("document".into(), strand.may("load", refer("load")).closed());
    }
    let mut schema = defs.shift_remove("document").unwrap_or_default();
    schema["$defs"] = Value::Object(defs);
    schema
}
