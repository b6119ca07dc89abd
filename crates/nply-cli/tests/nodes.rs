//! Start geometry: what is written is measured again, element by element.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs;
use std::path::PathBuf;

use command::{call, json, near, number, out};
use nply::geometry::{Clearance, Wire, Wires};

const STRAND: [&str; 8] = ["nodes", "--strands", "6", "--helical-angle", "17.44 deg", "--diameter", "2 mm", "--core"];

/// The least gap of two wires of a file of nodes, coatings apart, and that of any wire to the core.
fn measured(arguments: &[&str], coating: f64) -> (f64, f64) {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("nodes-{}.csv", arguments.join("").len()));
    out(&[arguments, &["--output", path.to_str().unwrap()]].concat());
    let text = fs::read_to_string(&path).unwrap();
    let mut wires: Vec<(String, f64, Vec<[f64; 3]>)> = Vec::new();
    for row in text.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |i: usize| -> f64 { cells[i].parse().unwrap() };
        if wires.last().is_none_or(|(name, ..)| name != cells[0]) {
            wires.push((cells[0].to_owned(), number(9), Vec::new()));
        }
        wires.last_mut().unwrap().2.push([number(3), number(4), number(5)]);
    }
    let gap = |those: &[&(String, f64, Vec<[f64; 3]>)]| {
        let wire =
            |(_, radius, points): &&(String, f64, Vec<[f64; 3]>)| -> (f64, Vec<[f64; 3]>) { (*radius, points.clone()) };
        let those: Vec<_> = those.iter().map(wire).collect();
        let wires: Vec<Wire<'_>> = those
            .iter()
            .map(|(radius, points)| Wire { points, closed: false, diameter: 2.0 * (radius + coating) })
            .collect();
        let index = Wires::new(&wires).unwrap();
        index.search(0..index.segments(), &Clearance::default()).tightest().unwrap().gap
    };
    let (core, strands): (Vec<_>, Vec<_>) = wires.iter().partition(|(name, ..)| name == "core");
    assert_eq!((strands.len(), core.len()), (6, 1));
    (gap(&strands), gap(&[strands[0], core[0]]))
}

#[test]
fn seven_wires_laid_upright_overlap_and_the_corrected_radius_clears_them() {
    let upright = [&STRAND[..], &["--lay-radius", "2 mm"]].concat();
    let report = json(&[&upright[..], &["--json"]].concat());
    assert_eq!(report["clear"], false);
    assert!(out(&upright).contains("The elements overlap"));
    let (gap, core) = measured(&upright, 0.0);
    assert!(gap < -0.08 && core < -0.01);
    near(gap, number(&report, "gap"), 1e-9); // r = 1 mm
    near(core, number(&report, "core_gap"), 1e-9);
    // geometry and chords apart
    near(number(&report, "geometric_gap") - number(&report, "chord_share"), gap, 1e-9);
    let least = number(&report, "least_helix_radius");
    let corrected = json(&[&STRAND[..], &["--json"]].concat());
    assert_eq!(corrected["clear"], true);
    near(number(&corrected, "helix_radius"), least, 1e-15);
    near(number(&corrected["si"], "helix_radius"), least * 1e-3, 1e-15);
    let (gap, core) = measured(&STRAND, 0.0);
    assert!(gap.abs() < 1e-9 && core > 0.0, "{gap} {core}");
}

#[test]
fn coated_staggered_and_left_handed_wires_are_clear_too() {
    for more in [
        &["--coating", "50 um"][..],
        &["--coating", "0.05 mm", "--stagger", "0.37", "--hand", "left"],
        &["--coating", "0.05 mm", "--any-stagger", "--elements-per-pitch", "11"],
    ] {
        let (gap, core) = measured(&[&STRAND[..], more].concat(), 0.05);
        assert!(gap > -1e-9 && gap < 0.02 && core > -1e-9, "{more:?}: {gap} {core}");
    }
    // the lay length held
    let long = ["nodes", "--strands", "6", "--lay-length", "40 mm", "--diameter", "2 mm", "--core", "1 mm"];
    let report = json(&[&long[..], &["--json"]].concat());
    near(number(&report, "lay_length"), 40.0, 1e-12);
    let (gap, core) = measured(&long, 0.0);
    assert!(gap.abs() < 1e-9 && core > -1e-9, "{gap} {core}");
}

#[test]
fn what_cannot_be_laid_is_refused_in_one_sentence() {
    let lay = ["nodes", "--strands", "6"];
    for (more, code, part) in [
        (&["--helical-angle", "0 deg"][..], 1, "straight strands have no turns"),
        (&["--helical-angle", "20 deg", "--elements-per-pitch", "2"], 1, "at least 3"),
        (&["--helical-angle", "20 deg", "--coating", "-1"], 1, "thickness of at least 0"),
        (&["--helical-angle", "20 deg", "--lay-radius", "0"], 1, "greater than 0"),
        (&["--helical-angle", "20 deg", "--stagger", "nan"], 1, "finite"),
        (&["--helical-angle", "20 deg", "--core", "1 mm"], 2, "no size to measure it by"),
        (&["--lay-length", "12.5", "--coating", "0.3"], 1, "no lay of this length"),
        (&[], 2, "the lay is missing"),
    ] {
        let found = call(&[&lay[..], more].concat());
        assert_eq!((found.code, found.out.as_str()), (code, ""), "{more:?}: {}", found.err);
        assert!(found.err.contains(part) && found.err.starts_with("error: "), "{more:?}: {}", found.err);
    }
}
