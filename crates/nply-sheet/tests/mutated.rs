//! Seeds of the fuzz targets, changed at random places from a seed: every reader gives an answer of numbers, or one sentence, and never a panic.
//! NPLY_ROUNDS=100000 goes on for longer, NPLY_SEED begins elsewhere.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

use std::fs::{self, File};
use std::io::Cursor;
use std::path::Path;

use nply_sheet::construction::ConstructionSpec;
use nply_sheet::curves::{Curves, Format as CurveFormat};
use nply_sheet::regression::{Measurements, RegressionQuestion, RegressionReport};
use nply_sheet::sweep::{Study, SweepFlags};
use nply_sheet::table::{Format, TableReader, Values};
use nply_sheet::{FitReport, Report, Spec, SpecError, StiffnessReport};

/// Random numbers from a seed (Steele, Lea and Flood's SplitMix, 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound.max(1) as u64) as usize
    }
}

/// What stands in files that try a reader.
const TOKENS: [&[u8]; 40] = [
    b"0",
    b"-0",
    b"1",
    b"-1",
    b"2",
    b"1e308",
    b"-1e308",
    b"1e-308",
    b"5e-324",
    b"nan",
    b"inf",
    b"-inf",
    b"0.1",
    b"1e9",
    b"4294967296",
    b"18446744073709551615",
    b"-9223372036854775808",
    b"90 deg",
    b"1e300 km",
    b"1e-300 nm",
    b"mm",
    b"true",
    b"\"",
    b"'",
    b"[",
    b"]",
    b"{",
    b"}",
    b"=",
    b",",
    b";",
    b"\t",
    b"\n",
    b"\r\n",
    b"\0",
    b"\xff",
    b"\xef\xbb\xbf",
    b"#",
    b"\xe2\x88\x92",
    b".",
];

/// A seed with some places changed: bytes and tokens put in, pieces taken out, doubled, or put elsewhere from another seed.
fn mutated(seeds: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut bytes = seeds[random.below(seeds.len())].clone();
    for _ in 0..=random.below(6) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(24)).min(bytes.len());
        match random.below(7) {
            0 if at < bytes.len() => bytes[at] = random.next().to_le_bytes()[0],
            1 => drop(bytes.splice(at..at, TOKENS[random.below(TOKENS.len())].iter().copied())),
            2 => drop(bytes.splice(at..end, TOKENS[random.below(TOKENS.len())].iter().copied())),
            3 => drop(bytes.drain(at..end)),
            4 => {
                let piece = bytes[at..end].to_vec();
                bytes.splice(at..at, piece);
            }
            5 => {
                let other = &seeds[random.below(seeds.len())];
                let from = random.below(other.len() + 1);
                let piece = other[from..(from + random.below(64)).min(other.len())].to_vec();
                bytes.splice(at..at, piece);
            }
            _ => bytes.truncate(at),
        }
    }
    bytes.truncate(8192);
    bytes
}

/// Every file of these folders, below the project's root.
fn seeds(folders: &[&str]) -> Vec<Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut all = Vec::new();
    for folder in folders {
        let mut names: Vec<_> = fs::read_dir(root.join(folder)).unwrap().map(|entry| entry.unwrap().path()).collect();
        names.sort();
        all.extend(names.into_iter().filter(|name| name.is_file()).map(|name| fs::read(name).unwrap()));
    }
    assert!(!all.is_empty());
    all
}

/// Tries a reader on mutated seeds.
fn tried(folders: &[&str], rounds: u64, reader: impl Fn(&[u8])) {
    let said = |name: &str| std::env::var(name).ok().and_then(|said| said.parse::<u64>().ok());
    let (first, rounds) = (said("NPLY_SEED").unwrap_or(1), said("NPLY_ROUNDS").unwrap_or(rounds));
    let seeds = seeds(folders);
    for seed in first..first + rounds {
        let bytes = mutated(&seeds, &mut Random(seed));
        let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| reader(&bytes)));
        assert!(outcome.is_ok(), "seed {seed}: {:?}", String::from_utf8_lossy(&bytes));
    }
}

#[track_caller]
fn one_sentence(error: &SpecError, text: &str) {
    assert_eq!(error.to_string().lines().count(), 1, "{error}");
    let _ = error.render(text);
}

fn no_nan(values: &[Values]) {
    for values in values {
        match values {
            Values::Dense(cells) => assert!(!cells.iter().any(|cell| cell.is_nan())),
            Values::Float(cells) => assert!(!cells.iter().flatten().any(|cell| cell.is_nan())),
            _ => {}
        }
    }
}

#[test]
fn descriptions_of_plies() {
    tried(&["fuzz/seeds/toml", "tests/inputs/ok", "tests/inputs/domain_error"], 300, |bytes| {
        let text = String::from_utf8_lossy(bytes);
        match Spec::from_bytes("mutated.toml", bytes).and_then(|spec| spec.check()).and_then(Report::of) {
            Ok(report) => {
                let _ = (report.text(true), report.json());
                let csv = report.csv();
                assert!(
                    text.contains("inf") || text.contains("nan") || !csv.contains("inf") && !csv.contains("NaN"),
                    "{csv}"
                );
            }
            Err(error) => one_sentence(&error, &text),
        }
    });
}

#[test]
fn layered_strands() {
    tried(&["fuzz/seeds/construction"], 300, |bytes| {
        let text = String::from_utf8_lossy(bytes);
        let Ok(spec) = ConstructionSpec::from_bytes("mutated.toml", bytes).map_err(|error| one_sentence(&error, &text))
        else {
            return;
        };
        let titled = text.contains("inf") || text.contains("NaN");
        match spec.check_fit().map(FitReport::of) {
            Ok(report) => {
                let (table, json, csv) = (report.text(true), report.json(), report.csv());
                assert!(
                    titled || !csv.contains("inf") && !csv.contains("NaN") && !table.contains("NaN"),
                    "{json}{csv}"
                );
            }
            Err(error) => one_sentence(&error, &text),
        }
        match spec.check_cable().and_then(|case| StiffnessReport::of(&spec, case)) {
            Ok(report) => {
                let (table, json, csv) = (report.text(true), report.json(), report.csv());
                assert!(
                    titled || !csv.contains("inf") && !csv.contains("NaN") && !table.contains("NaN"),
                    "{json}{csv}"
                );
            }
            Err(error) => one_sentence(&error, &text),
        }
    });
}

#[test]
fn curves() {
    tried(&["fuzz/seeds/formats"], 2000, |bytes| {
        let Some((choice, bytes)) = bytes.split_first() else { return };
        let format = CurveFormat::ALL[usize::from(*choice) % CurveFormat::ALL.len()];
        match Curves::read("mutated", bytes, Some(format)) {
            Ok(curves) => {
                for curve in &curves.curves {
                    assert!(curve.points.len() > 1 && curve.points.as_flattened().iter().all(|x| x.is_finite()));
                }
            }
            Err(error) => assert_eq!(error.to_string().lines().count(), 1, "{error}"),
        }
    });
}

#[test]
fn tables_of_measurements_and_rows() {
    let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-1")]).unwrap();
    let flags = SweepFlags { rows: Some("mutated.csv".to_owned()), ..SweepFlags::default() };
    let study = Study::from_spec(&ply, &flags).unwrap();
    tried(&["fuzz/seeds/csv"], 200, |bytes| {
        let [_, _, bytes @ ..] = bytes else { return };
        let text = String::from_utf8_lossy(bytes);
        match Measurements::read("mutated.csv", bytes) {
            Ok(data) if data.lines().len() <= 8 => {
                let question = RegressionQuestion {
                    estimate: vec!["stiffness_ratio".to_owned()],
                    starts: Some(1),
                    ..RegressionQuestion::default()
                };
                match RegressionReport::of(&ply, &data, &question) {
                    Ok(report) => assert!(!report.csv().contains("NaN")),
                    Err(error) => one_sentence(&error, &text),
                }
            }
            Ok(_) => {}
            Err(error) => one_sentence(&error, &text),
        }
        rows(&study, Format::Csv, bytes);
    });
}

/// Found among these: its levels are longer than its page, at which the library that reads Parquet panics.
#[test]
fn damaged_parquet_is_refused() {
    let bytes = mutated(&seeds(&["fuzz/seeds/parquet"]), &mut Random(1_008_813));
    let mut table = TableReader::open(Format::Parquet, Cursor::new(bytes), 8, 0).unwrap();
    let error = table.next_chunk().unwrap_err();
    assert!(error.to_string().contains("no whole Parquet file"), "{error}");
}

/// Found by libFuzzer: a list of 10⁹ numbers announced in a page's header, of which the library that reads Parquet skips each at the file's
/// end; and a column's name with a line break, which it quotes.
#[test]
fn damaged_parquet_is_refused_in_a_sentence_and_at_once() {
    for name in ["endless-list", "name-with-line-break"] {
        let path = format!("{}/tests/damaged/{name}.parquet", env!("CARGO_MANIFEST_DIR"));
        let read = TableReader::open(Format::Parquet, File::open(&path).unwrap(), 8, 0);
        let error = read.and_then(|mut table| table.next_chunk()).unwrap_err().to_string();
        assert!(
            error.contains("no whole Parquet file") && !error.contains(|c: char| c.is_control()),
            "{name}: {error}"
        );
    }
}

#[test]
fn parquet() {
    let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "0.75")]).unwrap();
    let flags = SweepFlags { rows: Some("mutated.parquet".to_owned()), ..SweepFlags::default() };
    let study = Study::from_spec(&ply, &flags).unwrap();
    tried(&["fuzz/seeds/parquet"], 1000, |bytes| rows(&study, Format::Parquet, bytes));
}

/// Rows of a file, as far as it is one.
fn rows(study: &Study, format: Format, bytes: &[u8]) {
    let mut table = match TableReader::open(format, Cursor::new(bytes.to_vec()), 8, 0) {
        Ok(table) => table,
        Err(error) => return assert_eq!(error.to_string().lines().count(), 1, "{error}"),
    };
    let given = table.columns().to_vec();
    let asked = study.given_columns(&given);
    for _ in 0..2 {
        match (table.next_chunk(), &asked) {
            (Ok(Some(cells)), Ok(_)) => {
                if let Ok((_, answers)) = study.solve_given(&given, &cells) {
                    no_nan(&answers);
                }
            }
            (Ok(Some(_)), Err(error)) => return one_sentence(error, ""),
            (Ok(None), _) => return,
            (Err(error), _) => return assert_eq!(error.to_string().lines().count(), 1, "{error}"),
        }
    }
}

#[test]
fn studies() {
    tried(&["fuzz/seeds/study"], 150, |bytes| {
        let Ok(text) = str::from_utf8(bytes) else { return };
        let mut parts = text.split('\0');
        let Some(document) = parts.next() else { return };
        let sweep: Vec<String> = parts.map(str::to_owned).take(4).collect();
        let spec = match Spec::from_toml("mutated.toml", document) {
            Ok(spec) => spec,
            Err(error) => return one_sentence(&error, document),
        };
        match Study::from_spec(&spec, &SweepFlags { sweep, ..SweepFlags::default() }) {
            Ok(study) => no_nan(&study.chunk(study.rows().saturating_sub(2), 2)),
            Err(error) => one_sentence(&error, document),
        }
    });
}
