//! Where two straight segments come nearest.

use crate::numerics::vector::{Vector, add, cross, dot, sub, times};

/// The square of the distance of two segments, and how far along each the nearest points lie, from 0 to 1.
///
/// The distance is convex in both places: its minimum lies at one of the four ends or between all of them. Each candidate is a pair of points of
/// the segments, so that rounding of its place costs the distance second order alone; parallel segments and segments of no
/// length have their minimum at an end.
pub(in crate::geometry) fn approach(first: [Vector; 2], second: [Vector; 2]) -> (f64, [f64; 2]) {
    let (u, v) = (sub(first[1], first[0]), sub(second[1], second[0]));
    let r = sub(second[0], first[0]);
    let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
    let (ur, vr) = (dot(u, r), dot(v, r));
    // of a segment without a length any place is as good
    let place = |along: f64, square: f64| if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
    let square = |[s, t]: [f64; 2]| {
        let apart = sub(add(r, times(t, v)), times(s, u));
        dot(apart, apart)
    };
    let ends = [[0.0, place(-vr, vv)], [1.0, place(uv - vr, vv)], [place(ur, uu), 0.0], [place(ur + uv, uu), 1.0]];
    let mut best = (square(ends[0]), ends[0]);
    let mut offer = |places: [f64; 2]| {
        let square = square(places);
        if square < best.0 {
            best = (square, places);
        }
    };
    ends[1..].iter().for_each(|places| offer(*places));
    let n = cross(u, v);
    let nn = dot(n, n);
    if nn > 0.0 {
        let (s, t) = (dot(cross(r, v), n) / nn, dot(cross(r, u), n) / nn);
        if s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0 {
            offer([s, t]);
        }
    }
    best
}
