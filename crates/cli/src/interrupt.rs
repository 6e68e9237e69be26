//! Ctrl-C and SIGTERM: the first ends a run with the results it has, the second ends the program at once. A run that
//! does not come to its end within a second is ended with the best answer kept before or, where there is none, with a
//! sentence.

use crate::complain::{Failure, INTERRUPTED, say};
use oilwedge_study::Interrupt;
use oilwedge_study::result::RunResult;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;

/// Time that a run has to end by itself.
const GRACE: Duration = Duration::from_millis(600);
/// What is said where a run has no answer yet.
pub(crate) const NOTHING: &str = "ended before there was an answer; nothing was written";
/// Time between two looks whether a signal has come.
const LOOK: Duration = Duration::from_millis(30);

static ASKED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);
/// The best answer so far.
static BEST: Mutex<Option<LatestAnswer>> = Mutex::new(None);
/// Writes that of a run that does not end by itself, and returns its exit status.
static END: OnceLock<Box<dyn Fn(LatestAnswer) -> u8 + Send + Sync>> = OnceLock::new();
/// Held by whoever writes results: the run, or what ends it.
static WRITING: Mutex<()> = Mutex::new(());

/// Turns the two signals into a wish. Only for runs that look after it: others are ended by the first, as any program
/// is.
///
/// # Errors
/// The system refuses to deliver signals.
pub(crate) fn listen() -> Result<Interrupt, Failure> {
    for signal in [SIGINT, SIGTERM] {
        watch(signal).map_err(refused)?;
    }
    Ok(Interrupt::when(&ASKED))
}

/// Turns the two signals into a wish as [`listen`] does, and sees that it is met in time; where no answer is kept,
/// these words are said.
///
/// # Errors
/// The system refuses to deliver signals, or a thread.
pub(crate) fn listen_in_time(words: &'static str) -> Result<Interrupt, Failure> {
    let interrupt = listen()?;
    std::thread::Builder::new().spawn(move || end_in_time(words)).map_err(refused)?;
    Ok(interrupt)
}

fn refused(error: io::Error) -> Failure {
    Failure::Message(format!("cannot listen to Ctrl-C: {error}"))
}

/// The answer of a run that does not end by itself.
pub(crate) struct LatestAnswer {
    /// Numbers of the best film.
    pub(crate) result: RunResult,
    /// Content of `orbit.csv`, if it is that of an orbit.
    pub(crate) orbit: Option<Vec<u8>>,
}

/// Ends a run that does not end by itself by writing its best answer.
pub(crate) fn end_with(end: impl Fn(LatestAnswer) -> u8 + Send + Sync + 'static) {
    drop(END.set(Box::new(end)));
}

/// Keeps the best answer so far, in place of the one before.
pub(crate) fn keep(best: LatestAnswer) {
    *BEST.lock().unwrap_or_else(PoisonError::into_inner) = Some(best);
}

/// The right to write results, which is held to the end of the program: from then on it ends by itself.
pub(crate) fn writing() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Waits for a signal, then for the end of the run, and ends the program if that does not come.
fn end_in_time(words: &str) {
    while !ASKED.load(Ordering::Relaxed) {
        std::thread::sleep(LOOK);
    }
    std::thread::sleep(GRACE);
    let Ok(_alone) = WRITING.try_lock() else { return };
    let best = BEST.lock().unwrap_or_else(PoisonError::into_inner).take();
    let status = match (END.get(), best) {
        (Some(end), Some(best)) => end(best),
        _ => {
            say(&format!("interrupted: {words}"));
            INTERRUPTED
        }
    };
    std::process::exit(status.into());
}

/// The immediate end is registered first, so that the first signal does not cause it.
fn watch(signal: i32) -> io::Result<()> {
    flag::register_conditional_shutdown(signal, INTERRUPTED.into(), Arc::clone(&ASKED))?;
    flag::register(signal, Arc::clone(&ASKED)).map(drop)
}
