//! The factorised tangent at a solution.

use crate::{Constraints, Error, Factorization, Matrix};

/// A residual above this fraction of the right-hand side is refined once, and refused after.
const REFINE_ABOVE: f64 = 1e-12;
const REFUSE_ABOVE: f64 = 1e-7;

/// The tangent `dR/du` with the given dofs masked, and its Cholesky factor.
///
/// Its clients: the last Newton step, error estimates, equilibrium, dynamic coefficients.
#[derive(Debug)]
pub struct Linearisation {
    matrix: Matrix,
    factorization: Factorization,
    constraints: Constraints,
}

impl Linearisation {
    /// Joins a tangent and its factor.
    pub fn new(matrix: Matrix, factorization: Factorization, constraints: Constraints) -> Self {
        Self {
            matrix,
            factorization,
            constraints,
        }
    }

    /// The tangent, unmasked.
    pub fn matrix(&self) -> &Matrix {
        &self.matrix
    }

    /// Gives the tangent back, to be assembled anew.
    pub fn into_matrix(self) -> Matrix {
        self.matrix
    }

    /// The given dofs.
    pub fn constraints(&self) -> &Constraints {
        &self.constraints
    }

    /// Solves `(dR/du) x = b` on the free dofs; `x` is zero where the value is given, `b` is not read there.
    ///
    /// The residual is checked, and one step of iterative refinement made where it pays.
    ///
    /// # Errors
    /// [`Error::NotFinite`], or [`Error::Inaccurate`] if the residual stays above 1e-7 of `b`.
    pub fn solve(&self, b: &[f64]) -> Result<Vec<f64>, Error> {
        let b = self.masked(b.to_vec());
        let mut x = b.clone();
        self.factorization.solve(&mut x)?;
        let size = self.constraints.free_norm(&b);
        if size == 0.0 {
            return Ok(x);
        }
        let mut correction = self.residual(&b, &x);
        if self.constraints.free_norm(&correction) > REFINE_ABOVE * size {
            self.factorization.solve(&mut correction)?;
            for (x, correction) in x.iter_mut().zip(&correction) {
                *x += correction;
            }
            let relative = self.constraints.free_norm(&self.residual(&b, &x)) / size;
            if relative.is_nan() || relative > REFUSE_ABOVE {
                return Err(Error::Inaccurate { relative });
            }
        }
        Ok(x)
    }

    /// Solves `(dR/du)^T x = b`; the tangents here are symmetric, so this is [`Linearisation::solve`].
    ///
    /// # Errors
    /// As [`Linearisation::solve`].
    pub fn solve_transposed(&self, b: &[f64]) -> Result<Vec<f64>, Error> {
        self.solve(b)
    }

    fn residual(&self, b: &[f64], x: &[f64]) -> Vec<f64> {
        let product = self.matrix.multiply(x);
        self.masked(b.iter().zip(product).map(|(b, y)| b - y).collect())
    }

    fn masked(&self, mut vector: Vec<f64>) -> Vec<f64> {
        for (value, &fixed) in vector.iter_mut().zip(&self.constraints.fixed) {
            if fixed {
                *value = 0.0;
            }
        }
        vector
    }
}
