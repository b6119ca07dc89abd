//! What scripts rely on: flags, keys and numbers of `nply solve --json` and `nply contact --json`.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::collections::BTreeMap;
use std::fs;

use command::{json, near, number, out, root, states};
use nply_sheet::{COLUMNS, Report, Spec};
use serde_json::Value;

const SOLVE: [&str; 14] = [
    "solve",
    "--strands",
    "3",
    "--stiffness-ratio",
    "0.75",
    "--pretwist",
    "-1",
    "--force",
    "0.1",
    "--moment",
    "-0.2",
    "--balance",
    "radial",
    "--json",
];

/// Of a state: each must be a number wherever there is a state.
const NUMBERS: [&str; 6] = [
    "helical_angle_deg",
    "radius_ratio",
    "arclength_shift",
    "strand_twist",
    "resultant_pressure",
    "interstrand_pressure",
];

#[test]
fn a_state_has_its_keys() {
    let report = json(&SOLVE);
    assert_eq!(report["balance"], "radial");
    assert_eq!(report["version"], env!("CARGO_PKG_VERSION"));
    assert!(!states(&report).is_empty());
    for state in states(&report) {
        for key in NUMBERS {
            number(state, key);
        }
        let hand = state["handedness"].as_i64().expect("an integer");
        assert!(hand == 1 || hand == -1);
        let flexibility = state["flexibility"].as_array().unwrap();
        assert_eq!(flexibility.len(), 2);
        for row in flexibility {
            assert_eq!(row.as_array().unwrap().iter().filter(|cell| cell.is_f64()).count(), 2);
        }
    }
    let contact = json(&SOLVE.map(|word| if word == "radial" { "contact" } else { word }));
    assert_eq!(contact["balance"], "contact");
    let default: Vec<&str> = SOLVE.into_iter().filter(|word| !["--balance", "radial"].contains(word)).collect();
    assert_eq!(json(&default), contact);
}

#[test]
fn a_contact_has_its_keys() {
    for (strands, angle) in [("2", "30 deg"), ("2", "0 deg"), ("3", "20 deg"), ("6", "89.9 deg"), ("1000000", "50 deg")]
    {
        let found = json(&["contact", "--strands", strands, "--helical-angle", angle, "--json"]);
        for key in
            ["arclength_shift", "radius_ratio", "radius_ratio_slope", "contact_line_radius", "curvature", "hole_radius"]
        {
            number(&found, key);
        }
        assert_eq!(found["version"], env!("CARGO_PKG_VERSION"));
    }
}

/// Each number printed reads back as the very double that was computed.
#[test]
fn every_number_comes_back_to_the_last_bit() {
    let flags =
        [("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-1"), ("force", "0.1"), ("moment", "-0.2")];
    let report = Report::of(Spec::from_flags(flags).unwrap().check().unwrap()).unwrap();
    let mut arguments = vec!["solve".to_owned(), "--json".to_owned()];
    arguments.extend(flags.iter().flat_map(|(flag, value)| [format!("--{flag}"), (*value).to_owned()]));
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let printed = json(&arguments);
    assert_eq!(states(&printed).len(), report.solution.states.len());
    for (state, computed) in states(&printed).iter().zip(&report.solution.states) {
        for column in COLUMNS {
            // the stiffnesses as published belong to the radial balance, stability to states that press
            let Some(value) = column.of(computed) else {
                let apart = column.name == "second_variation" && computed.is_separated();
                assert!(apart || column.name.ends_with("_as_published"), "{}", column.name);
                assert!(state[column.name].is_null(), "{}", column.name);
                continue;
            };
            assert_eq!(number(state, column.name).to_bits(), value.to_bits(), "{}", column.name);
        }
        let flexibility = computed.flexibility().unwrap();
        for (row, cells) in flexibility.iter().enumerate() {
            for (column, value) in cells.iter().enumerate() {
                assert_eq!(state["flexibility"][row][column].as_f64().unwrap().to_bits(), value.to_bits());
            }
        }
    }
    let csv: Vec<&str> = arguments.iter().map(|word| if *word == "--json" { "--format=csv" } else { word }).collect();
    let csv = out(&csv);
    let mut rows = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = rows.next().unwrap();
    for (row, computed) in rows.zip(&report.solution.states) {
        for column in COLUMNS {
            let at = head.iter().position(|name| *name == column.name).expect(column.name);
            let value = row[at].parse::<f64>().ok().map(f64::to_bits);
            assert_eq!(value, column.of(computed).map(f64::to_bits), "{}", column.name);
        }
    }
}

/// No null, and no word for infinity, at any state that is no fold.
#[test]
fn a_number_stands_where_a_number_must_be() {
    let cases: [&[&str]; 6] = [
        &["--strands", "2", "--pretwist", "-0.3"],
        &["--strands", "2", "--pretwist", "1e-9"],
        &["--strands", "3", "--pretwist", "-5", "--force", "1e-6"],
        &["--strands", "12", "--pretwist", "0.7", "--force", "-1e-6", "--moment", "3"],
        &["--strands", "1000000", "--pretwist", "-1"],
        &["--strands", "4", "--pretwist", "1e6", "--force", "1e9"],
    ];
    for case in cases {
        for balance in ["contact", "radial"] {
            let arguments: Vec<&str> = ["solve", "--json", "--stiffness-ratio", "0.75", "--balance", balance]
                .iter()
                .chain(case)
                .copied()
                .collect();
            for state in states(&json(&arguments)) {
                assert_eq!(state["fold"], false);
                for (key, value) in state.as_object().unwrap() {
                    let of_radial_only = key.ends_with("_as_published") && balance == "contact";
                    let of_pressing_only = ["stability", "second_variation"].contains(&key.as_str())
                        && (balance == "radial" || state["separated"] == true);
                    let of_length_only = key.ends_with("_total") || key.starts_with("buckling_thrust");
                    let none = of_radial_only || of_pressing_only || of_length_only;
                    assert_eq!(value.is_null(), none, "{case:?}: {key}");
                    if let Some(number) = value.as_f64() {
                        assert!(number.is_finite(), "{case:?}: {key}");
                    }
                }
            }
            let text = out(&arguments);
            assert!(!text.contains("NaN") && !text.contains("inf") && !text.contains("Infinity"), "{text}");
        }
    }
}

/// Rows of a table, each by column name.
fn table(name: &str) -> Vec<BTreeMap<String, String>> {
    let text = fs::read_to_string(root().join("authorities").join(name)).unwrap();
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row =
        |line: &str| head.iter().zip(line.split(',')).map(|(key, cell)| ((*key).to_owned(), cell.to_owned())).collect();
    lines.map(row).collect()
}

type Row = BTreeMap<String, String>;

fn cell(row: &Row, key: &str) -> f64 {
    row[key].parse().unwrap()
}

/// Rows with the same inputs, in the order of the command: right hand first, then by angle.
fn cases(name: &str) -> Vec<Vec<Row>> {
    let mut found: BTreeMap<Vec<String>, Vec<Row>> = BTreeMap::new();
    for row in table(name) {
        let inputs = ["case", "n", "gamma", "pretwist", "f", "m", "balance"];
        found.entry(inputs.iter().filter_map(|key| row.get(*key).cloned()).collect()).or_default().push(row);
    }
    let mut cases: Vec<_> = found.into_values().collect();
    for rows in &mut cases {
        let key = |row: &Row| (-cell(row, "handedness"), cell(row, "theta_deg"));
        rows.sort_by(|a, b| key(a).partial_cmp(&key(b)).unwrap());
    }
    cases
}

/// The command's states for the inputs of a row.
fn solved(row: &Row) -> Vec<Value> {
    let get = |key: &str| row.get(key).map_or("0", String::as_str);
    let arguments = [
        "solve",
        "--strands",
        get("n"),
        "--stiffness-ratio",
        get("gamma"),
        "--pretwist",
        get("pretwist"),
        "--force",
        get("f"),
        "--moment",
        get("m"),
        "--balance",
        get("balance"),
        "--json",
    ];
    states(&json(&arguments)).to_vec()
}

/// Every root of the table, no other, each within 1e-11 rad; what follows from the angle to `tolerance`.
fn check(name: &str, tolerance: f64) {
    for rows in cases(name) {
        let states = solved(&rows[0]);
        assert_eq!(states.len(), rows.len(), "{name}: {:?}", rows[0]);
        for (state, row) in states.iter().zip(&rows) {
            assert_eq!(state["handedness"].as_i64().unwrap(), row["handedness"].parse::<i64>().unwrap(), "{row:?}");
            let away = (number(state, "helical_angle_deg") - cell(row, "theta_deg")).to_radians();
            assert!(away.abs() < 1e-11, "{away:e}: {row:?}");
            for (column, key) in [
                ("rho", "radius_ratio"),
                ("r_u3", "strand_twist"),
                ("p_r3_over_B", "resultant_pressure"),
                ("p1_r3_over_B", "interstrand_pressure"),
            ] {
                if row.contains_key(column) {
                    near(number(state, key), cell(row, column), tolerance);
                }
            }
        }
    }
}

#[test]
fn balanced_plies_as_tabled() {
    check("balanced_plies.csv", 1e-10);
}

#[test]
fn loaded_plies_as_tabled() {
    check("loaded_plies.csv", 1e-9);
}

#[test]
fn more_loaded_plies_as_tabled() {
    let inputs: BTreeMap<String, Row> =
        table("loaded_plies_more_cases.csv").into_iter().map(|row| (row["case"].clone(), row)).collect();
    for rows in cases("loaded_plies_more.csv") {
        let states = solved(&rows[0]);
        let row = &rows[0];
        assert_eq!(states.len(), rows.len(), "{} {row:?}", inputs[&row["case"]]["kind"]);
        for (state, row) in states.iter().zip(&rows) {
            let away = (number(state, "helical_angle_deg") - cell(row, "theta_deg")).to_radians();
            assert!(away.abs() < 1e-11, "{away:e}: {row:?}");
            assert_eq!(state["handedness"].as_i64().unwrap(), row["handedness"].parse::<i64>().unwrap());
        }
    }
}

#[test]
fn flexibilities_as_tabled() {
    // the first table lists the states that are wound up by their pretwist, the second every state
    for (name, all) in [("flexibility.csv", false), ("flexibility_more.csv", true)] {
        for rows in cases(name) {
            let states = solved(&rows[0]);
            assert!(!all || states.len() == rows.len(), "{name}: {:?}", rows[0]);
            for row in &rows {
                let state = states
                    .iter()
                    .filter(|state| state["handedness"].as_i64().unwrap() == row["handedness"].parse::<i64>().unwrap())
                    .find(|state| (number(state, "helical_angle_deg") - cell(row, "theta_deg")).abs() < 1e-9)
                    .unwrap_or_else(|| panic!("{row:?}"));
                for (i, j, column) in [(0, 0, "a_ddf_df"), (0, 1, "a_ddf_dm"), (1, 0, "a_ddm_df"), (1, 1, "a_ddm_dm")] {
                    near(state["flexibility"][i][j].as_f64().unwrap(), cell(row, column), 1e-10);
                }
            }
        }
    }
}

#[test]
fn contacts_as_tabled() {
    for row in table("contact_geometry.csv") {
        let angle = format!("{} deg", row["theta_deg"]);
        let found = json(&["contact", "--strands", &row["n"], "--helical-angle", &angle, "--json"]);
        for (column, key, tolerance) in [
            ("x", "arclength_shift", 1e-13),
            ("rho", "radius_ratio", 1e-13),
            ("drho_dtheta", "radius_ratio_slope", 1e-12),
            ("contact_helix_radius_over_r", "contact_line_radius", 1e-13),
            ("curvature_times_r", "curvature", 1e-13),
            ("hole_radius_over_r", "hole_radius", 1e-13),
        ] {
            let (found, expected) = (number(&found, key), cell(&row, column));
            // 40 digits see a zero as 2e-43
            assert!((found - expected).abs() <= tolerance * expected.abs() + 1e-40, "{key} {found:e}: {row:?}");
        }
    }
}
