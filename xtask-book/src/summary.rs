//! The book's table of contents, `SUMMARY.md`. A chapter that is listed and not written yet is a draft.

use std::path::Path;

/// The listed chapters, and the text mdBook reads.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Summary {
    /// Chapters that are there, in their order, as paths below `book/src`.
    pub chapters: Vec<String>,
    /// Chapters that are listed and not there.
    pub missing: Vec<String>,
    /// `SUMMARY.md` in which missing chapters have no link, as mdBook wants a draft.
    pub text: String,
}

impl Summary {
    /// Reads a table of contents; `is_there` says of a path whether its file exists.
    #[must_use]
    pub fn of(text: &str, is_there: impl Fn(&str) -> bool) -> Self {
        let mut summary = Self { chapters: Vec::new(), missing: Vec::new(), text: String::new() };
        for line in text.lines() {
            match link(line) {
                Some(path) if is_there(path) => summary.chapters.push(path.to_owned()),
                Some(path) => {
                    summary.missing.push(path.to_owned());
                    summary.text.push_str(&line.replace(&format!("]({path})"), "]()"));
                    summary.text.push('\n');
                    continue;
                }
                None => {}
            }
            summary.text.push_str(line);
            summary.text.push('\n');
        }
        summary
    }

    /// Reads `SUMMARY.md` of a folder.
    ///
    /// # Errors
    /// A sentence, where it cannot be read.
    pub fn read(folder: &Path) -> Result<Self, String> {
        let path = folder.join("SUMMARY.md");
        let text =
            std::fs::read_to_string(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))?;
        Ok(Self::of(&text, |chapter| folder.join(chapter).is_file()))
    }
}

/// The path of a line's link.
fn link(line: &str) -> Option<&str> {
    let (_, after) = line.split_once("](")?;
    let (path, _) = after.split_once(')')?;
    (!path.is_empty()).then_some(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chapter_that_is_not_written_is_a_draft() {
        let summary = Summary::of("# Book\n\n[A](a.md)\n\n- [B (b)](x/b.md)\n- [C]()\n", |path| path == "a.md");
        assert_eq!(summary.chapters, ["a.md"]);
        assert_eq!(summary.missing, ["x/b.md"]);
        assert_eq!(summary.text, "# Book\n\n[A](a.md)\n\n- [B (b)]()\n- [C]()\n");
    }
}
