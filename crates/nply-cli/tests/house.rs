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

/// The rooms of the paperwork, floor by floor: a room may name those on the floors before its own.
const FLOORS: [&[&str]; 9] = [
    &["diagnostic", "quantity", "table"],
    &["curves", "key", "preferred"],
    &["plot", "spec"],
    &["case", "construction"],
    &["solve", "study"],
    &["report"],
    &["map", "mesh", "preset", "regression", "sweep"],
    &["graph", "render"],
    &["figure", "schema"],
];

/// What of the crate a text names, each by its first word: `crate::report::Known` and `crate::{Case, report::Known}` name `report`.
fn named_of_the_crate(code: &str) -> Vec<String> {
    let word = |text: &str| text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    let mut names = Vec::new();
    for after in code.split("crate::").skip(1) {
        let Some(list) = after.strip_prefix('{') else {
            names.push(word(after));
            continue;
        };
        let mut depth = 0;
        let mut member = String::new();
        for c in list.chars() {
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => break,
                '}' => depth -= 1,
                ',' if depth == 0 => names.push(word(&std::mem::take(&mut member))),
                c => member.push(c),
            }
        }
        names.push(word(&member));
    }
    names
}

#[test]
fn the_rooms_of_the_paperwork_stand_one_above_the_other() {
    let library = read("crates/nply-sheet/src/lib.rs");
    // what the crate shows under its own name stands in a room
    let mut home = std::collections::BTreeMap::new();
    for (room, names) in library.split("pub use ").skip(1).filter_map(|shown| shown.split_once("::")) {
        for name in names.split(';').next().unwrap().trim_matches(['{', '}']).split(',') {
            home.insert(name.trim().to_owned(), room.to_owned());
        }
    }
    let floor = |room: &str| FLOORS.iter().position(|floor| floor.contains(&room));
    let mut looked_at = 0;
    for (path, text) in sources("crates/nply-sheet/src") {
        let inside = path.split("crates/nply-sheet/src/").nth(1).unwrap();
        let room = inside.split('/').next().unwrap().trim_end_matches(".rs");
        if room == "lib" {
            continue;
        }
        let own = floor(room).unwrap_or_else(|| panic!("{room} has no floor in this test"));
        for name in named_of_the_crate(&code(&text)) {
            let other = home.get(&name).unwrap_or(&name);
            // a function of the crate's own, which every room may use
            if other == room || other == "quoted" || other.is_empty() {
                continue;
            }
            let below = floor(other).unwrap_or_else(|| panic!("{path}: {other} has no floor in this test"));
            assert!(below < own, "{path} names {name}: {other} stands on floor {below}, {room} on {own}");
            looked_at += 1;
        }
    }
    assert!(looked_at > 300);
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

/// Every name of a schema.
fn names(schema: &serde_json::Value, found: &mut std::collections::BTreeSet<String>) {
    match schema {
        serde_json::Value::Object(object) => {
            if let Some(serde_json::Value::Object(properties)) = object.get("properties") {
                found.extend(properties.keys().cloned());
            }
            object.values().for_each(|value| names(value, found));
        }
        serde_json::Value::Array(all) => all.iter().for_each(|value| names(value, found)),
        _ => {}
    }
}

/// What is read and what is written can be looked up: each name stands in docs/symbols.md or docs/json.md, in SI without its unit.
#[test]
fn every_name_that_is_read_or_written_is_told_of() {
    const UNITS: [&str; 14] = [
        "_kg_per_m",
        "_N_per_m",
        "_rad_per_m_per_N",
        "_rad_per_m",
        "_N_m2",
        "_N_m",
        "_m2",
        "_Pa",
        "_N",
        "_m",
        "_deg",
        "_percent",
        "_kg",
        "_turns",
    ];
    let docs = read("docs/symbols.md") + &read("docs/json.md");
    let told: std::collections::BTreeSet<&str> = docs.split('`').skip(1).step_by(2).collect();
    let mut wanted = std::collections::BTreeSet::new();
    for report in &nply_sheet::schema::REPORTS {
        names(&report.schema(), &mut wanted);
    }
    let outputs = wanted.len();
    let keys = nply_sheet::KEYS.iter().chain(&nply_sheet::construction::CONSTRUCTION_KEYS);
    wanted.extend(keys.map(|key| key.name.to_owned()));
    assert!(outputs > 200 && wanted.len() > outputs);
    let bare = |name: &str| UNITS.iter().find_map(|unit| name.strip_suffix(unit)).map(str::to_owned);
    let untold: Vec<&String> = wanted
        .iter()
        .filter(|name| !told.contains(name.as_str()) && bare(name).is_none_or(|bare| !told.contains(bare.as_str())))
        .collect();
    assert!(untold.is_empty(), "neither docs/symbols.md nor docs/json.md tells of {untold:?}");
}

/// Each equation that the table of symbols names has its text beside the theory: `eq38.md`, `eqA30.md`, or one for several, `eq34_36.md`.
#[test]
fn every_equation_that_a_symbol_names_has_its_text() {
    let texts = fs::read_dir(root().join("crates/nply/src/equations")).unwrap();
    let mut known = std::collections::BTreeSet::new();
    for entry in texts {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let Some(numbers) = name.strip_prefix("eq").and_then(|rest| rest.strip_suffix(".md")) else { continue };
        let appendix = numbers.starts_with('A');
        let ends: Option<Vec<u32>> =
            numbers.trim_start_matches('A').split('_').map(|number| number.parse().ok()).collect();
        if let Some([first, .., last] | [first @ last]) = ends.as_deref() {
            known.extend((*first..=*last).map(|number| (appendix, number)));
        }
    }
    assert!(known.len() > 100, "{}", known.len());
    let table = read("docs/symbols.md");
    let mut count = 0;
    for row in table.lines().filter(|line| line.starts_with("| ")) {
        let Some(cell) = row.split('|').nth(4) else { continue };
        for named in cell.split('(').skip(1).filter_map(|rest| rest.split(')').next()) {
            let appendix = named.starts_with("A.");
            let Ok(number) = named.trim_start_matches("A.").parse::<u32>() else { continue };
            assert!(
                known.contains(&(appendix, number)),
                "docs/symbols.md names ({named}), of which there is no text: {row}"
            );
            count += 1;
        }
    }
    assert!(count > 40, "{count}");
}
