//! `nply stiffness`: examples run, and what they say is physics.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::disallowed_methods,
    reason = "helpers of tests"
)]

#[path = "command/mod.rs"]
mod command;

use command::{call, call_with, number, root};
use serde_json::Value;

fn json(arguments: &[&str]) -> Value {
    command::json(&[arguments, &["--json"]].concat())
}

fn of_text(text: &str, more: &[&str]) -> Value {
    let answer = call_with(&[&["stiffness", "-", "--json"], more].concat(), text.as_bytes());
    assert_eq!(answer.code, 0, "{}", answer.err);
    serde_json::from_str(&answer.out).unwrap()
}

fn text_of(file: &str) -> String {
    std::fs::read_to_string(root().join(file)).unwrap()
}

/// EA, GJ and coupling are the strand's: the unit of a load, or its absence, does not change theirs.
#[test]
fn stiffnesses_keep_their_units_whatever_the_load() {
    let rows = |force: &str| -> Vec<String> {
        let text = command::out(&["stiffness", "examples/strand-7-wire.toml", "--force", force]);
        let mine = text
            .lines()
            .filter(|line| ["  EA, ", "  GJ, ", "  coupling", "  bending st"].iter().any(|l| line.starts_with(l)));
        mine.map(|line| line.rsplit_once("  ").unwrap().0.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
    };
    let none = rows("0");
    assert_eq!(none.len(), 6, "{none:?}");
    for force in ["130 kN", "0.1 MN", "20 N"] {
        assert_eq!(rows(force), none, "{force}");
    }
    assert!(none.iter().all(|row| !row.contains("kN mm")), "{none:?}");
}

/// Shares of core and layers add up to the loads, which are those that were asked for.
#[test]
fn shares_add_up() {
    for (example, force) in [("strand-7-wire", 130e3), ("spiral-strand-1x19", 30e3), ("rope-6x7", 15e3)] {
        let file = format!("examples/{example}.toml");
        for ends in [&["--turns-per-length", "0 turns/m"][..], &["--moment", "0 N m"]] {
            let said = json(&[&["stiffness", &file], ends].concat());
            let members = || said["layers"].as_array().unwrap().iter().chain(std::iter::once(&said["core"]));
            let sum = |name: &str| members().map(|member| number(member, name)).sum::<f64>();
            assert!((number(&said, "force_N") - force).abs() < 1e-6 * force, "{example}");
            assert!((sum("force_share_N") - force).abs() < 1e-6 * force, "{example}");
            assert!((sum("moment_share_N_m") - number(&said, "moment_N_m")).abs() < 1e-6 * force * 0.01, "{example}");
            let (fixed, free) = (number(&said, "axial_stiffness_N"), number(&said, "axial_stiffness_free_N"));
            assert!(fixed > free && free > 0.0, "{example}");
        }
    }
}

/// A swivel asks for no moment, and the strand unlays: a left-handed one turns right.
#[test]
fn a_swivel_lets_it_unlay() {
    let held = json(&["stiffness", "examples/strand-7-wire.toml"]);
    let swivel = json(&["stiffness", "examples/strand-7-wire.toml", "--moment", "0 N m"]);
    assert!(number(&held, "moment_N_m") < 0.0 && number(&held, "turning_rad_per_m").abs() < 1e-15);
    assert!(number(&swivel, "moment_N_m").abs() < 1e-9 && number(&swivel, "turning_rad_per_m") > 0.0);
    assert!(number(&swivel, "strain") > number(&held, "strain"));
}

/// The lay that is found for no torque gives none; the pretwist that is found holds straight wires in their lay.
#[test]
fn what_is_found_balances() {
    let file = "examples/spiral-strand-1x19.toml";
    let found = json(&["stiffness", file, "--torque-factor", "0", "--balanced-layer", "2"]);
    let lays = found["lay_lengths_for_torque_factor_m"].as_array().unwrap();
    for lay in lays {
        let lay = format!("{:?} m", lay.as_f64().unwrap());
        // flags of a layer are given for each; no load: about the lay as made
        let text = text_of(file).replace("\"110 mm\"", &format!("\"{lay}\""));
        let said = of_text(text.split("[load]").next().unwrap(), &[]);
        assert!(number(&said, "torque_factor").abs() < 1e-9, "{lay}");
    }
    // the other is no lay: the wires would be inside each other on the layer below, as `nply fit-check` has it
    let off = found["lay_lengths_that_do_not_fit_m"].as_array().unwrap();
    assert_eq!((lays.len(), off.len()), (1, 1));
    let gap = |lay: &Value| {
        let length = format!("{:?} m", lay.as_f64().unwrap());
        let said = json(&["fit-check", file, "--lay-length", "60 mm", "--lay-length", &length]);
        number(&said["layers"][1], "wire_gap_m")
    };
    assert!(gap(&lays[0]) > 0.0 && gap(&off[0]) < 0.0);
    let straight = ["stiffness", "examples/strand-7-wire.toml", "--preforming", "0", "--torque-factor", "0"];
    let pretwist = number(&json(&straight), "pretwist_for_no_moment_rad_per_m");
    let turns = format!("{pretwist:?} rad/m");
    let text = text_of("examples/strand-7-wire.toml");
    let text = text.split("[load]").next().unwrap();
    let said = of_text(text, &["--preforming", "0", "--wire-pretwist", &turns]);
    assert!(number(&said, "moment_N_m").abs() < 1e-9, "{said}");
}

/// A rope of Lang's lay turns harder under load than one of ordinary lay.
#[test]
fn langs_lay_turns_harder() {
    let text = text_of("examples/rope-6x7.toml");
    let factor = |text: &str| number(&of_text(text, &[]), "torque_factor");
    let (ordinary, lang) = (factor(&text), factor(&text.replace("hand = \"left\"", "hand = \"right\"")));
    assert!(lang > 1.2 * ordinary && ordinary > 0.0);
}

/// EA of the lay as made, by bare numbers, against ΣEA cos³θ: wires at small angles whose ends cannot turn.
#[test]
fn small_angles() {
    let said = json(&[
        "stiffness",
        "--core-diameter",
        "2.1",
        "--core-youngs-modulus",
        "1",
        "--core-poissons-ratio",
        "0",
        "--strands",
        "6",
        "--wire-diameter",
        "2",
        "--lay-length",
        "400",
        "--wire-youngs-modulus",
        "1",
        "--wire-poissons-ratio",
        "0",
    ]);
    let pi = std::f64::consts::PI;
    let cos = (2.0 * pi * 2.05_f64 / 400.0).atan().cos();
    let sum = pi * (1.05 * 1.05 + 6.0 * cos.powi(3));
    assert!((number(&said, "axial_stiffness") / sum - 1.0).abs() < 1e-6);
}

/// Refusals are sentences with their place, and their exit status.
/// The wires of a layer are `wires` in a file, and a flag that is not known gets no advice that leads nowhere.
#[test]
fn wires_are_called_wires() {
    let fit = |name: &str| {
        command::out(&[
            "fit-check",
            name,
            "6",
            "--core-diameter",
            "4.3",
            "--wire-diameter",
            "4.2",
            "--lay-length",
            "200",
        ])
    };
    assert_eq!(fit("--wires"), fit("--strands"));
    let unknown = call(&["solve", "--strands", "3", "--gamma", "0.75"]);
    assert!(unknown.code == 2 && unknown.err.contains("'--gamma'"), "{}", unknown.err);
    assert!(!unknown.err.contains("as a value"), "{}", unknown.err);
}

#[test]
fn refusals() {
    let text = "# a rope\n[core]\ndiameter = \"4 mm\"\n[[layer]]\nwires = 6\nwire_diameter = \"4 mm\"\nlay_length = \"200 mm\"\n";
    let answer = call_with(&["stiffness", "-"], text.as_bytes());
    assert!(answer.err.contains(":3:") && answer.err.contains("`youngs_modulus` in [core]"), "{}", answer.err);
    let strand = |more: &[&str]| {
        let given = [
            "stiffness",
            "--core-diameter",
            "4.3 mm",
            "--core-youngs-modulus",
            "200 GPa",
            "--core-poissons-ratio",
            "0.3",
            "--strands",
            "6",
            "--wire-diameter",
            "4.2 mm",
            "--wire-youngs-modulus",
            "200 GPa",
        ];
        call(&[&given[..], more].concat())
    };
    for (more, status, said) in [
        (&["--lay-length", "180 mm"][..], 2, "Poisson's ratio of the wires is missing"),
        (&["--lay-length", "180 mm", "--wire-poissons-ratio", "0.6"], 1, "at most 0.5"),
        (&["--lay-length", "20 mm", "--wire-poissons-ratio", "0.3"], 1, "flat rings"),
        (&["--lay-length", "180 mm", "--wire-poissons-ratio", "0.3", "--preforming", "1.5"], 1, "0 (straight) to 1"),
        (&["--lay-length", "180 mm", "--wire-poissons-ratio", "0.3", "--force", "1e9 kN"], 1, "near the lay as made"),
        (&["--lay-length", "180 mm", "--wire-poissons-ratio", "0.3", "--force", "5"], 2, "has no unit"),
        (
            &[
                "--lay-length",
                "180 mm",
                "--wire-poissons-ratio",
                "0.3",
                "--moment",
                "1 N m",
                "--turns-per-length",
                "1 turns/m",
            ],
            2,
            "give one of them",
        ),
        (&["--lay-length", "180 mm", "--wire-poissons-ratio", "0.3", "--balanced-layer", "1"], 2, "torque-factor"),
        (
            &[
                "--lay-length",
                "180 mm",
                "--wire-poissons-ratio",
                "0.3",
                "--torque-factor",
                "0",
                "--balanced-layer",
                "2",
            ],
            1,
            "counted from 1",
        ),
    ] {
        let run = strand(more);
        assert_eq!(run.code, status, "{more:?}: {}", run.err);
        assert!(run.err.contains(said), "{more:?}: {}", run.err);
    }
}

/// A core of fibre is no metal: section, modulus and breaking load of a rope are those of its wires; a name means the same in both reports.
#[test]
fn a_fibre_core_is_no_metal() {
    let pi = std::f64::consts::PI;
    let steel = 6.0 * 0.25 * pi * (1.30 * 1.30 + 6.0 * 1.25 * 1.25) * 1e-6;
    let rope = json(&["stiffness", "examples/rope-6x7.toml"]);
    assert!((number(&rope, "wire_section_area_m2") / steel - 1.0).abs() < 1e-12, "{rope}");
    let modulus = number(&rope, "axial_stiffness_N") / steel;
    assert!((number(&rope, "modulus_Pa") / modulus - 1.0).abs() < 1e-12);
    let fit = json(&["fit-check", "examples/rope-6x7.toml"]);
    for (file, fit) in [
        ("examples/rope-6x7.toml", &fit),
        ("examples/strand-7-wire.toml", &json(&["fit-check", "examples/strand-7-wire.toml"])),
    ] {
        let said = json(&["stiffness", file]);
        assert!((number(&said, "wire_section_area_m2") / number(fit, "wire_section_area_m2") - 1.0).abs() < 1e-12);
        assert!(said.get("metal_area_m2").is_none(), "{file}");
    }
    // and it cannot be of steel as well
    let both = call_with(&["stiffness", "examples/rope-6x7.toml", "--core-material", "steel"], b"");
    assert_eq!(both.code, 2, "{}", both.out);
    assert!(both.err.contains("contradict"), "{}", both.err);
}

/// What a soft core does not bear is said; a king wire bears it.
#[test]
fn a_core_that_gives_is_told_of() {
    let rope = call(&["stiffness", "examples/rope-6x7.toml"]).out;
    assert!(rope.contains("keep its round outline"), "{rope}");
    // 6 × 71.6 N/mm on a core of 2.1 mm: 32.6 MPa, of a modulus of 500 MPa
    let said = json(&["stiffness", "examples/rope-6x7.toml"]);
    let by_hand = 6.0 * number(&said["layers"][0], "pressure_below_N_per_m") / (std::f64::consts::TAU * 2.1e-3);
    assert!((number(&said["core"], "pressure_on_core_Pa") / by_hand - 1.0).abs() < 1e-6);
    assert!(rope.contains("32.5798 MPa") && rope.contains("6.51596 %"), "{rope}");
    assert!(!call(&["stiffness", "examples/strand-7-wire.toml"]).out.contains("keep its round outline"));
}

/// A rope's report speaks of strands; what it says of one, asked of the strand alone, strains it so.
#[test]
fn a_strand_of_a_rope_alone() {
    let text = call(&["stiffness", "examples/rope-6x7.toml"]).out;
    assert!(text.contains("strain of a strand") && !text.contains("strain of a wire"), "{text}");
    assert!(text.contains("In the strands of layer 1, 6 wires do not fit"), "{text}");
    let fit = call(&["fit-check", "examples/rope-6x7.toml"]).out;
    assert!(fit.contains("1 + 6 strands") && fit.contains("the strand is 3.80937 mm thick, not 3.8 mm"), "{fit}");
    let rope = json(&["stiffness", "examples/rope-6x7.toml"]);
    let one = &rope["layers"][0];
    let file = text_of("examples/rope-6x7.toml");
    let (_, strand) = file.split_once("[layer.strand.core]").unwrap();
    let strand =
        format!("[core]{}", strand.split("[load]").next().unwrap().replace("[[layer.strand.layer]]", "[[layer]]"));
    let (pull, turns) = (number(one, "wire_tension_N"), number(one, "wire_twist_rad_per_m"));
    let alone =
        of_text(&strand, &["--force", &format!("{pull:?} N"), "--turns-per-length", &format!("{turns:?} rad/m")]);
    // its wires are pulled as hard, and a little more where it is bent in the rope
    let most = |name: &str| f64::max(number(&alone["core"], name), number(&alone["layers"][0], name));
    let more = number(one, "stress_greatest_Pa") / most("stress_greatest_Pa") - 1.0;
    assert!(more > 0.0 && more < 0.03, "{more}");
    // to first order: a strand counts as it is free of load
    let (alone, in_rope) = (number(&alone, "strain"), number(one, "wire_strain"));
    assert!((alone - in_rope).abs() < 1e-3 * in_rope.abs(), "{alone} {in_rope}");
}

/// Strengths: the breaking load by hand, and the force at which the king wire, strained most, reaches its own.
#[test]
fn strength() {
    let file = "examples/strand-7-wire.toml";
    let strong = ["--wire-tensile-strength", "1860 MPa", "--core-tensile-strength", "1860 MPa"];
    let said = json(&[&["stiffness", file], &strong[..]].concat());
    let area = 0.25 * std::f64::consts::PI * (4.3 * 4.3 + 6.0 * 4.2 * 4.2) * 1e-6;
    assert!((number(&said, "metallic_breaking_load_N") / (1860e6 * area) - 1.0).abs() < 1e-12);
    let force = number(&said, "force_at_strength_N");
    assert!(force > 130e3 && force < 1860e6 * area);
    let force = format!("{force:?} N");
    let there = json(&[&["stiffness", file, "--force", &force], &strong[..]].concat());
    // of the outer wires, at their outer fibre: σ = E (strain + change of curvature × radius); the king wire is strained more, but pressed from all sides
    let outer = &there["layers"][0];
    let pull = 205e9 * number(outer, "wire_strain") + number(outer, "stress_bending_Pa");
    assert!((pull / 1860e6 - 1.0).abs() < 1e-9 && (number(outer, "strength_used") - 1.0).abs() < 1e-9, "{pull}");
    let king = number(&there["core"], "strength_used");
    assert!(king < 1.0 && number(&there, "strain") * 205e9 > 1860e6, "{king}");
    // past it, it is said; and of no wires whose strength is not known
    let past = call(&[&["stiffness", file, "--force", "190 kN"], &strong[..]].concat()).out;
    assert!(past.contains("Past its tensile strength: the core and layer 1"), "{past}");
    assert!(json(&["stiffness", file])["metallic_breaking_load_N"].is_null());
    // what no wire bears is said without any strength
    let wound = call(&["stiffness", file, "--preforming", "0"]).out;
    assert!(wound.contains("which no metal wire bears"), "{wound}");
}

/// Of ropes, and of strands on a strand, it is a wire within that first reaches its strength: there it uses all of it, and no other more.
#[test]
fn a_wire_of_a_strand_reaches_its_strength() {
    let rope = text_of("examples/rope-6x7.toml")
        .replace("poissons_ratio = 0.3", "poissons_ratio = 0.3\ntensile_strength = \"1770 MPa\"");
    let on_a_strand =
        "[[core.strand.layer]]\nwires = 6\nwire_diameter = \"2 mm\"\nlay_ratio = 14\nhand = \"left\"\nSTEEL\
        [core.strand.core]\ndiameter = \"2.1 mm\"\nSTEEL\
        [[layer]]\nwires = 12\nwire_diameter = \"2 mm\"\nlay_ratio = 12\nhand = \"right\"\nSTEEL"
            .replace("STEEL", "youngs_modulus = \"200 GPa\"\npoissons_ratio = 0.3\ntensile_strength = \"1770 MPa\"\n");
    for text in [rope.as_str(), &on_a_strand] {
        let force = number(&of_text(text, &[]), "force_at_strength_N");
        let there = of_text(text, &["--force", &format!("{force:?} N")]);
        let members = there["layers"].as_array().unwrap().iter().chain(std::iter::once(&there["core"]));
        let used = members.filter_map(|member| member["strength_used"].as_f64()).fold(0.0, f64::max);
        assert!((used - 1.0).abs() < 1e-9 && force < number(&there, "metallic_breaking_load_N"), "{used} at {force} N");
    }
    // one strength that is not known leaves it open
    let open = rope.replacen("tensile_strength = \"1770 MPa\"", "", 1);
    assert!(of_text(&open, &[])["force_at_strength_N"].is_null());
}

/// A core's stresses are those of its force: over its section along it, and with the pressure from the sides by von Mises, σz, −p, −p and a shear.
#[test]
fn stresses_of_a_core_are_those_of_its_force() {
    for (file, more) in [
        ("examples/strand-7-wire.toml", &[][..]),
        ("examples/strand-7-wire.toml", &["--moment", "0 N m"]),
        ("examples/spiral-strand-1x19.toml", &["--force", "30 kN"]),
        ("examples/rope-6x7.toml", &["--moment", "0 N m"]),
    ] {
        let said = json(&[&["stiffness", file], more].concat());
        let core = &said["core"];
        let along = number(core, "force_share_N") / number(core, "section_area_m2");
        assert!((number(core, "stress_greatest_Pa") / along - 1.0).abs() < 1e-12, "{file} {along}");
        let parts = number(core, "stress_stretch_Pa") + number(core, "stress_pressure_Pa");
        assert!((parts / along - 1.0).abs() < 1e-12, "{file} {parts}");
        let (sides, shear) = (number(core, "pressure_on_core_Pa"), number(core, "stress_twist_Pa"));
        let tensor = [[along, 0.0, shear], [0.0, -sides, 0.0], [shear, 0.0, -sides]];
        let mean = (tensor[0][0] + tensor[1][1] + tensor[2][2]) / 3.0;
        let deviator = |i: usize, j: usize| tensor[i][j] - if i == j { mean } else { 0.0 };
        let squares: f64 = (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).map(|(i, j)| deviator(i, j).powi(2)).sum();
        let by_hand = (1.5 * squares).sqrt();
        assert!((number(core, "stress_equivalent_Pa") / by_hand - 1.0).abs() < 1e-12, "{file} {by_hand}");
    }
    // 130 kN: 19.74 kN on 14.52 mm²
    let core = &json(&["stiffness", "examples/strand-7-wire.toml"])["core"];
    assert!((number(core, "stress_greatest_Pa") * 1e-6 - 1359.06).abs() < 0.01);
}

/// That no metal bears its stress is said of no fibre.
#[test]
fn a_fibre_core_is_no_metal_that_yields() {
    let said = call(&["stiffness", "examples/rope-6x7.toml", "--moment", "0 N m"]).out;
    assert!(!said.contains("no metal wire bears"), "{said}");
    // the same core, were it of metal
    let metal = text_of("examples/rope-6x7.toml").replace("fibre = true", "fibre = false");
    let said = call_with(&["stiffness", "-", "--moment", "0 N m"], metal.as_bytes()).out;
    assert!(said.contains("in the core, which no metal wire bears"), "{said}");
}

/// A wire turned back once a lay, against the hand, is left with no more twist than (1 − cos θ) turns a wire length of the lay: what writhe asks for.
#[test]
fn wires_that_are_turned_back() {
    let said = json(&[
        "stiffness",
        "examples/strand-7-wire.toml",
        "--force",
        "0",
        "--preforming",
        "0",
        "--wire-pretwist",
        "5.56192 turns/m",
    ]);
    let layer = &said["layers"][0];
    let cos = number(layer, "lay_angle_deg").to_radians().cos();
    let per_lay = number(layer, "wire_twist_rad_per_m") / std::f64::consts::TAU * 0.1778 / cos;
    assert!((per_lay - (1.0 - cos)).abs() < 2e-3 * (1.0 - cos) + 1e-4, "{per_lay} {}", 1.0 - cos);
}

/// Stresses are read beside the modulus that was given: in ksi beside Msi, in its own unit if that is none of SI, else in MPa.
#[test]
fn stresses_follow_the_unit_of_the_modulus() {
    let file = text_of("examples/strand-7-wire.toml");
    let stretch = |modulus: &str| {
        let said = call_with(&["stiffness", "-"], file.replace("205 GPa", modulus).as_bytes()).out;
        let row = said.lines().find(|line| line.starts_with("  from stretch")).unwrap().to_owned();
        let cells: Vec<&str> = row.split_whitespace().collect();
        (cells[2].to_owned(), cells[3].parse::<f64>().unwrap())
    };
    let (metric, mpa) = stretch("205 GPa");
    assert_eq!(metric, "MPa");
    // 1 psi is 6894.757 Pa, 1 kgf/mm² 9.80665 MPa
    for (modulus, unit, size) in [
        ("29.7327 Msi", "ksi", 6.894_757),
        ("29732.7 ksi", "ksi", 6.894_757),
        ("20904.2 kgf/mm^2", "kgf/mm^2", 9.80665),
    ] {
        let (said, value) = stretch(modulus);
        assert_eq!(said, unit);
        assert!((value * size / mpa - 1.0).abs() < 1e-5, "{modulus}: {value} {said}, {mpa} MPa");
    }
}

/// How many turns are too many is said as a number: one a lay length.
#[test]
fn too_many_turns_are_counted() {
    let refused = call(&["stiffness", "examples/strand-7-wire.toml", "--turns-per-length", "6 turns/m"]);
    assert_eq!(refused.code, 1, "{}", refused.out);
    assert!(refused.err.contains("straight at 5.6243 turns/m"), "{}", refused.err);
}
