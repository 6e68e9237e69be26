//! Conjugate gradients for cubic elements, preconditioned with the factor of the quadratic ones on the same mesh.
//!
//! `B r = P A_2^-1 P^T r + D^-1 r`: the quadratic part is solved, in single precision, the diagonal does for the rest.
//! Some ten steps to a thousandth, whatever the size of the mesh; on needles and jumps of size, where the diagonal does
//! not do, a factor of the cubic elements takes over. Given dofs are masked on both sides.

use std::sync::{Arc, OnceLock};

use rayon::prelude::*;

use crate::conjugate_gradients::{Ending, Enough, conjugate_gradients};
use crate::factorization::LazyAnalysis;
use crate::in_order;
use crate::{Constraints, Error, Factorization, Linearisation, Matrix, Prolongation};

/// Steps end when the residual has fallen to this part of the right-hand side.
const TOLERANCE: f64 = 1e-7;
/// Steps that cost as much as a factor of the cubic elements.
const WORTH_A_FACTOR: usize = 80;

/// What a cubic system is solved with.
#[derive(Debug, Clone)]
pub struct Nested {
    /// The tangent of the quadratic elements, factorised; its given dofs may differ from those of the cubic system.
    pub quadratic: Arc<Linearisation>,
    /// Prolongation between the two spaces.
    pub prolongation: Arc<Prolongation>,
    /// Analysis for the factor of the cubic elements that takes over where steps are too many.
    pub direct: Arc<LazyAnalysis>,
}

/// A cubic system.
#[derive(Debug)]
pub(crate) struct NestedSystem {
    pub(crate) nested: Nested,
    /// Factor that is made where conjugate gradients are slow.
    factor: OnceLock<Result<Factorization, Error>>,
}

impl NestedSystem {
    pub(crate) fn new(nested: Nested) -> Self {
        Self { nested, factor: OnceLock::new() }
    }

    /// Solves `matrix x = b` on the dofs that are not given; `x` is zero at given ones. A residual of zero in
    /// `enough` stands for 1e-7 of that of `b`.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositiveDefinite`], or those of a factor.
    pub(crate) fn solve(
        &self,
        matrix: &Matrix,
        constraints: &Constraints,
        b: &[f64],
        enough: Enough,
    ) -> Result<Vec<f64>, Error> {
        if self.factor.get().is_none()
            && let Some(x) = self.nested.solve(matrix, constraints, b, enough)?
        {
            return Ok(x);
        }
        let factor = self.factor.get_or_init(|| {
            let analysis = self.nested.direct.get()?;
            analysis.factorise(matrix, &constraints.fixed)
        });
        let mut x = b.to_vec();
        factor.as_ref().map_err(Clone::clone)?.solve(&mut x)?;
        Ok(x)
    }
}

impl Nested {
    /// The solution by conjugate gradients; none where the steps would be too many.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    fn solve(
        &self,
        matrix: &Matrix,
        constraints: &Constraints,
        b: &[f64],
        mut enough: Enough,
    ) -> Result<Option<Vec<f64>>, Error> {
        // Zero at given dofs, so that nothing comes from there.
        let inverted = |(i, &fixed): (usize, &bool)| if fixed { 0.0 } else { 1.0 / matrix.diagonal(i) };
        let inverse: Vec<f64> = in_order(constraints.fixed.par_iter().enumerate().map(inverted));
        if enough.residual == 0.0 {
            enough.residual = TOLERANCE * constraints.free_norm(b);
        }
        let ending = Ending { enough, most_steps: WORTH_A_FACTOR };
        let precondition = |r: &[f64]| self.precondition(r, &inverse);
        match conjugate_gradients(matrix, &constraints.fixed, b, ending, precondition) {
            // Perhaps only the preconditioner is not positive, in single precision: a factor can tell.
            Err(Error::NotPositiveDefinite) => Ok(None),
            outcome => outcome,
        }
    }

    /// `B r`; `inverse` is one over the diagonal, zero at given dofs.
    fn precondition(&self, r: &[f64], inverse: &[f64]) -> Result<Vec<f64>, Error> {
        let coarse = self.quadratic.apply_rough_factor(self.prolongation.restrict(r))?;
        let mut z = self.prolongation.prolong(&coarse);
        for ((z, r), &inverse) in z.iter_mut().zip(r).zip(inverse) {
            *z = if inverse == 0.0 { 0.0 } else { *z + inverse * r };
        }
        Ok(z)
    }
}
