//! Films that break: random bearings, counts of iterations, cases whose answer is known.

mod bad_meshes;
mod bars;
mod counts;
mod dry;
mod invariant;
mod linear_elements;
mod random;
mod starved;
mod swift_stieber;
