//! What a film is varied by, to first order.

use crate::JournalChange;
use crate::film_thickness::FilmContribution;

/// A small change of what a film depends on.
#[derive(Debug, Clone, Copy)]
pub enum FilmChange<'a> {
    /// The journal moves.
    Journal(JournalChange),
    /// The gap grows by this shape.
    Gap(&'a dyn FilmContribution),
    /// The gap grows with time, each second by this shape.
    GapRate(&'a dyn FilmContribution),
    /// The viscosity grows by this part [1].
    Viscosity(f64),
}

impl From<&JournalChange> for FilmChange<'_> {
    fn from(change: &JournalChange) -> Self {
        Self::Journal(*change)
    }
}
