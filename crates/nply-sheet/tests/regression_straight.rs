//! Rows of straight strands: without twist and moment, or without turns.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

use core::f64::consts::TAU;

use nply_sheet::Spec;
use nply_sheet::regression::{Measurements, RegressionQuestion, RegressionReport};

fn fit(table: &str, ply: &[(&str, &str)], estimate: &str, errors: &[&str]) -> RegressionReport {
    let data = Measurements::read("rows.csv", table.as_bytes()).unwrap();
    let ply = Spec::from_flags(ply.iter().copied()).unwrap();
    let question = RegressionQuestion {
        estimate: estimate.split(',').map(str::to_owned).collect(),
        errors: errors.iter().map(|error| (*error).to_owned()).collect(),
        ..RegressionQuestion::default()
    };
    RegressionReport::of(&ply, &data, &question).unwrap()
}

fn near(found: f64, truth: f64, share: f64) {
    assert!((found - truth).abs() <= share * truth.abs(), "{found} for {truth}");
}

const STRINGS: [(&str, &str); 8] = [
    ("strands", "2"),
    ("diameter", "0.9 mm"),
    ("strand-length", "0.5 m"),
    ("stretch", "true"),
    ("axial-stiffness", "2000 N"),
    ("stiffness-ratio", "1"),
    ("bending-stiffness", "0.02 N mm^2"),
    ("strand-twist", "0"),
];

/// Where nothing was twisted in and nothing pulls, no coils are counted: that fits exactly and says nothing of the stiffness.
#[test]
fn a_row_without_twist_changes_no_estimate() {
    let cords = [("strands", "3"), ("diameter", "6 mm"), ("stiffness-ratio", "1")];
    let counts =
        "turns_per_length [turns/m],ply_turns_per_strand_length [turns/m]\n5,-4.9\n10,-9.0\n15,-12.3\n20,-14.9\n";
    let angles = "pretwist,helical_angle_deg\n-0.2,12.14\n-0.5,23.2\n-1,30.6\n";
    for (table, ply, error) in [
        (counts, &cords[..], "ply_turns_per_strand_length=0.03 turns/m"),
        (angles, &[cords[0], cords[2]][..], "helical_angle=0.05 deg"),
    ] {
        let without = fit(table, ply, "stiffness_ratio", &[error]);
        let with = fit(&format!("{table}0,0\n"), ply, "stiffness_ratio", &[error]);
        let [of_rows, of_all] = [&without, &with].map(|report| report.answer().estimates[0]);
        near(of_all.value, of_rows.value, 1e-7);
        near(of_all.standard_error.unwrap(), of_rows.standard_error.unwrap(), 1e-6);
        let row = with.answer().rows.last().unwrap();
        assert!(row.is_straight() && row.limit().is_none());
        assert_eq!((row.helical_angle, row.compared[0].fitted), (0.0, 0.0));
        near(with.answer().chi_squared, without.answer().chi_squared, 1e-7);
        assert_eq!(with.answer().degrees_of_freedom, without.answer().degrees_of_freedom + 1);
        let said = with.text(false);
        assert!(said.contains("the strands lie straight") && !said.contains("a slip there"), "{said}");
        // what was measured of straight strands is theirs to answer for: a count of 4 is no count of 0
        let slipped = fit(&format!("{table}0,4\n"), ply, "stiffness_ratio", &[error]);
        assert!(slipped.answer().rows.last().unwrap().is_straight());
        near(slipped.answer().estimates[0].value, of_rows.value, 1e-7);
    }
}

/// n strings side by side are a spring: L(1 + F/(n EA)), whether the force is held or read with an error.
#[test]
fn lengths_without_turns_give_the_axial_stiffness() {
    let row = |force: f64| format!("0,{force},0,{:?}", 500.0 * (1.0 + force / (2.0 * 3000.0)));
    let table =
        format!("ply_turns,force [N],moment [N mm],ply_length [mm]\n{}\n", [20.0, 60.0, 100.0].map(row).join("\n"));
    let errors = ["moment=0.05 N mm", "ply_length=0.1 mm"];
    let report = fit(&table, &STRINGS, "axial_stiffness", &errors);
    near(report.answer().estimates[0].value, 3000.0, 1e-7);
    assert_eq!(report.answer().degrees_of_freedom, 6 - 1);
    let measured = fit(&table, &STRINGS, "axial_stiffness", &[&errors[..], &["force=1 N"]].concat());
    near(measured.answer().estimates[0].value, 3000.0, 1e-7);
    // three numbers a row, one of them used up by the force of the row
    assert_eq!(measured.answer().degrees_of_freedom, 6 - 1);
}

/// The moment that holds twisted strands before the ply is let go is nCτ.
#[test]
fn the_moment_that_keeps_a_ply_from_turning_gives_the_torsional_stiffness() {
    let torsion = 1.6e-9; // N m²
    let rows = [100.0, 200.0, 300.0].map(|turns| format!("{turns},0,{:?}", 3.0 * torsion * TAU * turns));
    let ply = [
        ("strands", "3"),
        ("diameter", "0.6 mm"),
        ("bending-stiffness", "2 mN mm^2"),
        ("torsional-stiffness", "2 mN mm^2"),
    ];
    let table =
        format!("turns_per_length [turns/m],ply_turns_per_strand_length [turns/m],moment [N m]\n{}\n", rows.join("\n"));
    let report = fit(&table, &ply, "torsional_stiffness", &["moment=1e-8 N m"]);
    near(report.answer().estimates[0].value, torsion, 1e-7);
}

/// A row that straight strands cannot keep is no reason to lose the others.
#[test]
fn a_row_without_turns_that_straight_strands_cannot_keep_is_left_out() {
    let table = "turns_per_length [tpm],ply_turns_per_strand_length [turns/m],force [mN],moment [mN mm],lay_length [mm]\n\
                 240,-100,,,9\n240,0,,1,9\n240,-120,,,8\n";
    let ply = [("strands", "3"), ("diameter", "0.5 mm"), ("bending-stiffness", "2 mN mm^2"), ("stiffness-ratio", "1")];
    let report = fit(table, &ply, "diameter", &["lay_length=0.1 mm"]);
    let lines: Vec<usize> = report.answer().rows.iter().map(|row| row.line).collect();
    assert_eq!(lines, [2, 4]);
    let said = report.text(false);
    assert!(
        said.contains("1 row is left out: no turns, and straight strands do not keep moment, in line 3."),
        "{said}"
    );
}
