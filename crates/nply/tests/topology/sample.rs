//! Smooth curves.

use std::f64::consts::{PI, TAU};

use nply::topology::{Curve, CurveError};

/// (A.4) of a torus knot by the trapezoidal rule, extrapolated: the integrand behaves as |s − t| on the diagonal, so that the error falls
/// as 1/n² and 1/n⁴.
fn double_integral(p: f64, q: f64) -> f64 {
    let [coarse, middle, fine] = [300, 600, 1200].map(|n| trapezoids(p, q, n));
    let (first, second) = ((4.0 * middle - coarse) / 3.0, (4.0 * fine - middle) / 3.0);
    (16.0 * second - first) / 15.0
}

/// On a grid whose nodes never meet.
fn trapezoids(p: f64, q: f64, n: i32) -> f64 {
    let at = |t: f64| {
        let r = 2.0 + (q * t).cos();
        let place = [r * (p * t).cos(), r * (p * t).sin(), -(q * t).sin()];
        let (dr, dz) = (-q * (q * t).sin(), -q * (q * t).cos());
        let slope = [dr * (p * t).cos() - p * r * (p * t).sin(), dr * (p * t).sin() + p * r * (p * t).cos(), dz];
        (place, slope)
    };
    let h = TAU / f64::from(n);
    let even: Vec<_> = (0..n).map(|k| at(h * f64::from(k))).collect();
    let odd: Vec<_> = (0..n).map(|k| at(h * (f64::from(k) + 0.5))).collect();
    let mut sum = 0.0;
    for (r, dr) in &even {
        for (s, ds) in &odd {
            let d = crate::vector::sub(*r, *s);
            let size = crate::vector::norm(d);
            sum += crate::vector::dot(d, crate::vector::cross(*dr, *ds)) / (size * size * size);
        }
    }
    sum * h * h / (4.0 * PI)
}

fn knot(p: f64, q: f64) -> impl Fn(f64) -> [f64; 3] {
    move |t| {
        let (phi, psi) = (TAU * p * t, TAU * q * t);
        [(2.0 + psi.cos()) * phi.cos(), (2.0 + psi.cos()) * phi.sin(), -psi.sin()]
    }
}

#[test]
fn torus_knots_have_the_writhe_of_their_double_integral() {
    for (p, q) in [(2.0, 3.0), (3.0, 4.0), (2.0, -5.0)] {
        let want = double_integral(p, q);
        for tolerance in [1e-4, 1e-8, 1e-11] {
            let got = Curve::sample_closed(knot(p, q), tolerance).unwrap();
            assert!(got.error <= tolerance);
            assert!((got.writhe - want).abs() < tolerance + 2e-10, "{p} {q}: {} {want} {tolerance}", got.writhe);
            let own = got.polygon.writhe().unwrap().value;
            assert!(((own - got.writhe).abs() - got.polygon_error).abs() < 1e-14);
        }
    }
}

#[test]
fn an_open_arc_of_a_helix() {
    // (A.8)'s first integral, the strand with itself: for long helices 1 − cos θ for each turn, and a bounded remainder
    let theta: f64 = 0.5;
    let helix =
        |turns: f64| move |t: f64| [(TAU * turns * t).cos(), (TAU * turns * t).sin(), TAU * turns * t / theta.tan()];
    let [short, long] = [20.0, 40.0].map(|turns| Curve::sample_open(helix(turns), 1e-8).unwrap().writhe);
    assert!((long - short - 20.0 * (1.0 - theta.cos())).abs() < 2e-3, "{short} {long}");
}

#[test]
fn what_cannot_be_sampled_is_said() {
    assert!(matches!(Curve::sample_closed(knot(2.0, 3.0), f64::NAN), Err(CurveError::Domain(_))));
    assert!(matches!(Curve::sample_closed(|_| [1.0, 2.0, 3.0], 1e-3), Err(CurveError::Repeated { .. })));
    assert!(matches!(Curve::sample_open(|t| [t, 1.0 / (t - 0.5), 0.0], 1e-3), Err(CurveError::NotFinite { .. })));
}
