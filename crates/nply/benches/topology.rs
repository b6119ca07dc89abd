//! How fast: writhe and link of curves, by crossings and by pairs.
//!
//! `cargo bench -p nply --bench topology`. The trefoil, the closed six-ply and the two curves that wind four times round each other are
//! those of common comparisons: evenly sampled in their parameter, 10⁴ or 10⁵ points. The throughput is in points, or in pairs.
#![allow(missing_docs, clippy::unwrap_used, clippy::disallowed_methods)]

use std::f64::consts::{PI, TAU};
use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nply::geometry::Contact;
use nply::topology::{AverageCrossings, Curve, WritheMap, linking_number};

type Vector = [f64; 3];

fn trefoil(n: usize) -> Vec<Vector> {
    let point = |k: usize| {
        let t = TAU * k as f64 / n as f64;
        let r = 2.0 + (3.0 * t).cos();
        [r * (2.0 * t).cos(), r * (2.0 * t).sin(), (3.0 * t).sin()]
    };
    (0..n).map(point).collect()
}

fn torus_link(n: usize) -> [Curve; 2] {
    [0.0, PI].map(|phase| {
        let point = |k: usize| {
            let t = TAU * k as f64 / n as f64;
            let r = 2.0 + 0.7 * (4.0 * t + phase).cos();
            [r * t.cos(), r * t.sin(), 0.7 * (4.0 * t + phase).sin()]
        };
        Curve::closed((0..n).map(point).collect()).unwrap()
    })
}

/// Six strands at 20°, up and down in turn, joined by half circles; segments a quarter of a strand radius long.
fn six_ply(points: usize) -> Vec<Vector> {
    let contact = Contact::new(6, 20_f64.to_radians()).unwrap();
    let (radius, (sin, cos)) = (contact.radius_ratio(), 20_f64.to_radians().sin_cos());
    let chord = 2.0 * radius * (PI / 6.0).sin();
    let arc = 0.5 * PI * chord;
    let length = points as f64 * 0.25 / 6.0 - arc;
    let cap = ((arc / (length + arc) * points as f64 / 6.0).round() as usize).max(4);
    let strand = points / 6 - cap;
    let at = |psi: f64, s: f64| [radius * psi.sin(), -radius * psi.cos(), s * cos];
    let mut all = Vec::with_capacity(points);
    for i in 0..6 {
        let count = strand + usize::from(i < points - 6 * (strand + cap));
        let up = i % 2 == 0;
        let azimuth = |s: f64, i: usize| sin / radius * s + TAU * i as f64 / 6.0;
        for k in 0..count {
            let u = k as f64 / count as f64 * length;
            let s = if up { u } else { length - u };
            all.push(at(azimuth(s, i), s));
        }
        let end = if up { length } else { 0.0 };
        let (a, b) = (at(azimuth(end, i), end), at(azimuth(end, i + 1), end));
        for k in 0..cap {
            let (sin, cos) = (k as f64 / cap as f64 * PI).sin_cos();
            let mut p = [0, 1, 2].map(|x| 0.5 * (a[x] + b[x]) + 0.5 * (a[x] - b[x]) * cos);
            p[2] += 0.5 * chord * sin * if up { 1.0 } else { -1.0 };
            all.push(p);
        }
    }
    all
}

fn crossings(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("writhe");
    group.sample_size(30);
    for n in [10_000, 100_000] {
        group.throughput(Throughput::Elements(n as u64));
        for (name, points) in [("trefoil", trefoil(n)), ("six-ply", six_ply(n))] {
            let closed = Curve::closed(points.clone()).unwrap();
            group.bench_function(format!("closed {name}, {n}"), |b| b.iter(|| black_box(&closed).writhe().unwrap()));
            let open = Curve::open(points).unwrap();
            group.bench_function(format!("open {name}, {n}"), |b| b.iter(|| black_box(&open).writhe().unwrap()));
        }
    }
    let [one, other] = torus_link(100_000);
    group.throughput(Throughput::Elements(200_000));
    group.bench_function("linking number, 100000 x 100000", |b| {
        b.iter(|| linking_number(black_box(&one), &other).unwrap());
    });
    group.finish();
}

/// Pairs of segments, a column of sixty-four with all before it; and the writhe by segment.
fn pairs(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("pairs");
    group.sample_size(30);
    for (name, points) in [("trefoil", trefoil(10_000)), ("six-ply", six_ply(10_000))] {
        let curve = Curve::closed(points).unwrap();
        let work = AverageCrossings::new(&curve);
        let column = work.columns() - 2;
        group.throughput(Throughput::Elements(work.pairs(column..column + 1)));
        group.bench_function(format!("average crossings, {name}"), |b| {
            b.iter(|| work.share(black_box(column..column + 1)))
        });
        let map = WritheMap::new(&curve, 1e-3).unwrap();
        group.throughput(Throughput::Elements(10_000));
        group.sample_size(10);
        group.bench_function(format!("writhe by segment, {name}"), |b| {
            b.iter(|| (0..map.parts()).map(|part| map.part(part).bound).sum::<f64>());
        });
    }
    group.finish();
}

criterion_group!(benches, crossings, pairs);
criterion_main!(benches);
