//! A large symmetric system by conjugate gradients with multigrid, and by a factor where that is slow.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock, PoisonError, RwLock};

use crate::conjugate_gradients::{Ending, Enough, TOLERANCE, conjugate_gradients};
use crate::linear_solver::MultigridSolver;
use crate::multigrid::Multigrid;
use crate::{Constraints, Error, Factorization, Matrix};

/// Steps that cost as much as a factor.
const WORTH_A_FACTOR: usize = 30;

/// A system and how it is solved.
#[derive(Debug)]
pub(crate) struct Iterated {
    solver: MultigridSolver,
    /// Nothing after [`Iterated::free`], until a system is solved again.
    multigrid: RwLock<Option<Arc<Multigrid>>>,
    /// Factor that is made where multigrid is slow.
    factor: OnceLock<Result<Factorization, Error>>,
    /// Steps of conjugate gradients made so far.
    steps: AtomicUsize,
}

impl Iterated {
    /// The levels of `matrix`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] or [`Error::NotPositiveDefinite`].
    pub(crate) fn new(solver: &MultigridSolver, matrix: &Matrix, fixed: &[bool]) -> Result<Self, Error> {
        Ok(Self {
            multigrid: RwLock::new(Some(Arc::new(Multigrid::new(solver.between.clone(), matrix, fixed)?))),
            solver: solver.clone(),
            factor: OnceLock::new(),
            steps: AtomicUsize::new(0),
        })
    }

    /// The solver of this matrix with other given dofs.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`].
    pub(crate) fn mask(&mut self, matrix: &Matrix, fixed: &[bool]) -> Result<(), Error> {
        self.factor = OnceLock::new();
        let multigrid = self.multigrid.get_mut().unwrap_or_else(PoisonError::into_inner);
        match multigrid.as_mut().and_then(Arc::get_mut) {
            Some(levels) => levels.mask(matrix, fixed),
            None => {
                *multigrid = None;
                Ok(())
            }
        }
    }

    /// Frees the levels of multigrid, which are made again where they are needed.
    pub(crate) fn free(&self) {
        *self.multigrid.write().unwrap_or_else(PoisonError::into_inner) = None;
    }

    /// The levels of multigrid.
    fn levels(&self, matrix: &Matrix, fixed: &[bool]) -> Result<Arc<Multigrid>, Error> {
        let there = self.multigrid.read().unwrap_or_else(PoisonError::into_inner).clone();
        if let Some(levels) = there {
            return Ok(levels);
        }
        let levels = Arc::new(Multigrid::new(self.solver.between.clone(), matrix, fixed)?);
        *self.multigrid.write().unwrap_or_else(PoisonError::into_inner) = Some(levels.clone());
        Ok(levels)
    }

    /// The factor, if multigrid was slow.
    pub(crate) fn factor(&self) -> Option<&Factorization> {
        self.factor.get()?.as_ref().ok()
    }

    /// Steps of conjugate gradients made so far.
    pub(crate) fn steps(&self) -> usize {
        self.steps.load(Ordering::Relaxed)
    }

    /// Solves `matrix x = b`; a residual of zero in `enough` stands for 1e-11 of `b`.
    ///
    /// # Errors
    /// Those of conjugate gradients and of a factor.
    pub(crate) fn solve(
        &self,
        matrix: &Matrix,
        constraints: &Constraints,
        b: &[f64],
        mut enough: Enough,
    ) -> Result<Vec<f64>, Error> {
        if enough.residual == 0.0 {
            enough.residual = TOLERANCE * constraints.free_norm(b);
        }
        let ending = Ending { enough, most_steps: WORTH_A_FACTOR };
        if self.factor.get().is_none() {
            let levels = self.levels(matrix, &constraints.fixed)?;
            let precondition = |r: &[f64]| {
                self.steps.fetch_add(1, Ordering::Relaxed);
                levels.cycle(r)
            };
            match conjugate_gradients(matrix, &constraints.fixed, b, ending, precondition) {
                Ok(Some(x)) => return Ok(x),
                // Perhaps only the preconditioner is not, in single precision: a factor can tell.
                Ok(None) | Err(Error::NotPositiveDefinite) => {}
                Err(error) => return Err(error),
            }
        }
        let factor = self.factor.get_or_init(|| {
            let analysis = self.solver.direct.get()?;
            analysis.factorise(matrix, &constraints.fixed)
        });
        let mut x = b.to_vec();
        factor.as_ref().map_err(Clone::clone)?.solve(&mut x)?;
        Ok(x)
    }

    /// One cycle, or one application of the factor, times `r`.
    ///
    /// # Errors
    /// Those of a factor.
    pub(crate) fn precondition(&self, matrix: &Matrix, fixed: &[bool], mut r: Vec<f64>) -> Result<Vec<f64>, Error> {
        match self.factor() {
            Some(factor) => {
                factor.solve(&mut r)?;
                Ok(r)
            }
            None => self.levels(matrix, fixed)?.cycle(&r),
        }
    }
}

#[cfg(test)]
mod tests;
