//! Our side of a number: a command as a stranger types it, or a call of the library.

use std::collections::HashMap;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::published::Number;
use crate::theory;

/// Runs commands, each once.
pub(crate) struct Ours {
    nply: PathBuf,
    root: PathBuf,
    said: HashMap<String, String>,
}

impl Ours {
    /// With the command's file, and the folder in which commands are typed.
    pub(crate) fn new(nply: PathBuf, root: PathBuf) -> Self {
        Self { nply, root, said: HashMap::new() }
    }

    /// The value, in the published unit; nothing where the file names no way to it.
    pub(crate) fn of(&mut self, number: &Number) -> Result<Option<f64>, String> {
        let raw = match (&number.command, &number.path, &number.theory) {
            (Some(command), Some(path), None) => {
                let text = self.say(command)?;
                if command.ends_with("--csv") { in_csv(&text, path)? } else { in_json(&text, path)? }
            }
            (None, None, Some(call)) => theory::call(call)?,
            (None, None, None) => return Ok(None),
            _ => return Err("a number has a command and a path, or a theory, or neither".to_owned()),
        };
        let value = if number.complement { 90.0 - raw } else { raw };
        let value = value * number.times.unwrap_or(1.0);
        if value.is_finite() { Ok(Some(value)) } else { Err(format!("{value} is no answer")) }
    }

    fn say(&mut self, line: &str) -> Result<String, String> {
        if let Some(text) = self.said.get(line) {
            return Ok(text.clone());
        }
        let mut text = String::new();
        for part in line.split(" | ") {
            text = self.run(&words(part), &text).map_err(|error| format!("`{part}`: {error}"))?;
        }
        self.said.insert(line.to_owned(), text.clone());
        Ok(text)
    }

    fn run(&self, words: &[String], input: &str) -> Result<String, String> {
        let [name, arguments @ ..] = words else { return Err("no command".to_owned()) };
        if name != "nply" {
            return Err("only nply is run".to_owned());
        }
        let mut command = Command::new(&self.nply);
        command.args(arguments).current_dir(&self.root);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().map_err(|error| error.to_string())?;
        if let Some(mut stdin) = child.stdin.take() {
            let _ = stdin.write_all(input.as_bytes()); // a command that wants no input closes the pipe
        }
        let output = child.wait_with_output().map_err(|error| error.to_string())?;
        if output.status.success() {
            String::from_utf8(output.stdout).map_err(|error| error.to_string())
        } else {
            Err(String::from_utf8_lossy(&output.stderr).into_owned())
        }
    }
}

/// Words between blanks; quotation marks keep blanks together.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    let (mut word, mut quoted) = (String::new(), false);
    for letter in line.chars() {
        match letter {
            '"' => quoted = !quoted,
            ' ' if !quoted => {
                if !word.is_empty() {
                    words.push(core::mem::take(&mut word));
                }
            }
            _ => word.push(letter),
        }
    }
    if !word.is_empty() {
        words.push(word);
    }
    words
}

/// `states[0].helical_angle_deg`; an index from the end is negative, and `[key=number]` is the first entry with that value.
fn in_json(text: &str, path: &str) -> Result<f64, String> {
    let mut value: &Value = &serde_json::from_str(text).map_err(|error| error.to_string())?;
    let missing = |step: &str| format!("{path}: no {step} in the answer");
    for step in path.split(['.', '[']) {
        let Some(index) = step.strip_suffix(']') else {
            value = value.get(step).ok_or_else(|| missing(step))?;
            continue;
        };
        let list = value.as_array().ok_or_else(|| missing(step))?;
        let found = if let Some((key, wanted)) = index.split_once('=') {
            let wanted: f64 = wanted.parse().map_err(|_| missing(step))?;
            list.iter().find(|entry| entry[key].as_f64() == Some(wanted))
        } else if let Some(back) = index.strip_prefix('-') {
            back.parse().ok().and_then(|back: usize| list.iter().rev().nth(back.checked_sub(1)?))
        } else {
            index.parse().ok().and_then(|index: usize| list.get(index))
        };
        value = found.ok_or_else(|| missing(step))?;
    }
    value.as_f64().ok_or_else(|| format!("{path} is no number"))
}

/// `word / word : column`: the last row that begins with these words.
fn in_csv(text: &str, path: &str) -> Result<f64, String> {
    let (wanted, column) = path.split_once(" : ").ok_or_else(|| format!("{path}: no column"))?;
    let wanted: Vec<&str> = wanted.split(" / ").collect();
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let place = names.iter().position(|name| *name == column).ok_or_else(|| format!("no column {column}"))?;
    let row = lines
        .map(|line| line.split(',').collect::<Vec<_>>())
        .rfind(|cells| cells.starts_with(&wanted))
        .ok_or_else(|| format!("no row {path}"))?;
    row.get(place).and_then(|cell| cell.parse().ok()).ok_or_else(|| format!("{path} is no number"))
}
