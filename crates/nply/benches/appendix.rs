//! How fast: every writhe contribution of a uniform ply, all n² entries, at any length.
//!
//! `cargo bench -p nply --bench appendix`. Lengths of 0.5, 5.3 and 10⁸ turns; angles of 20°, 45° and 60°, and flat strands at 80° and 89°.
#![allow(missing_docs, clippy::unwrap_used)]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use nply::Handedness::Right;
use nply::geometry::HelicalAngle;
use nply::topology::PlyWrithe;

fn ply_writhe(c: &mut Criterion) {
    let mut group = c.benchmark_group("ply writhe");
    group.sample_size(20);
    for degrees in [20, 45, 60, 80, 89] {
        let angle = HelicalAngle::new(f64::from(degrees).to_radians()).unwrap();
        for strands in [2, 3, 7, 12] {
            for turns in [0.5, 5.3, 1e8] {
                group.bench_function(format!("{degrees} degrees, n = {strands}, {turns} turns"), |b| {
                    b.iter(|| PlyWrithe::new(black_box(strands), angle, Right, black_box(turns)).unwrap().total());
                });
            }
        }
    }
    group.finish();
}

criterion_group!(benches, ply_writhe);
criterion_main!(benches);
