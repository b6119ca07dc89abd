//! The schemas against what is read and written: documents by how they must end, reports as they come out.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs;
use std::path::{Path, PathBuf};

use command::{call, json, out, root};
use jsonschema::Validator;
use serde_json::Value;

fn schema(flag: &str, name: &str) -> Value {
    json(&["schema", &format!("--{flag}"), name])
}

fn validator(schema: &Value) -> Validator {
    jsonschema::draft202012::meta::validate(schema).unwrap_or_else(|error| panic!("no schema: {error}"));
    jsonschema::draft202012::new(schema).unwrap()
}

/// What is wrong with a value, a line each.
fn faults(validator: &Validator, value: &Value) -> Vec<String> {
    validator.iter_errors(value).map(|error| format!("{}: {error}", error.instance_path())).collect()
}

/// The TOML files of a folder.
fn documents(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).unwrap_or_else(|error| panic!("{folder}: {error}"));
    let mut found: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    found.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    found.sort();
    assert!(!found.is_empty(), "{folder}");
    found
}

/// A document as the JSON it stands for; `None` for what is no TOML, or is none as JSON.
fn read(path: &Path) -> Option<Value> {
    let table: toml::Table = toml::from_str(&fs::read_to_string(path).ok()?).ok()?;
    serde_json::to_value(table).ok()
}

/// The kind of a document: what has layers is a construction.
fn kind(document: &Value) -> &'static str {
    if document.get("layer").is_some() || document.get("construction").is_some() { "construction" } else { "ply" }
}

#[test]
fn every_document_that_is_taken_is_valid() {
    let of = |kind| validator(&schema("document", kind));
    let (ply, construction) = (of("ply"), of("construction"));
    let mut count = 0;
    for folder in [
        "examples",
        "examples/fit",
        "examples/jobs",
        "examples/studies",
        "crates/nply-sheet/presets",
        "tests/inputs/ok",
        "tests/inputs/no_equilibrium",
    ] {
        for path in documents(folder) {
            let document = read(&path).unwrap_or_else(|| panic!("{} is no TOML", path.display()));
            let validator = if kind(&document) == "ply" { &ply } else { &construction };
            assert_eq!(faults(validator, &document), [""; 0], "{}", path.display());
            count += 1;
        }
    }
    assert!(count > 50, "{count}");
}

/// What the reader refuses for its keys or the sorts of its values, the schema refuses.
#[test]
fn documents_with_unknown_keys_are_refused() {
    let validator = validator(&schema("document", "ply"));
    let mut unknown = 0;
    for folder in ["tests/inputs/parse_error", "tests/inputs/unit_error", "tests/inputs/domain_error"] {
        for path in documents(folder) {
            let said = call(&["solve", path.to_str().unwrap()]).err;
            let is_unknown =
                [" is no key of ", " is no table of ", " stands in no table"].iter().any(|words| said.contains(words));
            let Some(document) = read(&path).filter(|_| is_unknown) else { continue };
            assert!(!validator.is_valid(&document), "{}: {said}", path.display());
            unknown += 1;
        }
    }
    assert!(unknown >= 5, "{unknown}");
    for (document, word) in [
        ("[ply]\nstrand = 3\n", "strand"),
        ("[ply]\nstrands = [3]\n", "strands"),
        ("[ply]\nhand = \"up\"\n", "hand"),
        ("[strand]\nstretch = \"true\"\n", "stretch"),
        ("[strand]\nradius = 1\ndiameter = 2\n", "strand"),
        ("[strand]\nyoungs_modulus = 3\n", "youngs_modulus"),
        ("[map]\nto.strand.radius = 2\n", "map"),
        ("[sweep]\nstates = \"some\"\n", "states"),
        ("[sweep]\nload.force = { from = 1 }\n", "force"),
        ("[[path]]\nload.external_pressure = 1\n", "path"),
        ("title = \"a ply\"\n", "title"),
    ] {
        let read: toml::Table = toml::from_str(document).unwrap();
        let faults = faults(&validator, &serde_json::to_value(read).unwrap());
        assert!(faults.iter().any(|fault| fault.contains(word)), "{document}: {faults:?}");
    }
}

#[test]
fn layered_strands_nest_as_deep_as_the_reader_goes() {
    let validator = validator(&schema("document", "construction"));
    let nested = |depth: usize| {
        let core = (0..depth)
            .map(|at| format!("[core{}]\nlayer = [{{ wires = 6 }}]\n", ".strand.core".repeat(at) + ".strand"));
        let text: String = core.collect();
        serde_json::to_value(toml::from_str::<toml::Table>(&text).unwrap()).unwrap()
    };
    assert_eq!(faults(&validator, &nested(3)), [""; 0]);
    assert!(!validator.is_valid(&nested(4)));
    for text in ["[[layer]]\nwire = 6\n", "[core.strand.load]\nforce = 1\n", "[ply]\nstrands = 3\n"] {
        let document = serde_json::to_value(toml::from_str::<toml::Table>(text).unwrap()).unwrap();
        assert!(!validator.is_valid(&document), "{text}");
    }
}

/// Every object of known names takes no others: what a report has is what its schema tells of.
fn closed(schema: &mut Value) {
    match schema {
        Value::Object(object) => {
            if object.contains_key("properties") {
                object.insert("additionalProperties".into(), Value::Bool(false));
            }
            object.values_mut().for_each(closed);
        }
        Value::Array(all) => all.iter_mut().for_each(closed),
        _ => {}
    }
}

#[test]
fn every_report_is_valid_and_has_no_name_that_its_schema_has_not() {
    let mut reports: Vec<(String, String, Value)> = Vec::new();
    let list: Value = serde_json::from_str(&fs::read_to_string(root().join("tests/cases/list.json")).unwrap()).unwrap();
    for case in list["cases"].as_array().unwrap() {
        let (name, verb) = (case["name"].as_str().unwrap(), case["verb"].as_str().unwrap());
        let text = fs::read_to_string(root().join(format!("tests/cases/{name}.json"))).unwrap();
        reports.push((name.to_owned(), verb.to_owned(), serde_json::from_str(&text).unwrap()));
    }
    // what the shared cases leave out
    let pull = "tests/inputs/ok/strands_that_stretch_clamped.toml";
    for arguments in [
        &["writhe", "examples/curves/trefoil.csv", "--closed", "--average-crossings", "--json"][..],
        &["writhe", "examples/curves/trefoil.csv", "--method", "tree", "--json"],
        &["writhe", "examples/curves/rings.csv", "--json"],
        &["link", "examples/curves/rings.csv", "--json"],
        &["clearance", "examples/curves/seven-wires.csv", "--diameter", "2", "--json"],
        &["clearance", "examples/curves/seven-wires.csv", "--json"],
        &["preset", "--json"],
        &["solve", pull, "--json"],
        &["trace", "examples/steel-strand-pulled.toml", "--to-force", "20 kN", "--json"],
        &[
            "fit",
            "examples/fit/cord-pull.csv",
            "examples/fit/cord.toml",
            "--estimate",
            "bending_stiffness,diameter",
            "--json",
        ],
        &[
            "fit",
            "examples/fit/balance.csv",
            "--strands",
            "3",
            "--stiffness-ratio",
            "1",
            "--estimate",
            "stiffness_ratio",
            "--json",
        ],
        &["stiffness", "examples/spiral-strand-1x19.toml", "--json"],
        &[
            "fit-check",
            "--strands",
            "6",
            "--core-diameter",
            "2",
            "--wire-diameter",
            "2",
            "--lay-length",
            "60",
            "--gap",
            "0.1",
            "--json",
        ],
        &["nodes", "--strands", "6", "--hand", "Z", "--lay-ratio", "8", "--core", "--json"],
        &["nodes", "--strands", "6", "--diameter", "2 mm", "--hand", "S", "--lay-length", "60 mm", "--json"],
        &["nodes", "examples/spiral-strand-1x19.toml", "--element-type", "B32", "--json"],
        &["contact", "--strands", "1", "--diameter", "2 mm", "--json"],
        &["locus", "examples/three-ply-yarn.toml", "--json"],
        &["solve", "examples/three-ply-yarn.toml", "--strand-length", "1 m", "--json"],
        &[
            "solve",
            "--strands",
            "3",
            "--stiffness-ratio",
            "0.75",
            "--pretwist",
            "-1",
            "--external-pressure",
            "-0.1",
            "--json",
        ],
    ] {
        let answer = call(arguments);
        assert_eq!(answer.code, 0, "{arguments:?}: {}", answer.err);
        let report = serde_json::from_str(&answer.out).unwrap_or_else(|error| panic!("{arguments:?}: {error}"));
        reports.push((arguments.join(" "), arguments[0].to_owned(), report));
    }
    let mut told = std::collections::BTreeMap::new();
    for (name, verb, report) in &reports {
        let (open, shut) = told.entry(verb.clone()).or_insert_with(|| {
            let open = schema("report", verb);
            let mut shut = open.clone();
            closed(&mut shut);
            (validator(&open), validator(&shut))
        });
        assert_eq!(faults(open, report), [""; 0], "{name}");
        assert_eq!(faults(shut, report), [""; 0], "{name}");
        // and a name that is missing is missed
        let mut less = report.clone();
        less.as_object_mut().unwrap().shift_remove("schema_version");
        assert!(!open.is_valid(&less), "{name}");
    }
    let listed = out(&["schema"]);
    let kinds: Vec<&str> =
        listed.lines().filter_map(|line| line.split("--report ").nth(1)?.split_whitespace().next()).collect();
    assert!(kinds.len() > 10);
    for kind in kinds {
        assert!(told.contains_key(kind), "no report of `nply {kind}` is tried");
    }
}

#[test]
fn a_kind_that_there_is_not_is_refused() {
    assert_eq!(call(&["schema", "--document", "rope"]).code, 2);
    assert_eq!(call(&["schema", "--report", "solve", "--document", "ply"]).code, 2);
}
