//! One file a command.

pub(crate) mod accuracy;
pub(crate) mod compare;
pub(crate) mod crates;
pub(crate) mod house;
pub(crate) mod orbits;
pub(crate) mod performance;
pub(crate) mod prices;
pub(crate) mod shafts;
pub(crate) mod stability;
pub(crate) mod thermal;
pub(crate) mod tilted;
pub(crate) mod validation;
