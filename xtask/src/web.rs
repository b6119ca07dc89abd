//! `cargo xtask web`: the explorer's page, from its solver to the files in web/dist. And its tests, in Node and in a browser.
//!
//! It sets up what it needs: the compiler's target, the packages of the lock file, and, for the tests, a browser.

use std::collections::hash_map::DefaultHasher;
use std::fs;
use std::hash::{Hash as _, Hasher as _};
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::npm::{lacks_node, npm, packages, write};
use crate::step::{Outcome, answers, cargo, hear, root, run as step};

const TARGET: &str = "wasm32-unknown-unknown";

/// Builds the page, or says what this machine lacks for it.
pub(crate) fn build() -> Outcome {
    if let Some(lacks) = lacks_node() {
        return Err(lacks);
    }
    target()?;
    step("solver for the page", &mut cargo(["build", "--package=nply-wasm", "--profile=wasm", "--target", TARGET]))?;
    let mut glue = cargo(["run", "--quiet", "--package=xtask-web", "--"]);
    step("glue", glue.arg(built().join(TARGET).join("wasm/nply_wasm.wasm")).arg(web().join("src/wasm")))?;
    packages(&web())?;
    page()
}

/// Builds the page for the tests to come; whether it stands.
pub(crate) fn build_for_tests() -> Result<bool, String> {
    let lacks = lacks_node().or_else(|| set_up().err());
    match lacks {
        Some(lacks) => left_out("the page", &lacks).map(|()| false),
        None => build().map(|()| true),
    }
}

/// What has to be fetched, each asked for twice: networks fail.
fn set_up() -> Outcome {
    target().or_else(|_| target())?;
    packages(&web()).or_else(|_| packages(&web()))
}

/// The page's own tests: its parts in Node, and the whole in a browser, served by the command.
pub(crate) fn test() -> Outcome {
    step("page: parts", &mut npm(&web(), ["run", "--silent", "test"]))?;
    match browser() {
        Ok(browser) => {
            step("command for the page", &mut cargo(["build"]))?;
            let command = built().join("debug").join(format!("nply{}", std::env::consts::EXE_SUFFIX));
            let mut tests = npm(&web(), ["run", "--silent", "e2e"]);
            step("page: in a browser", tests.env("CHROMIUM", browser).env("NPLY_BIN", command))
        }
        Err(lacks) => left_out("the page in a browser", &lacks),
    }
}

/// A check that this machine cannot make is named and left out; where `CI` says that all of them count, it fails.
fn left_out(what: &str, lacks: &str) -> Outcome {
    if std::env::var_os("CI").is_some_and(|ci| ci == "true" || ci == "1") {
        return Err(format!("{what} cannot be tested: {lacks}"));
    }
    println!("\n== LEFT OUT, {what}: {lacks}");
    Ok(())
}

fn web() -> PathBuf {
    root().join("web")
}

/// Where cargo puts what it builds.
fn built() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), |folder| root().join(folder))
}

/// The compiler's library for WebAssembly.
fn target() -> Outcome {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let there = hear(Command::new(rustc).args(["--print", "target-libdir", "--target", TARGET]).current_dir(root()));
    if there.is_some_and(|folder| Path::new(folder.trim()).is_dir()) {
        return Ok(());
    }
    let mut add = Command::new("rustup");
    step("target", add.args(["target", "add", TARGET]).current_dir(root()))
        .map_err(|why| format!("the compiler cannot build for {TARGET}, and rustup cannot add that: {why}"))
}

/// The files, unless they were made of the very same: the command need then not be built anew either.
fn page() -> Outcome {
    let seal = web().join("node_modules/.page-built");
    let made_of = || fingerprint(&web()).map_err(|error| format!("cannot read {}: {error}", web().display()));
    let stands = web().join("dist/index.html").is_file();
    if stands && fs::read_to_string(&seal).ok() == Some(made_of()?) {
        println!("\n== page: as it was");
        return Ok(());
    }
    step("page", &mut npm(&web(), ["run", "--silent", "build"]))?;
    write(&seal, made_of()?.as_bytes())
}

/// Of everything the page is made of.
fn fingerprint(folder: &Path) -> io::Result<String> {
    let mut hasher = DefaultHasher::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        let mut entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
        entries.sort();
        for path in entries {
            let name = path.file_name().unwrap_or_default();
            if ["node_modules", "dist", "test", "e2e", "test-results"].iter().any(|apart| name == *apart) {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
            } else {
                (&path, fs::read(&path)?).hash(&mut hasher);
            }
        }
    }
    Ok(format!("{:016x}\n", hasher.finish()))
}

/// A browser for the tests: one that is there, or Debian's; else why there is none.
fn browser() -> Result<PathBuf, String> {
    if let Some(found) = find_browser() {
        return Ok(found);
    }
    let is_root = hear(Command::new("id").arg("-u")).is_some_and(|id| id.trim() == "0");
    let has_apt = answers(Command::new("apt-get").arg("--version"));
    if !is_root || !has_apt {
        let hint = if has_apt { "as root, `apt-get install chromium`" } else { "install Chromium" };
        return Err(format!("there is no Chromium: {hint}, or name one in CHROMIUM"));
    }
    let apt = |arguments: &[&str]| {
        let mut command = Command::new("apt-get");
        command.args(arguments).env("DEBIAN_FRONTEND", "noninteractive");
        command
    };
    // a fresh machine knows no packages yet; where its lists cannot be renewed, those it has may do
    let _ = step("list of Debian's packages", &mut apt(&["update", "-qq"]));
    let install = || {
        step("browser", &mut apt(&["install", "-y", "-qq", "--no-install-recommends", "chromium", "fonts-dejavu-core"]))
    };
    if let Err(why) = install().or_else(|_| install()) {
        return Err(format!("Debian's Chromium cannot be installed: {why}"));
    }
    find_browser().ok_or_else(|| "Debian's Chromium was installed and is not found".to_owned())
}

fn find_browser() -> Option<PathBuf> {
    if let Some(named) = std::env::var_os("CHROMIUM").filter(|named| !named.is_empty()) {
        return Some(named.into());
    }
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    let names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
    names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name))).find(|path| path.is_file())
}
