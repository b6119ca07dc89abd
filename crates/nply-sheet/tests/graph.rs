//! Curves of a graph against the solver: every state is on one, and nothing else is.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::disallowed_methods)]

use nply::Handedness;
use nply::mechanics::{Balance, Load, Ply, Twist};
use nply_sheet::graph::{Graph, GraphCurve, GraphFlags, Scales};
use nply_sheet::{KEYS, Spec};

fn ply(flags: &[(&str, &str)]) -> Spec {
    Spec::from_flags(flags.iter().copied()).unwrap()
}

/// The same as a file has it: what runs may take its place.
fn written(flags: &[(&str, &str)]) -> Spec {
    let line = |(flag, value): &(&str, &str)| {
        let key = KEYS.iter().find(|key| key.flag == *flag).unwrap();
        format!("{}.{} = {value:?}\n", key.table.name(), key.name)
    };
    Spec::from_toml("ply.toml", &flags.iter().map(line).collect::<String>()).unwrap()
}

fn graph(ply: &Spec, range: &str, ask: &[&str]) -> Graph {
    let ask = ask.iter().map(|&name| name.to_owned()).collect();
    ply.check_graph(&GraphFlags { sweep: range.to_owned(), ask, ..GraphFlags::default() }).unwrap()
}

/// The angles at which curves of a hand pass a value, in degrees, rising.
fn angles_at(curves: &[GraphCurve], hand: Handedness, at: f64) -> Vec<f64> {
    let mut found = Vec::new();
    for curve in curves.iter().filter(|curve| curve.handedness == hand) {
        for pair in curve.points.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            if (a.x <= at) != (b.x <= at) {
                let angle = |p: &nply_sheet::graph::GraphPoint| p.state.contact().angle().degrees();
                found.push(angle(&a) + (angle(&b) - angle(&a)) * (at - a.x) / (b.x - a.x));
            }
        }
    }
    found.sort_by(f64::total_cmp);
    found
}

/// At any value the curves pass the angles that the solver finds, no more and no fewer: over folds, poles and for both balances.
#[test]
fn curves_hold_every_state_and_no_other() {
    type Solve = fn(&Ply, f64) -> Vec<nply::mechanics::Equilibrium>;
    let courses: [(&str, Solve); 4] = [
        ("pretwist=-3..3", |ply, x| ply.equilibria(Twist::Pretwist(x), Load { force: 0.3, moment: 0.4 }).unwrap()),
        ("load.force=-2..2", |ply, x| ply.equilibria(Twist::Pretwist(-0.7), Load { force: x, moment: 0.4 }).unwrap()),
        ("moment=-4..4", |ply, x| ply.equilibria(Twist::Pretwist(-0.7), Load { force: 0.3, moment: x }).unwrap()),
        ("stiffness_ratio=0.1..3", |ply, x| {
            let ply = Ply::with_balance(ply.strands(), x, ply.balance()).unwrap();
            ply.equilibria(Twist::Pretwist(-0.7), Load { force: 0.3, moment: 0.4 }).unwrap()
        }),
    ];
    for balance in Balance::BOTH {
        for strands in [2_u32, 3, 6] {
            let solver = Ply::with_balance(strands, 0.75, balance).unwrap();
            let number = strands.to_string();
            for (range, solve) in courses {
                let spec = written(&[
                    ("strands", &number),
                    ("balance", balance.name()),
                    ("stiffness-ratio", "0.75"),
                    ("pretwist", "-0.7"),
                    ("force", "0.3"),
                    ("moment", "0.4"),
                ]);
                let curves = graph(&spec, range, &["helical_angle", "interstrand_pressure"]).curves();
                let (low, high) = range.split_once('=').unwrap().1.split_once("..").unwrap();
                let (low, high): (f64, f64) = (low.parse().unwrap(), high.parse().unwrap());
                for i in 1..30 {
                    let x = low + (high - low) * (f64::from(i) + 0.137) / 30.0;
                    let states = solve(&solver, x);
                    for hand in Handedness::BOTH {
                        let wanted: Vec<f64> = states
                            .iter()
                            .filter(|s| s.handedness() == hand)
                            .map(|s| s.contact().angle().degrees())
                            .collect();
                        let found = angles_at(&curves, hand, x);
                        assert_eq!(
                            found.len(),
                            wanted.len(),
                            "{range} at {x}, n = {strands}, {balance:?}: {found:?} {wanted:?}"
                        );
                        for (found, wanted) in found.iter().zip(&wanted) {
                            assert!((found - wanted).abs() < 0.1, "{range} at {x}: {found} {wanted}");
                        }
                    }
                }
                for curve in &curves {
                    for point in &curve.points {
                        // of flat rings every term grows without bound
                        let flat = point.state.contact().pitch_angle() < 0.05;
                        assert!(flat || point.state.balance_residual().abs() < 1e-9, "{range} {point:?}");
                        assert!((low..=high).contains(&point.x), "{range} {}", point.x);
                    }
                }
            }
        }
    }
}

/// Curves part where p₁ vanishes, and both parts reach that point.
#[test]
fn dashes_begin_where_neighbours_stop_pressing() {
    let spec = ply(&[("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.5")]);
    let curves = graph(&spec, "force=-1..1", &["helical_angle"]).curves();
    let solver = Ply::new(3, 0.75).unwrap();
    let mut met = 0;
    for curve in &curves {
        for point in &curve.points {
            let pressure = point.state.interstrand_pressure();
            assert!(if curve.separated { pressure < 1e-9 } else { pressure > -1e-9 }, "{pressure}");
        }
    }
    for pressing in curves.iter().filter(|curve| !curve.separated) {
        for end in [pressing.points[0], pressing.points[pressing.points.len() - 1]] {
            if end.state.interstrand_pressure().abs() < 1e-9 {
                let verge = solver.separation_at_moment(Twist::Pretwist(-0.5), 0.0).unwrap();
                let same = verge
                    .iter()
                    .any(|s| s.handedness() == pressing.handedness && (s.load().force - end.x).abs() < 1e-7);
                assert!(same, "{end:?}");
                met += 1;
            }
        }
    }
    assert!(met > 0);
}

/// The pitchfork of two strands, drawn as one thing over another.
#[test]
fn what_is_asked_can_stand_on_the_axis() {
    let spec = ply(&[("strands", "2"), ("stiffness-ratio", "0.75")]);
    let flags = GraphFlags {
        sweep: "pretwist=-20..20".into(),
        ask: vec!["arclength_shift".into(), "radius_ratio".into()],
        against: Some("helical_angle".into()),
        ..GraphFlags::default()
    };
    let graph = spec.check_graph(&flags).unwrap();
    let csv = graph.csv(&graph.curves());
    let head: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
    assert_eq!(head[5..], ["pretwist", "helical_angle_deg", "arclength_shift", "radius_ratio"]);
    let mut forked = 0;
    for line in csv.lines().skip(1) {
        let cells: Vec<f64> = line.split(',').skip(5).map(|cell| cell.parse().unwrap()).collect();
        if cells[1] < 44.999 {
            assert!(cells[2].abs() < 1e-12 && (cells[3] - 1.0).abs() < 1e-12, "{line}");
        } else if cells[1] > 45.001 {
            assert!(cells[2] > 0.0 && cells[3] > 1.0, "{line}");
            forked += 1;
        }
    }
    assert!(forked > 20);
}

/// A lay that runs: the moment that holds it, against the solver; in the reader's own units.
#[test]
fn a_lay_runs() {
    let spec = ply(&[
        ("strands", "3"),
        ("stiffness-ratio", "0.75"),
        ("diameter", "2 mm"),
        ("pretwist", "-0.3"),
        ("force", "0.1"),
    ]);
    let curves = graph(&spec, "lay_length=30..8 mm", &["moment"]).curves();
    let solver = Ply::new(3, 0.75).unwrap();
    let right: Vec<_> =
        curves.iter().filter(|curve| curve.handedness == Handedness::Right).flat_map(|c| &c.points).collect();
    assert!(right.len() > 20);
    for point in right {
        assert!(
            (point.state.contact().lay_length() - point.x).abs() < 1e-9 * point.x && (8.0..=30.0).contains(&point.x)
        );
        let again =
            solver.moment_at(point.state.contact().angle(), Handedness::Right, Twist::Pretwist(-0.3), 0.1).unwrap();
        assert!((again.load().moment - point.state.load().moment).abs() < 1e-12);
    }
    let svg = graph(&spec, "lay_length=30..8 mm", &["moment"]).picture(&curves).svg();
    assert!(svg.contains("lay length (mm)"));
}

/// Turns that are held: the angle follows from them alone; and what is held keeps its angle while another datum runs.
#[test]
fn held_ends_run_too() {
    let spec = ply(&[("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.3")]);
    let curves = graph(&spec, "length_ratio=0.6..0.95", &["force", "helical_angle"]).curves();
    assert!(!curves.is_empty());
    for point in curves.iter().flat_map(|curve| &curve.points) {
        assert!((point.state.contact().helical_angle().cos() - point.x).abs() < 1e-12);
        assert!(point.state.balance_residual().abs() < 1e-10);
    }
    let held = written(&[("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.3"), ("length-ratio", "0.9")]);
    let curves = graph(&held, "pretwist=-1..1", &["force"]).curves();
    let hands = curves.iter().map(|curve| curve.handedness).collect::<std::collections::HashSet<_>>();
    assert_eq!(hands.len(), 2);
    for point in curves.iter().flat_map(|curve| &curve.points) {
        assert!((point.state.contact().helical_angle().cos() - 0.9).abs() < 1e-12);
        assert!((point.state.pretwist() - point.x).abs() < 1e-12);
    }
}

/// Each ply, hand and balance has its name once; logarithmic axes have decades; panels stand above each other.
#[test]
fn a_picture_names_what_it_shows() {
    let spec = ply(&[("strands", "3"), ("stiffness-ratio", "0.75")]);
    let flags = GraphFlags {
        sweep: "pretwist=-2..2".into(),
        ask: vec!["helical_angle".into(), "interstrand_pressure".into()],
        strands: vec![2, 3, 6],
        balances: Balance::BOTH.to_vec(),
        ..GraphFlags::default()
    };
    let asked = spec.check_graph(&flags).unwrap();
    let svg = asked.picture(&asked.curves()).svg();
    for name in [
        "n = 2, right (Z), contact",
        "n = 6, left (S), radial",
        "separated, p₁ &lt; 0",
        "interstrand pressure p₁ (B/r³)",
    ] {
        assert_eq!(svg.matches(name).count(), 1, "{name}");
    }
    let scales = Scales { log_x: true, log_y: true };
    let flags = GraphFlags {
        sweep: "pretwist=0.001..10".into(),
        ask: vec!["helical_angle".into()],
        scales,
        ..GraphFlags::default()
    };
    let asked = spec.check_graph(&flags).unwrap();
    let svg = asked.picture(&asked.curves()).svg();
    assert!(svg.contains(">0.01<") && svg.contains(">10<"));
}

/// What neighbours would have to hold by pulling can be left out: what is left is what hangs there.
#[test]
fn a_graph_of_touching_plies_has_no_other() {
    let spec = ply(&[("strands", "3"), ("stiffness-ratio", "0.75")]);
    let flags = |touching| GraphFlags {
        sweep: "pretwist=-2..2".into(),
        ask: vec!["helical_angle".into()],
        touching,
        ..GraphFlags::default()
    };
    let graph = |touching: bool| spec.check_graph(&flags(touching)).unwrap();
    let (all, touching) = (graph(false).curves(), graph(true).curves());
    assert!(all.iter().any(|curve| curve.separated));
    let pressing: Vec<GraphCurve> = all.into_iter().filter(|curve| !curve.separated).collect();
    assert_eq!(touching, pressing);
    assert!(!graph(true).picture(&touching).svg().contains("separated"));
}

/// Touching helices are geometry: nothing is loaded and nothing twisted, so that no state of them is better than another.
#[test]
fn geometry_alone_has_no_separated_part() {
    let drawn = |flags: &[(&str, &str)], ask: &str| {
        let graph = graph(&ply(flags), "helical_angle=1..60 deg", &[ask]);
        let curves = graph.curves();
        (graph.picture(&curves).svg().contains("separated"), curves.iter().any(|curve| curve.separated))
    };
    let bare = [("strands", "3"), ("stiffness-ratio", "0.75"), ("hand", "right")];
    assert_eq!(drawn(&bare, "radius_ratio"), (false, false));
    // an elastic ply is asked after
    assert_eq!(drawn(&bare, "pretwist"), (true, true));
    let loaded = [bare[0], bare[1], bare[2], ("force", "-0.5"), ("moment", "0")];
    assert_eq!(drawn(&loaded, "radius_ratio"), (true, true));
}

/// What cannot be understood is said in a sentence, with the nearest name.
#[test]
fn what_cannot_run_is_refused() {
    let spec = ply(&[("strands", "3"), ("stiffness-ratio", "0.75")]);
    let refused = |sweep: &str, ask: &str| {
        let flags = GraphFlags { sweep: sweep.into(), ask: vec![ask.into()], ..GraphFlags::default() };
        spec.check_graph(&flags).unwrap_err().to_string()
    };
    assert!(refused("pretwst=0..1", "helical_angle").contains("pretwist"));
    assert!(refused("pretwist=0..1", "helical_angel").contains("helical_angle"));
    assert!(refused("strands=2..6", "helical_angle").contains("flags of their own"));
    assert!(refused("pretwist=0..0", "helical_angle").contains("does not change"));
    assert!(refused("pretwist 0 1", "helical_angle").contains("no range"));
    assert!(refused("force=0..1 mm", "helical_angle").contains("--sweep force"));
    let cored =
        ply(&[("strands", "6"), ("stiffness-ratio", "0.75"), ("pretwist", "0"), ("support-core-radius", "1.1")]);
    let flags = GraphFlags { sweep: "force=0..1".into(), ask: vec!["moment".into()], ..GraphFlags::default() };
    assert!(cored.check_graph(&flags).unwrap_err().to_string().contains("nply trace --plot"));
}

/// What runs stands below the picture in the words and the unit in which it was asked for: 1 to 100 turns of half a metre of strands are
/// no 2 to 200 turns per metre.
#[test]
fn the_axis_is_what_was_asked_for() {
    let spec = ply(&[
        ("strands", "2"),
        ("stiffness-ratio", "1"),
        ("pretwist", "0"),
        ("diameter", "1 mm"),
        ("strand-length", "0.5 m"),
    ]);
    for (range, label, mark) in [
        ("ply_turns=1..100", "ply turns", 100.0),
        ("ply_turns_per_strand_length=0..3 turns/inch", "ply turns per strand length (turns/inch)", 2.5),
        ("turns_per_length=-5 tpi..1 tpi", "turns per length (tpi)", -4.0),
        ("force=0..2", "end force (B/r²)", 2.0),
    ] {
        let spec = if range.starts_with("turns") {
            ply(&[("strands", "2"), ("stiffness-ratio", "1"), ("diameter", "1 mm")])
        } else {
            spec.clone()
        };
        let graph = graph(&spec, range, &["helical_angle"]);
        let picture = graph.picture(&graph.curves()).svg();
        assert!(picture.contains(&format!(">{label}<")), "{range}: {picture}");
        let ticks =
            picture.split('<').filter_map(|piece| piece.split('>').nth(1)?.replace('−', "-").parse::<f64>().ok());
        assert!(ticks.filter(|tick| (tick - mark).abs() < 1e-9).count() > 0, "{range}");
    }
}

/// The table of a chart has what runs as it was written, beside the theory's datum: a = 2πr times turns per length, a force in newtons.
#[test]
fn what_runs_is_in_the_table_as_it_was_written() {
    let cord = ply(&[("strands", "3"), ("stiffness-ratio", "0.75"), ("diameter", "6 mm")]);
    let stiff = [("turns-per-length", "3 turns/m"), ("bending-stiffness", "10 N mm2")];
    let loaded = ply(&[&[("strands", "3"), ("stiffness-ratio", "0.75"), ("diameter", "6 mm")], &stiff[..]].concat());
    let newtons = 10e-6 / (3e-3 * 3e-3); // B/r²
    for (spec, sweep, name, factor) in [
        (
            &cord,
            "turns_per_length=1..30 turns/m",
            "turns_per_length_turns_per_m",
            1.0 / (2.0 * std::f64::consts::PI * 3e-3),
        ),
        (&loaded, "force=0..30 N", "force_N", newtons),
    ] {
        let graph = graph(spec, sweep, &["radius_ratio"]);
        let csv = graph.csv(&graph.curves());
        let mut lines = csv.lines();
        assert_eq!(lines.next().unwrap().split(',').nth(6), Some(name), "{csv}");
        for line in lines {
            let cells: Vec<f64> = line.split(',').skip(5).take(2).map(|cell| cell.parse().unwrap()).collect();
            assert!((cells[1] - factor * cells[0]).abs() <= 1e-12 * (factor * cells[0]).abs(), "{line}");
        }
        assert!(csv.lines().count() > 20);
    }
}
