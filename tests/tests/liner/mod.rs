//! Walls that give way to the film: against closed forms, the numbers of a second code, and differences of films.

mod film;
mod ring;
mod tangent;
