//! Contact between neighbouring strands by bisection of (5): slow, plain, and independent of the library.
#![allow(clippy::disallowed_methods)] // an independent route takes the platform's functions, not the library's

use std::f64::consts::{PI, TAU};

use nply::geometry::HelicalAngle;

/// The letters of section 2 at one angle, in the page's notation; r = 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Touch {
    pub(crate) n: f64,
    /// θ
    pub(crate) theta: f64,
    /// sin θ
    pub(crate) s: f64,
    /// cos θ
    pub(crate) c: f64,
    pub(crate) x: f64,
    pub(crate) rho: f64,
    /// (66)
    pub(crate) beta: f64,
}

/// Where `f` passes from below zero, at `low`, to zero or above, at `high`.
pub(crate) fn bisect(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if f(middle) < 0.0 { low = middle } else { high = middle }
    }
    high
}

/// The main branch.
pub(crate) fn touch(strands: u32, angle: HelicalAngle) -> Touch {
    let (theta, n) = (angle.radians(), f64::from(strands));
    let lambda = TAU / n;
    // near π/2 the complement has the digits
    let (s, c) = if theta < 1.0 { theta.sin_cos() } else { (angle.pitch_angle().cos(), angle.pitch_angle().sin()) };
    let (x, beta) = if strands == 2 && theta <= PI / 4.0 {
        (0.0, -PI)
    } else if theta < 1.0 {
        // (5) in x; for two strands sin(y − π) = −sin y keeps small x
        let five = |x: f64| {
            let sine = if strands == 2 { -(x * s).sin() } else { (x * s - lambda).sin() };
            x * c * c + s * sine
        };
        // the trivial solution of two strands is left below: x² s² > 2 (1 − cot²θ) on the other one
        let low = if strands == 2 { (2.0 * (s - c) * (s + c)).max(0.0).sqrt() / s / s } else { 0.0 };
        let x = bisect(five, low, lambda / s);
        (x, x * s - lambda)
    } else {
        // (5) in −β, which is small where rings lie flat; it rises up to arccos(−cot²θ) and holds the branch there
        let most = if strands == 2 { (-(c * c) / (s * s)).acos() } else { lambda };
        let e = bisect(|e| (e - lambda) * c * c + s * s * e.sin(), 0.0, most);
        ((lambda - e) / s, -e)
    };
    // (4), with 2 − 2 cos β = 4 sin²(β/2)
    let delta = 4.0 * (beta / 2.0).sin() * (beta / 2.0).sin() + x * x * c * c;
    Touch { n, theta, s, c, x, rho: 2.0 / delta.sqrt(), beta }
}

/// The main branch at θ in rad.
pub(crate) fn touch_at(strands: u32, theta: f64) -> Touch {
    touch(strands, HelicalAngle::new(theta).unwrap())
}

/// df/dt by Richardson's extrapolation of central differences with steps h and h/2: error of order h⁴.
pub(crate) fn slope(f: impl Fn(f64) -> f64, t: f64, h: f64) -> f64 {
    let d = |h: f64| (f(t + h) - f(t - h)) / (2.0 * h);
    (4.0 * d(h / 2.0) - d(h)) / 3.0
}
