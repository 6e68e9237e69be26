//! Orbits of the journal against closed solutions and the numbers of a second code.

mod conserving;
mod finite;
mod scene;
mod short;
mod storage;
