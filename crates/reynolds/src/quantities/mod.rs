//! What is reported: one idea a file.

pub mod cavity;
pub mod contact;
mod contact_division;
pub mod contact_points;
pub mod deflection;
pub mod deviation;
mod edge;
pub mod extent;
pub mod flow;
pub mod friction;
pub mod heat_network;
pub mod inlet;
mod junction;
mod line_cut;
pub mod load;
mod load_gradient;
pub mod power;
pub mod pressure;
mod share;
pub mod similarity;
pub mod stream;
pub mod summit;
pub mod turbulence;

pub use load_gradient::LoadGradient;
