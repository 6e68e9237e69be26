//! Films that break: random bearings, counts of iterations, cases whose answer is known.

mod bad_meshes;
mod bars;
mod dry;
mod guide;
mod invariant;
mod linear_elements;
mod sharp;
mod starved;
mod swift_stieber;
