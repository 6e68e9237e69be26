//! The factorised tangent at a solution.

use std::sync::OnceLock;

use crate::factorization::SingleFactor;
use crate::iterated::Iterated;
use crate::linear_solver::{Enough, MultigridSolver};
use crate::nested::{Nested, NestedSystem};
use crate::{Constraints, Error, Factorization, LinearSolver, Matrix, UnsymmetricFactorization};

/// A residual above this fraction of the right-hand side is refined once, and refused after.
const REFINE_ABOVE: f64 = 1e-12;
const REFUSE_ABOVE: f64 = 1e-7;
/// Part of the terms of a row that its residual is at most where the solution is that of a system that differs by
/// rounding.
const ROUNDING: f64 = 1e-12;
/// Terms of the rows over the right-hand side of a matrix that is singular for all that is known.
const SINGULAR_ABOVE: f64 = 1e12;
/// Residual over right-hand side of a solve that needs no more.
const ONE_DIGIT: f64 = 1e-1;

/// How linear systems are solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Route {
    /// A factor.
    Direct,
    /// Conjugate gradients with multigrid.
    Multigrid,
    /// A factor, after multigrid was found to be slow.
    Switched,
}

/// What a tangent is solved with.
#[derive(Debug)]
enum Factor {
    Cholesky(Factorization),
    Lu(Box<UnsymmetricFactorization>),
    Multigrid(Box<Iterated>),
    Nested(Box<NestedSystem>),
}

/// The tangent `dR/du` with the given dofs masked, and its factors.
///
/// Newton steps, error estimates and the search for equilibrium solve with it.
#[derive(Debug)]
pub struct Linearisation {
    matrix: Matrix,
    factor: Factor,
    constraints: Constraints,
    /// Factor in single precision that is made when it first preconditions.
    rough: OnceLock<SingleFactor>,
}

impl Linearisation {
    /// Joins a symmetric tangent and its Cholesky factor.
    pub fn new(matrix: Matrix, factorization: Factorization, constraints: Constraints) -> Self {
        Self { matrix, factor: Factor::Cholesky(factorization), constraints, rough: OnceLock::new() }
    }

    /// Joins an unsymmetric tangent and its LU factors.
    pub fn unsymmetric(matrix: Matrix, factorization: UnsymmetricFactorization, constraints: Constraints) -> Self {
        Self { matrix, factor: Factor::Lu(Box::new(factorization)), constraints, rough: OnceLock::new() }
    }

    /// A symmetric tangent of quadratic elements, solved by multigrid.
    pub(crate) fn multigrid(matrix: Matrix, solver: &MultigridSolver, constraints: Constraints) -> Result<Self, Error> {
        let iterated = Iterated::new(solver, &matrix, &constraints.fixed)?;
        Ok(Self { matrix, factor: Factor::Multigrid(Box::new(iterated)), constraints, rough: OnceLock::new() })
    }

    /// A symmetric tangent of cubic elements, on top of the factor of quadratic ones.
    pub(crate) fn nested(matrix: Matrix, nested: Nested, constraints: Constraints) -> Self {
        Self {
            matrix,
            factor: Factor::Nested(Box::new(NestedSystem::new(nested))),
            constraints,
            rough: OnceLock::new(),
        }
    }

    /// The tangent with other given dofs.
    ///
    /// # Errors
    /// As [`crate::LinearSolver::linearise`].
    pub(crate) fn masked_anew(self, solver: &LinearSolver, constraints: Constraints) -> Result<Self, Error> {
        let Factor::Multigrid(mut iterated) = self.factor else {
            return solver.linearise(self.matrix, constraints);
        };
        iterated.mask(&self.matrix, &constraints.fixed)?;
        Ok(Self { matrix: self.matrix, factor: Factor::Multigrid(iterated), constraints, rough: OnceLock::new() })
    }

    /// How systems with this tangent are solved.
    pub fn route(&self) -> Route {
        match &self.factor {
            Factor::Cholesky(_) | Factor::Lu(_) => Route::Direct,
            Factor::Multigrid(iterated) if iterated.factor().is_some() => Route::Switched,
            Factor::Multigrid(_) => Route::Multigrid,
            Factor::Nested(system) => system.nested.quadratic.route(),
        }
    }

    /// True if a factor of its own solves the system, false for an iteration.
    pub(crate) fn has_factor(&self) -> bool {
        !matches!(self.factor, Factor::Nested(_)) && self.route() != Route::Multigrid
    }

    /// Steps of conjugate gradients made so far; zero with a factor of its own.
    pub fn steps(&self) -> usize {
        match &self.factor {
            Factor::Multigrid(iterated) => iterated.steps(),
            Factor::Cholesky(_) | Factor::Lu(_) | Factor::Nested(_) => 0,
        }
    }

    /// Frees the levels of multigrid, for those who have solved what they need; they are made again if it is not so.
    pub fn free_levels(&self) {
        if let Factor::Multigrid(iterated) = &self.factor {
            iterated.free();
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

    /// Gives an unsymmetric tangent and its factors back, to be assembled anew and renewed.
    pub fn into_unsymmetric(self) -> Option<(Matrix, UnsymmetricFactorization)> {
        match self.factor {
            Factor::Lu(factor) => Some((self.matrix, *factor)),
            Factor::Cholesky(_) | Factor::Multigrid(_) | Factor::Nested(_) => None,
        }
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
        self.refined(b.to_vec(), false, Enough::residual(0.0), REFINE_ABOVE)
    }

    /// Solves likewise to what is `enough`; a factor gives what it has.
    ///
    /// # Errors
    /// As [`Linearisation::solve`].
    pub fn solve_to(&self, b: Vec<f64>, enough: Enough) -> Result<Vec<f64>, Error> {
        self.refined(b, false, enough, REFINE_ABOVE)
    }

    /// Solves likewise until the residual is this `part` of b: a product with an inverse that is to be no more
    /// accurate.
    ///
    /// # Errors
    /// As [`Linearisation::solve`], where the residual stays above both 1e-7 and `part` of b.
    pub fn solve_within(&self, b: &[f64], part: f64) -> Result<Vec<f64>, Error> {
        let enough = Enough::residual(part * self.constraints.free_norm(b));
        self.refined(b.to_vec(), false, enough, part.max(REFINE_ABOVE))
    }

    /// Solves `(dR/du)^T x = b`, likewise.
    ///
    /// # Errors
    /// As [`Linearisation::solve`].
    pub fn solve_transposed(&self, b: &[f64]) -> Result<Vec<f64>, Error> {
        self.refined(b.to_vec(), true, Enough::residual(0.0), REFINE_ABOVE)
    }

    /// Solves `(dR/du)^T x = b` until the residual is this `part` of b, likewise.
    ///
    /// # Errors
    /// As [`Linearisation::solve_within`].
    pub fn solve_transposed_within(&self, b: &[f64], part: f64) -> Result<Vec<f64>, Error> {
        let enough = Enough::residual(part * self.constraints.free_norm(b));
        self.refined(b.to_vec(), true, enough, part.max(REFINE_ABOVE))
    }

    /// `b` masked and put through the factor once, without a look at the residual, or solved to one digit where there
    /// is no factor: for those who need no more.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn apply_factor(&self, b: Vec<f64>, transposed: bool) -> Result<Vec<f64>, Error> {
        let mut x = self.masked(b);
        let enough = Enough::residual(ONE_DIGIT * self.constraints.free_norm(&x));
        self.back_solve(&mut x, transposed, enough)?;
        Ok(x)
    }

    /// The solution of a system with a symmetric tangent, in single precision: what preconditions larger systems.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub(crate) fn apply_rough_factor(&self, b: Vec<f64>) -> Result<Vec<f64>, Error> {
        let b = self.masked(b);
        let factor = match &self.factor {
            Factor::Cholesky(factor) => factor,
            Factor::Multigrid(iterated) => return iterated.precondition(&self.matrix, &self.constraints.fixed, b),
            Factor::Lu(_) | Factor::Nested(_) => return self.apply_factor(b, false),
        };
        let mut x = b.clone();
        match self.rough.get_or_init(|| factor.single()).solve(&mut x) {
            Ok(()) => Ok(x),
            // Numbers beyond the range of single precision.
            Err(_) => self.apply_factor(b, false),
        }
    }

    fn back_solve(&self, x: &mut Vec<f64>, transposed: bool, enough: Enough) -> Result<(), Error> {
        match (&self.factor, transposed) {
            (Factor::Cholesky(factor), _) => factor.solve(x),
            (Factor::Lu(factor), false) => factor.solve(x),
            (Factor::Lu(factor), true) => factor.solve_transposed(x),
            (Factor::Multigrid(iterated), _) => {
                *x = iterated.solve(&self.matrix, &self.constraints, x, enough)?;
                Ok(())
            }
            (Factor::Nested(system), _) => {
                *x = system.solve(&self.matrix, &self.constraints, x, enough)?;
                Ok(())
            }
        }
    }

    /// The solution; where a residual is above this part of the right-hand side it is refined once.
    fn refined(&self, b: Vec<f64>, transposed: bool, enough: Enough, refine_above: f64) -> Result<Vec<f64>, Error> {
        let b = self.masked(b);
        let mut x = b.clone();
        self.back_solve(&mut x, transposed, enough)?;
        if !self.has_factor() {
            // It checks its residual itself.
            return Ok(x);
        }
        let size = self.constraints.free_norm(&b);
        if size == 0.0 {
            return Ok(x);
        }
        let mut correction = self.residual(&b, &x, transposed);
        let left = self.constraints.free_norm(&correction);
        if left.is_nan() || left > refine_above * size {
            self.back_solve(&mut correction, transposed, enough)?;
            for (x, correction) in x.iter_mut().zip(&correction) {
                *x += correction;
            }
            let residual = self.residual(&b, &x, transposed);
            let relative = self.constraints.free_norm(&residual) / size;
            if (relative.is_nan() || relative > REFUSE_ABOVE.max(refine_above))
                && !self.is_stable(&b, &x, &residual, transposed)
            {
                return Err(Error::Inaccurate { relative });
            }
        }
        Ok(x)
    }

    /// True if `x` solves a system whose every entry is that of this one to rounding (Oettli, Prager, Numer. Math. 6
    /// (1964) 405): where conductances differ by many orders residuals over the right-hand side say little. An entry of
    /// the right-hand side below rounding of the whole counts as that, for terms may be as small as 1e-44 of it. Not of
    /// solutions so large that the matrix must be singular.
    fn is_stable(&self, b: &[f64], x: &[f64], residual: &[f64], transposed: bool) -> bool {
        let absolute = Matrix {
            pattern: self.matrix.pattern.clone(),
            values: self.matrix.values.iter().map(|value| value.abs()).collect(),
        };
        let x: Vec<f64> = x.iter().map(|x| x.abs()).collect();
        let sizes = self.masked(match (&self.factor, transposed) {
            (Factor::Lu(_), true) => absolute.multiply_transposed(&x),
            _ => absolute.multiply(&x),
        });
        let whole = self.constraints.free_norm(b);
        let is_bounded = self.constraints.free_norm(&sizes) < SINGULAR_ABOVE * whole;
        let own = |b: f64| b.abs().max(ROUNDING * whole);
        is_bounded && (residual.iter().zip(&sizes).zip(b)).all(|((r, size), &b)| r.abs() <= ROUNDING * (size + own(b)))
    }

    fn residual(&self, b: &[f64], x: &[f64], transposed: bool) -> Vec<f64> {
        let product = match (&self.factor, transposed) {
            (Factor::Lu(_), true) => self.matrix.multiply_transposed(x),
            _ => self.matrix.multiply(x),
        };
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
