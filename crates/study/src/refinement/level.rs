//! A solved film on the way to a tolerance.

use crate::estimate::Estimated;
use crate::solved::Solved;

/// A solved film on the way to a tolerance.
pub(super) struct SolvedLevel {
    pub(super) solved: Solved,
    pub(super) estimated: Estimated,
    /// Greatest bar over what it may be.
    pub(super) worst: f64,
    /// Quantity that has this greatest bar.
    pub(super) worst_name: String,
    /// Greatest bar over what it may be, the load being that of the film and not of its hill, where the program chooses
    /// the mesh: flows and cavity are those of the film in any case.
    pub(super) by_film: f64,
    /// Greatest bar over what is wanted besides.
    pub(super) wanted: f64,
}
