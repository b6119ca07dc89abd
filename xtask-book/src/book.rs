//! The chapters, read, expanded and checked.

use std::fs;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use crate::command::{Bench, Runner};
use crate::equation::Equations;
use crate::fence::{Piece, indented, pieces};
use crate::prose::{Part, parts};
use crate::site::Site;
use crate::{Failure, Summary, console, figure, include, links, made, math, program, value};

/// How many chapters are expanded at a time, and so how many commands run.
const AT_A_TIME: usize = 2;

/// A chapter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chapter {
    /// Its path below `book/src`.
    pub path: String,
    /// As it is written.
    pub source: String,
    /// Expanded: Markdown that mdBook reads.
    pub text: String,
}

/// The book's chapters, expanded.
#[derive(Debug)]
pub struct Book {
    /// Its table of contents.
    pub summary: Summary,
    /// The chapters that are there, in order.
    pub chapters: Vec<Chapter>,
    /// Commands that took longer than some seconds, and how long.
    pub slow: Vec<(Duration, String)>,
}

impl Book {
    /// Reads and expands every chapter of the summary that is there; `wished` leaves chapters out.
    ///
    /// # Errors
    /// All that is wrong: directives that fail, links that lead nowhere, files that no summary lists.
    pub fn expand(site: &Site, wished: impl Fn(&str) -> bool) -> Result<Self, Vec<Failure>> {
        let anywhere = |why: String| vec![Failure { chapter: "SUMMARY.md".to_owned(), line: 1, why }];
        let summary = Summary::read(&site.source()).map_err(anywhere)?;
        let runner = Runner::new(site).map_err(anywhere)?;
        let equations = Equations::read(&site.root).map_err(anywhere)?;
        fs::create_dir_all(site.made.join("figures")).map_err(|error| anywhere(error.to_string()))?;
        let wished: Vec<&String> = summary.chapters.iter().filter(|chapter| wished(chapter)).collect();
        let desk = Desk { site, runner: &runner, equations: &equations };
        let next = AtomicUsize::new(0);
        let done = Mutex::new(Vec::new());
        std::thread::scope(|scope| {
            for _ in 0..AT_A_TIME {
                scope.spawn(|| {
                    while let Some(chapter) = wished.get(next.fetch_add(1, Ordering::Relaxed)) {
                        let expanded = desk.chapter(chapter);
                        if let Ok(mut done) = done.lock() {
                            done.push((chapter.as_str(), expanded));
                        }
                    }
                });
            }
        });
        let mut done = done.into_inner().unwrap_or_default();
        done.sort_by_key(|(path, _)| summary.chapters.iter().position(|chapter| chapter == path));
        let (mut chapters, mut failures) = (Vec::new(), Vec::new());
        for (_, expanded) in done {
            match expanded {
                Ok(chapter) => chapters.push(chapter),
                Err(failure) => failures.push(failure),
            }
        }
        let source = site.source();
        if failures.is_empty() && wished.len() == summary.chapters.len() {
            failures = links::broken(&chapters, &summary, |path| source.join(path).is_file());
            failures.extend(unlisted(&source, &source, &summary));
        }
        if failures.is_empty() { Ok(Self { summary, chapters, slow: runner.slow() }) } else { Err(failures) }
    }
}

/// Chapters that stand in the folder and in no table of contents.
fn unlisted(source: &Path, folder: &Path, summary: &Summary) -> Vec<Failure> {
    let mut found = Vec::new();
    let Ok(entries) = fs::read_dir(folder) else { return found };
    for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
        if path.is_dir() {
            found.extend(unlisted(source, &path, summary));
            continue;
        }
        let Some(chapter) = path.strip_prefix(source).ok().and_then(Path::to_str) else { continue };
        let chapter = chapter.replace('\\', "/");
        if chapter.ends_with(".md") && chapter != "SUMMARY.md" && !summary.chapters.contains(&chapter) {
            found.push(Failure { chapter, line: 1, why: "SUMMARY.md does not list this chapter".to_owned() });
        }
    }
    found
}

/// What expanding a chapter needs.
struct Desk<'a> {
    site: &'a Site,
    runner: &'a Runner,
    equations: &'a Equations,
}

impl Desk<'_> {
    fn chapter(&self, path: &str) -> Result<Chapter, Failure> {
        let failure = |line: usize, why: String| Failure { chapter: path.to_owned(), line, why };
        let folder = self.site.made.join(console::slug(path));
        fs::create_dir_all(&folder).map_err(|error| failure(1, error.to_string()))?;
        let source =
            fs::read_to_string(self.site.source().join(path)).map_err(|error| failure(1, error.to_string()))?;
        let mut bench = Bench::new(folder);
        let mut text = String::new();
        for piece in pieces(&source) {
            match piece {
                Piece::Fence { line, indent, info, lines, .. } if is_ours(info) => {
                    let expanded = console::expand(&info[4..], &lines, path, &mut bench, self.runner)
                        .map_err(|(at, why)| failure(line + at, why))?;
                    text.push_str(&indented(&expanded, indent));
                }
                Piece::Fence { whole, .. } => text.push_str(whole),
                Piece::Prose { line, text: prose } => {
                    for part in parts(prose).map_err(|(at, why)| failure(line + at, why))? {
                        match part {
                            Part::Text(part) => text.push_str(part),
                            Part::Formula(latex, display, _) => text.push_str(&math::place(latex, display)),
                            Part::Directive(word, wish, at) => {
                                let expanded = self.directive(word, &wish, path, &mut bench);
                                text.push_str(
                                    &expanded
                                        .map_err(|why| failure(line + at, format!("{{{{{word} {wish}}}}}: {why}")))?,
                                );
                            }
                        }
                    }
                }
            }
        }
        Ok(Chapter { path: path.to_owned(), source, text })
    }

    fn directive(&self, word: &str, wish: &str, chapter: &str, bench: &mut Bench) -> Result<String, String> {
        match word {
            "value" => value::expand(wish, bench, self.runner),
            "equation" => self.equations.one(wish, chapter),
            "equations" => self.equations.all(),
            "figure" => figure::expand(wish, chapter, self.site, self.runner),
            "program" => program::expand(wish, self.site, self.runner),
            "made" => made::expand(wish, self.site, self.runner),
            "include" => include::expand(wish, self.site),
            _ => Err("there are equation, equations, value, figure, program, made and include".to_owned()),
        }
    }
}

/// Whether a block holds commands to run.
fn is_ours(info: &str) -> bool {
    info == "nply" || info.starts_with("nply ")
}
