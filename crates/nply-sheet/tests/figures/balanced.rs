//! Figures 6 to 8: the ply without loads.

use std::f64::consts::PI;

use nply::geometry::SpecialLays;

use super::{close, crossings, data, last, pairs};

fn panel(figure: &str, panel: &str, curve: &str) -> Vec<(f64, f64)> {
    pairs(&data(figure), &[panel, curve], "helical_angle_deg", "value")
}

/// Figure 6 at flat rings: p₁ = −π²/8 and p = 0 on the helix, −1/2 and −1 in line, as printed; in contact balance neither pulls.
#[test]
fn two_strands_end_where_the_paper_says() {
    let end = |what: &str, curve: &str| last(&panel("6", what, curve));
    close(end("interstrand_pressure", "helix, radial"), -PI * PI / 8.0, 1e-4);
    close(end("interstrand_pressure", "line"), -0.5, 1e-5);
    close(end("resultant_pressure", "helix, radial"), 0.0, 1e-4);
    close(end("resultant_pressure", "line"), -1.0, 1e-5);
    close(end("interstrand_pressure", "helix, contact"), 0.0, 1e-4);
    // n cancels: −1/cos θ − 2ε γ r u₃ ρ → 0 with ρ cos θ → n/π
    close(end("twisting_moment", "helix, contact"), -PI / 4.0, 1e-4);
    close(end("twisting_moment", "helix, radial"), 0.0, 1e-4);
    // radial p₁ has a greatest value before that
    let radial = panel("6", "interstrand_pressure", "helix, radial");
    let greatest =
        radial.iter().copied().fold((0.0, f64::MIN), |best, point| if point.1 > best.1 { point } else { best });
    assert!((50.0..80.0).contains(&greatest.0) && greatest.1 > -PI * PI / 8.0 + 0.01, "{greatest:?}");
}

/// In line contact (42) and (43) are explicit: ρ = 1.
#[test]
fn line_contact_is_explicit() {
    for (degrees, moment) in panel("6", "twisting_moment", "line") {
        let t = degrees.to_radians();
        let (s, c) = (t.sin(), t.cos());
        let wanted = -2.0 * s.powi(3) * c / (2.0 * t).cos();
        close(moment, wanted, 1e-9 * (1.0 + wanted * wanted));
    }
    for (degrees, pressure) in panel("6", "resultant_pressure", "line") {
        let t = degrees.to_radians();
        let wanted = t.sin().powi(4) / (2.0 * t).cos();
        close(pressure, wanted, 1e-9 * (1.0 + wanted * wanted));
    }
    assert!(panel("6", "radius_ratio", "line").iter().all(|(_, rho)| (rho - 1.0).abs() < 1e-12));
}

/// Figures 6 and 7: where pressures change from large and positive to large and negative.
#[test]
fn poles_stand_at_45_degrees_and_at_the_most_torsion() {
    let pole = |figure: &str, curve: &str| {
        let points = panel(figure, "interstrand_pressure", curve);
        let side = |sign: f64| points.iter().filter(move |(_, p)| sign * p > 1.9).map(|point| point.0);
        (side(1.0).fold(0.0, f64::max), side(-1.0).fold(90.0, f64::min))
    };
    for (figure, curve, angle) in [
        ("6", "line", 45.0),
        ("7", "radial", 45.0),
        ("7", "contact", SpecialLays::of(3).unwrap().most_torsion().angle().degrees()),
    ] {
        let (below, above) = pole(figure, curve);
        assert!(below < angle && angle < above, "{figure}, {curve}: {below} {above}");
    }
    close(SpecialLays::of(3).unwrap().most_torsion().angle().degrees(), 37.8756, 5e-5);
    close(last(&panel("7", "twisting_moment", "contact")), -PI / 6.0, 1e-4);
    close(
        last(&panel("7", "radius_ratio", "radial").into_iter().filter(|p| p.0 < 1.0).collect::<Vec<_>>()),
        2.0 / 3_f64.sqrt(),
        1e-3,
    );
}

/// Figure 8 against simulations in three dimensions (contact), and the paper's own equation (radial).
#[test]
fn a_pretwist_makes_its_published_angle() {
    let data = data("8");
    let three = |balance: &str| pairs(&data, &[balance, "3"], "pretwist", "signed_helical_angle_deg");
    for (balance, angles) in [
        ("contact", [(-0.2, 12.1369), (-0.5, 23.2305), (-1.0, 30.6130), (-2.0, 34.5859), (-5.0, 36.672)]),
        ("radial", [(-0.2, 12.1454), (-0.5, 23.4964), (-1.0, 32.0903), (-2.0, 38.1318), (-5.0, 42.225)]),
    ] {
        for (pretwist, angle) in angles {
            let found = crossings(&three(balance), pretwist);
            assert!(found.iter().any(|degrees| (degrees - angle).abs() < 0.06), "{balance} {pretwist}: {found:?}");
            // and its mirror image
            let found = crossings(&three(balance), -pretwist);
            assert!(found.iter().any(|degrees| (degrees + angle).abs() < 0.06), "{balance} {pretwist}: {found:?}");
        }
    }
    // two strands, radial: one state on either side of 45°, of opposite hands
    let two = crossings(&pairs(&data, &["radial", "2"], "pretwist", "signed_helical_angle_deg"), -1.0);
    assert!(two.len() == 2 && two.iter().any(|a| (0.0..45.0).contains(a)) && two.iter().any(|a| *a < -45.0), "{two:?}");
}

/// In contact balance the branch of flat rings ends at φ̄a = −ε π/(2nγ).
#[test]
fn flat_rings_hold_a_pretwist() {
    let data = data("8");
    for n in [2.0, 3.0, 6.0] {
        let points = pairs(&data, &["contact", &n.to_string()], "pretwist", "signed_helical_angle_deg");
        let rings = points.iter().copied().fold((0.0, 0.0), |best, p| if p.1 > best.1 { p } else { best });
        close(rings.0, -PI / (2.0 * n * 0.75), 1e-3);
    }
}
