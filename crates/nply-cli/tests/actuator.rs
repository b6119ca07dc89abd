//! Twisted string actuators: the published formula where it holds, the end of the stroke, stiffness, refusals.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::disallowed_methods, reason = "numbers to compare with go another way")]

mod command;

use core::f64::consts::TAU;

use command::{call, json, near, number, out};
use serde_json::Value;

fn actuator(strands: &str, more: &[&str]) -> Value {
    let base = ["actuator", "--strands", strands, "--diameter", "1 mm", "--strand-length", "0.5 m", "--force", "20 N"];
    json(&[&base[..], &["--json"], more].concat())
}

fn steps(report: &Value) -> &[Value] {
    report["steps"].as_array().unwrap()
}

/// p = √(L² − θ²r²) and torque/force θr²/p of Würtz et al. 2010, which two strings obey up to 45 degrees.
#[test]
fn two_strings_obey_the_published_formula_up_to_45_degrees() {
    let report = actuator("2", &["--motor-turns", "110", "--steps", "11"]);
    let (length, radius, force) = (0.5_f64, 0.5e-3, 20.0);
    for (i, step) in steps(&report).iter().enumerate() {
        // turns are those that were asked for, to the last digit
        assert!(number(step, "motor_turns").to_bits() == (10.0 * i as f64).to_bits());
        let theta = TAU * number(step, "motor_turns");
        let p = (length * length - theta * theta * radius * radius).sqrt();
        assert!(number(step, "helical_angle_deg") < 45.0);
        near(number(step, "length"), p, 1e-13);
        assert!((number(step, "stroke") - (length - p)).abs() < 1e-15);
        near(number(step, "torque"), force * theta * radius * radius / p, 1e-13);
        near(number(step, "constant_radius_torque"), force * theta * radius * radius / p, 1e-13);
        // the motor's work on a small turn is the load's
        near(number(step, "stroke_per_turn") * force, TAU * number(step, "torque"), 1e-13);
        near(number(step, "string_tension"), 0.5 * force * length / p, 1e-13);
    }
}

/// Two strings jam at 50.62 degrees; their formula goes on to tan α = π/2.
#[test]
fn the_stroke_ends_before_the_formula_says() {
    let report = actuator("2", &[]);
    let end = steps(&report).last().unwrap();
    near(number(end, "helical_angle_deg"), 50.6229, 1e-6);
    assert!(end["torque"].is_null() && end["stroke_per_turn"].is_null() && end["string_tension"].is_null());
    near(number(&report["most_turns"], "motor_turns"), number(end, "motor_turns"), 1e-15);
    let formula = &report["constant_radius_most_turns"];
    near(number(formula, "helical_angle_deg"), (TAU / 4.0).atan().to_degrees(), 1e-12);
    let sin = (TAU / 4.0).atan().sin();
    near(number(formula, "motor_turns"), 0.5 * sin / (TAU * 0.5e-3), 1e-12);
    assert!(number(formula, "motor_turns") > number(end, "motor_turns"));
    // zero-twist pitch angle of three strands 42.8 degrees: Bohr & Olsen, EPL 93 (2011) 60004; a rope of 68 % of its strands' length
    let three = actuator("3", &[]);
    let end = steps(&three).last().unwrap();
    assert!((90.0 - number(end, "helical_angle_deg") - 42.8).abs() < 0.05);
    assert!((number(end, "length") / 0.5 - 0.68).abs() < 5e-4);
}

/// The work of the motor over the whole table is force times stroke, and with stiffness the energy of bending and twisting as well.
#[test]
fn the_work_of_the_motor_is_kept() {
    let stiff = ["--bending-stiffness", "2 N mm^2", "--stiffness-ratio", "0.75"];
    for strands in ["2", "3", "5"] {
        let more = [&["--motor-turns", "30 S", "--steps", "400"], &stiff[..]].concat();
        let report = actuator(strands, &more);
        let swivelling = actuator(strands, &[&more[..], &["--strand-twist", "0"]].concat());
        assert_eq!(report["lay"], "S");
        let work_in = |report: &Value, torque: &str| {
            let pair = |pair: &[Value]| {
                let turned = TAU * (number(&pair[1], "motor_turns") - number(&pair[0], "motor_turns"));
                0.5 * turned * (number(&pair[0], torque) + number(&pair[1], torque))
            };
            steps(report).windows(2).map(pair).sum::<f64>()
        };
        let work = |torque| work_in(&report, torque);
        let end = steps(&report).last().unwrap();
        let lifted = 20.0 * number(end, "stroke");
        near(work("torque"), lifted, 3e-5);
        // B/2 κ² + C/2 τ² per length, of a helix of angle θ and radius R from the turns: sin θ = R Y
        let theta = number(end, "helical_angle_deg").to_radians();
        let rate = TAU * 30.0 / 0.5; // sin θ/R
        let (curvature, twist) = (rate * theta.sin(), rate * theta.cos());
        let n: f64 = strands.parse().unwrap();
        let stored = n * 0.5 * 0.5 * 2e-6 * (curvature * curvature + 0.75 * twist * twist);
        near(work("stiff_torque"), lifted + stored, 3e-5);
        // with swivels the strings are bent and no more
        let bent = n * 0.5 * 0.5 * 2e-6 * curvature * curvature;
        near(work_in(&swivelling, "stiff_torque"), lifted + bent, 3e-5);
    }
}

#[test]
fn a_table_is_written_for_spreadsheets() {
    let base = ["actuator", "--strands", "2", "--radius", "0.5 mm", "--strand-length", "0.5 m", "--force", "20 N"];
    let csv = out(&[&base[..], &["--steps", "4", "--format", "csv"]].concat());
    let lines: Vec<&str> = csv.lines().collect();
    assert!(lines.len() == 6 && lines[0].starts_with("motor_turns,helical_angle_deg,length_m,stroke_m,"));
    let text = out(&base);
    assert!(text.contains("117.629") && text.contains("2 limp strings under 20 N, turned Z"), "{text}");
}

/// Strings that were strongly twisted the way the motor turns do not stay together under a small pull; twisted the other way they do.
#[test]
fn strings_that_part_are_said_to() {
    for (twist, parted) in [("400 turns/m S", false), ("400 turns/m Z", true)] {
        let strings = ["--strands", "3", "--diameter", "1 mm", "--strand-length", "0.5 m", "--force", "0.01 N"];
        let stiff = ["--bending-stiffness", "2 N mm^2", "--stiffness-ratio", "0.75", "--turns-per-length", twist];
        let given = [&strings[..], &stiff, &["--json"]].concat();
        let report = json(&[&["actuator"], &given[..], &["--motor-turns", "40", "--steps", "2"]].concat());
        assert_eq!(report["notes"].to_string().contains("do not stay together"), parted);
        for step in &steps(&report)[1..] {
            assert_eq!(step["stiff_torque"].is_null(), parted);
            let turns = number(step, "motor_turns").to_string();
            let solved = json(&[&["solve"], &given[..], &["--ply-turns", &turns]].concat());
            let below =
                |state: &&Value| (number(state, "helical_angle_deg") - number(step, "helical_angle_deg")).abs() < 1e-9;
            let state = solved["states"].as_array().unwrap().iter().find(below).unwrap();
            assert_eq!(state["separated"], parted);
            if !parted {
                near(number(step, "stiff_torque"), number(&state["si"], "moment"), 1e-9);
            }
        }
    }
}

#[test]
fn what_no_strings_do_is_refused() {
    let base = ["actuator", "--strands", "2", "--diameter", "1 mm", "--strand-length", "0.5 m"];
    for (more, code, part) in [
        (&["--force", "20 N", "--motor-turns", "118"][..], 1, "cannot take so many turns"),
        (&["--force", "20 N", "--motor-turns", "0"], 1, "does not turn"),
        (&["--force", "-1 N"], 1, "must be greater than 0"),
        (&["--force", "20"], 2, "has no unit"),
        (&[], 2, "the load is missing"),
        (&["--force", "20 N", "--turns-per-length", "10 tpm"], 2, "limp strings hold no twist"),
        (&["--force", "20 N", "--stiffness-ratio", "1"], 2, "bending stiffness"),
    ] {
        let answer = call(&[&base[..], more].concat());
        assert!(answer.code == code && answer.err.contains(part), "{more:?}: {} {}", answer.code, answer.err);
    }
    let answer = call(&["actuator", "--strands", "2", "--diameter", "1 mm", "--force", "20 N"]);
    assert!(answer.code == 2 && answer.err.contains("length of the strings"), "{}", answer.err);
}

/// Asked backwards: turns for a stroke, a torque and a tension, of two strings by p = √(L² − θ²r²), torque = F θ r²/p, tension = F L/(2p).
#[test]
fn a_stroke_a_torque_and_a_tension_give_their_turns() {
    let (length, radius, force) = (0.5_f64, 0.5e-3, 20.0);
    let last = |more: &[&str]| steps(&actuator("2", more)).last().unwrap().clone();
    let turns = |p: f64| (length * length - p * p).sqrt() / radius / TAU;
    near(number(&last(&["--stroke", "100 mm"]), "motor_turns"), turns(0.4), 1e-11);
    near(number(&last(&["--tension", "12.5 N"]), "motor_turns"), turns(0.5 * force * length / 12.5), 1e-11);
    // θ² (F²r⁴ + M²r²) = M²L²
    let moment = 5e-3;
    let theta = moment * length / ((force * radius * radius).powi(2) + (moment * radius).powi(2)).sqrt();
    near(number(&last(&["--torque", "5 N mm"]), "motor_turns"), theta / TAU, 1e-11);
    // more strings and back: no formula, but the same stroke
    let three = actuator("3", &["--stroke", "100 mm"]);
    near(number(steps(&three).last().unwrap(), "stroke"), 0.1, 1e-12);
    let base = ["actuator", "--strands", "2", "--diameter", "1 mm", "--strand-length", "0.5 m", "--force", "20 N"];
    for (more, code, said) in [
        (&["--stroke", "0.4 m"][..], 1, "that of the most turns"),
        (&["--stroke", "1e-300 mm"], 1, "--stroke: the strokes of these strings are between 0"),
        (&["--tension", "9 N"], 1, "before any turn"),
        (&["--tension", "10 N"], 1, "--tension: the load alone pulls each string by 10 N, before any turn"),
        (&["--tension", "-3 N"], 2, "is no tension"),
        (&["--torque", "1e9 N mm"], 1, "next to which it is without bound"),
        (&["--torque", "9 N"], 2, "is no torque"),
        (&["--stroke", "30"], 2, "\"30\" has no unit: what is wanted is a length greater than 0, such as \"30 mm\""),
        (&["--torque", "5"], 2, "\"5\" has no unit"),
        (&["--tension", "5"], 2, "\"5\" has no unit"),
        // strings that stretch are another command's, and no flag leads there
        (&["--axial-stiffness", "5000 N"], 2, "`nply support` and `nply trace` know strands that do, with `--stretch`"),
        (&["--stroke", "9 mm", "--motor-turns", "3"], 2, "leave one of them out"),
    ] {
        let answer = call(&[&base[..], more].concat());
        assert!(answer.code == code && answer.err.contains(said), "{more:?}: {} {}", answer.code, answer.err);
    }
}

#[test]
fn the_help_says_where_strings_stretch() {
    for verb in ["actuator", "spin"] {
        let help = out(&[verb, "--help"]);
        let of_flag = help.split("      --stretch ").nth(1).unwrap();
        let of_flag = of_flag.split("      --").next().unwrap();
        assert!(of_flag.contains("Not taken here") && of_flag.contains("`nply trace`"), "{verb}: {of_flag}");
    }
}

/// Refused by the name that was typed, with the limit of the table, which can be given.
#[test]
fn turns_past_the_limit_are_answered_in_the_words_they_were_asked_in() {
    let base = ["actuator", "--strands", "2", "--diameter", "1 mm", "--strand-length", "0.5 m", "--force", "20 N"];
    for flag in ["--motor-turns", "--ply-turns"] {
        let answer = call(&[&base[..], &[flag, "200"]].concat());
        assert!(answer.code == 1 && answer.err.contains(&format!("`{flag} \"200\"`")), "{}", answer.err);
        let most = answer.err.split("can take is ").nth(1).unwrap().split(',').next().unwrap();
        let table = out(&[&base[..], &[flag, most]].concat());
        assert!(table.contains(&format!("The most turns are {},", most.strip_suffix(" turns").unwrap())), "{table}");
    }
    let both = call(&[&base[..], &["--motor-turns", "3", "--ply-turns", "3"]].concat());
    assert!(both.code == 2 && both.err.contains("cannot be used with"), "{}", both.err);
}
