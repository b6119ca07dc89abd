//! Schemas as tables for a reader.

use core::fmt::Write as _;

use serde_json::Value;

use super::Subject;

/// A heading, and a table for each object that has names.
pub(super) fn markdown(subject: &Subject, schema: &Value) -> String {
    let mut page = Page { out: format!("## {}\n\n{}.\n", subject.name, escaped(subject.about)), told: Vec::new() };
    match (schema["$defs"].as_object(), schema["anyOf"].as_array()) {
        // of a document: table by table; those of strands within are the same
        (Some(defs), _) => {
            for (name, def) in defs.iter().filter(|(name, _)| !name.contains('_') || name.ends_with("_0")) {
                let heading = match name.trim_end_matches("_0") {
                    "layer" => "\\[\\[layer\\]\\]".to_owned(),
                    "corner" => "\\[\\[path\\]\\], and `from` and `to` of \\[map\\]".to_owned(),
                    name => format!("\\[{name}\\]"),
                };
                page.table(&heading, def);
            }
        }
        (None, Some(kinds)) => kinds.iter().for_each(|kind| page.object("", kind)),
        (None, None) => page.object("", schema),
    }
    page.out
}

struct Page {
    out: String,
    /// what was told already, and where
    told: Vec<(String, String)>,
}

impl Page {
    /// An object's names, under a heading.
    fn table(&mut self, heading: &str, schema: &Value) {
        let Some(properties) = schema["properties"].as_object() else { return };
        let mut table = String::new();
        if let Some(about) = schema["description"].as_str().filter(|about| !about.is_empty()) {
            let _ = writeln!(table, "{}.\n", escaped(about.trim_end_matches('.')));
        }
        table.push_str("| name | takes | meaning |\n|---|---|---|\n");
        for (name, of) in properties.iter().filter(|(name, _)| *name != "si") {
            let said = if of["description"].is_string() { &of["description"] } else { &of["title"] };
            let said = said.as_str().unwrap_or("");
            let (said, wanted) = said.split_once(WANTED).map_or((said, None), |(said, wanted)| (said, Some(wanted)));
            let takes = wanted.map_or_else(|| takes(of), |wanted| wanted.trim_end_matches('.').to_owned());
            let _ = writeln!(table, "| `{name}` | {} | {} |", escaped(&takes), escaped(said.trim_end_matches('.')));
        }
        if let Some((_, where_told)) = self.told.iter().find(|(told, _)| *told == table) {
            if where_told != heading {
                let _ = writeln!(self.out, "\n{heading} is as {where_told}.");
            }
            return;
        }
        let _ = writeln!(self.out, "\n### {heading}\n\n{}", table.trim_end());
        self.told.push((table, heading.to_owned()));
    }

    /// The same, and then the objects in it.
    fn object(&mut self, path: &str, schema: &Value) {
        let kind = schema["title"].as_str().map_or_else(String::new, |kind| format!(" {kind}"));
        let heading = if path.is_empty() { format!("The report{kind}") } else { format!("`{path}`") };
        self.table(&heading, schema);
        let properties = schema["properties"].as_object();
        for (name, of) in properties.into_iter().flatten().filter(|(name, _)| *name != "si") {
            let below = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
            let inner = if of["items"].is_object() { &of["items"] } else { of };
            if inner["properties"].is_object() {
                self.object(&below, inner);
            }
        }
    }
}

/// What stands before the kind of value in the description of a key.
pub(super) const WANTED: &str = ". What is wanted is ";

/// What stands for a name: its unit, its kind of unit, its words, or its sort.
fn takes(schema: &Value) -> String {
    if let Some(unit) = schema["x-unit"].as_str() {
        return unit.to_owned();
    }
    let words = [&schema["enum"], &schema["anyOf"][0]["enum"]].into_iter().find_map(Value::as_array);
    if let Some(words) = words {
        let words = words.iter().map(|word| word.as_str().map_or_else(|| word.to_string(), str::to_owned));
        return words.collect::<Vec<_>>().join(", ");
    }
    if let Some(constant) = schema.get("const") {
        return constant.as_str().map_or_else(|| constant.to_string(), str::to_owned);
    }
    if let Some(names) = schema["properties"].as_object() {
        return names.keys().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    }
    if schema.get("$ref").is_some() {
        return "a table".to_owned();
    }
    if schema["anyOf"][0]["properties"]["from"].is_object() {
        return "a range or a list".to_owned();
    }
    let kinds = match &schema["type"] {
        Value::Array(kinds) => kinds.iter().filter_map(Value::as_str).collect::<Vec<_>>(),
        kind => kind.as_str().into_iter().collect(),
    };
    let word = |kind: &str| match kind {
        "string" => "text",
        "boolean" => "true, false",
        "integer" => "whole number",
        "array" => "list",
        "null" => "null",
        "object" => "object",
        _ => "number",
    };
    kinds.into_iter().map(word).collect::<Vec<_>>().join(", ")
}

fn escaped(text: &str) -> String {
    let mut out = String::new();
    for (at, piece) in text.split('`').enumerate() {
        if at > 0 {
            out.push('`');
        }
        if at % 2 == 1 {
            out.push_str(&piece.replace('|', "\\|"));
            continue;
        }
        for c in piece.chars() {
            if matches!(c, '|' | '[' | ']' | '<' | '>' | '*' | '_') {
                out.push('\\');
            }
            out.push(c);
        }
    }
    out
}
