//! What scripts rely on of `nply trace`, `nply map` and `nply locus`: numbers that agree with `nply solve`, files that are whole or none.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::collections::BTreeMap;
use std::fs;
use std::io::Read as _;
use std::path::PathBuf;
use std::process::Stdio;

use arrow_array::Array as _;
use arrow_array::cast::AsArray as _;
use arrow_array::types::{Float64Type, Int64Type};
use command::{Answer, answer, call, command, json, number, out, states};
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use serde_json::Value;

const RODS: [&str; 6] = ["--strands", "3", "--stiffness-ratio", "0.75", "--pretwist", "-0.2"];

/// An empty folder for the files of one test.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("studies").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn files(folder: &PathBuf) -> Vec<String> {
    fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

/// Rows of a table, each by column name.
fn rows(table: &str) -> Vec<BTreeMap<String, String>> {
    let mut lines = table.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells.len(), head.len(), "{line}");
        head.iter().zip(cells).map(|(key, cell)| ((*key).to_owned(), cell.to_owned())).collect()
    };
    lines.map(row).collect()
}

/// The points of a map in any order: the two data as written, and the states there.
type Points = BTreeMap<(String, String), Vec<BTreeMap<String, String>>>;

fn points(table: &str, axes: [&str; 2]) -> Points {
    let mut found = Points::new();
    for row in rows(table) {
        let key = (row[axes[0]].clone(), row[axes[1]].clone());
        found.entry(key).or_default().push(row);
    }
    found
}

fn cell(row: &BTreeMap<String, String>, name: &str) -> f64 {
    row[name].parse().unwrap_or_else(|_| panic!("{name} of {row:?}"))
}

#[track_caller]
fn close(found: f64, expected: f64, what: &dyn std::fmt::Debug) {
    assert!((found - expected).abs() < 1e-9, "{found} is not {expected}: {what:?}");
}

/// The states of a map's point are those of `nply solve` with the same data.
#[track_caller]
fn as_solved(ply: &[&str], axes: [&str; 2], ranges: &[&str], holding: &str) {
    let [columns, up] = ["--columns", "--rows"];
    let table = out(&[&["map"], ply, ranges, &[columns, "7", up, "5"]].concat());
    let found = points(&table, axes);
    assert_eq!(found.len(), 35);
    let mut states_seen = 0;
    for ((x, y), rows) in found.iter().step_by(3) {
        let flags = axes.map(|axis| format!("--{}", axis.replace('_', "-")));
        let report = json(&[&["solve"], ply, &[&flags[0], x, &flags[1], y, "--json"]].concat());
        let solved = states(&report);
        assert_eq!(cell(&rows[0], "states") as usize, solved.len(), "{x} {y}");
        if solved.is_empty() {
            assert!(rows.len() == 1 && rows[0]["state"].is_empty() && rows[0]["helical_angle_deg"].is_empty());
            continue;
        }
        assert_eq!(rows.len(), solved.len());
        for (i, (row, state)) in rows.iter().zip(solved).enumerate() {
            states_seen += 1;
            assert_eq!(cell(row, "state") as usize, i + 1);
            assert_eq!(row["handedness"], state["handedness"].to_string(), "{x} {y}");
            for name in ["helical_angle_deg", "resultant_pressure", "interstrand_pressure"] {
                close(cell(row, name), number(state, name), &(x, y, name, i));
            }
            let separated = number(state, "interstrand_pressure") < 0.0;
            assert_eq!(row["separated"], separated.to_string(), "{x} {y}");
            let verdict = state["stability_by_holding"][holding].as_str().unwrap_or("");
            assert_eq!(row["stability"], verdict, "{x} {y}");
        }
    }
    assert!(states_seen > 5, "{table}");
}

#[test]
fn a_map_has_the_states_of_each_point() {
    let loads = ["--from-force", "-0.7", "--to-force", "1.1", "--from-moment", "-2.1", "--to-moment", "1.9"];
    as_solved(&RODS, ["force", "moment"], &loads, "dead_loads");
    let radial = [&RODS[..], &["--balance", "radial"]].concat();
    as_solved(&radial, ["force", "moment"], &loads, "dead_loads");
    let twists = ["--from-pretwist", "-2", "--to-pretwist", "2", "--from-force", "-0.3", "--to-force", "0.6"];
    as_solved(&[&RODS[..4], &["--moment", "0.2"]].concat(), ["pretwist", "force"], &twists, "dead_loads");
    let ratios = ["--from-stiffness-ratio", "0.4", "--to-stiffness-ratio", "1.3"];
    let given = ["--strands", "2", "--pretwist", "0.8"];
    let flags = [&ratios[..], &["--from-moment", "-0.2", "--to-moment", "0.3"]].concat();
    as_solved(&given, ["stiffness_ratio", "moment"], &flags, "dead_loads");
}

/// Across and up changed over, and ranges the other way round: the same points with the same states.
#[test]
fn a_map_does_not_depend_on_how_it_is_asked() {
    let across = ["--from-force", "-0.5", "--to-force", "0.5"];
    let up = ["--from-moment", "-2", "--to-moment", "1"];
    let counts = ["--columns", "5", "--rows", "9"];
    let turned = ["--columns", "9", "--rows", "5"];
    let axes = ["force", "moment"];
    let forwards = points(&out(&[&["map"], &RODS[..], &across, &up, &counts].concat()), axes);
    let other_way = points(&out(&[&["map"], &RODS[..], &up, &across, &turned].concat()), axes);
    let back = ["--from-force", "0.5", "--to-force", "-0.5", "--from-moment", "1", "--to-moment", "-2"];
    let backwards = points(&out(&[&["map"], &RODS[..], &back, &counts].concat()), axes);
    assert_eq!(forwards.len(), 45);
    for other in [other_way, backwards] {
        assert_eq!(other.len(), 45);
        for (point, states) in &forwards {
            let same = &other[point];
            assert_eq!(same.len(), states.len(), "{point:?}");
            for (a, b) in states.iter().zip(same) {
                for name in ["states", "state", "handedness", "separated", "stability", "support"] {
                    assert_eq!(a[name], b[name], "{point:?} {name}");
                }
                for name in ["helical_angle_deg", "resultant_pressure", "interstrand_pressure"] {
                    close(cell(a, name), cell(b, name), &(point, name));
                }
            }
        }
    }
}

/// The sizes of a map are those of the file, and in SI beside where a size is known.
#[test]
fn a_map_is_read_back_from_parquet() {
    let folder = folder("parquet");
    let map = ["map", "tests/inputs/ok/map_with_units.toml", "--quiet"];
    let whole = folder.join("map.parquet");
    let told = out(&[&map[..], &["--output", whole.to_str().unwrap()]].concat());
    assert!(told.contains("3 × 3 points") && told.contains(" N\n"), "{told}");
    assert_eq!(files(&folder), ["map.parquet"]);
    let expected = rows(&out(&map));
    let reader = ParquetRecordBatchReaderBuilder::try_new(fs::File::open(&whole).unwrap()).unwrap();
    let said = reader.metadata().file_metadata().key_value_metadata().unwrap().clone();
    for (key, value) in [
        ("pretwist", "-0.2"),
        ("stiffness_ratio", "0.75"),
        ("strand_radius_m", "0.001"),
        ("program", "nply"),
        ("version", env!("CARGO_PKG_VERSION")),
        ("strands", "3"),
        ("balance", "contact"),
    ] {
        assert!(said.iter().any(|pair| pair.key == key && pair.value.as_deref() == Some(value)), "{key}: {said:?}");
    }
    let units: Vec<(String, String)> = reader
        .schema()
        .fields()
        .iter()
        .filter_map(|field| Some((field.name().clone(), field.metadata().get("unit")?.clone())))
        .collect();
    let expected_units: [(String, String); 3] = [
        ("rotation_turns_per_m".into(), "turns/m".into()),
        ("force_N".into(), "N".into()),
        ("helical_angle_deg".into(), "deg".into()),
    ];
    assert_eq!(units, expected_units);
    let mut row = 0;
    for batch in reader.build().unwrap() {
        let batch = batch.unwrap();
        for i in 0..batch.num_rows() {
            let expected = &expected[row];
            for name in ["rotation", "force", "force_N", "helical_angle_deg", "interstrand_pressure"] {
                let column = batch.column_by_name(name).unwrap().as_primitive::<Float64Type>();
                let read = column.is_valid(i).then(|| column.value(i).to_bits());
                assert_eq!(read, expected[name].parse::<f64>().ok().map(f64::to_bits), "{row} {name}");
            }
            for name in ["states", "state", "handedness"] {
                let column = batch.column_by_name(name).unwrap().as_primitive::<Int64Type>();
                let read = column.is_valid(i).then(|| column.value(i));
                assert_eq!(read, expected[name].parse().ok(), "{row} {name}");
            }
            let texts = batch.column_by_name("support").unwrap().as_string::<i32>();
            assert_eq!(if texts.is_valid(i) { texts.value(i) } else { "" }, expected["support"]);
            row += 1;
        }
    }
    assert_eq!(row, expected.len());
}

/// A map is the same bytes with one thread as with two, and from a file as from flags.
#[test]
fn threads_leave_no_trace() {
    let folder = folder("jobs");
    let ranges = ["--from-force", "-1", "--to-force", "1", "--from-moment", "-2", "--to-moment", "2"];
    let counts = ["--columns", "31", "--rows", "150", "--quiet"];
    let made = |jobs: &str, name: &str| {
        let (table, picture) = (folder.join(name), folder.join(format!("{name}.svg")));
        let files = ["--jobs", jobs, "--output", table.to_str().unwrap(), "--plot", picture.to_str().unwrap()];
        let told = out(&[&["map"], &RODS[..], &ranges, &counts, &files].concat());
        (told, fs::read(table).unwrap(), fs::read(picture).unwrap())
    };
    for kind in ["csv", "parquet"] {
        let (one, two) = (made("1", &format!("one.{kind}")), made("2", &format!("two.{kind}")));
        assert!(one == two, "{kind}: {} {}", one.0, two.0);
        assert!(one.1.len() > 1000 && one.2.starts_with(b"<svg"));
    }
    let printed = out(&[&["map"], &RODS[..], &ranges, &counts].concat());
    assert_eq!(printed.as_bytes(), fs::read(folder.join("one.csv")).unwrap());
}

/// Where a path arrives, `nply solve` and `nply support` know that state with the same numbers.
#[test]
fn a_path_ends_at_a_state_of_its_last_data() {
    let held = ["--ply-turns-per-strand-length", "0.03"];
    type Flags<'f> = &'f [&'f str];
    let cases: [(&str, Flags, Flags, Flags); 4] = [
        ("solve", &[], &["--to-force", "1", "--to-moment", "-1.3"], &["--force", "1", "--moment", "-1.3"]),
        ("solve", &["--balance", "radial"], &["--to-pretwist", "-0.9"], &["--pretwist", "-0.9"]),
        ("solve", &held, &["--to-force", "0.4"], &["--force", "0.4"]),
        ("support", &["--support-core-radius", "0.3"], &["--to-force", "0.4"], &["--force", "0.4"]),
    ];
    for (command, given, to, there) in cases {
        let ply = [&RODS[..], given].concat();
        let trace = json(&[&["trace"], &ply[..], to, &["--json"]].concat());
        let leg = &trace["legs"].as_array().unwrap()[0];
        assert_eq!(leg["end"], "arrival", "{to:?}");
        let last = leg["stations"].as_array().unwrap().last().unwrap();
        assert_eq!(last["along"], 1.0);
        // flags may stand once: the last of them is what the path leads to
        let ply: Vec<&str> = if there[0] == "--pretwist" { [&RODS[..4], given].concat() } else { ply };
        let report = json(&[&[command], &ply[..], there, &["--json"]].concat());
        let same = |state: &&Value| {
            let away = number(state, "helical_angle_deg") - number(last, "helical_angle_deg");
            state["handedness"] == last["handedness"] && away.abs() < 1e-9
        };
        let state = states(&report).iter().find(same).unwrap_or_else(|| panic!("{to:?}: {last}"));
        for name in
            ["radius_ratio", "extension", "force", "moment", "resultant_pressure", "interstrand_pressure", "pretwist"]
        {
            close(number(last, name), number(state, name), &(to, name));
        }
        let holding = leg["holding"].as_str().unwrap();
        assert_eq!(last["stability"], state["stability_by_holding"][holding], "{to:?}");
        // the CSV has every station, the last of them this one
        let csv = rows(&out(&[&["trace"], &[&RODS[..], given].concat()[..], to, &["--format", "csv"]].concat()));
        assert_eq!(csv.len(), leg["stations"].as_array().unwrap().len());
        assert_eq!(
            cell(csv.last().unwrap(), "helical_angle_deg").to_bits(),
            number(last, "helical_angle_deg").to_bits()
        );
    }
}

#[track_caller]
fn refused(found: &Answer, status: i32, part: &str) {
    assert_eq!((found.code, found.out.as_str()), (status, ""), "{}", found.err);
    assert!(found.err.starts_with("error: ") && found.err.contains(part), "{}", found.err);
}

#[test]
fn what_flags_get_wrong_is_said() {
    let trace = |more: &[&str]| call(&[&["trace"], &RODS[..], more].concat());
    refused(&trace(&[]), 2, "the path is missing");
    refused(&call(&["trace", "examples/rubber-rods.toml"]), 2, "the path is missing");
    refused(&trace(&["--to-force", "1", "--start", "9"]), 1, "--start: 9 is the number of no state: there is one");
    refused(&trace(&["--to-force", "1", "--start", "0"]), 2, "--start");
    refused(&trace(&["--to-support-core-radius", "0.2"]), 2, "--to-support-core-radius");
    refused(&trace(&["--to-strand-twist", "0.2"]), 2, "--to-strand-twist");
    for limit in ["-0.1", "0", "nan", "inf"] {
        let limit = format!("--curvature-limit={limit}");
        refused(&trace(&["--to-force", "1", &limit]), 1, "--curvature-limit");
    }
    let map = |more: &[&str]| call(&[&["map"], &RODS[..], more].concat());
    refused(&map(&[]), 2, "the rectangle is missing");
    refused(&map(&["--to-force", "1"]), 2, "only `--to-force \"1\"` is given");
    refused(&map(&["--to-force", "1", "--to-moment", "1", "--columns", "0"]), 2, "--columns");
    refused(
        &map(&["--to-force", "1", "--to-moment", "1", "--rows", "100001"]),
        1,
        "--rows: a map has 1 to 100000 rows",
    );
    refused(&call(&["map", "tests/inputs/ok/map_of_loads.toml", "--columns", "200000"]), 1, "--columns: a map has");
    refused(&call(&["locus", "--strands", "3", "--stiffness-ratio", "1"]), 2, "the twist is missing");
    for points in ["1", "10000001"] {
        refused(&call(&[&["locus"], &RODS[..], &["--points", points]].concat()), 1, "--points: a curve has 2 to");
    }
}

/// A file that cannot be written ends with 3 and one sentence, and nothing is left.
#[test]
fn files_that_cannot_be_written_end_with_3() {
    let folder = folder("unwritable");
    let missing = folder.join("missing/picture.svg");
    let there = folder.to_str().unwrap();
    let to = ["--to-force", "1"];
    let rectangle = ["--to-force", "1", "--to-moment", "1", "--columns", "3", "--rows", "3", "--quiet"];
    for wrong in [missing.to_str().unwrap(), there] {
        refused(&call(&[&["trace"], &RODS[..], &to, &["--plot", wrong]].concat()), 3, "cannot write");
        refused(&call(&[&["locus"], &RODS[..], &["--plot", wrong]].concat()), 3, "cannot write");
        refused(&call(&[&["map"], &RODS[..], &rectangle, &["--plot", wrong]].concat()), 3, "cannot write");
        refused(&call(&[&["map"], &RODS[..], &rectangle, &["--output", wrong]].concat()), 3, "cannot write");
    }
    assert_eq!(files(&folder), [""; 0]);
}

#[cfg(unix)]
#[test]
fn a_folder_that_may_not_be_written_to_ends_with_3() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = folder("read only");
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o555)).unwrap();
    // root may write anywhere
    if fs::write(folder.join("allowed"), "").is_err() {
        let table = folder.join("map.csv");
        let rectangle = ["--to-force", "1", "--to-moment", "1", "--columns", "3", "--rows", "3"];
        let found = call(&[&["map"], &RODS[..], &rectangle, &["--output", table.to_str().unwrap()]].concat());
        refused(&found, 3, "cannot write");
    }
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o755)).unwrap();
}

/// An old table stays as it is until the new one is whole.
#[test]
fn a_table_is_replaced_as_a_whole() {
    let folder = folder("replaced");
    let table = folder.join("map.csv");
    fs::write(&table, "old").unwrap();
    let rectangle = ["--to-force", "1", "--to-moment", "1", "--columns", "3", "--rows", "3", "--quiet"];
    let map = [&["map"], &RODS[..], &rectangle].concat();
    out(&[&map[..], &["--output", table.to_str().unwrap()]].concat());
    assert_eq!(fs::read_to_string(&table).unwrap(), out(&map));
    assert_eq!(files(&folder), ["map.csv"]);
}

#[test]
fn a_closed_pipe_is_no_error() {
    let large = ["--to-force", "1", "--to-moment", "1", "--columns", "100", "--rows", "400"];
    let studies: [Vec<&str>; 3] = [
        [&["map"], &RODS[..], &large].concat(),
        [&["trace"], &RODS[..], &["--to-force", "1", "--json"]].concat(),
        [&["locus"], &RODS[..], &["--points", "5000", "--json"]].concat(),
    ];
    for arguments in &studies {
        let mut child = command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut pipe = child.stdout.take().unwrap();
        pipe.read_exact(&mut [0]).unwrap();
        drop(pipe);
        let found = answer(&child.wait_with_output().unwrap());
        assert_eq!((found.code, found.err.as_str()), (0, ""), "{arguments:?}");
    }
}

/// Ctrl-C while a map is worked out: 130, no draft is left, and the table that stood there still stands.
#[cfg(unix)]
#[test]
fn an_interrupted_map_leaves_what_was_there() {
    use std::process::Command;
    use std::time::{Duration, Instant};
    let folder = folder("interrupted");
    for name in ["map.csv", "map.parquet"] {
        let table = folder.join(name);
        if name == "map.csv" {
            fs::write(&table, "old").unwrap();
        }
        let large = ["--to-force", "1", "--to-moment", "1", "--columns", "300", "--rows", "100000", "--jobs", "1"];
        let files = ["--output", table.to_str().unwrap(), "--quiet"];
        let mut child = command(&[&["map"], &RODS[..], &large, &files].concat())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // the draft is there once the work has begun
        let draft = folder.join(format!("{name}.{}.part", child.id()));
        let begin = Instant::now();
        while !draft.exists() {
            if begin.elapsed() > Duration::from_secs(20) || child.try_wait().unwrap().is_some() {
                let _ = child.kill();
                panic!("no draft: {:?}", child.wait_with_output());
            }
            std::thread::sleep(Duration::from_millis(5));
        }
        let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        assert!(sent.success());
        let found = answer(&child.wait_with_output().unwrap());
        assert_eq!((found.code, found.out.as_str()), (130, ""), "{}", found.err);
        assert!(begin.elapsed() < Duration::from_secs(60));
    }
    assert_eq!(files(&folder), ["map.csv"]);
    assert_eq!(fs::read_to_string(folder.join("map.csv")).unwrap(), "old");
}

/// The loads of the locus are loads at which `nply solve` finds a state whose pressure is nothing.
#[test]
fn a_locus_is_where_the_pressure_is_nothing() {
    let csv = rows(&out(&[&["locus"], &RODS[..], &["--points", "40", "--format", "csv"]].concat()));
    assert_eq!(csv.len(), 80);
    let inner = csv.iter().filter(|row| (5.0..80.0).contains(&cell(row, "helical_angle_deg")));
    let mut count = 0;
    for row in inner.step_by(9) {
        let loads = ["--force", &row["force"], "--moment", &row["moment"], "--json"];
        let report = json(&[&["solve"], &RODS[..], &loads].concat());
        let away = |state: &Value| (number(state, "helical_angle_deg") - cell(row, "helical_angle_deg")).abs();
        let same = |state: &&Value| {
            number(state, "handedness").total_cmp(&cell(row, "handedness")).is_eq() && away(state) < 1e-6
        };
        let state = states(&report).iter().find(same).unwrap_or_else(|| panic!("{row:?}"));
        assert!(number(state, "resultant_pressure").abs() < 1e-9, "{row:?}");
        count += 1;
    }
    assert!(count > 5);
}
