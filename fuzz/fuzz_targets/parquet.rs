//! Any bytes as a Parquet file whose rows are data, or as a table that was left unfinished: answers, or one sentence.
#![no_main]

use std::io::Cursor;
use std::sync::Once;

use libfuzzer_sys::fuzz_target;
use nply_sheet::Spec;
use nply_sheet::sweep::{Study, SweepFlags};
use nply_sheet::table::{BlockFile, Column, Encoder, Format, Kind, Mark, TableReader, panic_is_caught};

static HOOK: Once = Once::new();

fuzz_target!(|bytes: &[u8]| {
    // what the library of Parquet does with a damaged file is caught
    HOOK.call_once(|| {
        let end = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            if !panic_is_caught() {
                end(panic);
            }
        }));
    });
    let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "0.75")]).expect("a ply");
    let flags = SweepFlags { rows: Some("fuzz.parquet".to_owned()), ..SweepFlags::default() };
    let study = Study::from_spec(&ply, &flags).expect("a study");
    match TableReader::open(Format::Parquet, Cursor::new(bytes.to_vec()), 64, 0) {
        Ok(mut table) => {
            let given = table.columns().to_vec();
            let asked = study.given_columns(&given).is_ok();
            for _ in 0..4 {
                match table.next_chunk() {
                    Ok(Some(cells)) if asked => drop(study.solve_given(&given, &cells)),
                    Ok(Some(_)) => {}
                    Ok(None) => break,
                    Err(error) => {
                        assert_eq!(error.to_string().lines().count(), 1, "{error}");
                        break;
                    }
                }
            }
        }
        Err(error) => assert_eq!(error.to_string().lines().count(), 1, "{error}"),
    }
    left_off(bytes);
});

/// The same bytes as what an earlier run left, with marks where its blocks ended.
fn left_off(bytes: &[u8]) {
    for format in [Format::Csv, Format::Arrow] {
        let columns = vec![Column::new("force", Kind::Float), Column::new("reason", Kind::Text)];
        let encoder = Encoder::new(format, columns, &[]).expect("columns");
        let marks: Vec<Mark> =
            (1..3).map(|part| Mark { bytes: (bytes.len() * part / 2) as u64, tail: Vec::new() }).collect();
        let _ = BlockFile::resumed(&encoder, Vec::new(), Cursor::new(bytes.to_vec()), &marks).map(|(file, _)| file.finish());
    }
}
