//! Dense matrices of splines and points.

/// A dense matrix.
pub type Dense = nalgebra::DMatrix<f64>;
