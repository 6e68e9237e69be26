//! How thick the film is: a sum of contributions, one a file.

mod eccentricity;
mod groove_depth;

pub use eccentricity::Eccentricity;
pub use groove_depth::GrooveDepth;

use std::sync::Arc;

use crate::journal_state::JournalChange;
use crate::{FilmPoint, JournalState};

/// A part of the film thickness.
pub trait FilmContribution: Send + Sync + std::fmt::Debug {
    /// Adds its thickness [m], slope and rate [m/s] at `positions` [m] (developed surface) in triangle `cell`.
    fn add(&self, journal: &JournalState, cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]);

    /// Adds what it changes, to first order, where the journal changes by `change`. Nothing unless it knows the journal.
    fn vary(&self, _change: &JournalChange, _cell: usize, _positions: &[[f64; 2]], _film: &mut [FilmPoint]) {}

    /// The same part of the film on another mesh of the liner, whose triangle `t` lies in triangle `parents[t]` of this one.
    fn carried(&self, parents: &[u32]) -> Arc<dyn FilmContribution>;
}
