//! From a request to its answer.

use http_body_util::Full;
use hyper::body::Bytes;
use hyper::header::{
    ACCEPT_ENCODING, ALLOW, CACHE_CONTROL, CONTENT_ENCODING, CONTENT_SECURITY_POLICY, CONTENT_TYPE, ETAG, HeaderName,
    HeaderValue, IF_NONE_MATCH, REFERRER_POLICY, VARY, X_CONTENT_TYPE_OPTIONS,
};
use hyper::{HeaderMap, Method, Request, Response, StatusCode};

use super::host::Visitors;
use super::page::File;

/// What a browser may do with the page. Scripts come from here alone and none stands in the markup; WebAssembly, which is the solver, may be
/// compiled; nothing is fetched from, sent to or framed by anyone else.
const POLICY: &str = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'; \
    img-src 'self' data: blob:; font-src 'self'; connect-src 'self'; object-src 'none'; base-uri 'none'; \
    form-action 'none'; frame-ancestors 'none'";

/// Said with every answer, whatever it is.
const ALWAYS: [(HeaderName, &str); 7] = [
    (CONTENT_SECURITY_POLICY, POLICY),
    (X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (REFERRER_POLICY, "no-referrer"),
    // another version of nply may stand at this address tomorrow: a browser keeps files, but asks whether they still hold
    (CACHE_CONTROL, "no-cache"),
    (VARY, "accept-encoding"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
];

pub(super) type Answer = Response<Full<Bytes>>;

/// The answer to a request. Its body, if it has one, is not read.
pub(super) fn answer<B>(request: &Request<B>, visitors: Visitors) -> Answer {
    let mut answer = content(request, visitors);
    for (name, value) in ALWAYS {
        answer.headers_mut().insert(name, HeaderValue::from_static(value));
    }
    answer
}

fn content<B>(request: &Request<B>, visitors: Visitors) -> Answer {
    if !visitors.may_ask(request) {
        return plain(StatusCode::MISDIRECTED_REQUEST, "This is no host of that name.\n");
    }
    if ![Method::GET, Method::HEAD].contains(request.method()) {
        let mut refusal = plain(StatusCode::METHOD_NOT_ALLOWED, "The page can only be read (GET, HEAD).\n");
        refusal.headers_mut().insert(ALLOW, HeaderValue::from_static("GET, HEAD"));
        return refusal;
    }
    match File::at(request.uri().path()) {
        Some(file) if is_known(file, request.headers()) => {
            let mut unchanged = Answer::default();
            *unchanged.status_mut() = StatusCode::NOT_MODIFIED;
            unchanged.headers_mut().insert(ETAG, HeaderValue::from_static(file.tag));
            unchanged
        }
        Some(file) => whole(file, request.headers()),
        None => plain(StatusCode::NOT_FOUND, "The page has no such file.\n"),
    }
}

fn whole(file: &'static File, asked: &HeaderMap) -> Answer {
    let compressed = takes_gzip(asked);
    let body = if compressed {
        Bytes::from_static(file.gzip)
    } else {
        let Ok(plain_bytes) = file.plain() else {
            return plain(StatusCode::INTERNAL_SERVER_ERROR, "This file of the page is damaged.\n");
        };
        plain_bytes.into()
    };
    let mut answer = Answer::new(Full::new(body));
    let headers = answer.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static(file.media));
    headers.insert(ETAG, HeaderValue::from_static(file.tag));
    if compressed {
        headers.insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
    }
    answer
}

fn plain(status: StatusCode, sentence: &'static str) -> Answer {
    let mut answer = Answer::new(Full::new(Bytes::from_static(sentence.as_bytes())));
    *answer.status_mut() = status;
    answer.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static("text/plain; charset=utf-8"));
    answer
}

/// The items of a header that is a list, wherever it was broken into several.
fn items(headers: &HeaderMap, name: HeaderName) -> impl Iterator<Item = &str> {
    headers
        .get_all(name)
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|value| value.split(','))
        .map(str::trim)
}

/// Whether the client has the file as it is.
fn is_known(file: &File, headers: &HeaderMap) -> bool {
    // two tags are the same whether or not either says of itself that it is weak (RFC 9110, 8.8.3.2)
    let strong = |tag: &str| tag.trim_start_matches("W/").to_owned();
    items(headers, IF_NONE_MATCH).any(|tag| tag == "*" || strong(tag) == strong(file.tag))
}

/// Whether gzip is named among what the client takes, and not as of no worth (RFC 9110, 12.5.3).
fn takes_gzip(headers: &HeaderMap) -> bool {
    let worth = |coding: &str| {
        items(headers, ACCEPT_ENCODING).find_map(|item| {
            let mut parts = item.split(';').map(str::trim);
            let named = parts.next().is_some_and(|name| name.eq_ignore_ascii_case(coding));
            let weight = parts.find_map(|part| part.strip_prefix("q=")).map_or(Some(1.0), |q| q.parse::<f64>().ok());
            named.then(|| weight.unwrap_or(0.0))
        })
    };
    worth("gzip").or_else(|| worth("*")).is_some_and(|weight| weight > 0.0)
}
