//! authorities/published.toml: every difference between a published number and ours is the one that is stated, and a changed digit is seen.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

#[path = "../examples/validate/ours.rs"]
mod ours;
#[path = "../examples/validate/published.rs"]
mod published;
#[path = "../examples/validate/table.rs"]
mod table;
#[path = "../examples/validate/theory.rs"]
mod theory;
#[path = "../examples/validate/verdict.rs"]
mod verdict;

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::LazyLock;

use ours::Ours;
use published::Published;
use verdict::{Agreement, Row};

static PUBLISHED: LazyLock<Published> = LazyLock::new(|| {
    let text = std::fs::read_to_string(root().join("authorities/published.toml")).unwrap();
    Published::read(&text).unwrap()
});

static ROWS: LazyLock<Vec<Row<'static>>> = LazyLock::new(|| {
    let mut ours = Ours::new(PathBuf::from(env!("CARGO_BIN_EXE_nply")), root());
    verdict::rows(&PUBLISHED, |number| ours.of(number)).unwrap()
});

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn every_difference_is_the_one_that_is_stated() {
    assert!(ROWS.len() > 50);
    let astray: Vec<String> = ROWS
        .iter()
        .filter(|row| !row.holds())
        .map(|row| {
            let stated = row.number.difference.unwrap_or(0.0);
            format!("{}: {} less {} is not {stated}", row.number.id, row.ours.unwrap(), row.number.published)
        })
        .collect();
    assert!(astray.is_empty(), "{astray:#?}");
}

/// One unit more or less in the last printed digit of any published number, and its row no longer holds.
#[test]
fn a_changed_last_digit_is_seen() {
    for row in ROWS.iter().filter(|row| row.ours.is_some()) {
        for sign in [1.0, -1.0] {
            let mut changed = row.clone();
            changed.published.value += sign * row.published.last_digit();
            // exactly between two digits both would do: state the difference with a digit more
            assert!(!changed.holds(), "{}: {} for {}", row.number.id, changed.published.value, row.published.value);
        }
    }
}

/// A difference is stated where there is one, and then with a reason; nowhere else.
#[test]
fn differences_have_reasons() {
    for row in ROWS.iter() {
        let number = row.number;
        let reason = number.why.as_ref().is_some_and(|why| why.len() > 8 && why.ends_with('.'));
        match row.agreement() {
            Agreement::Digits => assert!(number.difference.is_none(), "{} agrees", number.id),
            Agreement::Tolerance => assert!(number.within_because.is_some(), "{}", number.id),
            Agreement::Differs => assert!(number.difference.is_some() && reason, "{} differs", number.id),
            Agreement::NotRemade => assert!(reason, "{} is not worked out", number.id),
        }
    }
}

#[test]
fn names_and_sources_are_known() {
    let mut seen = HashSet::new();
    for number in &PUBLISHED.numbers {
        assert!(seen.insert(&number.id), "{} twice", number.id);
        assert!(PUBLISHED.source(number).is_some(), "{}: no source {}", number.id, number.source);
    }
    for source in &PUBLISHED.sources {
        assert!(PUBLISHED.numbers.iter().any(|number| number.source == source.id), "{} gives nothing", source.id);
    }
}

/// Page and JSON have each number.
#[test]
fn the_table_is_whole() {
    let page = table::markdown(&PUBLISHED, &ROWS);
    let rows = page.lines().filter(|line| line.starts_with("| ") && line.contains("<small>source"));
    assert_eq!(rows.filter(|line| line.as_bytes()[2].is_ascii_digit()).count(), ROWS.len());
    // a cell is never empty, not even for a zero
    assert!(
        !page.lines().any(|line| line.starts_with("| ") && line.contains("<small>source") && line.contains("|  |")),
        "{page}"
    );
    let json = table::json(&PUBLISHED, &ROWS);
    assert_eq!(json["numbers"].as_array().unwrap().len(), ROWS.len());
    let counted: u64 =
        ["every_digit", "within", "differs", "not_remade"].iter().map(|key| json[key].as_u64().unwrap()).sum();
    assert_eq!(counted, ROWS.len() as u64);
}
