//! What a program of ours says, taken in as Markdown: `rust crates/NAME/examples/NAME.rs`, or a folder's `main.rs`, words after it handed over;
//! `python PATH` for one that needs Python's own library alone.

use std::process::Command;

use crate::command::Runner;
use crate::site::Site;

/// The program's standard output. It is built as tests are, so that nothing is compiled for it a second time, and finds the site's command in `NPLY`.
pub(crate) fn expand(wish: &str, site: &Site, runner: &Runner) -> Result<String, String> {
    let mut words = wish.split_whitespace();
    let (language, path) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
    let mut program = match language {
        "rust" => {
            let (package, example) =
                example(path).ok_or("wanted is crates/NAME/examples/NAME.rs or crates/NAME/examples/NAME/main.rs")?;
            let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
            cargo.args(["run", "--quiet", "--package", package, "--example", example, "--"]);
            cargo
        }
        "python" => {
            let mut python = Command::new(if cfg!(windows) { "python" } else { "python3" });
            python.arg(path);
            python
        }
        _ => return Err("wanted is rust or python, and the path of a program".to_owned()),
    };
    let said = runner.hear(program.args(words).env("NPLY", &site.command))?;
    if said.code != Some(0) {
        return Err(format!("it ended with {:?}\n{}", said.code, said.error.trim_end()));
    }
    Ok(format!("\n{}\n\n", said.output.trim()))
}

/// Package and name of an example by the path of its first file.
fn example(path: &str) -> Option<(&str, &str)> {
    let (package, file) = path.strip_prefix("crates/")?.split_once("/examples/")?;
    let name = file.strip_suffix("/main.rs").or_else(|| file.strip_suffix(".rs"))?;
    (!name.contains('/')).then_some((package, name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_example_is_a_file_or_a_folder() {
        assert_eq!(example("crates/nply/examples/yarn.rs"), Some(("nply", "yarn")));
        assert_eq!(example("crates/nply-cli/examples/validate/main.rs"), Some(("nply-cli", "validate")));
        assert_eq!(example("crates/nply-cli/examples/validate/table.rs"), None);
        assert_eq!(example("crates/nply/src/lib.rs"), None);
    }
}
