//! What slow commands said and wrote, kept for the next time. A command is the same where its words, the program and all example files are.

use std::collections::hash_map::DefaultHasher;
use std::fs;
use std::hash::{Hash as _, Hasher as _};
use std::io;
use std::path::{Path, PathBuf};

use crate::command::Said;
use crate::site::Site;

/// A folder of answers.
#[derive(Debug)]
pub(crate) struct Kept {
    folder: PathBuf,
    /// Where commands write: another place is the same command.
    made: String,
    /// Of the program, and of what it may read.
    base: u64,
}

impl Kept {
    pub(crate) fn of(site: &Site) -> io::Result<Self> {
        let mut hasher = DefaultHasher::new();
        fs::read(&site.command)?.hash(&mut hasher);
        files(&site.root.join("examples"), &mut |path| {
            (path.strip_prefix(&site.root).unwrap_or(path), fs::read(path)?).hash(&mut hasher);
            Ok(())
        })?;
        Ok(Self { folder: site.kept.clone(), made: site.made.display().to_string(), base: hasher.finish() })
    }

    /// A line's own folder.
    fn place(&self, line: &str) -> PathBuf {
        let mut hasher = DefaultHasher::new();
        (self.base, line.replace(&self.made, "")).hash(&mut hasher);
        self.folder.join(format!("{:016x}", hasher.finish()))
    }

    /// What a line said, its files put where it wants them.
    pub(crate) fn find(&self, line: &str, writes: &[PathBuf]) -> Option<Said> {
        let place = self.place(line);
        let said: (i32, String, String) = serde_json::from_slice(&fs::read(place.join("said.json")).ok()?).ok()?;
        for (at, path) in writes.iter().enumerate() {
            fs::copy(place.join(at.to_string()), path).ok()?;
        }
        Some(Said {
            code: Some(said.0),
            output: said.1.replace(MADE, &self.made),
            error: said.2.replace(MADE, &self.made),
        })
    }

    /// Keeps what a line said and wrote; where that cannot be, it is run again the next time.
    pub(crate) fn keep(&self, line: &str, writes: &[PathBuf], said: &Said) {
        let place = self.place(line);
        let keep = || -> io::Result<()> {
            fs::create_dir_all(&place)?;
            for (at, path) in writes.iter().enumerate() {
                fs::copy(path, place.join(at.to_string()))?;
            }
            let plain = |text: &str| text.replace(&self.made, MADE);
            let said = serde_json::to_vec(&(said.code.unwrap_or(1), plain(&said.output), plain(&said.error)))?;
            fs::write(place.join("said.json"), said)
        };
        if said.code.is_some() && keep().is_err() {
            let _ = fs::remove_dir_all(&place);
        }
    }
}

/// Stands for the folder of made files in what is kept.
const MADE: &str = "\u{1}made";

/// Every file below a folder, in order.
fn files(folder: &Path, each: &mut impl FnMut(&Path) -> io::Result<()>) -> io::Result<()> {
    let mut entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    entries.sort();
    for path in entries {
        if path.is_dir() { files(&path, each)? } else { each(&path)? }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_is_found_again_wherever_it_is_wanted() {
        let folder = std::env::temp_dir().join(format!("kept-{}", std::process::id()));
        let kept = |made: &str, base| Kept {
            folder: folder.join("kept"),
            made: folder.join(made).display().to_string(),
            base,
        };
        let file = |made: &str| folder.join(made).join("x.png");
        for made in ["a", "b"] {
            fs::create_dir_all(folder.join(made)).unwrap();
        }
        fs::write(file("a"), "picture").unwrap();
        let line = |made: &str| format!("nply render --output '{}'", file(made).display());
        let says = |made: &str| Said {
            code: Some(0),
            output: format!("wrote {}", file(made).display()),
            error: String::new(),
        };
        kept("a", 1).keep(&line("a"), &[file("a")], &says("a"));
        assert_eq!(kept("b", 1).find(&line("b"), &[file("b")]), Some(says("b")));
        assert_eq!(fs::read_to_string(file("b")).unwrap(), "picture");
        assert_eq!(kept("b", 2).find(&line("b"), &[file("b")]), None);
        fs::remove_dir_all(&folder).unwrap();
    }
}
