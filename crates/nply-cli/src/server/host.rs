//! Whom a request must be meant for. A page elsewhere whose name is made to point at this machine speaks of its own name, not of ours.

use std::net::IpAddr;

use hyper::Request;
use hyper::header::HOST;
use hyper::http::uri::Authority;

/// Who may ask.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Visitors {
    /// this machine, by its name for itself
    Local,
    /// any, by any name
    Any,
}

impl Visitors {
    /// Whether a request names a host, once, and one of ours.
    pub(super) fn may_ask<B>(self, request: &Request<B>) -> bool {
        let mut named = request.headers().get_all(HOST).iter();
        let (Some(name), None) = (named.next(), named.next()) else { return false };
        let Ok(authority) = Authority::try_from(name.as_bytes()) else { return false };
        // a host and a port, and nobody's name before them (RFC 9110, 7.2); the library takes any letters for a port, and behind a bracket
        let port = authority.as_str().strip_prefix(authority.host());
        let is_port =
            |port: &str| port.strip_prefix(':').is_some_and(|port| port.bytes().all(|digit| digit.is_ascii_digit()));
        if !port.is_some_and(|port| port.is_empty() || is_port(port)) {
            return false;
        }
        self == Self::Any || (is_here(authority.host()) && request.uri().host().is_none_or(is_here))
    }
}

fn is_here(host: &str) -> bool {
    let bare = host.strip_prefix('[').and_then(|host| host.strip_suffix(']')).unwrap_or(host);
    bare.eq_ignore_ascii_case("localhost") || bare.parse().is_ok_and(|address: IpAddr| address.is_loopback())
}
