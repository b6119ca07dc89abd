//! The closed centreline: one smooth curve that meets itself nowhere, whose own writhe is what the appendix adds up.

use std::f64::consts::TAU;

use nply::Handedness::{self, Right};
use nply::geometry::{Contact, HelicalAngle};
use nply::topology::{ClosedPly, Curve, Part, PlyWrithe};

use crate::common::vector::{Vector, cross, dot, norm, sub, times};

/// A closed ply of touching strands; one strand has the densest helix's radius.
fn closed(n: u32, theta: f64, hand: Handedness, turns: f64) -> ClosedPly {
    let radius = if n == 1 { 0.9 } else { Contact::new(n, theta).unwrap().radius_ratio() };
    let length = TAU * turns * radius / theta.sin();
    ClosedPly::new(n, HelicalAngle::new(theta).unwrap(), hand, radius, length).unwrap()
}

/// Writhe of the curve: of two polygons, their errors going as the tolerance.
fn writhe(curve: &ClosedPly) -> f64 {
    let of = |tolerance| Curve::closed(curve.points(tolerance).unwrap()).unwrap().writhe().unwrap().value;
    (4.0 * of(2e-4) - of(8e-4)) / 3.0
}

#[test]
fn one_curve_with_a_continuous_tangent() {
    for n in 1..=9 {
        for theta in [1e-3, 0.3, 0.8, 1.3] {
            for hand in Handedness::BOTH {
                let curve = closed(n, theta, hand, 2.3);
                let pieces = curve.pieces();
                for (i, piece) in pieces.iter().enumerate() {
                    let (end, next) = (piece.at(piece.length()), pieces[(i + 1) % pieces.len()].at(0.0));
                    let size = curve.length() * 1e-14;
                    assert!(
                        norm(sub(end[0], next[0])) < size && norm(sub(end[1], next[1])) < 1e-12,
                        "n = {n}, piece {i}"
                    );
                    let h = 1e-5 * piece.length().min(1.0);
                    let middle = 0.5 * piece.length();
                    let [before, after] = [piece.at(middle - h)[0], piece.at(middle + h)[0]];
                    let [_, tangent] = piece.at(middle);
                    assert!((norm(tangent) - 1.0).abs() < 1e-14);
                    let slope = sub(after, before).map(|x| x / (2.0 * h));
                    assert!(norm(sub(slope, tangent)) < 1e-9 + 1e-15 * curve.length() / h, "n = {n}, piece {i}");
                }
                let strands: Vec<u32> = pieces
                    .iter()
                    .filter_map(|p| match p.part() {
                        Part::Forward(i) if i % 2 == 0 => Some(i),
                        Part::Backward(i) if i % 2 == 1 => Some(i),
                        _ => None,
                    })
                    .collect();
                assert_eq!(strands, (0..n).collect::<Vec<_>>());
                let (s, l) = (0.3 * curve.length(), curve.length());
                assert!(norm(sub(curve.at(s)[0], curve.at(s - l)[0])) < 1e-10 * l);
            }
        }
    }
}

/// The closure lies in one plane through the axis, outside the ply.
#[test]
fn the_closure_is_planar() {
    for n in [1, 3, 5, 7] {
        for hand in Handedness::BOTH {
            let curve = closed(n, 0.6, hand, 2.8);
            let closure: Vec<_> = curve.pieces().iter().filter(|p| p.part() == Part::Closure).collect();
            let [x, y, _] = closure[1].at(0.0)[0];
            for piece in &closure {
                for i in 0..=20 {
                    let [position, tangent] = piece.at(piece.length() * f64::from(i) / 20.0);
                    let off = (position[0] * y - position[1] * x) / x.hypot(y);
                    let askew = (tangent[0] * y - tangent[1] * x) / x.hypot(y);
                    assert!(off.abs() < 1e-12 && askew.abs() < 1e-12, "n = {n}: {off} {askew}");
                }
            }
            let insert = curve.pieces().iter().find(|p| p.part() == Part::Insert).unwrap();
            assert!(insert.curvature() > 0.0 && insert.length() > 0.0);
        }
    }
}

/// Strands touch at a distance of two radii; nothing comes nearer to what is not next to it along the curve than that, or than a bend does to itself.
#[test]
fn no_part_meets_another() {
    for n in 1..=8 {
        for theta in [0.05, 0.4, 0.8, 1.2] {
            for hand in Handedness::BOTH {
                for turns in [0.1, 0.45, 0.8, 1.6] {
                    let curve = closed(n, theta, hand, turns);
                    let count = (curve.length() / 0.25) as u32;
                    let step = curve.length() / f64::from(count);
                    let points: Vec<_> = (0..count).map(|i| curve.at(step * f64::from(i))[0]).collect();
                    for (i, a) in points.iter().enumerate() {
                        for (j, b) in points.iter().enumerate().skip(i + 1) {
                            let along = step * ((j - i).min(points.len() - (j - i))) as f64;
                            let apart = norm(sub(*a, *b));
                            assert!(along < 4.0 || apart > 1.2, "n = {n}, {theta}, {turns}: {i} {j} {along} {apart}");
                        }
                    }
                }
            }
        }
    }
}

/// A polygon keeps within the tolerance: no point of the curve is further from it, and it has few corners more than that takes.
#[test]
fn polygons_are_as_near_as_asked() {
    let curve = closed(5, 0.7, Right, 1.4);
    for tolerance in [0.1, 1e-2, 1e-3] {
        let points = curve.points(tolerance).unwrap();
        let mut worst = 0.0_f64;
        for i in 0..1500 {
            let p = curve.at(curve.length() * f64::from(i) / 1500.0)[0];
            let from = |(a, b): (&Vector, &Vector)| {
                let (off, chord) = (sub(p, *a), sub(*b, *a));
                let share = (dot(off, chord) / dot(chord, chord)).clamp(0.0, 1.0);
                norm(sub(off, times(share, chord)))
            };
            let segments = points.iter().zip(points.iter().cycle().skip(1));
            worst = worst.max(segments.map(from).fold(f64::INFINITY, f64::min));
        }
        assert!(worst <= tolerance && (worst > 0.2 * tolerance || tolerance > 0.05), "{worst} for {tolerance}");
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-30] {
        assert_eq!(curve.points(bad).unwrap_err().quantity, "tolerance");
    }
}

/// (A.27) comes out of the very curve: what is left is the ends', the same at any length but for a change that dies away as 1/ψ_L. n = 1 is
/// Fuller's helix: 1 − cos θ a turn.
#[test]
fn numerical_writhe_is_the_analytic_sum_and_what_the_ends_add() {
    for n in 1..=7 {
        for theta in [0.3, 0.7, 1.2] {
            let hand = if n % 3 == 0 { Handedness::Left } else { Right };
            let angle = HelicalAngle::new(theta).unwrap();
            let [near, middle, far] = [7.3, 15.3, 31.3].map(|turns| {
                let sum = PlyWrithe::new(n, angle, hand, turns).unwrap().total();
                let got = writhe(&closed(n, theta, hand, turns));
                let rate = hand.sign() * (f64::from(n % 2) - f64::from(n) * theta.cos());
                assert!((sum.leading - rate * turns).abs() < 1e-12);
                assert!((got / turns - rate).abs() < 2.5 / turns, "n = {n}, {theta}, {turns} turns: {}", got / turns);
                got - sum.writhe
            });
            assert!(far.abs() < 2.0, "the ends add {far}");
            let (first, second) = ((middle - near).abs(), (far - middle).abs());
            assert!(second < 0.55 * first + 3e-5, "n = {n}, {theta}: {near} {middle} {far}");
            assert!(first < 0.02, "n = {n}, {theta}: {near} {middle}");
        }
    }
}

/// (A.4) itself as a double sum over points of the smooth curve, and the polygon's writhe.
#[test]
fn double_integral_over_the_curve() {
    for (n, hand) in [(2, Right), (3, Right), (3, Handedness::Left)] {
        let curve = closed(n, 0.7, hand, 0.8);
        let count = 3000;
        let step = curve.length() / f64::from(count);
        let points: Vec<_> = (0..count).map(|i| curve.at(step * (f64::from(i) + 0.5))).collect();
        let mut sum = 0.0;
        for (i, [r, t]) in points.iter().enumerate() {
            for [other, along] in &points[..i] {
                let d = sub(*r, *other);
                sum += dot(d, cross(*t, *along)) / norm(d).powi(3);
            }
        }
        let got = sum * step * step / TAU;
        assert!((got - writhe(&curve)).abs() < 1e-3, "n = {n}: {got} {}", writhe(&curve));
    }
}

#[test]
fn refusals() {
    let of = |n, theta: f64, radius, length| {
        ClosedPly::new(n, HelicalAngle::new(theta).unwrap(), Right, radius, length).map_err(|e| e.quantity)
    };
    assert_eq!(of(0, 0.5, 1.0, 1.0).unwrap_err(), "strands");
    assert_eq!(of(3, 0.0, 1.0, 1.0).unwrap_err(), "helical_angle");
    assert_eq!(of(u32::MAX, 0.5, 1.0, 1.0).unwrap_err(), "strands");
    assert_eq!(of(1, 1e-300, 1.0, 1.0).unwrap_err(), "helical_angle");
    assert!(of(2, 0.0, 1.0, 1.0).is_ok() && of(1, 0.0, 1.0, 1.0).is_ok());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(of(3, 0.5, bad, 1.0).unwrap_err(), "radius_ratio");
        assert_eq!(of(3, 0.5, 1.0, bad).unwrap_err(), "strand_length");
    }
}
