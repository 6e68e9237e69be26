//! How a search gets on, for whoever waits for it.

use std::fmt::Debug;

/// Is notified by a search; from any thread.
pub trait SearchObserver: Debug + Sync {
    /// Position `number` of this search, from 1, was tried: force and load differ by the part `residual` of the load.
    fn position(&self, number: usize, residual: f64);
}
