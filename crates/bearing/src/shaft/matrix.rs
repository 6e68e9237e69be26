//! Square matrices of a few hundred rows, all entries kept.

use oilwedge_fem::{Dense, DenseFactors};

/// A square matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix(Dense);

impl Matrix {
    /// The matrix of zeros with this many rows.
    pub fn zeros(order: usize) -> Self {
        Self(Dense::zeros(order, order))
    }

    /// Number of rows, and of columns.
    pub fn order(&self) -> usize {
        self.0.rows()
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
        Self(self.0.scaled(factor))
    }

    /// The rows and columns of these numbers.
    pub fn part(&self, rows: &[usize], columns: &[usize]) -> Vec<Vec<f64>> {
        let row = |&row: &usize| columns.iter().map(|&column| self.at(row, column)).collect();
        rows.iter().map(row).collect()
    }

    /// The square matrix of the rows and columns of these numbers.
    #[must_use]
    pub fn of_numbers(&self, numbers: &[usize]) -> Self {
        let entry = |row: usize, column: usize| self.at(numbers[row], numbers[column]);
        Self(Dense::from_fn(numbers.len(), numbers.len(), entry))
    }

    /// The product with a vector.
    pub fn times(&self, vector: &[f64]) -> Vec<f64> {
        self.0.times(vector)
    }

    /// The factors by elimination with row pivots; `None` where a pivot vanishes or is no number.
    pub fn factors(&self) -> Option<DenseFactors> {
        self.0.clone().factors()
    }
}

/// `sum_k a_k b_k`.
pub(super) fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
