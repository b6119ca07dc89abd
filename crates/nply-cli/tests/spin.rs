//! The spinner's numbers, by hand: two strands touch along a line, so that tan θ = 2π r T and, for C/B = 1, tan 2θ = 2 φ̄a.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::disallowed_methods, reason = "numbers to compare with go another way")]

mod command;

use core::f64::consts::TAU;

use command::{call, json, near, number};
use serde_json::Value;

const INCH: f64 = 0.0254;

fn spin(more: &[&str]) -> Value {
    json(&[&["spin", "--strands", "2", "--stiffness-ratio", "1", "--diameter", "0.5 mm", "--json"], more].concat())
}

fn ply<'r>(report: &'r Value, name: &str) -> &'r Value {
    report["plies"].as_array().unwrap().iter().find(|ply| ply["name"] == name).unwrap_or_else(|| panic!("no {name}"))
}

#[test]
fn singles_twist_gives_the_ply_that_balances_it() {
    let report = spin(&["--turns-per-length", "8 tpi Z"]);
    let radius = 0.25e-3;
    let pretwist = TAU * 8.0 / INCH * radius;
    let angle = 0.5 * (2.0 * pretwist).atan();
    let balanced = ply(&report, "balanced");
    assert_eq!((&balanced["lay"], &balanced["handedness"]), (&"S".into(), &(-1).into()));
    near(number(balanced, "helical_angle_deg"), angle.to_degrees(), 1e-11);
    near(number(&balanced["si"], "turns_per_ply_length"), -angle.tan() / (TAU * radius), 1e-11);
    near(number(&balanced["si"], "turns_per_strand_length"), -angle.sin() / (TAU * radius), 1e-11);
    near(number(balanced, "retraction_percent"), 100.0 * (1.0 - angle.cos()), 1e-11);
    near(number(&balanced["si"], "outer_diameter"), 1e-3, 1e-12);
    near(number(balanced, "twist_ratio"), 1.0 - angle.tan() * angle.tan(), 1e-11);
    // two thirds of it are a ply of 16/3 tpi, which is not balanced: it twists up, and is held by a moment the other way
    let rule = ply(&report, "two_thirds");
    near(number(&rule["si"], "turns_per_ply_length"), -16.0 / 3.0 / INCH, 1e-11);
    assert!(number(rule, "moment") > 0.0);
    // where the rule holds: 30 degrees
    near(number(&report["twist_ratios"][0], "two_thirds_angle_deg"), 30.0, 1e-12);
}

#[test]
fn a_wanted_ply_gives_the_twist_of_its_singles() {
    let report = spin(&["--ply-turns-per-length", "5 tpi S"]);
    let radius = 0.25e-3;
    let angle = (TAU * 5.0 / INCH * radius).atan();
    let balanced = ply(&report, "balanced");
    near(number(balanced, "helical_angle_deg"), angle.to_degrees(), 1e-11);
    near(number(&balanced["si"], "pretwist_per_length"), 0.5 * (2.0 * angle).tan() / (TAU * radius), 1e-11);
    // and back
    let turns = format!("{} turns/m", number(&balanced["si"], "pretwist_per_length"));
    let back = spin(&["--turns-per-length", &turns]);
    near(number(&ply(&back, "balanced")["si"], "turns_per_ply_length"), -5.0 / INCH, 1e-10);
    let mirrored = spin(&["--ply-turns-per-length", "5 tpi Z"]);
    near(
        number(&ply(&mirrored, "balanced")["si"], "pretwist_per_length"),
        -number(&balanced["si"], "pretwist_per_length"),
        1e-12,
    );
}

/// Turning on a ply that has too little twist lowers its energy; the moment that holds it says which way it would go.
#[test]
fn a_ply_out_of_balance_turns_towards_it() {
    for (turns, word, sign) in [("4 tpi S", "twists up", 1.0), ("9 tpi S", "untwists", -1.0)] {
        let report = spin(&["--turns-per-length", "8 tpi Z", "--ply-turns-per-length", turns]);
        assert!(number(ply(&report, "given"), "moment") * sign > 0.0, "{turns}");
        assert!(report["notes"].to_string().contains(word), "{turns}");
    }
    let report = spin(&["--turns-per-length", "8 tpi Z", "--ply-turns-per-length", "4 tpi Z"]);
    assert!(report["notes"].to_string().contains("the same way"));
}

/// The ratio for two, three and four strands; in radial balance it is 1 − tan²θ for C/B = 1, whatever their number.
#[test]
fn two_thirds_hold_at_one_angle() {
    for strands in ["2", "3", "4"] {
        let arguments = ["spin", "--strands", strands, "--stiffness-ratio", "1", "--pretwist", "0.3", "--json"];
        let report = json(&[&arguments[..], &["--balance", "radial"]].concat());
        let rule = &report["twist_ratios"][0];
        near(number(rule, "two_thirds_angle_deg"), 30.0, 1e-12);
        for listed in rule["by_angle"].as_array().unwrap() {
            let tan = number(listed, "helical_angle_deg").to_radians().tan();
            near(number(listed, "twist_ratio"), 1.0 - tan * tan, 1e-12);
        }
    }
    let rods = json(&["spin", "--strands", "2", "--stiffness-ratio", "0.75", "--pretwist", "0.3", "--json"]);
    assert!((number(&rods["twist_ratios"][0], "two_thirds_angle_deg") - 26.366).abs() < 5e-4);
    // contact forces at their heights make the rule fail earlier: 28.3 degrees for three
    let three = json(&["spin", "--strands", "3", "--stiffness-ratio", "1", "--pretwist", "0.3", "--json"]);
    let [contact, radial] = [0, 1].map(|i| number(&three["twist_ratios"][i], "two_thirds_angle_deg"));
    assert!(three["twist_ratios"][0]["balance"] == "contact" && contact < radial);
}

#[test]
fn what_no_spinner_can_ask_is_refused() {
    let base = ["spin", "--strands", "2", "--stiffness-ratio", "1", "--diameter", "0.5 mm"];
    for (more, code, part) in [
        (&["--helical-angle", "20 deg"][..], 2, "which way the ply winds"),
        (&["--helical-angle", "50 deg", "--hand", "S"], 1, "between 0 and 45"),
        (&["--turns-per-length", "0 tpi"], 1, "without twist"),
        (&[], 2, "twist is missing"),
    ] {
        let answer = call(&[&base[..], more].concat());
        assert!(answer.code == code && answer.err.contains(part), "{more:?}: {} {}", answer.code, answer.err);
    }
    let loaded = command::call_with(
        &["spin", "-"],
        b"ply.strands = 2\nstrand.stiffness_ratio = 1\ntwist.pretwist = 1\nload.force = 1\n",
    );
    assert!(loaded.code == 2 && loaded.err.contains("let go"), "{}", loaded.err);
}

/// The mass is that of the singles: R = n T/(1 − take-up); twist factors are T √tex. 8 tpi of Ne 10 are α_e = 8/√10.
#[test]
fn a_titre_gives_the_resulting_one_and_twist_factors() {
    let ply = |titre: &str, more: &[&str]| {
        let given = [
            "spin",
            "--strands",
            "2",
            "--stiffness-ratio",
            "1",
            "--density",
            "1.54 g/cm^3",
            "--turns-per-length",
            "8 tpi Z",
        ];
        json(&[&given[..], &["--linear-density", titre, "--json"], more].concat())
    };
    let report = ply("59 tex", &[]);
    let balanced = &report["plies"][0];
    near(number(balanced, "resulting_tex"), 2.0 * 59.0 / (1.0 - number(balanced, "retraction_percent") / 100.0), 1e-12);
    near(number(balanced, "singles_twist_factor"), 8.0 / INCH * 59_f64.sqrt(), 1e-12);
    let turns = number(&balanced["si"], "turns_per_ply_length").abs();
    near(number(balanced, "ply_twist_factor"), turns * number(balanced, "resulting_tex").sqrt(), 1e-12);
    // a hank of 840 yards a pound
    let tex_of_one: f64 = 0.453_592_37e6 / (840.0 * 0.9144);
    let english = number(&ply("Ne 10", &[])["plies"][0], "singles_twist_factor") * INCH / tex_of_one.sqrt();
    near(english, 8.0 / 10_f64.sqrt(), 1e-12);
    assert_eq!(spin(&["--turns-per-length", "8 tpi Z"])["plies"][0]["resulting_tex"], Value::Null);
}

#[test]
fn the_plies_are_a_table_too() {
    let given =
        ["spin", "--strands", "3", "--stiffness-ratio", "1", "--diameter", "0.5 mm", "--turns-per-length", "8 tpi Z"];
    let csv = call(&[&given[..], &["--format", "csv"]].concat()).out;
    let report = json(&[&given[..], &["--json"]].concat());
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let plies = report["plies"].as_array().unwrap();
    assert_eq!(rows.len(), plies.len() + 1);
    for (row, ply) in rows[1..].iter().zip(plies) {
        for (name, cell) in rows[0].iter().zip(row) {
            let (of, name) = match name.strip_suffix("_turns_per_m").or(name.strip_suffix("_m")) {
                Some(name) => (&ply["si"], name),
                None => (ply, *name),
            };
            match &of[name] {
                Value::Number(number) => near(cell.parse().unwrap(), number.as_f64().unwrap(), 1e-15),
                Value::String(text) => assert_eq!(cell, text),
                _ => assert_eq!(*cell, "", "{name}"),
            }
        }
    }
}

/// Surplus S twist turns a free end Z and snarls Z; too little goes on S.
#[test]
fn which_way_a_ply_snarls_and_what_does_not_go_in_is_said() {
    let notes = |more: &[&str]| spin(more)["notes"].to_string();
    assert!(notes(&["--turns-per-length", "8 tpi Z", "--ply-turns-per-length", "7 tpi S"]).contains("snarls Z"));
    assert!(notes(&["--turns-per-length", "8 tpi Z", "--ply-turns-per-length", "4 tpi S"]).contains("snarls S"));
    assert!(notes(&["--turns-per-length", "4000 tpm Z"]).contains("do not go into a ply"));
    // 850 tpm: between the most turns, at 50.6 degrees, and 1/(2 · 0.5 mm) = 1000 tpm of flat rings
    assert!(notes(&["--turns-per-length", "1275 tpm Z"]).contains("beyond the angle of the most turns"));
    assert!(!notes(&["--turns-per-length", "8 tpi Z"]).contains("do not go into a ply"));
}

/// The energy of n strands per strand length, n(κ² + γ(φ̄a + ετ)²)/2, and the rotation ε sin θ/ρ: dE/d(rotation) is the moment that holds the free
/// end, and it turns, let go, the way in which E falls. Turns per strand length have a most, beyond which a closer ply has fewer of them.
#[test]
fn a_free_end_turns_the_way_its_energy_falls_on_either_side_of_the_most_turns() {
    let given = |strands: &str, tpm: f64| {
        let singles = ["--diameter", "0.3 mm", "--stiffness-ratio", "0.75", "--turns-per-length", "1000 tpm Z"];
        let lay = format!("{tpm} tpm");
        json(&[&["spin", "--json", "--strands", strands, "--ply-turns-per-length", &lay], &singles[..]].concat())
    };
    let pretwist = TAU * 1000.0 * 0.15e-3;
    let energy_and_rotation = |strands: &str, tpm: f64| {
        let report = given(strands, tpm);
        let ply = ply(&report, "given");
        let (angle, rho) = (number(ply, "helical_angle_deg").to_radians(), 0.5 * number(ply, "outer_diameter") - 1.0);
        let (curvature, torsion) = (angle.sin().powi(2) / rho, angle.sin() * angle.cos() / rho);
        let n: f64 = strands.parse().unwrap();
        let energy = 0.5 * n * (curvature * curvature + 0.75 * (pretwist + tpm.signum() * torsion).powi(2));
        (energy, tpm.signum() * angle.sin() / rho)
    };
    // singles are Z: plies of the other hand, and of the same
    for (strands, tpm, beyond) in [
        ("2", -500.0, false),
        ("2", -1000.0, false),
        ("2", -1300.0, true),
        ("3", -400.0, false),
        ("3", -700.0, false),
        ("3", -790.0, false),
        ("3", -800.0, true),
        ("3", -950.0, true),
        ("3", 300.0, false),
        ("3", 780.0, false),
        ("3", 900.0, true),
    ] {
        let at = |share: f64| energy_and_rotation(strands, tpm * share);
        let ((e0, r0), (e1, r1)) = (at(1.0 - 1e-5), at(1.0 + 1e-5));
        let slope = (e1 - e0) / (r1 - r0);
        let report = given(strands, tpm);
        let moment = number(ply(&report, "given"), "moment");
        assert!((moment / slope - 1.0).abs() < 1e-4, "{strands}, {tpm}: {moment} is not {slope}");
        let notes = report["notes"].to_string();
        // turned Z, the rotation grows
        let turns = if slope > 0.0 { "Its free end turns S" } else { "Its free end turns Z" };
        let through_straight = notes.contains("turns back through straight");
        assert!(notes.contains(turns) || through_straight && slope > 0.0, "{strands}, {tpm}, {slope}: {notes}");
        assert_eq!(through_straight, tpm > 0.0 && e1 > e0, "{strands}, {tpm}: {notes}");
        assert_eq!((r1.abs() < r0.abs(), notes.contains("more do not go in")), (beyond, beyond), "{tpm}: {notes}");
    }
    let notes = given("3", -800.0)["notes"].to_string();
    // Ω r = 2π times 0.162634 turns per diameter (`nply lays`), in singles of 0.3 mm 542.11 per metre
    assert!(notes.contains("go 542.11") && notes.contains("tpm at most"), "{notes}");
    assert!(notes.contains("turns S until") && notes.contains("and Z from there") && !notes.contains("untwists"));
}
