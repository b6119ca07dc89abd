//! Start geometry: what is written is measured again, element by element.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs;
use std::path::PathBuf;

use command::{call, json, near, number, out};
use nply::geometry::{Clearance, Contact, Wire, Wires};

const STRAND: [&str; 8] = ["nodes", "--strands", "6", "--helical-angle", "17.44 deg", "--diameter", "2 mm", "--core"];

/// A wire of a file of nodes: name, radius, nodes.
type Row = (String, f64, Vec<[f64; 3]>);

/// The wires of the file of nodes that is written.
fn wires(arguments: &[&str]) -> Vec<Row> {
    let name: String = arguments.concat().chars().filter(char::is_ascii_alphanumeric).collect();
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("nodes-{name}.csv"));
    out(&[arguments, &["--output", path.to_str().unwrap()]].concat());
    let text = fs::read_to_string(&path).unwrap();
    let mut wires: Vec<Row> = Vec::new();
    for row in text.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |i: usize| -> f64 { cells[i].parse().unwrap() };
        if wires.last().is_none_or(|(name, ..)| name != cells[0]) {
            wires.push((cells[0].to_owned(), number(9), Vec::new()));
        }
        wires.last_mut().unwrap().2.push([number(3), number(4), number(5)]);
    }
    wires
}

/// The least gap of any two of these wires, coatings apart.
fn gap(those: &[&Row], coating: f64) -> f64 {
    let wire = |(_, radius, points): &&'_ Row| (*radius, points.clone());
    let those: Vec<_> = those.iter().map(wire).collect();
    let wires: Vec<Wire<'_>> = those
        .iter()
        .map(|(radius, points)| Wire { points, closed: false, diameter: 2.0 * (radius + coating) })
        .collect();
    let index = Wires::new(&wires).unwrap();
    index.search(0..index.segments(), &Clearance::default()).tightest().unwrap().gap
}

/// The least gap of two wires of a file of nodes, coatings apart, and that of any wire to the core.
fn measured(arguments: &[&str], coating: f64) -> (f64, f64) {
    let wires = wires(arguments);
    let (core, strands): (Vec<_>, Vec<_>) = wires.iter().partition(|(name, ..)| name == "core");
    assert_eq!((strands.len(), core.len()), (6, 1));
    (gap(&strands, coating), gap(&[strands[0], core[0]], coating))
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
        (
            &["--diameter", "4.2 mm", "--core-diameter", "4.3 mm", "--lay-length", "177.8 mm"],
            2,
            "remove one of them (`--core-diameter` is the core of strands that touch each other and it; a core wire of any size is `--core`",
        ),
    ] {
        let found = call(&[&lay[..], more].concat());
        assert_eq!((found.code, found.out.as_str()), (code, ""), "{more:?}: {}", found.err);
        assert!(found.err.contains(part) && found.err.starts_with("error: "), "{more:?}: {}", found.err);
    }
}

/// A king wire that keeps its strands apart, of a surface: how thick, in the unit of the input, and what to do.
#[test]
fn a_core_too_thick_for_touching_strands_is_refused_in_their_unit() {
    let strand = ["--strands", "6", "--diameter", "4.2mm", "--core", "2.15mm", "--lay-length", "177.8mm"];
    let found = call(&[&["mesh", "--format", "stl"], &strand[..]].concat());
    assert_eq!(found.code, 1);
    let touching = Contact::from_lay_length(6, 177.8 / 2.1).unwrap().radius_ratio();
    let hole = format!("leave a hole of radius {:.5} mm", 2.1 * (touching - 1.0));
    for part in ["a core of radius 2.15 mm", &hole, "[core] and [[layer]]"] {
        assert!(found.err.contains(part), "{}", found.err);
    }
}

/// All lengths in mm of a layer of a report.
fn in_mm(layer: &serde_json::Value, name: &str) -> f64 {
    number(&layer["si"], name) * 1e3
}

/// Strands of layers: no two polylines of a file come nearer than their radii, wires of a layer, wires of two layers and the king wire alike,
/// and what is said to touch does.
#[test]
fn wires_of_layers_are_clear_of_each_other_and_of_all_below() {
    let core_strand = concat!(env!("CARGO_TARGET_TMPDIR"), "/core-strand.toml");
    let text = r#"
        [[layer]]
        wires = 14
        wire_diameter = "1.6 mm"
        lay_length = "95 mm"
        hand = "right"
        [core.strand.core]
        diameter = "2.1 mm"
        [[core.strand.layer]]
        wires = 6
        wire_diameter = "2 mm"
        lay_length = "60 mm"
        hand = "left"
    "#;
    fs::write(core_strand, text).unwrap();
    for (file, more, coating) in [
        ("examples/strand-7-wire.toml", &[][..], 0.0),
        ("examples/strand-7-wire.toml", &["--element-type", "B32", "--elements-per-pitch", "9"], 0.0),
        ("examples/spiral-strand-1x19.toml", &[], 0.0),
        ("examples/spiral-strand-1x19.toml", &["--coating", "0.05 mm", "--stagger", "0.3"], 0.05),
        ("examples/spiral-strand-1x19.toml", &["--any-stagger", "--elements-per-pitch", "11"], 0.0),
        ("examples/mooring-spiral-strand.toml", &["--elements-per-pitch", "12"], 0.0),
        (core_strand, &[], 0.0),
    ] {
        let arguments = [&["nodes", file, "--lay-lengths", "1.5"], more].concat();
        let report = json(&[&arguments[..], &["--json"]].concat());
        assert_eq!(report["clear"], true, "{arguments:?}");
        let layers = report["layers"].as_array().unwrap();
        let wires = wires(&arguments);
        let core: Vec<&Row> = wires.iter().filter(|(name, ..)| name == "core").collect();
        let mut below = core.clone();
        for (at, layer) in layers.iter().enumerate() {
            let prefix = format!("layer{}-", at + 1);
            let own: Vec<&Row> = wires.iter().filter(|(name, ..)| name.starts_with(&prefix)).collect();
            near(f64::from(u32::try_from(own.len()).unwrap()), number(layer, "strands"), 0.0);
            // one of two neighbours is nearest: staggered nodes close round the ply with a step of their own
            let stated = in_mm(layer, "gap");
            let within = gap(&own, coating);
            assert!(within > -1e-9, "{arguments:?}: {within}");
            if !more.contains(&"--stagger") && !more.contains(&"--any-stagger") {
                assert!((within - stated).abs() < 1e-9, "{arguments:?}: {within} {stated}");
            }
            let to_below = own.iter().flat_map(|own| below.iter().map(|below| gap(&[own, below], coating)));
            let to_below = to_below.fold(f64::INFINITY, f64::min);
            let stated = in_mm(layer, "core_gap");
            assert!(stated > -1e-9 && to_below > stated - 1e-9, "{arguments:?}: {to_below} {stated}");
            if at == 0 {
                assert!((to_below - stated).abs() < 1e-9, "{arguments:?}: {to_below} {stated}");
            }
            // it is no wider than its neighbours or what is below make it
            assert!(stated < 1e-9 || in_mm(layer, "gap") < 1e-9, "{arguments:?}");
            // laid at the lay length of the file, on a radius that is a chord's height greater
            let (laid, taken) = (in_mm(layer, "laid_helix_radius"), in_mm(layer, "helix_radius"));
            assert!(taken > laid && taken < 1.1 * laid + coating * 4.0);
            below.extend(own);
        }
        assert!(wires.iter().all(|(.., nodes)| nodes.len() == wires[0].2.len()));
        if !more.contains(&"--stagger") {
            let level = |k: usize| wires.iter().all(|(.., nodes)| (nodes[k][2] - wires[0].2[k][2]).abs() < 1e-9);
            assert!((0..wires[0].2.len()).all(level), "{arguments:?}");
        }
    }
}

#[test]
fn layers_keep_the_lay_lengths_of_their_file() {
    let report = json(&["nodes", "examples/spiral-strand-1x19.toml", "--json"]);
    let layers = report["layers"].as_array().unwrap();
    for (layer, [lay_length, elements, hand]) in layers.iter().zip([[60.0, 24.0, -1.0], [110.0, 44.0, 1.0]]) {
        near(in_mm(layer, "lay_length"), lay_length, 1e-12);
        near(number(layer, "elements_per_lay_length"), elements, 1e-12);
        near(number(layer, "handedness"), hand, 0.0);
    }
    for (more, part) in
        [(&["--core", "1 mm"], "stands in its description"), (&["--lay-radius", "2 mm"], "radius of its own")]
    {
        let found = call(&[&["nodes", "examples/spiral-strand-1x19.toml"][..], more].concat());
        assert!(found.code == 2 && found.err.contains(part), "{}", found.err);
    }
}

/// Where wires carry each other off the core, that is said.
#[test]
fn a_king_wire_that_is_loose_is_said_to_be() {
    let said = out(&STRAND);
    assert!(said.contains("The wires carry each other and do not reach the core: their elements stand 0.0"), "{said}");
    let held = ["nodes", "--strands", "6", "--diameter", "4.2 mm", "--core", "2.15 mm", "--lay-length", "177.8 mm"];
    assert!(!out(&held).contains("do not reach"));
}

/// Every field of the files for finite elements: CalculiX reads twenty characters of one and cuts off the rest, exponents too.
#[test]
fn no_field_of_an_input_file_is_longer_than_twenty_characters() {
    let strand = "examples/strand-7-wire.toml";
    let spiral = "examples/spiral-strand-1x19.toml";
    let bare = [
        "nodes",
        "--strands",
        "6",
        "--diameter",
        "4.2 mm",
        "--core",
        "2.15 mm",
        "--lay-length",
        "177.8 mm",
        "--hand",
        "S",
    ];
    for arguments in [
        &bare[..],
        &["nodes", strand],
        &["nodes", spiral, "--element-type", "B32"],
        &["nodes", spiral, "--unit", "m"],
        &["nodes", spiral, "--unit", "nm"],
        &["mesh", spiral, "--centrelines"],
        &["mesh", "examples/rope-6x7.toml", "--centrelines", "--elements-per-pitch", "96"],
        &["mesh", "examples/dna-supercoil.toml", "--centrelines", "--unit", "m"],
    ] {
        let written = |format| out(&[arguments, &["--format", format]].concat());
        let (inp, csv) = (written("inp"), written("csv"));
        let exact = csv.lines().skip(1).map(|row| {
            let cells: Vec<f64> = row.split(',').skip(3).take(3).map(|cell| cell.parse().unwrap()).collect();
            [cells[0], cells[1], cells[2]]
        });
        let exact: Vec<[f64; 3]> = exact.collect();
        let greatest = exact.as_flattened().iter().fold(0.0, |all: f64, x| all.max(x.abs()));
        let (mut place, mut nodes) = ("", exact.iter());
        for line in inp.lines().skip(2) {
            if line.starts_with('*') {
                place = line;
                continue;
            }
            let fields: Vec<&str> = line.split(',').map(str::trim).collect();
            assert!(fields.iter().all(|field| field.len() <= 20), "{arguments:?}: {line}");
            if place == "*NODE" {
                // what is left out is less than the last digit of the greatest, and noughts are noughts
                for (field, exact) in fields[1..].iter().zip(nodes.next().unwrap()) {
                    let read: f64 = field.parse().unwrap();
                    assert!((read - exact).abs() <= 2e-12 * greatest, "{arguments:?}: {line}");
                    assert!(read == 0.0 || read.abs() > 1e-16 * greatest, "{arguments:?}: {line}");
                }
            }
        }
        assert!(nodes.next().is_none() && !inp.contains("radius 2.1500000000000004"));
    }
}

/// Elements of three nodes: the middle one on the helix, as the ends are, so that as many elements lose a quarter to chords.
#[test]
fn quadratic_elements_have_their_middle_nodes_on_the_helix() {
    let quadratic = [&STRAND[..], &["--element-type", "b32"]].concat();
    let [straight, curved] = [&STRAND[..], &quadratic].map(|it| json(&[it, &["--json"]].concat()));
    let doubled = json(&[&STRAND[..], &["--elements-per-pitch", "48", "--json"]].concat());
    assert_eq!((&curved["element_type"], &straight["element_type"]), (&"B32".into(), &"B31".into()));
    assert_eq!(curved["elements_per_lay_length"], 24);
    near(number(&curved, "helix_radius"), number(&doubled, "helix_radius"), 1e-15);
    let to_core = |report| number(report, "core_chord_share") / number(report, "helix_radius");
    near(to_core(&straight) / to_core(&curved), 4.0, 0.02);
    let radius = number(&curved, "helix_radius");
    let rows = wires(&quadratic);
    assert!(rows.iter().all(|(name, _, nodes)| {
        let on = if name == "core" { 0.0 } else { radius };
        nodes.len() == 2 * 72 + 1 && nodes.iter().all(|[x, y, _]| ((x * x + y * y).sqrt() - on).abs() < 1e-12)
    }));
    let inp = out(&[&quadratic[..], &["--format", "inp"]].concat());
    let mut lines = inp.lines().skip_while(|line| *line != "*ELEMENT, TYPE=B32, ELSET=STRAND-2");
    assert_eq!(lines.nth(1), Some("73, 146, 147, 148"));
    assert_eq!(lines.next(), Some("74, 148, 149, 150"));
    let mesh = ["mesh", "--strands", "3", "--helical-angle", "20 deg", "--centrelines", "--lay-lengths", "1"];
    let inp = out(&[&mesh[..], &["--elements-per-pitch", "4", "--element-type", "B32", "--format", "inp"]].concat());
    assert!(
        inp.contains("*ELEMENT, TYPE=B32, ELSET=STRAND-1\n1, 1, 2, 3\n2, 3, 4, 5\n3, 5, 6, 7\n4, 7, 8, 9\n**"),
        "{inp}"
    );
}

/// What is written for a solver is read again, with its radii and its unit: the same gaps as of the table.
#[test]
fn an_input_file_is_checked_as_the_table_is() {
    for more in [
        &["examples/spiral-strand-1x19.toml", "--lay-lengths", "1"][..],
        &["examples/strand-7-wire.toml", "--element-type", "B32"],
    ] {
        let found = ["csv", "inp"].map(|ending| {
            let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
                .join(format!("checked-{}.{ending}", more.len() + more[0].len()));
            out(&[&["nodes"], more, &["--output", path.to_str().unwrap()]].concat());
            json(&["clearance", path.to_str().unwrap(), "--json"])
        });
        assert_eq!(found[1]["unit"], "mm");
        assert_eq!(found[1]["overlapping_pairs"], 0);
        for name in ["least_distance", "clearance"] {
            let [csv, inp] = [0, 1].map(|at| number(&found[at], name));
            assert!((csv - inp).abs() < 1e-12, "{more:?} {name}: {csv} {inp}");
        }
        let names = |at: usize| {
            found[at]["curves"]
                .as_array()
                .unwrap()
                .iter()
                .map(|it| it["name"].as_str().unwrap().to_lowercase())
                .collect::<Vec<_>>()
        };
        assert_eq!(names(0), names(1));
    }
}

/// Elements keep the length for which the lay was found: how far whole ones reach is said where it is more than was asked.
#[test]
fn a_length_of_whole_elements_is_said_where_it_is_more() {
    // 177.8 mm in 24 elements: 14 of them are 103.717 mm
    let asked = ["nodes", "examples/strand-7-wire.toml", "--length", "100 mm"];
    let said = out(&asked);
    assert!(said.contains("The nodes reach 103.717 mm, 14 whole elements: 100 mm would end within one."), "{said}");
    for (name, _, points) in wires(&asked) {
        let end = points.last().unwrap()[2];
        assert!((end - 14.0 * 177.8 / 24.0).abs() < 1e-9, "{name} {end}");
    }
    for whole in [&["--length", "177.8 mm"][..], &["--lay-lengths", "2.5"], &[]] {
        let said = out(&[&asked[..2], whole].concat());
        assert!(!said.contains("whole element"), "{said}");
    }
}

/// What is about a whole file is shown at its first table, and not at a comment above it.
#[test]
fn a_rope_is_refused_at_its_first_table() {
    let refused = call(&["nodes", "examples/rope-6x7.toml"]);
    assert_eq!(refused.code, 2, "{}", refused.err);
    assert!(refused.err.contains("| [construction]\n"), "{}", refused.err);
}
