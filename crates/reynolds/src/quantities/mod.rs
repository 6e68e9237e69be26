//! What is reported: one idea a file.

pub mod cavity;
mod edge;
pub mod flow;
pub mod friction;
pub mod inlet;
mod junction;
pub mod load;
pub mod power;
pub mod pressure;
pub mod similarity;
pub mod stream;
