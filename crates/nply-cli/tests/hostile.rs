//! What a hostile user gives: names, files and numbers. The answer is an exit status of the contract and one sentence, and no file is lost.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use command::{Answer, answer, call, command, root};

/// An empty folder of its own for a test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("hostile").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

const PLY: &str = "[ply]\nstrands = 3\n[strand]\nstiffness_ratio = 0.75\n[twist]\npretwist = -1\n";
const BARE: [&str; 4] = ["--strands", "3", "--stiffness-ratio", "0.75"];

/// A refusal: its exit status and its first line.
#[track_caller]
fn refused(arguments: &[&str]) -> (i32, String) {
    let Answer { code, out, err } = call(arguments);
    assert_eq!(out, "", "{arguments:?}");
    assert!(err.starts_with("error: "), "{arguments:?}: {err}");
    (code, err.lines().next().unwrap().to_owned())
}

#[test]
fn nothing_is_written_over_what_is_read() {
    let folder = folder("onto_itself");
    let file = |name: &str, content: &str| {
        let path = folder.join(name);
        fs::write(&path, content).unwrap();
        path
    };
    let (ply, rows) = (file("ply.csv", PLY), file("rows.csv", "pretwist\n-1\n-0.5\n"));
    let data = file("data.csv", "pretwist,helical_angle_deg\n-0.2,12.1\n-0.5,23.2\n-1,30.6\n");
    let study = file("study.toml", &format!("{PLY}[sweep]\nrows = \"{}\"\n", text(&rows)));
    let around = folder.join(".").join("rows.csv");
    let fit = ["fit", text(&data), "--strands", "3", "--stiffness-ratio", "1", "--estimate", "stiffness_ratio"];
    let calls: Vec<Vec<&str>> = vec![
        vec!["sweep", text(&ply), "--sweep", "force=0:1:3", "--output", text(&ply)],
        vec!["sweep", "--strands", "3", "--stiffness-ratio", "1", "--rows", text(&rows), "--output", text(&around)],
        vec!["sweep", text(&study), "--output", text(&rows)],
        [&fit[..], &["--output", text(&data)]].concat(),
        [&fit[..], &["--plot", text(&data)]].concat(),
        vec!["plot", text(&ply), "--sweep", "force=0..1", "--ask", "helical_angle", "--output", text(&ply)],
        vec!["map", text(&ply), "--to-force", "1", "--to-moment", "1", "--output", text(&ply)],
        vec!["locus", text(&ply), "--plot", text(&ply)],
    ];
    for arguments in &calls {
        let before: Vec<_> = [&ply, &rows, &data].map(|path| fs::read(path).unwrap()).to_vec();
        let (code, said) = refused(arguments);
        assert_eq!((code, said.contains("is read as well, and would be lost")), (2, true), "{arguments:?}: {said}");
        assert_eq!([&ply, &rows, &data].map(|path| fs::read(path).unwrap()).to_vec(), before, "{arguments:?}");
    }
    // a link to it is it
    #[cfg(unix)]
    {
        let link = folder.join("link.csv");
        std::os::unix::fs::symlink(&ply, &link).unwrap();
        assert_eq!(refused(&["map", text(&ply), "--to-force", "1", "--to-moment", "1", "--output", text(&link)]).0, 2);
    }
    let twice = folder.join("twice.csv");
    let again = folder.join(".").join("twice.csv");
    let (code, said) = refused(&[&fit[..], &["--output", text(&twice), "--plot", text(&again)]].concat());
    assert_eq!((code, said.contains("written to the same file"), twice.exists()), (2, true, false), "{said}");
}

#[test]
fn a_flag_is_not_dropped_for_what_varies() {
    let call = |more: &[&str]| refused(&[&more[..1], &BARE[..], &["--pretwist", "-1"], &more[1..]].concat());
    for (arguments, flag, varies) in [
        (&["plot", "--force", "1", "--sweep", "force=0..2", "--ask", "helical_angle"][..], "force", "force"),
        (&["plot", "--sweep", "strand-twist=0..2", "--ask", "helical_angle"], "pretwist", "strand_twist"),
        (&["sweep", "--force", "1", "--sweep", "force=0:2:3"], "force", "force"),
        (&["sweep", "--sweep", "strand-twist=0:2:3"], "pretwist", "strand_twist"),
        (&["map", "--force", "1", "--from-force", "0", "--to-force", "2", "--to-moment", "1"], "force", "force"),
    ] {
        let (code, said) = call(arguments);
        assert_eq!(code, 2, "{arguments:?}");
        assert!(said.starts_with(&format!("error: `--{flag} ")) && said.contains(&format!("`{varies}`")), "{said}");
    }
    // what a file says may be overridden, and a map may begin where a flag says
    let folder = folder("overridden");
    let ply = folder.join("ply.toml");
    fs::write(&ply, PLY).unwrap();
    for arguments in [
        &["sweep", text(&ply), "--sweep", "strand-twist=0:2:3"][..],
        &["sweep", text(&ply), "--sweep", "pretwist=-2:0:3"],
        &["map", text(&ply), "--force", "1", "--to-force", "2", "--to-moment", "1", "--rows", "2", "--columns", "2"],
    ] {
        assert_eq!(command::call(arguments).code, 0, "{arguments:?}");
    }
}

/// Sizes whose powers are no numbers any more; every refusal names flag, value and range.
#[test]
fn sizes_beyond_numbers_are_refused_and_none_is_infinite() {
    let sized = |size: &'static str, stiffness: &'static str, twist: &'static str| {
        let numbers = ["--diameter", size, "--bending-stiffness", stiffness, "--pretwist", twist];
        [&["--strands", "3", "--stiffness-ratio", "0.75"][..], &numbers[..]].concat()
    };
    let (d, b, t) = ("1 mm", "1 N mm^2", "-1");
    for (arguments, wanted) in [
        (sized("1e-300 nm", b, t), ["--diameter", "1e-300 nm", "1e-100 m to 1e100 m"]),
        (sized("5e-324 m", b, t), ["--diameter", "5e-324 m", ""]),
        (sized("1e300 km", b, t), ["--diameter", "1e300 km", "1e-100 m to 1e100 m"]),
        (sized(d, "1e300 N m^2", t), ["--bending-stiffness", "1e300 N m^2", "1e300 N m^2"]),
        (sized(d, "1e-300 N m^2", t), ["--bending-stiffness", "1e-300 N m^2", "1e-300 N m^2"]),
        (sized(d, b, "1e308"), ["--pretwist", "1e308", "-1e60 to 1e60"]),
        (sized(d, b, "-1e308"), ["--pretwist", "-1e308", "-1e60 to 1e60"]),
        ([&sized(d, b, t)[..], &["--force", "1e300 kN"]].concat(), ["--force", "1e300 kN", "-1e60 to 1e60"]),
        ([&sized(d, b, t)[..], &["--moment=-1e300 kN m"]].concat(), ["--moment", "-1e300 kN m", "-1e60 to 1e60"]),
    ] {
        for verb in ["solve", "support"] {
            let (code, said) = refused(&[&[verb][..], &arguments[..]].concat());
            assert_eq!(code, 1, "{arguments:?}: {said}");
            assert!(wanted.iter().all(|wanted| said.contains(wanted)), "{said}");
        }
    }
    let huge = ["--strands", "3", "--stiffness-ratio", "1e308", "--diameter", d, "--bending-stiffness", b];
    assert_eq!(refused(&[&["solve", "--pretwist", "-1"][..], &huge[..]].concat()).0, 1);
    // what is only extreme has an answer of numbers
    for arguments in [
        sized("1e-90 m", "1e-230 N m^2", t),
        sized("1e30 km", "1e120 N m^2", t),
        sized(d, b, "1e59"),
        sized(d, b, "-5e-324"),
        [&sized(d, b, t)[..], &["--force", "1e-300 nN"]].concat(),
    ] {
        let Answer { code, out, err } = call(&[&["solve", "--format", "csv"][..], &arguments[..]].concat());
        assert_eq!(code, 0, "{arguments:?}: {err}");
        assert!(!out.contains("inf") && !out.contains("NaN"), "{arguments:?}: {out}");
    }
}

/// Angles beside the limits of the theory.
#[test]
fn angles_beside_their_limits_are_numbers_or_refused() {
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};
    for angle in [0.0, FRAC_PI_4, FRAC_PI_2] {
        for beside in [angle.next_down(), angle, angle.next_up()] {
            for verb in ["contact", "solve"] {
                let lay = format!("--helical-angle={beside:?} rad");
                let mut arguments = vec![verb, "--strands", "3", &lay];
                if verb == "solve" {
                    arguments.extend(["--format", "csv", "--stiffness-ratio", "0.75", "--force", "0", "--moment", "0"]);
                }
                let Answer { code, out, err } = call(&arguments);
                assert!(code == 0 || code == 1 && err.starts_with("error: `--helical-angle"), "{lay}: {code} {err}");
                assert!(!out.contains("NaN"), "{lay}: {out}");
            }
        }
    }
}

#[test]
fn names_steer_no_terminal_and_break_no_line() {
    for name in ["a\nb.toml", "\u{1b}[31mred.toml", "\u{7}.csv", "no\rsuch.toml"] {
        let data = ["fit", name, "--strands", "3", "--stiffness-ratio", "1", "--estimate", "stiffness_ratio"];
        let rows = ["sweep", "--strands", "3", "--stiffness-ratio", "1", "--rows", name];
        for arguments in [&["solve", name][..], &["stiffness", name], &["writhe", name], &data, &rows] {
            let Answer { code, err, .. } = call(arguments);
            assert!(code == 3 || code == 2, "{arguments:?}: {err}");
            assert_eq!(err.trim_end().lines().count(), 1, "{arguments:?}: {err}");
            assert!(!err.trim_end().contains(char::is_control), "{arguments:?}: {err:?}");
        }
    }
}

#[test]
fn a_missing_folder_is_told_by_the_name_that_was_given() {
    let folder = folder("missing");
    let name = folder.join("none").join("a.csv");
    let (code, said) =
        refused(&[&["sweep"][..], &BARE, &["--sweep", "pretwist=-1:1:3", "--output", text(&name)]].concat());
    assert_eq!(code, 3);
    assert!(said.starts_with(&format!("error: cannot write {}: ", text(&name))), "{said}");
}

#[test]
fn no_environment_asks_for_too_many_threads() {
    let arguments = [&["sweep", "--quiet"][..], &BARE, &["--sweep", "pretwist=-1:1:3"]].concat();
    let mut many = command(&arguments);
    many.env("RAYON_NUM_THREADS", "1000000");
    assert_eq!(answer(&many.output().unwrap()).code, 0);
}

/// Where the answer cannot be written, that is told, whatever the command; and nobody who stops reading hears of it.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_by_every_command_and_a_closed_pipe_by_none() {
    let yarn = "examples/three-ply-yarn.toml";
    let fit = "examples/fit/balance.csv";
    let calls: [&[&str]; 15] = [
        &["solve", yarn],
        &["solve", yarn, "--json"],
        &["support", "tests/inputs/ok/support_core.toml"],
        &["trace", "examples/birdcage.toml", "--to-force", "-20 kN"],
        &["map", "tests/inputs/ok/map_of_loads.toml", "--rows", "9", "--columns", "9", "--quiet"],
        &["sweep", yarn, "--sweep", "force=0:1 mN:20000", "--quiet"],
        &["plot", yarn, "--sweep", "pretwist=-3..3", "--ask", "helical_angle"],
        &["locus", yarn],
        &["contact", "--strands", "3", "--helical-angle", "20 deg"],
        &["lays", "--strands", "3"],
        &["fit", fit, "--strands", "3", "--stiffness-ratio", "1", "--estimate", "stiffness_ratio"],
        &["fit-check", "examples/strand-7-wire.toml"],
        &["stiffness", "examples/strand-7-wire.toml", "--force", "100 kN"],
        &["mesh", yarn, "--format", "stl"],
        &["preset"],
    ];
    for arguments in calls {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let told = answer(&command(arguments).stdout(full).output().unwrap());
        assert_eq!((told.code, told.err.contains("No space left on device")), (3, true), "{arguments:?}: {}", told.err);
        let mut child = command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let told = answer(&child.wait_with_output().unwrap());
        assert_eq!((told.code, told.err.as_str()), (0, ""), "{arguments:?}");
    }
}

/// A fit of many rows takes a while; Ctrl-C ends it at once and leaves no file.
#[cfg(unix)]
#[test]
fn ctrl_c_ends_a_fit_and_leaves_nothing() {
    let folder = folder("fit");
    let (data, output) = (folder.join("data.csv"), folder.join("residuals.csv"));
    let rows: String = (1..20_000).map(|i| format!("-{}.{:04},{}\n", 1 + i % 3, i % 9973, 30 + i % 5)).collect();
    fs::write(&data, format!("pretwist,helical_angle_deg\n{rows}")).unwrap();
    let arguments = ["fit", text(&data), "--strands", "3", "--stiffness-ratio", "1", "--estimate", "stiffness_ratio"];
    let mut child = command(&[&arguments[..], &["--output", text(&output)]].concat())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // it reads for a moment before it listens
    for _ in 0..600 {
        sleep(Duration::from_millis(100));
        let caught = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
        let mask = caught.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap_or("2").trim();
        // SIGINT is signal 2
        if u64::from_str_radix(mask, 16).is_ok_and(|mask| mask & 2 != 0) {
            break;
        }
    }
    assert!(child.try_wait().unwrap().is_none(), "it was done too soon to be interrupted");
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let Answer { code, out, err } = answer(&child.wait_with_output().unwrap());
    assert_eq!((code, out.as_str(), err.as_str()), (130, "", "interrupted: nothing is kept\n"));
    let left: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["data.csv"]);
    assert!(root().exists());
}

/// Text that is none, or nearly: every reader says so, with the place where it stops.
#[test]
fn text_of_every_kind_is_read_or_refused() {
    let folder = folder("text");
    let utf16: Vec<u8> = [0xff, 0xfe].into_iter().chain(PLY.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    let contents: [(&str, Vec<u8>, i32); 12] = [
        ("crlf", PLY.replace('\n', "\r\n").into(), 0),
        ("mark", [b"\xef\xbb\xbf", PLY.as_bytes()].concat(), 0),
        ("minus", PLY.replace("-1", "\"\u{2212}1\"").into(), 0),
        ("returns", PLY.replace('\n', "\r").into(), 2),
        ("utf16", utf16, 2),
        ("nul", format!("{PLY}\0").into(), 2),
        ("latin", b"[ply]\ntitle = \"f\xfcr\"\n".to_vec(), 2),
        ("digits", PLY.replace("0.75", "\"\u{ff10}.\u{ff17}\"").into(), 2),
        ("deep", format!("a = {}", "[".repeat(500_000)).into(), 2),
        ("nested", format!("a = {}", "{a=".repeat(300_000)).into(), 2),
        ("dotted", format!("{}a = 1", "a.".repeat(500_000)).into(), 2),
        ("long", format!("[ply]\nstrands = \"{}\"\n", "9".repeat(1_000_000)).into(), 1),
    ];
    for (name, bytes, expected) in contents {
        let path = folder.join(format!("{name}.toml"));
        fs::write(&path, bytes).unwrap();
        let Answer { code, err, .. } = call(&["solve", text(&path)]);
        assert_eq!(code, expected, "{name}: {err}");
        assert!(expected == 0 || err.contains(&format!("{name}.toml:")), "{name}: {err}");
        assert!(err.len() < 4_000, "{name}: {} bytes of message", err.len());
    }
}

/// A row of a table without an end is refused at a limit, before it takes the memory; rows that are only long come through.
#[test]
fn rows_without_an_end_are_refused() {
    let folder = folder("long_rows");
    let name = folder.join("rows.csv");
    let sweep = [&["sweep", "--quiet"][..], &BARE, &["--rows", text(&name), "--outputs", "helical_angle"]].concat();
    let cell = |bytes: usize| format!("pretwist,note\n-1,{}\n-2,b\n", "x".repeat(bytes));
    let open = |rows: usize| format!("pretwist,note\n-1,\"never closed\n{}", "-1,a\n".repeat(rows));
    let head = |columns: usize| format!("pretwist{}\n", ",".repeat(columns));
    for (content, expected) in
        [(cell(900_000), 0), (cell(3_000_000), 2), (open(100), 2), (open(1_000_000), 2), (head(5_000_000), 2)]
    {
        fs::write(&name, &content).unwrap();
        let Answer { code, err, .. } = call(&sweep);
        assert_eq!(code, expected, "{} bytes: {err}", content.len());
        assert!(code == 0 || err.starts_with(&format!("error: {} cannot be read as a table: ", text(&name))), "{err}");
    }
    let told = call(&sweep).err;
    assert!(told.contains("a row of more than 1 MiB is not taken"), "{told}");
}

/// What `nply mesh` is asked for is refused in the words in which it was asked.
#[test]
fn facets_and_lengths_are_refused_by_their_own_names() {
    let mesh = |more: &[&str]| {
        refused(&[&["mesh", "--strands", "3", "--helical-angle", "20 deg", "--format", "obj"], more].concat())
    };
    for (arguments, code, wanted) in [
        (&["--facets", "2"][..], 1, "--facets: 2 facets round a strand make no body: at least 3 do"),
        (
            &["--chord-error", "1e-300"],
            1,
            "--chord-error: with a chord error of \"1e-300\" there would be more than 1e9",
        ),
        (&["--lay-lengths", "1e308"], 1, "--lay-lengths: so many lay lengths are longer than any number"),
        (&["--lay-lengths", "1e30"], 1, "--chord-error: with the usual chord error there would be more than 1e9"),
        (&["--core", "1e-300"], 1, "--core: a core of 1e-300 strand radii is too thin"),
        (&["--core", "1e300"], 1, "--core: a core of radius 1.000e300 strand radii overlaps"),
    ] {
        let (found, said) = mesh(arguments);
        assert!(found == code && said.contains(wanted), "{arguments:?}: {found}, {said}");
        assert!(said.len() < 300, "{said}");
    }
}

#[test]
fn a_prolongation_is_refused_by_its_own_length() {
    let folder = folder("prolonged");
    let name = folder.join("a.csv");
    fs::write(&name, "x,y,z\n0,0,0\n1,0,0\n1,1,0\n1,1,2\n").unwrap();
    for length in ["1e308", "1e-300", "5e-324"] {
        let (code, said) = refused(&["writhe", "--quiet", "--extend", length, text(&name)]);
        assert!(code == 1 && said.contains("cannot be prolonged by"), "{code}: {said}");
    }
}
