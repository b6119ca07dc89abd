//! The examples' states, against numbers computed apart from this project's programs.
//!
//! How: units taken off by hand; contact by bisection of z − tan²θ sin z = π(1 − 2/n) with 40 digits, and ρ from the
//! squared distance (4) of the touching sections itself; the balance G of the design, with its ρ′ term for `contact` and
//! without it for `radial`, bisected between the signs on 1000 angles; everything in mpmath, 17 digits quoted.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::disallowed_methods, reason = "numbers to compare with go another way")]

mod command;

use std::fs;

use command::{json, near, number, out, root, states};
use serde_json::Value;

const TOLERANCE: f64 = 1e-10;

fn solved(name: &str) -> Value {
    json(&["solve", &format!("examples/{name}.toml"), "--json"])
}

/// The only state of an example.
fn state(name: &str) -> Value {
    let report = solved(name);
    let [state] = states(&report) else { panic!("{report}") };
    state.clone()
}

fn angles(report: &Value) -> Vec<(i64, f64)> {
    let pair = |state: &Value| (state["handedness"].as_i64().unwrap(), number(state, "helical_angle_deg"));
    states(report).iter().map(pair).collect()
}

#[track_caller]
fn same_angles(report: &Value, expected: &[(i64, f64)]) {
    let found = angles(report);
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for ((hand, angle), (expected_hand, expected)) in found.iter().zip(expected) {
        assert_eq!(hand, expected_hand);
        near(*angle, *expected, TOLERANCE);
    }
}

#[test]
fn every_example_is_answered_and_names_its_source() {
    let mut count = 0;
    for entry in fs::read_dir(root().join("examples")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            count += 1;
            let text = fs::read_to_string(&path).unwrap();
            let command = if text.contains("\n[[layer]]\n") { "fit-check" } else { "solve" };
            out(&[command, path.to_str().unwrap()]);
            let comment: String = text.lines().take_while(|line| line.starts_with('#')).collect();
            assert!(
                ["Source", "Journal", "Sci. Rep.", "BioNumbers"].iter().any(|word| comment.contains(word)),
                "{text}"
            );
        }
    }
    assert_eq!(count, 16, "an example without a test of its own");
}

/// Each example of a job is answered by the command it names, and says where its numbers are from.
#[test]
fn every_example_of_a_job_runs() {
    let mut count = 0;
    for entry in fs::read_dir(root().join("examples/jobs")).unwrap() {
        let text = fs::read_to_string(entry.unwrap().path()).unwrap();
        let comment: Vec<&str> = text.lines().map_while(|line| line.strip_prefix('#')).collect();
        assert!(comment.iter().any(|line| line.starts_with(" Source: ")), "{text}");
        let command = comment.iter().find_map(|line| line.trim().strip_prefix("nply ")).expect("its command");
        out(&command.split_whitespace().collect::<Vec<_>>());
        count += 1;
    }
    assert_eq!(count, 3, "an example that no chapter shows");
}

/// Lay of 8.5 nm, chain radius 0.2582 nm: 2πρ/tan θ = 8.5/0.2582.
#[test]
fn collagen() {
    let state = state("collagen");
    near(number(&state, "helical_angle_deg"), 12.505149050017749, TOLERANCE);
    near(number(&state, "radius_ratio"), 1.1620444020033935, TOLERANCE);
    near(number(&state, "pretwist"), -0.20720200960032044, TOLERANCE);
    assert_eq!(state["handedness"], 1);
    // published: a helix diameter 2R of 0.6 nm, drawn at an angle of 12 degrees
    assert!((number(&state["si"], "ply_radius") - 0.3e-9).abs() < 0.0005e-9);
    assert!((number(&state, "helical_angle_deg") - 12.5).abs() < 0.05);
}

/// C/B = 120/50, B = kT·50 nm = 2.05716701e-28 N m²; at 32° two strands touch along a line, ρ = 1.
#[test]
fn dna_supercoil() {
    let report = solved("dna-supercoil");
    let state = state("dna-supercoil");
    near(number(&report, "bending_stiffness_N_m2"), 2.05716701e-28, TOLERANCE);
    near(number(&state, "helical_angle_deg"), 32.0, TOLERANCE);
    near(number(&state, "pretwist"), -0.68929489716627708, TOLERANCE);
    near(number(&state, "strand_twist"), -0.23989787401669359, TOLERANCE);
    near(number(&state["si"], "resultant_pressure"), 0.037005512278135879, TOLERANCE);
    // published: strands 58 degrees from the plane across the axis
    assert!((number(&state, "pitch_angle_deg") - 58.0).abs() < 1e-9);
}

#[test]
fn rubber_rods() {
    same_angles(&solved("rubber-rods"), &[(1, 12.136929512816447), (1, 53.061596186357026), (-1, 46.200867655000041)]);
    let radial = json(&["solve", "examples/rubber-rods.toml", "--balance", "radial", "--json"]);
    same_angles(&radial, &[(1, 12.145354314060729), (-1, 71.509066730130764)]);
}

/// Pretwist 2π·470/m·0.1375 mm.
#[test]
fn three_ply_yarn() {
    let report = solved("three-ply-yarn");
    same_angles(&report, &[(1, 44.451155023262998), (-1, 20.581164503906438), (-1, 60.340843738863594)]);
    let lays = [0.0012135447871302422, 0.0027082427995467675, 0.00095210348415620722];
    for (state, lay) in states(&report).iter().zip(lays) {
        near(number(state, "pretwist"), 0.40605085047648078, TOLERANCE);
        near(number(&state["si"], "lay_length"), lay, TOLERANCE);
    }
    // the one that touches winds against its twist
    let touching: Vec<_> = states(&report).iter().filter(|state| state["separated"] == false).collect();
    assert!(touching.len() == 1 && touching[0]["lay"] == "S");
}

/// tan θ = 2π·460/m·0.1375 mm; two strands, line contact.
#[test]
fn tyre_cord() {
    let state = state("tyre-cord");
    near(number(&state, "helical_angle_deg"), 21.673440469766607, TOLERANCE);
    near(number(&state, "pretwist"), 0.51486330295918663, TOLERANCE);
    near(number(&state["si"], "pretwist_per_length"), 595.94937950963356, TOLERANCE);
    assert_eq!(state["lay"], "S");
    // as sold: 460 turns/m of cord, gauge 0.55 mm
    assert!((number(&state, "helical_angle_deg") - 21.67).abs() < 0.005);
    near(number(&state["si"], "turns_per_ply_length"), 460.0, TOLERANCE);
    near(number(&state["si"], "outer_diameter"), 0.55e-3, TOLERANCE);
}

/// ρ = 1 + 3.94/3.73, B = πEr⁴/4 = 1.7863356897154717 N m², f = 40 kN·r²/B = 0.077885137043956462.
#[test]
fn wire_strand_on_core() {
    let state = state("wire-strand-on-core");
    near(number(&state, "helical_angle_deg"), 15.296255548875007, TOLERANCE);
    near(number(&state, "force"), 0.077885137043956462, TOLERANCE);
    near(number(&state, "moment"), 0.6606518079738406, TOLERANCE);
    near(number(&state["si"], "moment"), 632.78600700199673, TOLERANCE);
    near(number(&state["si"], "lay_length"), 0.088102820286920201, TOLERANCE);
    // tested: lay angles from 9.2 to 17.0 degrees, on this core
    assert!((9.2..17.0).contains(&number(&state, "helical_angle_deg")));
    near(number(&state["si"], "hole_radius"), 1.97e-3, TOLERANCE);
}

/// What the ends of the birdcage hold: r·rad of turns per wire length, ρ on the king wire, f = −3 kN·r²/B.
struct Birdcage {
    turns: f64,
    on_core: f64,
    force: f64,
}

const BIRDCAGE: Birdcage = {
    const RADIUS: f64 = 1.5e-3;
    let stiffness = std::f64::consts::PI * 200e9 * (RADIUS * RADIUS) * (RADIUS * RADIUS) / 4.0;
    Birdcage {
        turns: std::f64::consts::TAU * 0.7 * RADIUS / 0.1,
        on_core: 1.0 + 3.15 / 3.0,
        force: -3000.0 * RADIUS * RADIUS / stiffness,
    }
};

impl Birdcage {
    /// Energy of one of the six wires, bent but not twisted, as a helix of given angle and ρ, the ply under a moment.
    fn energy(&self, angle: f64, rho: f64, moment: f64) -> f64 {
        let (s, c) = angle.sin_cos();
        let curvature = s * s / rho;
        let loads = self.force * c + moment * s / rho;
        0.5 * curvature * curvature - loads / 6.0
    }

    /// ρ of six touching helices, by a search for the nearest point of a neighbour.
    fn touching(angle: f64) -> f64 {
        let distance = |azimuth: f64| {
            let across = 2.0 - 2.0 * (azimuth + std::f64::consts::TAU / 6.0).cos();
            across + (azimuth / angle.tan()).powi(2)
        };
        let (mut low, mut high) = (-std::f64::consts::TAU / 6.0, 0.0);
        for _ in 0..200 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if distance(a) < distance(b) { high = b } else { low = a }
        }
        2.0 / distance(low).sqrt()
    }
}

/// Where a function that changes its sign does so.
fn crossing(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let negative = f(low) < 0.0;
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if (f(middle) < 0.0) == negative { low = middle } else { high = middle }
    }
    low
}

/// On the king wire, on the verge of a birdcage, and a birdcage whose wires touch: by the energy alone, and by a search.
#[test]
fn birdcage() {
    let report = solved("birdcage");
    let [on_core, free, touching] = states(&report) else { panic!("{report}") };
    let names: Vec<_> = states(&report).iter().map(|state| state["support"].as_str().unwrap()).collect();
    assert_eq!(names, ["core", "none", "neighbours"]);
    let strand = BIRDCAGE;
    for state in states(&report) {
        near(number(state, "rotation"), strand.turns, TOLERANCE);
        near(number(state, "force"), strand.force, TOLERANCE);
    }
    // on the king wire the turns fix the angle, energy is at rest there, and rises outwards by what the core presses
    let (angle, rho, h) = (number(on_core, "helical_angle"), strand.on_core, 1e-5);
    near(angle.sin(), strand.turns * rho, TOLERANCE);
    let energy = |angle: f64, rho: f64| strand.energy(angle, rho, number(on_core, "moment"));
    assert!((energy(angle + h, rho) - energy(angle - h, rho)).abs() < 1e-10 * 2.0 * h);
    let outward = (energy(angle, rho + h) - energy(angle, rho - h)) / (2.0 * h);
    assert!((number(on_core, "core_pressure") - outward).abs() < 1e-10 && outward > 1e-5, "{outward}");
    near(number(on_core, "neighbour_gap"), 2.0 * (rho / Birdcage::touching(angle) - 1.0), 1e-7);
    // with the turns held a free helix has one angle left; its energy is greatest where nothing has to hold it
    let alone = |angle: f64| strand.energy(angle, angle.sin() / strand.turns, 0.0);
    let slope = |angle: f64| alone(angle + 1e-4) - alone(angle - 1e-4);
    let verge = crossing(0.3, 1.5, slope);
    assert!(slope(verge - 0.1) > 0.0 && slope(verge + 0.1) < 0.0);
    assert!((number(free, "helical_angle") - verge).abs() < 1e-7, "{verge}");
    assert_eq!(free["stability_by_holding"]["rotation_held"], "unstable");
    near(number(free, "core_gap"), verge.sin() / strand.turns - rho, 1e-6);
    // beyond it the wires swing out until they touch each other
    let flat = crossing(1.0, 1.5, |angle| angle.sin() / Birdcage::touching(angle) - strand.turns);
    assert!((number(touching, "helical_angle") - flat).abs() < 1e-8, "{flat}");
    // the thrust that lifts the wires off their king wire: nothing presses outwards or inwards there, n y² cos θ in B/r²
    let lift_off = 6.0 * strand.turns * strand.turns * angle.cos() * 3.0 / -strand.force;
    for (share, holds) in [(0.999, true), (1.001, false)] {
        let thrust = format!("{} kN", -share * lift_off);
        let pushed = json(&["solve", "examples/birdcage.toml", "--force", &thrust, "--json"]);
        assert_eq!(states(&pushed).iter().any(|state| state["support"] == "core"), holds, "{thrust}");
    }
}

/// The events of a path: leg, name, station.
fn events(report: &Value) -> Vec<(usize, String, Value)> {
    let legs = report["legs"].as_array().unwrap().iter().enumerate();
    legs.flat_map(|(leg, content)| {
        content["events"]
            .as_array()
            .unwrap()
            .iter()
            .map(move |event| (leg + 1, event["event"].as_str().unwrap().to_owned(), event["station"].clone()))
    })
    .collect()
}

/// The event of a leg with a name, the first of them.
#[track_caller]
fn event(report: &Value, leg: usize, name: &str) -> Value {
    let all = events(report);
    let found = all.iter().find(|(of, called, _)| (*of, called.as_str()) == (leg, name));
    found.unwrap_or_else(|| panic!("no {name} on leg {leg}: {all:?}")).2.clone()
}

/// Pulled, turned through straight past 45 degrees, and let go: from the balanced ply below to the one above, of which `nply solve`
/// knows nothing of the way.
#[track_caller]
fn manoeuvre(name: &str, balance: &str, kept: bool) -> Value {
    let file = format!("examples/{name}.toml");
    let mut arguments = vec!["trace", &file, "--json"];
    if kept {
        arguments.push("--kept");
    }
    let report = json(&arguments);
    let rods = |force: &str, moment: &str| {
        let loads = ["--force", force, "--moment", moment, "--balance", balance, "--json"];
        json(&[&["solve", "--strands", "3", "--stiffness-ratio", "0.75", "--pretwist", "-0.2"][..], &loads].concat())
    };
    let balanced = rods("0", "0");
    let of_hand = |hand: i64| states(&balanced).iter().find(|state| state["handedness"] == hand).unwrap().clone();
    let (low, high) = (of_hand(1), of_hand(-1));
    assert!(number(&low, "helical_angle_deg") < 45.0 && number(&high, "helical_angle_deg") > 45.0);
    let start = &report["legs"][0]["stations"][0];
    near(number(start, "helical_angle_deg"), number(&low, "helical_angle_deg"), TOLERANCE);
    // straight where the ends take the whole twist: n γ times the pretwist
    let straight = event(&report, 2, "straight");
    near(number(&straight, "moment"), 3.0 * 0.75 * -0.2, 1e-9);
    assert!(number(&straight, "helical_angle_deg") < 1e-6);
    near(number(&event(&report, 2, "diagonal"), "helical_angle_deg"), 45.0, 1e-12);
    // at the angle of the goal, pressing
    let top = event(&report, 2, "arrival");
    near(number(&top, "helical_angle_deg"), number(&high, "helical_angle_deg"), TOLERANCE);
    assert!(top["handedness"] == -1 && number(&top, "interstrand_pressure") > 0.5);
    // and, if neighbours are kept together, still at that angle without loads
    if kept || balance == "radial" {
        let end = event(&report, 3, "arrival");
        near(number(&end, "helical_angle_deg"), number(&high, "helical_angle_deg"), TOLERANCE);
        near(number(&end, "interstrand_pressure"), number(&high, "interstrand_pressure"), 1e-9);
        let parting = event(&report, 3, "separation");
        let [force, moment] = ["force", "moment"].map(|load| number(&parting, load).to_string());
        let there = rods(&force, &moment);
        let away = |state: &Value| (number(state, "helical_angle_deg") - number(&parting, "helical_angle_deg")).abs();
        let state = states(&there).iter().find(|state| state["handedness"] == -1 && away(state) < 1e-8).unwrap();
        assert!(number(state, "resultant_pressure").abs() < 1e-12, "{state}");
        near(number(&parting, "moment") / number(&parting, "force"), number(&top, "moment") / 0.5, 1e-12);
    }
    report
}

#[test]
fn manoeuvre_radial() {
    manoeuvre("manoeuvre-radial", "radial", false);
}

#[test]
fn manoeuvre_contact() {
    let kept = manoeuvre("manoeuvre-contact", "contact", true);
    // contacts that only push open where the kept ones would begin to pull
    let pushing = manoeuvre("manoeuvre-contact", "contact", false);
    let opening = event(&pushing, 3, "contact_change");
    near(number(&opening, "along"), number(&event(&kept, 3, "separation"), "along"), 1e-9);
    near(number(&opening, "moment"), number(&event(&kept, 3, "separation"), "moment"), 1e-9);
    let first = &pushing["legs"][2]["events"][0];
    assert!(first["event"] == "contact_change" && !first["jump"].as_array().unwrap().is_empty(), "{first}");
    assert_ne!(pushing["legs"][2]["end"], "arrival");
}

/// Straight as long as the clamps hold n γ times the pretwist, then coiling up to what a simulation found.
#[test]
fn letting_go() {
    let report = json(&["trace", "examples/letting-go.toml", "--json"]);
    let legs = report["legs"].as_array().unwrap();
    for leg in &legs[..2] {
        let stations = leg["stations"].as_array().unwrap();
        assert!(stations.iter().all(|station| number(station, "helical_angle_deg") < 1e-6));
        // without a pull nothing of second order keeps straight strands where they are
        let verdict = |station: &Value| if number(station, "force") > 0.0 { "stable" } else { "marginal" };
        assert!(stations.iter().all(|station| station["stability"] == verdict(station)));
    }
    let end = event(&report, 3, "arrival");
    assert!((number(&end, "helical_angle_deg") - 30.6130).abs() < 5e-5, "simulated: 30.6130 degrees");
    assert!(end["handedness"] == 1 && end["stability"] == "stable");
    let balanced = json(&["solve", "--strands", "3", "--stiffness-ratio", "0.75", "--pretwist", "-1", "--json"]);
    near(number(&end, "helical_angle_deg"), number(&states(&balanced)[0], "helical_angle_deg"), TOLERANCE);
}

/// A pulled strand whose ends cannot turn, by balances that need none of its theory: its wires' tensions and its core's make up its force,
/// a taut wire presses on the core with tension times curvature, and what it answers between two forces is its stiffness.
#[test]
fn steel_strand_pulled() {
    let at = |force: &str| {
        let report = json(&["support", "examples/steel-strand-pulled.toml", "--force", force, "--json"]);
        let [state] = states(&report) else { panic!("{report}") };
        state.clone()
    };
    let (state, pulled) = (at("100 kN"), at("101 kN"));
    let (si, more) = (&state["si"], &pulled["si"]);
    let (strain, angle) = (number(&state, "strain"), number(&state, "helical_angle_deg").to_radians());
    let tension = 200e9 * std::f64::consts::PI * 2.1e-3 * 2.1e-3 * strain;
    // what presses from the sides stretches by Poisson's ratio, and that part of the stretch pulls with nothing; in the core's force it is
    // left out already
    let squeeze = 0.3 * number(si, "core_pressure");
    let pulls = 6.0 * (tension - squeeze * 2.1e-3) * angle.cos() + number(si, "core_force");
    near(pulls, 100e3, 3e-4);
    let curvature = angle.sin().powi(2) / (number(&state, "radius_ratio") * 2.1e-3);
    // per unstretched length
    near(number(si, "core_pressure") / ((1.0 + strain) * (tension - squeeze * 2.1e-3) * curvature), 1.0, 2e-3);
    let strained = number(&pulled, "extension") / number(&state, "extension") - 1.0;
    near(1e3 / strained, number(si, "axial_stiffness"), 1e-3);
    let torque = (number(more, "moment") - number(si, "moment")) / 1e3;
    near(torque / number(si, "outer_diameter"), number(&state, "torque_factor"), 1e-3);
    // nominal of seven-wire prestressing strand: 195 GPa (EN 1992-1-1, 3.3.6)
    assert!((number(si, "modulus") / 195e9 - 1.0).abs() < 0.01);
    assert_eq!(state["support"], "core");
}

/// The same let go and pushed: wholly preformed wires lift off the king wire where nothing loads the strand, in the lay in which it was made.
#[test]
fn steel_strand_pushed() {
    let report = json(&["trace", "examples/steel-strand-pulled.toml", "--to-force", "-10 kN", "--json"]);
    let leg = &report["legs"][0];
    let events = leg["events"].as_array().unwrap();
    let opens = &events.iter().find(|event| event["event"] == "contact_change").unwrap()["station"];
    // the turns are given to six digits
    assert!(number(&opens["si"], "force").abs() < 1.0 && number(&opens["si"], "moment").abs() < 1e-2, "{opens}");
    let made = (std::f64::consts::TAU * 4.25 / 190.0_f64).atan();
    near(number(opens, "extension"), made.cos(), 1e-6);
    let last = &leg["stations"].as_array().unwrap().last().unwrap();
    assert!(leg["end"] == "arrival" && last["support"] == "none" && number(last, "core_gap") > 0.0, "{last}");
}
