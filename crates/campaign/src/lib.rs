//! One scene to many answers: sweeps, convergence studies, the cost of effects, bearing theories, characteristics, the ISO 7902 twin.

mod add_on;
pub mod characteristics;
pub mod convergence;
mod cost;
mod standard;
pub mod sweep;
mod theories;

pub use add_on::{AddOn, Alternative, Comparison, Estimate, Record};
pub use characteristics::characteristics;
pub use convergence::converge;
pub use cost::effect_costs;
pub use standard::standard;
pub use theories::theories;

use oilwedge_study::CompileError;

/// Why a campaign ended without an answer.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The mesh is unreadable, defective, or not that of the scene.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// The quantity whose convergence is studied is zero.
    #[error("the {goal} of this film is zero, so it has no relative error to converge")]
    NothingToConverge {
        /// Name of the quantity.
        goal: String,
    },
    /// Threads cannot be started.
    #[error("cannot start the threads of a sweep: {0}")]
    Threads(String),
}
