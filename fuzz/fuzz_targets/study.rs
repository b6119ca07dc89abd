//! Any text as a study: a description, and behind each NUL what varies as a flag says it; its first rows, and its curves, or one sentence.
#![no_main]

use std::time::Duration;

use cpu_time::ProcessTime;
use libfuzzer_sys::fuzz_target;
use nply_sheet::graph::GraphFlags;
use nply_sheet::sweep::{Study, SweepFlags};
use nply_sheet::table::Values;
use nply_sheet::{Spec, SpecError};

fn refused(error: &SpecError) {
    assert_eq!(error.to_string().lines().count(), 1, "{error}");
}

fuzz_target!(|text: &str| {
    let begin = ProcessTime::now();
    let mut parts = text.split('\0');
    let Some(document) = parts.next() else { return };
    let sweep: Vec<String> = parts.map(str::to_owned).take(4).collect();
    let spec = match Spec::from_toml("fuzz.toml", document) {
        Ok(spec) => spec,
        Err(error) => return refused(&error),
    };
    if let Some(runs) = sweep.first() {
        let flags = GraphFlags { sweep: runs.clone(), ask: vec!["helical_angle".to_owned()], ..GraphFlags::default() };
        if let Err(error) = spec.check_graph(&flags) {
            refused(&error);
        }
    }
    match Study::from_spec(&spec, &SweepFlags { sweep, ..SweepFlags::default() }) {
        Ok(study) if study.takes_rows() => {}
        Ok(study) => {
            let _ = study.text();
            for first in [0, study.rows().saturating_sub(3)] {
                let chunk = study.chunk(first, 3);
                let length = chunk.first().map_or(0, Values::len);
                assert_eq!(chunk.len(), study.columns().len());
                for values in &chunk {
                    assert_eq!(values.len(), length);
                    match values {
                        Values::Dense(cells) => assert!(!cells.iter().any(|cell| cell.is_nan())),
                        Values::Float(cells) => assert!(!cells.iter().flatten().any(|cell| cell.is_nan())),
                        _ => {}
                    }
                }
            }
        }
        Err(error) => refused(&error),
    }
    assert!(begin.elapsed() < LONGEST, "{:?}", begin.elapsed());
});

/// No answer may take more of the processor.
const LONGEST: Duration = Duration::from_secs(1);
