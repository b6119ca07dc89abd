//! The explorer's page, served from within the command: nothing is read from the disk, no request leaves anything behind.

mod answer;
mod host;
mod page;

use std::convert::Infallible;
use std::io;
use std::net::{SocketAddr, TcpListener};
use std::pin::pin;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::net::TcpStream;
use tokio::sync::{Notify, Semaphore};
use tokio::task::AbortHandle;
use tokio::time::timeout;

pub(crate) use host::Visitors;
pub(crate) use page::IS_BUILT;

/// What one client may take, so that none keeps the others waiting.
#[derive(Clone, Copy)]
struct Limits {
    /// connections at a time; for one more, that which has asked for nothing the longest is cut
    connections: usize,
    /// bytes of a request line with its headers
    head: usize,
    /// until those have come
    head_within: Duration,
    /// until a connection takes no further request
    connection_within: Duration,
    /// and until it is cut, whatever it still reads
    grace: Duration,
}

const LIMITS: Limits = Limits {
    connections: 256,
    head: 16 << 10,
    head_within: Duration::from_secs(10),
    connection_within: Duration::from_secs(60),
    grace: Duration::from_secs(60),
};

/// A page that can be asked for, as soon as it is made.
pub(crate) struct Server {
    listener: TcpListener,
    visitors: Visitors,
    limits: Limits,
}

/// Ends a server.
#[derive(Clone, Default)]
pub(crate) struct Stop(Arc<Notify>);

impl Stop {
    pub(crate) fn now(&self) {
        self.0.notify_one();
    }
}

impl Server {
    pub(crate) fn new(address: SocketAddr, visitors: Visitors) -> io::Result<Self> {
        let listener = TcpListener::bind(address)?;
        listener.set_nonblocking(true)?;
        Ok(Self { listener, visitors, limits: LIMITS })
    }

    /// Where it listens: with the port that was found, where any was wanted.
    pub(crate) fn address(&self) -> io::Result<SocketAddr> {
        self.listener.local_addr()
    }

    /// Answers until it is stopped; what is being answered then is cut.
    pub(crate) fn run(self, stop: &Stop) -> io::Result<()> {
        // one thread has enough to do with waiting: all answers lie ready
        let runtime = tokio::runtime::Builder::new_current_thread().enable_io().enable_time().build()?;
        let listener = {
            let _inside = runtime.enter();
            tokio::net::TcpListener::from_std(self.listener)?
        };
        runtime.spawn(accept(listener, self.visitors, self.limits));
        runtime.block_on(stop.0.notified());
        Ok(())
    }
}

async fn accept(listener: tokio::net::TcpListener, visitors: Visitors, limits: Limits) {
    const BREATH: Duration = Duration::from_millis(50);
    let room = Arc::new(Semaphore::new(limits.connections));
    let guests = Guests::default();
    let mut number = 0;
    loop {
        match listener.accept().await {
            Ok((stream, _)) => {
                if room.available_permits() == 0 {
                    guests.cut_most_silent();
                }
                let Ok(place) = Arc::clone(&room).acquire_owned().await else { return };
                number += 1;
                let (number, known) = (number, guests.clone());
                let task = tokio::spawn(async move {
                    converse(stream, visitors, limits, || known.has_asked(number)).await;
                    known.has_left(number);
                    drop(place);
                });
                guests.has_come(number, task.abort_handle());
            }
            // a client that left already, or no descriptor free: the next one may fare better
            Err(_) => tokio::time::sleep(BREATH).await,
        }
    }
}

/// Those connected, who asked longest ago (or came longest ago and asked for nothing) first: many who say nothing, or a letter a second,
/// keep nobody else waiting.
#[derive(Clone, Default)]
struct Guests(Arc<Mutex<Vec<(u64, AbortHandle)>>>);

impl Guests {
    fn list(&self) -> MutexGuard<'_, Vec<(u64, AbortHandle)>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn has_come(&self, number: u64, task: AbortHandle) {
        self.list().push((number, task));
    }

    fn has_asked(&self, number: u64) {
        let mut list = self.list();
        if let Some(at) = list.iter().position(|(other, _)| *other == number) {
            let guest = list.remove(at);
            list.push(guest);
        }
    }

    fn has_left(&self, number: u64) {
        self.list().retain(|(other, _)| *other != number);
    }

    fn cut_most_silent(&self) {
        let mut list = self.list();
        if !list.is_empty() {
            list.remove(0).1.abort();
        }
    }
}

/// One connection. Errors are the client's: a request that is none, a connection that broke.
async fn converse(stream: TcpStream, visitors: Visitors, limits: Limits, asks: impl Fn()) {
    let service = service_fn(|request| {
        asks();
        let response = answer::answer(&request, visitors);
        async move { Ok::<_, Infallible>(response) }
    });
    let mut connection = pin!(
        http1::Builder::new()
            .timer(TokioTimer::new())
            .header_read_timeout(limits.head_within)
            .max_header_size(limits.head)
            .serve_connection(TokioIo::new(stream), service)
    );
    if timeout(limits.connection_within, connection.as_mut()).await.is_err() {
        connection.as_mut().graceful_shutdown();
        let _ = timeout(limits.grace, connection).await;
    }
}

#[cfg(test)]
mod tests {
    use std::io::{Read as _, Write as _};
    use std::net::{Ipv4Addr, TcpStream};
    use std::thread;

    use super::*;

    /// A server with other limits, and what it is stopped by.
    fn serve(limits: Limits) -> (SocketAddr, Stop, thread::JoinHandle<io::Result<()>>) {
        let mut server = Server::new((Ipv4Addr::LOCALHOST, 0).into(), Visitors::Local).unwrap();
        server.limits = limits;
        let (address, stop) = (server.address().unwrap(), Stop::default());
        let stopped = stop.clone();
        (address, stop, thread::spawn(move || server.run(&stopped)))
    }

    /// All that comes until the server closes.
    fn rest(mut stream: TcpStream) -> Vec<u8> {
        let mut all = Vec::new();
        let _ = stream.read_to_end(&mut all); // a connection may be cut hard
        all
    }

    #[test]
    fn who_never_ends_his_request_is_sent_away() {
        let (address, stop, running) = serve(Limits { head_within: Duration::from_millis(30), ..LIMITS });
        for begun in ["", "GET / HTTP/1.1\r\nHost: localhost\r\nX-Slow: "] {
            let mut stream = TcpStream::connect(address).unwrap();
            stream.write_all(begun.as_bytes()).unwrap();
            assert!(!rest(stream).starts_with(b"HTTP/1.1 200"), "{begun}");
        }
        stop.now();
        running.join().unwrap().unwrap();
    }

    #[test]
    fn no_connection_stays_for_ever() {
        let brief = Duration::from_millis(30);
        let (address, stop, running) = serve(Limits { connection_within: brief, grace: brief, ..LIMITS });
        let mut stream = TcpStream::connect(address).unwrap();
        stream.write_all(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n").unwrap();
        assert!(rest(stream).starts_with(b"HTTP/1.1 200"));
        stop.now();
        running.join().unwrap().unwrap();
    }

    #[test]
    fn the_silent_make_room() {
        // nobody is sent away for being slow here, but for those who come later
        let patient = Duration::from_secs(600);
        let (address, stop, running) = serve(Limits { connections: 8, head_within: patient, ..LIMITS });
        let mut silent: Vec<TcpStream> = (0..20).map(|_| TcpStream::connect(address).unwrap()).collect();
        for stream in &mut silent {
            let _ = stream.write_all(b"GET / HTTP/1.1\r\nHost: localhost\r\nX-Slow: "); // some are cut already
        }
        for _ in 0..20 {
            let mut asks = TcpStream::connect(address).unwrap();
            asks.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
            asks.write_all(b"GET / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n").unwrap();
            assert!(rest(asks).starts_with(b"HTTP/1.1 200"));
        }
        drop(silent);
        stop.now();
        running.join().unwrap().unwrap();
    }
}
