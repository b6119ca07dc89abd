//! `nply explore` as a browser, a stranger and a slow client meet it.
#![cfg(feature = "explore")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::collections::BTreeMap;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::{SocketAddr, TcpStream};
use std::process::{Child, Stdio};
use std::time::Duration;

use command::Answer;

/// The command, serving; ended with the test.
struct Served {
    child: Child,
    address: SocketAddr,
    /// what stands behind the address, with the line's end
    link: String,
}

impl Served {
    fn with(arguments: &[&str]) -> Self {
        let mut all = vec!["explore", "--port", "0"];
        all.extend(arguments);
        let mut child =
            command::command(&all).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command starts");
        let mut line = String::new();
        BufReader::new(child.stdout.as_mut().expect("a pipe")).read_line(&mut line).unwrap();
        let address = line.strip_prefix("http://").and_then(|line| line.split_once('/'));
        let (address, link) = address.unwrap_or_else(|| panic!("no address: {line:?}"));
        Self { child, address: address.parse().unwrap(), link: link.to_owned() }
    }

    /// What is said where it must not serve; where it does all the same, that it is at an end.
    fn refused(arguments: &[&str]) -> Answer {
        let mut child = command::command(&[&["explore"], arguments].concat())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        let mut line = String::new();
        BufReader::new(child.stdout.as_mut().expect("a pipe")).read_line(&mut line).unwrap();
        if !line.is_empty() {
            let _ = child.kill();
            panic!("{arguments:?} is served at {line}");
        }
        command::answer(&child.wait_with_output().unwrap())
    }

    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(self.address).unwrap();
        // far beyond what any answer takes: a test that hangs is worse than one that fails
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        stream
    }

    /// What a whole request gets, written as it stands; the server closes behind it.
    fn raw(&self, request: &[u8]) -> Reply {
        let mut stream = self.connect();
        stream.write_all(request).unwrap();
        let mut all = Vec::new();
        stream.read_to_end(&mut all).unwrap();
        Reply::of(&all)
    }

    fn ask(&self, method: &str, path: &str, headers: &[&str]) -> Reply {
        let host = format!("Host: {}", self.address);
        self.ask_with(method, path, &[&[host.as_str()], headers].concat())
    }

    /// With no host but those given.
    fn ask_with(&self, method: &str, path: &str, headers: &[&str]) -> Reply {
        let mut request = format!("{method} {path} HTTP/1.1\r\nConnection: close\r\n");
        for header in headers {
            request.push_str(header);
            request.push_str("\r\n");
        }
        request.push_str("\r\n");
        self.raw(request.as_bytes())
    }

    /// Every file that the page names, and those that they name in turn, by their paths.
    fn files(&self) -> BTreeMap<String, Reply> {
        let mut found = BTreeMap::new();
        let mut wanted = vec!["/".to_owned()];
        while let Some(path) = wanted.pop() {
            if found.contains_key(&path) {
                continue;
            }
            let reply = self.ask("GET", &path, &[]);
            let folder = path.rsplit_once('/').unwrap().0.to_owned();
            let text = String::from_utf8_lossy(&reply.body).into_owned();
            if reply.status == 200 && path.ends_with(['/', 's']) {
                for name in text.split(['"', '\'', '`']) {
                    let is_file = [".js", ".css", ".wasm", ".svg", ".png"].iter().any(|ending| name.ends_with(ending));
                    let is_ours = !name.contains([' ', ':', '\n', '$', '*', '<']) && !name.starts_with("//");
                    if is_file && is_ours {
                        let bare = name.trim_start_matches("./");
                        for base in [folder.as_str(), ""] {
                            let path = format!("{base}/{}", bare.trim_start_matches('/'));
                            if self.ask("HEAD", &path, &[]).status == 200 {
                                wanted.push(path);
                            }
                        }
                    }
                }
            }
            found.insert(path, reply);
        }
        found
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[derive(Debug)]
struct Reply {
    status: u16,
    headers: BTreeMap<String, String>,
    body: Vec<u8>,
}

impl Reply {
    fn of(all: &[u8]) -> Self {
        let end = all.windows(4).position(|four| four == b"\r\n\r\n");
        let end = end.unwrap_or_else(|| panic!("no answer: {}", String::from_utf8_lossy(all)));
        let head = std::str::from_utf8(&all[..end]).unwrap();
        let mut lines = head.lines();
        let status = lines.next().unwrap().split(' ').nth(1).unwrap().parse().unwrap();
        let headers = lines.map(|line| line.split_once(": ").unwrap());
        let headers = headers.map(|(name, value)| (name.to_ascii_lowercase(), value.to_owned())).collect();
        Self { status, headers, body: all[end + 4..].to_vec() }
    }

    fn header(&self, name: &str) -> &str {
        self.headers.get(name).map_or("", String::as_str)
    }

    fn text(&self) -> &str {
        std::str::from_utf8(&self.body).unwrap()
    }
}

/// What a browser holds the page to.
#[track_caller]
fn is_guarded(reply: &Reply) {
    let policy = reply.header("content-security-policy");
    let rules: BTreeMap<&str, &str> =
        policy.split("; ").map(|rule| rule.split_once(' ').unwrap_or_else(|| panic!("{rule:?}"))).collect();
    for (rule, allowed) in [
        ("default-src", "'self'"),
        ("script-src", "'self' 'wasm-unsafe-eval'"),
        ("worker-src", "'self'"),
        ("style-src", "'self'"),
        ("connect-src", "'self'"),
        ("object-src", "'none'"),
        ("base-uri", "'none'"),
        ("frame-ancestors", "'none'"),
    ] {
        assert_eq!(rules.get(rule), Some(&allowed), "{policy}");
    }
    assert_eq!(reply.header("x-content-type-options"), "nosniff");
    assert_eq!(reply.header("referrer-policy"), "no-referrer");
    assert_eq!(reply.header("cache-control"), "no-cache");
    assert!(!reply.headers.contains_key("access-control-allow-origin"));
}

#[test]
fn every_file_of_the_page_comes_under_its_own_type_and_guarded() {
    let served = Served::with(&[]);
    let files = served.files();
    assert!(files.len() >= 2, "{:?}", files.keys());
    for (path, reply) in files {
        assert_eq!(reply.status, 200, "{path}");
        is_guarded(&reply);
        let expected = match path.rsplit(['.', '/']).next().unwrap() {
            "" | "html" => "text/html; charset=utf-8",
            "js" => "text/javascript; charset=utf-8",
            "css" => "text/css; charset=utf-8",
            "wasm" => "application/wasm",
            "svg" => "image/svg+xml",
            "png" => "image/png",
            other => panic!("{path}: no type is expected of {other}"),
        };
        assert_eq!(reply.header("content-type"), expected, "{path}");
        assert_eq!(reply.header("content-length"), reply.body.len().to_string(), "{path}");
    }
}

#[test]
fn the_markup_holds_no_script_no_style_and_no_stranger() {
    let page = Served::with(&[]).ask("GET", "/", &[]);
    let markup = page.text().to_lowercase();
    assert!(markup.starts_with("<!doctype html>"), "{markup}");
    for script in markup.split("<script").skip(1) {
        let (tag, after) = script.split_once('>').unwrap();
        assert!(tag.contains("src="), "a script in the markup: {tag}");
        assert!(after.trim_start().starts_with("</script>"), "a script in the markup: {after:.60}");
    }
    for forbidden in
        ["<style", " style=", " onclick=", " onload=", "javascript:", "src=\"http", "href=\"http", "src=\"//"]
    {
        // a link that a reader may follow is no request
        let markup = markup.replace("<a href=\"http", "<a ");
        assert!(!markup.contains(forbidden), "{forbidden}");
    }
}

#[test]
fn a_page_that_is_not_built_says_how() {
    let mut served = Served::with(&[]);
    let page = served.ask("GET", "/", &[]);
    let is_built = !page.text().contains("The explorer is not built in");
    assert_eq!(page.text().contains("cargo xtask web"), !is_built);
    served.child.kill().unwrap();
    let mut said = String::new();
    served.child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    let note = "note: this nply was built without the page, and says there how to build it\n";
    assert_eq!(said, if is_built { "" } else { note });
}

#[test]
fn the_page_is_compressed_for_whoever_takes_it_so() {
    let served = Served::with(&[]);
    let plain = served.ask("GET", "/", &[]);
    assert_eq!(plain.header("content-encoding"), "");
    let mut smaller = Vec::new();
    for takes in ["gzip", "br, GZip;q=0.5", "deflate, gzip, br, zstd", "*"] {
        let reply = served.ask("GET", "/", &[&format!("Accept-Encoding: {takes}")]);
        assert_eq!((reply.status, reply.header("content-encoding")), (200, "gzip"), "{takes}");
        assert_eq!(reply.header("vary"), "accept-encoding");
        assert!(reply.body.starts_with(&[0x1f, 0x8b]), "{takes}");
        smaller = reply.body;
    }
    let mut unpacked = Vec::new();
    flate2::read::GzDecoder::new(smaller.as_slice()).read_to_end(&mut unpacked).unwrap();
    assert_eq!(unpacked, plain.body);
    for refuses in ["gzip;q=0", "gzip;q=0.0, *", "br", "identity", "gzip; q=nonsense"] {
        let reply = served.ask("GET", "/", &[&format!("Accept-Encoding: {refuses}")]);
        assert_eq!((reply.header("content-encoding"), &reply.body), ("", &plain.body), "{refuses}");
    }
}

#[test]
fn what_a_browser_has_is_not_sent_again() {
    let served = Served::with(&[]);
    let tag = served.ask("GET", "/", &[]).header("etag").to_owned();
    assert!(tag.len() > 4, "{tag}");
    for known in [tag.clone(), format!("\"other\", {tag}"), tag.replace("W/", ""), "*".to_owned()] {
        let reply = served.ask("GET", "/", &[&format!("If-None-Match: {known}")]);
        assert_eq!((reply.status, reply.body.len(), reply.header("etag")), (304, 0, tag.as_str()), "{known}");
        is_guarded(&reply);
    }
    assert_eq!(served.ask("GET", "/", &["If-None-Match: \"other\""]).status, 200);
}

#[test]
fn the_head_alone_is_that_of_the_whole() {
    let served = Served::with(&[]);
    for path in ["/", "/nothing"] {
        let (whole, mut head) = (served.ask("GET", path, &[]), served.ask("HEAD", path, &[]));
        assert!(head.body.is_empty() && !whole.body.is_empty());
        let date = whole.header("date").to_owned();
        head.headers.insert("date".to_owned(), date); // the one thing that may differ
        assert_eq!((head.status, head.headers), (whole.status, whole.headers));
    }
}

#[test]
fn it_is_read_and_nothing_else() {
    let served = Served::with(&[]);
    for method in ["POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "PROPFIND", "get"] {
        let reply = served.ask(method, "/", &[]);
        assert_eq!((reply.status, reply.header("allow")), (405, "GET, HEAD"), "{method}");
        assert_eq!(reply.header("content-type"), "text/plain; charset=utf-8");
        assert!(reply.text().ends_with(".\n"));
        is_guarded(&reply);
    }
}

#[test]
fn there_is_no_way_out_of_the_page() {
    let served = Served::with(&[]);
    for path in [
        "/nothing",
        "/index.html/",
        "//index.html",
        "/./index.html",
        "/../Cargo.toml",
        "/../../../../../../../../etc/passwd",
        "/assets/../index.html",
        "/%2e%2e/Cargo.toml",
        "/..%2fCargo.toml",
        "/..%5cCargo.toml",
        "/..\\Cargo.toml",
        "/.gitkeep",
        "/assets",
        "/assets/",
        "/index.html%00.js",
        "/etc/passwd",
        "/C:/Windows/win.ini",
    ] {
        let reply = served.ask("GET", path, &[]);
        assert!([400, 404].contains(&reply.status), "{path}: {}", reply.status);
        if reply.status == 404 {
            assert_eq!(reply.text(), "The page has no such file.\n", "{path}");
            is_guarded(&reply);
        }
    }
    assert_eq!(served.ask("GET", "/?n=3", &[]).status, 200);
    assert_eq!(served.ask("GET", "/index.html", &[]).body, served.ask("GET", "/", &[]).body);
}

#[test]
fn a_stranger_s_name_for_this_machine_is_refused() {
    let served = Served::with(&[]);
    let port = served.address.port();
    for host in ["localhost", "LocalHost", "127.0.0.1", "127.8.8.8", "[::1]"] {
        for host in [host.to_owned(), format!("{host}:{port}"), format!("{host}:1")] {
            assert_eq!(served.ask_with("GET", "/", &[&format!("Host: {host}")]).status, 200, "{host}");
        }
    }
    for host in [
        "example.com",
        &format!("example.com:{port}"),
        "localhost.example.com",
        "127.0.0.1.example.com",
        "192.168.0.1",
        "0.0.0.0",
        "[2001:db8::1]",
        "localhost@example.com",
        "example.com@localhost",
        "localhost:80@example.com",
        "localhost.",
        "127.1",
        "2130706433",
        "0x7f.1",
        "example.com@",
        "",
        "::1",
        "[::1]example.com",
        "[::1]:80example.com",
        "[::1]:example.com",
        "localhost:example",
    ] {
        let reply = served.ask_with("GET", "/", &[&format!("Host: {host}")]);
        assert!([400, 421].contains(&reply.status), "{host}: {}", reply.status);
        assert!(!reply.text().contains('<'), "{host}");
    }
    assert_eq!(served.ask_with("GET", "/", &[]).status, 421);
    assert_eq!(served.ask_with("GET", "/", &["Host: localhost", "Host: example.com"]).status, 421);
    assert_eq!(served.ask_with("GET", "http://example.com/", &["Host: localhost"]).status, 421);
    assert_eq!(served.ask_with("GET", "http://localhost/", &["Host: localhost"]).status, 200);
}

#[test]
fn other_machines_are_let_in_only_where_that_is_said() {
    for host in ["0.0.0.0", "::", "192.0.2.1", "169.254.1.1", "2001:db8::1", "::ffff:192.0.2.1"] {
        let Answer { code, out, err } = Served::refused(&["--port", "0", "--host", host]);
        assert_eq!((code, out.as_str()), (2, ""), "{host}");
        let sentence = "can be reached from other machines: give --allow-remote too if they may read the page";
        assert!(err.contains(sentence), "{err}");
    }
    let Answer { code, err, .. } = Served::refused(&["--host", "example.com"]);
    assert_eq!(code, 2);
    assert!(err.contains("what is wanted is an address in digits, such as 127.0.0.1 or ::1"), "{err}");

    let open = Served::with(&["--host", "0.0.0.0", "--allow-remote"]);
    assert!(open.address.ip().is_loopback(), "the address printed is one that this machine can reach");
    assert_eq!(open.ask_with("GET", "/", &["Host: a.machine.of.mine:80"]).status, 200);
    for host in ["127.0.0.1", "localhost", "127.0.0.2"] {
        assert_eq!(Served::with(&["--host", host]).ask("GET", "/", &[]).status, 200);
    }
}

#[test]
fn a_port_in_use_is_said_with_what_to_do() {
    let first = Served::with(&[]);
    let port = first.address.port().to_string();
    let Answer { code, out, err } = Served::refused(&["--port", &port]);
    assert_eq!((code, out.as_str()), (3, ""));
    assert!(
        err.starts_with(&format!("error: cannot listen at 127.0.0.1:{port} (--port 0 takes a free port): ")),
        "{err}"
    );
    let Answer { code, .. } = Served::refused(&["--port", "65536"]);
    assert_eq!(code, 2);
}

#[test]
fn the_slow_and_the_greedy_keep_nobody_waiting() {
    let served = Served::with(&[]);
    let mut slow = Vec::new();
    // more than there are places for
    for number in 0..500 {
        let mut stream = served.connect();
        let begun =
            ["", "G", "GET / HTTP/1.1\r\nHost: localhost\r\nX-Slow: ", "POST / HTTP/1.1\r\nContent-Length: 9\r\n\r\nx"];
        let _ = stream.write_all(begun[number % begun.len()].as_bytes()); // it may be cut already
        slow.push(stream);
    }
    assert_eq!(served.ask("GET", "/", &[]).status, 200);

    // a body is not waited for, however much is announced
    for method in ["GET", "POST"] {
        let mut stream = served.connect();
        write!(stream, "{method} / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000000000000\r\n\r\nbegun").unwrap();
        let mut all = Vec::new();
        let _ = stream.read_to_end(&mut all); // cut, since the rest is not wanted
        assert_eq!(Reply::of(&all).status, if method == "GET" { 200 } else { 405 });
    }

    // and a head is not taken at any length
    let mut stream = served.connect();
    let endless = [b"GET / HTTP/1.1\r\nHost: localhost\r\nX: ".to_vec(), vec![b'x'; 1 << 20]].concat();
    let _ = stream.write_all(&endless); // the server closes meanwhile
    let mut all = Vec::new();
    let _ = stream.read_to_end(&mut all);
    assert!(!all.starts_with(b"HTTP/1.1 200"), "{}", String::from_utf8_lossy(&all));

    for nonsense in
        ["\r\n\r\n", "hello\r\n\r\n", "GET / HTTP/9.9\r\n\r\n", "GET  HTTP/1.1\r\n\r\n", "\0\u{1}\u{2}\r\n\r\n"]
    {
        let mut stream = served.connect();
        stream.write_all(nonsense.as_bytes()).unwrap();
        stream.shutdown(std::net::Shutdown::Write).unwrap();
        let mut all = Vec::new();
        let _ = stream.read_to_end(&mut all);
        assert!(!all.starts_with(b"HTTP/1.1 2"), "{nonsense:?}");
    }
    assert_eq!(served.ask("GET", "/", &[]).status, 200);
    drop(slow);
    assert_eq!(served.ask("GET", "/", &[]).status, 200);
}

/// Requests put together from pieces by a seed: each is answered in HTTP or cut, none brings the server down, and nobody else's name is
/// answered with the page.
#[test]
fn requests_of_any_make_are_answered_or_cut() {
    const PIECES: [&str; 34] = [
        "GET ",
        "HEAD ",
        "POST ",
        "OPTIONS ",
        "get ",
        "/",
        "//",
        "/..",
        "/%2e%2e/",
        "/%00",
        "\\",
        "*",
        "http://localhost/",
        "http://example.com/",
        "?a=b",
        "#",
        " HTTP/1.1",
        " HTTP/1.0",
        " HTTP/2.0",
        "\r\n",
        "\r\n",
        "\n",
        "\r",
        "Host: localhost\r\n",
        "Host: example.com\r\n",
        "Host:\r\n",
        "Content-Length: 5\r\n",
        "Content-Length: -1\r\n",
        "Transfer-Encoding: chunked\r\n",
        "Expect: 100-continue\r\n",
        "If-None-Match: *\r\n",
        "Accept-Encoding: gzip;q=0,*;q=nan\r\n",
        "\0",
        "é",
    ];
    let served = Served::with(&[]);
    let mut at = 2002_u64;
    let mut next = |bound: usize| {
        at = at.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (at >> 33) as usize % bound
    };
    for _ in 0..400 {
        let mut request: String = if next(2) == 0 { "GET / HTTP/1.1\r\n".to_owned() } else { String::new() };
        for _ in 0..next(12) {
            request.push_str(PIECES[next(PIECES.len())]);
        }
        request.push_str("\r\n\r\n");
        let mut stream = served.connect();
        let _ = stream.write_all(request.as_bytes());
        let _ = stream.shutdown(std::net::Shutdown::Write);
        let mut all = Vec::new();
        let _ = stream.read_to_end(&mut all);
        assert!(all.is_empty() || all.starts_with(b"HTTP/1."), "{request:?}");
        if !request.contains("Host: localhost") {
            assert!(!all.starts_with(b"HTTP/1.1 200"), "{request:?}");
        }
    }
    assert_eq!(served.ask("GET", "/", &[]).status, 200);
}

#[test]
fn several_requests_go_over_one_connection() {
    let served = Served::with(&[]);
    let stream = served.connect();
    let mut reader = BufReader::new(&stream);
    for _ in 0..3 {
        (&stream).write_all(b"GET /nothing HTTP/1.1\r\nHost: localhost\r\n\r\n").unwrap();
        let mut length = 0;
        loop {
            let mut line = String::new();
            reader.read_line(&mut line).unwrap();
            if let Some(value) = line.strip_prefix("content-length: ") {
                length = value.trim().parse().unwrap();
            }
            if line == "\r\n" {
                break;
            }
        }
        let mut body = vec![0; length];
        reader.read_exact(&mut body).unwrap();
        assert_eq!(body, b"The page has no such file.\n");
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_it_in_peace() {
    let mut served = Served::with(&[]);
    let kept = served.connect(); // a browser keeps its connections
    let sent = std::process::Command::new("kill").args(["-INT", &served.child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    assert_eq!(served.child.wait().unwrap().code(), Some(0));
    let mut said = String::new();
    served.child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    assert!(!said.contains("interrupted") && !said.contains("panicked"), "{said}");
    drop(kept);
}

#[test]
fn a_file_stands_in_the_address_datum_by_datum() {
    assert_eq!(Served::with(&[]).link, "\n");
    let yarn = Served::with(&["examples/three-ply-yarn.toml"]);
    let pairs: Vec<(&str, &str)> =
        yarn.link.trim_end()[1..].split('&').map(|pair| pair.split_once('=').unwrap()).collect();
    assert!(yarn.link.starts_with('#'), "{}", yarn.link);
    // the same data as flags are the same ply
    let flags: Vec<String> = pairs
        .iter()
        .map(|(flag, text)| {
            let text = text.replace('+', " ").replace("%2B", "+").replace("%5E", "^");
            assert!(!text.contains('%'), "{text}");
            format!("--{flag}={text}")
        })
        .collect();
    let flags: Vec<&str> = ["solve"].into_iter().chain(flags.iter().map(String::as_str)).collect();
    assert_eq!(command::out(&flags), command::out(&["solve", "examples/three-ply-yarn.toml"]));
    // what has a meaning in an address has none in a title
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    let file = folder.join("titled.toml");
    std::fs::write(&file, "ply = { title = \"a#b&c=d+é%\", strands = 3 }\n[[path]]\nload.force = 1\n").unwrap();
    let titled = Served::with(&[file.to_str().unwrap()]);
    assert_eq!(titled.link, "#title=a%23b%26c%3Dd%2B%C3%A9%25&strands=3\n");

    std::fs::write(&file, "ply.strand = 3\n").unwrap();
    let Answer { code, err, .. } = Served::refused(&[file.to_str().unwrap()]);
    assert_eq!(code, 2);
    assert!(err.contains("did you mean `strands`?"), "{err}");
    assert_eq!(Served::refused(&["nowhere.toml"]).code, 3);
}

/// The browser is a script here that writes down what it is given.
#[cfg(unix)]
#[test]
fn the_browser_is_opened_at_the_address() {
    use std::os::unix::fs::PermissionsExt as _;

    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("browser");
    std::fs::create_dir_all(&folder).unwrap();
    let (browser, note) = (folder.join("xdg-open"), folder.join("opened"));
    let _ = std::fs::remove_file(&note);
    std::fs::write(&browser, format!("#!/bin/sh\necho \"$1\" > '{0}.part' && mv '{0}.part' '{0}'\n", note.display()))
        .unwrap();
    std::fs::set_permissions(&browser, std::fs::Permissions::from_mode(0o755)).unwrap();

    let path =
        std::env::join_paths(std::iter::once(folder).chain(std::env::split_paths(&std::env::var_os("PATH").unwrap())));
    let mut child = command::command(&["explore", "--port", "0", "--open"])
        .env("PATH", path.unwrap())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut line = String::new();
    BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut line).unwrap();
    let address = line.trim()["http://".len()..].trim_end_matches('/').parse().unwrap();
    let served = Served { child, address, link: String::new() };
    let opened = (0..1000).find_map(|_| {
        std::thread::sleep(Duration::from_millis(10));
        std::fs::read_to_string(&note).ok()
    });
    assert_eq!(opened.as_deref(), Some(line.as_str()));
    assert_eq!(served.ask("GET", "/", &[]).status, 200);
}
