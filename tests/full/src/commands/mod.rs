//! One file a command.

pub(crate) mod accuracy;
pub(crate) mod cavitation_iterations;
pub(crate) mod house;
pub(crate) mod orbits;
pub(crate) mod performance;
pub(crate) mod prices;
pub(crate) mod read_meshes;
pub(crate) mod shafts;
pub(crate) mod tilted;
pub(crate) mod validation;
