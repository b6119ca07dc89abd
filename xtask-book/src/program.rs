//! A program shown whole, and below it what it says: `python path` or `rust path`.

use std::fs;
use std::process::Command;

use crate::command::Runner;
use crate::example;
use crate::fence::fenced;
use crate::site::Site;

/// The program and its output in the page.
pub(crate) fn expand(wish: &str, site: &Site, runner: &Runner) -> Result<String, String> {
    let (language, path) = wish.split_once(' ').ok_or("wanted is a language and a path")?;
    let path = path.trim();
    let source = fs::read_to_string(site.root.join(path)).map_err(|error| format!("cannot read {path}: {error}"))?;
    let said = match language {
        // one that needs nothing but Python's own library runs under any
        "python" => match (&site.python, source.contains("import nply") || source.contains("from nply")) {
            (Some(python), _) => runner.hear(Command::new(python).arg(path))?,
            (None, false) => runner.hear(Command::new("python3").arg(path))?,
            (None, true) => return Ok(shown(language, path, &source, "")),
        },
        "rust" => runner.hear(&mut Command::new(example::built(path, runner)?))?,
        other => return Err(format!("`{other}` is neither python nor rust")),
    };
    if said.code != Some(0) {
        return Err(format!("{path} ended with {:?}\n{}", said.code, said.error.trim_end()));
    }
    Ok(shown(language, path, &source, &said.output))
}

fn shown(language: &str, path: &str, source: &str, output: &str) -> String {
    let mut page =
        format!("\n<div class=\"console program\">\n\n<p class=\"path\">{path}</p>\n\n{}\n", fenced(language, source));
    if !output.trim().is_empty() {
        page.push_str(&fenced("text,said", output));
        page.push('\n');
    }
    page.push_str("</div>\n\n");
    page
}
