//! Layered strands and ropes as shapes: closed bodies, what they enclose, and that rods lie beside each other.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::disallowed_methods, reason = "an independent route takes the platform's functions")]

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use nply::geometry::{Clearance, Wires};
use nply_sheet::construction::ConstructionSpec;
use nply_sheet::mesh::{
    Assembly, Chain, FileUnit, Fineness, Layered, Spacing, StartGeometry, StartWanted, Surface, Wanted, chain_summary,
    chains, surface_summary,
};

fn laid(example: &str) -> (Layered, Assembly) {
    let path = format!("{}/../../examples/{example}.toml", env!("CARGO_MANIFEST_DIR"));
    let spec = ConstructionSpec::from_toml(example, &std::fs::read_to_string(path).unwrap()).unwrap();
    let strand = Layered::of(&spec).unwrap();
    let assembly = strand.assembly(&Wanted::default()).unwrap();
    (strand, assembly)
}

/// The least gap of polylines, and how far chords may lie off the smooth wires on both sides.
fn least_gap(chains: &[&Chain]) -> (f64, f64) {
    let wires: Vec<nply::geometry::Wire<'_>> = chains
        .iter()
        .map(|chain| nply::geometry::Wire { points: &chain.points, closed: false, diameter: 2.0 * chain.radius })
        .collect();
    let index = Wires::new(&wires).unwrap();
    let found = index.search(0..index.segments(), &Clearance::default());
    let approach = found.tightest().unwrap();
    (approach.gap, approach.wires.iter().map(|wire| index.sagitta(*wire)).sum())
}

#[test]
fn every_wire_is_one_closed_body_of_its_volume() {
    for (example, count) in [("spiral-strand-1x19", 19), ("conductor-cardinal", 61), ("rope-6x7", 43)] {
        let (strand, assembly) = laid(example);
        let fineness = Fineness { chord_error: Some("0.04"), ..Fineness::default() };
        let surface = Surface::of(strand.subject(), &assembly, fineness).unwrap();
        assert_eq!(surface.parts.len(), count, "{example}");
        for part in &surface.parts {
            let mut edges: HashMap<(u32, u32), u32> = HashMap::new();
            for [a, b, c] in &part.mesh.triangles {
                for edge in [(*a, *b), (*b, *c), (*c, *a)] {
                    *edges.entry(edge).or_default() += 1;
                }
            }
            let name = &part.wire.name;
            assert!(edges.iter().all(|(&(a, b), &count)| count == 1 && edges.contains_key(&(b, a))), "{name} is open");
            assert_eq!(part.mesh.positions.len() + part.mesh.triangles.len(), edges.len() / 2 + 2, "{name}");
            assert!(part.mesh.deviation.iter().all(|off| off.abs() <= 0.04), "{name} {:?}", part.mesh.deviation);
            // πr²L, L by steps of the centreline itself, less at most a skin as thick as the chord error
            let [start, end] = part.wire.tube.parameters();
            let at = |k: u32| part.wire.tube.course().place(start + (end - start) * f64::from(k) / 8000.0).position;
            let step = |k: u32| {
                let (a, b) = (at(k), at(k + 1));
                ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2) + (a[2] - b[2]).powi(2)).sqrt()
            };
            let length: f64 = (0..8000).map(step).sum();
            let radius = part.wire.tube.radius();
            let short = 1.0 - part.mesh.volume() / (PI * radius * radius * length);
            assert!(short > 0.0 && short < 2.0 * 0.04 / radius, "{name} {short}");
        }
    }
}

/// Wires of different layers, and of different strands, keep clear of each other by no more than chords take.
#[test]
fn rods_lie_beside_each_other() {
    for example in ["spiral-strand-1x19", "conductor-cardinal", "rope-6x7"] {
        let (strand, assembly) = laid(example);
        let nodes =
            chains(strand.subject(), &assembly, Spacing { per_lay_length: Some(96), ..Spacing::default() }).unwrap();
        let rod = |chain: &Chain| match chain.name.split_once("-wire").or_else(|| chain.name.split_once("-core")) {
            Some((rod, _)) if rod.contains("strand") => rod.to_owned(),
            _ => chain.name.clone(),
        };
        let mut least = f64::INFINITY;
        for (i, a) in nodes.iter().enumerate().filter(|(_, a)| a.name.ends_with('1') || a.name.ends_with("core")) {
            for b in nodes.iter().enumerate().filter(|(j, b)| *j != i && rod(b) != rod(a)).map(|(_, b)| b) {
                let (gap, chords) = least_gap(&[a, b]);
                assert!(gap >= -1.01 * chords - 1e-9, "{example}: {} {} {gap} {chords}", a.name, b.name);
                least = least.min(gap + chords);
            }
        }
        // some of them touch: the first layer its core
        assert!(least < 0.02, "{example} {least}");
    }
}

/// The hands and the lays are those of the description, measured on the nodes.
#[test]
fn wires_turn_as_they_are_said_to() {
    let turn =
        |from: [f64; 2], to: [f64; 2]| (from[0] * to[1] - from[1] * to[0]).atan2(from[0] * to[0] + from[1] * to[1]);
    let (strand, assembly) = laid("rope-6x7");
    let wire = |name: &str| assembly.wires.iter().find(|wire| wire.name == name).unwrap().tube;
    let (core, outer) = (wire("layer1-strand2-core"), wire("layer1-strand2-wire3"));
    let [start, end] = core.parameters();
    let place = |t: f64| (core.course().place(t), outer.course().place(t));
    let (mut about_axis, mut about_strand) = (0.0, 0.0);
    const STEPS: u32 = 4000;
    for k in 0..STEPS {
        let t = |k: u32| start + (end - start) * f64::from(k) / f64::from(STEPS);
        let ((a, wire_a), (b, wire_b)) = (place(t(k)), place(t(k + 1)));
        about_axis += turn([a.position[0], a.position[1]], [b.position[0], b.position[1]]);
        // across the strand, in directions that are carried along without a twist
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let arm = |wire: [f64; 3], middle: [f64; 3]| [0, 1, 2].map(|i| wire[i] - middle[i]);
        let (arm_a, arm_b) = (arm(wire_a.position, a.position), arm(wire_b.position, b.position));
        let carried = |way: [f64; 3]| [0, 1, 2].map(|i| way[i] - dot(way, b.tangent) * b.tangent[i]);
        let (n, m) = (carried(a.inward), carried(a.binormal));
        about_strand += turn([dot(arm_a, a.inward), dot(arm_a, a.binormal)], [dot(arm_b, n), dot(arm_b, m)]);
    }
    assert!((about_axis - TAU).abs() < 1e-9, "{about_axis}"); // a right-handed turn in 75 mm
    let along = (end - start) * strand.subject().strand_radius.unwrap();
    assert!((about_strand / (-TAU * along / 32e-3) - 1.0).abs() < 1e-5, "{about_strand}"); // left-handed, one in 32 mm of strand
}

#[test]
fn what_is_not_drawn_is_refused_in_a_sentence() {
    let (strand, _) = laid("rope-6x7");
    for (wanted, part) in [
        (Wanted { core: Some(""), ..Wanted::default() }, "stands in its description"),
        (Wanted { stripes: 2, ..Wanted::default() }, "not known here"),
        (Wanted { contact_lines: true, ..Wanted::default() }, "plies of one layer"),
        (Wanted { length: Some("20"), ..Wanted::default() }, "has no unit"),
        (Wanted { length: Some("-20 mm"), ..Wanted::default() }, "greater than 0"),
        (Wanted { cuts: vec!["90 mm"], ..Wanted::default() }, "passes by"),
    ] {
        let said = strand.assembly(&wanted).unwrap_err().to_string();
        assert!(said.contains(part), "{said}");
    }
    let wire = "wires = 6\nlay_length = 900\nhand = \"right\"\n";
    let deep = format!(
        "[core]\ndiameter = 40\n[[layer]]\n{wire}[layer.strand.core]\ndiameter = 5\n[[layer.strand.layer]]\n{wire}\
         [layer.strand.layer.strand.core]\ndiameter = 1\n[[layer.strand.layer.strand.layer]]\n{wire}wire_diameter = 1\n"
    );
    let said = Layered::of(&ConstructionSpec::from_toml("deep.toml", &deep).unwrap()).unwrap_err().to_string();
    assert!(said.contains("wound three times"), "{said}");
}

/// A lay that was not given is found, and whoever takes the nodes is told so.
#[test]
fn a_lay_that_was_not_given_is_said_to_be_found() {
    let described = |lay: &str, more: &str| {
        let text = format!(
            "[core]\ndiameter = \"4.3 mm\"\n[[layer]]\nwires = 6\nwire_diameter = \"4.2 mm\"\nhand = \"right\"\n{lay}\n{more}"
        );
        ConstructionSpec::from_toml("strand.toml", &text).unwrap()
    };
    let outer = "[[layer]]\nwires = 12\nwire_diameter = \"4.1 mm\"\nhand = \"left\"\n";
    let touching = "No lay was given for layer 1: the one at which its wires just touch is taken.";
    let apart = "No lay was given for layer 1: the one at which its wires have the gap that is wanted is taken.";
    for (lay, more, wanted) in [
        ("", String::new(), vec![touching]),
        ("gap = \"0.01 mm\"", String::new(), vec![apart]),
        ("lay_length = \"177.8 mm\"", String::new(), vec![]),
        ("", format!("{outer}lay_length = \"200 mm\""), vec![touching]),
        ("lay_length = \"177.8 mm\"", outer.to_owned(), vec![&*touching.replace("layer 1", "layer 2")]),
    ] {
        let spec = described(lay, &more);
        let start = StartGeometry::of_layers(&spec, &StartWanted::default()).unwrap();
        let unit = FileUnit::of(start.ply(), None, None).unwrap();
        let report: serde_json::Value = serde_json::from_str(&start.json()).unwrap();
        assert_eq!(report["notes"], serde_json::json!(wanted), "{lay}{more}");
        let strand = Layered::of(&spec).unwrap();
        let assembly = strand.assembly(&Wanted::default()).unwrap();
        let surface = Surface::of(strand.subject(), &assembly, Fineness::default()).unwrap();
        let lines = chains(strand.subject(), &assembly, Spacing::default()).unwrap();
        for said in [
            start.text(&unit),
            surface_summary(strand.subject(), &surface, &unit),
            chain_summary(strand.subject(), &lines, &unit),
        ] {
            let found: Vec<&str> = said.lines().filter(|line| line.contains("No lay")).collect();
            assert_eq!(found, wanted, "{said}");
        }
    }
}
