//! The parts that schemas are put together from.

use serde_json::{Map, Value, json};

/// An object under construction: names with their schemas, and which of them are always there.
pub(super) struct Object {
    about: String,
    properties: Map<String, Value>,
    required: Vec<String>,
}

impl Object {
    pub(super) fn new(about: impl Into<String>) -> Self {
        Self { about: about.into(), properties: Map::new(), required: Vec::new() }
    }

    /// What is always there.
    pub(super) fn with(mut self, name: impl Into<String>, schema: Value) -> Self {
        let name = name.into();
        self.required.push(name.clone());
        self.may(name, schema)
    }

    /// What is there where it is known, or was asked for.
    pub(super) fn may(mut self, name: impl Into<String>, schema: Value) -> Self {
        self.properties.insert(name.into(), schema);
        self
    }

    pub(super) fn all(self, named: impl IntoIterator<Item = (String, Value)>) -> Self {
        named.into_iter().fold(self, |object, (name, schema)| object.with(name, schema))
    }

    /// An object that may have other names as well.
    pub(super) fn open(self) -> Value {
        json!({ "type": "object", "description": self.about, "properties": self.properties, "required": self.required })
    }

    /// An object of these names alone, none of which is needed.
    pub(super) fn closed(self) -> Value {
        json!({
            "type": "object",
            "description": self.about,
            "properties": self.properties,
            "additionalProperties": false,
        })
    }
}

/// A number with its unit; none of a pure number.
pub(super) fn number(meaning: impl Into<String>, unit: &str) -> Value {
    let mut schema = json!({ "type": "number", "description": meaning.into() });
    if !unit.is_empty() {
        schema["x-unit"] = json!(unit);
    }
    schema
}

pub(super) fn whole(meaning: &str, least: i64) -> Value {
    json!({ "type": "integer", "minimum": least, "description": meaning })
}

pub(super) fn text(meaning: &str) -> Value {
    json!({ "type": "string", "description": meaning })
}

pub(super) fn flag(meaning: &str) -> Value {
    json!({ "type": "boolean", "description": meaning })
}

/// One of some words.
pub(super) fn words<'w>(meaning: &str, words: impl IntoIterator<Item = &'w str>) -> Value {
    json!({ "type": "string", "enum": words.into_iter().collect::<Vec<_>>(), "description": meaning })
}

pub(super) fn list(meaning: &str, of: Value) -> Value {
    json!({ "type": "array", "items": of, "description": meaning })
}

/// So many numbers in a row.
pub(super) fn tuple(meaning: &str, count: usize, of: Value) -> Value {
    json!({ "type": "array", "items": of, "minItems": count, "maxItems": count, "description": meaning })
}

/// The same, or null where there is no such thing.
pub(super) fn or_null(mut schema: Value) -> Value {
    if let Some(words) = schema.get_mut("enum").and_then(Value::as_array_mut) {
        words.push(Value::Null);
    }
    if let Some(kind) = schema.get("type").cloned() {
        schema["type"] = json!([kind, "null"]);
    }
    schema
}

/// A schema that stands by itself.
pub(super) fn whole_schema(title: &str, about: &str, body: Value) -> Value {
    let mut top = Map::new();
    top.insert("$schema".into(), json!("https://json-schema.org/draft/2020-12/schema"));
    top.insert("title".into(), json!(title));
    if let Value::Object(body) = body {
        top.extend(body);
    }
    top.insert("description".into(), json!(about));
    Value::Object(top)
}
