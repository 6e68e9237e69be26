//! One scene to many answers: sweeps, convergence studies, the cost of effects, bearing theories, the ISO 7902 twin.

pub mod convergence;
pub mod cost;
pub mod standard;
pub mod sweep;
pub mod theories;

pub use convergence::converge;
pub use cost::effect_costs;
pub use standard::standard;
pub use theories::theories;

use oilwedge_study::CompileError;
use serde::Serialize;

/// What stands beside a result where it is asked for.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct AddOns {
    /// What each effect changes and costs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost: Option<Vec<cost::EffectCost>>,
    /// The bearing by ISO 7902.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard: Option<standard::Standard>,
    /// The film as a short, a full and a long one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub theories: Option<theories::Theories>,
}

/// Why a campaign ended without an answer.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The mesh is unreadable, defective, or not that of the scene.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// The number whose convergence was asked for is zero.
    #[error(
        "the {goal} of this film is zero, so it has no relative error and nothing converges; give an eccentricity, a feed or a load that is not zero"
    )]
    NothingToConverge {
        /// Name of the quantity.
        goal: String,
    },
    /// Threads cannot be started.
    #[error("cannot start the threads of a sweep: {0}; give fewer with --threads")]
    Threads(String),
}
