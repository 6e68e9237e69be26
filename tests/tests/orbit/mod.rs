//! Orbits of the journal against closed solutions and the numbers of a second code.

mod finite;
mod loads;
mod mobility;
mod no_orbit;
mod scene;
mod short;
mod standstill;
mod storage;
