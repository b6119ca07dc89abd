//! The document of a layered strand: what it understands, and how it says what it does not.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

use nply::Handedness;
use nply::geometry::WireLay;
use nply_sheet::construction::{CONSTRUCTION_KEYS, Construction, ConstructionSpec, MATERIALS};
use nply_sheet::{ErrorKind, SpecError, Table};

const STRAND: &str = r#"
[construction]
title = "Seven wires and twelve"

[core]
diameter = "4 mm"
material = "galvanised steel"
youngs_modulus = "190 GPa"
poissons_ratio = 0.3

[[layer]]
wires = 6
wire_diameter = "3.9 mm"
lay_length = "150 mm"
hand = "left"
density = "7.8 g/cm^3"
preforming = 1

[[layer]]
wires = 12
wire_diameter = "0.39 cm"
lay_ratio = 12
hand = "right"
material = "Aluminum"
youngs_modulus = "70 GPa"
poissons_ratio = 0.33
preforming = 0
"#;

fn check(text: &str) -> Result<Construction, SpecError> {
    ConstructionSpec::from_toml("s.toml", text)?.check()
}

#[test]
fn a_strand_is_understood() {
    let strand = check(STRAND).unwrap();
    assert_eq!(strand.title.as_deref(), Some("Seven wires and twelve"));
    assert!(strand.measured);
    let core = strand.core.unwrap();
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-15 * b.abs();
    assert!(close(core.diameter, 4e-3) && core.density.is_some_and(|density| close(density, 7780.0)));
    assert_eq!((core.youngs_modulus, core.poissons_ratio), (Some(190e9), Some(0.3)));
    let [inner, outer] = strand.layers.as_slice() else { panic!("two layers") };
    assert_eq!((inner.wires, inner.hand, inner.preforming), (6, Handedness::Left, 1.0));
    assert!(matches!(inner.lay, WireLay::Length(length) if close(length, 0.15)));
    assert!(inner.density.is_some_and(|density| close(density, 7800.0)) && inner.youngs_modulus.is_none());
    assert_eq!((outer.wires, outer.hand, outer.preforming), (12, Handedness::Right, 0.0));
    assert_eq!((outer.lay, outer.youngs_modulus), (WireLay::Ratio(12.0), Some(70e9)));
    assert!(close(outer.wire_diameter, 3.9e-3) && outer.density.is_some_and(|density| close(density, 2703.0)));
}

/// The same by flags; and without any unit, densities and moduli with numbers of their own.
#[test]
fn flags_say_the_same() {
    let flags = [
        ("title", "Seven wires and twelve"),
        ("core-diameter", "4 mm"),
        ("core-material", "galvanized-steel"),
        ("core-youngs-modulus", "190 GPa"),
        ("core-poissons-ratio", "0.3"),
        ("strands", "6"),
        ("strands", "12"),
        ("wire-diameter", "3.9 mm"),
        ("lay-length", "150 mm"),
        ("hand", "S"),
        ("hand", "Z"),
        ("wire-density", "7.8 g/cm^3"),
    ];
    let by_flags = ConstructionSpec::from_flags(flags).unwrap().check().unwrap();
    let by_file = check(STRAND).unwrap();
    assert_eq!((&by_flags.core, by_flags.layers[0].lay), (&by_file.core, by_file.layers[0].lay));
    assert_eq!(by_flags.layers[1].hand, Handedness::Right);
    let bare = "core = { diameter = 2, density = 1.5, youngs_modulus = 1 }\nlayer = [{ wires = 6, wire_diameter = 2, lay_length = 60, youngs_modulus = 3 }]\n";
    let bare = check(bare).unwrap();
    assert!(!bare.measured);
    assert_eq!((bare.core.unwrap().density, bare.layers[0].youngs_modulus), (Some(1.5), Some(3.0)));
    // nothing is nothing in every unit: no core
    let none =
        check("core.diameter = 0\n[[layer]]\nwires = 3\nwire_diameter = \"2 mm\"\nlay_angle = \"8 deg\"\n").unwrap();
    assert!(none.core.is_none() && none.measured);
}

#[test]
fn a_mistake_is_said_in_a_sentence_at_its_place() {
    use ErrorKind::{Contradiction, Domain, Missing, Syntax, UnknownKey, WrongType, WrongUnit};
    for (from, to, kind, said) in [
        ("[core]\n", "[cor]\n", UnknownKey, "`cor` is no table of a layered strand"),
        ("[core]\n", "[strand]\n", UnknownKey, "described to `nply solve`"),
        ("[core]\n", "[[core]]\n", WrongType, "`core` is a table of its own"),
        ("[[layer]]\nwires = 12", "[layers]\nwires = 12", UnknownKey, "did you mean `[[layer]]`?"),
        ("wires = 6", "strands = 6", UnknownKey, "`strands` is no key of [[layer]]; its keys are wires"),
        ("wires = 6", "outer_diameter = 6\nwires = 6", UnknownKey, "it belongs below [construction]"),
        ("wires = 6", "wires = 1", Domain, "s.toml:12:9: `wires = 1`: a single wire has no neighbour"),
        ("wires = 6", "", Missing, "the number of wires of layer 1 is missing: give `wires` in [[layer]]"),
        ("wire_diameter = \"3.9 mm\"", "", Missing, "the wire diameter of layer 1 is missing"),
        ("lay_length = \"150 mm\"", "", Missing, "the lay (its length, ratio or angle) of layer 1 is missing"),
        ("hand = \"left\"", "", Missing, "the hand (layers of either hand differ) of layer 1 is missing"),
        ("\"4 mm\"", "4", WrongUnit, "s.toml:6:12: `diameter = 4` has no unit, but"),
        ("\"4 mm\"", "\"4 N\"", WrongUnit, "is a force; what is wanted is a length"),
        ("\"4 mm\"", "4 mm", Syntax, "put the value in quotation marks"),
        ("\"4 mm\"", "nan", Domain, "not a finite number"),
        ("\"4 mm\"", "\"-4 mm\"", Domain, "must be greater than 0"),
        ("\"7.8 g/cm^3\"", "\"7.8 g\"", WrongUnit, "what is wanted is a density, such as"),
        ("\"7.8 g/cm^3\"", "7.8", WrongUnit, "`density = 7.8` has no unit"),
        ("\"Aluminum\"", "\"wood\"", WrongType, "the materials are steel, galvanised steel, aluminium, copper"),
        ("poissons_ratio = 0.33", "poissons_ratio = 0.51", Domain, "greater than -1 and at most 0.5"),
        ("lay_ratio = 12", "lay_ratio = 12\nlay_angle = \"9 deg\"", Contradiction, "both give the lay of a layer"),
        (
            "material = \"galvanised steel\"",
            "fibre = true\ntensile_strength = \"1770 MPa\"",
            Contradiction,
            "`tensile_strength = \"1770 MPa\"` goes nowhere beside `fibre = true`: a core of fibre does not count",
        ),
        ("diameter = \"4 mm\"", "diameter_ratio = 1.02", Contradiction, "is for finding sizes with `nply fit-check`"),
    ] {
        assert!(STRAND.contains(from), "{from}");
        let error = check(&STRAND.replacen(from, to, 1)).expect_err(to);
        assert_eq!(error.kind(), kind, "{error}");
        assert!(error.to_string().contains(said) && error.to_string().lines().count() == 1, "{error}");
    }
    let none = check("[core]\ndiameter = 2\n").unwrap_err();
    assert!(none.to_string().contains("a strand needs a layer of wires"), "{none}");
    let unequal = [("strands", "6"), ("strands", "12"), ("strands", "18"), ("hand", "S"), ("hand", "Z")];
    let unequal = ConstructionSpec::from_flags(unequal).unwrap_err();
    assert!(unequal.to_string().contains("given 2 times where there are 3 layers"), "{unequal}");
}

#[test]
fn each_key_stands_once_in_the_list() {
    for (at, key) in CONSTRUCTION_KEYS.iter().enumerate() {
        assert!(matches!(key.table, Table::Construction | Table::Core | Table::Layer | Table::Load));
        for other in &CONSTRUCTION_KEYS[at + 1..] {
            assert_ne!(key.datum, other.datum);
            assert_ne!(key.flag, other.flag);
            assert_ne!((key.table, key.name), (other.table, other.name));
        }
    }
    // the help names every material
    for material in &MATERIALS {
        assert!(
            CONSTRUCTION_KEYS.iter().filter(|key| key.name == "material").all(|key| key.help.contains(material.name))
        );
    }
}

/// What is said of a strand belongs to its wires: where to write it is said.
#[test]
fn what_belongs_to_the_wires_of_a_strand_is_shown_its_place() {
    let path = format!("{}/../../examples/rope-6x7.toml", env!("CARGO_MANIFEST_DIR"));
    let rope = ConstructionSpec::from_toml("rope.toml", &std::fs::read_to_string(path).unwrap()).unwrap();
    let strong = ConstructionSpec::from_flags([("wire-tensile-strength", "1770 MPa")]).unwrap();
    let said = rope.overridden_by(&strong).unwrap().check().unwrap_err().to_string();
    assert!(said.contains("write `tensile_strength` in [layer.strand.core] and [[layer.strand.layer]]"), "{said}");
}

/// The same strand of one metal throughout, its fibre cores too.
fn of_one_metal(text: &str) -> String {
    let header = |line: &str| line.trim_matches(['[', ']']).to_owned();
    let dropped = ["density", "material", "fibre"];
    let lines = text.lines().filter(|line| !dropped.iter().any(|key| line.starts_with(key)));
    let lines: Vec<&str> = lines.take_while(|line| *line != "[load]").collect();
    let mut poured = String::new();
    for (at, line) in lines.iter().enumerate() {
        poured += &format!("{line}\n");
        let next = lines.iter().skip(at + 1).find(|line| line.starts_with('['));
        let of_strands = next.is_some_and(|next| header(next).starts_with(&format!("{}.strand", header(line))));
        if line.starts_with('[') && (line.contains("core") || line.contains("layer")) && !of_strands {
            poured += "density = \"7.85 g/cm^3\"\n";
        }
    }
    poured
}

/// What a plane across cuts of a metal, times its density, is what a length of it weighs: of wires in strands in ropes as of wires alone.
#[test]
fn the_section_across_times_the_density_is_the_mass_per_length() {
    let shelf = |folder: &str| std::fs::read_dir(format!("{}/{folder}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let texts = shelf("../../examples").chain(shelf("presets")).map(|entry| entry.unwrap().path());
    let texts = texts.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let mut texts: Vec<String> = texts.map(|path| std::fs::read_to_string(path).unwrap()).collect();
    texts.retain(|text| nply_sheet::construction::is_layered(text));
    assert!(texts.len() > 10);
    let cored = "[[core.strand.layer]]\nwires = 6\nwire_diameter = \"2 mm\"\nlay_ratio = 9\nhand = \"left\"\n\
        [core.strand.core]\ndiameter = \"2.1 mm\"\n\
        [[layer]]\nwires = 12\nwire_diameter = \"2 mm\"\nlay_ratio = 11\nhand = \"right\"\n";
    texts.push(cored.to_owned());
    texts.push(
        cored.replace("wire_diameter = \"2 mm\"\nlay_ratio = 11\n", "lay_ratio = 8\n") // a wire rope on such a core
        + "[[layer.strand.layer]]\nwires = 3\nwire_diameter = \"0.9 mm\"\nlay_ratio = 6\nhand = \"left\"\n",
    );
    for text in texts {
        let text = of_one_metal(&text);
        let fit = ConstructionSpec::from_toml("s.toml", &text).unwrap().check_fit().unwrap();
        let said: serde_json::Value = serde_json::from_str(&nply_sheet::FitReport::of(fit).json()).unwrap();
        let number = |name: &str| said[name].as_f64().unwrap();
        let (area, mass) = (number("metal_area_m2"), number("mass_per_length_kg_per_m"));
        // the same but for rounding
        assert!((7850.0 * area / mass - 1.0).abs() < 1e-14, "{area} m², {mass} kg/m\n{text}");
    }
}
