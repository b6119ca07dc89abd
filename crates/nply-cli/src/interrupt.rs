//! Long work: how many threads it takes, and Ctrl-C, which ends it between two pieces and not in the midst of one.

use std::sync::atomic::{AtomicBool, Ordering};

use clap::{Arg, ArgMatches};

use crate::arguments::count;
use crate::failure::Failure;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// More threads than any machine has use for.
const THREADS: u32 = 1024;

/// `--jobs`.
pub(crate) fn jobs() -> Arg {
    let most = THREADS.into();
    count("jobs", "Threads to use (all cores)", most)
}

/// Makes the threads that `--jobs` asks for, and listens for Ctrl-C.
pub(crate) fn prepare(arguments: &ArgMatches) {
    // what the environment asks for (RAYON_NUM_THREADS) has the same bound as the flag
    let said = std::env::var("RAYON_NUM_THREADS").ok().and_then(|said| said.parse::<u64>().ok());
    let bounded = said.filter(|said| *said > THREADS.into()).map(|_| THREADS);
    if let Some(jobs) = arguments.get_one::<u32>("jobs").copied().or(bounded) {
        // fails only where threads stand already, and then so many are used
        let _ = rayon::ThreadPoolBuilder::new().num_threads(jobs as usize).build_global();
    }
    listen();
}

/// Listens for Ctrl-C.
pub(crate) fn listen() {
    // where it cannot be caught, Ctrl-C ends the program as it does any other
    let _ = ctrlc::set_handler(|| INTERRUPTED.store(true, Ordering::Relaxed));
}

/// Does something else at Ctrl-C than to interrupt the work.
#[cfg(feature = "explore")]
pub(crate) fn instead(action: impl Fn() + Send + 'static) {
    let _ = ctrlc::set_handler(action); // as above
}

/// Whether work may go on.
pub(crate) fn check() -> Result<(), Failure> {
    if INTERRUPTED.load(Ordering::Relaxed) { Err(Failure::Interrupted) } else { Ok(()) }
}
