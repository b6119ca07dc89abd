//! `cargo xtask kill [TIMES] [SEED]`: studies ended at random moments and gone on with. What comes out must be, byte for byte, what comes out of
//! a run that nobody disturbs.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::step::{Outcome, command};

/// One kind of study: its name, what it is called with, the ending of its file, and whether it can be gone on with.
struct Kind {
    name: &'static str,
    arguments: &'static [&'static str],
    ending: &'static str,
    resumes: bool,
}

const SWEEP: &[&str] = &[
    "sweep",
    "--quiet",
    "--strands",
    "3",
    "--stiffness-ratio",
    "0.75",
    "--sweep",
    "pretwist=-2:2:61",
    "--sweep",
    "force=-0.05:0.2:197",
    "--sweep",
    "moment=-0.2:0.2:3",
];
/// States that are followed from row to row, by one thread: taken up again, they must come out the same.
const FOLLOWED: &[&str] = &[
    "sweep",
    "--quiet",
    "--strands",
    "3",
    "--stiffness-ratio",
    "0.75",
    "--states",
    "continued",
    "--sweep",
    "moment=-0.2:0.2:5",
    "--sweep",
    "pretwist=-2:0:9001",
];
const SAMPLE: &[&str] = &[
    "sweep",
    "--quiet",
    "--strands",
    "3",
    "--stiffness-ratio",
    "0.75",
    "--sample",
    "sobol",
    "--points",
    "40000",
    "--seed",
    "7",
    "--sweep",
    "pretwist=-2:2",
    "--sweep",
    "force=-0.05:0.2",
];
const MAP: &[&str] = &[
    "map",
    "--quiet",
    "--strands",
    "3",
    "--stiffness-ratio",
    "0.75",
    "--pretwist",
    "-1",
    "--to-force",
    "2",
    "--to-moment",
    "3",
    "--columns",
    "400",
    "--rows",
    "300",
];

const KINDS: [Kind; 7] = [
    Kind { name: "sweep", arguments: SWEEP, ending: "csv", resumes: true },
    Kind { name: "sweep", arguments: SWEEP, ending: "parquet", resumes: true },
    Kind { name: "sweep", arguments: SWEEP, ending: "arrow", resumes: true },
    Kind { name: "followed", arguments: FOLLOWED, ending: "parquet", resumes: true },
    Kind { name: "sample", arguments: SAMPLE, ending: "csv", resumes: true },
    Kind { name: "map", arguments: MAP, ending: "csv", resumes: false },
    Kind { name: "map", arguments: MAP, ending: "parquet", resumes: false },
];

/// Moments as a seed gives them (Steele, Lea and Flood's SplitMix, 2014): any run can be repeated as far as the machine can.
struct Moments(u64);

impl Moments {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A share of a while.
    fn within(&mut self, all: Duration) -> Duration {
        all.mul_f64((self.next() >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// What happened.
#[derive(Default)]
struct Tally {
    killed: u64,
    interrupted: u64,
    finished: u64,
    tables: u64,
}

pub(crate) fn run(times: &str, seed: &str) -> Outcome {
    let times: u64 = times.parse().map_err(|_| format!("\"{times}\" is no number of times"))?;
    let seed: u64 = seed.parse().map_err(|_| format!("\"{seed}\" is no seed"))?;
    let nply = command()?;
    let folder = std::env::temp_dir().join(format!("nply-kill-{}", std::process::id()));
    fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    let begin = Instant::now();
    let outcome = rounds(&nply, &folder, times, seed);
    let _ = fs::remove_dir_all(&folder);
    let tally = outcome?;
    println!(
        "seed {seed}: {} tables, {} runs killed, {} interrupted, {} at their end before the signal came; every table as undisturbed, {:.0} s",
        tally.tables,
        tally.killed,
        tally.interrupted,
        tally.finished,
        begin.elapsed().as_secs_f64()
    );
    Ok(())
}

fn rounds(nply: &Path, folder: &Path, times: u64, seed: u64) -> Result<Tally, String> {
    let mut moments = Moments(seed);
    let mut tally = Tally::default();
    // what each kind writes where nobody disturbs it, and how long it takes
    let mut whole: BTreeMap<usize, (Vec<u8>, Duration)> = BTreeMap::new();
    while tally.killed + tally.interrupted < times {
        let number = (moments.next() % KINDS.len() as u64) as usize;
        let kind = &KINDS[number];
        if let Entry::Vacant(place) = whole.entry(number) {
            let path = folder.join(format!("whole-{number}.{}", kind.ending));
            let begin = Instant::now();
            ended_well(&mut start(nply, kind, &path, false)?)?;
            place.insert((read(&path)?, begin.elapsed()));
        }
        let (expected, duration) = &whole[&number];
        let path = folder.join(format!("{}-{}.{}", kind.name, tally.tables, kind.ending));
        disturbed(nply, kind, &path, *duration, &mut moments, &mut tally)?;
        if &read(&path)? != expected {
            return Err(format!("seed {seed}: {} ({}) differs from the undisturbed table", path.display(), kind.name));
        }
        tally.tables += 1;
        left_clean(folder, kind, &path)?;
        fs::remove_file(&path).map_err(|error| error.to_string())?;
        println!(
            "{:9} {:7} whole; {} killed, {} interrupted so far",
            kind.name, kind.ending, tally.killed, tally.interrupted
        );
    }
    Ok(tally)
}

/// Starts a run again and again, and ends it at a random moment, until one comes to its end or it was ended often enough.
fn disturbed(
    nply: &Path,
    kind: &Kind,
    path: &Path,
    duration: Duration,
    moments: &mut Moments,
    tally: &mut Tally,
) -> Outcome {
    const MOST: usize = 6;
    for _ in 0..MOST {
        let mut child = start(nply, kind, path, kind.resumes)?;
        sleep(moments.within(duration));
        if child.try_wait().map_err(|error| error.to_string())?.is_some() {
            ended_well(&mut child)?;
            tally.finished += 1;
            return Ok(());
        }
        let kill = (tally.killed + tally.interrupted).is_multiple_of(2);
        let signal = if kill { "-KILL" } else { "-INT" };
        let _ = Command::new("kill").args([signal, &child.id().to_string()]).stderr(Stdio::null()).status();
        let status = child.wait().map_err(|error| error.to_string())?;
        match (kill, status.code()) {
            // the signal came behind the last line of the work
            (_, Some(0)) => {
                tally.finished += 1;
                return Ok(());
            }
            (true, None) => tally.killed += 1,
            (false, Some(130)) => tally.interrupted += 1,
            // before the command listens, Ctrl-C ends it as any other
            (false, None) => tally.interrupted += 1,
            (_, code) => return Err(format!("{} ended with {code:?} on {signal}", kind.name)),
        }
        if path.exists() {
            return Err(format!("{} is there though its run was ended", path.display()));
        }
    }
    ended_well(&mut start(nply, kind, path, kind.resumes)?)
}

fn start(nply: &Path, kind: &Kind, path: &Path, resume: bool) -> Result<Child, String> {
    let mut command = Command::new(nply);
    command.args(kind.arguments).arg("--output").arg(path);
    if resume {
        command.arg("--resume");
    }
    command.stdin(Stdio::null()).stdout(Stdio::null());
    command.spawn().map_err(|error| format!("cannot start {}: {error}", nply.display()))
}

fn ended_well(child: &mut Child) -> Outcome {
    let status = child.wait().map_err(|error| error.to_string())?;
    if status.success() { Ok(()) } else { Err(format!("a run that nobody disturbed ended with {status}")) }
}

fn read(path: &Path) -> Result<Vec<u8>, String> {
    fs::read(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}

/// Beside a whole table nothing is left of its parts, but for drafts of maps that were killed and could not take them away.
fn left_clean(folder: &Path, kind: &Kind, path: &Path) -> Outcome {
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    for entry in fs::read_dir(folder).map_err(|error| error.to_string())? {
        let entry = entry.map_err(|error| error.to_string())?.path();
        let found = entry.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        if found == name || !found.starts_with(&name) {
            continue;
        }
        if kind.resumes {
            return Err(format!("{found} is left beside the whole table"));
        }
        fs::remove_file(&entry).map_err(|error| error.to_string())?;
    }
    Ok(())
}
