//! How the linear systems of a space are solved: by a factor of their own, by multigrid, or on top of a smaller one.

use std::sync::Arc;

pub use crate::conjugate_gradients::Enough;
use crate::conjugate_gradients::TOLERANCE;
use crate::factorization::LazyAnalysis;
use crate::linear_prolongation::LinearProlongation;
use crate::nested::Nested;
use crate::{Analysis, Constraints, Error, Linearisation, Matrix};

/// The way to solve.
#[derive(Debug, Clone)]
pub enum LinearSolver {
    /// Cholesky factorisation on an analysed pattern.
    Direct(Arc<Analysis>),
    /// Quadratic elements by conjugate gradients, preconditioned by multigrid.
    Multigrid(MultigridSolver),
    /// Cubic elements by conjugate gradients, preconditioned with what solves quadratic ones.
    Nested(Nested),
}

/// What multigrid needs, whatever the matrix.
#[derive(Debug, Clone)]
pub struct MultigridSolver {
    /// Prolongation from the vertices to the quadratic elements.
    pub between: Arc<LinearProlongation>,
    /// Analysis for the factor that takes over where multigrid is slow.
    pub direct: Arc<LazyAnalysis>,
}

/// Part of the flow through given dofs to which the sum of residuals at all others is brought.
const IMBALANCE: f64 = 3e-11;

/// Parts of the first residual down to which an iteration solves its systems.
struct ResidualLimits {
    /// The part that ends an iteration in any case.
    enough: f64,
    /// The part where the balance of the law is not reached before.
    round_off: f64,
    /// The part while a set of contact is still sought.
    rough: f64,
    /// Error that solutions have at this part, over the natural size of the unknowns: signs of smaller values mean
    /// nothing.
    accuracy: f64,
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
            Self::Multigrid(solver) => Linearisation::multigrid(matrix, solver, constraints),
            Self::Nested(nested) => Ok(Linearisation::nested(matrix, nested.clone(), constraints)),
        }
    }

    fn ends(&self) -> ResidualLimits {
        match self {
            Self::Direct(_) => ResidualLimits { enough: 0.0, round_off: 0.0, rough: 0.0, accuracy: 1e-12 },
            Self::Multigrid(_) => ResidualLimits { enough: TOLERANCE, round_off: 1e-13, rough: 1e-4, accuracy: 1e-9 },
            Self::Nested(nested) if nested.quadratic.has_factor() => {
                ResidualLimits { enough: 1e-8, round_off: 1e-8, rough: 1e-4, accuracy: 1e-8 }
            }
            // What the quadratic elements leave is reduced to this part: far below what the bars say of it.
            Self::Nested(_) => ResidualLimits { enough: 1e-5, round_off: 1e-9, rough: 1e-3, accuracy: 1e-8 },
        }
    }

    /// What will do in an iteration that began with a residual of the Euclidean norm `first`, and now has the
    /// `residual` (its entries at dofs given by `constraints` are the flow through them).
    pub fn balanced(&self, first: f64, residual: &[f64], constraints: &Constraints) -> Enough {
        Enough {
            residual: self.enough(first),
            imbalance: IMBALANCE * 0.5 * constraints.sum_of_reactions(residual),
            round_off: self.ends().round_off * first,
        }
    }

    /// The residual (Euclidean norm) that will do in an iteration that began with the residual `first`.
    pub fn enough(&self, first: f64) -> f64 {
        self.ends().enough * first
    }

    /// The residual (Euclidean norm) that will do while the set of contact may still change, in an iteration that began
    /// with `first`.
    pub fn roughly_enough(&self, first: f64) -> f64 {
        self.ends().rough * first
    }

    /// Part of what is natural by which solutions may be off: signs below it mean nothing.
    pub fn accuracy(&self) -> f64 {
        self.ends().accuracy
    }
}
