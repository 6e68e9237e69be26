//! Orbits of the journal against closed solutions and the numbers of a second code.

mod finite;
mod loads;
mod mobility;
mod short;
mod storage;
