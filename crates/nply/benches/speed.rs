//! How fast: one contact, all equilibria of one ply, and the same by a naive bracketing solver.
//!
//! `cargo bench -p nply`. The cases are those a sweep meets: n = 2 … 12, γ in (0.6, 1), pretwist in (−2, 2), half of them
//! loaded with f in (−1, 1) and m in (−4, 4).
#![allow(missing_docs, clippy::unwrap_used, clippy::disallowed_methods)]

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nply::geometry::Contact;
use nply::mechanics::{Balance, Load, Ply, Twist};

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

const COUNT: usize = 4096;

fn contacts() -> Vec<(u32, f64)> {
    let mut random = Uniform(1);
    (0..COUNT).map(|i| (2 + (i % 11) as u32, random.next(1e-3, std::f64::consts::FRAC_PI_2 - 1e-3))).collect()
}

#[derive(Clone, Copy)]
struct Case {
    n: u32,
    gamma: f64,
    pretwist: f64,
    f: f64,
    m: f64,
}

fn cases() -> Vec<Case> {
    let mut random = Uniform(2);
    (0..COUNT)
        .map(|i| {
            let loaded = if i % 2 == 0 { 0.0 } else { 1.0 };
            Case {
                n: 2 + (random.next(0.0, 11.0) as u32),
                gamma: random.next(0.6, 1.0),
                pretwist: random.next(-2.0, 2.0),
                f: loaded * random.next(-1.0, 1.0),
                m: loaded * random.next(-4.0, 4.0),
            }
        })
        .collect()
}

/// What one writes first: scan 400 angles of each hand for a change of sign, then bisect, with (5) bisected inside.
mod naive {
    use super::Case;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn bisect(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
        let sign = f(low) > 0.0;
        for _ in 0..52 {
            let middle = 0.5 * (low + high);
            if (f(middle) > 0.0) == sign { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    pub(super) fn contact(n: u32, theta: f64) -> (f64, f64) {
        let lambda = 2.0 * PI / f64::from(n);
        let e = theta.tan() * theta.tan();
        if n == 2 && e <= 1.0 {
            return (0.0, 1.0);
        }
        let top = if e > 1.0 { lambda.min((-1.0 / e).acos()) } else { lambda };
        let anomaly = bisect(1e-12, top, |t| t + e * t.sin() - lambda);
        let (sh, ch) = (0.5 * anomaly).sin_cos();
        ((lambda - anomaly) / theta.sin(), 1.0 / (sh * (1.0 + e * ch * ch).sqrt()))
    }

    pub(super) fn roots(case: &Case, mut found: impl FnMut(f64)) {
        let Case { n, gamma, pretwist, f, m } = *case;
        let n_ = f64::from(n);
        for eps in [1.0, -1.0] {
            let balance = |theta: f64| {
                let rho = contact(n, theta).1;
                let (s, c) = theta.sin_cos();
                2.0 * n_ * s * s * s * c
                    + n_ * gamma * s * c * (c * c - s * s)
                    + eps * n_ * gamma * pretwist * rho * (c * c - s * s)
                    + rho * rho * f * s
                    - eps * rho * m * c
            };
            let at = |i: u32| f64::from(i) / 400.0 * FRAC_PI_2 * 0.999_999 + 1e-7;
            let mut before = balance(at(0));
            for i in 1..=400 {
                let here = balance(at(i));
                if (here > 0.0) != (before > 0.0) {
                    found(bisect(at(i - 1), at(i), balance));
                }
                before = here;
            }
        }
    }
}

fn contact(c: &mut Criterion) {
    let inputs = contacts();
    let mut group = c.benchmark_group("contact");
    group.throughput(Throughput::Elements(COUNT as u64));
    group.bench_function("nply", |b| {
        b.iter(|| {
            let mut sum = 0.0;
            for &(n, theta) in black_box(&inputs) {
                let contact = Contact::new(n, theta).unwrap();
                sum += contact.arclength_shift() + contact.radius_ratio();
            }
            sum
        });
    });
    group.bench_function("naive bisection", |b| {
        b.iter(|| black_box(&inputs).iter().map(|&(n, theta)| naive::contact(n, theta).1).sum::<f64>());
    });
    group.finish();
}

fn equilibria(c: &mut Criterion) {
    let inputs = cases();
    let mut group = c.benchmark_group("equilibria");
    group.throughput(Throughput::Elements(COUNT as u64));
    for balance in Balance::BOTH {
        group.bench_function(balance.name(), |b| {
            b.iter(|| {
                let mut sum = 0.0;
                for case in black_box(&inputs) {
                    let ply = Ply::with_balance(case.n, case.gamma, balance).unwrap();
                    let load = Load { force: case.f, moment: case.m };
                    ply.each_equilibrium(Twist::Pretwist(case.pretwist), load, |s| sum += s.contact().helical_angle())
                        .unwrap();
                }
                sum
            });
        });
    }
    let few = &inputs[..256];
    group.sample_size(10).throughput(Throughput::Elements(few.len() as u64));
    group.bench_function("naive scan and bisection, radial", |b| {
        b.iter(|| {
            let mut sum = 0.0;
            for case in black_box(few) {
                naive::roots(case, |theta| sum += theta);
            }
            sum
        });
    });
    group.finish();
}

criterion_group!(speed, contact, equilibria);
criterion_main!(speed);
