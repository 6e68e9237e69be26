//! What closes the film: unknowns of the whole bearing around one film.
//!
//! | balance | unknown | where |
//! |---|---|---|
//! | load = force of the film | position of the journal | [`equilibrium`] |
//! | friction = heat carried off | temperature of the film | [`heat_balance`] |
//!
//! [`cap_joint`] is what the bolts of a connecting rod's cap must hold, to compare the film's load with.
//!
//! The film knows its own tangent ([`oilwedge_reynolds::FilmProblem::unknown_change`]); a balance borders it.

pub mod cap_joint;
pub mod cubic;
pub mod equilibrium;
pub mod estimate;
pub mod heat_balance;
pub mod no_equilibrium;
pub mod patience;
mod prediction;
mod reach;
mod search;
mod stretched;

pub use cap_joint::{CapJoint, JointForces, Shell};
pub use cubic::{find_cubic, find_cubic_near};
pub use equilibrium::{Equilibrium, NEAR, SHORT_MOVE, find, find_near, newton_step};
pub use estimate::{GREATEST_ECCENTRICITY, first_position};
pub use heat_balance::{Balanced, FilmHeat, HeatBalance, Housing, NoBalance};
pub use no_equilibrium::NoEquilibrium;
pub use patience::{Interrupt, Patience};
pub use prediction::{Point, Visited, predicted};
