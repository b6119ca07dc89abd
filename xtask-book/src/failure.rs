//! Why a chapter cannot be built: where, and what.

use std::fmt;

/// A chapter's line that cannot be expanded, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// The chapter's path below `book/src`.
    pub chapter: String,
    /// The line in it, counted from 1.
    pub line: usize,
    /// What was asked for, where it is known, and what is wrong with it.
    pub why: String,
}

impl fmt::Display for Failure {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "book/src/{}:{}: {}", self.chapter, self.line, self.why)
    }
}

impl std::error::Error for Failure {}
