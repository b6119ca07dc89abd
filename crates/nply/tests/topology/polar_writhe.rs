//! Polar writhe.

use std::f64::consts::{PI, TAU};

use proptest::prelude::*;

use crate::config;
use crate::curves::{closed, harmonics, mirrored, open, tangle, turned};

/// A helix between two planes has a local part alone: the area its tangent sweeps round the pole, 1 − cos θ for each turn.
#[test]
fn of_a_helix_between_planes() {
    let theta: f64 = 0.7;
    let helix = (0..=10_000).map(|k| {
        let psi = 3.0 * TAU * f64::from(k) / 10_000.0;
        [psi.cos(), psi.sin(), psi / theta.tan()]
    });
    let polar = open(helix.collect()).polar_writhe([0.0, 0.0, 2.0]).unwrap();
    assert_eq!(polar.nonlocal, 0.0);
    assert!((polar.local - 3.0 * (1.0 - theta.cos())).abs() < 1e-3, "{polar:?}");
}

/// Two halves of a right-handed double helix, one up and one down, turn round each other.
#[test]
fn of_a_plectoneme_between_planes() {
    let strand = |phase: f64| {
        (0..=400).map(move |k| {
            let psi = 2.0 * TAU * f64::from(k) / 400.0;
            [(psi + phase).cos(), (psi + phase).sin(), psi]
        })
    };
    let top = [0.0, 0.0, 2.0 * TAU + 1.0];
    let points = strand(0.0).chain([top]).chain(strand(PI).collect::<Vec<_>>().into_iter().rev());
    let polar = open(points.collect()).polar_writhe([0.0, 0.0, 1.0]).unwrap();
    assert!((polar.nonlocal + 4.0).abs() < 1e-12, "{polar:?}");
}

proptest! {
    #![proptest_config(config(40))]

    /// Of a closed curve it is the writhe, along whatever axis.
    #[test]
    fn of_a_closed_curve_it_is_the_writhe(seed in 1_u64..10_000, smooth: bool) {
        let points = if smooth { harmonics(200, seed) } else { tangle(40, seed) };
        let curve = closed(points);
        let writhe = curve.writhe().unwrap().value;
        for axis in [[0.0, 0.0, 1.0], [0.3, -0.8, 0.1], [5.0, 1.0, -2.0]] {
            let polar = curve.polar_writhe(axis).unwrap();
            prop_assert!((polar.value() - writhe).abs() < 1e-9, "{axis:?} {polar:?} {writhe}");
        }
    }

    /// It turns with the curve and its axis; a mirror changes the sign.
    #[test]
    fn it_turns_with_its_axis(seed in 1_u64..10_000) {
        let points = tangle(40, seed);
        let axis = [0.2, 0.5, -0.7];
        let want = open(points.clone()).polar_writhe(axis).unwrap().value();
        let turned_axis = turned(&[axis], seed)[0];
        prop_assert!((open(turned(&points, seed)).polar_writhe(turned_axis).unwrap().value() - want).abs() < 1e-9);
        let other_axis = [axis[0], axis[1], -axis[2]];
        prop_assert!((open(mirrored(&points)).polar_writhe(other_axis).unwrap().value() + want).abs() < 1e-9);
    }
}
