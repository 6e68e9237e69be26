//! Films that break: random bearings, counts of iterations, cases whose answer is known.

mod dry;
mod linear_elements;
mod sharp;
mod starved;
mod swift_stieber;
