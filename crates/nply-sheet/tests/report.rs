//! What a report says of a state's limits, link and buckling, against what is found when the case is asked anew or worked out by hand.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "hands, ends of a curve and the same number written twice are exact")]

use nply::Handedness;
use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Balance, Equilibrium, Holding, Load, Ply, Support, Twist};
use nply_sheet::{Case, ErrorKind, LocusReport, Question, Report, Spec};
use serde_json::Value;

type Flags<'f> = &'f [(&'f str, &'f str)];

fn case(flags: Flags) -> Case {
    Spec::from_flags(flags.iter().copied()).unwrap().check().unwrap()
}

fn report(flags: Flags) -> (Report, Value) {
    let report = Report::of(case(flags)).unwrap();
    let json = serde_json::from_str(&report.json()).unwrap();
    (report, json)
}

fn number(object: &Value, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("{key} is no number: {}", object[key]))
}

#[track_caller]
fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found:e} is not {expected:e}");
}

/// Rope and yarn, pulled, pushed and turned; in some of them a limit lies beyond an angle at which the datum has no end.
const CASES: [[f64; 5]; 10] = [
    // strands, stiffness ratio, pretwist, force, moment
    [3.0, 0.75, 0.406_050_850_476_480_8, 0.0, 0.0],
    [3.0, 0.75, -0.2, 0.0, 0.0],
    [2.0, 0.75, -0.2, 0.05, 0.1],
    [2.0, 1.3, -1.0, 0.3, -0.3],
    [4.0, 0.5, 1.56, -0.055, -0.2365],
    [6.0, 0.93, 0.2638, 0.455, 0.4018],
    [7.0, 0.807, -1.66, 0.0, 0.644],
    [14.0, 1.1, -0.8, -0.02, 0.3],
    [3.0, 0.77, -0.35, -0.43, 0.88],
    [4.0, 0.78, 0.24, 0.03, 0.84],
];

/// The touching states of a hand when one datum is changed, asked anew.
fn anew(was: &Equilibrium, datum: &str, change: f64) -> Vec<Equilibrium> {
    let ply = Ply::with_balance(was.contact().strands(), was.stiffness_ratio(), was.balance()).unwrap();
    let (twist, load, angle, hand) = (was.twist(), was.load(), was.contact().angle(), was.handedness());
    let states = match datum {
        "force" => ply.equilibria(twist, Load { force: load.force + change, ..load }).unwrap(),
        "moment" => ply.equilibria(twist, Load { moment: load.moment + change, ..load }).unwrap(),
        "pretwist" => ply.equilibria(Twist::Pretwist(was.pretwist() + change), load).unwrap(),
        "force_ends_held" => vec![ply.moment_at(angle, hand, twist, load.force + change).unwrap()],
        // turns per length are sin θ/(2πρ): every angle that has so many
        "turns" => {
            let wanted = (was.rotation() / std::f64::consts::TAU + change) * hand.sign();
            let turns = |angle: f64| {
                let contact = Contact::new(ply.strands(), angle).unwrap();
                contact.angle().sin() / contact.radius_ratio() / std::f64::consts::TAU
            };
            let at = |i: u32| if i < 1570 { f64::from(i) * 1e-3 } else { std::f64::consts::FRAC_PI_2 };
            let found = (0..1570).filter(|i| (turns(at(*i)) < wanted) != (turns(at(i + 1)) < wanted));
            let angle = |i: u32| {
                let (mut low, mut high) = (at(i), at(i + 1));
                let below = turns(low) < wanted;
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    *(if (turns(middle) < wanted) == below { &mut low } else { &mut high }) = middle;
                }
                HelicalAngle::new(low).unwrap()
            };
            found.map(|i| ply.moment_at(angle(i), hand, twist, load.force).unwrap()).collect()
        }
        other => panic!("{other}"),
    };
    states.into_iter().filter(|state| state.handedness() == hand && state.interstrand_pressure() > 0.0).collect()
}

#[test]
fn a_margin_is_where_the_state_ends_when_the_case_is_asked_anew() {
    let mut causes = std::collections::BTreeMap::new();
    for data in CASES {
        for balance in ["contact", "radial"] {
            let data = data.map(|value| value.to_string());
            let names = ["strands", "stiffness-ratio", "pretwist", "force", "moment"];
            let mut flags: Vec<_> = names.iter().zip(&data).map(|(name, value)| (*name, value.as_str())).collect();
            flags.push(("balance", balance));
            let (report, json) = report(&flags);
            for (state, json) in report.solution.states.iter().zip(json["states"].as_array().unwrap()) {
                let margins = json["margins"].as_object().unwrap();
                assert_eq!(margins.len(), 5);
                for (datum, sides) in margins {
                    assert_eq!(sides.is_null(), state.interstrand_pressure() <= 0.0, "{datum}");
                    for side in ["below", "above"].iter().filter(|side| !sides[**side].is_null()) {
                        let limit = &sides[*side];
                        let (change, cause) = (number(limit, "change"), limit["cause"].as_str().unwrap());
                        assert_eq!(change < 0.0, *side == "below");
                        let (here, there) = (state.contact().angle().degrees(), number(limit, "helical_angle_deg"));
                        let between = |s: &&Equilibrium| {
                            let angle = s.contact().angle().degrees();
                            (here.min(there) - 0.01..=here.max(there) + 0.01).contains(&angle)
                        };
                        for share in [0.01, 0.5, 0.999] {
                            let found = anew(state, datum, change * share);
                            let stays = found.iter().any(|s| between(&s));
                            assert!(stays, "{data:?} {balance} {datum} {share} of {limit}");
                        }
                        // beyond it, no state presses that is near the last one; at straight strands and at the most turns none is
                        // left on this side
                        let found = anew(state, datum, change * 1.001);
                        let gone = found.iter().filter(between).count();
                        assert_eq!(gone, 0, "{data:?} {balance} {datum} beyond {limit}");
                        *causes.entry(cause.to_owned()).or_insert(0) += 1;
                    }
                }
            }
        }
    }
    assert!(causes.len() == 5 && causes.values().all(|count| *count >= 5), "{causes:?}");
}

#[test]
fn margins_are_read_in_the_units_of_the_input() {
    let flags = [
        ("strands", "3"),
        ("radius", "5 mm"),
        ("bending-stiffness", "1 N m^2"),
        ("stiffness-ratio", "0.75"),
        ("turns-per-length", "20 turns/m"),
        ("strand-length", "2 m"),
        ("force", "1 kN"),
    ];
    let (report, json) = report(&flags);
    let index = report.solution.states.iter().position(|state| !state.is_separated()).unwrap();
    let limit = &json["states"][index]["margins"]["turns"]["above"];
    // turns/r · 2 m and turns/r ÷ 5 mm
    near(number(limit, "change_total"), number(limit, "change") * 400.0, 1e-14);
    near(number(&limit["si"], "change"), number(limit, "change") / 5e-3, 1e-14);
    let force = &json["states"][index]["margins"]["force"]["below"];
    let newtons = number(force, "change") / 25e-6;
    near(number(&force["si"], "change"), newtons, 1e-14);
    let text = report.text(false);
    let row = |label: &str| {
        text.lines().find(|line| line.trim_start().starts_with(label)).unwrap_or_else(|| panic!("{text}"))
    };
    let cell: f64 = (format!("{:.3e}", -newtons / 1e3)).parse().unwrap();
    assert!(
        row("force may fall by  ").contains(" kN ") && row("force may fall by  ").contains(&format!("{cell} opens"))
    );
    assert!(row("turns in all to take out").contains(" turns "));
    // the same numbers in the table for spreadsheets
    let csv = report.csv();
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let value = |name: &str| rows[index + 1][rows[0].iter().position(|head| *head == name).expect(name)];
    assert_eq!(value("margin_force_below").parse::<f64>().unwrap().to_bits(), number(force, "change").to_bits());
    assert_eq!(value("margin_force_below_cause"), "separation");
    assert_eq!(value("margin_force_below_N").parse::<f64>().unwrap(), number(&force["si"], "change"));
    assert_eq!(value("stability_rotation_held"), "stable");
}

/// Two bounds that are compared, and terms that are summed, stand in one unit; a zero goes with what it is compared with.
#[test]
fn what_is_compared_has_one_unit() {
    let unit = |text: &str, label: &str| {
        let row =
            text.lines().find(|line| line.trim_start().starts_with(label)).unwrap_or_else(|| panic!("{label}: {text}"));
        // label, unit and cells stand at least two blanks apart
        row.trim().split("  ").filter(|part| !part.is_empty()).nth(1).unwrap().trim().to_owned()
    };
    // pull it buckles at: some µN where strands slide, some mN where they do not
    let ply = [
        ("strands", "3"),
        ("diameter", "1 mm"),
        ("bending-stiffness", "1 N mm^2"),
        ("stiffness-ratio", "0.75"),
        ("strand-length", "200 mm"),
        ("pretwist", "-1"),
    ];
    let text = report(&ply).0.text(false);
    let thrust = |how: &str| unit(&text, &format!("thrust it buckles at, {how}"));
    assert_eq!(thrust("strands sliding"), thrust("solid strands locked"));
    assert_eq!(unit(&text, "end loads"), unit(&text, "total"));
    assert_eq!(unit(&text, "end loads"), unit(&text, "bending  "));
    // strands that swivel have no twist: all link is writhe
    let braid = [
        ("strands", "2"),
        ("radius", "1 nm"),
        ("bending-stiffness", "206 pN nm^2"),
        ("stiffness-ratio", "2.4"),
        ("strand-twist", "0"),
        ("helical-angle", "18 deg"),
        ("force", "10 pN"),
    ];
    let text = report(&braid).0.text(false);
    let per_length = |what: &str| unit(&text, &format!("{what}, per strand length"));
    assert_eq!([per_length("put in"), per_length("twist")], [per_length("writhe"), per_length("writhe")]);
    assert_eq!(unit(&text, "strand twist per strand length"), unit(&text, "pretwist per strand length"));
}

#[test]
fn the_ledger_of_link_adds_up() {
    let flags = [
        ("strands", "3"),
        ("radius", "5 mm"),
        ("stiffness-ratio", "0.75"),
        ("turns-per-length", "20 turns/m"),
        ("strand-length", "2 m"),
    ];
    let (_, json) = report(&flags);
    let states = json["states"].as_array().unwrap();
    assert_eq!(states.len(), 3);
    for state in states {
        // three strands, 20 turns/m, 2 m
        near(number(state, "link_put_in_total"), 120.0, 1e-14);
        near(number(&state["si"], "link_put_in"), 60.0, 1e-14);
        for suffix in ["", "_total"] {
            let part = |name: &str| number(state, &format!("link_{name}{suffix}"));
            near(part("twist") + part("writhe"), part("put_in"), 1e-13);
        }
        // a turn of the ply takes cos θ of a turn out of each strand or puts it in
        let turns = number(state, "turns_per_strand_length") * number(state, "extension");
        near(number(state, "link_writhe"), -3.0 * number(state, "handedness") * turns, 1e-13);
    }
}

/// Turns are counted along a strand, which is longer than the ply.
#[test]
fn turns_per_strand_length_are_those_of_the_ply_on_a_longer_length() {
    let (_, json) = report(&[("strands", "3"), ("stiffness-ratio", "0.75"), ("helical-angle", "60 deg")]);
    let state = &json["states"][0];
    near(number(state, "turns_per_strand_length"), 0.5 * number(state, "turns_per_ply_length"), 1e-14);
}

/// Two strands at 30 degrees: ρ = 1; with γ = 1/2 the sliding ply bends with 2 cos 30°/1.125 = 1.5396007178, the locked one with 6.
/// A ply 100 r long under m = 0.1 then buckles at B_ply (π/100)² − 0.01/(4 B_ply).
#[test]
fn buckling_is_bounded_as_by_hand() {
    let thrusts = |force: &str| {
        report(&[
            ("strands", "2"),
            ("stiffness-ratio", "0.5"),
            ("helical-angle", "30 deg"),
            ("hand", "right"),
            ("strand-length", "115.47005383792516"),
            ("force", force),
            ("moment", "0.1"),
        ])
    };
    let (report, json) = thrusts("-0.002");
    let state = &json["states"][0];
    near(number(state, "bending_stiffness_sliding"), 1.539_600_717_839_002, 1e-14);
    near(number(state, "bending_stiffness_locked"), 6.0, 1e-14);
    near(number(state, "buckling_thrust_sliding"), -0.000_104_272_630_025_407, 1e-11);
    near(number(state, "buckling_thrust_locked"), 0.005_505_095_973_986_95, 1e-12);
    assert_eq!(state["separated"], false);
    assert!(report.notes.iter().any(|note| note.contains("In state 1 the ply may buckle")), "{:?}", report.notes);
    assert!(report.text(false).contains("thrust it buckles at, strands sliding"));
    let does = thrusts("-0.006").0.notes;
    assert!(does.iter().any(|note| note.contains("In state 1 the ply buckles as a whole")), "{does:?}");
    let pulled = thrusts("0.002").0.notes;
    assert!(pulled.iter().all(|note| !note.contains("buckle as") && !note.contains("buckles")), "{pulled:?}");
    // without a length there is nothing to say
    let (short, json) = self::report(&[("strands", "2"), ("stiffness-ratio", "0.5"), ("helical-angle", "30 deg")]);
    assert!(json["states"][0]["buckling_thrust_sliding"].is_null() && !short.text(false).contains("buckles"));
}

/// Glued strands bend as n(B + ½ EA R²), and EA is 4B/r² of solid round ones alone: nothing is said of it where persistence lengths or a
/// packing fraction say that the strands are others.
#[test]
fn the_upper_bound_is_of_solid_strands() {
    let molecule = [
        ("strands", "2"),
        ("radius", "5 nm"),
        ("bending-persistence-length", "50 nm"),
        ("stiffness-ratio", "1.5"),
        ("temperature", "298 K"),
        ("helical-angle", "30 deg"),
        ("hand", "right"),
        ("strand-length", "1 um"),
        ("force", "-0.0165 pN"),
        ("moment", "4.11 pN nm"),
    ];
    let (report, _) = self::report(&molecule);
    let text = report.text(false);
    assert!(text.contains("bending stiffness, strands sliding") && !text.contains("locked"), "{text}");
    assert!(report.notes.iter().any(|note| note.contains("may buckle")), "{:?}", report.notes);
    assert!(report.notes.iter().all(|note| !note.contains("buckles as a whole:")), "{:?}", report.notes);
    let rod: Vec<(&str, &str)> = molecule
        .into_iter()
        .filter(|(name, _)| *name != "temperature")
        .map(|(name, value)| match name {
            "bending-persistence-length" => ("bending-stiffness", "205.7 pN nm^2"),
            _ => (name, value),
        })
        .collect();
    let (report, _) = self::report(&rod);
    assert!(report.text(false).contains("bending stiffness, solid strands locked"));
    assert!(report.notes.iter().any(|note| note.contains("buckles as a whole:")), "{:?}", report.notes);
}

/// Neighbours that would have to pull hold nothing together: such a ply is no column, however wide its rings would be.
#[test]
fn what_has_come_apart_does_not_buckle() {
    let (_, json) =
        self::report(&[("strands", "3"), ("stiffness-ratio", "0.667"), ("pretwist", "-0.2"), ("strand-length", "300")]);
    let states = json["states"].as_array().unwrap();
    assert!(
        states.iter().any(|state| state["separated"] == true) && states.iter().any(|state| state["separated"] == false)
    );
    for state in states {
        for name in ["buckling_thrust_sliding", "buckling_thrust_locked"] {
            assert_eq!(state[name].is_null(), state["separated"] == true, "{state}");
        }
    }
}

/// The strand twist held, by the other road: the states that any support carries, of which touching neighbours are one.
#[test]
fn each_way_of_holding_the_ends_has_its_verdict() {
    let mut differs = 0;
    for data in CASES {
        let data = data.map(|value| value.to_string());
        let names = ["strands", "stiffness-ratio", "pretwist", "force", "moment"];
        let flags: Vec<_> = names.iter().zip(&data).map(|(name, value)| (*name, value.as_str())).collect();
        let (report, json) = report(&flags);
        let Question::States { twist, load } = report.case.question else { panic!("{:?}", report.case.question) };
        let ply = Ply::new(report.case.strands, report.case.stiffness_ratio).unwrap();
        let carried = ply.supported_states(twist, load, None).unwrap();
        for (state, json) in report.solution.states.iter().zip(json["states"].as_array().unwrap()) {
            let held = json["stability_by_holding"].as_object().unwrap();
            assert_eq!(held["dead_loads"], json["stability"]);
            if state.is_separated() {
                assert!(held.len() == 4 && held.values().all(Value::is_null));
                continue;
            }
            let same = carried
                .iter()
                .filter(|other| other.support() == Support::Neighbours && other.handedness() == state.handedness())
                .find(|other| (other.angle().radians() - state.contact().helical_angle()).abs() < 1e-9)
                .unwrap();
            let expected = same.with_strand_twist_held().stability(Holding::DeadLoads).name();
            assert_eq!(held["strand_twist_held"], expected, "{data:?}");
            assert_eq!((&held["rotation_held"], &held["length_held"]), (&"stable".into(), &"stable".into()));
            differs += u32::from(held["strand_twist_held"] != held["dead_loads"]);
        }
    }
    assert!(differs > 0, "no case tells the two apart");
    // where the strand twist is the datum there is no other to hold, and in radial balance no energy to ask
    let (_, json) =
        report(&[("strands", "2"), ("stiffness-ratio", "0.75"), ("strand-twist", "-0.2"), ("moment", "0.3")]);
    assert!(
        json["states"]
            .as_array()
            .unwrap()
            .iter()
            .all(|state| state["stability_by_holding"]["strand_twist_held"].is_null())
    );
}

fn locus(flags: Flags, points: usize) -> LocusReport {
    LocusReport::of(&case(flags), points).unwrap()
}

#[test]
fn strands_part_at_each_load_of_the_locus() {
    let flags = [
        ("strands", "3"),
        ("radius", "2 mm"),
        ("bending-stiffness", "1 N mm^2"),
        ("stiffness-ratio", "0.75"),
        ("pretwist", "-0.2"),
        ("force", "9 N"),
    ];
    let csv = locus(&flags, LocusReport::POINTS).csv();
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("handedness,lay,helical_angle_deg,force,moment,force_N,moment_N_m"));
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 2 * 200);
    for row in rows.iter().filter(|row| !["0.0", "90.0"].contains(&row[2])).step_by(7) {
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        near(number(5), number(3) / 4.0, 1e-14);
        near(number(6), number(4) / 2.0 * 1e-3, 1e-14);
        // the case asked anew: the force of this point, at separation, has this angle and moment among its answers
        let force = number(3).to_string();
        let states = case(&[
            ("strands", "3"),
            ("stiffness-ratio", "0.75"),
            ("pretwist", "-0.2"),
            ("separation", "true"),
            ("force", &force),
        ])
        .solve()
        .unwrap()
        .states;
        let same = |s: &&Equilibrium| {
            (s.contact().angle().degrees() - number(2)).abs() < 1e-4 && s.handedness().sign() == number(0)
        };
        let state = states.iter().find(same).unwrap_or_else(|| panic!("{row:?}"));
        assert!(
            (state.load().moment - number(4)).abs() < 1e-6 && row[1] == state.handedness().lay_letter().to_string()
        );
    }
}

/// Beside each line of constant angle stands its angle, and the line of that angle goes by there.
#[test]
fn lines_of_constant_angle_say_which() {
    let report = locus(&[("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2")], 200);
    let chart = report.picture();
    assert!(chart.notes.len() > 8, "{:?}", chart.notes);
    for note in &chart.notes {
        let degrees: f64 = note.words.trim_end_matches('°').parse().unwrap();
        let angle = nply::geometry::HelicalAngle::new(degrees.to_radians()).unwrap();
        let passes = nply::Handedness::BOTH.into_iter().any(|hand| {
            let line = report.line_of_angle(angle, hand).unwrap();
            let (x, y) = (note.x - line.parting.force, note.y - line.parting.moment);
            // on it, and where neighbours press
            (x * line.direction.moment - y * line.direction.force).abs() < 1e-9 * (1.0 + line.direction.moment.abs())
                && x * line.direction.force + y * line.direction.moment > 0.0
        });
        assert!(passes, "{note:?}");
    }
}

#[test]
fn named_points_are_what_they_are_called() {
    let report = locus(&[("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2")], 2001);
    let json: Value = serde_json::from_str(&report.json()).unwrap();
    assert_eq!(json["curves"][1]["moment"].as_array().unwrap().len(), 2001);
    assert_eq!(json["special_points"].as_array().unwrap().len(), report.special_points().len());
    let mut turning = 0;
    for point in report.special_points() {
        let degrees = point.angle.degrees();
        let curve: Vec<(f64, Load)> =
            report.curve(point.handedness).map(|(angle, load)| (angle.degrees(), load)).collect();
        let value = |load: &Load| if point.name == "moment_turns" { load.moment } else { load.force };
        match point.name {
            "straight" => {
                assert!(degrees == 0.0 && point.load.force == 0.0 && (point.load.moment + 0.45).abs() < 1e-15)
            }
            "diagonal" => assert!((degrees - 45.0).abs() < 1e-13),
            "rings" => assert!(degrees == 90.0 && point.load.force.abs() < 1e-15),
            // the curve's points on either side within three degrees lie all below, or all above
            _ => {
                turning += 1;
                let sides: Vec<bool> = curve
                    .iter()
                    .filter(|(angle, _)| (0.3..3.0).contains(&(angle - degrees).abs()))
                    .map(|(_, load)| value(load) < value(&point.load))
                    .collect();
                assert!(sides.len() > 50 && sides.iter().all(|side| *side == sides[0]), "{point:?}");
            }
        }
        assert!(report.text(false).contains(point.label));
    }
    assert!(turning >= 2);
}

#[test]
fn a_line_of_constant_angle_holds_its_angle_and_presses_on_its_side() {
    for balance in Balance::BOTH {
        let flags = [("strands", "4"), ("stiffness-ratio", "0.6"), ("pretwist", "0.3"), ("balance", balance.name())];
        let report = locus(&flags, 2);
        let ply = Ply::with_balance(4, 0.6, balance).unwrap();
        for degrees in [10.0_f64, 40.0, 60.0] {
            for hand in Handedness::BOTH {
                let angle = HelicalAngle::new(degrees.to_radians()).unwrap();
                let line = report.line_of_angle(angle, hand).unwrap();
                for steps in [-0.4, 0.5, 2.0] {
                    let load = line.at(steps);
                    let state = ply.force_at(angle, hand, Twist::Pretwist(0.3), load.moment).unwrap();
                    assert!((state.load().force - load.force).abs() < 1e-13, "{balance:?} {degrees} {hand:?} {steps}");
                    assert_eq!(
                        state.interstrand_pressure() > 0.0,
                        steps > 0.0,
                        "{balance:?} {degrees} {hand:?} {steps}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_locus_is_refused_where_its_data_say_so() {
    let refused = |flags: Flags, points| LocusReport::of(&case(flags), points).unwrap_err();
    let lay = refused(&[("strands", "3"), ("stiffness-ratio", "1"), ("lay-length", "30")], 200);
    assert!(lay.kind() == ErrorKind::Missing && lay.to_string().contains("the twist is missing"), "{lay}");
    let pressed = [("strands", "3"), ("stiffness-ratio", "1"), ("pretwist", "1"), ("external-pressure", "0.1")];
    assert!(refused(&pressed, 200).to_string().contains("external-pressure"));
    assert!(refused(&pressed[..3], 1).to_string().contains("points"));
}
