//! Walls that give way to the film: against closed forms, the numbers of a second code, and differences of films.

mod bars;
mod contact;
mod film;
pub(crate) mod orbit;
mod ring;
mod tangent;
