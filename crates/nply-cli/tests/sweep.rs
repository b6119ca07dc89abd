//! `nply sweep` as a script calls it: the same bytes whatever the number of threads and whatever came between; nothing lost, nothing damaged.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use command::{call, command, near, out, root};
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;

/// An empty folder of one's own.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("sweep").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

fn left(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Rows of a Parquet file.
fn rows(path: &Path) -> usize {
    let batches = ParquetRecordBatchReaderBuilder::try_new(File::open(path).unwrap()).unwrap().build().unwrap();
    batches.map(|batch| batch.unwrap().num_rows()).sum()
}

/// A study that takes its time: states one by one, some with reasons.
const SLOW: [&str; 11] = [
    "sweep",
    "--strands",
    "3",
    "--question",
    "supports",
    "--pretwist",
    "-1",
    "--sweep",
    "stiffness_ratio=-0.1,0.7,0.8,1",
    "--sweep",
    "force=1:-1:15000",
];

/// The same without the wait.
fn study(more: &[&'static str]) -> Vec<&'static str> {
    SLOW.iter().copied().chain(more.iter().copied()).collect()
}

#[test]
fn the_examples_are_answered() {
    let table = out(&["sweep", "examples/studies/yarn-twist.toml"]);
    let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let at = |name: &str| names.iter().position(|other| *other == name).unwrap();
    // as `nply solve examples/three-ply-yarn.toml` has it
    let row = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>())
        .find(|cells| cells[at("strands")] == "3" && cells[at("turns_per_length_turns_per_m")] == "470.0")
        .unwrap();
    near(row[at("helical_angle_deg")].parse().unwrap(), 20.5812, 1e-5);
    near(row[at("lay_length_mm")].parse().unwrap(), 2.70824, 1e-5);
    let folder = folder("examples");
    let file = folder.join("tolerance.parquet");
    assert_eq!(out(&["sweep", "examples/studies/yarn-tolerance.toml", "--output", text(&file)]), "");
    assert_eq!((rows(&file), left(&folder)), (4096, vec!["tolerance.parquet".to_owned()]));
    let builder = ParquetRecordBatchReaderBuilder::try_new(File::open(&file).unwrap()).unwrap();
    let pairs = builder.metadata().file_metadata().key_value_metadata().unwrap();
    let said = |key: &str| pairs.iter().find(|pair| pair.key == key).unwrap().value.clone().unwrap();
    assert_eq!((said("version").as_str(), said("question").as_str()), (env!("CARGO_PKG_VERSION"), "contact"));
    assert!(said("study").contains("sample = \"sobol\""));
    assert_eq!(builder.schema().field_with_name("outer_diameter_mm").unwrap().metadata()["unit"], "mm");
}

#[test]
fn threads_give_the_same_bytes() {
    let folder = folder("threads");
    for ending in ["csv", "parquet", "arrow"] {
        let write = |jobs: &str, name: &str| {
            let file = folder.join(format!("{name}.{ending}"));
            let mut arguments = vec!["sweep", "--strands", "3", "--stiffness-ratio", "0.75", "--jobs", jobs];
            arguments.extend(["--sweep", "pretwist=-2:2:501", "--sweep", "force=-1:1:301", "--output", text(&file)]);
            assert_eq!(out(&arguments), "");
            fs::read(file).unwrap()
        };
        let (one, three) = (write("1", "one"), write("3", "three"));
        assert!(one == three && one.len() > 100_000, "{ending}");
    }
}

/// Ends a run with a signal after a while; whether it was still running.
fn ended(arguments: &[&str], signal: &str, after: u64) -> Option<i32> {
    let mut child = command(arguments).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    sleep(Duration::from_millis(after));
    let id = child.id().to_string();
    let sent = Command::new("kill").args([signal, &id]).stderr(Stdio::null()).status().unwrap();
    let status = child.wait().unwrap();
    assert!(sent.success() || status.success());
    status.code()
}

#[test]
fn what_was_ended_goes_on_to_the_same_bytes() {
    let folder = folder("resume");
    for ending in ["parquet", "csv", "arrow"] {
        let whole = folder.join(format!("whole.{ending}"));
        assert_eq!(out(&study(&["--output"]).iter().copied().chain([text(&whole)]).collect::<Vec<_>>()), "");
        let file = folder.join(format!("ended.{ending}"));
        let arguments: Vec<&str> = study(&["--output"]).into_iter().chain([text(&file), "--resume"]).collect();
        let (mut ends, mut after) = (0, 250);
        // killed and interrupted in turn, later and later, until it comes to its end
        while !file.exists() {
            let signal = if ends % 2 == 0 { "-KILL" } else { "-INT" };
            let code = ended(&arguments, signal, after);
            ends += 1;
            after += 170;
            assert!(ends < 60);
            let part = folder.join(format!("ended.{ending}.part"));
            if code == Some(130) {
                // what Ctrl-C leaves can be read
                match ending {
                    "parquet" => assert!(rows(&part) <= rows(&whole)),
                    "csv" => {
                        let (part, whole) = (fs::read_to_string(&part).unwrap(), fs::read_to_string(&whole).unwrap());
                        assert!(whole.starts_with(&part) && part.ends_with('\n'));
                    }
                    _ => assert!(fs::read(&part).unwrap().ends_with(b"ARROW1")),
                }
            }
        }
        assert!(ends > 2, "{ending}: it was never ended");
        assert!(fs::read(&file).unwrap() == fs::read(&whole).unwrap(), "{ending}: {ends} ends");
        let again = call(&arguments);
        assert!((again.code, again.out.contains("is whole")) == (0, true), "{}", again.err);
    }
    assert_eq!(left(&folder).len(), 6);
}

#[test]
fn a_beginning_is_neither_overwritten_nor_taken_for_another() {
    let folder = folder("beginnings");
    let file = folder.join("a.parquet");
    let with = |more: &[&'static str]| -> Vec<String> {
        study(&["--output"])
            .into_iter()
            .map(str::to_owned)
            .chain([text(&file).to_owned()])
            .chain(more.iter().map(|word| (*word).to_owned()))
            .collect()
    };
    let call = |arguments: &[String]| call(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
    let arguments = with(&[]);
    let code = ended(&arguments.iter().map(String::as_str).collect::<Vec<_>>(), "-INT", 600);
    assert_eq!(code, Some(130));
    assert_eq!(left(&folder), ["a.parquet.part", "a.parquet.part.log"]);
    let before = fs::read(folder.join("a.parquet.part")).unwrap();
    let again = call(&arguments);
    assert_eq!(again.code, 3);
    assert!(again.err.contains("go on with it by --resume, or remove it"), "{}", again.err);
    let other = call(&with(&["--resume", "--states", "stable"]));
    assert_eq!(other.code, 3);
    assert!(other.err.contains("the beginning of another table"), "{}", other.err);
    assert_eq!(fs::read(folder.join("a.parquet.part")).unwrap(), before);
}

#[test]
fn given_rows_are_answered_in_their_order() {
    let folder = folder("rows");
    let given = folder.join("lays.csv");
    fs::write(&given, "\u{feff}batch,lay_length_mm,strands\na,2.7,3\n\"b, c\",x,3\nd,0.1,3\ne,2.7,\nf,5 mm,3\n")
        .unwrap();
    let ask =
        ["sweep", "--strands", "2", "--diameter", "0.275 mm", "--outputs", "helical_angle", "--rows", text(&given)];
    let table = out(&ask);
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines[0], "batch,lay_length_mm,strands,helical_angle_deg,reason");
    assert_eq!(lines.len(), 6);
    assert!(lines[1].starts_with("a,2.7,3,20.6") && lines[1].ends_with(','), "{}", lines[1]);
    assert!(
        lines[2].starts_with("\"b, c\",x,3,,") && lines[2].contains("does not begin with a number"),
        "{}",
        lines[2]
    );
    assert!(
        lines[3].starts_with("d,0.1,3,,") && lines[3].contains("no ply has it: it must be finite and greater"),
        "{}",
        lines[3]
    );
    assert!(lines[4].starts_with("e,2.7,,"), "an empty cell leaves the description's own");
    assert!(lines[5].starts_with("f,5 mm,3,11."), "{}", lines[5]);
    // a table of ours is a table of rows again
    let parquet = folder.join("grid.parquet");
    let sweep = [
        "sweep",
        "--diameter",
        "0.275 mm",
        "--sweep",
        "strands=2,3",
        "--sweep",
        "lay_length=2:5 mm:30",
        "--outputs",
        "arclength_shift",
    ];
    assert_eq!(out(&[&sweep[..], &["--output", text(&parquet)]].concat()), "");
    let of_rows = |asked| ["sweep", "--diameter", "0.275 mm", "--outputs", asked, "--rows", text(&parquet)];
    let again = call(&of_rows("radius_ratio"));
    assert_eq!((again.code, again.err.contains("reason of ")), (0, true), "{}", again.err);
    let lines: Vec<&str> = again.out.lines().collect();
    assert_eq!((lines[0], lines.len()), ("row,strands,lay_length_mm,arclength_shift,radius_ratio,reason", 61));
    let twice = call(&of_rows("arclength_shift"));
    assert_eq!((twice.code, twice.err.contains("would stand in the table twice")), (2, true), "{}", twice.err);
}

#[test]
fn trouble_is_told_in_a_sentence_and_damages_nothing() {
    let folder = folder("trouble");
    let name = |name: &str| text(&folder.join(name)).to_owned();
    let grid = |more: &[&str]| -> Vec<String> {
        ["sweep", "--strands", "3", "--sweep", "helical_angle=1 deg:80 deg:300000"]
            .iter()
            .chain(more)
            .map(|word| (*word).to_owned())
            .collect()
    };
    let of_rows = |file: &str| {
        grid(&[])
            .into_iter()
            .take(3)
            .chain(["--rows".to_owned(), name(file), "--output".into(), name("out.parquet")])
            .collect::<Vec<_>>()
    };
    fs::write(folder.join("ragged.csv"), "helical_angle_deg,note\n20,a\n30\n").unwrap();
    fs::write(folder.join("empty.csv"), "").unwrap();
    fs::write(folder.join("nothing.csv"), "colour,size\nred,1\n").unwrap();
    fs::write(folder.join("twice.csv"), "helical_angle_deg,helical_angle_rad\n20,1\n").unwrap();
    fs::write(folder.join("text.parquet"), "this is no Parquet file at all").unwrap();
    fs::write(folder.join("latin.csv"), b"helical_angle_deg,note\n20,\xe9\n").unwrap();
    let whole = folder.join("whole.parquet");
    assert_eq!(
        call(
            &grid(&["--outputs", "radius_ratio", "--output", text(&whole)])
                .iter()
                .map(String::as_str)
                .collect::<Vec<_>>()
        )
        .code,
        0
    );
    let bytes = fs::read(&whole).unwrap();
    fs::write(folder.join("cut.parquet"), &bytes[..bytes.len() / 2]).unwrap();
    fs::create_dir(folder.join("folder.csv")).unwrap();
    let before = left(&folder);
    for (arguments, code, said) in [
        (grid(&["--output", "/dev/full"]), 3, "No space left on device"),
        (grid(&["--output", &name("nowhere/out.parquet")]), 3, "No such file or directory"),
        (grid(&["--output", &name("folder.csv")]), 3, "it is no file"),
        (grid(&["--output", &name("out.xlsx")]), 2, "tables are CSV"),
        (grid(&["--resume"]), 2, "give --output"),
        (grid(&["--points", "10"]), 2, "goes with a sample"),
        (grid(&["--outputs", "helical_angel"]), 2, "did you mean `helical_angle`"),
        (vec!["sweep".to_owned(), "--strands".into(), "3".into()], 2, "nothing varies"),
        (of_rows("missing.csv"), 3, "cannot read"),
        (of_rows("folder.csv"), 3, "it is a folder"),
        (of_rows("ragged.csv"), 2, "line 3 has 1 cells"),
        (of_rows("empty.csv"), 2, "it is empty"),
        (of_rows("nothing.csv"), 2, "no column is a datum"),
        (of_rows("twice.csv"), 2, "are the same datum"),
        (of_rows("latin.csv"), 2, "not UTF-8"),
        (of_rows("text.parquet"), 2, "no whole Parquet file"),
        (of_rows("cut.parquet"), 2, "no whole Parquet file"),
        (of_rows("out.xlsx"), 2, "rows are read from CSV"),
    ] {
        let answer = call(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(answer.code, code, "{arguments:?}: {}", answer.err);
        assert!(answer.err.contains(said), "{arguments:?}: {}", answer.err);
        assert!(answer.err.lines().count() <= 6, "{}", answer.err);
        assert_eq!(left(&folder), before, "{arguments:?}");
    }
}

#[test]
fn a_closed_pipe_is_no_error() {
    let mut child = command(&["sweep", "--strands", "3", "--sweep", "helical_angle=1 deg:80 deg:300000"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(root().exists());
}
