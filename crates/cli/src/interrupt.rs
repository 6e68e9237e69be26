//! Ctrl-C and SIGTERM: the first ends a run with the results it has, the second ends the program at once.

use crate::complain::{Failure, INTERRUPTED};
use oilwedge_study::Interrupt;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::io;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, LazyLock};

static ASKED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Turns the two signals into a wish. Only for runs that look after it: others are ended by the first, as any program is.
///
/// # Errors
/// The system refuses to deliver signals.
pub(crate) fn listen() -> Result<Interrupt, Failure> {
    for signal in [SIGINT, SIGTERM] {
        watch(signal).map_err(|error| Failure::Message(format!("cannot listen to Ctrl-C: {error}")))?;
    }
    Ok(Interrupt::when(&ASKED))
}

/// The immediate end is registered first, so that the first signal does not cause it.
fn watch(signal: i32) -> io::Result<()> {
    flag::register_conditional_shutdown(signal, INTERRUPTED.into(), Arc::clone(&ASKED))?;
    flag::register(signal, Arc::clone(&ASKED)).map(drop)
}
