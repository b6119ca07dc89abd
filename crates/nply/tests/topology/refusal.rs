//! What is no curve, or has no writhe or link, is said with its place.

use nply::topology::{Along, Curve, CurveError, Frame, linking_integral, linking_number};

use crate::curves::{Vector, closed, open, tangle, turned};

#[test]
fn points_that_make_no_curve() {
    let [a, b, c, d] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.5]];
    let nan = [0.0, f64::NAN, 0.0];
    let infinite = [0.0, f64::INFINITY, 0.0];
    for (points, is_closed, want) in [
        (vec![], true, CurveError::TooFew { points: 0, closed: true }),
        (vec![a, b], true, CurveError::TooFew { points: 2, closed: true }),
        (vec![a], false, CurveError::TooFew { points: 1, closed: false }),
        (vec![a, b, nan, c], true, CurveError::NotFinite { point: 2 }),
        (vec![a, infinite], false, CurveError::NotFinite { point: 1 }),
        (vec![a, b, b, c], true, CurveError::Repeated { point: 2 }),
        (vec![a, a], false, CurveError::Repeated { point: 1 }),
        (vec![a, b, c, a], true, CurveError::EndRepeatsStart { point: 3 }),
        (vec![a, b, [0.5, 0.0, 0.0], c], true, CurveError::TurnsBack { point: 1 }),
        (vec![a, b, [-3.0, 0.0, 0.0]], false, CurveError::TurnsBack { point: 1 }),
        (vec![a, b, c, d, [1e301, 0.0, 0.0]], true, CurveError::OutOfReach { point: 4 }),
        (vec![[1.0, 1.0, 0.0], b, [1.0, 0.0, 1e-50], d], true, CurveError::OutOfReach { point: 1 }),
    ] {
        let got = if is_closed { Curve::closed(points.clone()) } else { Curve::open(points.clone()) };
        assert_eq!(got.unwrap_err(), want, "{points:?}");
        let sentence = want.to_string();
        assert!(sentence.len() > 30 && !sentence.contains('{'), "{sentence}");
    }
    // a hairpin that is open by however little is a curve
    assert!(closed(vec![a, b, [0.5, 1e-30, 0.0], c]).writhe().unwrap().value.abs() < 1e-12);
}

/// Segments that have a point in common: an end on another segment, two that cross, two ends in one place, two that overlap.
#[test]
fn segments_that_touch() {
    let cases: [(&str, Vec<Vector>, [usize; 2]); 4] = [
        ("cross", vec![[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [2.0, 0.0, 1.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]], [0, 3]),
        (
            "an end on a segment",
            vec![[0.0, 0.0, 0.0], [2.0, 2.0, 2.0], [3.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 4.0, 1.0]],
            [0, 2],
        ),
        (
            "two ends",
            vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [1.0, 0.0, 3.0], [1.0, 0.0, 0.0], [0.0, 3.0, 1.0]],
            [0, 3],
        ),
        (
            "overlap",
            vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 1.0, 1.0], [3.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 5.0]],
            [0, 2],
        ),
    ];
    for (name, points, want) in cases {
        // exactly so only where the coordinates say so: scaled and moved by powers of two
        for (scale, shift) in [(1.0, 0.0), (0.25, 8.0), (1024.0, -2.0)] {
            let points: Vec<Vector> = points.iter().map(|p| p.map(|x| scale * x + shift)).collect();
            for curve in [closed(points.clone()), open(points)] {
                let error = curve.writhe().unwrap_err();
                let CurveError::Touch { curves: [0, 0], segments } = error else { panic!("{name}: {error:?}") };
                assert!(segments[0] <= want[0] + 1 && segments[1] <= want[1] + 1, "{name}: {segments:?}");
                assert!(error.to_string().contains(&format!("segments {} and {}", segments[0], segments[1])));
            }
        }
    }
    // turned, they pass each other by rounding, one way or the other: an answer, or a word
    let points = turned(&[[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [2.0, 0.0, 1.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]], 3);
    assert!(closed(points).writhe().map_or(true, |writhe| writhe.value.is_finite()));
}

#[test]
fn curves_that_touch_each_other() {
    let one = closed(vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]]);
    let other = closed(vec![[1.0, 0.0, 0.0], [1.0, -3.0, 1.0], [1.0, -3.0, -1.0]]);
    let error = linking_number(&one, &other).unwrap_err();
    assert!(matches!(error, CurveError::Touch { curves: [0, 1], segments: [0, _] }), "{error:?}");
    assert!(error.to_string().starts_with("segment 0 of curve 0 and segment "));
    assert!(error.of_curves([4, 7]).to_string().contains("of curve 7"));
    let string = open(vec![[1.0, 0.0, 0.0], [1.0, -3.0, 1.0]]);
    assert!(matches!(linking_integral(&one, &string), Err(CurveError::Touch { .. })));
    assert_eq!(linking_number(&one, &string), Err(CurveError::Open { curve: 1 }));
    // a curve with itself
    assert!(matches!(linking_number(&one, &one), Err(CurveError::Touch { .. })));
}

#[test]
fn questions_that_a_curve_does_not_answer() {
    let (round, string) = (closed(tangle(9, 1)), open(tangle(9, 1)));
    assert_eq!(round.extended(1.0, Along::Tangents), Err(CurveError::Closed));
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(string.extended(length, Along::Chord), Err(CurveError::Domain(_))));
    }
    for axis in [[0.0; 3], [f64::NAN, 0.0, 1.0], [f64::INFINITY, 0.0, 1.0]] {
        assert!(matches!(string.polar_writhe(axis), Err(CurveError::Domain(_))));
    }
    let mut loose = tangle(9, 1);
    loose.push(loose[0]);
    assert_eq!(open(loose).extended(1.0, Along::Chord), Err(CurveError::EndsMeet));
    let flat = open(vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 1.0]]);
    assert_eq!(flat.polar_writhe([0.0, 0.0, 1.0]), Err(CurveError::Level { segment: 0 }));
    let up = [[0.0, 0.0, 1.0]; 9];
    assert_eq!(round.twist(Frame::AtPoints(&up[1..])), Err(CurveError::FrameLength { vectors: 8, needed: 9 }));
    assert_eq!(string.twist(Frame::OnSegments(&up)), Err(CurveError::FrameLength { vectors: 9, needed: 8 }));
    for bad in [[1.0, 0.0, 0.0], [0.0; 3], [f64::NAN; 3]] {
        assert_eq!(flat.twist(Frame::AtPoints(&[bad; 3])), Err(CurveError::FrameAlong { vector: 0 }));
    }
}
