//! Square matrices of a few hundred rows, all entries kept, and their factors.

use nalgebra::{DMatrix, DVector, Dyn, LU};

/// A square matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct SquareMatrix(DMatrix<f64>);

/// The factors `P A = L U` of a matrix, none of whose pivots vanishes.
#[derive(Debug, Clone)]
pub struct Factors(LU<f64, Dyn, Dyn>);

impl SquareMatrix {
    /// The matrix of zeros with this many rows.
    pub fn zeros(order: usize) -> Self {
        Self(DMatrix::zeros(order, order))
    }

    /// Number of rows, and of columns.
    pub fn order(&self) -> usize {
        self.0.nrows()
    }

    /// The entry of a row and a column.
    pub fn at(&self, row: usize, column: usize) -> f64 {
        self.0[(row, column)]
    }

    /// Adds to the entry of a row and a column.
    pub fn add(&mut self, row: usize, column: usize, more: f64) {
        self.0[(row, column)] += more;
    }

    /// The matrix times a number.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self(self.0 * factor)
    }

    /// The rows and columns of these numbers.
    pub fn part(&self, rows: &[usize], columns: &[usize]) -> Vec<Vec<f64>> {
        let row = |&row: &usize| columns.iter().map(|&column| self.at(row, column)).collect();
        rows.iter().map(row).collect()
    }

    /// The square matrix of the rows and columns of these numbers.
    #[must_use]
    pub fn of_numbers(&self, numbers: &[usize]) -> Self {
        Self(self.0.select_rows(numbers).select_columns(numbers))
    }

    /// The product with a vector.
    pub fn times(&self, vector: &[f64]) -> Vec<f64> {
        (&self.0 * DVector::from_column_slice(vector)).as_slice().to_vec()
    }

    /// The factors by elimination with row pivots; `None` where a pivot vanishes or is no number.
    pub fn factors(&self) -> Option<Factors> {
        let factors = self.0.clone().lu();
        let pivots = factors.u().diagonal();
        let are_pivots = pivots.iter().all(|pivot| *pivot != 0.0 && pivot.is_finite());
        are_pivots.then_some(Factors(factors))
    }
}

impl Factors {
    /// The vector whose product with the matrix is `wanted`.
    pub fn solve(&self, wanted: &[f64]) -> Vec<f64> {
        let mut x = DVector::from_column_slice(wanted);
        // No pivot vanishes.
        self.0.solve_mut(&mut x);
        x.as_slice().to_vec()
    }
}

/// `sum_k a_k b_k`.
pub(super) fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: &[[f64; 3]; 3]) -> SquareMatrix {
        let mut matrix = SquareMatrix::zeros(3);
        for (i, row) in rows.iter().enumerate() {
            row.iter().enumerate().for_each(|(j, entry)| matrix.add(i, j, *entry));
        }
        matrix
    }

    #[test]
    fn what_is_solved_gives_the_vector_back() {
        let needs_pivots = matrix(&[[0.0, 2.0, 1.0], [3.0, 0.0, 0.5], [1.0, -1.0, 0.0]]);
        let wanted = [1.0, -2.0, 0.7];
        let found = needs_pivots.factors().expect("it has an inverse").solve(&wanted);
        let back = needs_pivots.times(&found);
        assert!(back.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-15), "{back:?}");
    }

    #[test]
    fn a_singular_matrix_has_no_factors() {
        assert!(matrix(&[[1.0, 2.0, 0.0], [2.0, 4.0, 0.0], [0.0, 0.0, 1.0]]).factors().is_none());
    }
}
