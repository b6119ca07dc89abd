//! Long work: on how many threads, without Python's lock, and ended by Ctrl-C between two rounds.

use std::sync::{Arc, Mutex, PoisonError};

use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// The threads, and the process they are of: a forked child has none of its parent's.
struct Threads {
    process: u32,
    jobs: usize,
    pool: Arc<ThreadPool>,
}

/// Only touched while Python's lock is held, so that no fork finds it locked.
static THREADS: Mutex<Option<Threads>> = Mutex::new(None);

/// The pool of this process, of `jobs` threads if that is said (0: as many as there are cores, or `RAYON_NUM_THREADS`).
fn pool(jobs: Option<usize>) -> PyResult<Arc<ThreadPool>> {
    let mut threads = THREADS.lock().unwrap_or_else(PoisonError::into_inner);
    let process = std::process::id();
    let wanted = jobs.or_else(|| threads.as_ref().map(|threads| threads.jobs)).unwrap_or(0);
    if let Some(threads) = threads.as_ref()
        && (threads.process, threads.jobs) == (process, wanted)
    {
        return Ok(Arc::clone(&threads.pool));
    }
    let pool = ThreadPoolBuilder::new().num_threads(wanted).build();
    let pool = Arc::new(pool.map_err(|error| PyRuntimeError::new_err(format!("no threads can be made: {error}")))?);
    let before = threads.replace(Threads { process, jobs: wanted, pool: Arc::clone(&pool) });
    if let Some(before) = before.filter(|before| before.process != process) {
        // its threads stayed behind in the parent: nobody would answer a farewell
        std::mem::forget(before);
    }
    Ok(pool)
}

/// On how many threads long work is done.
#[pyfunction]
pub fn jobs() -> PyResult<usize> {
    Ok(pool(None)?.current_num_threads())
}

/// Says on how many threads long work is done from now on; `None`: on all cores, or as many as `RAYON_NUM_THREADS` says.
#[pyfunction]
#[pyo3(signature = (jobs))]
pub fn set_jobs(jobs: Option<usize>) -> PyResult<()> {
    const MOST: usize = 1024;
    match jobs {
        Some(0) => Err(PyValueError::new_err("jobs: at least one thread is wanted; None takes all cores")),
        Some(jobs) if jobs > MOST => Err(PyValueError::new_err(format!("jobs: more than {MOST} threads are not made"))),
        jobs => pool(Some(jobs.unwrap_or(0))).map(drop),
    }
}

/// Work without Python's lock; its panics are Python's.
pub fn alone<R: Send>(py: Python<'_>, work: impl FnOnce() -> R + Send) -> PyResult<R> {
    let done = py.detach(work);
    py.check_signals()?;
    Ok(done)
}

/// Pieces of work shared out among threads, a round at a time; between rounds Ctrl-C is heard.
pub fn each<T: Sync, R: Send, E: Send>(
    py: Python<'_>,
    all: &[T],
    round: usize,
    refused: impl Fn(E) -> PyErr,
    work: impl Fn(&T) -> Result<R, E> + Sync,
) -> PyResult<Vec<R>> {
    let pool = pool(None)?;
    let mut done = Vec::with_capacity(all.len());
    for some in all.chunks(round.max(1)) {
        let found: Result<Vec<R>, E> = alone(py, || pool.install(|| some.par_iter().map(&work).collect()))?;
        done.extend(found.map_err(&refused)?);
    }
    Ok(done)
}
