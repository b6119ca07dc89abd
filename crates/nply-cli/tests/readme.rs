//! What the README and docs/json.md show is what the command does.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::process::Command;

fn root() -> &'static str {
    concat!(env!("CARGO_MANIFEST_DIR"), "/../..")
}

fn read(name: &str) -> String {
    std::fs::read_to_string(format!("{}/{name}", root())).unwrap()
}

fn nply(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_nply")).args(arguments).current_dir(root()).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn the_readme_shows_real_output() {
    for arguments in [["solve", "examples/three-ply-yarn.toml"], ["trace", "examples/letting-go.toml"]] {
        let output = nply(&arguments);
        assert!(read("README.md").contains(output.trim_end()), "README.md does not show\n{output}");
    }
}

/// Every command that the README's shell blocks begin with `nply` is one that works.
#[test]
fn the_readme_shows_real_commands() {
    let readme = read("README.md");
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("readme");
    std::fs::create_dir_all(&folder).unwrap();
    let mut count = 0;
    // `nply explore` answers until it is ended: it has tests of its own
    let is_shown = |line: &&str| line.starts_with("nply ") && !line.contains('"') && !line.starts_with("nply explore");
    for line in readme.lines().filter(is_shown) {
        let mut words: Vec<String> = line.split(" #").next().unwrap().split_whitespace().map(str::to_owned).collect();
        // files are made elsewhere
        for i in 1..words.len() {
            if ["--output", "--plot"].contains(&words[i - 1].as_str()) {
                let name = std::path::Path::new(&words[i]).file_name().unwrap().to_owned();
                words[i] = folder.join(name).to_str().unwrap().to_owned();
            }
        }
        let words: Vec<&str> = words[1..].iter().map(String::as_str).collect();
        let said = nply(&words);
        // an answer, or the file that was asked for
        let written = words.windows(2).any(|pair| pair[0] == "--output" && std::path::Path::new(pair[1]).exists());
        assert!(!said.is_empty() || written, "{line}");
        count += 1;
    }
    assert!(count >= 6);
    // and its picture is what they draw
    let drawn = std::fs::read_to_string(folder.join("three-ply-locus.svg")).unwrap();
    assert!(drawn == read("docs/three-ply-locus.svg"), "docs/three-ply-locus.svg is not what `nply locus` draws");
    assert!(drawn.len() < 20_000);
}

#[test]
fn every_name_in_json_is_documented() {
    let documented = read("docs/json.md");
    let solved = nply(&["solve", "examples/wire-strand-on-core.toml", "--json"]);
    let shape =
        nply(&["contact", "--strands", "3", "--helical-angle", "60 deg", "--diameter", "1 mm", "--branches", "--json"]);
    let supports = nply(&["support", "examples/birdcage.toml", "--json"]);
    let trace = nply(&["trace", "examples/birdcage.toml", "--to-force", "-20 kN", "--json"]);
    let locus = nply(&["locus", "examples/wire-strand-on-core.toml", "--json"]);
    let fit = nply(&["fit-check", "examples/conductor-cardinal.toml", "--json"]);
    let cable =
        nply(&["stiffness", "examples/strand-7-wire.toml", "--preforming", "0", "--torque-factor", "0", "--json"]);
    // the unit behind a name in SI is not part of it
    let suffixes =
        ["_rad_per_m_per_N", "_rad_per_m", "_kg_per_m", "_N_per_m", "_N_m2", "_N_m", "_N", "_Pa", "_m2", "_m", "_deg"];
    let plain = |name: &str| suffixes.iter().find_map(|si| name.strip_suffix(si)).unwrap_or(name).to_owned();
    let mut names = 0;
    for line in [&solved, &shape, &supports, &trace, &locus, &fit, &cable].into_iter().flat_map(|text| text.lines()) {
        // keys of the objects: `"name": …`
        if let Some((name, value)) = line.trim_start().strip_prefix('"').and_then(|rest| rest.split_once("\": ")) {
            assert!(
                documented.contains(&format!("`{name}`"))
                    || documented.contains(&format!("`{}`", plain(name)))
                    || line.contains("\"given\""),
                "{name} is not in docs/json.md"
            );
            // words that a program looks for
            if ["event", "end", "holding", "contacts"].contains(&name) {
                let word = value.trim_end_matches(',').trim_matches('"');
                assert!(documented.contains(&format!("`{word}`")), "{word} is not in docs/json.md");
            }
            names += 1;
        }
    }
    assert!(names > 150, "only {names} names seen");
}

#[test]
fn every_name_and_word_of_a_path_or_map_is_documented() {
    use nply::mechanics::{End, Holding, Mark, Stability, Support};
    let documented = read("docs/json.md");
    let (_, traced) = documented.split_once("## `nply trace --json`").unwrap();
    let says = |name: &str| assert!(traced.contains(&format!("`{name}`")), "{name} is not in docs/json.md");
    let marks = [
        Mark::Arrival,
        Mark::Fold,
        Mark::ContactChange(Support::Free),
        Mark::Separation,
        Mark::Diagonal,
        Mark::MostTurns,
        Mark::CurvatureLimit,
        Mark::Straight,
        Mark::Buckling,
    ];
    marks.iter().for_each(|mark| says(mark.name()));
    [End::Arrival, End::LeftWindow, End::FlatRings, End::Apart, End::UnboundedLoad, End::Stalled]
        .iter()
        .for_each(|end| says(end.name()));
    [Holding::DeadLoads, Holding::Rotation, Holding::Length].iter().for_each(|holding| says(holding.name()));
    [Stability::Stable, Stability::Unstable, Stability::Marginal].iter().for_each(|verdict| says(verdict.name()));
    [Support::Neighbours, Support::Core, Support::Both, Support::Free].iter().for_each(|support| says(support.name()));
    let csv = nply(&["trace", "examples/birdcage.toml", "--to-force", "1 kN", "--format", "csv"]);
    let names = |csv: &str| csv.lines().next().unwrap().split(',').map(str::to_owned).collect::<Vec<_>>();
    // columns in SI are named after the others
    names(&csv).iter().take(6 + 17).for_each(|name| says(name));
    let size = ["--strands", "3", "--radius", "1 mm", "--bending-stiffness", "1 N mm^2", "--stiffness-ratio", "1"];
    let maps: [&[&str]; 4] = [
        &["--pretwist", "-0.2", "--to-force", "1 N", "--to-moment", "1 N mm"],
        &[
            "--pretwist",
            "-0.2",
            "--support-core-radius",
            "1 mm",
            "--to-support-core-radius",
            "2 mm",
            "--to-pretwist",
            "-1",
        ],
        &[
            "--strand-twist",
            "0",
            "--ply-turns-per-strand-length",
            "5 turns/m",
            "--to-strand-twist",
            "1",
            "--to-ply-turns-per-strand-length",
            "6 turns/m",
        ],
        &["--pretwist", "-0.2", "--length-ratio", "0.9", "--to-length-ratio", "0.8", "--to-stiffness-ratio", "0.5"],
    ];
    for map in maps {
        let arguments = [&["map", "--columns", "2", "--rows", "2"], &size[..], map].concat();
        names(&nply(&arguments)).iter().for_each(|name| says(name));
    }
}
