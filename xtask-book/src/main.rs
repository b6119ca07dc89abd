//! Builds the book: `xtask-book NPLY [PYTHON]`, into `target/book/html`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use mdbook_driver::MDBook;
use mdbook_driver::book::BookItem;
use mdbook_driver::config::Config;
use xtask_book::{Book, Katex, Site, formulas, set_formulas};

fn main() -> ExitCode {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let Some(command) = arguments.next() else {
        eprintln!("usage: xtask-book NPLY [PYTHON]");
        return ExitCode::from(2);
    };
    match build(command, arguments.next()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn build(command: PathBuf, python: Option<PathBuf>) -> Result<(), String> {
    let out = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let out = out.unwrap_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../target"));
    let out = out.canonicalize().map(|out| out.join("book")).map_err(|error| error.to_string())?;
    let made = out.join("made");
    emptied(&made)?;
    let site = Site::here(made, command, python);
    let katex = Katex::installed(&site.root).ok_or("KaTeX is not installed: `npm ci` in book/")?;

    let start = Instant::now();
    let book = Book::expand(&site, |_| true).map_err(|failures| {
        let lines: Vec<String> = failures.iter().map(ToString::to_string).collect();
        lines.join("\n")
    })?;
    println!("{} chapters expanded in {:.1} s", book.chapters.len(), start.elapsed().as_secs_f64());
    for missing in &book.summary.missing {
        println!("warning: {missing} is listed and not written yet");
    }
    for (time, command) in &book.slow {
        println!("note: {:.1} s for {command}", time.as_secs_f64());
    }
    let html = out.join("html");
    let formulas = set(&book, &katex)?;
    bound(&book, &site, &html)?;
    pages(&html, &formulas)?;
    copied(&site.made, &html.join("made"), |_| true)?;
    let dist = katex.dist();
    let needed = |path: &Path| {
        path.is_dir() || path.ends_with("katex.min.css") || path.extension().is_some_and(|ending| ending == "woff2")
    };
    copied(&dist.join("fonts"), &html.join("katex/fonts"), needed)?;
    fs::copy(dist.join("katex.min.css"), html.join("katex/katex.min.css")).map_err(|error| error.to_string())?;
    println!("{}", html.join("index.html").display());
    Ok(())
}

/// Every chapter's formulas, set.
fn set(book: &Book, katex: &Katex) -> Result<BTreeMap<(String, bool), String>, String> {
    let mut all = BTreeSet::new();
    for chapter in &book.chapters {
        all.extend(formulas(&chapter.text));
    }
    katex.set(&all).map_err(|why| {
        let holds = |latex: &str| why.contains(&format!("`{latex}`"));
        let chapter =
            book.chapters.iter().find(|chapter| formulas(&chapter.text).iter().any(|(latex, _)| holds(latex)));
        format!("book/src/{}: {why}", chapter.map_or("", |chapter| &chapter.path))
    })
}

/// mdBook's pages of the expanded chapters.
fn bound(book: &Book, site: &Site, html: &Path) -> Result<(), String> {
    let root = site.root.join("book");
    let wrong = |error: &dyn std::fmt::Display| format!("mdBook: {error:#}");
    let mut config = Config::from_disk(root.join("book.toml")).map_err(|error| wrong(&error))?;
    config.build.build_dir = html.to_path_buf();
    let summary = mdbook_summary::parse_summary(&book.summary.text).map_err(|error| wrong(&error))?;
    let mut pages = MDBook::load_with_config_and_summary(root, config, summary).map_err(|error| wrong(&error))?;
    pages.book.for_each_mut(|item| {
        if let BookItem::Chapter(page) = item {
            let path = page.source_path.as_deref().and_then(Path::to_str);
            if let Some(chapter) = book.chapters.iter().find(|chapter| path == Some(&chapter.path)) {
                page.content.clone_from(&chapter.text);
            }
        }
    });
    pages.build().map_err(|error| wrong(&error))
}

/// Puts the formulas into the pages.
fn pages(folder: &Path, html: &BTreeMap<(String, bool), String>) -> Result<(), String> {
    let wrong = |error: std::io::Error| format!("{}: {error}", folder.display());
    for entry in fs::read_dir(folder).map_err(wrong)? {
        let path = entry.map_err(wrong)?.path();
        if path.is_dir() {
            pages(&path, html)?;
        } else if path.extension().is_some_and(|ending| ending == "html") {
            let page = fs::read_to_string(&path).map_err(wrong)?;
            let set = set_formulas(&page, html);
            if set != page {
                fs::write(&path, set).map_err(wrong)?;
            }
        }
    }
    Ok(())
}

fn emptied(folder: &Path) -> Result<(), String> {
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(|error| format!("cannot empty {}: {error}", folder.display()))?;
    }
    Ok(())
}

fn copied(from: &Path, to: &Path, is_needed: impl Fn(&Path) -> bool + Copy) -> Result<(), String> {
    let wrong = |error: std::io::Error| format!("cannot copy {}: {error}", from.display());
    fs::create_dir_all(to).map_err(wrong)?;
    for entry in fs::read_dir(from).map_err(wrong)? {
        let entry = entry.map_err(wrong)?;
        let (path, target) = (entry.path(), to.join(entry.file_name()));
        if !is_needed(&path) {
            continue;
        }
        if path.is_dir() {
            copied(&path, &target, is_needed)?;
        } else {
            fs::copy(&path, &target).map_err(wrong)?;
        }
    }
    Ok(())
}
