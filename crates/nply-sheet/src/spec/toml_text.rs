//! A datum as a file has it.

use super::{Entry, Value};
use crate::{Kind, Quantity};

/// A text in quotation marks, as TOML has it.
pub(crate) fn toml_text(text: &str) -> String {
    let escaped: String = text
        .chars()
        .flat_map(|c| match c {
            '"' => "\\\"".chars().collect::<Vec<_>>(),
            '\\' => "\\\\".chars().collect(),
            c if c.is_control() => format!("\\u{:04x}", c as u32).chars().collect(),
            c => vec![c],
        })
        .collect();
    format!("\"{escaped}\"")
}

impl Entry {
    /// The value as a file has it.
    pub(crate) fn as_toml(&self) -> String {
        match &self.value {
            Value::Switch(switch) => switch.to_string(),
            Value::Balance(balance) => format!("\"{}\"", balance.name()),
            Value::Hand(hand) => format!("\"{}\"", if hand.sign() > 0.0 { "right" } else { "left" }),
            Value::Text(text) => toml_text(text),
            Value::Quantity(Quantity::Bare(value)) if self.key.kind == Kind::Count => value.to_string(),
            Value::Quantity(Quantity::Bare(value)) => format!("{value:?}"),
            // as it was written, whose last digit is that of the value
            Value::Quantity(Quantity::Measured { .. }) => toml_text(self.written.trim_matches('"')),
        }
    }
}
