//! The formulas that the example `compare` sets beside the exact geometry are those it names.
#![allow(clippy::unwrap_used, clippy::disallowed_methods, reason = "helpers of tests")]
#![allow(dead_code, reason = "the example's own pages are not printed here")]

#[path = "../examples/compare/layers.rs"]
mod layers;
#[path = "../examples/compare/page.rs"]
mod page;
#[path = "../examples/compare/wires.rs"]
mod wires;

use std::f64::consts::PI;

use layers::{ellipse, error, flat, perimeter};

/// The flat formula misses θ² cos²(π/n)/2, as its equation in the library says; the ellipse formula is right to third order.
#[test]
fn errors_have_their_order() {
    for n in [3, 4, 6, 12] {
        let half = (PI / f64::from(n)).cos();
        let small = 0.01;
        assert!((error(flat, n, small) / (small * small) / (-0.5 * half * half) - 1.0).abs() < 1e-3, "{n}");
        let (once, twice) = (error(ellipse, n, 0.05), error(ellipse, n, 0.1));
        assert!((twice / once - 16.0).abs() < 0.8, "{n}: {once} {twice}");
    }
}

/// With many wires the circle of lay and the polygon of their ellipses are one, up to (π/n)² (cos²θ − 2/3)/2.
#[test]
fn many_wires_fill_their_circle() {
    for angle in [0.0_f64, 0.3, 0.8] {
        let (n, c) = (600, angle.cos());
        let apart = perimeter(n, angle) / ellipse(n, angle) - 1.0;
        let half = PI / f64::from(n);
        assert!((apart / (-0.5 * half * half * (c * c - 2.0 / 3.0)) - 1.0).abs() < 1e-3, "{angle}: {apart}");
    }
}

/// Six circles fit round a seventh, six laid wires do not.
#[test]
fn five_wires_fit_on_one() {
    let page = wires::page().unwrap();
    assert!(page.lines().any(|line| line.starts_with("| 1 | 10.0° | 6 | 5 | 5 | 1, 0 |")), "{page}");
    // the chapter says that ellipses never promise a wire too many, or too few
    assert!(page.lines().skip(2).all(|line| line.ends_with(", 0 |")), "{page}");
}

#[test]
fn one_per_cent_is_found() {
    let square = |x: f64| x * x;
    let at = page::first_above(square, 0.01, 0.0, 1.0).unwrap();
    assert!((at - 0.1).abs() < 1e-12);
    assert!(page::first_above(square, 2.0, 0.0, 1.0).is_none());
}
