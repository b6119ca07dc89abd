//! JSON Schemas (2020-12) of the documents that are read and of the reports that are written, made from the same lists as the reader and the
//! writer have. Units stand under `x-unit`, of what is read the kind of unit under `x-unit-kind`.

mod document;
mod meaning;
mod node;
mod report;
mod table;

use serde_json::Value;

/// Something that has a schema.
///
/// ```
/// use nply_sheet::schema::{DOCUMENTS, Subject};
/// let ply = Subject::named(&DOCUMENTS, "ply").map(Subject::schema).unwrap_or_default();
/// assert_eq!(ply["$defs"]["strand"]["properties"]["radius"]["x-unit-kind"], "a length");
/// assert_eq!(ply["$defs"]["strand"]["additionalProperties"], false);
/// ```
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Subject {
    /// What it is called: the kind of document, or the command whose report it is.
    pub name: &'static str,
    /// What it is, on one line.
    pub about: &'static str,
    body: fn() -> Value,
}

const fn subject(name: &'static str, about: &'static str, body: fn() -> Value) -> Subject {
    Subject { name, about, body }
}

/// Every kind of document.
pub static DOCUMENTS: [Subject; 2] = [
    subject("ply", "A ply of equal strands, with its studies: [[path]], [map], [sweep]", document::ply),
    subject("construction", "A layered strand or rope: a core and [[layer]] upon [[layer]]", document::construction),
];

/// Every report that is written as JSON, by the command that writes it.
#[rustfmt::skip] // a table: one row a line
pub static REPORTS: [Subject; 16] = [
    subject("solve", "Every state in equilibrium (`nply solve --json`)", report::solve),
    subject("support", "What carries the strands (`nply support --json`)", report::support),
    subject("trace", "A ply followed along a path (`nply trace --json`)", report::trace),
    subject("locus", "The loads at which touching strands part (`nply locus --json`)", report::locus),
    subject("contact", "How strands touch at a lay (`nply contact --json`)", report::contact),
    subject("lays", "The distinguished lays (`nply lays --json`)", report::lays),
    subject("spin", "Singles and the ply they make (`nply spin --json`)", report::spin),
    subject("actuator", "Strings twisted by a motor (`nply actuator --json`)", report::actuator),
    subject("fit", "Numbers of the strands from measurements (`nply fit --json`)", report::fit),
    subject("preset", "The documents that come with the program (`nply preset --json`)", report::preset),
    subject("fit-check", "Whether wires fit beside each other (`nply fit-check --json`)", report::fit_check),
    subject("stiffness", "What a strand or rope carries, and how stiffly (`nply stiffness --json`)", report::stiffness),
    subject("writhe", "The writhe of curves (`nply writhe --json`)", report::writhe),
    subject("link", "How curves are linked (`nply link --json`)", report::link),
    subject("clearance", "How near wires come to each other (`nply clearance --json`)", report::clearance),
    subject("nodes", "Start geometry of straight elements (`nply nodes --json`)", report::nodes),
];

impl Subject {
    /// The one of a name.
    #[must_use]
    pub fn named(all: &'static [Self], name: &str) -> Option<&'static Self> {
        all.iter().find(|subject| subject.name == name)
    }

    /// Its schema, whole.
    #[must_use]
    pub fn schema(&self) -> Value {
        node::whole_schema(&format!("nply: {}", self.name), self.about, (self.body)())
    }

    /// Its names as tables of Markdown: of a document the keys of every table, of a report the names of every object.
    ///
    /// ```
    /// use nply_sheet::schema::{DOCUMENTS, Subject};
    /// let page = Subject::named(&DOCUMENTS, "ply").map(Subject::markdown).unwrap_or_default();
    /// assert!(page.contains("| `radius` | a length, such as \"0.5 mm\" | Strand radius r |"));
    /// ```
    #[must_use]
    pub fn markdown(&self) -> String {
        table::markdown(self, &self.schema())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every name of a schema, with what it says.
    fn leaves(schema: &Value, at: &str, found: &mut Vec<(String, Value)>) {
        match schema {
            Value::Object(object) => {
                for (key, value) in object {
                    if key == "properties"
                        && let Value::Object(properties) = value
                    {
                        for (name, of) in properties {
                            found.push((format!("{at}.{name}"), of.clone()));
                            leaves(of, &format!("{at}.{name}"), found);
                        }
                    } else {
                        leaves(value, at, found);
                    }
                }
            }
            Value::Array(all) => all.iter().for_each(|one| leaves(one, at, found)),
            _ => {}
        }
    }

    #[test]
    fn every_name_says_what_it_means() {
        for subject in DOCUMENTS.iter().chain(&REPORTS) {
            let mut found = Vec::new();
            leaves(&subject.schema(), subject.name, &mut found);
            assert!(found.len() > 4, "{}", subject.name);
            for (name, schema) in found {
                let said = schema["description"].as_str().is_some_and(|said| !said.is_empty());
                assert!(said || schema.get("$ref").is_some() || schema.get("anyOf").is_some(), "{name}: {schema}");
            }
        }
    }

    #[test]
    fn no_meaning_is_of_nothing() {
        let all: String = REPORTS.iter().map(|subject| subject.schema().to_string()).collect();
        for (name, _) in &meaning::MEANINGS {
            assert!(all.contains(&format!("\"{name}\"")), "{name}");
        }
    }
}
