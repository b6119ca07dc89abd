//! Where the project stands, and the programs its book runs.

use std::path::{Path, PathBuf};

/// Folders and programs; all paths absolute.
#[derive(Debug, Clone)]
pub struct Site {
    /// The project's root, in which every command runs.
    pub root: PathBuf,
    /// Where commands write their files; the pictures among them go into the book.
    pub made: PathBuf,
    /// Where answers of slow commands are kept from one time to the next.
    pub kept: PathBuf,
    /// The command that is called `nply` in the chapters.
    pub command: PathBuf,
    /// A Python that has the package; without one Python programs are shown and not run.
    pub python: Option<PathBuf>,
}

impl Site {
    /// The workspace this crate was built in; files are written under `made`, slow answers kept under `kept`.
    #[must_use]
    pub fn here(made: PathBuf, kept: PathBuf, command: PathBuf, python: Option<PathBuf>) -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(|| PathBuf::from("."), Path::to_path_buf);
        Self { root, made, kept, command, python }
    }

    /// Where the chapters stand.
    #[must_use]
    pub fn source(&self) -> PathBuf {
        self.root.join("book/src")
    }
}
