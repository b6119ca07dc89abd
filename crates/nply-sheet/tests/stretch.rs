//! Strands that stretch, from paper to report: units, what is implied, paths.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::disallowed_methods, reason = "numbers to compare with go another way")]

use core::f64::consts::{PI, TAU};

use nply::mechanics::{Axial, ExtensiblePly, Mark, Support, Turning};
use nply_sheet::{ErrorKind, LocusReport, Question, Report, Spec, TraceReport, Walk};
use serde_json::Value;

/// Six steel wires on a king wire of half their modulus, all but preformed; each datum may be changed, or left out where it is empty.
fn strand(extra: &[(&str, &str)]) -> Spec {
    let mut flags = vec![
        ("strands", "6"),
        ("diameter", "4 mm"),
        ("youngs-modulus", "200 GPa"),
        ("poissons-ratio", "0.3"),
        ("stretch", "true"),
        ("pretwist", "0"),
        ("formed-lay-length", "100 mm"),
        ("preforming", "0.95"),
        ("support-core-diameter", "4.4 mm"),
        ("support-core-youngs-modulus", "100 GPa"),
    ];
    flags.retain(|(name, _)| extra.iter().all(|(other, _)| name != other));
    flags.extend(extra.iter().filter(|(_, value)| !value.is_empty()));
    Spec::from_flags(flags).unwrap()
}

fn ply(extra: &[(&str, &str)]) -> ExtensiblePly {
    let Question::Stretched { ply, .. } = strand(extra).check().unwrap().question else { panic!() };
    ply
}

fn report(extra: &[(&str, &str)]) -> Value {
    serde_json::from_str(&Report::of(strand(extra).check_supports().unwrap()).unwrap().json()).unwrap()
}

#[track_caller]
fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{found} {expected}");
}

/// r = 2 mm, B = πEr⁴/4: everything by hand.
#[test]
fn solid_wires_need_only_their_modulus() {
    let ply = ply(&[]);
    near(ply.strand().axial_stiffness(), 4.0);
    near(ply.strand().poissons_ratio(), 0.3);
    let bending = PI * 200e9 * 2e-3_f64.powi(4) / 4.0;
    let core = ply.core().unwrap();
    near(core.axial_stiffness(), 100e9 * PI * 2.2e-3 * 2.2e-3 * (2e-3 * 2e-3) / bending);
    near(core.torsional_stiffness(), 100e9 / 2.6 * PI / 2.0 * 2.2e-3_f64.powi(4) / bending);
    near(core.poissons_ratio(), 0.3);
    let lay = ply.formed().unwrap();
    near(lay.radius_ratio, 2.1);
    near(lay.angle.radians(), (TAU * 4.2 / 100.0_f64).atan());
    near(lay.preforming, 0.95);
}

/// The lay is that on the core where wires are clear of each other there, that of touching wires where they are not.
#[test]
fn the_least_radius_is_the_one_meant() {
    // the core too thin to be touched: a lay of touching strands
    let thin = ply(&[("support-core-diameter", "3 mm")]).formed().unwrap();
    let touching = nply::geometry::Contact::from_lay_length(6, 50.0).unwrap();
    near(thin.radius_ratio, touching.radius_ratio());
    near(thin.angle.radians(), touching.helical_angle());
    let by_angle = ply(&[("formed-lay-length", ""), ("formed-helical-angle", "10 deg")]).formed().unwrap();
    near(by_angle.radius_ratio, 2.1);
    let wide = ply(&[("formed-radius-ratio", "2.5")]).formed().unwrap();
    near(wide.angle.radians(), (TAU * 5.0 / 100.0_f64).atan());
}

#[test]
fn other_sections_give_their_own_stiffness() {
    let own = &[
        ("youngs-modulus", ""),
        ("bending-stiffness", "2 N m^2"),
        ("axial-stiffness", "1 MN"),
        ("support-core-youngs-modulus", ""),
        ("support-core-axial-stiffness", "500 kN"),
        ("support-core-torsional-stiffness", "1 N m^2"),
        ("support-core-poissons-ratio", "0.1"),
    ];
    let ply = ply(own);
    near(ply.strand().axial_stiffness(), 1e6 * 4e-6 / 2.0);
    let core = ply.core().unwrap();
    near(core.axial_stiffness(), 5e5 * 4e-6 / 2.0);
    near(core.torsional_stiffness(), 0.5);
    near(core.poissons_ratio(), 0.1);
    // stresses of a section that is not known are not given, all else is
    let report = report(&[&own[..], &[("force", "5 kN")]].concat());
    let state = &report["states"][0];
    assert!(state["strand_stress"].is_null() && state["modulus"].is_null() && state["axial_stiffness"].is_number());
}

/// The sum of what wires, core and loads' positions carry: stresses over moduli are strains.
#[test]
fn stresses_are_strains_times_moduli() {
    let report = report(&[("force", "20 kN")]);
    let states = report["states"].as_array().unwrap();
    let state = states.iter().find(|state| state["support"] == "core").unwrap();
    let of = |name: &str| state[name].as_f64().unwrap();
    let si = |name: &str| state["si"][name].as_f64().unwrap();
    let strand = 200e9 * (of("strain") + of("bending_strain").abs());
    assert!((si("strand_stress") / strand - 1.0).abs() < 1e-12);
    let area = PI * 2.2e-3 * 2.2e-3;
    assert!((si("core_stress") * area / si("core_force") - 1.0).abs() < 1e-12);
    let metal = area + 6.0 * PI * 4e-6;
    assert!((si("modulus") * metal / si("axial_stiffness") - 1.0).abs() < 1e-12);
    assert_eq!(report["si_units"]["strand_stress"], "Pa");
    assert_eq!(state["stability_by_holding"]["both_held"], "stable");
}

/// Between clamps both loads are found.
#[test]
fn length_and_rotation_may_be_held_at_once() {
    let spec = strand(&[("length-ratio", "0.97"), ("ply-turns-per-strand-length", "9.5 turns/m")]);
    let Question::Stretched { grips, .. } = spec.check().unwrap().question else { panic!() };
    assert_eq!(grips.axial, Axial::Extension(0.97));
    let Turning::Rotation(rotation) = grips.turning else { panic!() };
    near(rotation, 9.5 * TAU * 2e-3);
    let report: Value = serde_json::from_str(&Report::of(spec.check_supports().unwrap()).unwrap().json()).unwrap();
    for state in report["states"].as_array().unwrap() {
        near(state["extension"].as_f64().unwrap(), 0.97);
        near(state["rotation"].as_f64().unwrap(), rotation);
    }
    // a flag that turns the ends leaves their length held
    let turned = spec.overridden_by(&Spec::from_flags([("ply-turns-per-strand-length", "9 turns/m")]).unwrap());
    let Question::Stretched { grips, .. } = turned.check().unwrap().question else { panic!() };
    assert_eq!(grips.axial, Axial::Extension(0.97));
    near(if let Turning::Rotation(rotation) = grips.turning { rotation } else { 0.0 }, 9.0 * TAU * 2e-3);
}

/// Pulled, let go and pushed: wires lift off where the report on supports says they do, and a leg that holds the length begins with that
/// reached.
#[test]
fn a_path_opens_where_the_report_says() {
    let pulled = strand(&[("force", "20 kN")]);
    let pushed = Spec::from_flags([("force", "-0.2 kN")]).unwrap();
    let report = TraceReport::of(pulled.check_path(Some(&pushed)).unwrap(), Walk::default()).unwrap();
    let trace = report.stretch_traces().next().unwrap();
    let lifts = trace.events.iter().find(|e| e.mark == Mark::ContactChange(Support::Free)).unwrap();
    let supports: Value = serde_json::from_str(&Report::of(pulled.check_supports().unwrap()).unwrap().json()).unwrap();
    let force = lifts.station.state.load().force;
    let opening = |o: &&Value| o["kept"] == "moment" && (o["force"].as_f64().unwrap() - force).abs() < 1e-9;
    assert!(supports["openings"].as_array().unwrap().iter().any(|o| opening(&o)), "{force} {supports}");
    let json: Value = serde_json::from_str(&report.json()).unwrap();
    assert_eq!(json["legs"][0]["holding"], "dead_loads");
    assert!(json["starts"][0]["strain"].is_number());
    assert!(report.text(false).contains("opens") && report.csv().contains("bending_strain"));
    assert!(report.picture().svg().contains("end force"));

    let clamped = Spec::from_flags([("length-ratio", "0.95")]).unwrap();
    let report = TraceReport::of(pulled.check_path(Some(&clamped)).unwrap(), Walk::default()).unwrap();
    let trace = report.stretch_traces().next().unwrap();
    let (first, last) = (trace.stations.first().unwrap(), trace.stations.last().unwrap());
    assert!((first.state.load().force / 2e4 * (PI * 200e9 * 4e-6 / 4.0) - 1.0).abs() < 1e-9);
    assert!((last.state.extension() - 0.95).abs() < 1e-12);
}

#[test]
fn what_knows_no_stretch_says_so() {
    let case = strand(&[]).check().unwrap();
    let error = LocusReport::of(&case, 10).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Contradiction);
    assert!(error.to_string().contains("only strands that do not stretch"), "{error}");
    let kept = Walk { kept: true, ..Walk::default() };
    let leg = Spec::from_flags([("force", "1 kN")]).unwrap();
    let error = TraceReport::of(strand(&[]).check_path(Some(&leg)).unwrap(), kept).unwrap_err();
    assert!(error.to_string().starts_with("--kept: "), "{error}");
    let leg = Spec::from_flags([("support-core-diameter", "4.5 mm")]).unwrap();
    let error = TraceReport::of(strand(&[]).check_path(Some(&leg)).unwrap(), Walk::default()).unwrap_err();
    assert!(error.to_string().contains("cannot change along a path of strands that stretch"), "{error}");
}
