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
    assert_eq!(lays.len(), 2);
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
