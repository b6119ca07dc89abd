//! What is wrong, for a page.

use nply::DomainError;
use nply_sheet::SpecError;
use serde_json::{Value, json};

/// `{"error": …}` of a document: the sentence, the lines as the command shows them, and which key is meant.
pub(crate) fn of_document(error: &SpecError, text: &str) -> String {
    let sentence = error.to_string();
    let about = json!({
        "sentence": sentence,
        "message": error.message(),
        "help": error.help(),
        "shown": error.render(text).trim_end(),
        "key": error.key(),
        "line": error.line(),
        "column": error.column(),
        "exit_code": error.exit_code(),
    });
    wrapped(about)
}

/// `{"error": …}` of numbers.
pub(crate) fn of_numbers(error: &DomainError) -> String {
    wrapped(json!({ "sentence": error.to_string() }))
}

fn wrapped(about: Value) -> String {
    json!({ "error": about }).to_string()
}
