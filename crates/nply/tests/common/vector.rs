//! Vectors in space.
#![allow(clippy::disallowed_methods)] // plain functions of the platform are good enough here

pub(crate) type Vector = [f64; 3];

pub(crate) fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn sub(a: Vector, b: Vector) -> Vector {
    add(a, times(-1.0, b))
}

pub(crate) fn times(k: f64, a: Vector) -> Vector {
    [k * a[0], k * a[1], k * a[2]]
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// df/ds by Richardson's extrapolation.
pub(crate) fn derivative(f: impl Fn(f64) -> Vector, s: f64, h: f64) -> Vector {
    let d = |h: f64| times(0.5 / h, sub(f(s + h), f(s - h)));
    let (coarse, fine) = (d(h), d(h / 2.0));
    times(1.0 / 3.0, sub(times(4.0, fine), coarse))
}

/// Panics unless two vectors are within `tolerance` of each other.
#[track_caller]
pub(crate) fn assert_vector(got: Vector, want: Vector, tolerance: f64, what: &str) {
    assert!(norm(sub(got, want)) <= tolerance, "{what}: {got:?}, wanted {want:?}");
}
