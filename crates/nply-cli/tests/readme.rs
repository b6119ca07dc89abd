//! What the README and docs/json.md show is what the command does.
#![allow(clippy::unwrap_used, clippy::panic)] // a test fails by panicking

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
fn the_readme_shows_a_real_output() {
    let output = nply(&["solve", "examples/three-ply-yarn.toml"]);
    assert!(read("README.md").contains(output.trim_end()), "README.md does not show\n{output}");
}

#[test]
fn every_name_in_json_is_documented() {
    let documented = read("docs/json.md");
    let solved = nply(&["solve", "examples/wire-strand-on-core.toml", "--json"]);
    let shape =
        nply(&["contact", "--strands", "3", "--helical-angle", "60 deg", "--diameter", "1 mm", "--branches", "--json"]);
    let supports = nply(&["support", "examples/birdcage.toml", "--json"]);
    let mut names = 0;
    for line in solved.lines().chain(shape.lines()).chain(supports.lines()) {
        // keys of the objects: `"name": …`
        if let Some((name, _)) = line.trim_start().strip_prefix('"').and_then(|rest| rest.split_once("\": ")) {
            assert!(
                documented.contains(&format!("`{name}`")) || line.contains("\"given\""),
                "{name} is not in docs/json.md"
            );
            names += 1;
        }
    }
    assert!(names > 150, "only {names} names seen");
}
