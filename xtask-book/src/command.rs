//! A command line of a chapter: run in the project's root, its files in the book's own folder.

use std::collections::{BTreeSet, HashMap};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

use crate::site::Site;

/// What a command said.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Said {
    /// Its exit code; of a pipe that of the last command. A command that a signal ended has none.
    pub(crate) code: Option<i32>,
    /// Standard output.
    pub(crate) output: String,
    /// Standard error.
    pub(crate) error: String,
}

/// What is told of, for whoever waits for the book.
const SLOW: Duration = Duration::from_secs(3);

/// What a command said, or why it cannot be run.
type Heard = Result<Said, String>;

/// Runs each command once, however often it is asked for.
#[derive(Debug)]
pub(crate) struct Runner {
    path: OsString,
    root: PathBuf,
    said: Mutex<HashMap<String, Arc<OnceLock<Heard>>>>,
    slow: Mutex<Vec<(Duration, String)>>,
}

impl Runner {
    /// A runner for which `nply` is the site's command, whatever else of that name is installed.
    pub(crate) fn new(site: &Site) -> Result<Self, String> {
        let mut folders = vec![site.command.parent().unwrap_or(Path::new(".")).to_path_buf()];
        if let Some(path) = std::env::var_os("PATH") {
            folders.extend(std::env::split_paths(&path));
        }
        let path = std::env::join_paths(folders).map_err(|error| error.to_string())?;
        Ok(Self { path, root: site.root.clone(), said: Mutex::default(), slow: Mutex::default() })
    }

    /// What a line, a command or a pipe, says.
    pub(crate) fn run(&self, line: &str) -> Heard {
        let cell = {
            let mut said = self.said.lock().unwrap_or_else(PoisonError::into_inner);
            Arc::clone(said.entry(line.to_owned()).or_default())
        };
        cell.get_or_init(|| {
            let start = Instant::now();
            let heard = self.hear(Command::new("sh").arg("-c").arg(line));
            if start.elapsed() > SLOW {
                self.slow.lock().unwrap_or_else(PoisonError::into_inner).push((start.elapsed(), line.to_owned()));
            }
            heard
        })
        .clone()
    }

    /// The commands that took long, and how long.
    pub(crate) fn slow(self) -> Vec<(Duration, String)> {
        self.slow.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    /// What a program says, run in the root.
    pub(crate) fn hear(&self, command: &mut Command) -> Heard {
        let output = command
            .current_dir(&self.root)
            .env("PATH", &self.path)
            .env("NO_COLOR", "1")
            .env_remove("CLICOLOR_FORCE")
            .stdin(Stdio::null())
            .output()
            .map_err(|error| format!("cannot start {}: {error}", command.get_program().to_string_lossy()))?;
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).map_err(|_| "its output is not text".to_owned());
        Ok(Said { code: output.status.code(), output: text(output.stdout)?, error: text(output.stderr)? })
    }
}

/// A chapter's folder of files that its commands write under bare names.
#[derive(Debug)]
pub(crate) struct Bench {
    /// The folder.
    folder: PathBuf,
    /// The names written so far.
    names: BTreeSet<String>,
}

/// A line as it is run, and what it writes.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Placed {
    /// The line, bare names in place.
    pub(crate) line: String,
    /// The bare names it writes.
    pub(crate) writes: Vec<String>,
}

impl Bench {
    pub(crate) fn new(folder: PathBuf) -> Self {
        Self { folder, names: BTreeSet::new() }
    }

    /// Where a bare name stands.
    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// Puts a line's files into the folder: those it writes, and those that lines before it wrote.
    pub(crate) fn place(&mut self, line: &str) -> Placed {
        let words = words(line);
        let mut placed = Placed { line: String::new(), writes: Vec::new() };
        let (mut copied, mut writes_next) = (0, false);
        for word in &words {
            let is_flag = |text: &str| matches!(text, "--output" | "-o" | "--plot");
            let (start, name, written) = match word.text.split_once('=') {
                Some((flag, name)) if is_flag(flag) => (word.start + flag.len() + 1, name, true),
                _ => (word.start, word.text.as_str(), writes_next),
            };
            writes_next = is_flag(&word.text);
            let is_bare = !name.is_empty() && !name.starts_with('-') && !name.contains(['/', '|']);
            let known = self.names.contains(name) || placed.writes.iter().any(|other| other == name);
            if is_bare && (written || known) {
                placed.line.push_str(&line[copied..start]);
                placed.line.push_str(&format!("'{}'", self.path(name).display()));
                copied = word.end;
                if written {
                    placed.writes.push(name.to_owned());
                }
            }
        }
        placed.line.push_str(&line[copied..]);
        self.names.extend(placed.writes.iter().cloned());
        placed
    }

    /// A command's words with the bare names again in place of the paths.
    pub(crate) fn unplaced(&self, text: &str) -> String {
        text.replace(&format!("{}{}", self.folder.display(), std::path::MAIN_SEPARATOR), "")
    }
}

struct Word {
    start: usize,
    end: usize,
    /// Without quotes.
    text: String,
}

/// The words of a line as a shell has them, quotes and all but no more.
fn words(line: &str) -> Vec<Word> {
    let mut words: Vec<Word> = Vec::new();
    let mut open: Option<Word> = None;
    let mut quote: Option<char> = None;
    for (at, letter) in line.char_indices() {
        if quote.is_none() && letter.is_whitespace() {
            words.extend(open.take());
            continue;
        }
        let word = open.get_or_insert_with(|| Word { start: at, end: at, text: String::new() });
        word.end = at + letter.len_utf8();
        match quote {
            Some(mark) if mark == letter => quote = None,
            None if letter == '"' || letter == '\'' => quote = Some(letter),
            _ => word.text.push(letter),
        }
    }
    words.extend(open);
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bare_names_stand_in_the_chapters_folder() {
        let mut bench = Bench::new(PathBuf::from("/made/x"));
        let placed = bench.place("nply plot a.toml --sweep \"pretwist=-3..3\" --output yarn.svg");
        assert_eq!(placed.line, "nply plot a.toml --sweep \"pretwist=-3..3\" --output '/made/x/yarn.svg'");
        assert_eq!(placed.writes, ["yarn.svg"]);
        let placed = bench.place("nply map --output=map.csv --plot 'map.png' | cat yarn.svg -");
        assert_eq!(
            placed.line,
            "nply map --output='/made/x/map.csv' --plot '/made/x/map.png' | cat '/made/x/yarn.svg' -"
        );
        assert_eq!(placed.writes, ["map.csv", "map.png"]);
        assert_eq!(bench.place("nply solve other.toml -o - --output a/b.svg").writes, [""; 0]);
        assert_eq!(bench.unplaced("wrote /made/x/map.csv"), "wrote map.csv");
    }
}
