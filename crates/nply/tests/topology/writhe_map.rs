//! The writhe's shares by segment.

use std::f64::consts::TAU;

use nply::topology::{Curve, CurveError, WritheMap};

use crate::curves::{closed, gauss, harmonics, open, tangle, torus_knot};

fn shares(curve: &Curve, tolerance: f64) -> (Vec<f64>, f64) {
    let map = WritheMap::new(curve, tolerance).unwrap();
    let mut all = Vec::new();
    let mut bound = 0.0;
    for part in 0..map.parts() {
        let part = map.part(part);
        assert_eq!(part.first, all.len());
        all.extend(part.shares);
        bound += part.bound;
    }
    (all, bound)
}

#[test]
fn each_share_is_its_sum_over_pairs() {
    for curve in [closed(torus_knot(600, 2, 3)), open(harmonics(500, 3)), closed(tangle(150, 2))] {
        let n = curve.segments();
        let (got, bound) = shares(&curve, 1e-5);
        for i in (0..n).step_by(37) {
            let joined = |j: usize| i.abs_diff(j) <= 1 || (curve.is_closed() && i.abs_diff(j) + 1 == n);
            let want: f64 = (0..n).filter(|&j| !joined(j)).map(|j| gauss(curve.segment(i), curve.segment(j))).sum();
            assert!((got[i] - want).abs() < 2e-8 + bound, "{i} of {n}: {} {want}", got[i]);
        }
    }
}

/// A long helix on a circle: far pieces are expanded, and the sum is the writhe within the bound, which is within the tolerance.
#[test]
fn they_add_up_to_the_writhe_within_their_bound() {
    let n = 6_000;
    let coil = |k: usize| {
        let t = TAU * k as f64 / n as f64;
        let (r, psi) = (40.0 + (60.0 * t).cos(), 60.0 * t);
        [r * t.cos(), r * t.sin(), psi.sin()]
    };
    for curve in [closed((0..n).map(coil).collect()), open((0..n).map(coil).collect())] {
        let want = curve.writhe().unwrap();
        for tolerance in [1e-1, 1e-4] {
            let (got, bound) = shares(&curve, tolerance);
            let off = (got.iter().sum::<f64>() - want.value).abs();
            assert!(off <= bound + want.bound && bound <= 1.1 * tolerance, "{off} {bound} {tolerance}");
        }
    }
}

#[test]
fn a_tolerance_is_above_nought() {
    let curve = closed(tangle(5, 1));
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(WritheMap::new(&curve, tolerance), Err(CurveError::Domain(_))));
    }
}
