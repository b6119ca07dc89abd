//! How fast: whole arrays of plies at once.
//!
//! `cargo bench -p nply --bench batch`. Contact: n = 2 … 12 in any order and angles in (1e-3, π/2 − 1e-3). Equilibria: n = 2 … 12, γ in
//! (0.6, 1), pretwist in (−2, 2), the first half unloaded, the second with f in (−1, 1) and m in (−4, 4). The throughput is in rows.
#![allow(missing_docs, clippy::unwrap_used)]

use std::f64::consts::FRAC_PI_2;
use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nply::geometry::contact_batch;
use nply::mechanics::{Balance, Plies, States, Twists};

const COUNT: usize = 100_000;

/// A small generator of uniform numbers, the same in every run.
struct Uniform(u64);

impl Uniform {
    fn next(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn contact(c: &mut Criterion) {
    let mut random = Uniform(1);
    let strands: Vec<u32> = (0..COUNT).map(|_| random.next(2.0, 13.0) as u32).collect();
    let angles: Vec<f64> = (0..COUNT).map(|_| random.next(1e-3, FRAC_PI_2 - 1e-3)).collect();
    let (mut shift, mut radius) = (vec![0.0; COUNT], vec![0.0; COUNT]);
    let mut group = c.benchmark_group("batch");
    group.throughput(Throughput::Elements(COUNT as u64));
    group.bench_function("contact", |b| {
        b.iter(|| {
            contact_batch(black_box(&strands), black_box(&angles), &mut shift, &mut radius, |_, _| ()).unwrap();
            black_box((&shift, &radius));
        });
    });
    group.finish();
}

fn equilibria(c: &mut Criterion) {
    let mut random = Uniform(2);
    let mut list = |low: f64, high: f64| -> Vec<f64> { (0..COUNT).map(|_| random.next(low, high)).collect() };
    let strands: Vec<u32> = list(2.0, 13.0).into_iter().map(|n| n as u32).collect();
    let (stiffness_ratio, twist) = (list(0.6, 1.0), list(-2.0, 2.0));
    let (mut force, mut moment) = (list(-1.0, 1.0), list(-4.0, 4.0));
    force[..COUNT / 2].fill(0.0);
    moment[..COUNT / 2].fill(0.0);
    let plies = Plies {
        strands: &strands,
        stiffness_ratio: &stiffness_ratio,
        twist: Twists::Pretwist(&twist),
        force: &force,
        moment: &moment,
    };
    let mut states = States::new();
    let mut group = c.benchmark_group("batch");
    group.throughput(Throughput::Elements(COUNT as u64));
    for balance in Balance::BOTH {
        group.bench_function(format!("equilibria, {}", balance.name()), |b| {
            b.iter(|| {
                black_box(&plies).equilibria(balance, &mut states).unwrap();
                black_box(&states);
            });
        });
    }
    group.finish();
}

criterion_group!(batch, contact, equilibria);
criterion_main!(batch);
