//! Links between chapters: each leads to a chapter, and to something in it.

use std::collections::{BTreeMap, BTreeSet};

use crate::book::Chapter;
use crate::fence::{Piece, pieces};
use crate::prose::{Part, parts};
use crate::{Failure, Summary, anchor};

/// The links that lead nowhere. A chapter that the summary lists may be missing yet; `is_file` says which other files are there, below `book/src`.
pub(crate) fn broken(chapters: &[Chapter], summary: &Summary, is_file: impl Fn(&str) -> bool) -> Vec<Failure> {
    let anchors: BTreeMap<&str, BTreeSet<String>> =
        chapters.iter().map(|chapter| (chapter.path.as_str(), anchor::anchors(&chapter.text))).collect();
    let mut broken = Vec::new();
    for chapter in chapters {
        for (line, target) in links(&chapter.source) {
            let (path, name) = target.split_once('#').map_or((target, None), |(path, name)| (path, Some(name)));
            let path = if path.is_empty() { Some(chapter.path.clone()) } else { joined(&chapter.path, path) };
            let why = match path.as_deref().map(|path| (path, anchors.get(path))) {
                None => Some("leads out of the book"),
                Some((_, Some(anchors))) => {
                    name.is_some_and(|name| !anchors.contains(name)).then_some("names what is not in that chapter")
                }
                Some((path, None)) => {
                    let awaited = summary.missing.iter().any(|missing| missing == path);
                    (!awaited && (path.ends_with(".md") || !is_file(path)))
                        .then_some("leads to no chapter of the summary")
                }
            };
            if let Some(why) = why {
                broken.push(Failure { chapter: chapter.path.clone(), line, why: format!("the link `{target}` {why}") });
            }
        }
    }
    broken
}

/// Relative links of a chapter as it is written, each with its line.
fn links(text: &str) -> Vec<(usize, &str)> {
    let mut links = Vec::new();
    for piece in pieces(text) {
        let Piece::Prose { line: first, text } = piece else { continue };
        let Ok(parts) = parts(text) else { continue };
        for part in parts {
            let Part::Text(part) = part else { continue };
            for (at, mark) in part.match_indices("](") {
                // inside a part of this prose, so that the distance is a place in it
                let before = part.as_ptr() as usize - text.as_ptr() as usize + at;
                let Some(target) = part[at + mark.len()..].split([')', ' ']).next() else { continue };
                let is_code = text[..before].rsplit('\n').next().unwrap_or("").matches('`').count() % 2 == 1;
                if !is_code && !target.contains("://") && !target.starts_with("mailto:") && !target.is_empty() {
                    links.push((first + text[..before].matches('\n').count(), target));
                }
            }
        }
    }
    links
}

/// A relative path from a chapter, below `book/src`; none where it leads out.
fn joined(chapter: &str, path: &str) -> Option<String> {
    let mut folders: Vec<&str> = chapter.split('/').collect();
    folders.pop();
    for part in path.split('/') {
        match part {
            "." | "" => {}
            ".." => drop(folders.pop()?),
            part => folders.push(part),
        }
    }
    Some(folders.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_lead_somewhere() {
        let chapter = |path: &str, text: &str| Chapter { path: path.into(), source: text.into(), text: text.into() };
        let chapters = [
            chapter(
                "a.md",
                "# A\n[b](x/b.md#b) [c](x/c.md)\n[d](d.md) `[e](e.md)` [f](https://f.org/#g)\n[g](#h) ![i](i.svg)\n",
            ),
            chapter("x/b.md", "# B\n[a](../a.md#a) [out](../../README.md)\n"),
        ];
        let summary = Summary::of("[A](a.md)\n- [B](x/b.md)\n- [C](x/c.md)\n", |path| path != "x/c.md");
        let broken = broken(&chapters, &summary, |path| path == "i.svg");
        let said: Vec<String> = broken.iter().map(ToString::to_string).collect();
        assert_eq!(
            said,
            [
                "book/src/a.md:3: the link `d.md` leads to no chapter of the summary",
                "book/src/a.md:4: the link `#h` names what is not in that chapter",
                "book/src/x/b.md:2: the link `../../README.md` leads out of the book",
            ]
        );
    }
}
