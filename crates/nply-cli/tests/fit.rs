//! Numbers of the strands from measurements, through the command.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs;

use command::{call, call_with, json, near, number, out, root};
use serde_json::Value;

fn estimate<'r>(report: &'r Value, name: &str) -> &'r Value {
    report["estimates"].as_array().unwrap().iter().find(|estimate| estimate["name"] == name).unwrap()
}

fn folder(name: &str) -> std::path::PathBuf {
    let folder = std::env::temp_dir().join(format!("nply-fit-{name}-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Rods simulated in three dimensions give back the C/B they were given.
#[test]
fn simulated_rods_give_back_their_stiffness_ratio() {
    let report = json(&[
        "fit",
        "examples/fit/balance.csv",
        "--strands",
        "3",
        "--stiffness-ratio",
        "1.5",
        "--estimate",
        "stiffness_ratio",
        "--json",
    ]);
    let ratio = estimate(&report, "stiffness_ratio");
    near(number(ratio, "value"), 0.75, 2e-5);
    assert!((5e-6..2e-5).contains(&number(ratio, "standard_error")));
    assert_eq!((report["degrees_of_freedom"].as_u64(), &report["errors_given"]), (Some(3), &Value::Bool(true)));
    assert_eq!(report["taken_as_zero"], serde_json::json!(["force", "moment"]));
    let rows = report["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    near(number(&rows[2], "helical_angle_deg"), 30.6130, 5e-6);
}

/// The noisy example: truth within three standard errors, residuals as tables, a picture.
#[test]
fn the_example_gives_what_it_was_made_of() {
    let folder = folder("example");
    let (table, picture) = (folder.join("residuals.csv"), folder.join("cord.svg"));
    let arguments = [
        "fit",
        "examples/fit/cord-pull.csv",
        "examples/fit/cord.toml",
        "--estimate",
        "bending_stiffness,stiffness_ratio,diameter",
    ];
    let more = ["--starts", "2", "--output", table.to_str().unwrap(), "--plot", picture.to_str().unwrap(), "--json"];
    let report = json(&[&arguments[..], &more[..]].concat());
    for (name, truth, unit) in
        [("bending_stiffness", 2e-9, "N m^2"), ("stiffness_ratio", 0.8, ""), ("diameter", 0.6e-3, "m")]
    {
        let found = estimate(&report, name);
        let pull = (number(found, "value") - truth) / number(found, "standard_error");
        assert!(pull.abs() < 3.0, "{name}: {pull}");
        assert_eq!(found["unit"], unit);
    }
    // three numbers a row, one of them used up by the row's state; three estimates
    assert_eq!(report["degrees_of_freedom"], 21 * 2 - 3);
    assert!((0.01..0.99).contains(&number(&report, "probability")));
    let table = fs::read_to_string(table).unwrap();
    assert_eq!(table.lines().count(), 22);
    assert!(table.starts_with(
        "line,handedness,helical_angle_deg,force_N,moment_N_m,interstrand_pressure,separated,states,measured_force_N,"
    ));
    let sum: f64 = report["rows"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(|row| row["compared"].as_array().unwrap())
        .map(|compared| number(compared, "standardised") * number(compared, "standardised"))
        .sum();
    near(sum, number(&report, "chi_squared"), 1e-9);
    assert!(fs::read_to_string(&picture).unwrap().starts_with("<svg "));
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_person_reads_estimates_in_their_own_units() {
    let said = out(&[
        "fit",
        "examples/fit/cord-pull.csv",
        "examples/fit/cord.toml",
        "--estimate",
        "diameter",
        "--bending-stiffness",
        "2 mN mm^2",
        "--stiffness-ratio",
        "0.8",
        "--starts",
        "1",
    ]);
    let line = said.lines().find(|line| line.trim_start().starts_with("diameter")).unwrap();
    assert!(line.contains("mm") && line.contains('%') && line.contains("0.5"), "{line}");
    assert!(said.contains("held: moment; measured: force, lay_length, ply_turns_per_strand_length"), "{said}");
    assert!(said.contains("degrees of freedom") && !said.contains('\u{1b}'), "{said}");
}

#[test]
fn what_is_wrong_is_said_at_its_place_and_nothing_is_written() {
    let folder = folder("refused");
    let csv = folder.join("a.csv");
    let answer = |text: &str, more: &[&str]| {
        let arguments = [
            "fit",
            "-",
            "--strands",
            "3",
            "--stiffness-ratio",
            "1",
            "--pretwist",
            "-1",
            "--estimate",
            "stiffness_ratio",
        ];
        call_with(&[&arguments[..], more].concat(), text.as_bytes())
    };
    let bad = answer("helical_angle_deg\ntwelve\n", &["--output", csv.to_str().unwrap()]);
    assert_eq!(bad.code, 2);
    assert!(bad.err.contains("standard input:2:1") && bad.err.contains("twelve") && !csv.exists(), "{}", bad.err);
    // a premise that no ply has
    let none = answer("force,length_ratio\n0.5,0.9\n1,1.2\n", &["--measured", "force"]);
    assert_eq!(none.code, 1, "{}", none.err);
    assert!(none.err.contains("no state") && none.err.contains("standard input:3:1"), "{}", none.err);
    assert_eq!(
        call(&[
            "fit",
            "no-such.csv",
            "--strands",
            "3",
            "--stiffness-ratio",
            "1",
            "--pretwist",
            "-1",
            "--estimate",
            "stiffness_ratio"
        ])
        .code,
        3
    );
    assert_eq!(call(&["fit", "-", "--strands", "3"]).code, 2);
    let same = answer("helical_angle_deg\n12\n", &["--output", "a.svg", "--plot", "a.svg"]);
    assert!(same.code == 2 && same.err.contains("same file") && !root().join("a.svg").exists(), "{}", same.err);
    fs::remove_dir_all(folder).unwrap();
}

/// A class counts coils, not signed coils: strands twisted Z wind into an S ply, and counts without the sign fit no touching state.
#[test]
fn counts_without_their_sign_give_no_value() {
    let rows = [(5, 5.0), (10, 9.0), (15, 12.5), (20, 15.0), (30, 18.0)];
    let fit = |sign: f64, head: &str| {
        let mut text = format!("{head}\n");
        for (twist, coils) in rows {
            text += &format!("{twist},{}\n", sign * coils);
        }
        let ply = ["--strands", "3", "--diameter", "6 mm", "--stiffness-ratio", "1", "--estimate", "stiffness_ratio"];
        call_with(&[&["fit", "-", "--json"], &ply[..]].concat(), text.as_bytes())
    };
    let head = "turns_per_length [turns/m],ply_turns_per_strand_length [turns/m]";
    let counted: Value = serde_json::from_str(&fit(1.0, head).out).unwrap();
    assert_eq!(estimate(&counted, "stiffness_ratio")["value"], Value::Null);
    let signed: Value = serde_json::from_str(&fit(-1.0, head).out).unwrap();
    let ratio = number(estimate(&signed, "stiffness_ratio"), "value");
    assert!((0.55..0.75).contains(&ratio), "{ratio}"); // a rubber cord's C/B is 2/3 where it is solid
    // columns by the names of reports, and what to do with those that are none
    let per_length = fit(-1.0, "turns_per_length [turns/m],turns_per_ply_length [turns/m]");
    assert_eq!(per_length.code, 0, "{}", per_length.err);
    let turns = fit(-1.0, "turns,ply_turns_per_strand_length [turns/m]");
    assert!(turns.code == 2 && turns.err.contains("the twist put in stands in turns_per_length"), "{}", turns.err);
}

/// Three strands of 0.5 mm, lays to 0.4 %.
fn lays(table: &str, more: &[&str]) -> command::Answer {
    let ply =
        ["fit", "-", "--strands", "3", "--diameter", "0.5 mm", "--stiffness-ratio", "1", "--error", "lay_length=0.4%"];
    call_with(&[&ply[..], more].concat(), table.as_bytes())
}

/// The least lay of n touching strands is n strand diameters (flat rings, all in one turn).
#[test]
fn what_no_ply_can_have_is_refused_and_not_fitted_at_90_degrees() {
    let table = "turns_per_length [tpm],lay_length [mm]\n200,5.93\n300,4.55\n400,0.9\n500,3.55\n";
    let answer = lays(table, &["--estimate", "stiffness_ratio"]);
    assert_eq!(answer.code, 1, "{}", answer.out);
    assert!(answer.err.contains("standard input:4:1") && answer.err.contains("0.9 mm"), "{}", answer.err);
    assert!(answer.err.contains("at least 1.5 mm"), "{}", answer.err);
}

#[test]
fn what_is_not_determined_has_no_value() {
    let table = "turns_per_length [tpm],lay_length [mm]\n200,5.93\n300,4.55\n500,3.55\n";
    let asked = ["--bending-stiffness", "1 mN mm^2", "--estimate", "stiffness_ratio,bending_stiffness"];
    let said = lays(table, &asked).out;
    let line = said.lines().find(|line| line.trim_start().starts_with("bending_stiffness")).unwrap();
    assert!(line.contains(" –  ") && line.contains("not determined"), "{line}");
    let report: Value = serde_json::from_str(&lays(table, &[&asked[..], &["--json"]].concat()).out).unwrap();
    let stiffness = estimate(&report, "bending_stiffness");
    assert_eq!((&stiffness["value"], &stiffness["standard_error"]), (&Value::Null, &Value::Null));
    assert!(estimate(&report, "stiffness_ratio")["value"].is_f64());
}

#[test]
fn rows_left_out_and_a_row_that_stands_alone_are_named() {
    let said = lays(
        "turns_per_length [tpm],lay_length [mm]\n200,5.93\n300,4.55\n,3.31\n500,3.55\n",
        &["--estimate", "stiffness_ratio"],
    )
    .out;
    assert!(
        said.contains("fitted to 3 of 4 rows") && said.contains("1 row is left out: no turns_per_length in line 4."),
        "{said}"
    );
    let table = "turns_per_length [tpm],lay_length [mm]\n200,5.93\n300,4.55\n400,5.87\n500,3.55\n";
    let said = lays(table, &["--estimate", "stiffness_ratio"]).out;
    assert!(said.contains("Line 4 alone makes") && !said.contains("times as large would explain"), "{said}");
    // without it the estimate is that of the other rows
    let without = lays(
        "turns_per_length [tpm],lay_length [mm]\n200,5.93\n300,4.55\n500,3.55\n",
        &["--estimate", "stiffness_ratio", "--json"],
    )
    .out;
    let ratio = number(estimate(&serde_json::from_str(&without).unwrap(), "stiffness_ratio"), "value");
    assert!(said.contains(&format!("Without it stiffness_ratio = {ratio:.4}")), "{ratio} {said}");
}

/// A ply let go winds against the twist in its strands: turns without their sign are found out, and S says the sign.
#[test]
fn forgotten_signs_are_asked_about() {
    let fit = |rows: &str, more: &[&str]| {
        let ply = [
            "fit",
            "-",
            "--strands",
            "2",
            "--diameter",
            "0.03 inch",
            "--stiffness-ratio",
            "1",
            "--estimate",
            "stiffness_ratio",
        ];
        let error = ["--error", "ply_turns_per_length=0.1tpi"];
        let table = format!("turns_per_length [tpi],ply_turns_per_length [tpi]\n{rows}");
        call_with(&[&ply[..], &error, more].concat(), table.as_bytes())
    };
    let forgotten = fit("8,5.2\n10,5.9\n", &[]);
    assert!(forgotten.out.contains("With the signs of ply_turns_per_length turned round"), "{}", forgotten.out);
    let contradicted = fit("8,5.2\n10,5.9\n", &["--hand", "S"]);
    assert_eq!(contradicted.code, 1, "{}", contradicted.out);
    assert!(contradicted.err.contains("With the signs of ply_turns_per_length turned round"), "{}", contradicted.err);
    let signed = fit("8,-5.2\n10,-5.9\n", &["--json"]).out;
    let lettered = fit("8 Z,5.2 S\nZ 10,S 5.9\n", &["--json"]).out;
    assert!(!signed.contains("turned round"), "{signed}");
    assert_eq!(signed, lettered);
    let twice = fit("8,+5.2 S\n10,5.9\n", &[]);
    assert!(twice.code == 2 && twice.err.contains("say opposite hands"), "{}", twice.err);
}

/// Where a comma parts no cells it is that of a decimal.
#[test]
fn decimal_commas_are_read_beside_semicolons_and_tabs() {
    let comma = lays(
        "turns_per_length [tpm],lay_length [mm]\n200,5.93\n300,4.55\n",
        &["--estimate", "stiffness_ratio", "--json"],
    )
    .out;
    for separator in [";", "\t"] {
        let table =
            format!("turns_per_length [tpm]{separator}lay_length [mm]\n200{separator}5,93\n300{separator}4,55\n");
        assert_eq!(lays(&table, &["--estimate", "stiffness_ratio", "--json"]).out, comma);
    }
}

/// A diameter known with an error counts as one measurement more: the estimate is the mean, by their variances, of what the data alone say
/// and what was known; both stiffnesses stay within their errors, where a held diameter leads them astray.
#[test]
fn a_known_diameter_has_its_error() {
    let fit = |more: &[&str]| {
        let ply = ["fit", "examples/fit/cord-pull.csv", "examples/fit/cord.toml", "--starts", "1", "--json"];
        json(&[&ply[..], more].concat())
    };
    let all = ["--estimate", "bending_stiffness,stiffness_ratio,diameter"];
    let alone = fit(&all);
    let known = fit(&[&all[..], &["--diameter", "0.61 mm", "--error", "diameter=0.004mm"]].concat());
    let [of_data, of_both] = [&alone, &known].map(|report| estimate(report, "diameter"));
    let weight = |error: f64| 1.0 / (error * error);
    let (data, prior) = (weight(number(of_data, "standard_error")), weight(0.004e-3));
    let mean = (data * number(of_data, "value") + prior * 0.61e-3) / (data + prior);
    near(number(of_both, "value"), mean, 1e-3);
    near(number(of_both, "standard_error"), (data + prior).sqrt().recip(), 0.02);
    near(number(of_both, "known_to"), 0.004e-3, 1e-12);
    assert_eq!(known["degrees_of_freedom"].as_u64(), alone["degrees_of_freedom"].as_u64().map(|freedom| freedom + 1));
    let held = call(&[
        "fit",
        "examples/fit/cord-pull.csv",
        "examples/fit/cord.toml",
        "--estimate",
        "stiffness_ratio",
        "--error",
        "diameter=1um",
    ]);
    assert!(held.code == 2 && held.err.contains("what is held counts as exact"), "{}", held.err);
}

/// Where the error of what is known goes to nothing, the others are estimated as if it were held.
#[test]
fn what_is_known_to_many_digits_is_as_good_as_held() {
    let fit = |more: &[&str]| {
        let ply = [
            "fit",
            "examples/fit/cord-pull.csv",
            "examples/fit/cord.toml",
            "--starts",
            "1",
            "--json",
            "--diameter",
            "0.61 mm",
        ];
        json(&[&ply[..], more].concat())
    };
    let held = fit(&["--estimate", "bending_stiffness,stiffness_ratio"]);
    let known = fit(&["--estimate", "bending_stiffness,stiffness_ratio,diameter", "--error", "diameter=1e-12mm"]);
    for name in ["bending_stiffness", "stiffness_ratio"] {
        let [of_held, of_known] = [&held, &known].map(|report| estimate(report, name));
        near(number(of_known, "value"), number(of_held, "value"), 1e-6);
        near(number(of_known, "standard_error"), number(of_held, "standard_error"), 1e-3);
    }
}

/// Two strings wound n times are helices of their own radius: L² = L₀² − (2πnr)², whatever holds the turns.
#[test]
fn turns_and_lengths_alone_give_a_diameter() {
    let table = |third: &str| {
        let rows = [20.0, 60.0, 100.0].map(|turns: f64| {
            let girth = std::f64::consts::TAU * turns * 0.5;
            let cells = if third.is_empty() { "" } else { "," };
            format!("{turns},{:?}{cells}", (500.0 * 500.0 - girth * girth).sqrt())
        });
        format!("ply_turns,ply_length [mm]{third}\n{}\n", rows.join("\n"))
    };
    let fit = |table: &str, more: &[&str]| {
        let ply = ["fit", "-", "--strands", "2", "--diameter", "0.9 mm", "--strand-length", "0.5 m", "--hand", "Z"];
        let asked = ["--stiffness-ratio", "1", "--strand-twist", "0", "--estimate", "diameter"];
        let stiffness = ["--bending-stiffness", "0.02 N mm^2", "--error", "ply_length=0.1mm"];
        call_with(&[&ply[..], &asked, &stiffness, more].concat(), table.as_bytes())
    };
    for (third, held) in [("", vec!["ply_turns"]), (",moment [N mm]", vec!["ply_turns"])] {
        let answer = fit(&table(third), &["--json"]);
        let report: Value = serde_json::from_str(&answer.out).expect(&answer.err);
        near(number(estimate(&report, "diameter"), "value"), 1e-3, 1e-8);
        // what has no value is not held
        assert_eq!(report["held"], serde_json::json!(held));
        assert_eq!(report["taken_as_zero"], serde_json::json!(["force"]));
        let said = fit(&table(third), &[]).out;
        assert!(said.contains("held: ply_turns, force 0 (not given); free: moment; measured: ply_length"), "{said}");
    }
    // a moment that is given holds as ever, and is one too many
    let given = fit(&table(""), &["--moment", "1 N mm"]);
    assert!(given.code == 2 && given.err.contains("a state keeps no more than"), "{}", given.err);
}

/// Whatever may head a column names it in a flag too.
#[test]
fn flags_know_columns_by_every_name_that_heads_them() {
    let fit = |head: &str, more: &[&str]| {
        let table = format!("turns_per_length [tpm],{head}\n200,-110\n300,-150\n");
        let ply = ["fit", "-", "--strands", "3", "--diameter", "0.5 mm", "--stiffness-ratio", "1"];
        call_with(&[&ply[..], &["--estimate", "stiffness_ratio", "--json"], more].concat(), table.as_bytes())
    };
    let plain = fit("ply_turns_per_length [tpm]", &["--error", "ply_turns_per_length=1%"]);
    assert_eq!(plain.code, 0, "{}", plain.err);
    for (head, name) in [
        ("turns_per_ply_length [tpm]", "turns_per_ply_length"),
        ("ply_turns_per_length [tpm]", "turns-per-ply-length"),
        ("Turns per ply length [tpm]", "Turns per ply length [tpm]"),
        ("turns_per_ply_length_turns_per_m", "turns_per_ply_length_turns_per_m"),
    ] {
        let named = fit(head, &["--error", &format!("{name}=1%")]);
        assert_eq!((named.out, named.code), (plain.out.clone(), 0), "{name}: {}", named.err);
    }
    let measured = fit("turns_per_ply_length [tpm]", &["--measured", "turns_per_ply_length"]);
    assert_eq!(measured.code, 0, "{}", measured.err);
    let both =
        fit("turns_per_ply_length [tpm]", &["--error", "turns_per_ply_length=1%", "--held", "ply_turns_per_length"]);
    assert!(both.code == 2 && both.err.contains("held or measured, not both"), "{}", both.err);
    // the errors of a column are none, nor is a unit of something else
    for wrong in ["ply_turns_per_length_error", "turns_per_ply_length [mm]", "extension"] {
        let refused = fit("turns_per_ply_length [tpm]", &["--error", &format!("{wrong}=1%")]);
        assert!(refused.code == 2 && refused.err.contains("is no column of the data"), "{wrong}: {}", refused.err);
    }
    let table = "force,extension\n0.1,0.95\n0.3,0.97\n";
    let ply = ["fit", "-", "--strands", "3", "--stiffness-ratio", "1", "--pretwist", "-0.5"];
    let asked = ["--estimate", "stiffness_ratio", "--error", "extension=1%"];
    let extension = call_with(&[&ply[..], &asked].concat(), table.as_bytes());
    assert_eq!(extension.code, 0, "{}", extension.err);
}

/// Residuals of everything measured stand over what is held and varies most, never over what is measured itself.
#[test]
fn residuals_stand_over_what_is_held() {
    let fit = |more: &[&str]| {
        let ply =
            ["fit", "examples/fit/strings.csv", "--strands", "2", "--diameter", "1 mm", "--strand-length", "0.5 m"];
        let stretch = ["--stretch", "--axial-stiffness", "3000 N", "--stiffness-ratio", "1", "--strand-twist", "0"];
        let asked = ["--bending-stiffness", "0.02 N mm^2", "--hand", "Z", "--estimate", "diameter", "--starts", "1"];
        out(&[&ply[..], &stretch, &asked, more].concat())
    };
    let axes = |said: &str, axis: &str| said.lines().filter(|line| line.trim() == axis).count();
    // turns, of five different numbers; loads, of three
    let said = fit(&[]);
    assert_eq!((axes(&said, "ply turns (turns)"), axes(&said, "moment (N mm)")), (2, 0), "{said}");
    // with nothing held that varies, a load that is measured
    let said = fit(&["--error", "ply_turns=0.01", "--error", "force=0.1 N"]);
    assert_eq!((axes(&said, "moment (N mm)"), axes(&said, "force (N)")), (3, 1), "{said}");
}

/// Of strings that do not stretch turns and lengths give the diameter, whatever their stiffness: none need be given.
#[test]
fn limp_strings_need_no_stiffness() {
    let table =
        "ply_turns,force [N],ply_length [mm],ply_length_error\n20,20,495.9,0.2\n60,20,463.2,0.2\n100,20,389.2,0.2\n";
    let fit = |table: &str, more: &[&str]| {
        let ply = ["fit", "-", "--strands", "2", "--diameter", "0.9 mm", "--strand-length", "0.5 m", "--hand", "Z"];
        call_with(&[&ply[..], more].concat(), table.as_bytes())
    };
    let asked = ["--estimate", "diameter", "--json"];
    let limp = fit(table, &asked);
    let report: Value = serde_json::from_str(&limp.out).expect(&limp.err);
    assert!(limp.out.contains("No stiffness is given"), "{}", limp.out);
    for stiffness in [["1", "1 N mm^2"], ["0.3", "20 N mm^2"]] {
        let strand = ["--stiffness-ratio", stiffness[0], "--bending-stiffness", stiffness[1], "--strand-twist", "0"];
        let stiff = fit(table, &[&asked[..], &strand].concat());
        assert!(!stiff.out.contains("No stiffness is given"), "{}", stiff.out);
        let stiff: Value = serde_json::from_str(&stiff.out).expect(&stiff.err);
        for name in ["value", "standard_error"] {
            near(number(estimate(&report, "diameter"), name), number(estimate(&stiff, "diameter"), name), 1e-6);
        }
    }
    // where it has a bearing it is asked for: on moments, and on a stiffness itself
    let moments = "ply_turns,force [N],moment [N mm],moment_error\n20,20,1.3,0.05\n60,20,4.1,0.05\n";
    for (table, asked) in [(moments, "diameter"), (table, "stiffness_ratio")] {
        let refused = fit(table, &["--estimate", asked]);
        assert!(refused.code == 2 && refused.err.contains("stiffness ratio C/B is missing"), "{}", refused.err);
    }
}
