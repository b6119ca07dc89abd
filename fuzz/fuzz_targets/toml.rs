//! Any bytes as a file: read, understood, solved and written in every form, or refused in one sentence.
#![no_main]

use std::time::Duration;

use cpu_time::ProcessTime;
use libfuzzer_sys::fuzz_target;
use nply_sheet::{Report, ShapeReport, Spec, SpecError, TraceReport, Walk};

fn refused(error: &SpecError, text: &str) {
    assert_eq!(error.to_string().lines().count(), 1, "{error}");
    assert!(error.line().is_some() && error.column().is_some(), "{error}");
    assert!(error.render(text).contains("--> "), "{error}");
}

fn is_json(text: &str) {
    let read: serde_json::Value = serde_json::from_str(text).expect("JSON");
    assert!(read.is_object());
}

fuzz_target!(|bytes: &[u8]| {
    let begin = ProcessTime::now();
    read_and_report(bytes);
    assert!(begin.elapsed() < LONGEST, "{:?}", begin.elapsed());
});

/// No answer may take more of the processor.
const LONGEST: Duration = Duration::from_millis(250);

fn read_and_report(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let spec = match Spec::from_bytes("fuzz.toml", bytes) {
        Ok(spec) => spec,
        Err(error) => return refused(&error, &text),
    };
    match spec.check().and_then(Report::of) {
        Ok(report) => {
            let table = report.text(true);
            assert!(!table.contains("NaN") || report.case.title.is_some(), "{table}");
            is_json(&report.json());
            let csv = report.csv();
            let mut rows = csv.lines().map(|row| row.split(',').count());
            let head = rows.next();
            assert!(rows.all(|cells| Some(cells) == head));
            for state in &report.solution.states {
                let angle = state.contact().helical_angle();
                assert!(angle > 0.0 || report.solution.straight.is_none(), "{angle}");
                assert!(angle <= core::f64::consts::FRAC_PI_2, "{angle}");
            }
        }
        Err(error) => refused(&error, &text),
    }
    study(&spec, &text);
    match spec.check_shape().and_then(|shape| ShapeReport::of(shape, 4)) {
        Ok(report) => {
            let _ = report.text(false);
            is_json(&report.json());
        }
        Err(error) => refused(&error, &text),
    }
}

/// A path or a map in the file: walked, or its first row worked out, or refused in one sentence.
fn study(spec: &Spec, text: &str) {
    match spec.check_path(None).and_then(|cases| TraceReport::of(cases, Walk::default())) {
        Ok(report) => {
            let table = report.text(true);
            assert!(!table.contains("NaN") || table.starts_with(char::is_alphabetic), "{table}");
            is_json(&report.json());
        }
        Err(error) => assert_eq!(error.to_string().lines().count(), 1, "{error}"),
    }
    match spec.check_map(None) {
        Ok(map) if map.x.count <= 1000 => drop(map.row(0)),
        Ok(_) => {}
        Err(error) => {
            assert_eq!(error.to_string().lines().count(), 1, "{error}");
            let _ = error.render(text);
        }
    }
}
