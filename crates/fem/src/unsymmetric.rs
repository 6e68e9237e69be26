//! Sparse LU factorisation of unsymmetric matrices: analysed once a mesh, factorised once a tangent.
//!
//! Wraps faer, with partial pivoting; columns in COLAMD order. A singular matrix is not
//! noticed here: every solve is followed by a check of its residual ([`crate::Linearisation`]).

use std::sync::Arc;

use faer::linalg::solvers::SolveCore;
use faer::sparse::linalg::solvers::{Lu, SymbolicLu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut};

use crate::{Error, Matrix, Pattern};

/// The analysed pattern of an unsymmetric matrix whose pattern is symmetric.
#[derive(Debug)]
pub struct UnsymmetricAnalysis {
    symbolic: SymbolicLu<u32>,
    pattern: Arc<Pattern>,
    /// Where each entry stands in the transposed matrix.
    transposed: Vec<u32>,
}

impl UnsymmetricAnalysis {
    /// Orders and analyses `pattern`: symmetric, columns ascending in each row.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if indices or memory do not fit.
    pub fn new(pattern: Arc<Pattern>) -> Result<Self, Error> {
        let unknowns = pattern.dimension();
        let symbolic = SymbolicLu::try_new(faer_pattern(&pattern)).map_err(|_| Error::TooLarge { unknowns })?;
        // Rows are visited in order, so the entries of each column are met in order too.
        let mut next = pattern.row_start.clone();
        let transposed = (pattern.columns.iter())
            .map(|&column| {
                let place = next[column as usize];
                next[column as usize] += 1;
                place
            })
            .collect();
        Ok(Self {
            symbolic,
            pattern,
            transposed,
        })
    }

    /// Factorises `matrix` with the rows and columns of fixed dofs replaced by those of the identity.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if an entry is not finite, [`Error::TooLarge`] if the factor does not fit.
    pub fn factorise(self: &Arc<Self>, matrix: &Matrix, fixed: &[bool]) -> Result<UnsymmetricFactorization, Error> {
        // Stored by columns: pivots are sought down a column, where the matrices of upwind schemes are dominant.
        let mut by_columns = vec![0.0; matrix.values.len()];
        for i in 0..self.pattern.dimension() {
            for k in self.pattern.row(i) {
                let j = self.pattern.columns[k] as usize;
                by_columns[self.transposed[k] as usize] = match (fixed[i] || fixed[j], i == j) {
                    (false, _) => matrix.values[k],
                    (true, true) => 1.0,
                    (true, false) => 0.0,
                };
            }
        }
        if !by_columns.iter().all(|value| value.is_finite()) {
            return Err(Error::NotFinite { what: "matrix" });
        }
        let unknowns = self.pattern.dimension();
        let lu = Lu::try_new_with_symbolic(
            self.symbolic.clone(),
            SparseColMatRef::new(faer_pattern(&self.pattern), &by_columns),
        )
        .map_err(|_| Error::TooLarge { unknowns })?;
        Ok(UnsymmetricFactorization { lu })
    }
}

/// The LU factors of a masked matrix.
#[derive(Debug)]
pub struct UnsymmetricFactorization {
    lu: Lu<u32, f64>,
}

impl UnsymmetricFactorization {
    /// Solves `A x = b` in place.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the solution is not finite.
    pub fn solve(&self, x: &mut [f64]) -> Result<(), Error> {
        let n = x.len();
        self.lu
            .solve_in_place_with_conj(Conj::No, MatMut::from_column_major_slice_mut(x, n, 1));
        finite(x)
    }

    /// Solves `A^T x = b` in place.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the solution is not finite.
    pub fn solve_transposed(&self, x: &mut [f64]) -> Result<(), Error> {
        let n = x.len();
        self.lu
            .solve_transpose_in_place_with_conj(Conj::No, MatMut::from_column_major_slice_mut(x, n, 1));
        finite(x)
    }
}

fn finite(x: &[f64]) -> Result<(), Error> {
    match x.iter().all(|x| x.is_finite()) {
        true => Ok(()),
        false => Err(Error::NotFinite {
            what: "solution of the linear system",
        }),
    }
}

fn faer_pattern(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, u32> {
    let n = pattern.dimension();
    SymbolicSparseColMatRef::new_checked(n, n, &pattern.row_start, None, &pattern.columns)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Constraints, Linearisation};

    /// Upwind transport with diffusion on a line of `n` points.
    fn line(n: u32) -> Matrix {
        let rows = |i: u32| i.saturating_sub(1)..(i + 2).min(n);
        let mut row_start = vec![0];
        let (mut columns, mut values) = (Vec::new(), Vec::new());
        for i in 0..n {
            for j in rows(i) {
                columns.push(j);
                values.push(match (i, j) {
                    (i, j) if i == j => 5.0 + f64::from(i % 3),
                    (i, j) if j < i => -4.0,
                    _ => -0.5,
                });
            }
            row_start.push(columns.len() as u32);
        }
        Matrix {
            pattern: Arc::new(Pattern { row_start, columns }),
            values,
        }
    }

    #[test]
    fn both_systems_are_solved_and_given_dofs_stay() {
        let matrix = line(30);
        let analysis = Arc::new(UnsymmetricAnalysis::new(matrix.pattern.clone()).unwrap());
        let mut constraints = Constraints::none(30);
        constraints.fix(7, 0.0);
        let factor = analysis.factorise(&matrix, &constraints.fixed).unwrap();
        let linearisation = Linearisation::unsymmetric(matrix, factor, constraints);
        let b: Vec<f64> = (0..30).map(|i| f64::from(i).sin()).collect();
        let (x, y) = (
            linearisation.solve(&b).unwrap(),
            linearisation.solve_transposed(&b).unwrap(),
        );
        assert_eq!((x[7], y[7]), (0.0, 0.0));
        let left = linearisation.matrix().multiply(&x);
        assert!((0..30).filter(|&i| i != 7).all(|i| (left[i] - b[i]).abs() < 1e-13));
        // b . A^-1 b is the same from both sides.
        let dot = |v: &[f64]| v.iter().zip(&b).map(|(v, b)| v * b).sum::<f64>() - v[7] * b[7];
        assert!((dot(&x) - dot(&y)).abs() < 1e-13);
    }

    #[test]
    fn a_singular_matrix_is_refused() {
        let mut matrix = line(12);
        let rows: Vec<usize> = matrix.pattern.row(5).collect();
        for k in rows {
            matrix.values[k] = 0.0;
        }
        let analysis = Arc::new(UnsymmetricAnalysis::new(matrix.pattern.clone()).unwrap());
        let constraints = Constraints::none(12);
        let solved = analysis
            .factorise(&matrix, &constraints.fixed)
            .and_then(|factor| Linearisation::unsymmetric(matrix, factor, constraints).solve(&[1.0; 12]));
        assert!(solved.is_err());
    }
}
