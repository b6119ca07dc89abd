//! The same ply in any units is the same ply.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use command::{json, near, number, states};
use serde_json::Value;

/// One ply in one system of units: radius, B, C, twist, force, moment.
struct Written([&'static str; 6]);

/// r = 2 mm, B = 6 N mm², C = 4.5 N mm²; pretwist −0.8, f = 0.5, m = −1.
const MILLIMETRES: Written = Written(["2 mm", "6 N mm^2", "4.5 N mm^2", "-400 rad/m", "0.75 N", "-3 N mm"]);
const METRES: Written = Written(["0.002 m", "6e-6 N m^2", "4.5e-6 N m^2", "-0.4 rad/mm", "0.75 N", "-3e-3 N m"]);
/// r = 1/8 in, B = 3 lbf in², in pounds and inches: f = F/192 lbf, m = M/24 lbf in.
const INCHES: Written = Written(["0.125 in", "3 lbf in^2", "2.25 lbf in^2", "-6.4 rad/in", "96 lbf", "-24 lbf in"]);
/// r = 5 nm, B = 200 pN nm².
const MOLECULES: Written = Written(["5 nm", "200 pN nm^2", "150 pN nm^2", "-160 rad/um", "4 pN", "-40 pN nm"]);

fn solve(written: &Written, balance: &str) -> Value {
    let flags =
        ["--radius", "--bending-stiffness", "--torsional-stiffness", "--turns-per-length", "--force", "--moment"];
    let mut arguments = vec!["solve", "--strands", "4", "--balance", balance, "--json"];
    arguments.extend(flags.iter().zip(written.0).flat_map(|(flag, value)| [*flag, value]));
    json(&arguments)
}

fn dimensionless(balance: &str) -> Value {
    json(&[
        "solve",
        "--strands",
        "4",
        "--stiffness-ratio",
        "0.75",
        "--pretwist",
        "-0.8",
        "--force",
        "0.5",
        "--moment",
        "-1",
        "--balance",
        balance,
        "--json",
    ])
}

#[test]
fn units_change_nothing_but_the_units() {
    for balance in ["contact", "radial"] {
        let bare = dimensionless(balance);
        assert!(states(&bare).len() >= 2, "{bare}");
        for (written, r, b) in [
            (&MILLIMETRES, 2e-3, 6e-6),
            (&METRES, 2e-3, 6e-6),
            (&INCHES, 0.003175, 3.0 * 4.4482216152605 * 0.0254 * 0.0254),
            (&MOLECULES, 5e-9, 200e-30),
        ] {
            let found = solve(written, balance);
            near(number(&found, "strand_radius_m"), r, 1e-15);
            near(number(&found, "bending_stiffness_N_m2"), b, 1e-15);
            assert_eq!(states(&found).len(), states(&bare).len());
            for (state, expected) in states(&found).iter().zip(states(&bare)) {
                for (key, value) in expected.as_object().unwrap() {
                    if let Some(value) = value.as_f64() {
                        // what is nearly zero by cancellation is measured by 1, the natural size
                        let away = (number(state, key) - value).abs();
                        assert!(away <= 1e-12 * value.abs().max(1.0), "{key}: {} {value}", number(state, key));
                    }
                }
                natural(&found["si_units"], state, r, b);
            }
        }
    }
}

/// Each value in SI is the dimensionless one times the natural size of its unit.
fn natural(units: &Value, state: &Value, r: f64, b: f64) {
    let si = state["si"].as_object().unwrap();
    assert_eq!(si.len(), units.as_object().unwrap().len());
    for (key, value) in si {
        let size = match units[key].as_str().unwrap() {
            "m" => r,
            "turns/m" | "1/m" => 1.0 / r,
            "N" => b / (r * r),
            "N m" => b / r,
            "N/m" => b / (r * r * r),
            "N m^2" => b,
            "rad/N" => r * r / b,
            "rad/(N m)" => r / b,
            other => panic!("{key} in {other}"),
        };
        match value.as_f64() {
            Some(value) => near(value, number(state, key) * size, 1e-12),
            None => assert!(state[key].is_null(), "{key}"),
        }
    }
}
