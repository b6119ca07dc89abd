//! Programs of ours in Rust: the examples of the crates, found by their path.

use std::path::PathBuf;
use std::process::Command;

use crate::command::Runner;

/// Name of an example by the path of its first file: `crates/NAME/examples/NAME.rs`, or a folder's `main.rs`.
pub(crate) fn name(path: &str) -> Option<&str> {
    let (_, file) = path.strip_prefix("crates/")?.split_once("/examples/")?;
    let name = file.strip_suffix("/main.rs").or_else(|| file.strip_suffix(".rs"))?;
    (!name.contains('/')).then_some(name)
}

/// The example as an executable: out of the folder that `NPLY_EXAMPLES` names, where the workspace's tests have just built them all, else built
/// for this. (Built for itself it stands on crates of other features than the tests do, which takes a minute.)
pub(crate) fn built(path: &str, runner: &Runner) -> Result<PathBuf, String> {
    let name = name(path).ok_or("wanted is crates/NAME/examples/NAME.rs or crates/NAME/examples/NAME/main.rs")?;
    let there = std::env::var_os("NPLY_EXAMPLES");
    let there = there.map(|folder| PathBuf::from(folder).join(format!("{name}{}", std::env::consts::EXE_SUFFIX)));
    if let Some(executable) = there.filter(|path| path.is_file()) {
        return Ok(executable);
    }
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["build", "--quiet", "--workspace", "--message-format", "json-render-diagnostics", "--example", name]);
    let said = runner.hear(&mut cargo)?;
    let executable = said.output.lines().rev().find_map(|line| {
        let message: serde_json::Value = serde_json::from_str(line).ok()?;
        message["executable"].as_str().map(PathBuf::from)
    });
    executable.ok_or_else(|| format!("{path} was not built\n{}", said.error.trim_end()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_example_is_a_file_or_a_folder() {
        assert_eq!(name("crates/nply/examples/yarn.rs"), Some("yarn"));
        assert_eq!(name("crates/nply-cli/examples/validate/main.rs"), Some("validate"));
        assert_eq!(name("crates/nply-cli/examples/validate/table.rs"), None);
        assert_eq!(name("crates/nply/src/lib.rs"), None);
    }
}
