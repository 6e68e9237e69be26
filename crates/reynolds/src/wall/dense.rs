//! Small dense square matrices: inverse and product.

use rayon::prelude::*;

/// Rows from which on a product is made in parallel.
const MANY: usize = 256;

/// A square matrix by rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Dense {
    order: usize,
    entries: Vec<f64>,
}

impl Dense {
    /// Zeros.
    pub fn zero(order: usize) -> Self {
        Self {
            order,
            entries: vec![0.0; order * order],
        }
    }

    /// Of its entries by rows; none where they are no square.
    pub fn of_rows(order: usize, entries: Vec<f64>) -> Option<Self> {
        (entries.len() == order * order).then_some(Self { order, entries })
    }

    /// How many rows it has.
    pub fn order(&self) -> usize {
        self.order
    }

    /// An entry.
    pub fn entry(&mut self, row: usize, column: usize) -> &mut f64 {
        &mut self.entries[row * self.order + column]
    }

    /// A row.
    pub fn row(&self, row: usize) -> &[f64] {
        &self.entries[row * self.order..(row + 1) * self.order]
    }

    /// Its product with a vector.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        let product = |row: usize| self.row(row).iter().zip(x).map(|(a, x)| a * x).sum();
        match self.order < MANY {
            true => (0..self.order).map(product).collect(),
            false => (0..self.order).into_par_iter().map(product).collect(),
        }
    }

    /// Its transpose.
    pub fn transposed(&self) -> Self {
        let mut transposed = Self::zero(self.order);
        for i in 0..self.order {
            for j in 0..self.order {
                *transposed.entry(j, i) = self.row(i)[j];
            }
        }
        transposed
    }

    /// Its inverse, by Gauss and Jordan with row pivots; none where it is singular.
    pub fn inverse(&self) -> Option<Self> {
        let n = self.order;
        let mut a = self.clone();
        let mut inverse = Self::zero(n);
        (0..n).for_each(|k| *inverse.entry(k, k) = 1.0);
        for k in 0..n {
            let pivot = (k..n).max_by(|&i, &j| a.row(i)[k].abs().total_cmp(&a.row(j)[k].abs()))?;
            let divisor = a.row(pivot)[k];
            if divisor == 0.0 || !divisor.is_finite() {
                return None;
            }
            for matrix in [&mut a, &mut inverse] {
                for j in 0..n {
                    matrix.entries.swap(k * n + j, pivot * n + j);
                    *matrix.entry(k, j) /= divisor;
                }
            }
            for i in (0..n).filter(|&i| i != k) {
                let factor = a.row(i)[k];
                for matrix in [&mut a, &mut inverse] {
                    for j in 0..n {
                        let upper = matrix.row(k)[j];
                        *matrix.entry(i, j) -= factor * upper;
                    }
                }
            }
        }
        Some(inverse)
    }
}
