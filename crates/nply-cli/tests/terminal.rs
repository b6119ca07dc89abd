//! How the command behaves between pipes, files and people.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "the same ply asked in two ways gives the same bits")]

mod command;

use std::fs::{self, File};
use std::io::{Read as _, Write as _};
use std::process::Stdio;

use command::{Answer, answer, call, call_with, command, json, number, out, root, states};
use unicode_width::UnicodeWidthStr as _;

const YARN: &str = "examples/three-ply-yarn.toml";
const BARE: [&str; 5] = ["solve", "--strands", "3", "--stiffness-ratio", "0.75"];

fn bare(more: &[&str]) -> Vec<String> {
    BARE.iter().chain(more).map(ToString::to_string).collect()
}

fn refs(words: &[String]) -> Vec<&str> {
    words.iter().map(String::as_str).collect()
}

/// A folder for the files of one test.
fn folder(name: &str) -> std::path::PathBuf {
    let folder = std::path::PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&folder).unwrap();
    folder
}

#[track_caller]
fn one_sentence(found: &Answer, status: i32, part: &str) {
    assert_eq!((found.code, found.out.as_str()), (status, ""), "{}", found.err);
    assert!(found.err.contains(part), "{}", found.err);
    assert!(found.err.starts_with("error: ") && found.err.trim_end().lines().count() == 1, "{}", found.err);
}

#[test]
fn a_closed_pipe_is_no_error() {
    // closed before the first byte, and after it
    for read in [0, 1] {
        let arguments = bare(&["--pretwist", "-1", "--json"]);
        let mut child = command(&refs(&arguments)).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut pipe = child.stdout.take().unwrap();
        let mut first = vec![0; read];
        pipe.read_exact(&mut first).unwrap();
        drop(pipe);
        let found = answer(&child.wait_with_output().unwrap());
        assert_eq!((found.code, found.err.as_str()), (0, ""));
    }
}

#[test]
fn colours_only_where_somebody_sees_them() {
    let styled = |name: &str, value: &str, arguments: &[&str]| {
        let found = answer(&command(arguments).env(name, value).output().unwrap());
        (found.out.contains('\u{1b}'), found.err.contains('\u{1b}'))
    };
    let wrong = ["solve", "tests/inputs/parse_error/unknown_key.toml"];
    assert_eq!(styled("TERM", "xterm", &["solve", YARN]), (false, false));
    assert_eq!(styled("TERM", "xterm", &wrong), (false, false));
    assert_eq!(styled("NO_COLOR", "1", &["solve", YARN]), (false, false));
    assert_eq!(styled("CLICOLOR_FORCE", "1", &["solve", YARN]), (true, false));
    assert_eq!(styled("CLICOLOR_FORCE", "1", &wrong), (false, true));
    assert_eq!(styled("CLICOLOR_FORCE", "1", &["contact", YARN, "--helical-angle", "20 deg"]), (true, false));
    // for programs there is nothing to look at
    assert_eq!(styled("CLICOLOR_FORCE", "1", &["solve", YARN, "--json"]), (false, false));
    assert_eq!(styled("CLICOLOR_FORCE", "1", &["solve", YARN, "--format", "csv"]), (false, false));
}

#[test]
fn a_dash_reads_standard_input() {
    let text = fs::read(root().join(YARN)).unwrap();
    let found = call_with(&["solve", "-"], &text);
    assert_eq!((found.code, found.out), (0, out(&["solve", YARN])));
    let wrong = call_with(&["solve", "-"], b"[ply]\nstrand = 3\n");
    assert_eq!((wrong.code, wrong.out.as_str()), (2, ""));
    assert!(wrong.err.contains("--> standard input:2:1"), "{}", wrong.err);
    let empty = call_with(&["solve", "-"], b"");
    assert_eq!(empty.code, 2);
    assert!(empty.err.contains("--> standard input:1:1"), "{}", empty.err);
}

#[test]
fn file_trouble_ends_with_3() {
    one_sentence(&call(&["solve", "no such file.toml"]), 3, "cannot read no such file.toml");
    one_sentence(&call(&["solve", "examples"]), 3, "cannot read examples");
    one_sentence(&call(&["contact", "no such file.toml"]), 3, "cannot read no such file.toml");
    let large = folder("terminal").join("large.toml");
    fs::write(&large, vec![b'#'; 2 << 20]).unwrap();
    one_sentence(&call(&["solve", large.to_str().unwrap()]), 3, "larger than 1 MiB");
    one_sentence(&call_with(&["solve", "-"], &vec![b'#'; 2 << 20]), 3, "larger than 1 MiB");
}

#[cfg(target_os = "linux")]
#[test]
fn an_answer_that_cannot_be_written_ends_with_3() {
    for format in ["table", "json", "csv"] {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let found = command(&["solve", YARN, "--format", format]).stdout(full).stderr(Stdio::piped()).spawn().unwrap();
        one_sentence(&answer(&found.wait_with_output().unwrap()), 3, "cannot write the answer");
    }
}

#[test]
fn help_and_version_are_answers() {
    for arguments in [&["--help"][..], &["solve", "--help"], &["contact", "--help"], &["--version"], &["help", "solve"]]
    {
        assert!(out(arguments).contains("nply"), "{arguments:?}");
    }
    assert_eq!(out(&["--version"]), concat!("nply ", env!("CARGO_PKG_VERSION"), "\n"));
    for key in ["--strands <N>", "--lay-length <LENGTH>", "--force <FORCE>", "[FILE]"] {
        assert!(out(&["solve", "--help"]).contains(key), "{key}");
    }
}

#[test]
fn a_slip_in_a_flag_is_answered_with_the_flag_meant() {
    for (arguments, meant) in [
        (&["solve", "--pretwst", "-1"][..], "--pretwist"),
        (&["solve", "--lay-lenght", "3"], "--lay-length"),
        (&["contact", "--helical-angel", "3 deg"], "--helical-angle"),
        (&["slove"], "solve"),
    ] {
        let found = call(arguments);
        assert_eq!((found.code, found.out.as_str()), (2, ""), "{arguments:?}");
        assert!(found.err.starts_with("error: ") && found.err.contains(meant), "{}", found.err);
    }
    for arguments in
        [&[][..], &["solve"], &["solve", "--strands"], &["solve", "a.toml", "b.toml"], &["solve", "--format", "xml"]]
    {
        let found = call(arguments);
        assert_eq!((found.code, found.out.as_str()), (2, ""), "{arguments:?}: {}", found.err);
        assert!(!found.err.is_empty());
    }
}

/// Below a heading, and in the block above the first, each row is as wide as any other.
#[test]
fn the_columns_of_a_table_stand_in_line() {
    let files = ["three-ply-yarn", "tyre-cord", "dna-supercoil", "collagen", "rubber-rods", "wire-strand-on-core"];
    for file in files {
        let file = format!("examples/{file}.toml");
        let mut tables = vec![out(&["solve", &file])];
        tables.push(out(&["contact", &file, "--helical-angle", "50 deg"]));
        for table in tables {
            let rows: Vec<&str> = table.lines().filter(|line| line.starts_with("  ")).collect();
            assert!(rows.len() > 10, "{table}");
            for row in &rows {
                assert_eq!(row.width(), rows[0].width(), "{row}\n{table}");
            }
        }
        let csv = out(&["solve", &file, "--format", "csv"]);
        let fields: Vec<usize> = csv.lines().map(|line| line.split(',').count()).collect();
        assert!(fields.len() >= 2 && fields.iter().all(|count| *count == fields[0]), "{csv}");
        assert!(!csv.contains('"') && csv.ends_with('\n'));
        let mut names: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
        names.sort_unstable();
        assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "{names:?}");
        assert_eq!(out(&["solve", &file, "--json"]), out(&["solve", &file, "--format", "json"]));
    }
}

#[test]
fn flags_replace_what_the_file_says() {
    let angle = |arguments: &[&str]| number(&states(&json(arguments))[0], "helical_angle_deg");
    let file = "examples/rubber-rods.toml";
    assert_eq!(
        angle(&["solve", file, "--json"]),
        angle(&["solve", "--json", "--strands", "3", "--stiffness-ratio", "0.75", "--pretwist", "-0.2"])
    );
    let changed = ["solve", file, "--json", "--pretwist", "-1", "--strands", "4"];
    assert_eq!(
        angle(&changed),
        angle(&["solve", "--json", "--strands", "4", "--stiffness-ratio", "0.75", "--pretwist", "-1"])
    );
    // of data that exclude each other the flag's stands
    let turned = ["solve", file, "--json", "--surface-angle", "-45 deg"];
    assert!((angle(&turned) - 30.6130).abs() < 5e-5);
    assert_eq!(json(&["solve", file, "--json", "--balance", "radial"])["balance"], "radial");
}

#[test]
fn a_negative_value_is_no_flag() {
    let measured = ["--radius", "1 mm", "--bending-stiffness", "1 N mm^2"];
    for (more, key, value) in [
        (&["--pretwist", "-1"][..], "pretwist", -1.0),
        (&["--pretwist=-1"], "pretwist", -1.0),
        (&["--pretwist", "-1", "--force", "-2 N"], "force", -2.0),
        (&["--pretwist", "-1", "--moment", "-.5 N mm"], "moment", -0.5),
        (&["--turns-per-length", "-200 turns/m"], "pretwist", -0.4 * std::f64::consts::PI),
        (&["--surface-angle", "-45 deg"], "pretwist", -1.0),
    ] {
        let arguments: Vec<String> =
            bare(more).into_iter().chain(measured.map(str::to_owned)).chain(["--json".into()]).collect();
        let given = number(&json(&refs(&arguments))["question"]["given"], key);
        assert!((given - value).abs() < 1e-14, "{more:?}: {given}");
    }
}

#[test]
fn a_title_stays_on_its_line_and_colours_nothing() {
    let text = "ply.title = \"a\\n\\u001b[31mb\"\nply.strands = 3\nstrand.stiffness_ratio = 1\ntwist.pretwist = -1\n";
    let mut child = command(&["solve", "-"])
        .env("CLICOLOR_FORCE", "1")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    let found = answer(&child.wait_with_output().unwrap());
    assert!(!found.out.contains("\u{1b}[31m"), "{:?}", found.out);
    assert!(found.out.lines().next().unwrap().contains("a  [31mb: 3 strands"), "{:?}", found.out);
}
