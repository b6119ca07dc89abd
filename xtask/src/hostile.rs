//! `cargo xtask hostile`: inputs too large for a test, made on the fly. Each must end with its exit status, in bounded memory, without a panic.
//! Memory is what Linux says a program took at most (VmHWM); elsewhere only statuses are looked at.

use std::fs::{self, File};
use std::io::{BufWriter, Write as _};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::step::{Outcome, command};

/// What is called, what it must end with, and in how much memory (MiB).
struct Case {
    name: &'static str,
    /// `FILE` stands for the file that is made, `-` for standard input
    arguments: &'static [&'static str],
    make: fn(&Path) -> std::io::Result<()>,
    code: i32,
    memory: u64,
}

const GIB: u64 = 1 << 30;
const PLY: &str = "[ply]\nstrands = 3\n[strand]\nstiffness_ratio = 0.75\n[twist]\npretwist = -1\n";
const ROWS: &[&str] = &[
    "sweep",
    "--quiet",
    "--strands",
    "3",
    "--stiffness-ratio",
    "0.75",
    "--outputs",
    "helical_angle",
    "--states",
    "stable",
    "--rows",
    "FILE",
];
const FIT: &[&str] = &[
    "fit",
    "FILE",
    "--quiet",
    "--strands",
    "3",
    "--stiffness-ratio",
    "1",
    "--estimate",
    "stiffness_ratio",
    "--starts",
    "1",
];

const CASES: [Case; 14] = [
    Case { name: "TOML of 100 MB, valid", arguments: &["solve", "FILE"], make: remarks, code: 3, memory: 64 },
    Case { name: "TOML of 100 MB in one line", arguments: &["solve", "FILE"], make: one_line, code: 3, memory: 64 },
    Case { name: "TOML without an end", arguments: &["solve", "/dev/zero"], make: nothing, code: 3, memory: 64 },
    Case { name: "a million brackets", arguments: &["solve", "FILE"], make: brackets, code: 2, memory: 128 },
    Case { name: "half a million keys in keys", arguments: &["fit-check", "FILE"], make: dots, code: 2, memory: 256 },
    Case { name: "rows: a line of 1 GiB", arguments: ROWS, make: long_row, code: 2, memory: 128 },
    Case { name: "rows: a header of 1 GiB", arguments: ROWS, make: long_head, code: 2, memory: 256 },
    Case { name: "rows: a mark never closed in 1 GiB", arguments: ROWS, make: open_mark, code: 2, memory: 128 },
    Case { name: "rows: a line of a million cells", arguments: ROWS, make: many_cells, code: 2, memory: 512 },
    Case { name: "rows: 2 million, in a stream", arguments: ROWS, make: many_rows, code: 0, memory: 512 },
    Case { name: "fit: 1 GiB", arguments: FIT, make: long_row, code: 3, memory: 256 },
    Case { name: "fit: a line of 60 MiB", arguments: FIT, make: line_of_60, code: 2, memory: 512 },
    Case {
        name: "curves: a line of 1 GiB",
        arguments: &["writhe", "--quiet", "FILE"],
        make: long_row,
        code: 2,
        memory: 2200,
    },
    Case {
        name: "a million strands",
        arguments: &["solve", "--strands", "1000000", "--stiffness-ratio", "0.75", "--pretwist", "-1"],
        make: nothing,
        code: 0,
        memory: 256,
    },
];

pub(crate) fn run() -> Outcome {
    let nply = command()?;
    let folder = std::env::temp_dir().join(format!("nply-hostile-{}", std::process::id()));
    fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    let outcome = CASES.iter().try_for_each(|case| one(&nply, &folder, case));
    let _ = fs::remove_dir_all(&folder);
    outcome
}

fn one(nply: &Path, folder: &Path, case: &Case) -> Outcome {
    let cannot = |error: std::io::Error| format!("{}: {error}", case.name);
    let file = folder.join("input.csv");
    (case.make)(&file).map_err(cannot)?;
    let named = |word: &&str| if *word == "FILE" { file.clone().into_os_string() } else { (*word).into() };
    let begin = Instant::now();
    let (said, heard) = (folder.join("said"), File::create(folder.join("said")).map_err(cannot)?);
    let mut child = Command::new(nply)
        .args(case.arguments.iter().map(named))
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(heard)
        .spawn()
        .map_err(cannot)?;
    let mut most = 0;
    let status = loop {
        most = most.max(memory(child.id()).unwrap_or(0));
        if let Some(status) = child.try_wait().map_err(cannot)? {
            break status;
        }
        if most > 4 * case.memory || begin.elapsed() > Duration::from_secs(600) {
            let _ = child.kill();
            let _ = child.wait();
            return Err(format!("{}: no end after {:.0} s and {most} MiB", case.name, begin.elapsed().as_secs_f64()));
        }
        sleep(Duration::from_millis(5));
    };
    let said = fs::read_to_string(said).map_err(cannot)?;
    let first = said.lines().next().unwrap_or_default();
    println!(
        "{:36} {:>4} {:6.1} s {most:5} MiB  {:.100}",
        case.name,
        status.code().map_or("none".to_owned(), |code| code.to_string()),
        begin.elapsed().as_secs_f64(),
        first
    );
    if status.code() != Some(case.code) || said.contains("panicked") {
        return Err(format!("{}: ended with {status}, and {} is wanted: {first}", case.name, case.code));
    }
    if most > case.memory {
        return Err(format!("{}: {most} MiB, and {} are enough", case.name, case.memory));
    }
    Ok(())
}

/// The most memory a running program has had, MiB.
fn memory(id: u32) -> Option<u64> {
    let status = fs::read_to_string(format!("/proc/{id}/status")).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.trim().trim_end_matches(" kB").parse::<u64>().ok()? / 1024)
}

fn nothing(_: &Path) -> std::io::Result<()> {
    Ok(())
}

fn written(path: &Path, content: &dyn Fn(&mut BufWriter<File>) -> std::io::Result<()>) -> std::io::Result<()> {
    let mut file = BufWriter::new(File::create(path)?);
    content(&mut file)?;
    file.flush()
}

fn remarks(path: &Path) -> std::io::Result<()> {
    let remark = format!("#{}\n", "x".repeat(999));
    written(path, &|file| {
        file.write_all(PLY.as_bytes())?;
        (0..100_000).try_for_each(|_| file.write_all(remark.as_bytes()))
    })
}

fn one_line(path: &Path) -> std::io::Result<()> {
    let piece = "x".repeat(1000);
    written(path, &|file| {
        file.write_all(b"ply.title = \"")?;
        (0..100_000).try_for_each(|_| file.write_all(piece.as_bytes()))
    })
}

fn brackets(path: &Path) -> std::io::Result<()> {
    fs::write(path, format!("a = {}", "[".repeat(1_000_000)))
}

fn dots(path: &Path) -> std::io::Result<()> {
    fs::write(path, format!("{}a = 1", "a.".repeat(500_000)))
}

/// A file that begins so and then has nothing but zeros, which take no room on the disk.
fn and_zeros(path: &Path, begin: &str) -> std::io::Result<()> {
    fs::write(path, begin)?;
    File::options().write(true).open(path)?.set_len(GIB)
}

fn long_row(path: &Path) -> std::io::Result<()> {
    and_zeros(path, "pretwist,note\n-1,a\n-1,")
}

fn long_head(path: &Path) -> std::io::Result<()> {
    and_zeros(path, "pretwist,note")
}

fn open_mark(path: &Path) -> std::io::Result<()> {
    and_zeros(path, "pretwist,note\n-1,\"a\n")
}

fn many_cells(path: &Path) -> std::io::Result<()> {
    fs::write(path, format!("pretwist,note\n-1{}\n", ",".repeat(1_000_000)))
}

fn many_rows(path: &Path) -> std::io::Result<()> {
    written(path, &|file| {
        file.write_all(b"pretwist,note\n")?;
        (0..2_000_000).try_for_each(|row| writeln!(file, "-{}.{:03},row {row}", row % 2, row % 997))
    })
}

fn line_of_60(path: &Path) -> std::io::Result<()> {
    fs::write(path, format!("pretwist,helical_angle_deg\n-1,{}\n", "9".repeat(60 << 20)))
}
