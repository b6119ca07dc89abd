//! The examples' states, against numbers computed apart from this project's programs.
//!
//! How: units taken off by hand; contact by bisection of z − tan²θ sin z = π(1 − 2/n) with 40 digits, and ρ from the
//! squared distance (4) of the touching sections itself; the balance G of the design, with its ρ′ term for `contact` and
//! without it for `radial`, bisected between the signs on 1000 angles; everything in mpmath, 17 digits quoted.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs;

use command::{json, near, number, out, root, states};
use serde_json::Value;

const TOLERANCE: f64 = 1e-10;

fn solved(name: &str) -> Value {
    json(&["solve", &format!("examples/{name}.toml"), "--json"])
}

/// The only state of an example.
fn state(name: &str) -> Value {
    let report = solved(name);
    let [state] = states(&report) else { panic!("{report}") };
    state.clone()
}

fn angles(report: &Value) -> Vec<(i64, f64)> {
    let pair = |state: &Value| (state["handedness"].as_i64().unwrap(), number(state, "helical_angle_deg"));
    states(report).iter().map(pair).collect()
}

#[track_caller]
fn same_angles(report: &Value, expected: &[(i64, f64)]) {
    let found = angles(report);
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for ((hand, angle), (expected_hand, expected)) in found.iter().zip(expected) {
        assert_eq!(hand, expected_hand);
        near(*angle, *expected, TOLERANCE);
    }
}

#[test]
fn every_example_is_answered_and_names_its_source() {
    let mut count = 0;
    for entry in fs::read_dir(root().join("examples")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            count += 1;
            out(&["solve", path.to_str().unwrap()]);
            let text = fs::read_to_string(&path).unwrap();
            let comment: String = text.lines().take_while(|line| line.starts_with('#')).collect();
            assert!(
                ["Source", "Journal", "Sci. Rep.", "BioNumbers"].iter().any(|word| comment.contains(word)),
                "{text}"
            );
        }
    }
    assert_eq!(count, 6, "an example without a test of its own");
}

/// Lay of 8.5 nm, chain radius 0.2582 nm: 2πρ/tan θ = 8.5/0.2582.
#[test]
fn collagen() {
    let state = state("collagen");
    near(number(&state, "helical_angle_deg"), 12.505149050017749, TOLERANCE);
    near(number(&state, "radius_ratio"), 1.1620444020033935, TOLERANCE);
    near(number(&state, "pretwist"), -0.20720200960032044, TOLERANCE);
    assert_eq!(state["handedness"], 1);
    // published: a helix diameter 2R of 0.6 nm, drawn at an angle of 12 degrees
    assert!((number(&state["si"], "ply_radius") - 0.3e-9).abs() < 0.0005e-9);
    assert!((number(&state, "helical_angle_deg") - 12.5).abs() < 0.05);
}

/// C/B = 120/50, B = kT·50 nm = 2.05716701e-28 N m²; at 32° two strands touch along a line, ρ = 1.
#[test]
fn dna_supercoil() {
    let report = solved("dna-supercoil");
    let state = state("dna-supercoil");
    near(number(&report, "bending_stiffness_N_m2"), 2.05716701e-28, TOLERANCE);
    near(number(&state, "helical_angle_deg"), 32.0, TOLERANCE);
    near(number(&state, "pretwist"), -0.68929489716627708, TOLERANCE);
    near(number(&state, "strand_twist"), -0.23989787401669359, TOLERANCE);
    near(number(&state["si"], "resultant_pressure"), 0.037005512278135879, TOLERANCE);
    // published: strands 58 degrees from the plane across the axis
    assert!((number(&state, "pitch_angle_deg") - 58.0).abs() < 1e-9);
}

#[test]
fn rubber_rods() {
    same_angles(&solved("rubber-rods"), &[(1, 12.136929512816447), (1, 53.061596186357026), (-1, 46.200867655000041)]);
    let radial = json(&["solve", "examples/rubber-rods.toml", "--balance", "radial", "--json"]);
    same_angles(&radial, &[(1, 12.145354314060729), (-1, 71.509066730130764)]);
}

/// Pretwist 2π·470/m·0.1375 mm.
#[test]
fn three_ply_yarn() {
    let report = solved("three-ply-yarn");
    same_angles(&report, &[(1, 44.451155023262998), (-1, 20.581164503906438), (-1, 60.340843738863594)]);
    let lays = [0.0012135447871302422, 0.0027082427995467675, 0.00095210348415620722];
    for (state, lay) in states(&report).iter().zip(lays) {
        near(number(state, "pretwist"), 0.40605085047648078, TOLERANCE);
        near(number(&state["si"], "lay_length"), lay, TOLERANCE);
    }
    // the one that touches winds against its twist
    let touching: Vec<_> = states(&report).iter().filter(|state| state["separated"] == false).collect();
    assert!(touching.len() == 1 && touching[0]["lay"] == "S");
}

/// tan θ = 2π·460/m·0.1375 mm; two strands, line contact.
#[test]
fn tyre_cord() {
    let state = state("tyre-cord");
    near(number(&state, "helical_angle_deg"), 21.673440469766607, TOLERANCE);
    near(number(&state, "pretwist"), 0.51486330295918663, TOLERANCE);
    near(number(&state["si"], "pretwist_per_length"), 595.94937950963356, TOLERANCE);
    assert_eq!(state["lay"], "S");
    // as sold: 460 turns/m of cord, gauge 0.55 mm
    assert!((number(&state, "helical_angle_deg") - 21.67).abs() < 0.005);
    near(number(&state["si"], "turns_per_ply_length"), 460.0, TOLERANCE);
    near(number(&state["si"], "outer_diameter"), 0.55e-3, TOLERANCE);
}

/// ρ = 1 + 3.94/3.73, B = πEr⁴/4 = 1.7863356897154717 N m², f = 40 kN·r²/B = 0.077885137043956462.
#[test]
fn wire_strand_on_core() {
    let state = state("wire-strand-on-core");
    near(number(&state, "helical_angle_deg"), 15.296255548875007, TOLERANCE);
    near(number(&state, "force"), 0.077885137043956462, TOLERANCE);
    near(number(&state, "moment"), 0.6606518079738406, TOLERANCE);
    near(number(&state["si"], "moment"), 632.78600700199673, TOLERANCE);
    near(number(&state["si"], "lay_length"), 0.088102820286920201, TOLERANCE);
    // tested: lay angles from 9.2 to 17.0 degrees, on this core
    assert!((9.2..17.0).contains(&number(&state, "helical_angle_deg")));
    near(number(&state["si"], "hole_radius"), 1.97e-3, TOLERANCE);
}
