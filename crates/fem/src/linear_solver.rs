//! How the linear systems of a space are solved: by a factor of their own, or on top of a smaller one.

use std::sync::Arc;

use crate::nested::Nested;
use crate::{Analysis, Constraints, Error, Linearisation, Matrix};

/// Part of the first residual down to which conjugate gradients are run at last,
const ENOUGH: f64 = 1e-8;
/// and while a set of contact is still sought.
const ROUGHLY_ENOUGH: f64 = 1e-4;

/// The way to solve.
#[derive(Debug, Clone)]
pub enum LinearSolver {
    /// Cholesky factorisation on an analysed pattern.
    Direct(Arc<Analysis>),
    /// Cubic elements by conjugate gradients, preconditioned with the factor of quadratic ones.
    Nested(Nested),
}

impl LinearSolver {
    /// The tangent `matrix` with given dofs, ready to be solved with.
    ///
    /// # Errors
    /// [`Error::NotFinite`] or [`Error::NotPositiveDefinite`].
    pub fn linearise(&self, matrix: Matrix, constraints: Constraints) -> Result<Linearisation, Error> {
        match self {
            Self::Direct(analysis) => {
                let factorization = analysis.factorise(&matrix, &constraints.fixed)?;
                Ok(Linearisation::new(matrix, factorization, constraints))
            }
            Self::Nested(nested) => Ok(Linearisation::nested(matrix, nested.clone(), constraints)),
        }
    }

    /// The residual (Euclidean norm) that will do in an iteration that began with the residual `first`.
    pub fn enough(&self, first: f64) -> f64 {
        match self {
            Self::Direct(_) => 0.0,
            Self::Nested(_) => ENOUGH * first,
        }
    }

    /// The same while the set of contact may still change.
    pub fn roughly_enough(&self, first: f64) -> f64 {
        match self {
            Self::Direct(_) => 0.0,
            Self::Nested(_) => ROUGHLY_ENOUGH * first,
        }
    }

    /// Part of what is natural by which solutions may be off: signs below it mean nothing.
    pub fn accuracy(&self) -> f64 {
        match self {
            Self::Direct(_) => 1e-12,
            Self::Nested(_) => 1e-8,
        }
    }
}
