//! Shafts on the films of all their bearings.

mod bearings;
mod deflection;
mod report;
mod statics;
mod sweep;
mod weights;
