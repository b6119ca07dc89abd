//! The axes `examples/coiled-coil/helix_axes.py` finds, for coiled coils made by Crick's equations, and what it says to files it cannot take.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::disallowed_methods, reason = "numbers to compare with go another way")]
#![allow(clippy::print_stdout, reason = "a test that is left out says so")]

mod command;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use command::{Answer, answer, root};

/// Cα of `count` residues of the helices of a left-handed coiled coil, by Crick's equations (*Acta Cryst.* 6 (1953) 685): superhelix radius and pitch in Å, a
/// helix of radius 2.26 Å and seven residues to two turns about its axis, 1.51 Å apart along it.
fn crick(helices: u32, radius: f64, pitch: f64, count: u32) -> Vec<Vec<[f64; 3]>> {
    let tau = core::f64::consts::TAU;
    let inner = 2.26;
    let tilt = (tau * radius / pitch).atan();
    let helix = |k: u32| {
        let at = move |i: u32| {
            let residue = f64::from(i) - 0.5 * f64::from(count - 1);
            let along = 1.51 * residue * tilt.cos();
            let outer_turn = tau * (f64::from(k) / f64::from(helices) - along / pitch);
            let inner_turn = tau * residue * 2.0 / 7.0 + 0.35;
            let [(s0, c0), (s1, c1)] = [outer_turn.sin_cos(), inner_turn.sin_cos()];
            [
                radius * c0 + inner * (c0 * c1 - tilt.cos() * s0 * s1),
                radius * s0 + inner * (s0 * c1 + tilt.cos() * c0 * s1),
                along + inner * tilt.sin() * s1,
            ]
        };
        (0..count).map(at).collect()
    };
    (0..helices).map(helix).collect()
}

/// Atoms of a chain as a PDB file has them; residue 11 is a selenomethionine, as crystals have it.
fn atoms(chain: char, first: usize, points: &[[f64; 3]]) -> Vec<String> {
    let atom = |(i, [x, y, z]): (usize, &[f64; 3])| {
        let (record, name) = if i + first == 11 { ("HETATM", "MSE") } else { ("ATOM  ", "LEU") };
        format!(
            "{record}{:5}  CA  {name} {chain}{:4}    {x:8.3}{y:8.3}{z:8.3}  1.00 20.00           C",
            i + 1,
            i + first
        )
    };
    points.iter().enumerate().map(atom).collect()
}

/// The file a test writes or asks for.
fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// What the program says to these words; nothing where there is no Python.
fn told(words: &[&str]) -> Option<Answer> {
    let mut program = Command::new(if cfg!(windows) { "python" } else { "python3" });
    let said = program.arg("examples/coiled-coil/helix_axes.py").args(words).current_dir(root()).output();
    if said.is_err() {
        println!("LEFT OUT: there is no Python here");
    }
    said.ok().map(|output| answer(&output))
}

/// What it says to a file of these lines, with more words behind it.
fn axes(name: &str, lines: &[String], more: &[&str]) -> Option<Answer> {
    let path = scratch(&format!("axes-{name}.pdb"));
    fs::write(&path, lines.join("\n") + "\nEND\n").unwrap();
    told(&[&[path.to_str().unwrap()], more].concat())
}

/// It says so many helices of these chains, and the radius and the pitch they were made with.
#[track_caller]
fn right(name: &str, lines: &[String], more: &[&str], chains: &str) {
    let Some(said) = axes(name, lines, more) else { return };
    assert_eq!(said.code, 0, "{name}: {}", said.err);
    let first = said.out.lines().next().unwrap();
    assert!(first.starts_with(&format!("2 helices (chains {chains}), ")), "{name}: {first}");
    assert!(first.ends_with(" Å, left-handed"), "{name}: {first}");
    let number = |before: &str| -> f64 {
        first.split_once(before).and_then(|(_, rest)| rest.split(' ').next()).unwrap().parse().unwrap()
    };
    // the bisectors of an ideal helix meet on its axis but for the bend of that, some hundredths of an Å
    assert!((number("radius ") - 4.9).abs() < 0.03, "{name}: {first}");
    assert!((number("pitch ") - 148.0).abs() < 1.0, "{name}: {first}");
}

/// It answers nothing, and says this on standard error.
#[track_caller]
fn refused(name: &str, lines: &[String], more: &[&str], part: &str) {
    let Some(said) = axes(name, lines, more) else { return };
    assert!(said.code == 1 && said.out.is_empty() && said.err.contains(part), "{name}: {}{}", said.out, said.err);
    assert!(!said.err.contains("Traceback"), "{name}: {}", said.err);
}

/// Two helices of a dimer, and its atoms as chains A and B.
fn dimer() -> (Vec<Vec<[f64; 3]>>, [Vec<String>; 2]) {
    let two = crick(2, 4.9, 148.0, 31);
    let chains = [atoms('A', 1, &two[0]), atoms('B', 1, &two[1])];
    (two, chains)
}

fn backwards(points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    points.iter().rev().copied().collect()
}

fn moved(points: &[[f64; 3]], by: [f64; 3]) -> Vec<[f64; 3]> {
    points.iter().map(|[x, y, z]| [x + by[0], y + by[1], z + by[2]]).collect()
}

fn line(text: &str) -> Vec<String> {
    vec![text.to_owned()]
}

#[test]
fn axes_of_a_coiled_coil_have_the_radius_and_pitch_it_was_made_with() {
    let (two, [one, other]) = dimer();
    let both = [one.clone(), other.clone()].concat();
    right("plain", &both, &[], "A, B");
    // a chain that begins two residues later, as crystals have it, and one that runs the other way
    right("stagger", &[atoms('A', 3, &two[0][2..]), other.clone()].concat(), &[], "A, B");
    right("against", &[one.clone(), atoms('B', 1, &backwards(&two[1]))].concat(), &[], "A, B; B against A");
    // a loop that was not seen, and a second position of an atom
    let gap: Vec<String> =
        one.iter().enumerate().filter(|(i, _)| !(14..17).contains(i)).map(|(_, l)| l.clone()).collect();
    right("gap", &[gap, other.clone()].concat(), &[], "A, B");
    let mut alternate = one.clone();
    alternate.insert(20, one[19].replace(" CA  LEU", " CA BLEU").replace("  1.00", "  0.40"));
    right("alternate", &[alternate, other.clone()].concat(), &[], "A, B");
    // a second model
    let second = atoms('A', 1, &moved(&two[0], [3.0, -2.0, 0.0]));
    right("models", &[both, line("ENDMDL"), line("MODEL 2"), second].concat(), &[], "A, B");
}

#[test]
fn chains_are_chosen_and_the_file_of_their_axes_named() {
    let (two, [one, other]) = dimer();
    let far = moved(&two[0], [30.0, 0.0, 0.0]);
    let three = [one.clone(), other.clone(), atoms('C', 1, &far)].concat();
    refused("three", &three, &[], "do not stand evenly");
    let table = scratch("axes-chosen.csv");
    let table = table.to_str().unwrap();
    for choice in ["AB", "A,B", "BA"] {
        right("chosen", &three, &[table, choice], "A, B");
    }
    let Some(said) = axes("chosen", &three, &[table, "AB"]) else { return };
    assert_eq!(said.out.lines().nth(1), Some(format!("axes written to {table}").as_str()));
    assert_eq!(fs::read_to_string(table).unwrap().lines().count(), 1 + 2 * 28);
    refused("chosen", &three, &[table, "AQ"], "has no chain Q: its chains are A, B, C");
    let nowhere = scratch("no-such-folder").join("axes.csv");
    refused("chosen", &three, &[nowhere.to_str().unwrap(), "AB"], "cannot be written");
    // chains where the file's name is wanted: no file of that name
    let taken_for_chains = scratch("AB");
    refused(
        "chosen",
        &three,
        &[taken_for_chains.to_str().unwrap()],
        "a name that ends in .csv; chains stand behind it",
    );
    assert!(!taken_for_chains.exists());
}

/// As programs of molecular dynamics write them: no letters, and a TER behind each chain; residues are numbered anew in each.
#[test]
fn chains_without_a_letter_end_at_their_ter() {
    let (two, _) = dimer();
    let [one, other] = [atoms(' ', 1, &two[0]), atoms(' ', 1, &two[1])];
    let ended = [one.clone(), line("TER"), other.clone(), line("TER")].concat();
    right("blank", &ended, &[], "1, 2");
    // beside a chain of that name they have the next
    right("blank-and-1", &[one.clone(), line("TER"), atoms('1', 1, &two[1])].concat(), &[], "2, 1");
    let far = [ended, atoms(' ', 1, &moved(&two[0], [30.0, 0.0, 0.0]))].concat();
    let table = scratch("axes-blank.csv");
    right("blank-chosen", &far, &[table.to_str().unwrap(), "12"], "1, 2");
    refused("blank-without-ter", &[one, other].concat(), &[], "no letter of a chain (column 22), and no TER");
}

#[test]
fn what_is_no_coiled_coil_is_refused() {
    let (two, [one, _]) = dimer();
    refused("one", &one, &[], "two or more chains");
    let hairpin = [two[0].clone(), backwards(&two[1])].concat();
    refused("hairpins", &[atoms('A', 1, &hairpin), atoms('B', 1, &hairpin)].concat(), &[], "turns back");
    let higher = atoms('B', 1, &moved(&two[1], [0.0, 0.0, 60.0]));
    refused("apart", &[one.clone(), higher].concat(), &[], "less than 10 Å");
    refused("nothing", &[], &[], "0 found");
    // 31 residues straight as a rod: 28 fours, named by a range; and two that are moved away, each named with the three fours before it
    let rod: Vec<[f64; 3]> = (0..31_u8).map(|i| [0.0, 0.0, 3.8 * f64::from(i)]).collect();
    refused("rod", &[one, atoms('B', 1, &rod)].concat(), &[], "by the first of the four: 1 to 28; left out\n");
    let mut torn = two[0].clone();
    (torn[9][0], torn[30][0]) = (50.0, 50.0);
    refused("torn", &atoms('A', 1, &torn), &[], "by the first of the four: 7 to 10, 28; left out\n");
}

#[test]
fn damaged_files_are_refused_in_one_line() {
    let (_, [one, other]) = dimer();
    let both = [one, other].concat();
    let damaged = |line: String| [&both[..11], &[line], &both[12..]].concat();
    let no_number = "line 12: this atom's x, y and z are not three numbers";
    for (name, line) in [
        ("cut", both[11][..42].to_owned()),
        ("cut-within-z", both[11][..52].to_owned()),
        ("overflown", format!("{}********{}", &both[11][..38], &both[11][46..])),
        ("unknown", format!("{}     nan{}", &both[11][..38], &both[11][46..])),
    ] {
        refused(name, &damaged(line), &[], no_number);
    }
    let cif = ["data_1ABC", "loop_", "_atom_site.id", "ATOM 1 C CA . LEU A 1 1 ? 1.0 2.0 3.0 1.0 20 1 LEU A CA"];
    refused("cif", &cif.map(str::to_owned), &[], "it is mmCIF; save it as PDB");
    for path in ["no-such.pdb", "examples"] {
        let Some(said) = told(&[path]) else { return };
        assert!(said.code == 1 && said.err.starts_with(&format!("{path} cannot be read: ")), "{}", said.err);
        assert_eq!(said.err.trim_end().lines().count(), 1, "{}", said.err);
    }
}
