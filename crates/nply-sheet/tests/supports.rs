//! Ends that are held and what carries the strands: each rule once, and the report's own claims against the theory.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

use core::f64::consts::TAU;

use nply::mechanics::{Ends, Load, Ply, Support, Twist};
use nply_sheet::{Case, ErrorKind, Place, Question, Report, Spec, SpecError};
use serde_json::Value;

type Flags<'f> = &'f [(&'f str, &'f str)];

/// Three strands of r = 2 mm, B = 1 N mm², L = 250 r, with more flags.
fn measured(more: Flags) -> Result<Case, SpecError> {
    let base = [
        ("strands", "3"),
        ("radius", "2 mm"),
        ("bending-stiffness", "1 N mm^2"),
        ("stiffness-ratio", "0.75"),
        ("strand-length", "0.5 m"),
        ("pretwist", "-0.2"),
    ];
    Spec::from_flags(base.iter().chain(more).copied())?.check()
}

/// The same, dimensionless and without a length.
fn bare(more: Flags) -> Result<Case, SpecError> {
    let base = [("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2")];
    Spec::from_flags(base.iter().chain(more).copied())?.check()
}

fn held(case: Result<Case, SpecError>) -> Ends {
    match case.unwrap().question {
        Question::Held { twist: Twist::Pretwist(_), ends } => ends,
        other => panic!("{other:?}"),
    }
}

fn supports(flags: Flags) -> Value {
    let case = Spec::from_flags(flags.iter().copied()).unwrap().check_supports().unwrap();
    serde_json::from_str(&Report::of(case).unwrap().json()).unwrap()
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-14 * b.abs(), "{a} is not {b}");
}

#[test]
fn the_ends_by_each_of_their_data() {
    let rotation = |case| match held(case) {
        Ends::Rotation { rotation, force } => (rotation, force),
        other => panic!("{other:?}"),
    };
    near(rotation(measured(&[("ply-rotation", "1800 deg")])).0, 5.0 * TAU / 250.0);
    near(rotation(measured(&[("ply-turns", "5")])).0, 5.0 * TAU / 250.0);
    near(rotation(measured(&[("ply-turns", "-5 turns")])).0, -5.0 * TAU / 250.0);
    near(rotation(measured(&[("ply-turns-per-strand-length", "10 turns/m")])).0, 5.0 * TAU / 250.0);
    near(rotation(bare(&[("ply-turns-per-strand-length", "0.02")])).0, 5.0 * TAU / 250.0);
    near(rotation(measured(&[("ply-turns", "5"), ("force", "0.5 N")])).1, 2.0);
    let length = |case| match held(case) {
        Ends::Length { extension, moment } => (extension, moment),
        other => panic!("{other:?}"),
    };
    near(length(measured(&[("ply-length", "450 mm")])).0, 0.9);
    near(length(bare(&[("ply-length", "90"), ("strand-length", "100")])).0, 0.9);
    assert!(length(bare(&[("length-ratio", "0.9"), ("moment", "-0.1")])) == (0.9, -0.1));
}

#[test]
fn a_core_by_radius_or_diameter() {
    let core = |flags| match measured(flags).unwrap().question {
        Question::Supported { ends: Ends::Loads(load), core_radius, .. } => {
            assert_eq!(load, Load::NONE);
            core_radius.unwrap()
        }
        other => panic!("{other:?}"),
    };
    near(core(&[("support-core-radius", "3 mm")]), 1.5);
    near(core(&[("support-core-diameter", "3 mm")]), 0.75);
    let case = measured(&[("support-core-radius", "3 mm"), ("ply-turns", "5")]).unwrap();
    assert!(matches!(case.question, Question::Supported { ends: Ends::Rotation { .. }, .. }));
    // asked without a core
    let spec = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "1"), ("pretwist", "-1")]).unwrap();
    assert!(matches!(spec.check().unwrap().question, Question::States { .. }));
    assert!(matches!(spec.check_supports().unwrap().question, Question::Supported { core_radius: None, .. }));
}

/// What a person is told to be the most, taken at their word, is taken.
#[test]
fn the_most_turns_that_are_named_can_be_taken() {
    for flag in ["ply-turns", "ply-turns-per-strand-length", "ply-rotation"] {
        for (unit, start) in [("", "1e6"), (" turns", "1e6"), (" turns/m", "1e6"), (" deg", "1e9"), (" rad", "-1e8")] {
            let Ok(case) = measured(&[(flag, &format!("{start}{unit}"))]) else { continue };
            let error = case.locate(&case.solve().unwrap_err());
            assert_eq!((error.kind(), error.place()), (ErrorKind::Domain, &Place::Flag(flag.to_owned())));
            let said = error.to_string();
            let most = said.split(" can take is ").nth(1).expect(&said).trim_end_matches(", either way");
            let most = if unit.is_empty() { most.split(' ').next().unwrap() } else { most };
            assert!(measured(&[(flag, most)]).unwrap().solve().is_ok(), "{said}");
            let number: f64 = most.split(' ').next().unwrap().parse().unwrap();
            let more = format!("{}{unit}", number * 1.00002);
            assert!(measured(&[(flag, &more)]).unwrap().solve().is_err(), "{more}");
        }
    }
}

#[test]
fn what_no_ends_can_hold_is_said_in_the_words_of_the_input() {
    for (flag, value, why) in [
        ("length-ratio", "1", "a ply is shorter than its strands"),
        ("ply-length", "600 mm", "a ply is shorter than its strands"),
        ("length-ratio", "1e-200", "a ply of no length is none"),
        ("ply-turns", "0", "strands without turns lie straight"),
        ("ply-rotation", "-1e6 deg", "touching strands cannot take so many turns"),
    ] {
        let case = measured(&[(flag, value)]).unwrap();
        let error = case.locate(&case.solve().unwrap_err());
        assert_eq!(error.place(), &Place::Flag(flag.to_owned()));
        assert!(error.to_string().starts_with(&format!("`--{flag} \"{value}\"`: {why}")), "{error}");
    }
}

/// A core larger than the hole of the ply that would open is in the way: the neighbours do not part there.
#[test]
fn a_ply_opens_only_where_it_is_clear_of_the_core() {
    let flags = [("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2"), ("force", "-0.05")];
    let radii = |more: Option<(&'static str, &'static str)>| -> Vec<f64> {
        let report = supports(&flags.into_iter().chain(more).collect::<Vec<_>>());
        let openings = report["openings"].as_array().unwrap();
        let parting = openings.iter().filter(|one| one["lets_go"] == "neighbours");
        parting.map(|one| one["radius_ratio"].as_f64().unwrap()).collect()
    };
    let all = radii(None);
    let clear = radii(Some(("support-core-radius", "0.3")));
    assert!(clear.len() < all.len() && !clear.is_empty());
    let expected: Vec<f64> = all.into_iter().filter(|radius| *radius >= 1.3).collect();
    assert_eq!(clear, expected);
}

/// A touching ply opens, and an opened one closes, under the same loads: those of p = 0.
#[test]
fn what_opens_closes_at_the_same_loads() {
    let ply = Ply::new(3, 0.75).unwrap();
    let flags =
        [("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2"), ("force", "-0.05"), ("moment", "0.2")];
    let report = supports(&flags);
    let openings = report["openings"].as_array().unwrap();
    assert!(openings.iter().any(|one| one["kept"] == "force") && openings.iter().any(|one| one["kept"] == "moment"));
    for opening in openings {
        let number = |key: &str| opening[key].as_f64().unwrap();
        let kept = if opening["kept"] == "force" { ("force", -0.05) } else { ("moment", 0.2) };
        assert!((number(kept.0) - kept.1).abs() < 1e-15);
        let at = |more: f64| {
            let load = Load { force: number("force"), moment: number("moment") + more };
            let states = ply.supported_states(Twist::Pretwist(-0.2), load, None).unwrap();
            let close = |angle: f64| (angle - number("helical_angle_deg")).abs() < 0.1;
            states.into_iter().filter(move |state| close(state.angle().degrees()))
        };
        // near these loads, on one side or on both, neighbours press a little, and strands stand a little apart
        let (mut pressing, mut apart) = (0, 0);
        for state in at(1e-7).chain(at(-1e-7)) {
            let (gap, pressure) = (state.neighbour_gap(), state.interstrand_pressure());
            match state.support() {
                Support::Neighbours => {
                    assert!(pressure > 0.0 && pressure < 1e-5, "{pressure}");
                    pressing += 1;
                }
                Support::Free => {
                    assert!(gap > 0.0 && gap < 1e-4, "{gap}");
                    apart += 1;
                }
                other => panic!("{other:?} {opening}"),
            }
        }
        assert_eq!((pressing, apart), (1, 1), "{opening}");
    }
}

/// Inside the wedge both carry; across one edge the neighbours part, across the other the core comes loose.
#[test]
fn a_wedge_is_where_both_carry() {
    let base = [("strands", "6"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2"), ("support-core-radius", "1.1")];
    let report = supports(&base);
    let ply = Ply::new(6, 0.75).unwrap();
    let wedges = report["wedges"].as_array().unwrap();
    assert_eq!(wedges.len(), 2);
    for wedge in wedges {
        let pair = |name: &str| ["force", "moment"].map(|load| wedge[format!("{name}_{load}")].as_f64().unwrap());
        let (tip, neighbours, core) = (pair("tip"), pair("neighbours_just_touch"), pair("core_just_touches"));
        let supports = |a: f64, b: f64| -> Vec<Support> {
            let [force, moment] = [0, 1].map(|i| tip[i] + a * neighbours[i] + b * core[i]);
            let states = ply.supported_states(Twist::Pretwist(-0.2), Load { force, moment }, Some(1.1)).unwrap();
            let is_right = wedge["handedness"] == 1;
            states
                .iter()
                .filter(|state| (state.handedness().sign() > 0.0) == is_right)
                .map(|state| state.support())
                .collect()
        };
        assert!(supports(0.5, 0.5).contains(&Support::Both));
        assert!(!supports(0.5, -0.01).contains(&Support::Both) && supports(0.5, -0.01).contains(&Support::Core));
        assert!(!supports(-0.01, 0.5).contains(&Support::Both) && supports(-0.01, 0.5).contains(&Support::Neighbours));
    }
}

/// The table, JSON and CSV say the same, each load in its place.
#[test]
fn one_list_of_names_for_all() {
    let flags = [
        ("strands", "6"),
        ("stiffness-ratio", "0.75"),
        ("pretwist", "-0.2"),
        ("support-core-radius", "2.2 mm"),
        ("radius", "2 mm"),
    ];
    let spec = Spec::from_flags(flags.iter().copied().chain([("force", "8.7"), ("moment", "7.1")])).unwrap();
    let report = Report::of(spec.check().unwrap()).unwrap();
    let json: Value = serde_json::from_str(&report.json()).unwrap();
    let csv = report.csv();
    let mut lines = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = lines.next().unwrap();
    let states = json["states"].as_array().unwrap();
    assert_eq!(states.len(), report.solution.supported.as_ref().unwrap().states.len());
    for (row, state) in lines.zip(states) {
        for (name, cell) in head.iter().zip(&row) {
            let value = match name.strip_suffix("_m") {
                Some(plain) => &state["si"][plain],
                None => &state[*name],
            };
            if let Some(number) = value.as_f64() {
                // JSON is read here to a unit in the last place
                near(cell.parse().unwrap(), number);
            }
        }
        assert_eq!(row.len(), head.len());
    }
    assert!(states.iter().any(|state| state["support"] == "both"));
    let text = report.text(false);
    assert!(text.contains("core radius 2.2 mm") && text.contains("both") && !text.contains("NaN"), "{text}");
}

/// Euler's load π²B_ply/ℓ² with B_ply = nB cos θ/(1 + ½ sin²θ (1/γ − 1)), on either side of the length at which it is the thrust.
#[test]
fn a_ply_that_may_buckle_as_a_whole_is_pointed_out() {
    let flags = [("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2"), ("force", "-0.05")];
    let report = supports(&flags);
    let cosine = report["states"][0]["extension"].as_f64().unwrap();
    let stiffness = 3.0 * cosine / (1.0 + 0.5 * (1.0 - cosine * cosine) * (1.0 / 0.75 - 1.0));
    let critical = core::f64::consts::PI * (stiffness / 0.05).sqrt() / cosine;
    for (share, warns) in [(0.999, false), (1.001, true)] {
        let length = format!("{}", share * critical);
        let report = supports(&flags.into_iter().chain([("strand-length", length.as_str())]).collect::<Vec<_>>());
        let notes = report["notes"].as_array().unwrap();
        let said = notes.iter().any(|note| note.as_str().unwrap().starts_with("In state 1 the ply may buckle"));
        assert_eq!(said, warns, "{length}: {notes:?}");
    }
}
