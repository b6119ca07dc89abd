//! How fast: all equilibria of a map of 1000 × 1000 pairs of loads, row by row, against one by one; the locus p = 0; a path.
//!
//! `cargo bench -p nply --bench map`. Three strands, γ = 0.75, φ̄a = −0.2, f in [−2, 2], m in [−3, 3]; the angle and the pressure of
//! every state of either hand are kept. The throughput is in pixels.
#![allow(missing_docs, clippy::unwrap_used)]

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nply::mechanics::{Along, Balance, Contacts, Data, Load, Path, Ply, Route, Twist};

const SIDE: usize = 1000;
/// States of one pixel that are kept.
const MOST: usize = 6;

fn even(low: f64, high: f64) -> Vec<f64> {
    (0..SIDE).map(|i| low + (high - low) * i as f64 / (SIDE - 1) as f64).collect()
}

/// Angle and pressure of the states of each pixel in one row, and how many they are.
struct Row {
    count: Vec<u8>,
    angle: Vec<[f64; MOST]>,
    pressure: Vec<[f64; MOST]>,
}

impl Row {
    fn new() -> Self {
        Self { count: vec![0; SIDE], angle: vec![[f64::NAN; MOST]; SIDE], pressure: vec![[f64::NAN; MOST]; SIDE] }
    }

    #[inline]
    fn push(&mut self, pixel: usize, angle: f64, pressure: f64) {
        let k = usize::from(self.count[pixel]);
        if k < MOST {
            self.angle[pixel][k] = angle;
            self.pressure[pixel][k] = pressure;
            self.count[pixel] += 1;
        }
    }
}

fn map(ply: &Ply, along: Along, row: &mut Row) -> usize {
    let twist = Twist::Pretwist(-0.2);
    let (forces, moments) = (even(-2.0, 2.0), even(-3.0, 3.0));
    let (values, others) = if along == Along::Force { (&forces, &moments) } else { (&moments, &forces) };
    let mut states = 0;
    for &other in others {
        row.count.fill(0);
        let load = Load { force: other, moment: other };
        ply.each_equilibrium_along(along, values, twist, load, |pixel, state| {
            row.push(pixel, state.handedness.sign() * state.helical_angle, state.resultant_pressure);
        })
        .unwrap();
        states += row.count.iter().map(|&count| usize::from(count)).sum::<usize>();
        black_box(&row.angle);
        black_box(&row.pressure);
    }
    states
}

fn one_by_one(ply: &Ply, moment: f64, row: &mut Row) {
    row.count.fill(0);
    for (pixel, &force) in even(-2.0, 2.0).iter().enumerate() {
        ply.each_equilibrium(Twist::Pretwist(-0.2), Load { force, moment }, |state| {
            let angle = state.handedness().sign() * state.contact().helical_angle();
            row.push(pixel, angle, state.resultant_pressure());
        })
        .unwrap();
    }
    black_box(&row.angle);
    black_box(&row.pressure);
}

fn maps(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("map");
    let mut row = Row::new();
    for balance in Balance::BOTH {
        let ply = Ply::with_balance(3, 0.75, balance).unwrap();
        group.sample_size(20).throughput(Throughput::Elements((SIDE * SIDE) as u64));
        for along in [Along::Force, Along::Moment] {
            let name = format!("{}, rows along the {}", balance.name(), along.name());
            group.bench_function(name, |b| b.iter(|| map(&ply, along, &mut row)));
        }
        group.throughput(Throughput::Elements(SIDE as u64));
        group.bench_function(format!("{}, one by one (one row)", balance.name()), |b| {
            b.iter(|| one_by_one(&ply, black_box(0.7), &mut row));
        });
    }
    group.finish();
}

/// p = 0 at 1000 angles of both hands, and a state followed along a path.
fn curves(criterion: &mut Criterion) {
    let ply = Ply::new(3, 0.75).unwrap();
    criterion.bench_function("locus p = 0, 2 x 1000 points", |b| {
        b.iter(|| ply.separation_locus(black_box(Twist::Pretwist(-0.2)), 1000).unwrap());
    });
    let at = |force| Data {
        stiffness_ratio: 0.75,
        twist: Twist::Pretwist(-0.2),
        ends: Load { force, moment: 3.0 }.into(),
        core_radius: None,
    };
    let path = Path::new(3, at(0.5), at(-0.2), Contacts::Unilateral).unwrap();
    let start = path.starts().unwrap()[0];
    criterion.bench_function("a path of some 50 steps", |b| {
        b.iter(|| path.trace(black_box(&start), &Route::default()).unwrap());
    });
}

criterion_group!(benches, maps, curves);
criterion_main!(benches);
