//! Writhe.

use std::f64::consts::{PI, TAU};

use proptest::prelude::*;

use crate::config;
use crate::curves::{Vector, closed, harmonics, mirrored, open, tangle, torus_knot, turned, writhe_by_pairs};

#[test]
fn crossings_less_twist_is_the_sum_over_pairs() {
    for n in [4, 5, 6, 7, 8, 9, 12, 17, 40, 64, 65, 129, 200] {
        for seed in 0..6 {
            let curve = closed(tangle(n, seed + 1));
            let (got, want) = (curve.writhe().unwrap(), writhe_by_pairs(&curve));
            assert!((got.value - want).abs() < 1e-10, "{n} {seed}: {got:?} {want}");
            let curve = open(tangle(n, seed + 1));
            let (got, want) = (curve.writhe().unwrap(), writhe_by_pairs(&curve));
            assert!((got.value - want).abs() < 1e-10, "open {n} {seed}: {got:?} {want}");
        }
    }
    for (p, q) in [(2, 3), (2, -3), (3, 5), (1, 7)] {
        let curve = closed(torus_knot(300, p, q));
        let (got, want) = (curve.writhe().unwrap(), writhe_by_pairs(&curve));
        // four arcsines lose digits between nearly parallel segments
        assert!((got.value - want).abs() < 1e-7, "{p} {q}: {got:?} {want}");
    }
}

#[test]
fn a_right_handed_trefoil_has_positive_writhe_and_a_right_handed_plectoneme_negative() {
    let trefoil = closed(torus_knot(200, 2, 3)).writhe().unwrap();
    assert!((3.0..4.0).contains(&trefoil.value), "{trefoil:?}");
    // two strands of a right-handed helix, up and down, joined by straight pieces
    let (turns, per_turn) = (5, 60);
    let strand = |phase: f64| {
        (0..=turns * per_turn).map(move |k| {
            let psi = TAU * f64::from(k) / f64::from(per_turn);
            [(psi + phase).cos(), (psi + phase).sin(), psi]
        })
    };
    let plectoneme: Vec<Vector> = strand(0.0).chain(strand(PI).collect::<Vec<_>>().into_iter().rev()).collect();
    let plectoneme = closed(plectoneme).writhe().unwrap();
    // (A.27) with n = 2 and tan θ = 1: −n cos θ for each turn, less what the ends bound
    assert!((plectoneme.value / 5.0 + 2.0 * 0.5_f64.sqrt()).abs() < 0.2, "{plectoneme:?}");
}

#[test]
fn a_plane_curve_has_none() {
    for seed in 0..20 {
        // a star-shaped polygon, in a plane of any direction
        let radii = tangle(50, seed + 3);
        let flat: Vec<Vector> = radii
            .iter()
            .enumerate()
            .map(|(k, r)| {
                let (sin, cos) = (TAU * k as f64 / 50.0).sin_cos();
                [(0.2 + r[0]) * cos, (0.2 + r[0]) * sin, 0.0]
            })
            .collect();
        for points in [flat.clone(), turned(&flat, seed)] {
            let writhe = closed(points.clone()).writhe().unwrap();
            assert!(writhe.value.abs() < 1e-12 && writhe.discrepancy < 1e-12, "{writhe:?}");
            assert!(open(points).writhe().unwrap().value.abs() < 1e-12);
        }
    }
}

#[test]
fn a_circle_run_through_twice_has_writhe_one_in_the_limit() {
    let twice = |gap: f64, n: usize| {
        let point = |k: usize| {
            let t = 2.0 * TAU * k as f64 / n as f64;
            [t.cos() * (1.0 + gap * (0.5 * t).cos()), t.sin() * (1.0 + gap * (0.5 * t).cos()), gap * (0.5 * t).sin()]
        };
        closed((0..n).map(point).collect()).writhe().unwrap().value
    };
    let values = [0.1, 0.03, 0.01].map(|gap| (twice(gap, 6000).abs() - 1.0).abs());
    assert!(values[0] > values[1] && values[1] > values[2] && values[2] < 1e-2, "{values:?}");
    // closer than the segments are long, and still told apart
    assert!((twice(1e-9, 2000).abs() - 1.0).abs() < 1e-5);
}

#[test]
fn many_turns_round_a_straight_line_have_that_many_less_their_slope() {
    // (A.27)'s strand with itself: 1 − cos θ for each turn of a long helix
    let theta: f64 = 0.6;
    let (turns, per_turn) = (400, 48);
    let helix = (0..turns * per_turn).map(|k| {
        let psi = TAU * f64::from(k) / f64::from(per_turn);
        [psi.cos(), psi.sin(), psi / theta.tan()]
    });
    let per_turn = open(helix.collect()).writhe().unwrap().value / f64::from(turns);
    assert!((per_turn - (1.0 - theta.cos())).abs() < 1.5e-3, "{per_turn}");
}

#[test]
fn segments_of_all_lengths_stand_beside_each_other() {
    let mut points = torus_knot(40, 2, 3);
    // one corner replaced by a copy of a knotted tangle, ten orders smaller
    let corner = points[7];
    let small = tangle(60, 9).into_iter().map(|p| [0, 1, 2].map(|k| corner[k] + 1e-10 * p[k]));
    points.splice(7..8, small.collect::<Vec<_>>());
    let curve = closed(points);
    let (got, want) = (curve.writhe().unwrap(), writhe_by_pairs(&curve));
    assert!((got.value - want).abs() < 1e-6, "{got:?} {want}");
    assert!(got.discrepancy < 1e-9);
}

#[test]
fn ends_that_meet_make_no_difference() {
    let mut points = torus_knot(90, 3, 4);
    let round = closed(points.clone()).writhe().unwrap();
    points.push(points[0]);
    assert_eq!(open(points).writhe().unwrap(), round);
}

#[test]
fn what_is_prolonged_along_its_tangents_counts_as_segments_do() {
    use nply::topology::Along;
    for along in [Along::Tangents, Along::Chord] {
        let curve = open(tangle(30, 5)).extended(20.0, along).unwrap();
        assert_eq!(curve.segments(), 31);
        let (got, want) = (curve.writhe().unwrap(), writhe_by_pairs(&curve));
        // four arcsines lose digits between segments nearly on a line
        assert!((got.value - want).abs() < 1e-7, "{along:?} {got:?} {want}");
    }
}

proptest! {
    #![proptest_config(config(40))]

    /// Shape alone counts: not size, place, direction, sense or beginning; a mirror changes the sign.
    #[test]
    fn shape_alone_counts(seed in 1_u64..1000, size in -200..200_i32, shift in -3.0..3.0_f64, by in 0_usize..80, tangled: bool, is_closed: bool) {
        let points = if tangled { tangle(80, seed) } else { harmonics(80, seed) };
        let of = |points: Vec<Vector>| if is_closed { closed(points) } else { open(points) }.writhe().unwrap().value;
        let want = of(points.clone());
        let tolerance = 1e-9;
        let scale = 10_f64.powi(size);
        prop_assert!((of(points.iter().map(|p| p.map(|x| scale * x)).collect()) - want).abs() < tolerance, "size");
        prop_assert!((of(points.iter().map(|p| p.map(|x| x + shift)).collect()) - want).abs() < tolerance, "place");
        prop_assert!((of(turned(&points, seed)) - want).abs() < tolerance, "direction");
        prop_assert!((of(points.iter().rev().copied().collect()) - want).abs() < tolerance, "sense");
        prop_assert!((of(mirrored(&points)) + want).abs() < tolerance, "mirror");
        if is_closed {
            let mut other = points;
            other.rotate_left(by);
            prop_assert!((of(other) - want).abs() < tolerance, "beginning");
        }
    }
}
