//! What scripts rely on: `nply fit-check`, its names, its numbers and how it refuses.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::disallowed_methods, reason = "numbers to compare with go another way")]

mod command;

use std::f64::consts::{PI, TAU};

use command::{Answer, call, call_with, json, near, number, out};
use serde_json::Value;

/// Of a single layer, at the top as in `layers`.
const LENGTHS: [&str; 4] = ["wire_gap", "touching_lay_radius", "king_wire_diameter", "outer_diameter"];

fn fit(core: &str, wire: &str, strands: &str, lay: &str) -> Value {
    json(&[
        "fit-check",
        "--core-diameter",
        core,
        "--wire-diameter",
        wire,
        "--strands",
        strands,
        "--lay-length",
        lay,
        "--json",
    ])
}

/// Least distance between the surfaces of neighbouring wires, sampled.
fn sampled_gap(core: f64, wire: f64, strands: f64, lay: f64) -> f64 {
    let radius = 0.5 * (core + wire);
    let distance = |phi: f64| {
        let rise = lay * (phi - TAU / strands) / TAU;
        (2.0 * radius * (0.5 * phi).sin()).hypot(rise)
    };
    (0..400_000).map(|i| distance(f64::from(i) / 400_000.0 * PI)).fold(f64::MAX, f64::min) - wire
}

#[test]
fn bare_numbers_come_back_in_their_own_unit() {
    for (core, wire, strands, lay) in
        [(5.1, 5.0, 6, 210.0), (5.0, 5.0, 6, 80.0), (3.94, 3.73, 6, 115.0), (1.0, 3.0, 3, 40.0), (20.0, 2.0, 30, 100.0)]
    {
        let found = fit(&core.to_string(), &wire.to_string(), &strands.to_string(), &lay.to_string());
        let expected = sampled_gap(core, wire, f64::from(strands), lay);
        let gap = number(&found, "wire_gap");
        assert!((gap - expected).abs() < 1e-8 * wire, "{gap} {expected}");
        near(number(&found, "lay_angle_deg"), (PI * (core + wire) / lay).atan().to_degrees(), 1e-14);
        near(number(&found, "outer_diameter"), core + 2.0 * wire, 1e-15);
        assert_eq!(found["contact"], if expected > 0.0 { "core" } else { "neighbours" });
        // on the king wire they just touch
        let king = number(&found, "king_wire_diameter");
        near(number(&found, "touching_lay_radius"), 0.5 * (king + wire), 1e-13);
        assert!(sampled_gap(king, wire, f64::from(strands), lay).abs() < 1e-8 * wire);
        let touching = fit(&format!("{king:?}"), &wire.to_string(), &strands.to_string(), &lay.to_string());
        assert_eq!(touching["contact"], "both");
        // the lay they really take
        let taken = if expected > 0.0 { 0.5 * (core + wire) } else { 0.5 * (king + wire) };
        near(number(&found, "taken_outer_diameter"), 2.0 * taken + wire, 1e-13);
        near(number(&found, "taken_lay_angle_deg"), (TAU * taken / lay).atan().to_degrees(), 1e-13);
        // no size, no SI
        assert!(found["length_unit"].is_null());
        assert!(found.as_object().unwrap().keys().all(|key| !key.ends_with("_m") && !key.ends_with("_m2")));
        assert_eq!(found["layers"].as_array().unwrap().len(), 1);
        for key in LENGTHS {
            assert_eq!(found[key], found["layers"][0][key]);
        }
    }
}

#[test]
fn with_units_the_same_unit_and_metres() {
    let bare = fit("5.1", "5", "6", "210");
    let (mm, inch) = (fit("5.1 mm", "5 mm", "6", "210 mm"), fit("5.1 in", "5 in", "6", "210 in"));
    assert_eq!((mm["length_unit"].as_str(), inch["length_unit"].as_str()), (Some("mm"), Some("in")));
    for key in LENGTHS {
        let value = number(&bare, key);
        // differences of lengths keep their digits but for those that cancel
        let slack = 1e-15 * 15.0;
        for (found, unit) in [(&mm, 1e-3), (&inch, 0.0254)] {
            assert!((number(found, key) - value).abs() < slack, "{key}");
            assert!((number(found, &format!("{key}_m")) / unit - value).abs() < slack, "{key}");
        }
    }
    for key in ["lay_angle_deg", "fill_factor", "wire_length_ratio"] {
        near(number(&mm, key), number(&bare, key), 1e-14);
    }
    // the units of core and wire may differ: the wire's is the answer's
    let mixed = fit("0.51 cm", "5 mm", "6", "0.21 m");
    assert_eq!(mixed["length_unit"], "mm");
    near(number(&mixed, "king_wire_diameter"), number(&bare, "king_wire_diameter"), 1e-13);
}

#[test]
fn what_is_missing_is_found() {
    // lay length at which neighbours just touch: Utting & Jones' strand
    let lay = json(&["fit-check", "--core-diameter", "3.94", "--wire-diameter", "3.73", "--strands", "6", "--json"]);
    assert_eq!((&lay["found"][0], &lay["contact"]), (&"lay_length".into(), &"both".into()));
    near(number(&lay, "lay_length"), 88.102_820_286_919_94, 1e-12);
    near(number(&lay, "lay_angle_deg"), 15.296_255_548_875, 1e-12);
    // the core for a gap
    let flags =
        ["fit-check", "--wire-diameter", "3.73", "--strands", "6", "--lay-length", "115", "--gap", "0.05", "--json"];
    let core = json(&flags);
    assert_eq!((&core["found"][0], &core["contact"]), (&"core_diameter".into(), &"core".into()));
    assert!((sampled_gap(number(&core, "core_diameter"), 3.73, 6.0, 115.0) - 0.05).abs() < 1e-8);
    // and beside the core that is given
    let both = json(&[&flags[..], &["--core-diameter", "3.94"]].concat());
    near(number(&both, "king_wire_diameter_for_gap"), number(&core, "core_diameter"), 1e-13);
    // wires within an outer diameter, king wire as thick, thicker, or what it must be
    let within = |more: &[&str]| {
        let flags = ["fit-check", "--outer-diameter", "12.7", "--strands", "6", "--lay-ratio", "14", "--json"];
        json(&[&flags[..], more].concat())
    };
    let alike = within(&["--core-diameter-ratio", "1"]);
    near(number(&alike, "wire_diameter"), 12.7 / 3.0, 1e-15);
    assert_eq!(alike["contact"], "neighbours");
    near(number(&within(&["--core-diameter", "4.3"]), "wire_diameter"), 4.2, 1e-14);
    let touching = within(&[]);
    assert_eq!((&touching["contact"], number(&touching, "core_diameter")), (&"neighbours".into(), 0.0));
    near(number(&touching, "wire_diameter"), 4.209_617_514_418, 1e-12);
    // anything that is said of a core asks for one
    let cored = within(&["--core-density", "1"]);
    assert_eq!(cored["contact"], "both");
    near(number(&cored, "core_diameter"), 4.280_764_971_164, 1e-12);
    near(number(&cored, "metal_area"), 98.834_525_998_142, 1e-12);
}

#[test]
fn layers_by_flags_and_by_file() {
    let flags = json(&[
        "fit-check",
        "--core-diameter",
        "3.34 mm",
        "--strands",
        "6",
        "--strands",
        "12",
        "--strands",
        "18",
        "--strands",
        "24",
        "--wire-diameter",
        "3.34 mm",
        "--wire-diameter",
        "3.32 mm",
        "--wire-diameter",
        "3.32 mm",
        "--wire-diameter",
        "3.32 mm",
        "--lay-ratio",
        "21",
        "--lay-ratio",
        "13",
        "--lay-ratio",
        "13",
        "--lay-ratio",
        "12",
        "--core-density",
        "7.78 g/cm^3",
        "--wire-density",
        "7.78 g/cm^3",
        "--wire-density",
        "2.70 g/cm^3",
        "--wire-density",
        "2.70 g/cm^3",
        "--wire-density",
        "2.70 g/cm^3",
        "--json",
    ]);
    let file = json(&["fit-check", "examples/conductor-cardinal.toml", "--json"]);
    assert_eq!(flags["layers"].as_array().unwrap().len(), 4);
    for (a, b) in flags["layers"].as_array().unwrap().iter().zip(file["layers"].as_array().unwrap()) {
        for key in LENGTHS {
            assert_eq!(a[key], b[key]);
        }
    }
    // EN 50182, data set of rte-france/pallas-stranded-cable: on sums of diameters
    assert!((number(&file, "nominal_mass_per_length_kg_per_m") - 1.770_510).abs() < 5e-7);
    near(number(&file, "nominal_outer_diameter"), 29.94, 1e-14);
    let more = number(&file, "mass_per_length_kg_per_m") - number(&file, "nominal_mass_per_length_kg_per_m");
    assert!((more - 25e-6).abs() < 1e-6, "{more}");
    // a flag for all layers replaces what the file says of each
    let longer = json(&["fit-check", "examples/conductor-cardinal.toml", "--lay-ratio", "20", "--json"]);
    for layer in longer["layers"].as_array().unwrap() {
        near(number(layer, "lay_ratio"), 20.0, 1e-14);
    }
    // what is said of a strand on standard input is the same
    let Answer { code, out: text, .. } = call_with(
        &["fit-check", "-", "--json"],
        b"core.diameter = 5.1\n[[layer]]\nwires = 6\nwire_diameter = 5\nlay_length = 210\n",
    );
    assert_eq!(code, 0);
    let read: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(read["wire_gap"], fit("5.1", "5", "6", "210")["wire_gap"]);
}

#[test]
fn table_and_csv_say_the_same() {
    let arguments =
        ["fit-check", "--core-diameter", "5 mm", "--wire-diameter", "5 mm", "--strands", "6", "--lay-length", "80 mm"];
    let text = out(&arguments);
    assert!(text.contains("each other") && text.contains("-0.274658"), "{text}");
    assert!(text.contains("The 6 wires do not fit beside each other on the core"), "{text}");
    assert!(text.contains("The flat formula sees no overlap there."), "{text}");
    let csv = out(&[&arguments[..], &["--format", "csv"]].concat());
    let mut rows = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let (head, row) = (rows.next().unwrap(), rows.next().unwrap());
    assert!(rows.next().is_none() && head.len() == row.len());
    let found = fit("5 mm", "5 mm", "6", "80 mm");
    for (name, cell) in head.iter().zip(&row) {
        match &found[*name] {
            Value::Number(value) => {
                assert_eq!(cell.parse().map(f64::to_bits), Ok(value.as_f64().unwrap().to_bits()), "{name}")
            }
            Value::String(word) => assert_eq!(cell, word),
            value => assert!(*name == "layer" || value.is_null() && cell.is_empty(), "{name}: {value}"),
        }
    }
}

#[test]
fn what_does_not_fit_the_question_is_refused() {
    let good = [("--core-diameter", "5"), ("--wire-diameter", "5"), ("--strands", "6"), ("--lay-length", "80")];
    let with = |changes: &[(&str, &str)]| {
        let mut arguments = vec!["fit-check".to_owned()];
        let kept = good.iter().filter(|(flag, _)| !changes.iter().any(|(other, _)| other == flag));
        for (flag, value) in kept.chain(changes).filter(|(_, value)| !value.is_empty()) {
            arguments.extend([(*flag).to_owned(), (*value).to_owned()]);
        }
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        call(&arguments)
    };
    assert_eq!(with(&[]).code, 0);
    for (changes, status, part) in [
        (&[("--core-diameter", "5 mm")][..], 2, "has no unit, but"),
        (&[("--wire-material", "steel")], 2, "stands for a density"),
        (&[("--strands", "1")], 1, "no neighbour"),
        (&[("--strands", "0")], 1, "whole number of wires"),
        (&[("--strands", "6.5")], 1, "whole number of wires"),
        (&[("--strands", "-6")], 1, "whole number of wires"),
        (&[("--strands", "")], 2, "number of wires is missing"),
        (&[("--wire-diameter", "")], 2, "wire diameter is missing"),
        (&[("--wire-diameter", "0")], 1, "greater than 0"),
        (&[("--wire-diameter", "-5")], 1, "greater than 0"),
        (&[("--wire-diameter", "NaN")], 1, "not a finite number"),
        (&[("--core-diameter", "-5")], 1, "greater than 0"),
        (&[("--core-diameter", "inf")], 1, "not a finite number"),
        (&[("--lay-length", "0")], 1, "greater than 0"),
        (
            &[("--lay-length", "30")],
            1,
            "too short a lay for 6 wires of 5: as flat rings on top of each other they need 30",
        ),
        (&[("--lay-length", ""), ("--lay-angle", "90 deg")], 1, "less than 90 degrees"),
        (&[("--lay-length", ""), ("--lay-angle", "0 deg")], 1, "greater than 0"),
        (&[("--lay-length", ""), ("--lay-angle", "85 deg")], 1, "too short a lay"),
        (&[("--lay-length", ""), ("--lay-ratio", "0")], 1, "greater than 0"),
        (&[("--lay-length", "")], 1, "leave no gap between each other on 5 even where they are straight"),
        (&[("--lay-ratio", "9")], 2, "both give the lay"),
        (&[("--core-diameter-ratio", "1")], 2, "both give the size"),
        (&[("--gap", "-1")], 1, "at least 0"),
        (&[("--outer-diameter", "15")], 2, "too much"),
        (&[("--outer-diameter", "10"), ("--core-diameter", "")], 1, "leaves no room"),
        (&[("--outer-diameter", "5"), ("--wire-diameter", "")], 1, "leaves no room"),
        (&[("--wire-diametr", "5")], 2, "unexpected argument"),
        (&[("--core-diameter", "1e200")], 1, "at most 1e100"),
    ] {
        let Answer { code, out, err } = with(changes);
        assert_eq!(code, status, "{changes:?}: {err}");
        assert!(out.is_empty() && err.contains(part), "{changes:?}: {err}");
    }
    // a mistake in a file is shown there
    let Answer { code, err, .. } =
        call_with(&["fit-check", "-"], b"[[layer]]\nwires = 6\nwire_diameter = \"5 mm\"\nlay_length = \"29 mm\"\n");
    assert_eq!(code, 1);
    assert!(err.contains("standard input:4:14") && err.contains("they need 30 mm"), "{err}");
}

/// Wires without a core touch each other, and two of them on the axis.
#[test]
fn no_core_and_a_core_of_nothing() {
    let three = json(&["fit-check", "--wire-diameter", "4", "--strands", "3", "--lay-length", "60", "--json"]);
    assert_eq!((&three["contact"], number(&three, "wire_gap")), (&"neighbours".into(), 0.0));
    let king = number(&three, "king_wire_diameter");
    assert!(sampled_gap(king, 4.0, 3.0, 60.0).abs() < 1e-8);
    near(number(&three, "strand_outer_diameter"), king + 8.0, 1e-14);
    // laid on the axis three wires would overlap; they take the same lay
    let axis = fit("0", "4", "3", "60");
    assert!(number(&axis, "wire_gap") < 0.0);
    for key in ["strand_outer_diameter", "metal_area", "fill_factor", "nominal_outer_diameter"] {
        near(number(&axis, key), number(&three, key), 1e-14);
    }
    let two = fit("0", "4", "2", "60");
    assert_eq!((&two["contact"], number(&two, "strand_outer_diameter")), (&"neighbours".into(), 8.0));
    near(number(&two, "king_wire_diameter"), 0.0, 0.0);
}
