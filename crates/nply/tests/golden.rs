//! The golden tables of `authorities/`, row by row.

#![allow(clippy::unwrap_used, clippy::panic)] // a test fails by panicking

mod common;

use common::{Row, assert_relative, table};
use nply::Handedness;
use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Balance, Equilibrium, Load, Ply, Twist};
use nply::topology::PlyWrithe;

/// 90 less an angle given in whole thousandths of a degree, without the rounding of the difference.
fn complement(degrees: f64) -> f64 {
    (90_000.0 - (1000.0 * degrees).round()) / 1000.0
}

#[test]
fn contact_geometry() {
    for name in ["contact_geometry", "contact_geometry_more"] {
        for row in table(name) {
            // theta_deg is exact in the table; its nearest double in rad carries half a unit of its last place
            let (n, degrees) = (row.strands(), row.number("theta_deg"));
            let angle = if degrees <= 45.0 {
                HelicalAngle::new(degrees.to_radians()).unwrap()
            } else {
                HelicalAngle::from_pitch_angle(complement(degrees).to_radians()).unwrap()
            };
            let contact = Contact::at_angle(n, angle).unwrap();
            // the rounding of degrees to rad, as seen from the pitchfork of n = 2, where x and the hole grow from zero
            let from_pitchfork = if n == 2 && degrees > 45.0 { degrees / (degrees - 45.0) } else { 0.0 };
            let rounding = 1e-13 + f64::EPSILON * from_pitchfork;
            let at = |quantity: &str| format!("{quantity} at n = {n}, {degrees} deg");
            assert_relative(contact.arclength_shift(), row.number("x"), rounding, &at("x"));
            assert_relative(contact.radius_ratio(), row.number("rho"), rounding, &at("rho"));
            assert_relative(
                contact.radius_ratio_slope(),
                row.number("drho_dtheta"),
                10.0 * rounding,
                &at("drho_dtheta"),
            );
            let line = row.number("contact_helix_radius_over_r");
            assert_relative(contact.contact_line_radius(), line, rounding, &at("contact line"));
            assert_relative(contact.curvature(), row.number("curvature_times_r"), 1e-13, &at("curvature"));
            assert_relative(contact.hole_radius(), row.number("hole_radius_over_r"), rounding, &at("hole"));
        }
    }
}

/// All states of a row's inputs, and which of them the rows of the table are.
fn states(row: &Row, load: Load) -> Vec<Equilibrium> {
    let balance = match row.text("balance") {
        "radial" => Balance::Radial,
        _ => Balance::Contact,
    };
    Ply::with_balance(row.strands(), row.number("gamma"), balance)
        .unwrap()
        .equilibria(Twist::Pretwist(row.number("pretwist")), load)
        .unwrap()
}

fn handedness(row: &Row) -> Handedness {
    if row.number("handedness") > 0.0 { Handedness::Right } else { Handedness::Left }
}

/// The state of a row: its hand, and its angle to 1e-11 rad.
fn find(row: &Row, states: &[Equilibrium]) -> Equilibrium {
    let angle = row.number("theta_deg").to_radians();
    *states
        .iter()
        .find(|s| s.handedness() == handedness(row) && (s.contact().helical_angle() - angle).abs() < 1e-11)
        .unwrap_or_else(|| panic!("no {} state at {angle} rad among {states:#?}", row.text("handedness")))
}

/// No state is missing and none is extra: as many states as rows with the same inputs.
fn none_extra(rows: &[Row], inputs: &[&str], load: impl Fn(&Row) -> Load) {
    let key = |row: &Row| inputs.iter().map(|i| row.text(i).to_owned()).collect::<Vec<_>>().join(",");
    for row in rows {
        let listed = rows.iter().filter(|other| key(other) == key(row)).count();
        let found = states(row, load(row));
        assert_eq!(found.len(), listed, "{}: {found:#?}", key(row));
    }
}

#[test]
fn balanced_plies() {
    let rows = table("balanced_plies");
    for row in &rows {
        let state = find(row, &states(row, Load::NONE));
        assert_relative(state.contact().radius_ratio(), row.number("rho"), 1e-11, "rho");
        assert_relative(state.strand_twist(), row.number("r_u3"), 1e-11, "r_u3");
        assert_relative(state.resultant_pressure(), row.number("p_r3_over_B"), 1e-11, "p");
        assert_relative(state.interstrand_pressure(), row.number("p1_r3_over_B"), 1e-11, "p1");
        assert_relative(state.balance_slope(), row.number("dG_dtheta"), 1e-10, "dG_dtheta");
    }
    none_extra(&rows, &["n", "gamma", "pretwist", "balance"], |_| Load::NONE);
}

#[test]
fn loaded_plies() {
    let load = |row: &Row| Load { force: row.number("f"), moment: row.number("m") };
    for name in ["loaded_plies", "loaded_plies_more"] {
        let rows = table(name);
        for row in &rows {
            let state = find(row, &states(row, load(row)));
            assert_relative(state.contact().radius_ratio(), row.number("rho"), 1e-11, "rho");
            assert_relative(state.resultant_pressure(), row.number("p_r3_over_B"), 1e-11, "p");
        }
        none_extra(&rows, &["n", "gamma", "pretwist", "balance", "f", "m"], load);
    }
}

/// Cases with no root at all have no row among the roots: every case has as many states as it has roots listed.
#[test]
fn cases_have_no_other_states() {
    let roots = table("loaded_plies_more");
    for case in table("loaded_plies_more_cases") {
        for balance in Balance::BOTH {
            let listed = roots
                .iter()
                .filter(|root| root.text("case") == case.text("case") && root.text("balance") == balance.name())
                .count();
            let load = Load { force: case.number("f"), moment: case.number("m") };
            let found = Ply::with_balance(case.strands(), case.number("gamma"), balance)
                .unwrap()
                .equilibria(Twist::Pretwist(case.number("pretwist")), load)
                .unwrap();
            assert_eq!(found.len(), listed, "case {} in {} balance: {found:#?}", case.text("case"), balance.name());
        }
    }
}

#[test]
fn flexibility() {
    for (name, loaded) in [("flexibility", false), ("flexibility_more", true)] {
        for row in table(name) {
            let load = if loaded { Load { force: row.number("f"), moment: row.number("m") } } else { Load::NONE };
            let [[ff, fm], [mf, mm]] = find(&row, &states(&row, load)).flexibility().unwrap();
            assert_relative(ff, row.number("a_ddf_df"), 1e-10, "a_ddf_df");
            assert_relative(fm, row.number("a_ddf_dm"), 1e-10, "a_ddf_dm");
            assert_relative(mf, row.number("a_ddm_df"), 1e-10, "a_ddm_df");
            assert_relative(mm, row.number("a_ddm_dm"), 1e-10, "a_ddm_dm");
        }
    }
}

/// A strand with itself counts both orders of its points, two strands one: an entry of Tables I and II.
#[test]
fn strand_writhe() {
    for row in table("strand_writhe") {
        let (strands, places) = match row.text("alpha_over_2pi") {
            "0" => (1, 0),
            share => (share.strip_prefix("1/").unwrap().parse().unwrap(), 1),
        };
        let angle = HelicalAngle::new(row.number("theta_deg").to_radians()).unwrap();
        for hand in Handedness::BOTH {
            let got = PlyWrithe::new(strands, angle, hand, row.number("turns")).unwrap().pair(places);
            let want = hand.sign() * row.number("writhe");
            // ten digits, those of the table
            assert!(
                (got.writhe - want).abs() < 6e-10 * want.abs().max(0.1),
                "{strands} {}: {got:?} {want}",
                angle.degrees()
            );
            assert!(got.error_bound < 1e-12, "{got:?}");
        }
    }
}

/// Digits enough to hold every answer against its own bound.
#[test]
fn strand_writhe_remainders() {
    for row in table("strand_writhe_more") {
        let (places, strands) = match row.text("alpha_over_2pi") {
            "0" => (0, 1),
            share => share.split_once('/').map(|(i, n)| (i.parse().unwrap(), n.parse().unwrap())).unwrap(),
        };
        let degrees = row.number("theta_deg");
        let angle = if degrees <= 45.0 {
            HelicalAngle::new(degrees.to_radians()).unwrap()
        } else {
            HelicalAngle::from_pitch_angle(complement(degrees).to_radians()).unwrap()
        };
        let got = PlyWrithe::new(strands, angle, Handedness::Right, row.number("turns")).unwrap().pair(places);
        let error = (got.remainder - row.number("remainder")).abs();
        // the angle is rounded to a double
        assert!(error <= got.error_bound + 4e-16 * angle.tan(), "{degrees} {places}/{strands}: {error:e} {got:?}");
        assert!(error < 2e-14 && got.error_bound < 1e-11, "{degrees} {places}/{strands}: {error:e} {got:?}");
    }
}
