//! Any bytes as a layered strand: whether its wires fit, what it carries, its shape, or one sentence.
#![no_main]

use std::time::Duration;

use cpu_time::ProcessTime;
use libfuzzer_sys::fuzz_target;
use nply_sheet::construction::ConstructionSpec;
use nply_sheet::mesh::Layered;
use nply_sheet::{FitReport, SpecError, StiffnessReport};

fn refused(error: &SpecError, text: &str) {
    assert_eq!(error.to_string().lines().count(), 1, "{error}");
    let _ = error.render(text);
}

fn is_whole(text: &str, json: &str, csv: &str, title: bool) {
    assert!(title || !text.contains("NaN"), "{text}");
    let _: serde_json::Value = serde_json::from_str(json).expect("JSON");
    assert!(title || !csv.contains("NaN"), "{csv}");
}

fuzz_target!(|bytes: &[u8]| {
    let begin = ProcessTime::now();
    let text = String::from_utf8_lossy(bytes);
    let spec = match ConstructionSpec::from_bytes("fuzz.toml", bytes) {
        Ok(spec) => spec,
        Err(error) => return refused(&error, &text),
    };
    let title = text.contains("NaN");
    match spec.check_fit().map(FitReport::of) {
        Ok(report) => is_whole(&report.text(true), &report.json(), &report.csv(), title),
        Err(error) => refused(&error, &text),
    }
    match spec.check_cable().and_then(|case| StiffnessReport::of(&spec, case)) {
        Ok(report) => is_whole(&report.text(true), &report.json(), &report.csv(), title),
        Err(error) => refused(&error, &text),
    }
    if let Err(error) = Layered::of(&spec) {
        refused(&error, &text);
    }
    assert!(begin.elapsed() < LONGEST, "{:?}", begin.elapsed());
});

/// No answer may take more of the processor.
const LONGEST: Duration = Duration::from_secs(1);
