//! What a program of ours says, taken in as Markdown: `rust crates/NAME/examples/NAME.rs`, or a folder's `main.rs`, words after it handed over;
//! `python PATH` for one that needs Python's own library alone.

use std::process::Command;

use crate::command::Runner;
use crate::example;
use crate::site::Site;

/// The program's standard output. It is built as tests are, so that nothing is compiled for it a second time, and finds the site's command in `NPLY`.
pub(crate) fn expand(wish: &str, site: &Site, runner: &Runner) -> Result<String, String> {
    let mut words = wish.split_whitespace();
    let (language, path) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
    let mut program = match language {
        "rust" => Command::new(example::built(path, runner)?),
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
