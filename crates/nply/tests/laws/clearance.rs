//! Least distances of polylines: exact fractions, every pair looked at, touching plies, a strand laid too close.

use core::f64::consts::{PI, TAU};

use nply::Handedness;
use nply::geometry::{Approach, Centreline, Clearance, Contact, HelicalAngle, Vector, Wire, Wires};
use proptest::prelude::*;

use super::config;

/// All of a search, in ranges of unequal length.
fn search(wires: &Wires) -> Clearance {
    let mut found = Clearance::default();
    let n = wires.segments();
    for range in [0..n / 3, n / 3..n / 2, n / 2..n] {
        let more = wires.search(range, &found);
        found.merge(more);
    }
    found
}

fn index(curves: &[Vec<Vector>], closed: bool, diameters: &[f64]) -> Wires {
    let wire = |(points, diameter): (&Vec<Vector>, f64)| Wire { points: leak(points), closed, diameter };
    let wires: Vec<Wire> = curves.iter().zip(diameters.iter().copied().cycle()).map(wire).collect();
    Wires::new(&wires).unwrap()
}

/// Points that live as long as the test.
fn leak(points: &[Vector]) -> &'static [Vector] {
    Vec::leak(points.to_vec())
}

/// The least square of the distance of two segments between whole points, as an exact fraction.
fn exact(p: [[i128; 3]; 2], q: [[i128; 3]; 2]) -> (i128, i128) {
    let sub = |a: [i128; 3], b: [i128; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let dot = |a: [i128; 3], b: [i128; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross =
        |a: [i128; 3], b: [i128; 3]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let less = |a: (i128, i128), b: (i128, i128)| a.0 * b.1 < b.0 * a.1;
    let mut best = (i128::MAX >> 64, 1);
    for (a, b) in [(p, q), (q, p)] {
        for end in a {
            let (v, w) = (sub(b[1], b[0]), sub(end, b[0]));
            let (along, square) = (dot(v, w), dot(v, v));
            let found = if along <= 0 || square == 0 {
                (dot(w, w), 1)
            } else if along >= square {
                let w = sub(end, b[1]);
                (dot(w, w), 1)
            } else {
                (dot(w, w) * square - along * along, square)
            };
            if less(found, best) {
                best = found;
            }
        }
    }
    let (u, v, r) = (sub(p[1], p[0]), sub(q[1], q[0]), sub(q[0], p[0]));
    let n = cross(u, v);
    let (nn, s, t) = (dot(n, n), dot(cross(r, v), n), dot(cross(r, u), n));
    if nn > 0 && (0..=nn).contains(&s) && (0..=nn).contains(&t) {
        let found = (dot(r, n) * dot(r, n), nn);
        if less(found, best) {
            best = found;
        }
    }
    best
}

fn whole_segment() -> impl Strategy<Value = [[i128; 3]; 2]> {
    // small ranges, so that parallel, crossing, touching segments and points are met often
    prop_oneof![
        prop::array::uniform2(prop::array::uniform3(-3..=3_i128)),
        prop::array::uniform2(prop::array::uniform3(-900..=900_i128)),
    ]
}

fn polyline() -> impl Strategy<Value = Vec<Vector>> {
    (prop::array::uniform3(-9.0..9.0_f64), prop::collection::vec(prop::array::uniform3(-1.0..1.0_f64), 1..24)).prop_map(
        |(start, steps)| {
            let mut points = vec![start];
            for step in steps {
                let last = points[points.len() - 1];
                points.push([last[0] + step[0], last[1] + step[1], last[2] + step[2]]);
            }
            points
        },
    )
}

/// Every pair of segments of different wires, each by an index of its own.
fn every_pair(curves: &[Vec<Vector>], closed: bool, diameters: &[f64]) -> (f64, f64, Vec<[usize; 2]>) {
    let segments = |points: &[Vector]| -> Vec<Vec<Vector>> {
        let mut pairs: Vec<Vec<Vector>> = points.windows(2).map(<[Vector]>::to_vec).collect();
        if closed {
            pairs.push(vec![points[points.len() - 1], points[0]]);
        }
        pairs
    };
    let (mut nearest, mut tightest, mut overlapping) = (f64::INFINITY, f64::INFINITY, Vec::new());
    for j in 0..curves.len() {
        for i in 0..j {
            let mut gap = f64::INFINITY;
            for a in segments(&curves[i]) {
                for b in segments(&curves[j]) {
                    let pair = index(&[a.clone(), b], false, &[0.0]);
                    let distance = search(&pair).nearest().unwrap().distance;
                    nearest = nearest.min(distance);
                    gap = gap.min(distance - 0.5 * (diameters[i] + diameters[j]));
                }
            }
            tightest = tightest.min(gap);
            if gap < -1e-12 {
                overlapping.push([i, j]);
            }
        }
    }
    overlapping.sort_unstable();
    (nearest, tightest, overlapping)
}

fn length(a: Vector) -> f64 {
    (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt()
}

proptest! {
    #![proptest_config(config(3000))]

    /// Crossing, parallel, touching, without length: whatever two segments are, as exact fractions have it.
    #[test]
    fn two_segments_as_exact_fractions_have_it(p in whole_segment(), q in whole_segment(), shift in -400..400_i32) {
        let (numerator, denominator) = exact(p, q);
        let wanted = (numerator as f64 / denominator as f64).sqrt();
        // far from unity too, where squares of lengths are no numbers any more
        let scale = 2_f64.powi(shift);
        let points = |s: [[i128; 3]; 2]| s.map(|p| p.map(|x| scale * x as f64)).to_vec();
        let wires = index(&[points(p), points(q)], false, &[0.0]);
        let found = search(&wires);
        let nearest = found.nearest().unwrap();
        prop_assert!((nearest.distance / scale - wanted).abs() <= 1e-15 * 900.0 + 4e-16 * wanted, "{} {wanted}", nearest.distance / scale);
        let [a, b] = nearest.points;
        let between = length([b[0] - a[0], b[1] - a[1], b[2] - a[2]].map(|x| x / scale));
        prop_assert!((between - wanted).abs() <= 1e-12);
    }
}

proptest! {
    #![proptest_config(config(60))]

    #[test]
    fn the_index_misses_no_pair(
        curves in prop::collection::vec(polyline(), 2..6),
        diameters in prop::collection::vec(0.0..6.0_f64, 6),
        closed in any::<bool>(),
    ) {
        let found = search(&index(&curves, closed, &diameters));
        let (nearest, tightest, overlapping) = every_pair(&curves, closed, &diameters);
        prop_assert!((found.nearest().unwrap().distance - nearest).abs() < 1e-13);
        prop_assert!((found.tightest().unwrap().gap - tightest).abs() < 1e-13);
        prop_assert_eq!(found.overlaps().map(|pair| pair.wires).collect::<Vec<_>>(), overlapping);
    }

    /// A wire with itself: all segments farther apart along it than πr, each pair as two wires.
    #[test]
    fn the_index_misses_no_pair_of_one_wire(points in polyline(), diameter in 0.1..1.0_f64, closed in any::<bool>()) {
        let points: Vec<Vector> = points.into_iter().flat_map(|p| [p, [p[0] + 0.1, p[1], p[2]]]).collect();
        let found = search(&index(std::slice::from_ref(&points), closed, &[diameter]));
        let n = points.len();
        let count = if closed { n } else { n - 1 };
        let ends = |i: usize| [points[i], points[(i + 1) % n]];
        let edge = |i: usize| { let [a, b] = ends(i); length([b[0] - a[0], b[1] - a[1], b[2] - a[2]]) };
        let (mut least, mut overlaps) = (f64::INFINITY, false);
        for j in 0..count {
            for i in 0..j {
                let between: f64 = (i + 1..j).map(edge).sum();
                let round: f64 = if closed { (j + 1..count).chain(0..i).map(edge).sum() } else { f64::INFINITY };
                if between.min(round) >= 0.5 * PI * diameter {
                    let pair = index(&[ends(i).to_vec(), ends(j).to_vec()], false, &[0.0]);
                    let distance = search(&pair).nearest().unwrap().distance;
                    least = least.min(distance);
                    overlaps |= distance < diameter - 1e-12;
                }
            }
        }
        prop_assert_eq!(found.own_nearest().is_some(), least.is_finite());
        if let Some(own) = found.own_nearest() {
            prop_assert!((own.distance - least).abs() < 1e-13, "{} {}", own.distance, least);
        }
        prop_assert_eq!(found.own_overlaps().count(), usize::from(overlaps));
    }
}

/// `turns` turns of a helix, `points` points a turn.
fn helix(contact: &Contact, hand: Handedness, strand: u32, turns: u32, points: u32) -> Vec<Vector> {
    let line = Centreline::new(contact, hand, strand);
    let one = contact.lay_length() / contact.angle().cos();
    (0..=turns * points).map(|i| line.position(one * f64::from(i) / f64::from(points))).collect()
}

proptest! {
    #![proptest_config(config(24))]

    /// Strands of a touching ply are 2r apart, less what chords cut off, which goes with the square of their length.
    #[test]
    fn touching_strands_are_a_diameter_apart(n in 2..8_u32, angle in 0.05..1.2_f64, hand in super::hand()) {
        let contact = Contact::new(n, angle).unwrap();
        for points in [64, 128] {
            let curves: Vec<_> = (0..n).map(|i| helix(&contact, hand, i, 3, points)).collect();
            let wires = index(&curves, false, &[2.0]);
            let found = search(&wires);
            let missing = 2.0 - found.nearest().unwrap().distance;
            let both = wires.sagitta(0) + wires.sagitta(1);
            prop_assert!(missing > -both && missing <= 1.01 * both, "{missing} {both}");
            // κ h²/8 of a helix
            let chord = contact.lay_length() / contact.angle().cos() / f64::from(points);
            prop_assert!((wires.sagitta(0) / (contact.curvature() * chord * chord / 8.0) - 1.0).abs() < 0.02);
        }
    }
}

/// Six wires on a king wire, laid at 17.44° with R = 2r as if they stood upright: neighbours overlap. At the radius of touching wires
/// they clear each other, as far as the chords go, and the king wire is loose.
#[test]
fn a_strand_of_seven_wires_needs_a_thinner_lay_or_a_thicker_king_wire() {
    let angle = 17.44_f64.to_radians();
    let contact = Contact::new(6, angle).unwrap();
    let strand = |radius: f64| -> Vec<Vec<Vector>> {
        let pitch = TAU * radius / angle.tan();
        let point = |i: u32, k: u32| {
            let psi = TAU * f64::from(k) / 200.0;
            let phase = psi + TAU * f64::from(i) / 6.0;
            [radius * phase.cos(), radius * phase.sin(), pitch * psi / TAU]
        };
        let king = vec![[0.0, 0.0, 0.0], [0.0, 0.0, 2.0 * pitch]];
        core::iter::once(king).chain((0..6).map(|i| (0..=400).map(|k| point(i, k)).collect())).collect()
    };
    let wires = index(&strand(2.0), false, &[2.0]);
    let found = search(&wires);
    let pairs: Vec<[usize; 2]> = found.overlaps().map(|pair| pair.wires).filter(|pair| pair[0] > 0).collect();
    assert_eq!(pairs, [[1, 2], [1, 6], [2, 3], [3, 4], [4, 5], [5, 6]]);
    // far more than chords can explain
    let gap = |approach: &Approach| approach.gap;
    let deepest = found.tightest().map(gap).unwrap();
    assert!(deepest < -0.05 && deepest < -20.0 * wires.sagitta(1), "{deepest}");
    assert!(contact.radius_ratio() > 2.0);
    let wires = index(&strand(contact.radius_ratio()), false, &[2.0]);
    let found = search(&wires);
    let least = found.nearest().unwrap();
    assert!(least.wires[0] > 0 && least.distance > 2.0 - 2.0 * wires.sagitta(1), "{least:?}");
    assert!(found.overlaps().all(|pair| pair.wires[0] > 0 && pair.gap > -2.0 * wires.sagitta(1)));
    assert_eq!(found.own_overlaps().count(), 0);
}

/// The densest helix touches its own next turn: it is its own nearest neighbour, at a diameter.
#[test]
fn the_densest_helix_touches_itself() {
    let densest = nply::geometry::DensestHelix::new();
    let (radius, pitch) = (densest.radius_ratio(), densest.pitch());
    let points: Vec<Vector> = (0..=4000)
        .map(|k| f64::from(k) / 1000.0)
        .map(|turn| [radius * (TAU * turn).cos(), radius * (TAU * turn).sin(), pitch * turn])
        .collect();
    let wires = index(std::slice::from_ref(&points), false, &[2.0]);
    let own = search(&wires);
    let own = own.own_nearest().unwrap();
    assert!((own.distance - 2.0).abs() < 2.0 * wires.sagitta(0), "{own:?}");
    // bent as sharply as it can be: its radius of curvature is its own
    assert!((wires.bend_radius(0) - 1.0).abs() < 1e-4);
    // the next turn stands an arclength x R away
    let arc = |at: usize| {
        (own.segments[at] as f64 + own.fractions[at]) * pitch
            / (1000.0 * HelicalAngle::new(densest.helical_angle()).unwrap().cos())
    };
    assert!((arc(1) - arc(0) - densest.arclength_shift() * radius).abs() < 0.02);
    let thicker = search(&index(&[points], false, &[2.001]));
    assert_eq!(thicker.own_overlaps().count(), 1);
}

#[test]
fn what_is_no_wire_is_refused() {
    let wire =
        |points: &[Vector], diameter| Wires::new(&[Wire { points: leak(points), closed: false, diameter }]).map(drop);
    let good = [[0.0; 3], [0.0, 0.0, 1.0]];
    assert!(wire(&good, 0.0).is_ok());
    assert_eq!(wire(&good[..1], 1.0).unwrap_err().quantity, "points");
    assert_eq!(wire(&[[0.0; 3], [0.0, f64::NAN, 1.0]], 1.0).unwrap_err().quantity, "coordinate");
    assert_eq!(wire(&[[0.0; 3], [0.0, f64::INFINITY, 1.0]], 1.0).unwrap_err().quantity, "coordinate");
    for diameter in [-1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(wire(&good, diameter).unwrap_err().quantity, "diameter");
    }
    // nothing at all, one wire alone
    let none = Wires::new(&[]).unwrap();
    assert_eq!((none.segments(), search(&none).nearest()), (0, None));
    assert_eq!(search(&index(&[good.to_vec()], false, &[1.0])).nearest(), None);
}
