//! What closes the film: unknowns of the whole bearing around one film.
//!
//! | balance | unknown | where |
//! |---|---|---|
//! | load = force of the film | position of the journal | [`equilibrium`] |
//! | moment of the load and of the support = moment of the film | tilt of the journal | [`equilibrium`] |
//! | deflection of the wall = that by the pressure of the film | deflection | [`deflection`] |
//! | friction = heat carried off | temperature of the film | [`thermal_balance`], [`Heated`] |
//!
//! [`dynamics`]: how the film answers to small motions of the journal, and when a rotor on it whirls.
//! [`duty_cycle`]: the load of a journal over a cycle, by crank angle.
//! [`orbit`]: the journal under such a load; [`mobility`]: the same by a map of the film.
//! [`shaft`]: a shaft on the films of all its bearings, and its loads.
//! [`cap_bolts`]: the forces in the bolts of a connecting rod's cap, to compare the film's load with.
//!
//! The film knows its own tangent ([`oilwedge_reynolds::SolvedFilm::unknown_change`]); a balance borders it.

mod balance;
pub mod cap_bolts;
mod cascade;
mod continuation;
pub mod coordinates;
mod coupled;
mod cubic;
pub mod deadline;
pub mod deflection;
pub mod duty_cycle;
pub mod dynamics;
pub mod equilibrium;
pub mod estimate;
pub mod film_heat;
mod graetz;
pub mod heat_beside;
pub mod heat_round;
mod hill;
mod load;
mod log_eccentricity;
mod mean_network;
pub mod mobility;
mod newton;
pub mod no_equilibrium;
pub mod observer;
pub mod orbit;
mod prediction;
mod processor;
mod reason;
mod search;
pub mod search_options;
pub mod shaft;
pub mod stiffness;
mod tangent;
pub mod thermal_balance;
pub mod thermal_film;
mod time_terms;
mod together;
mod warming;
mod work;

pub use cap_bolts::{BoltForces, CapBolts, Shell};
pub use cascade::{find, find_held};
pub use coordinates::{Coordinates, Vector};
pub use deadline::{Clock, Deadline, Interrupt, Moment};
pub use duty_cycle::{Duty, DutyCycle};
pub use dynamics::{Coefficients, Dynamics, Stability, Threshold, stability};
pub use equilibrium::{Equilibrium, NEAR, ROUGHLY_BALANCED};
pub use estimate::{GREATEST_ECCENTRICITY, first_contact, first_position, is_contact};
pub use graetz::graetz_number;
pub use hill::balance_hill;
pub use load::{JournalLoad, Tilting};
pub use mean_network::mean_network;
pub use no_equilibrium::{BranchEnd, BranchLimit, NoEquilibrium, SearchEnd, Waypoint};
pub use observer::SearchObserver;
pub use prediction::{OperatingPoint, Predicted, Visited, predicted};
pub use processor::pool;
pub use search_options::{Carrier, InitialGuess, Purpose, SearchOptions};
pub use stiffness::Stiffness;
pub use tangent::{Neighbourhood, WallByPlace};
pub use thermal_balance::{Balanced, Housing, NoThermalBalance, ThermalBalance, ThermalFlows};
pub use warming::{FoundWarmth, Heated};
pub use work::Work;
