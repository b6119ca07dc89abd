//! Any bytes as a table in CSV: measurements that are fitted, and rows that are solved, or one sentence.
#![no_main]

use std::io::Cursor;

use libfuzzer_sys::fuzz_target;
use nply_sheet::regression::{Measurements, RegressionQuestion, RegressionReport};
use nply_sheet::sweep::{Study, SweepFlags};
use nply_sheet::table::{Format, TableReader, Values};
use nply_sheet::{Spec, SpecError};

const BARE: &[(&str, &str)] = &[("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-1")];
const SIZED: &[(&str, &str)] = &[
    ("strands", "2"),
    ("diameter", "0.5 mm"),
    ("bending-stiffness", "1 N mm^2"),
    ("stiffness-ratio", "1"),
    ("turns-per-length", "-0.2 turns/mm"),
];
const ASKED: [&str; 6] =
    ["stiffness_ratio", "pretwist", "bending_stiffness", "diameter", "turns_per_length", "strand_twist"];

fn one_sentence(error: &SpecError) {
    assert_eq!(error.to_string().lines().count(), 1, "{error}");
}

fuzz_target!(|bytes: &[u8]| {
    let [choice, question, bytes @ ..] = bytes else { return };
    let flags = if choice & 1 == 0 { BARE } else { SIZED };
    let ply = Spec::from_flags(flags.iter().copied()).expect("a ply");
    match Measurements::read("fuzz.csv", bytes) {
        Ok(data) if data.lines().len() <= 12 => {
            let estimate = (0..ASKED.len()).filter(|bit| question >> bit & 1 == 1);
            let question = RegressionQuestion {
                estimate: estimate.map(|bit| ASKED[bit].to_owned()).collect(),
                measured: data.names().first().filter(|_| choice & 2 != 0).map(|name| (*name).to_owned()).into_iter().collect(),
                starts: Some(1),
                ..RegressionQuestion::default()
            };
            match RegressionReport::of(&ply, &data, &question) {
                Ok(report) => {
                    let _: serde_json::Value = serde_json::from_str(&report.json()).expect("JSON");
                    assert!(!report.csv().contains("NaN"));
                    let _ = report.text(true);
                }
                Err(error) => one_sentence(&error),
            }
        }
        Ok(_) => {}
        Err(error) => one_sentence(&error),
    }
    rows(&ply, bytes);
});

/// The same bytes as rows of a sweep.
fn rows(ply: &Spec, bytes: &[u8]) {
    let flags = SweepFlags { rows: Some("fuzz.csv".to_owned()), ..SweepFlags::default() };
    let study = match Study::from_spec(ply, &flags) {
        Ok(study) => study,
        Err(error) => return one_sentence(&error),
    };
    let mut table = match TableReader::open(Format::Csv, Cursor::new(bytes.to_vec()), 8, 0) {
        Ok(table) => table,
        Err(error) => return assert_eq!(error.to_string().lines().count(), 1, "{error}"),
    };
    let given = table.columns().to_vec();
    if let Err(error) = study.given_columns(&given) {
        return one_sentence(&error);
    }
    match table.next_chunk() {
        Ok(Some(cells)) => match study.solve_given(&given, &cells) {
            Ok((places, answers)) => {
                for values in &answers {
                    assert_eq!(values.len(), places.len());
                    no_nan(values);
                }
            }
            Err(error) => one_sentence(&error),
        },
        Ok(None) => {}
        Err(error) => assert_eq!(error.to_string().lines().count(), 1, "{error}"),
    }
}

fn no_nan(values: &Values) {
    match values {
        Values::Dense(cells) => assert!(!cells.iter().any(|cell| cell.is_nan())),
        Values::Float(cells) => assert!(!cells.iter().flatten().any(|cell| cell.is_nan())),
        _ => {}
    }
}
