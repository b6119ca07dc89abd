//! Every chapter of the book as it stands: its commands run, its links lead somewhere, its numbers are found.

use std::path::{Path, PathBuf};
use std::process::Command;

use xtask_book::{Book, Equations, Katex, Site, Summary, formulas};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The command: the one named in `NPLY_BIN`, or this workspace's.
fn command() -> PathBuf {
    if let Some(named) = std::env::var_os("NPLY_BIN") {
        return named.into();
    }
    // the same as the workshop builds, so that it is built once; what a reader runs, and fast enough to draw pictures
    let build = ["build", "--release", "--quiet", "--message-format", "json-render-diagnostics"];
    let output = Command::new(env!("CARGO")).args(build).current_dir(root()).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let said = String::from_utf8(output.stdout).unwrap();
    let executable = said.lines().rev().find_map(|line| {
        let message: serde_json::Value = serde_json::from_str(line).ok()?;
        message["executable"].as_str().map(PathBuf::from)
    });
    executable.expect("cargo names the command it built")
}

/// A Python that has the package, where the workshop has made one.
fn python() -> Option<PathBuf> {
    let python = root().join(".venv").join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    let has_package =
        Command::new(&python).args(["-c", "import nply"]).output().is_ok_and(|said| said.status.success());
    has_package.then_some(python)
}

#[test]
fn every_chapter_can_be_expanded() {
    let made = Path::new(env!("CARGO_TARGET_TMPDIR")).join("made");
    let _ = std::fs::remove_dir_all(&made);
    let only = std::env::var("CHAPTER").unwrap_or_default();
    let kept = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("book").join("kept");
    let site = Site::here(made, kept, command(), python());
    if site.python.is_none() {
        println!("LEFT OUT: programs in Python, for .venv has no nply (`cargo xtask python`)");
    }
    let book = Book::expand(&site, |chapter| chapter.contains(&only)).unwrap_or_else(|failures| {
        let lines: Vec<String> = failures.iter().map(ToString::to_string).collect();
        panic!("{} failures\n{}", lines.len(), lines.join("\n"))
    });
    for (time, command) in &book.slow {
        println!("{:.1} s for {command}", time.as_secs_f64());
    }
    if let Some(katex) = Katex::installed(&root()) {
        let all = book.chapters.iter().flat_map(|chapter| formulas(&chapter.text)).collect();
        katex.set(&all).unwrap();
    } else {
        println!("LEFT OUT: formulas, for KaTeX is not installed (`npm ci` in book/)");
    }
}

#[test]
fn the_summary_lists_what_is_there() {
    let summary = Summary::read(&root().join("book/src")).unwrap();
    assert!(summary.missing.is_empty(), "listed and not there: {:?}", summary.missing);
    let twice: Vec<&String> = summary
        .chapters
        .iter()
        .enumerate()
        .filter(|(at, path)| summary.chapters[..*at].contains(path))
        .map(|(_, path)| path)
        .collect();
    assert!(twice.is_empty(), "listed twice: {twice:?}");
}

#[test]
fn every_equation_can_be_typeset() {
    let latex = Equations::read(&root()).unwrap().latex().unwrap();
    let Some(katex) = Katex::installed(&root()) else { return };
    let all = latex.iter().map(|(_, latex)| (latex.clone(), true)).collect();
    if let Err(why) = katex.set(&all) {
        let file = latex.iter().find(|(_, latex)| why.contains(&format!("`{latex}`")));
        panic!("{}: {why}", file.map_or("", |(file, _)| file));
    }
}
