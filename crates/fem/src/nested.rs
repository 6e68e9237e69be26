//! Conjugate gradients for cubic elements, preconditioned with the factor of the quadratic ones on the same mesh.
//!
//! `B r = P A_2^-1 P^T r + D^-1 r`: the quadratic part is solved, in single precision, the diagonal does for the rest. Some ten steps to
//! a thousandth, whatever the size of the mesh. Given dofs are masked on both sides.

use std::sync::Arc;

use crate::conjugate_gradients::{Ending, Outcome, conjugate_gradients};
use crate::{Constraints, Error, Linearisation, Matrix, Prolongation};

/// Steps end when the residual has fallen to this part of the right-hand side.
const TOLERANCE: f64 = 1e-7;
/// A residual above this part of the right-hand side after [`MOST_STEPS`] steps is refused.
const REFUSE_ABOVE: f64 = 1e-3;
/// Most steps of one solve.
const MOST_STEPS: usize = 200;

/// What a cubic system is solved with.
#[derive(Debug, Clone)]
pub struct Nested {
    /// The tangent of the quadratic elements, factorised; its given dofs may differ from those of the cubic system.
    pub quadratic: Arc<Linearisation>,
    /// Between the two spaces.
    pub prolongation: Arc<Prolongation>,
}

impl Nested {
    /// Solves `matrix x = b` on the dofs that are not given; `x` is zero at given ones. A residual (Euclidean norm) of
    /// `enough` will do; zero stands for 1e-7 of that of `b`.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositiveDefinite`], or [`Error::Inaccurate`] if steps do not lead there.
    pub(crate) fn solve(
        &self,
        matrix: &Matrix,
        constraints: &Constraints,
        b: &[f64],
        enough: f64,
    ) -> Result<Vec<f64>, Error> {
        // Zero at given dofs, so that nothing comes from there.
        let inverse: Vec<f64> = (constraints.fixed.iter().enumerate())
            .map(|(i, &fixed)| if fixed { 0.0 } else { 1.0 / matrix.diagonal(i) })
            .collect();
        let first = constraints.free_norm(b);
        let ending = Ending {
            enough: if enough > 0.0 { enough } else { TOLERANCE * first },
            most_steps: MOST_STEPS,
            foresees: false,
        };
        let precondition = |r: &[f64]| self.precondition(r, &inverse);
        match conjugate_gradients(matrix, &constraints.fixed, b, ending, precondition)? {
            Outcome::Solved { x } => Ok(x),
            Outcome::Slow { x, residual } if residual < REFUSE_ABOVE * first => Ok(x),
            Outcome::Slow { residual, .. } => Err(Error::Inaccurate {
                relative: residual / first,
            }),
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
