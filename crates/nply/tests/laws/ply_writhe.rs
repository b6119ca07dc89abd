//! Writhe of a uniform ply: the same by every route, at any length, of both hands.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nply::Handedness::{Left, Right};
use nply::geometry::{Centreline, Contact, HelicalAngle};
use nply::topology::{Curve, PlyLink, PlyWrithe, linking_integral};
use proptest::prelude::*;

use crate::config;

fn ply(n: u32, theta: f64, turns: f64) -> PlyWrithe {
    PlyWrithe::new(n, HelicalAngle::new(theta).unwrap(), Right, turns).unwrap()
}

/// What one rad of ψ_L adds to the writhe of a pair: each strand's new end with all of the other, which is the cosine of a chord.
fn growth(theta: f64, alpha: f64, u: f64) -> f64 {
    let cosine = |alpha: f64| {
        let across = 2.0 * ((u - alpha) / 2.0).sin() * theta.sin();
        u * theta.cos() / across.hypot(u * theta.cos())
    };
    if alpha == 0.0 { (cosine(0.0) - theta.cos()) / TAU } else { (cosine(alpha) + cosine(-alpha)) / (2.0 * TAU) }
}

fn simpson(f: impl Fn(f64) -> f64, from: f64, to: f64, n: u32) -> f64 {
    let h = (to - from) / f64::from(2 * n);
    let weight = |i: u32| if i == 0 || i == 2 * n { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
    (0..=2 * n).map(|i| weight(i) * f(from + h * f64::from(i))).sum::<f64>() * h / 3.0
}

proptest! {
    #![proptest_config(config(300))]

    /// From one length to a greater one, within the reach of one way of summing or from one to another.
    #[test]
    fn grows_by_the_chords(
        theta in 0.02..1.5_f64, n in 1..30_u32, share in 0.0..1.0_f64,
        turns in prop_oneof![0.3..3.0_f64, 3.0..7.0_f64, 7.0..300.0_f64], more in 0.01..1.5_f64,
    ) {
        let i = (share * f64::from(n)) as u32;
        let alpha = TAU * f64::from(i.min(n - i)) / f64::from(n);
        let (short, long) = (ply(n, theta, turns).pair(i), ply(n, theta, turns + more).pair(i));
        let want = simpson(|u| growth(theta, alpha, u), TAU * turns, TAU * (turns + more), 3000);
        let rate = if i == 0 { 1.0 - theta.cos() } else { 1.0 };
        let bound = 1e-12 + short.error_bound + long.error_bound;
        prop_assert!((long.remainder - short.remainder + rate * more - want).abs() < bound, "{short:?} {long:?} {want}");
        prop_assert!((long.writhe - short.writhe - want).abs() < bound + 1e-15 * long.writhe);
        prop_assert!(long.error_bound < 1e-10 && short.error_bound < 1e-10, "{long:?}");
        prop_assert!((long.leading - rate * (turns + more)).abs() < 1e-13 * (turns + more));
    }

    #[test]
    fn mirror_image_and_symmetries(theta in 0.0..FRAC_PI_2, n in 1..20_u32, turns in 0.0..40.0_f64) {
        let angle = HelicalAngle::new(theta).unwrap();
        let (right, left) = (PlyWrithe::new(n, angle, Right, turns).unwrap(), PlyWrithe::new(n, angle, Left, turns).unwrap());
        prop_assert_eq!(right.total().writhe, -left.total().writhe);
        let twice = PlyWrithe::new(2 * n, angle, Right, turns).unwrap();
        let mut sum = 0.0;
        for i in 0..n {
            prop_assert_eq!(right.pair(i).writhe, -left.pair(i).writhe);
            prop_assert_eq!(right.pair(i).remainder, -left.pair(i).remainder);
            prop_assert_eq!(right.pair(i), right.pair(n - i)); // i = 0: with itself
            prop_assert!(right.pair(i).writhe >= 0.0 && right.pair(i).writhe <= turns * (1.0 + 1e-15));
            // a pair knows its angle, not the number of strands
            prop_assert!((right.pair(i).writhe - twice.pair(2 * i).writhe).abs() < 2e-12);
            for j in 0..n {
                prop_assert_eq!(right.entry(i, j), right.entry(j, i));
                sum += right.entry(i, j).writhe;
            }
        }
        prop_assert!((right.total().writhe - sum).abs() < 1e-12 * (1.0 + turns * f64::from(n * n)));
    }
}

/// (A.15)–(A.27) are limits: what is left stays bounded, and settles as 1/ψ_L.
#[test]
fn the_remainder_settles() {
    for n in 1..=12 {
        for theta in [1e-3, 0.3, 0.7, 1.1, 1.4, 1.55] {
            let at = |turns| ply(n, theta, turns).total().remainder;
            let scale = (0.1 + theta.tan().powi(2)) * f64::from(n * n);
            for turns in [1e3, 1e5, 1e8] {
                let change = (at(4.0 * turns) - at(turns)).abs();
                assert!(change < scale / turns + 1e-10, "n = {n}, {theta}, {turns} turns: {change}");
            }
        }
    }
}

/// C − cos θ starts as cos θ sin²θ u²/24, so that W starts as cos θ sin²θ ψ³/144π.
#[test]
fn a_short_strand_keeps_its_digits() {
    for theta in [1e-4_f64, 0.3, 1.0, 1.5] {
        for psi in [1e-3_f64, 1e-5] {
            let want = theta.cos() * theta.sin().powi(2) * psi * psi * psi / (144.0 * PI);
            let got = ply(1, theta, psi / TAU).itself().writhe;
            assert!((got / want - 1.0).abs() < psi * psi, "{theta} {psi}: {got} {want}");
        }
    }
}

#[test]
fn both_ends_of_the_angle() {
    let straight = ply(5, 0.0, 7.3);
    assert_eq!(straight.itself().writhe, 0.0);
    assert!((straight.pair(2).writhe - 7.3).abs() < 1e-14 && straight.pair(1).remainder.abs() < 1e-14);
    for pitch in [1e-3, 1e-6, 1e-9, 1e-12, 1e-100, 1e-150] {
        // rings on top of each other: a strand with itself or another writhes a turn for a turn, less what is as great where 1/pitch turns have not been reached
        let angle = HelicalAngle::from_pitch_angle(pitch).unwrap();
        for turns in [0.5, 30.0, 1e8] {
            let ply = PlyWrithe::new(3, angle, Right, turns).unwrap();
            for i in 0..2 {
                let got = ply.pair(i);
                assert!(
                    (0.0..=turns).contains(&got.writhe) && got.error_bound < 1e-15 * turns.max(1e4 / pitch),
                    "{got:?}"
                );
            }
        }
    }
}

/// The strands themselves as open polygons, by crossings: the very integral (A.4), without its reduction.
#[test]
fn polygons_through_the_strands() {
    for (n, theta, turns, hand) in
        [(2, 0.3, 6.4, Right), (3, 0.8, 1.3, Left), (5, 1.25, 2.7, Right), (6, 0.7, 9.1, Left)]
    {
        let contact = Contact::new(n, theta).unwrap();
        let length = TAU * turns * contact.radius_ratio() / theta.sin();
        let strand = |i: u32, segments: u32| {
            let line = Centreline::new(&contact, hand, i);
            let at = |k: u32| line.position(length * f64::from(k) / f64::from(segments));
            Curve::open((0..=segments).map(at).collect()).unwrap()
        };
        // errors as the square of the segments' length
        let refined = |of: &dyn Fn(u32) -> f64| (4.0 * of(4000) - of(2000)) / 3.0;
        let ply = PlyWrithe::of_ply(&contact, hand, length).unwrap();
        let itself = refined(&|segments| strand(0, segments).writhe().unwrap().value);
        assert!((itself - ply.itself().writhe).abs() < 1e-7, "n = {n}: {itself} {:?}", ply.itself());
        for i in 1..n {
            let pair = refined(&|s| linking_integral(&strand(0, s), &strand(i, s)).unwrap().value);
            assert!((pair - ply.pair(i).writhe).abs() < 1e-7, "n = {n}, {i}: {pair} {:?}", ply.pair(i));
        }
    }
}

#[test]
fn refusals() {
    let angle = HelicalAngle::new(0.5).unwrap();
    for turns in [-1.0, f64::NAN, f64::INFINITY, 2e15] {
        assert_eq!(PlyWrithe::new(2, angle, Right, turns).unwrap_err().quantity, "turns");
    }
    assert_eq!(PlyWrithe::new(u32::MAX, angle, Right, 1.0).unwrap_err().quantity, "strands");
    assert_eq!(PlyWrithe::new(0, angle, Right, 1.0).unwrap_err().quantity, "strands");
    assert_eq!(PlyLink::straight(2, f64::NAN).unwrap_err().quantity, "end_rotation");
    let other = PlyLink::straight(3, 1.0).unwrap().wound(&ply(2, 0.5, 1.0));
    assert_eq!(other.unwrap_err().quantity, "strands");
}
