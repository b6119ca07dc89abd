//! `nply explore`: the page in which a ply is twisted by hand.

use std::fmt::Write as _;
use std::net::{IpAddr, Ipv4Addr, SocketAddr};

use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use nply_sheet::{ErrorKind, Place, SpecError};

use super::Verb;
use crate::failure::Failure;
use crate::input;
use crate::interrupt;
use crate::output;
use crate::server::{self, Server, Stop, Visitors};

const LONG: &str = "\
Serves the explorer, a page in which a ply is twisted, pulled and looked at, to the browsers of this machine, and prints its address.
With FILE it begins with that ply: its data stand in the address. The page solves by itself, in the browser: nothing is sent anywhere, and nothing is fetched but the page. Ctrl-C ends it.";

pub(super) const VERB: Verb = Verb {
    name: "explore",
    about: "A page to twist a ply by hand, for the browser",
    long: LONG,
    examples: false,
    arguments,
    run,
};

/// The letters n, p, l, y on a telephone's keys.
const PORT: u16 = 6759;

fn arguments(command: Command) -> Command {
    command
        .arg(
            Arg::new("file")
                .value_name("FILE")
                .help("A TOML file with the ply to begin with; `-` reads standard input"),
        )
        .arg(
            Arg::new("port")
                .long("port")
                .value_name("PORT")
                .value_parser(value_parser!(u16))
                .help(format!("Port to listen at; 0 takes one that is free ({PORT})")),
        )
        .arg(
            Arg::new("host")
                .long("host")
                .value_name("ADDRESS")
                .value_parser(address)
                .help("Address to listen at, of this machine alone unless --allow-remote is given (127.0.0.1)"),
        )
        .arg(
            Arg::new("allow-remote")
                .long("allow-remote")
                .action(ArgAction::SetTrue)
                .help("Let other machines read the page, where --host lets them in"),
        )
        .arg(Arg::new("open").long("open").action(ArgAction::SetTrue).help("Open it in the browser"))
}

fn address(text: &str) -> Result<IpAddr, String> {
    if text.eq_ignore_ascii_case("localhost") {
        return Ok(Ipv4Addr::LOCALHOST.into());
    }
    text.parse().map_err(|_| "what is wanted is an address in digits, such as 127.0.0.1 or ::1".to_owned())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let port = arguments.get_one::<u16>("port").copied().unwrap_or(PORT);
    let host = arguments.get_one::<IpAddr>("host").copied().unwrap_or(Ipv4Addr::LOCALHOST.into());
    let visitors = if arguments.get_flag("allow-remote") { Visitors::Any } else { Visitors::Local };
    if !host.is_loopback() && visitors == Visitors::Local {
        let message =
            format!("{host} can be reached from other machines: give --allow-remote too if they may read the page");
        let place = Place::Flag("host".to_owned());
        return Err(Failure::Refused(SpecError::new(ErrorKind::Missing, place, message), String::new()));
    }

    let ply = arguments.get_one::<String>("file").map(|path| input::read_written(path)).transpose()?;

    let wanted = SocketAddr::new(host, port);
    let cannot =
        |error| Failure::File { what: format!("cannot listen at {wanted} (--port 0 takes a free port)"), error };
    let stop = Stop::default();
    let server = Server::new(wanted, visitors).map_err(cannot)?;
    let listening = server.address().map_err(cannot)?;
    interrupt::instead({
        let stop = stop.clone();
        move || stop.now()
    });

    let input::Written { data, is_study } = ply.unwrap_or_default();
    let page = format!("http://{}/{}", reached(listening), link(&data));
    output::write(&format!("{page}\n"))?;
    if is_study {
        output::note("what changes ([[path]], [map]) is for nply trace and nply map: the page begins without it");
    }
    if !server::IS_BUILT {
        output::note("this nply was built without the page, and says there how to build it");
    }
    if arguments.get_flag("open")
        && let Err(error) = open::that_detached(&page)
    {
        output::note(&format!("no browser could be opened: {error}"));
    }
    server.run(&stop).map_err(|error| Failure::File { what: format!("cannot serve {page}"), error })
}

/// Where this machine reaches what listens at an address: at itself, where that is every address.
fn reached(listening: SocketAddr) -> SocketAddr {
    match listening.ip() {
        IpAddr::V4(all) if all.is_unspecified() => SocketAddr::new(Ipv4Addr::LOCALHOST.into(), listening.port()),
        IpAddr::V6(all) if all.is_unspecified() => {
            SocketAddr::new(std::net::Ipv6Addr::LOCALHOST.into(), listening.port())
        }
        _ => listening,
    }
}

/// Data as the page reads them behind its address: `#strands=3&diameter=0.5+mm`.
fn link(data: &[(&str, String)]) -> String {
    let pairs: Vec<String> = data.iter().map(|(flag, text)| format!("{flag}={}", escaped(text))).collect();
    if pairs.is_empty() { String::new() } else { format!("#{}", pairs.join("&")) }
}

/// As a form writes it: what has a meaning in an address stands as its bytes, a blank as a plus.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for byte in text.bytes() {
        match byte {
            b' ' => escaped.push('+'),
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' | b':' | b',' => {
                escaped.push(byte.into());
            }
            _ => {
                let _ = write!(escaped, "%{byte:02X}");
            }
        }
    }
    escaped
}
