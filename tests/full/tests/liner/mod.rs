//! Walls that give way: bars, contact, orbits, searches.

mod bars;
mod contact;
pub(crate) mod orbit;
mod search;
