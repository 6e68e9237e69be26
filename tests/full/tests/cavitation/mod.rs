//! Films that break: random bearings, bad meshes, counts of iterations.

mod along_flow;
mod bad_meshes;
mod bars;
mod counts;
mod guide;
mod invariant;
mod random;
