//! Figures 1 to 5: how strands touch.

use std::f64::consts::{PI, TAU};

use nply::geometry::{Contact, Section};

use super::{close, data, last, pairs};

/// Figure 1: a line up to 45°, then a pitchfork whose prongs end at ±π.
#[test]
fn two_strands_fork_at_45_degrees() {
    let data = data("1");
    let main = pairs(&data, &["main"], "helical_angle_deg", "arclength_shift");
    for &(degrees, x) in &main {
        let e = degrees.to_radians().tan().powi(2);
        if (degrees - 45.0).abs() < 0.01 {
            continue; // the corner itself is met to rounding only
        }
        if degrees < 45.0 {
            assert!(x.abs() < 1e-12, "{degrees}: {x}");
        } else {
            assert!(x != 0.0, "{degrees}");
            // z = e sin z with z² ≈ 6(1 − 1/e), and x ≈ √2 z by the fork
            if degrees < 45.5 {
                close(x * x / (12.0 * (1.0 - 1.0 / e)), 1.0, 0.05);
            }
        }
    }
    let [up, down] = [1.0, -1.0].map(|side| main.iter().filter(|(_, x)| side * x > 0.0).copied().collect::<Vec<_>>());
    close(last(&up), PI, 1e-5);
    close(last(&down), -PI, 1e-5);
    close(up.iter().map(|p| p.0).fold(90.0, f64::min), 45.0, 0.01);
    // the trivial line goes on to 90°
    close(
        pairs(&data, &["line"], "helical_angle_deg", "arclength_shift").iter().map(|p| p.0).fold(0.0, f64::max),
        90.0,
        1e-9,
    );
}

/// The satellites of two strands turn where tan y = y (y = 7.725252, Abramowitz and Stegun, table 4.19), at tan²θ = 1/cos y, and come from
/// flat rings at x = 2π and 3π.
#[test]
fn satellites_turn_where_tan_y_is_y() {
    let data = data("1");
    let points = pairs(&data, &["satellite"], "helical_angle_deg", "arclength_shift");
    let y: f64 = 7.725_251_837;
    let turn = (1.0 / y.cos()).sqrt().atan().to_degrees();
    let least = points.iter().filter(|(_, x)| x.abs() < 3.2 * PI).map(|p| p.0).fold(90.0, f64::min);
    close(least, turn, 0.01);
    let rings: Vec<f64> =
        points.iter().filter(|(degrees, x)| *degrees > 89.99 && (0.0..3.2 * PI).contains(x)).map(|p| p.1).collect();
    close(rings.iter().copied().fold(f64::MAX, f64::min), TAU, 2e-3);
    close(rings.iter().copied().fold(0.0, f64::max), 3.0 * PI, 2e-3);
}

/// Figure 3: one branch from slope sin(2π/3) to 2π/3.
#[test]
fn three_strands_have_one_branch_without_overlap() {
    let data = data("3");
    let main = pairs(&data, &["main"], "helical_angle_deg", "arclength_shift");
    let (near, x) = *main.iter().find(|(degrees, _)| *degrees > 0.0).unwrap();
    close(x / near.to_radians(), (TAU / 3.0).sin(), 1e-3);
    close(last(&main), TAU / 3.0, 1e-5);
    assert!(main.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 < pair[1].1), "it rises");
    for &(degrees, x) in &main {
        let (s, c) = degrees.to_radians().sin_cos();
        close(x * c * c + s * (x * s - TAU / 3.0).sin(), 0.0, 1e-9); // (5)
    }
    let satellites = pairs(&data, &["satellite"], "helical_angle_deg", "arclength_shift");
    let nearest = satellites.iter().filter(|(degrees, _)| *degrees > 89.9).map(|p| p.1).filter(|x| *x < 0.0);
    close(nearest.fold(f64::MIN, f64::max), TAU / 3.0 - PI, 2e-3);
}

/// Figures 2 and 4: neighbours' centrelines are two radii apart.
#[test]
fn shaded_strands_touch() {
    for (name, strands) in [("2", 2.0), ("4", 3.0)] {
        let data = data(name);
        let points = |strand: f64| -> Vec<[f64; 3]> {
            let all = ["x", "y", "z"].map(|column| data.numbers(&[], column).collect::<Vec<_>>());
            let of: Vec<f64> = data.numbers(&[], "strand").collect();
            (0..of.len()).filter(|&i| (of[i] - strand).abs() < 0.5).map(|i| [0, 1, 2].map(|k| all[k][i])).collect()
        };
        assert!(points(strands).len() > 50 && points(strands + 1.0).is_empty());
        let distance = |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
        let (one, two) = (points(1.0), points(2.0));
        let least = one.iter().flat_map(|a| two.iter().map(move |b| distance(a, b))).fold(f64::MAX, f64::min);
        assert!((2.0..2.02).contains(&least), "{name}: {least}");
    }
}

/// Figure 5: convex at 20°, hollow above 51.1577°; from the hole to the cylinder around; neighbours meet on the contact line.
#[test]
fn cuts_turn_hollow() {
    let data = data("5");
    for degrees in [20.0, 60.0, 80.0] {
        let rows: Vec<(f64, f64)> = pairs(&data, &[], "helical_angle_deg", "strand");
        let places: Vec<(f64, f64)> = pairs(&data, &[], "x", "y");
        let strand = |number: f64| -> Vec<(f64, f64)> {
            let own = rows
                .iter()
                .zip(&places)
                .filter(|((angle, n), _)| (*angle - degrees).abs() < 0.5 && (*n - number).abs() < 0.5);
            own.map(|(_, place)| *place).collect()
        };
        let (one, two) = (strand(1.0), strand(2.0));
        let turn = |i: usize| {
            let p = |k: usize| one[(i + k) % one.len()];
            let (a, b, c) = (p(0), p(1), p(2));
            (b.0 - a.0) * (c.1 - b.1) - (b.1 - a.1) * (c.0 - b.0)
        };
        let turns: Vec<f64> = (0..one.len()).map(turn).collect();
        let convex = turns.iter().all(|t| *t > 0.0) || turns.iter().all(|t| *t < 0.0);
        assert_eq!(convex, degrees < 51.1577, "{degrees}");
        let contact = Contact::new(3, degrees.to_radians()).unwrap();
        let radii = || one.iter().map(|(x, y)| x.hypot(*y));
        close(radii().fold(f64::MAX, f64::min), contact.hole_radius(), 1e-3);
        close(radii().fold(0.0, f64::max), contact.outer_radius(), 1e-3);
        let (gap, meets) = one
            .iter()
            .flat_map(|a| two.iter().map(move |b| ((a.0 - b.0).hypot(a.1 - b.1), a.0.hypot(a.1))))
            .fold((f64::MAX, 0.0), |best, pair| if pair.0 < best.0 { pair } else { best });
        assert!(gap < 0.05, "{degrees}: {gap}");
        close(meets, contact.contact_line_radius(), 0.05);
    }
    close(Section::non_convex_angle(3).unwrap().degrees(), 51.1577, 5e-5);
}
