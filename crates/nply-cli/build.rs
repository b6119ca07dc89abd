//! Puts the page of `nply explore` into the command: each file of `web/dist` (of `page`, in a package), compressed, and a table of them. It calls neither npm nor the
//! network. Where the page has not been built, one that says how takes its place; with `NPLY_REQUIRE_WEB` set that is an error.

#[cfg(not(feature = "explore"))]
fn main() {
    println!("cargo::rerun-if-changed=build.rs");
}

#[cfg(feature = "explore")]
fn main() -> std::io::Result<()> {
    page::embed()
}

#[cfg(feature = "explore")]
mod page {
    use std::fmt::Write as _;
    use std::fs;
    use std::io::{self, Write as _};
    use std::path::{Path, PathBuf};

    use flate2::{Compression, Crc, write::GzEncoder};

    pub(super) fn embed() -> io::Result<()> {
        let here = folder("CARGO_MANIFEST_DIR")?;
        // in a package the page stands beside this file; in the project it is what web/ was built into
        let packed = here.join("page");
        let beside = if packed.join("index.html").is_file() { packed.clone() } else { here.join("../../web/dist") };
        let built = folder("NPLY_WEB_DIST").unwrap_or(beside);
        let fallback = here.join("fallback");
        // folders are watched and not files: a file that is missing would have the command built anew each time
        for watched in [&packed, &built, &fallback] {
            println!("cargo::rerun-if-changed={}", watched.display());
        }
        println!("cargo::rerun-if-changed=build.rs");
        println!("cargo::rerun-if-env-changed=NPLY_WEB_DIST");
        println!("cargo::rerun-if-env-changed=NPLY_REQUIRE_WEB");

        let is_built = built.join("index.html").is_file();
        if !is_built && std::env::var_os("NPLY_REQUIRE_WEB").is_some_and(|value| !value.is_empty() && value != "0") {
            let message = format!("{} has no index.html: build the page with `cargo xtask web`", built.display());
            return Err(io::Error::new(io::ErrorKind::NotFound, message));
        }
        let page = if is_built { &built } else { &fallback };
        let mut files = Vec::new();
        collect(page, "", &mut files)?;
        files.sort();

        let out = folder("OUT_DIR")?;
        let mut table = format!("pub(crate) const IS_BUILT: bool = {is_built};\nstatic FILES: &[File] = &[\n");
        for (number, (path, file)) in files.iter().enumerate() {
            let plain = fs::read(file)?;
            let kept = out.join(format!("{number}.gz"));
            compress(&plain, &kept)?;
            let mut crc = Crc::new();
            crc.update(&plain);
            let tag = format!("W/\"{:08x}-{:x}\"", crc.sum(), plain.len());
            let _ = writeln!(
                table,
                "    File {{ path: {path:?}, media: {:?}, tag: {tag:?}, length: {}, gzip: include_bytes!({kept:?}) }},",
                media(path),
                plain.len()
            );
        }
        table.push_str("];\n");
        fs::write(out.join("page.rs"), table)
    }

    fn folder(variable: &str) -> io::Result<PathBuf> {
        let value = std::env::var_os(variable).filter(|value| !value.is_empty());
        value.map(PathBuf::from).ok_or_else(|| io::Error::other(format!("{variable} is not set")))
    }

    /// Every file below a folder with the path a browser asks for; what a dot hides is no part of the page.
    fn collect(folder: &Path, at: &str, files: &mut Vec<(String, PathBuf)>) -> io::Result<()> {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let name = entry.file_name().into_string();
            let name = name.map_err(|name| io::Error::other(format!("{name:?} is no name for the web")))?;
            let (path, file) = (format!("{at}/{name}"), entry.path());
            if name.starts_with('.') {
                continue;
            }
            if file.is_dir() { collect(&file, &path, files)? } else { files.push((path, file)) }
        }
        Ok(())
    }

    fn compress(plain: &[u8], kept: &Path) -> io::Result<()> {
        let mut encoder = GzEncoder::new(fs::File::create(kept)?, Compression::best());
        encoder.write_all(plain)?;
        encoder.finish().map(drop)
    }

    /// The media type of a file, by the end of its name. A browser that is told not to guess runs a script only under its right type.
    fn media(path: &str) -> &'static str {
        match path.rsplit('.').next().unwrap_or_default() {
            "html" => "text/html; charset=utf-8",
            "css" => "text/css; charset=utf-8",
            "js" | "mjs" => "text/javascript; charset=utf-8",
            "wasm" => "application/wasm",
            "json" | "map" => "application/json",
            "webmanifest" => "application/manifest+json",
            "svg" => "image/svg+xml",
            "png" => "image/png",
            "ico" => "image/x-icon",
            "woff2" => "font/woff2",
            "glb" => "model/gltf-binary",
            "toml" => "application/toml",
            "txt" | "md" => "text/plain; charset=utf-8",
            _ => "application/octet-stream",
        }
    }
}
