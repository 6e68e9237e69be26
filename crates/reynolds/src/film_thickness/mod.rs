//! How thick the film is: a sum of contributions, one a file.

mod eccentricity;
mod groove_depth;

pub use eccentricity::Eccentricity;
pub use groove_depth::GrooveDepth;

use crate::FilmPoint;

/// A part of the film thickness.
pub trait FilmContribution: Send + Sync {
    /// Adds its thickness h [m] and slope dh/dx at `positions` [m] (developed surface) in triangle `cell`.
    fn add(&self, cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]);
}
