//! How fast: the index of a bundle of twisted wires, and the search for what is near and what overlaps.
//!
//! `cargo bench -p nply --bench clearance`. 400 wires of 250 segments on a hexagonal grid a diameter wide, twisted together; the throughput is
//! in segments.
#![allow(missing_docs, clippy::unwrap_used)]

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nply::geometry::{Clearance, Vector, Wire, Wires};

fn bundle() -> Vec<Vec<Vector>> {
    let place = |i: u32| {
        let (row, column) = (i / 20, i % 20);
        [f64::from(column) + 0.5 * f64::from(row % 2) - 10.0, 0.75_f64.sqrt() * f64::from(row) - 9.0]
    };
    let wire = |i: u32| {
        let [x, y] = place(i);
        (0..=250).map(move |k| {
            let z = 0.3 * f64::from(k);
            let (sin, cos) = libm::sincos(0.01 * z);
            [x * cos - y * sin, x * sin + y * cos, z]
        })
    };
    (0..400).map(|i| wire(i).collect()).collect()
}

fn clearance(criterion: &mut Criterion) {
    let bundle = bundle();
    let wires = |diameter: f64| -> Vec<Wire<'_>> {
        bundle.iter().map(|points| Wire { points, closed: false, diameter }).collect()
    };
    let mut group = criterion.benchmark_group("clearance");
    group.sample_size(10).throughput(Throughput::Elements(100_000));
    group.bench_function("index", |bencher| bencher.iter(|| Wires::new(black_box(&wires(0.95))).unwrap()));
    for diameter in [0.9, 1.1] {
        let index = Wires::new(&wires(diameter)).unwrap();
        group.bench_function(format!("search, diameter {diameter}"), |bencher| {
            bencher.iter(|| index.search(0..index.segments(), black_box(&Clearance::default())));
        });
    }
    group.finish();
}

criterion_group!(benches, clearance);
criterion_main!(benches);
