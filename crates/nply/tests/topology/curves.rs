//! Curves whose link and writhe are known, and the Gauss sum taken pair by pair, the long way round.

use std::f64::consts::{PI, TAU};

use nply::topology::Curve;

pub(crate) type Vector = [f64; 3];

pub(crate) fn closed(points: Vec<Vector>) -> Curve {
    Curve::closed(points).unwrap()
}

pub(crate) fn open(points: Vec<Vector>) -> Curve {
    Curve::open(points).unwrap()
}

/// The (p, q) torus knot, p times round the axis, q times round the core; radii 2 and 1. A trefoil is (2, 3).
pub(crate) fn torus_knot(n: usize, p: i32, q: i32) -> Vec<Vector> {
    (0..n)
        .map(|k| {
            let t = TAU * k as f64 / n as f64;
            let (phi, psi) = (f64::from(p) * t, f64::from(q) * t);
            let r = 2.0 + psi.cos();
            // psi runs so that the knot is right-handed for p, q > 0
            [r * phi.cos(), r * phi.sin(), -psi.sin()]
        })
        .collect()
}

/// Two curves, each once round the axis, that wind k times round each other, right-handed for k > 0.
pub(crate) fn torus_link(n: usize, k: i32) -> [Vec<Vector>; 2] {
    [0.0, PI].map(|phase| {
        (0..n)
            .map(|i| {
                let t = TAU * i as f64 / n as f64;
                let psi = f64::from(k) * t + phase;
                let r = 2.0 + 0.7 * psi.cos();
                [r * t.cos(), r * t.sin(), -0.7 * psi.sin()]
            })
            .collect()
    })
}

/// A polygon that crosses itself at every turn.
pub(crate) fn tangle(n: usize, seed: u64) -> Vec<Vector> {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut next = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..n).map(|_| [next(), next(), next()]).collect()
}

/// The Gauss integral of two segments by four arcsines (Klenin & Langowski's 1a), in units of a turn: the sum over all pairs, twice, is the writhe.
pub(crate) fn gauss([a, b]: [Vector; 2], [c, d]: [Vector; 2]) -> f64 {
    use crate::vector::{cross, dot, norm, sub, times};
    let (ac, ad, bc, bd) = (sub(c, a), sub(d, a), sub(c, b), sub(d, b));
    let normals = [cross(ac, ad), cross(ad, bd), cross(bd, bc), cross(bc, ac)];
    if normals.iter().any(|n| norm(*n) == 0.0) {
        return 0.0;
    }
    // in one plane: none, and rounding would make up normals
    let volume = dot(cross(sub(d, c), sub(b, a)), ac);
    if volume.abs() <= 1e-14 * norm(sub(d, c)) * norm(sub(b, a)) * norm(ac) {
        return 0.0;
    }
    let n = normals.map(|n| times(1.0 / norm(n), n));
    let angle: f64 = (0..4).map(|k| dot(n[k], n[(k + 1) % 4]).clamp(-1.0, 1.0).asin()).sum();
    angle / (2.0 * TAU) * volume.signum()
}

/// The writhe, pair by pair.
pub(crate) fn writhe_by_pairs(curve: &Curve) -> f64 {
    let n = curve.segments();
    let mut sum = 0.0;
    for i in 0..n {
        for j in i + 2..n - usize::from(curve.is_closed() && i == 0) {
            sum += gauss(curve.segment(i), curve.segment(j));
        }
    }
    2.0 * sum
}

/// The Gauss integral of two curves, pair by pair.
pub(crate) fn link_by_pairs(one: &Curve, other: &Curve) -> f64 {
    (0..one.segments())
        .flat_map(|i| (0..other.segments()).map(move |j| (i, j)))
        .map(|(i, j)| gauss(one.segment(i), other.segment(j)))
        .sum()
}

/// A smooth closed curve of a few random harmonics, knotted often enough.
pub(crate) fn harmonics(n: usize, seed: u64) -> Vec<Vector> {
    let amplitudes = tangle(16, seed);
    (0..n)
        .map(|i| {
            let t = TAU * i as f64 / n as f64;
            [0, 1, 2].map(|k| {
                (1..=4)
                    .map(|m| {
                        let [a, b] = [0, 1].map(|part| amplitudes[4 * part + m as usize - 1 + 8 * (k / 2)][k] - 0.5);
                        let weight = 1.0 / f64::from(m);
                        weight * (a * (f64::from(m) * t).cos() + b * (f64::from(m) * t).sin())
                    })
                    .sum()
            })
        })
        .collect()
}

/// Turned about an axis through the origin by an angle, both drawn from a seed.
pub(crate) fn turned(points: &[Vector], seed: u64) -> Vec<Vector> {
    use crate::vector::{add, cross, dot, norm, times};
    let [draw, ..] = tangle(1, seed)[..] else { unreachable!() };
    let axis = [draw[0] - 0.5, draw[1] - 0.4, draw[2] + 0.1];
    let axis = times(1.0 / norm(axis), axis);
    let (sin, cos) = (TAU * draw[0] + 0.3).sin_cos();
    let turn =
        |&p: &Vector| add(add(times(cos, p), times(sin, cross(axis, p))), times((1.0 - cos) * dot(axis, p), axis));
    points.iter().map(turn).collect()
}

pub(crate) fn mirrored(points: &[Vector]) -> Vec<Vector> {
    points.iter().map(|&[x, y, z]| [x, y, -z]).collect()
}
