//! What is reported: one idea a file.

pub mod cavity;
pub mod error_bars;
pub mod flow;
pub mod load;
pub mod pressure;
pub mod similarity;
