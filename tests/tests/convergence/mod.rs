//! Rates of convergence: the discretisation does what its theory says.

mod film;
mod manufactured;
mod map;
mod study;
