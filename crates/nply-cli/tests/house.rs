//! Who may know whom, and what is said twice and must agree.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: impl AsRef<Path>) -> String {
    let path = root().join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Every Rust file below a folder, with its text.
fn sources(folder: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push((path.display().to_string(), fs::read_to_string(&path).unwrap()));
            }
        }
    }
    assert!(found.len() >= 2, "{folder}");
    found
}

/// The code of a text, without comments and without what stands in its tests.
fn code(text: &str) -> String {
    let before_tests = text.split("#[cfg(test)]\nmod ").next().unwrap();
    before_tests.lines().map(|line| line.split("//").next().unwrap()).collect::<Vec<_>>().join("\n")
}

/// The crates of ours that a manifest depends on, tests apart.
fn dependencies(package: &str) -> Vec<String> {
    let manifest = read(format!("crates/{package}/Cargo.toml"));
    let section = manifest.split("\n[dependencies]\n").nth(1).unwrap().split("\n[").next().unwrap();
    let names = section.lines().filter_map(|line| line.split(['.', ' ', '=']).next());
    names.filter(|name| name.starts_with("nply")).map(str::to_owned).collect()
}

#[test]
fn a_crate_imports_only_what_stands_below_it() {
    assert_eq!(dependencies("nply"), [""; 0]);
    assert_eq!(dependencies("nply-sheet"), ["nply"]);
    assert_eq!(dependencies("nply-cli"), ["nply", "nply-sheet"]);
    for entry in fs::read_dir(root().join("crates")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let ours = dependencies(&name);
        assert!(
            ours.iter().all(|other| ["nply", "nply-sheet"].contains(&other.as_str())),
            "{name} imports a door: {ours:?}"
        );
    }
}

#[test]
fn inside_the_theory_numbers_know_no_shape_and_shapes_no_force() {
    for (room, above) in [
        ("numerics", &["geometry", "mechanics", "topology", "Handedness", "Scale"][..]),
        ("geometry", &["mechanics", "topology"]),
        ("mechanics", &["topology"]),
        ("topology", &["mechanics"]),
    ] {
        if !root().join("crates/nply/src").join(room).exists() {
            continue;
        }
        for (path, text) in sources(&format!("crates/nply/src/{room}")) {
            for line in code(&text).lines() {
                let line = line.trim();
                for name in above {
                    let imported = (line.starts_with("use ") || line.starts_with("pub use ")) && line.contains(name);
                    let named =
                        ["crate::", "super::", "nply::"].iter().any(|from| line.contains(&format!("{from}{name}")));
                    assert!(!imported && !named, "{path}: {line}");
                }
            }
        }
    }
}

#[test]
fn theory_and_paperwork_touch_no_file_and_print_nothing() {
    for folder in ["crates/nply/src", "crates/nply-sheet/src"] {
        for (path, text) in sources(folder) {
            let code = code(&text);
            for word in [
                "std::fs",
                "std::env::",
                "std::io",
                "std::net",
                "std::process",
                "std::time",
                "std::thread",
                "println!",
                "print!(",
                "eprintln!",
                "eprint!(",
                "dbg!(",
            ] {
                // tables are written to whatever a door hands over
                let handed_over = word == "std::io" && path.contains("/nply-sheet/src/table/");
                assert!(handed_over || !code.contains(word), "{path}: {word}");
            }
        }
    }
}

#[test]
fn the_version_is_the_same_wherever_it_is_said() {
    let version = env!("CARGO_PKG_VERSION");
    assert!(read("CITATION.cff").lines().any(|line| line == format!("version: {version}")));
    let manifest = read("Cargo.toml");
    assert!(manifest.contains(&format!("\nversion = \"{version}\"\n")));
    for name in ["nply", "nply-sheet"] {
        assert!(
            manifest.contains(&format!("{name} = {{ path = \"crates/{name}\", version = \"{version}\" }}")),
            "{name}"
        );
    }
}

/// Each name in the second column of the table of symbols is a word of the code.
#[test]
fn every_symbol_has_its_name_in_the_code() {
    let code: String = ["crates/nply/src", "crates/nply-sheet/src"]
        .iter()
        .flat_map(|folder| sources(folder))
        .map(|(_, text)| code(&text))
        .collect();
    let words: std::collections::BTreeSet<&str> = code.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    let table = read("docs/symbols.md");
    let columns = table.lines().filter(|line| line.starts_with("| ")).filter_map(|row| row.split('|').nth(2));
    let names: Vec<&str> = columns.flat_map(|column| column.split('`').skip(1).step_by(2)).collect();
    let unknown: Vec<&&str> = names.iter().filter(|name| !words.contains(*name)).collect();
    assert!(unknown.is_empty(), "docs/symbols.md has names that the code has not: {unknown:?}");
    assert!(names.len() > 30);
}
