//! Bores and shafts that are no circles: against the numbers of a second code, measured points, and films that must be
//! equal.

mod criteria;
mod equilibrium;
mod film;
mod profiles;
