//! The figures' numbers against the theory: ends, crossings, limits, slopes; not their pixels.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::disallowed_methods)]

mod balanced;
mod contact;
mod gallery;
mod loads;
mod topology;

use nply_sheet::figure::{Data, Figure};

fn data(name: &str) -> Data {
    Figure::named(name).unwrap().unwrap().data
}

/// Two columns of the rows that begin with these words.
fn pairs(data: &Data, words: &[&str], x: &str, y: &str) -> Vec<(f64, f64)> {
    data.numbers(words, x).zip(data.numbers(words, y)).collect()
}

/// The value of a curve at a place, between its points; where it passes there several times, each.
fn crossings(curve: &[(f64, f64)], at: f64) -> Vec<f64> {
    let between = |pair: &[(f64, f64)]| {
        let ((a, u), (b, v)) = (pair[0], pair[1]);
        // a greater step is one from curve to curve
        ((a <= at) != (b <= at) && (a - b).abs() < 1.0).then(|| u + (v - u) * (at - a) / (b - a))
    };
    curve.windows(2).filter_map(between).collect()
}

fn close(found: f64, wanted: f64, by: f64) {
    assert!((found - wanted).abs() < by, "{found} instead of {wanted}");
}

fn last(curve: &[(f64, f64)]) -> f64 {
    let greatest = curve.iter().max_by(|a, b| a.0.total_cmp(&b.0));
    greatest.expect("a curve has points").1
}
