//! What runs borrow and give back, so that thousands of them leave nothing behind: flags that interrupt, and pools of
//! threads.

use std::ops::Deref;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use oilwedge_study::{Interrupt, pool};
use rayon::ThreadPool;

use crate::failure::PythonFailure;

/// Flags that no run has. An [`Interrupt`] holds its flag for ever, so flags are made once and used again.
static FLAGS: Mutex<Vec<&'static AtomicBool>> = Mutex::new(Vec::new());
/// Pools that no run has, with the process that made them: a child that was forked has none of their threads.
static POOLS: Mutex<Vec<(u32, ThreadPool)>> = Mutex::new(Vec::new());

/// A flag of one run, given back when the last that has it lets it go.
pub(crate) struct Flag(&'static AtomicBool);

impl Flag {
    /// A flag that nobody else has.
    pub(crate) fn borrowed() -> Self {
        let free = FLAGS.lock().unwrap_or_else(PoisonError::into_inner).pop();
        Self(free.unwrap_or_else(|| Box::leak(Box::default())))
    }

    /// The interrupt that comes when the flag is set.
    pub(crate) fn interrupt(&self) -> Interrupt {
        Interrupt::when(self.0)
    }

    /// Asks the run to end.
    pub(crate) fn set(&self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

impl Drop for Flag {
    fn drop(&mut self) {
        self.0.store(false, Ordering::Relaxed);
        FLAGS.lock().unwrap_or_else(PoisonError::into_inner).push(self.0);
    }
}

/// Threads of one run, given back when the last that has them lets them go.
pub(crate) struct Pool(Option<ThreadPool>);

impl Pool {
    /// A pool of this many threads that nobody else has; one for each core where no number is given.
    ///
    /// # Errors
    /// They cannot be started.
    pub(crate) fn borrowed(threads: Option<usize>) -> Result<Self, PythonFailure> {
        let cores = || std::thread::available_parallelism().map_or(1, usize::from);
        let threads = threads.unwrap_or_else(cores);
        let mut pools = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
        while let Some(place) = pools.iter().position(|(process, _)| *process != std::process::id()) {
            // Its threads are those of another process: there is nothing to end.
            std::mem::forget(pools.swap_remove(place));
        }
        let fitting = pools.iter().position(|(_, pool)| pool.current_num_threads() == threads);
        if let Some(place) = fitting {
            return Ok(Self(Some(pools.swap_remove(place).1)));
        }
        let made = pool(threads);
        made.map(|pool| Self(Some(pool))).map_err(|error| {
            PythonFailure::Argument(format!("cannot start {threads} threads: {error}; give fewer threads"))
        })
    }
}

impl Deref for Pool {
    type Target = Option<ThreadPool>;

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl Drop for Pool {
    fn drop(&mut self) {
        if let Some(pool) = self.0.take() {
            let own = (std::process::id(), pool);
            POOLS.lock().unwrap_or_else(PoisonError::into_inner).push(own);
        }
    }
}
