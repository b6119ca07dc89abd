//! Any bytes as a file of curves of one format, which the first byte chooses, so that the depths of each are reached: finite points that
//! every report takes, or one sentence.
#![no_main]

use libfuzzer_sys::fuzz_target;
use nply_sheet::curves::{Closing, CurveSet, Curves, Format};
use nply_sheet::{ClearanceReport, LinkReport, WritheQuestion, WritheReport};

fuzz_target!(|bytes: &[u8]| {
    let Some((choice, bytes)) = bytes.split_first() else { return };
    let format = Format::ALL[usize::from(*choice) % Format::ALL.len()];
    match Curves::read("fuzz", bytes, Some(format)) {
        Ok(curves) => {
            for curve in &curves.curves {
                assert!(curve.points.len() > 1 && curve.points.as_flattened().iter().all(|x| x.is_finite()));
                assert!(curve.diameter.is_none_or(|diameter| diameter.is_finite() && diameter >= 0.0));
            }
            for note in &curves.notes {
                assert_eq!(note.lines().count(), 1, "{note}");
            }
            reports(&curves);
        }
        Err(error) => assert_eq!(error.to_string().lines().count(), 1, "{error}"),
    }
});

/// What the commands on curves do with them, where it does not take long.
fn reports(curves: &Curves) {
    if curves.points() > 60 || curves.curves.len() > 4 {
        return;
    }
    let set = |closing| CurveSet::of(vec![("fuzz".to_owned(), curves.clone())], None, closing);
    for closing in [Closing::AsWritten, Closing::Closed, Closing::Open] {
        let Ok(set) = set(closing) else { continue };
        if let Ok(report) = WritheReport::new(set.clone(), WritheQuestion::default()) {
            for number in 0..report.len() {
                if let Ok(writhing) = report.writhing(number, None) {
                    assert!(!format!("{writhing:?}").contains("NaN"), "{writhing:?}");
                }
            }
        }
        if let Ok(report) = LinkReport::new(set.clone(), None) {
            let pairs: Vec<_> = report.pairs().collect();
            for pair in pairs {
                let _ = report.link(pair);
            }
        }
        let _ = ClearanceReport::new(set, &["0.1"]);
    }
}
