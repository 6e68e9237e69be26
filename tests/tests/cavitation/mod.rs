//! Films that break: random bearings, counts of iterations, cases whose answer is known.

mod along_flow;
mod bad_meshes;
mod bars;
mod counts;
mod dry;
mod guide;
mod invariant;
mod linear_elements;
mod random;
mod sharp;
mod starved;
mod swift_stieber;
