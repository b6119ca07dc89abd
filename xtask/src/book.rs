//! `cargo xtask book`: the book, from its chapters to the pages in target/book/html, which need no server and no network.

use std::fs;
use std::path::Path;

use crate::npm::{lacks_node, packages};
use crate::step::{Outcome, built, cargo, root, run as step};
use crate::{python, venv};

/// Builds the book, or says what this machine lacks for it. `examples` is where its programs in Rust stand built, where they do.
pub(crate) fn run(examples: Option<&Path>) -> Outcome {
    if let Some(lacks) = lacks_node() {
        return Err(lacks);
    }
    let book = root().join("book");
    packages(&book).or_else(|_| packages(&book))?;
    step("release build", &mut cargo(["build", "--release"]))?;
    let command = built().join("release").join(format!("nply{}", std::env::consts::EXE_SUFFIX));
    let mut bind = cargo(["run", "--quiet", "--package=xtask-book", "--"]);
    bind.arg(command);
    if let Some(examples) = examples {
        bind.env("NPLY_EXAMPLES", examples);
    }
    if has_python_programs(&book.join("src")) {
        if !venv::is_there() {
            return Err("python3 is missing, and the book has programs in Python".to_owned());
        }
        python::wheel("dev")?;
        bind.arg(venv::python().get_program());
    }
    step("book", &mut bind)
}

fn has_python_programs(folder: &Path) -> bool {
    fs::read_dir(folder).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path())).any(|path| {
        if path.is_dir() {
            return has_python_programs(&path);
        }
        fs::read_to_string(&path).is_ok_and(|text| text.contains("{{program python"))
    })
}
