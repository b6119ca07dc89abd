//! Călugăreanu's sum: link = twist + writhe.

use nply::topology::{Frame, linking_number};
use proptest::prelude::*;

use crate::config;
use crate::curves::{Vector, closed, harmonics, torus_knot};
use crate::vector::{add, cross, norm, sub, times};

/// Vectors across a closed curve that turn `turns` times against a fixed direction, and a little to and fro.
fn across(points: &[Vector], turns: i32, wave: f64) -> Vec<Vector> {
    let n = points.len();
    (0..n)
        .map(|i| {
            let tangent = sub(points[(i + 1) % n], points[(i + n - 1) % n]);
            let tangent = times(1.0 / norm(tangent), tangent);
            let side = cross(tangent, [0.36, 0.48, 0.8]);
            let side = times(1.0 / norm(side), side);
            let s = std::f64::consts::TAU * i as f64 / n as f64;
            let (sin, cos) = (f64::from(turns) * s + wave * (3.0 * s).sin()).sin_cos();
            add(times(cos, side), times(sin, cross(tangent, side)))
        })
        .collect()
}

fn assert_sum(points: Vec<Vector>, turns: i32, wave: f64) -> Result<(), TestCaseError> {
    let vectors = across(&points, turns, wave);
    // narrow, for the edge not to pass through the curve at its sharpest bends and where it meets itself
    let edge: Vec<Vector> = points.iter().zip(&vectors).map(|(p, u)| add(*p, times(1e-6, *u))).collect();
    let curve = closed(points);
    let link = linking_number(&curve, &closed(edge.clone())).unwrap().value;
    let writhe = curve.writhe().unwrap();
    for frame in [Frame::AtPoints(&vectors), Frame::Edge(&edge)] {
        let twist = curve.twist(frame).unwrap();
        let sum = twist.value + writhe.value;
        prop_assert!((sum - link as f64).abs() < 1e-9, "{link} {twist:?} {writhe:?}");
    }
    Ok(())
}

#[test]
fn knots_too() {
    for (p, q) in [(2, 3), (2, -5), (3, 4), (1, 6)] {
        for turns in [-4, 0, 7] {
            assert_sum(torus_knot(2000, p, q), turns, 0.4).unwrap();
        }
    }
}

/// A frame that each segment carries on to the next without turning twists by less the writhe, up to whole turns, (A.2).
#[test]
fn a_frame_of_segments_closes_by_the_writhe() {
    let points = torus_knot(500, 2, 3);
    let n = points.len();
    let tangent = |i: usize| {
        let edge = sub(points[(i + 1) % n], points[i % n]);
        times(1.0 / norm(edge), edge)
    };
    let mut vectors = vec![cross(tangent(0), [0.0, 0.6, 0.8])];
    for i in 1..n {
        // what the frame before shows across the new segment, made a unit vector again
        let last = vectors[i - 1];
        let along = crate::vector::dot(last, tangent(i));
        let next = sub(last, times(along, tangent(i)));
        vectors.push(times(1.0 / norm(next), next));
    }
    let curve = closed(points.clone());
    let sum = curve.twist(Frame::OnSegments(&vectors)).unwrap().value + curve.writhe().unwrap().value;
    assert!((sum - sum.round()).abs() < 1e-9, "{sum}");
}

proptest! {
    #![proptest_config(config(30))]

    #[test]
    fn link_is_twist_and_writhe(seed in 1_u64..100_000, turns in -9..9_i32, wave in 0.0..1.0_f64) {
        assert_sum(harmonics(3000, seed), turns, wave)?;
    }
}
