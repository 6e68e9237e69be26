//! What is reported: one idea a file.

pub mod cavity;
mod edge;
pub mod flow;
mod junction;
pub mod load;
pub mod pressure;
pub mod similarity;
