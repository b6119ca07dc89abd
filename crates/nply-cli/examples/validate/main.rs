//! Every published number beside ours: `cargo xtask validate` prints it as Markdown, `cargo xtask validate --json` as JSON.
//!
//! The numbers stand in authorities/published.toml. Exit status 1 if a difference is not the one that is stated there.

mod ours;
mod published;
mod table;
mod theory;
mod verdict;

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use ours::Ours;
use published::Published;

fn main() -> ExitCode {
    let as_json = std::env::args().skip(1).any(|argument| argument == "--json");
    match report(as_json) {
        Ok((text, held)) => {
            // a closed pipe is no error
            let _ = writeln!(std::io::stdout(), "{}", text.trim_end());
            if held { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "validate: {error}");
            ExitCode::FAILURE
        }
    }
}

fn report(as_json: bool) -> Result<(String, bool), String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let file = root.join("authorities/published.toml");
    let text = std::fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    let published = Published::read(&text)?;
    let mut ours = Ours::new(nply()?, root);
    let rows = verdict::rows(&published, |number| ours.of(number))?;
    let astray: Vec<&str> = rows.iter().filter(|row| !row.holds()).map(|row| row.number.id.as_str()).collect();
    if !astray.is_empty() {
        let _ = writeln!(std::io::stderr(), "validate: not the difference that is stated: {}", astray.join(", "));
    }
    let text =
        if as_json { format!("{:#}", table::json(&published, &rows)) } else { table::markdown(&published, &rows) };
    Ok((text, astray.is_empty()))
}

/// The command, built beside this program: target/PROFILE/nply for target/PROFILE/examples/validate. The variable NPLY names another.
fn nply() -> Result<PathBuf, String> {
    if let Some(named) = std::env::var_os("NPLY") {
        return Ok(PathBuf::from(named));
    }
    let here = std::env::current_exe().map_err(|error| error.to_string())?;
    let folder = here.parent().and_then(Path::parent).ok_or("this program stands in no folder")?;
    let command = folder.join(format!("nply{}", std::env::consts::EXE_SUFFIX));
    if command.exists() { Ok(command) } else { Err(format!("{} is not built", command.display())) }
}
