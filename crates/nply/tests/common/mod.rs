//! What the test files share: golden tables, contact found the slow way, vectors.
#![allow(dead_code, clippy::unwrap_used, clippy::panic)] // no file uses all of it, and a test may panic

pub(crate) mod touch;
pub(crate) mod vector;

use std::collections::HashMap;

/// One row of a table, by the names of its columns.
pub(crate) struct Row(HashMap<String, String>);

impl Row {
    pub(crate) fn text(&self, column: &str) -> &str {
        self.0.get(column).unwrap_or_else(|| panic!("no column {column}"))
    }

    pub(crate) fn number(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or_else(|_| panic!("{column} = {}", self.text(column)))
    }

    pub(crate) fn strands(&self) -> u32 {
        self.text("n").parse().unwrap()
    }
}

/// All rows of `authorities/<name>.csv`, of which there are more than ten.
pub(crate) fn table(name: &str) -> Vec<Row> {
    let rows = short_table(name);
    assert!(rows.len() > 10, "{name} has lost its rows");
    rows
}

/// All rows of a table that may be as short as one row.
pub(crate) fn short_table(name: &str) -> Vec<Row> {
    let path = format!("{}/../../authorities/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Row> = lines
        .map(|line| Row(head.iter().zip(line.split(',')).map(|(k, v)| ((*k).to_owned(), v.to_owned())).collect()))
        .collect();
    assert!(!rows.is_empty(), "{path} is empty");
    rows
}

/// Panics unless `got` is within `tolerance`·|want| of `want`; a zero of the table (below 1e-40) wants an exact zero.
#[track_caller]
pub(crate) fn assert_relative(got: f64, want: f64, tolerance: f64, what: &str) {
    let scale = if want.abs() < 1e-40 { 0.0 } else { want.abs() };
    assert!(
        (got - if scale > 0.0 { want } else { 0.0 }).abs() <= tolerance * scale,
        "{what}: {got:e}, wanted {want:e}"
    );
}
