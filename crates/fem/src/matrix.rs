//! A sparse matrix on a fixed pattern.

use std::sync::Arc;

use rayon::prelude::*;

use crate::Pattern;

/// Rows of a product that one task computes; fixed, so that threads do not change a bit.
const ROWS_A_TASK: usize = 8192;

/// Values on a [`Pattern`].
#[derive(Debug, Clone)]
pub struct Matrix {
    /// The pattern.
    pub pattern: Arc<Pattern>,
    /// One value an entry.
    pub values: Vec<f64>,
}

impl Matrix {
    /// The zero matrix.
    pub fn zero(pattern: Arc<Pattern>) -> Self {
        let values = vec![0.0; pattern.columns.len()];
        Self { pattern, values }
    }

    /// Entry `(i, i)`.
    pub fn diagonal(&self, i: usize) -> f64 {
        let place = self.pattern.row(i).find(|&k| self.pattern.columns[k] as usize == i);
        place.map_or(0.0, |k| self.values[k])
    }

    /// Adds `value` to the entry `(i, i)`.
    pub fn add_to_diagonal(&mut self, i: usize, value: f64) {
        if let Some(k) = self.pattern.row(i).find(|&k| self.pattern.columns[k] as usize == i) {
            self.values[k] += value;
        }
    }

    /// `A x`.
    pub fn multiply(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        self.rows_of_product(x, &mut product, |_| true);
        product
    }

    /// `A x` into `product`, zero at `fixed` dofs.
    pub(crate) fn multiply_free(&self, x: &[f64], fixed: &[bool], product: &mut [f64]) {
        self.rows_of_product(x, product, |i| !fixed[i]);
    }

    /// The wanted rows of `A x`; others are zero.
    fn rows_of_product(&self, x: &[f64], product: &mut [f64], is_wanted: impl Fn(usize) -> bool + Sync) {
        let Pattern { row_start, columns } = &*self.pattern;
        product.par_chunks_mut(ROWS_A_TASK).enumerate().for_each(|(task, out)| {
            for (k, y) in out.iter_mut().enumerate() {
                let i = task * ROWS_A_TASK + k;
                if !is_wanted(i) {
                    *y = 0.0;
                    continue;
                }
                let row = row_start[i] as usize..row_start[i + 1] as usize;
                *y = columns[row.clone()]
                    .iter()
                    .zip(&self.values[row])
                    .map(|(&column, value)| value * x[column as usize])
                    .sum();
            }
        });
    }

    /// `A^T x`.
    pub fn multiply_transposed(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        for (i, x) in x.iter().enumerate() {
            for k in self.pattern.row(i) {
                product[self.pattern.columns[k] as usize] += self.values[k] * x;
            }
        }
        product
    }
}
