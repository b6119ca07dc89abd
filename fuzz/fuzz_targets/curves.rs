//! Any bytes as a file of curves, of every format: finite points, or one sentence.
#![no_main]

use libfuzzer_sys::fuzz_target;
use nply_sheet::curves::{Closing, CurveSet, Curves, Format};

fuzz_target!(|bytes: &[u8]| {
    for format in core::iter::once(None).chain(Format::ALL.map(Some)) {
        match Curves::read("fuzz", bytes, format) {
            Ok(curves) => {
                for curve in &curves.curves {
                    assert!(curve.points.len() > 1 && curve.points.as_flattened().iter().all(|x| x.is_finite()));
                }
                let set = CurveSet::of(vec![("fuzz".to_owned(), curves)], None, Closing::AsWritten).expect("one file");
                let _ = set.members.iter().map(|member| member.length()).sum::<f64>();
            }
            Err(error) => assert_eq!(error.to_string().lines().count(), 1, "{error}"),
        }
    }
});
