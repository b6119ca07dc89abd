//! `cargo xtask release`: all that a release gives away, made and tried, in target/release-kit. It publishes nothing.
//!
//! The crates as packages, each built from its package alone; the page that the packaged command serves; a wheel and the source package for
//! Python, the latter installed into a fresh environment and asked; the command with its manual, completions and licences; and sums of all.

use std::fs;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::step::{Outcome, cargo, hear, root, run as step};
use crate::{venv, web};

/// In the order in which they would be published: each stands on those before.
const CRATES: [&str; 3] = ["nply", "nply-sheet", "nply-cli"];

/// What a fresh environment is asked, after the source package is installed.
const PROGRAM: &str =
    "import nply; print(nply.solve(strands=3, stiffness_ratio=0.75, pretwist=-1)); print(nply.__version__)";

pub(crate) fn run() -> Outcome {
    let kit = root().join("target/release-kit");
    let _ = fs::remove_dir_all(&kit);
    for folder in ["crates", "python"] {
        make(&kit.join(folder))?;
    }
    same_toolchain()?;
    if let Some(changed) = hear(Command::new("git").args(["status", "--porcelain"]).current_dir(root()))
        && !changed.trim().is_empty()
    {
        println!("\n== NOT COMMITTED, and so no release to keep:\n{}", changed.trim_end());
    }
    web::build()?;
    crates(&kit)?;
    python(&kit)?;
    archive(&kit)?;
    sums(&kit)?;
    println!("\nxtask: the kit stands in {}; nothing was published", kit.display());
    Ok(())
}

/// The compiler is the one that `rust-version` promises: a newer one would prove nothing about it.
fn same_toolchain() -> Outcome {
    let manifest = read(&root().join("Cargo.toml"))?;
    let promised = manifest.lines().find_map(|line| line.strip_prefix("rust-version = ")).unwrap_or("");
    let promised = promised.trim_matches('"');
    let found = hear(Command::new("rustc").arg("--version").current_dir(root())).unwrap_or_default();
    if found.starts_with(&format!("rustc {promised}.")) {
        println!("\n== rust-version: {promised} is the compiler that builds this kit; older ones are not tried");
        return Ok(());
    }
    println!("\n== RUST-VERSION NOT TRIED: Cargo.toml promises {promised}, this is {}", found.trim());
    Ok(())
}

/// The page beside the command while the packages are made, and only then: later it would hide a newer one.
struct Page(PathBuf);

impl Page {
    fn put() -> Result<Self, String> {
        let page = Self(root().join("crates/nply-cli/page"));
        page.clear();
        copy(&root().join("web/dist"), &page.0)?;
        Ok(page)
    }

    /// All but the file that keeps the folder.
    fn clear(&self) {
        for entry in fs::read_dir(&self.0).into_iter().flatten().flatten() {
            let path = entry.path();
            let _ = if path.is_dir() {
                fs::remove_dir_all(&path)
            } else if entry.file_name() == ".gitkeep" {
                Ok(())
            } else {
                fs::remove_file(&path)
            };
        }
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        self.clear();
    }
}

fn crates(kit: &Path) -> Outcome {
    let _page = Page::put()?;
    let packages = CRATES.iter().flat_map(|name| ["-p", name]);
    // a package has no profile of the project's: with the project's own its dependencies need not be built twice
    let mut package = cargo(["package", "--locked", "--allow-dirty"]);
    step(
        "packages, each built from itself",
        package.args(packages.clone()).env("CARGO_PROFILE_DEV_DEBUG", "line-tables-only"),
    )?;
    let mut publish = cargo(["publish", "--dry-run", "--no-verify", "--locked", "--allow-dirty"]);
    step("publishing, up to the last step", publish.args(packages))?;
    let version = version()?;
    for name in CRATES {
        let file = format!("{name}-{version}.crate");
        let made = root().join("target/package").join(&file);
        let size = fs::metadata(&made).map_err(|error| format!("{}: {error}", made.display()))?.len();
        println!("{file}: {} kB", size / 1000);
        copy_file(&made, &kit.join("crates").join(&file))?;
    }
    served(&version)
}

/// The packaged command, built from its package with the packages before it, serves the very page that was built.
fn served(version: &str) -> Outcome {
    let unpacked = |name: &str| root().join(format!("target/package/{name}-{version}"));
    let mut build = cargo(["build", "--quiet", "--target-dir"]);
    build.arg(root().join("target")).arg("--manifest-path").arg(unpacked("nply-cli").join("Cargo.toml"));
    for name in &CRATES[..2] {
        build.arg("--config").arg(format!("patch.crates-io.{name}.path={:?}", unpacked(name)));
    }
    step("the command, from its package", build.env("CARGO_PROFILE_DEV_DEBUG", "line-tables-only"))?;
    let command = root().join("target/debug").join(format!("nply{}", std::env::consts::EXE_SUFFIX));
    let page = fetched(&command)?;
    let built = read(&root().join("web/dist/index.html"))?;
    if page != built {
        return Err("the packaged command serves another page than web/dist has".to_owned());
    }
    println!("\n== the packaged command serves the page: {} bytes, as built", page.len());
    Ok(())
}

/// What the command serves at its root.
fn fetched(command: &Path) -> Result<String, String> {
    let said = |error: std::io::Error| format!("{}: {error}", command.display());
    let mut server =
        Command::new(command).args(["explore", "--port", "0"]).stdout(Stdio::piped()).spawn().map_err(said)?;
    let mut line = String::new();
    let read = server.stdout.take().map(|out| BufReader::new(out).read_line(&mut line));
    let answer = match read {
        Some(Ok(_)) => ask(line.trim()),
        _ => Err("the command says no address".to_owned()),
    };
    let _ = server.kill();
    let _ = server.wait();
    answer
}

fn ask(address: &str) -> Result<String, String> {
    let host = address.strip_prefix("http://").and_then(|rest| rest.split('/').next()).unwrap_or("");
    let said = |error: std::io::Error| format!("{address:?}: {error}");
    let mut stream = TcpStream::connect(host).map_err(said)?;
    write!(stream, "GET / HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").map_err(said)?;
    let mut answer = String::new();
    stream.read_to_string(&mut answer).map_err(said)?;
    let (head, body) = answer.split_once("\r\n\r\n").ok_or("no answer")?;
    if head.starts_with("HTTP/1.1 200") { Ok(body.to_owned()) } else { Err(head.to_owned()) }
}

/// Wheel and source package; the latter is what somebody without a wheel builds from, so it is built from and asked.
fn python(kit: &Path) -> Outcome {
    if !venv::is_there() {
        println!("\n== LEFT OUT, the Python packages: python3 is missing");
        return Ok(());
    }
    let package = root().join("crates/nply-py");
    venv::with(&package.join("requirements.txt"))?;
    let out = kit.join("python");
    let maturin = |what: &str| {
        let mut python = venv::python();
        python.args(["-m", "maturin", what, "--manifest-path", "crates/nply-py/Cargo.toml", "--out"]).arg(&out);
        python
    };
    step("wheel", maturin("build").args(["--quiet", "--locked", "--profile", "wheel"]))?;
    step("source package", &mut maturin("sdist"))?;
    let mut made = fs::read_dir(&out).into_iter().flatten().flatten().map(|entry| entry.path());
    let source = made.find(|path| path.extension().is_some_and(|ending| ending == "gz"));
    let source = source.ok_or("there is no source package")?;
    let fresh = root().join("target/release-kit-python");
    let _ = fs::remove_dir_all(&fresh);
    step("fresh environment", Command::new("python3").args(["-m", "venv"]).arg(&fresh))?;
    let python = fresh.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    let install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
    step(
        "source package, built and installed",
        Command::new(&python).args(install).arg(source).env("CARGO_TARGET_DIR", root().join("target")).current_dir(kit),
    )?;
    step("an example of it", Command::new(&python).args(["-c", PROGRAM]).current_dir(kit))
}

/// The command with what goes with it, in one archive.
fn archive(kit: &Path) -> Outcome {
    let mut build = cargo(["build", "--release", "--locked", "--package=nply-cli"]);
    step("command", build.env("NPLY_REQUIRE_WEB", "1"))?;
    let nply = root().join("target/release").join(format!("nply{}", std::env::consts::EXE_SUFFIX));
    let platform = hear(Command::new("rustc").arg("-vV"))
        .and_then(|said| said.lines().find_map(|line| line.strip_prefix("host: ").map(str::to_owned)))
        .unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    let name = format!("nply-{}-{platform}", version()?);
    let folder = kit.join(&name);
    make(&folder.join("completions"))?;
    copy_file(&nply, &folder.join(format!("nply{}", std::env::consts::EXE_SUFFIX)))?;
    for file in ["README.md", "CHANGELOG.md", "CITATION.cff", "LICENSE-MIT", "LICENSE-APACHE", "THIRD-PARTY.md"] {
        copy_file(&root().join(file), &folder.join(file))?;
    }
    step("manual", Command::new(&nply).args(["man", "--output"]).arg(folder.join("man/man1")))?;
    for (shell, file) in [
        ("bash", "nply.bash"),
        ("zsh", "_nply"),
        ("fish", "nply.fish"),
        ("powershell", "nply.ps1"),
        ("elvish", "nply.elv"),
    ] {
        let script = hear(Command::new(&nply).args(["completions", shell]));
        let script = script.ok_or_else(|| format!("no completions for {shell}"))?;
        write(&folder.join("completions").join(file), script.as_bytes())?;
    }
    let mut tar = Command::new("tar");
    tar.args(["--sort=name", "--owner=0", "--group=0", "--numeric-owner", "-czf"])
        .arg(format!("{name}.tar.gz"))
        .arg(&name);
    step("archive", tar.current_dir(kit))?;
    fs::remove_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))
}

/// SHA-256 of every file of the kit.
fn sums(kit: &Path) -> Outcome {
    let mut files = Vec::new();
    list(kit, kit, &mut files)?;
    files.sort();
    let mut command = Command::new("sha256sum");
    let said = hear(command.args(&files).current_dir(kit)).ok_or("sha256sum is missing")?;
    print!("\n{said}");
    write(&kit.join("SHA256SUMS"), said.as_bytes())
}

fn list(folder: &Path, from: &Path, files: &mut Vec<PathBuf>) -> Outcome {
    for entry in fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?.flatten() {
        let path = entry.path();
        if path.is_dir() {
            list(&path, from, files)?;
        } else if let Ok(inner) = path.strip_prefix(from) {
            files.push(inner.to_path_buf());
        }
    }
    Ok(())
}

fn version() -> Result<String, String> {
    let manifest = read(&root().join("Cargo.toml"))?;
    let version = manifest.lines().find_map(|line| line.strip_prefix("version = "));
    version.map(|version| version.trim_matches('"').to_owned()).ok_or_else(|| "Cargo.toml has no version".to_owned())
}

fn copy(from: &Path, to: &Path) -> Outcome {
    make(to)?;
    for entry in fs::read_dir(from).map_err(|error| format!("{}: {error}", from.display()))?.flatten() {
        let (path, name) = (entry.path(), entry.file_name());
        if name.to_string_lossy().starts_with('.') {
            continue;
        }
        if path.is_dir() { copy(&path, &to.join(name))? } else { copy_file(&path, &to.join(name))? }
    }
    Ok(())
}

fn copy_file(from: &Path, to: &Path) -> Outcome {
    fs::copy(from, to).map(drop).map_err(|error| format!("cannot copy {} to {}: {error}", from.display(), to.display()))
}

fn make(folder: &Path) -> Outcome {
    fs::create_dir_all(folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}

fn write(path: &Path, bytes: &[u8]) -> Outcome {
    fs::write(path, bytes).map_err(|error| format!("cannot write {}: {error}", path.display()))
}
