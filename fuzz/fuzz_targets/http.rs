//! Any request to `nply explore`: an answer with its guards, and the page only for who may have it.
#![no_main]

#[path = "../../crates/nply-cli/src/server/answer.rs"]
#[allow(dead_code, unreachable_pub)]
mod answer;
#[path = "../../crates/nply-cli/src/server/host.rs"]
#[allow(dead_code, unreachable_pub)]
mod host;

/// A page of one file in the place of the true one, which is made by the build of the command.
mod page {
    use std::io;

    pub(crate) struct File {
        pub(crate) media: &'static str,
        pub(crate) tag: &'static str,
        pub(crate) gzip: &'static [u8],
    }

    static INDEX: File = File { media: "text/html", tag: "\"tag\"", gzip: b"packed" };

    impl File {
        pub(crate) fn at(path: &str) -> Option<&'static Self> {
            ["/", "/index.html"].contains(&path).then_some(&INDEX)
        }

        pub(crate) fn plain(&self) -> io::Result<Vec<u8>> {
            Ok(b"plain".to_vec())
        }
    }
}

use host::Visitors;
use hyper::{Request, StatusCode};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    // a line for the method, one for the target, then names and values of headers
    let mut lines = bytes.split(|byte| *byte == b'\n');
    let mut next = || lines.next().unwrap_or_default();
    let mut request = Request::builder().method(next()).uri(next());
    let mut hosts = Vec::new();
    for line in lines.take(16) {
        let mut pair = line.splitn(2, |byte| *byte == b':');
        let (name, value) = (pair.next().unwrap_or_default(), pair.next().unwrap_or_default());
        if name.eq_ignore_ascii_case(b"host") {
            hosts.push(value.to_vec());
        }
        request = request.header(name, value);
    }
    let Ok(request) = request.body(()) else { return };
    for visitors in [Visitors::Local, Visitors::Any] {
        let answer = answer::answer(&request, visitors);
        assert!(answer.headers().contains_key("content-security-policy"));
        assert_eq!(answer.headers()["x-content-type-options"], "nosniff");
        let given = [StatusCode::OK, StatusCode::NOT_MODIFIED].contains(&answer.status());
        if given {
            assert_eq!(hosts.len(), 1);
        }
        if given && visitors == Visitors::Local {
            let host = String::from_utf8(hosts[0].clone()).expect("a host's name is text");
            let name = host.rsplit_once(':').filter(|(_, port)| port.bytes().all(|b| b.is_ascii_digit()));
            let name = name.map_or(host.as_str(), |(name, _)| name).trim_matches(['[', ']']);
            let own = name.eq_ignore_ascii_case("localhost")
                || name.parse::<std::net::IpAddr>().is_ok_and(|address| address.is_loopback());
            assert!(own, "{host:?}");
        }
    }
});
