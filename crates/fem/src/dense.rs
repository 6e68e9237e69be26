//! Dense matrices of at most some hundred rows, such as those of walls and shafts: products, factors, inverses.
//!
//! **Method.** Elimination column by column with row pivots (Golub and Van Loan, Matrix Computations, algorithm 3.4.1). **Verified by** `a_solution_gives_the_right_side_back`.

use std::ops::{Index, IndexMut};

/// A dense matrix, column by column.
#[derive(Debug, Clone, PartialEq)]
pub struct Dense {
    rows: usize,
    entries: Vec<f64>,
}

/// The factors `P A = L U` of a square matrix, none of whose pivots vanishes.
#[derive(Debug, Clone)]
pub struct DenseFactors {
    /// L below the diagonal, U on and above it.
    factors: Dense,
    /// The row with which row k was exchanged in step k.
    exchanged: Vec<usize>,
}

impl Dense {
    /// The matrix of zeros.
    pub fn zeros(rows: usize, columns: usize) -> Self {
        Self::from_columns(rows, vec![0.0; rows * columns])
    }

    /// The matrix with these entries, column by column.
    pub fn from_columns(rows: usize, entries: Vec<f64>) -> Self {
        Self { rows, entries }
    }

    /// The matrix whose entry of a row and a column is `entry(row, column)`.
    pub fn from_fn(rows: usize, columns: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let entries = (0..columns).flat_map(|column| (0..rows).map(move |row| (row, column)));
        Self::from_columns(rows, entries.map(|(row, column)| entry(row, column)).collect())
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.entries.len().checked_div(self.rows).unwrap_or(0)
    }

    /// The entries of a column.
    pub fn column(&self, column: usize) -> &[f64] {
        &self.entries[column * self.rows..][..self.rows]
    }

    /// All entries, column by column.
    pub fn entries(&self) -> &[f64] {
        &self.entries
    }

    /// All entries, column by column.
    pub fn into_columns(self) -> Vec<f64> {
        self.entries
    }

    /// The transposed matrix.
    #[must_use]
    pub fn transposed(&self) -> Self {
        Self::from_fn(self.columns(), self.rows, |row, column| self[(column, row)])
    }

    /// The matrix times a number.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        self.entries.iter_mut().for_each(|entry| *entry *= factor);
        self
    }

    /// The product with a vector.
    pub fn times(&self, vector: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; self.rows];
        for (column, factor) in vector.iter().enumerate() {
            add_multiple(&mut product, *factor, self.column(column));
        }
        product
    }

    /// The product with the matrix of these entries, column by column.
    #[must_use]
    pub fn times_columns(&self, entries: &[f64]) -> Self {
        let columns = entries.chunks_exact(self.columns().max(1));
        Self::from_columns(self.rows, columns.flat_map(|column| self.times(column)).collect())
    }

    /// The factors of a square matrix; `None` where a pivot vanishes or is no number.
    pub fn factors(mut self) -> Option<DenseFactors> {
        let order = self.rows;
        let mut exchanged = Vec::with_capacity(order);
        for k in 0..order {
            let below = self.column(k)[k..].iter().enumerate();
            let (offset, _) = below.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
            exchanged.push(k + offset);
            for column in self.entries.chunks_exact_mut(order) {
                column.swap(k, k + offset);
            }
            let (left, right) = self.entries.split_at_mut((k + 1) * order);
            let (pivot, multipliers) = left[k * order + k..].split_first_mut()?;
            if *pivot == 0.0 || !pivot.is_finite() {
                return None;
            }
            multipliers.iter_mut().for_each(|entry| *entry /= *pivot);
            for column in right.chunks_exact_mut(order) {
                let (above, below) = column.split_at_mut(k + 1);
                add_multiple(below, -above[k], multipliers);
            }
        }
        Some(DenseFactors {
            factors: self,
            exchanged,
        })
    }

    /// The inverse of a square matrix; `None` where it is singular.
    pub fn inverse(self) -> Option<Self> {
        let order = self.rows;
        let factors = self.factors()?;
        let unit = |k: usize| {
            (0..order)
                .map(move |row| f64::from(u8::from(row == k)))
                .collect::<Vec<f64>>()
        };
        Some(Self::from_columns(
            order,
            (0..order).flat_map(|k| factors.solve(&unit(k))).collect(),
        ))
    }
}

impl Index<(usize, usize)> for Dense {
    type Output = f64;

    fn index(&self, (row, column): (usize, usize)) -> &f64 {
        &self.entries[column * self.rows..][..self.rows][row]
    }
}

impl IndexMut<(usize, usize)> for Dense {
    fn index_mut(&mut self, (row, column): (usize, usize)) -> &mut f64 {
        &mut self.entries[column * self.rows..][..self.rows][row]
    }
}

impl DenseFactors {
    /// The vector whose product with the matrix is `wanted`.
    pub fn solve(&self, wanted: &[f64]) -> Vec<f64> {
        let mut x = wanted.to_vec();
        self.exchanged.iter().enumerate().for_each(|(k, row)| x.swap(k, *row));
        for k in 0..x.len() {
            let (done, below) = x.split_at_mut(k + 1);
            add_multiple(below, -done[k], &self.factors.column(k)[k + 1..]);
        }
        for k in (0..x.len()).rev() {
            let column = self.factors.column(k);
            x[k] /= column[k];
            let (above, rest) = x.split_at_mut(k);
            add_multiple(above, -rest[0], &column[..k]);
        }
        x
    }
}

/// Adds `factor` times `more` to `sum`.
fn add_multiple(sum: &mut [f64], factor: f64, more: &[f64]) {
    sum.iter_mut().zip(more).for_each(|(sum, more)| *sum += factor * more);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solution_gives_the_right_side_back() {
        let needs_pivots = Dense::from_columns(3, vec![0.0, 3.0, 1.0, 2.0, 0.0, -1.0, 1.0, 0.5, 0.0]);
        let wanted = [1.0, -2.0, 0.7];
        let found = needs_pivots
            .clone()
            .factors()
            .expect("it has an inverse")
            .solve(&wanted);
        let back = needs_pivots.times(&found);
        assert!(back.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-15), "{back:?}");
        let inverse = needs_pivots.clone().inverse().expect("it has one");
        let unit = needs_pivots.times_columns(&inverse.into_columns());
        let identity = Dense::from_fn(3, 3, |row, column| f64::from(u8::from(row == column)));
        assert!((0..9).all(|k| (unit[(k % 3, k / 3)] - identity[(k % 3, k / 3)]).abs() < 1e-15));
        assert_eq!(needs_pivots.transposed()[(0, 1)], 3.0);
    }

    #[test]
    fn a_singular_matrix_has_no_factors() {
        let singular = [1.0, 2.0, 0.0, 2.0, 4.0, 0.0, 0.0, 0.0, 1.0];
        assert!(Dense::from_columns(3, singular.to_vec()).factors().is_none());
        assert!(Dense::from_columns(1, vec![f64::NAN]).factors().is_none());
    }
}
