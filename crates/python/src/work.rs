//! Work on threads of its own, without Python's lock: Ctrl-C ends it, and a panic becomes an exception.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use oilwedge_study::Interrupt;
use pyo3::prelude::*;

use crate::failure::PythonFailure;
use crate::shelf::{Flag, Pool};

/// Time between two looks whether a signal has come.
const LOOK: Duration = Duration::from_millis(50);
/// How long work that was interrupted is waited for. What it then still computes it computes for nobody, and ends at
/// its next look.
const FAREWELL: Duration = Duration::from_millis(100);

/// What `job` returns, which runs on so many threads, one for each core where no number is given. It may look whether
/// it is to end.
///
/// # Errors
/// The exception of a signal, the failure of the job, or [`PythonFailure::Panic`].
pub(crate) fn done<T: Send + 'static>(
    py: Python<'_>,
    threads: Option<usize>,
    job: impl FnOnce(Interrupt) -> Result<T, PythonFailure> + Send + 'static,
) -> PyResult<T> {
    let pool = Pool::borrowed(threads).map_err(|failure| failure.raised(py))?;
    let (pool, flag) = (Arc::new(pool), Arc::new(Flag::borrowed()));
    let (sender, mut receiver) = channel();
    let (own_pool, own_flag) = (Arc::clone(&pool), Arc::clone(&flag));
    let task = move || {
        let outcome = catch_unwind(AssertUnwindSafe(|| job(own_flag.interrupt())));
        // Whoever waits has the last hold of both, unless it has gone away.
        drop((own_pool, own_flag));
        // It may have gone away: then nobody wants the outcome.
        drop(sender.send(outcome));
    };
    if let Some(threads) = pool.as_ref().as_ref() {
        threads.spawn(task);
    }
    loop {
        let outcome;
        (outcome, receiver) = waited(py, receiver, LOOK);
        match outcome {
            Ok(Ok(outcome)) => return outcome.map_err(|failure| failure.raised(py)),
            Ok(Err(panic)) => return Err(PythonFailure::Panic(words(panic.as_ref())).raised(py)),
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PythonFailure::Panic("the work ended without an outcome".to_owned()).raised(py));
            }
            Err(RecvTimeoutError::Timeout) => {}
        }
        if let Err(signal) = py.check_signals() {
            flag.set();
            drop(waited(py, receiver, FAREWELL));
            return Err(signal);
        }
    }
}

/// Waits for the outcome while other threads of Python run.
fn waited<T: Send>(
    py: Python<'_>,
    receiver: Receiver<T>,
    longest: Duration,
) -> (Result<T, RecvTimeoutError>, Receiver<T>) {
    py.detach(move || (receiver.recv_timeout(longest), receiver))
}

/// What a panic says.
fn words(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    text.unwrap_or("the program has failed").to_owned()
}
