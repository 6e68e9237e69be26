//! One scene to many answers: sweeps, convergence studies, the cost of effects, bearing theories, characteristics, the
//! ISO 7902 twin.

pub mod characteristics;
mod compare;
mod comparison;
pub mod convergence;
mod cost;
pub mod design;
mod mobility;
pub mod records;
mod sensitivity;
mod spread;
mod standard;
pub mod statistics;
pub mod sweep;
mod theories;

pub use characteristics::characteristics;
pub use compare::{Compare, comparisons, shafts};
pub use comparison::{Alternative, Comparison, QuantityPair};
pub use convergence::converge;
pub use records::Records;
pub use sensitivity::NoSpread;
pub use spread::{main_of, with_derivatives};

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
    /// The scene has an orbit.
    #[error(
        "[orbit] is given, but a convergence study is one of a steady film; the bars of oilwedge solve show the errors of mesh and steps in time, by their `error_parts`; remove [orbit] and give [load] with force and angle to study a film"
    )]
    Orbit,
    /// Threads cannot be started.
    #[error("cannot start the threads of a sweep: {0}")]
    Threads(String),
}
