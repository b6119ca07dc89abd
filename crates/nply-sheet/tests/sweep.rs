//! Tables of states: every row is what the same ply gives by itself, whichever way it was worked out and however the table was cut.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::float_cmp, reason = "helpers of tests")]

use nply_sheet::sweep::{States, Study, SweepFlags, Trail};
use nply_sheet::table::{Column, Kind, Values};
use nply_sheet::{Report, ShapeReport, Spec};

fn study(text: &str) -> Study {
    Study::from_spec(&Spec::from_toml("study.toml", text).unwrap(), &SweepFlags::default()).unwrap()
}

/// A cell as CSV has it.
fn cell(values: &Values, row: usize) -> String {
    match values.taken(&[row]) {
        Values::Float(cells) => cells[0].map_or(String::new(), |value| format!("{value:?}")),
        Values::Dense(cells) => format!("{:?}", cells[0]),
        Values::Integer(cells) => cells[0].map_or(String::new(), |value| value.to_string()),
        Values::Counts(cells) => cells[0].to_string(),
        Values::Boolean(cells) => cells[0].map_or(String::new(), |value| value.to_string()),
        Values::Text(cells) => cells[0].clone().unwrap_or_default(),
        Values::Words(cells) => cells[0].unwrap_or_default().to_owned(),
        _ => String::new(),
    }
}

/// A table as rows of text, by name.
struct Rows {
    names: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Rows {
    fn of(columns: &[Column], chunk: &[Values]) -> Self {
        assert_eq!(columns.len(), chunk.len());
        for (column, values) in columns.iter().zip(chunk) {
            assert_eq!(column.kind, values.kind(), "{}", column.name);
            assert_eq!(values.len(), chunk[0].len(), "{}", column.name);
        }
        let rows = (0..chunk[0].len()).map(|row| chunk.iter().map(|values| cell(values, row)).collect()).collect();
        Self { names: columns.iter().map(|column| column.name.clone()).collect(), rows }
    }

    fn whole(study: &Study) -> Self {
        Self::of(study.columns(), &study.chunk(0, usize::MAX))
    }

    fn get(&self, row: usize, name: &str) -> &str {
        let at =
            self.names.iter().position(|other| other == name).unwrap_or_else(|| panic!("{name}: {:?}", self.names));
        &self.rows[row][at]
    }

    fn number(&self, row: usize, name: &str) -> f64 {
        self.get(row, name).parse().unwrap_or_else(|_| panic!("{name} of row {row}: {:?}", self.rows[row]))
    }
}

/// A report's CSV as the same.
fn report(csv: &str) -> Rows {
    let mut lines = csv.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    Rows { names: lines.next().unwrap(), rows: lines.collect() }
}

fn near(a: f64, b: f64, digits: f64, what: &str) {
    assert!((a - b).abs() <= digits * a.abs().max(b.abs()).max(1e-3), "{what}: {a:e} {b:e}");
}

const YARN: &str = "ply.strands = 3\nstrand = { diameter = \"0.275 mm\", bending_stiffness = \"5e-10 N m^2\", stiffness_ratio = 0.75 }\n\
    twist.turns_per_length = \"470 turns/m\"\n";

#[test]
fn a_grid_is_so_many_single_solves() {
    let numbers =
        ["helical_angle_deg", "lay_length_m", "force_N", "interstrand_pressure_N_per_m", "torsional_stiffness_N_m2"];
    let text = format!(
        "{YARN}[sweep]\nload.force = {{ from = \"-1 mN\", to = \"3 mN\", count = 5 }}\nload.moment = [\"0 N m\", \"1e-7 N m\"]\n\
         outputs = [\"handedness\", \"stability\", \"separated\", \"helical_angle\", \"lay_length_m\", \"force_N\", \
         \"interstrand_pressure_N_per_m\", \"torsional_stiffness_N_m2\", \"margin_force_below\", \"margin_force_below_cause\"]\n"
    );
    let study = study(&text);
    assert!(study.is_fast());
    let table = Rows::whole(&study);
    assert_eq!(study.rows(), 10);
    let mut at = 0;
    for row in 0..10_usize {
        let force = ["-1 mN", "0 mN", "1 mN", "2 mN", "3 mN"][row / 2];
        let moment = ["0 N m", "1e-7 N m"][row % 2]; // the last varies fastest
        let flags = Spec::from_flags([("force", force), ("moment", moment)]).unwrap();
        let spec = Spec::from_toml("yarn.toml", YARN).unwrap().overridden_by(&flags);
        let single = report(&Report::of(spec.check().unwrap()).unwrap().csv());
        assert!(!single.rows.is_empty());
        for state in 0..single.rows.len() {
            assert_eq!(table.get(at, "row"), row.to_string());
            assert_eq!(table.get(at, "state"), (state + 1).to_string());
            for name in ["handedness", "stability", "separated", "margin_force_below_cause"] {
                assert_eq!(table.get(at, name), single.get(state, name), "{name} {row}");
            }
            for name in numbers {
                near(table.number(at, name), single.number(state, name), 1e-9, name);
            }
            assert_eq!(table.get(at, "reason"), "");
            at += 1;
        }
    }
    assert_eq!(at, table.rows.len());
}

#[test]
fn shapes_are_those_of_contact() {
    for lay in [
        "lay.helical_angle = { from = \"1 deg\", to = \"80 deg\", count = 7 }",
        "lay.pitch_angle = [\"10 deg\", \"1 deg\"]",
        "lay.lay_length = { from = \"10 mm\", to = \"50 mm\", count = 5, scale = \"log\" }",
        "lay.lay_ratio = [3, 4, 10]",
        "lay.radius_ratio = [2.1, 3]",
    ] {
        for outputs in ["", "outputs = [\"radius_ratio\", \"arclength_shift\", \"outer_diameter_mm\", \"strands\"]\n"] {
            let text = format!("strand.diameter = \"1 mm\"\n[sweep]\nply.strands = [2, 3, 6]\n{lay}\n{outputs}");
            let study = study(&text);
            assert!(study.is_fast(), "{text}");
            let table = Rows::whole(&study);
            assert_eq!(table.rows.len() as u64, study.rows());
            for row in 0..table.rows.len() {
                let given = &study.columns()[2];
                let unit = given.unit.clone();
                let value = format!("{} {unit}", table.get(row, &given.name));
                let flag = ["helical-angle", "pitch-angle", "lay-length", "lay-ratio", "radius-ratio"]
                    .into_iter()
                    .find(|flag| given.name.starts_with(&flag.replace('-', "_")))
                    .unwrap();
                let strands = table.get(row, "strands").to_owned();
                let flags = [("strands", strands.as_str()), ("diameter", "1 mm"), (flag, value.trim())];
                let single = Spec::from_flags(flags).unwrap().check_shape();
                match single.and_then(|shape| ShapeReport::of(shape, 0)) {
                    Ok(report) => {
                        let json: serde_json::Value = serde_json::from_str(&report.json()).unwrap();
                        near(table.number(row, "radius_ratio"), json["radius_ratio"].as_f64().unwrap(), 1e-14, "ρ");
                        near(
                            table.number(row, "arclength_shift"),
                            json["arclength_shift"].as_f64().unwrap(),
                            1e-14,
                            "x",
                        );
                        let diameter = json["si"]["outer_diameter"].as_f64().unwrap();
                        if outputs.is_empty() {
                            near(table.number(row, "outer_diameter_m"), diameter, 1e-14, "D");
                        } else {
                            near(table.number(row, "outer_diameter_mm"), 1e3 * diameter, 1e-14, "D");
                        }
                        assert_eq!(table.get(row, "reason"), "");
                    }
                    Err(error) => {
                        assert_eq!(
                            table.get(row, "radius_ratio").parse::<f64>().ok().filter(|_| flag != "radius-ratio"),
                            None
                        );
                        assert!(
                            table.get(row, "reason").ends_with(error.message().rsplit(':').next().unwrap()),
                            "{error}"
                        );
                    }
                }
            }
        }
    }
}

/// A study of each sort.
fn studies() -> Vec<Study> {
    let ply = "ply.strands = 3\nstrand.stiffness_ratio = 0.75\n";
    [
        format!("{YARN}[sweep]\nload.force = {{ from = \"-1 mN\", to = \"3 mN\", count = 51 }}\nply.strands = [2, 3, 13, 2.5, 7]\n"),
        format!("{ply}[sweep]\nsample = \"sobol\"\npoints = 700\ntwist.pretwist = {{ from = -2, to = 2 }}\nload.force = {{ from = -1, to = 1 }}\nply.strands = {{ from = 2, to = 12 }}\n"),
        format!("{ply}[sweep]\nsample = \"latin\"\npoints = 500\nseed = 3\ntwist.surface_angle = {{ from = \"-100 deg\", to = \"60 deg\" }}\nload.moment = {{ from = -1, to = 1 }}\nstates = \"stable\"\n"),
        format!("{ply}[sweep]\nsample = \"latin\"\npoints = 300\nlay.helical_angle = {{ from = \"-1 deg\", to = \"91 deg\" }}\noutputs = [\"radius_ratio\", \"pitch_angle\"]\n"),
        format!("{ply}twist.pretwist = -1\n[sweep]\nload.force = {{ from = 0, to = -2, count = 41 }}\nload.moment = [-1, 0, 0.5]\norder = \"grid\"\nquestion = \"supports\"\n"),
        format!("{ply}[sweep]\ntwist.pretwist = {{ from = -2, to = 2, count = 9 }}\nload.force = {{ from = -0.5, to = 0.5, count = 21 }}\nstates = \"continued\"\n"),
        format!("{ply}load.force = 0\n[sweep]\nlay.helical_angle = {{ from = \"1 deg\", to = \"80 deg\", count = 40 }}\ntwist.pretwist = {{ from = -1, to = 1, count = 40 }}\norder = \"zip\"\noutputs = [\"moment\"]\n"),
        format!("{YARN}[sweep]\nstrand.diameter = {{ from = \"0.1 mm\", to = \"0.4 mm\", count = 31 }}\n"),
    ]
    .iter()
    .map(|text| study(text))
    .collect()
}

#[test]
fn the_table_is_the_same_however_it_is_cut() {
    for study in studies() {
        let whole = Rows::whole(&study);
        assert!(whole.rows.len() as u64 >= study.rows(), "no row is lost");
        for step in [1_usize, 7, 64, 255] {
            let mut cut = Vec::new();
            let mut trail = Trail::default();
            let mut first = 0;
            while first < study.rows() {
                let chunk = if step == 7 { study.chunk(first, step) } else { study.chunk_on(&mut trail, first, step) };
                cut.extend(Rows::of(study.columns(), &chunk).rows);
                first += step as u64;
            }
            assert_eq!(cut, whole.rows, "{step} {}", study.text());
        }
        // each row of the study is there
        let rows: std::collections::BTreeSet<&String> = whole.rows.iter().map(|row| &row[0]).collect();
        assert_eq!(rows.len() as u64, study.rows());
    }
}

/// The same rows handed in from outside go the same way or another, and give the same.
#[test]
fn rows_from_outside_give_the_same() {
    for study in studies().into_iter().filter(|study| study.states() != States::Continued) {
        let count = study
            .columns()
            .iter()
            .position(|column| column.name == "state")
            .unwrap_or_else(|| study.columns().iter().position(|column| column.name == "radius_ratio").unwrap());
        let whole = study.chunk(0, usize::MAX);
        // one row of data each
        let Values::Counts(rows) = &whole[0] else { panic!() };
        let firsts: Vec<usize> = (0..rows.len()).filter(|at| *at == 0 || rows[at - 1] != rows[*at]).collect();
        let given: Vec<Column> = study.columns()[1..count].to_vec();
        let cells: Vec<Values> = whole[1..count].iter().map(|values| values.taken(&firsts)).collect();
        let (places, answers) = study.solve_given(&given, &cells).unwrap();
        let columns = study.given_columns(&given).unwrap();
        let (a, b) = (Rows::of(&study.columns()[count..], &whole[count..]), Rows::of(&columns, &answers));
        assert_eq!(places.iter().map(|place| *place as i64).collect::<Vec<_>>(), *rows);
        assert_eq!((a.names, a.rows), (b.names, b.rows));
        // with a column that has nothing to do with it the arrays are not used: to 1e-12 of an angle the answers are the same
        let mut slow_given = given.clone();
        let mut slow_cells = cells.clone();
        slow_given.push(Column::new("balance", Kind::Text));
        slow_cells.push(Values::Words(vec![Some("contact"); firsts.len()]));
        let (again, slow) = study.solve_given(&slow_given, &slow_cells).unwrap();
        let own: Vec<Column> = study.given_columns(&slow_given).unwrap();
        assert_eq!(again, places);
        let slow = Rows::of(&own, &slow);
        for (row, cells) in b_rows(&columns, &answers).into_iter().enumerate() {
            for (name, text) in columns.iter().map(|column| &column.name).zip(cells) {
                let other = slow.get(row, name);
                match (text.parse::<f64>(), other.parse::<f64>()) {
                    (Ok(a), Ok(b)) => near(a, b, 1e-8, name),
                    _ => assert_eq!(text, other, "{name} {row} {}", study.text()),
                }
            }
        }
    }
}

fn b_rows(columns: &[Column], chunk: &[Values]) -> Vec<Vec<String>> {
    Rows::of(columns, chunk).rows
}

#[test]
fn a_row_that_cannot_be_says_why_and_hurts_no_other() {
    let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-1")]).unwrap();
    let flags = SweepFlags { outputs: vec!["helical_angle".into()], ..SweepFlags::default() };
    let study = Study::from_spec(&ply, &flags).unwrap();
    let given = [Column::new("stiffness_ratio", Kind::Float), Column::new("note", Kind::Text)];
    let ratio = vec![Some(0.75), Some(-1.0), None, Some(f64::NAN), Some(0.75)];
    let (places, answers) = study.solve_given(&given, &[ratio.into(), Values::Nothing(Kind::Text, 5)]).unwrap();
    let table = Rows::of(&study.given_columns(&given).unwrap(), &answers);
    assert_eq!(places, [0, 0, 1, 2, 2, 3, 4, 4]);
    // an empty cell leaves the description's own, which goes another way
    near(table.number(0, "helical_angle_deg"), table.number(3, "helical_angle_deg"), 1e-13, "θ");
    assert_eq!(table.rows[0], table.rows[6]);
    assert!(table.get(2, "reason").contains("`stiffness_ratio = -1`: a stiffness ratio must be greater than 0"));
    assert!(table.get(5, "reason").contains("is not a finite number"), "{:?}", table.rows[5]);
    assert_eq!(table.get(2, "helical_angle_deg"), "");
    // no state is said too
    let none = study_of_no_state();
    assert_eq!(none.get(0, "reason"), "no state is in equilibrium with these data");
}

fn study_of_no_state() -> Rows {
    let text = "ply.strands = 2\nstrand.stiffness_ratio = 1\ntwist.pretwist = 0\n[sweep]\nload.force = [100]\n";
    Rows::whole(&study(text))
}

#[test]
fn a_state_is_followed_to_the_end_of_its_branch() {
    // in contact balance the pressing state of a given pretwist opens and ends as force falls; followed finely or coarsely it is the same
    let text = |count: u32| {
        format!(
            "ply.strands = 3\nstrand.stiffness_ratio = 0.75\ntwist.pretwist = -1\n[sweep]\n\
             load.force = {{ from = 1, to = -1, count = {count} }}\nstates = \"continued\"\noutputs = [\"helical_angle\", \"handedness\"]\n"
        )
    };
    let (coarse, fine) = (Rows::whole(&study(&text(11))), Rows::whole(&study(&text(2001))));
    for row in 0..11 {
        let other = row * 200;
        assert_eq!(coarse.get(row, "handedness"), fine.get(other, "handedness"), "{row}");
        if coarse.get(row, "reason").is_empty() && fine.get(other, "reason").is_empty() {
            near(coarse.number(row, "helical_angle_deg"), fine.number(other, "helical_angle_deg"), 1e-10, "θ");
        }
    }
    // and moves little from row to row, but where it begins anew
    let mut before: Option<f64> = None;
    for row in 0..fine.rows.len() {
        let here = fine.get(row, "helical_angle_deg").parse::<f64>().ok();
        if let (Some(before), Some(here)) = (before, here) {
            assert!((here - before).abs() < 3.0, "{row}: {before} {here}");
        }
        if here.is_none() {
            assert_eq!(fine.get(row, "reason"), "branch ended");
        }
        before = here;
    }
}

#[test]
fn what_is_written_wrong_is_told_in_a_sentence() {
    let ply = "ply.strands = 3\nstrand.stiffness_ratio = 0.75\n[sweep]\n";
    for (text, said) in [
        ("twist.pretwist = 3", "has one value here and does not vary"),
        ("twist.pretwst = [1]", "did you mean `pretwist`"),
        ("twist.pretwist = []", "a list of one value at least"),
        ("twist.pretwist = { from = 0, to = 1 }", "give a `count`"),
        ("twist.pretwist = { from = 0, to = 1, count = 0 }", "at least one value"),
        ("twist.pretwist = { from = 0, to = 1, count = 1.5 }", "whole `count`"),
        ("twist.pretwist = { from = 0, too = 1, count = 1 }", "no part of a range"),
        ("twist.pretwist = { from = -1, to = 1, count = 3, scale = \"log\" }", "on one side of 0"),
        ("load.force = [\"1 N\", 2]", "go not together"),
        ("load.force = [\"1 mm\"]", "is a length"),
        ("ply.title = [\"a\", \"b\"]", "one for the whole study"),
        ("strand.stretch = [true, false]", "one for the whole study"),
        ("outputs = [\"helical_angel\"]\ntwist.pretwist = [1]", "did you mean `helical_angle`"),
        ("outputs = [\"core_pressure\", \"separated\"]\ntwist.pretwist = [1]", "`question = \"supports\"` has it"),
        ("outputs = [\"lay_length_mm\"]\ntwist.pretwist = [1]", "none to measure it by"),
        ("outputs = []\ntwist.pretwist = [1]", "nothing is asked"),
        ("states = \"some\"\ntwist.pretwist = [1]", "all, stable or continued"),
        ("sample = \"sobol\"\ntwist.pretwist = { from = 0, to = 1 }", "number of points is missing"),
        ("sample = \"sobol\"\npoints = 10", "nothing varies"),
        ("points = 10\ntwist.pretwist = [1]", "goes with a sample"),
        (
            "sample = \"latin\"\npoints = 4\nstates = \"continued\"\ntwist.pretwist = { from = 0, to = 1 }",
            "no neighbours",
        ),
        ("order = \"zip\"\ntwist.pretwist = [1, 2]\nload.force = [1, 2, 3]", "as many (or one)"),
        ("rows = \"a.csv\"\ntwist.pretwist = [1, 2]", "leave one of the two out"),
        ("lay.helical_angle = [\"1 deg\"]\nstates = \"stable\"\nquestion = \"contact\"", "no equilibrium"),
        (
            "twist.pretwist = { from = 0, to = 1, count = 1e9 }\nload.force = { from = 0, to = 1, count = 1e9 }",
            "too large",
        ),
        ("outputz = []", "did you mean `outputs`"),
    ] {
        let error = Spec::from_toml("study.toml", &format!("{ply}{text}\n"))
            .and_then(|spec| Study::from_spec(&spec, &SweepFlags::default()).map(drop))
            .unwrap_err();
        assert!(error.to_string().contains(said), "{text}: {error}");
        assert!(error.line().is_some(), "{text}: {error}");
    }
    for (flag, said) in [
        ("pretwist", "what varies is missing"),
        ("pretwst=0:1:3", "did you mean `pretwist`"),
        ("pretwist=0:1:x", "no whole number"),
        ("pretwist=0:1:2:3:4", "this is no range"),
        ("pretwist=-3..3", "\"pretwist=-3..3\": a table's range is written with colons"),
        ("force=0:1 mm:3", "is a length"),
    ] {
        let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "0.75")]).unwrap();
        let flags = SweepFlags { sweep: vec![flag.into()], ..SweepFlags::default() };
        let error = Study::from_spec(&ply, &flags).unwrap_err().to_string();
        assert!(error.contains(said), "{flag}: {error}");
    }
}

#[test]
fn flags_say_what_a_file_says() {
    let ply = [("stiffness-ratio", "0.75"), ("diameter", "1 mm"), ("bending-stiffness", "1 N mm^2")];
    let flags = SweepFlags {
        sweep: vec![
            "twist.pretwist=-1:1:5".into(),
            "force=1:100 N:3:log".into(),
            "strands=2,3".into(),
            "moment=0,1,2 N mm".into(),
        ],
        outputs: vec!["helical_angle".into(), "lay_length_mm".into()],
        states: Some("stable".into()),
        ..SweepFlags::default()
    };
    let by_flags = Study::from_spec(&Spec::from_flags(ply).unwrap(), &flags).unwrap();
    let by_file = study(
        "ply.strands = 3\nstrand = { stiffness_ratio = 0.75, diameter = \"1 mm\", bending_stiffness = \"1 N mm^2\" }\n[sweep]\n\
         twist.pretwist = { from = -1, to = 1, count = 5 }\nload.force = { from = \"1 N\", to = \"100 N\", count = 3, scale = \"log\" }\n\
         ply.strands = [2, 3]\n",
    );
    assert!(by_file.rows() * 3 == by_flags.rows());
    let again = study(&by_flags.text());
    assert_eq!(again.text(), by_flags.text());
    let (a, b) = (Rows::whole(&by_flags), Rows::whole(&again));
    assert_eq!((a.names, a.rows), (b.names, b.rows));
    // both ends of a range are as they were written, and the middle of equal ratios is the root
    let table = Rows::whole(&by_file);
    let forces: std::collections::BTreeSet<&str> = (0..table.rows.len()).map(|row| table.get(row, "force_N")).collect();
    assert_eq!(forces.into_iter().collect::<Vec<_>>(), ["1.0", "10.0", "100.0"]);
}

#[test]
fn a_column_is_known_by_its_name_and_unit() {
    let ply = Spec::from_flags([("strands", "3"), ("diameter", "1 mm")]).unwrap();
    let flags = SweepFlags { outputs: vec!["radius_ratio".into()], ..SweepFlags::default() };
    let study = Study::from_spec(&ply, &flags).unwrap();
    let ratio = |column: Column, value: Values| {
        let (_, answers) = study.solve_given(std::slice::from_ref(&column), &[value])?;
        Ok::<f64, nply_sheet::SpecError>(cell(&answers[0], 0).parse().unwrap_or(f64::NAN))
    };
    let number = |value: f64| Values::Dense(vec![value]);
    let wanted = ratio(Column::new("lay_length_mm", Kind::Float), number(10.0)).unwrap();
    for (column, value) in [
        (Column::new("lay.lay_length", Kind::Float).with_unit("mm"), number(10.0)),
        (Column::new("lay_length_m", Kind::Float), number(0.01)),
        (Column::new("lay_length_m", Kind::Float).with_unit("m"), number(0.01)),
        (Column::new("lay_length", Kind::Text), Values::Words(vec![Some("1 cm")])),
        (Column::new("lay-length", Kind::Text), Values::Words(vec![Some("10 mm")])),
        (Column::new("ply_turns_per_length_turns_per_m", Kind::Float), number(100.0)),
        (Column::new("lay.turns_per_length_turns_per_m", Kind::Float), number(100.0)),
    ] {
        near(ratio(column.clone(), value).unwrap(), wanted, 1e-13, &column.name);
    }
    for (column, said) in [
        (Column::new("lay_length_mm", Kind::Float).with_unit("m"), "its name says mm"),
        (Column::new("lay_length", Kind::Float).with_unit("N"), "what is wanted is a length"),
        (Column::new("lay_length", Kind::Float).with_unit("mmm"), "no unit"),
        (Column::new("helical_angle", Kind::Float), "its unit is missing"),
        (Column::new("colour", Kind::Float), "no column is a datum"),
    ] {
        let error = ratio(column, number(10.0)).unwrap_err().to_string();
        assert!(error.contains(said), "{error}");
    }
}
