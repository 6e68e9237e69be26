//! A sparse matrix on a fixed pattern.

use std::sync::Arc;

use rayon::prelude::*;

use crate::sparsity::Sparsity;

/// Rows of a product that one task computes; fixed, so that threads do not change a bit.
const ROWS_A_TASK: usize = 8192;

/// Values on a [`Sparsity`].
#[derive(Debug, Clone)]
pub struct Matrix {
    /// The pattern.
    pub sparsity: Arc<Sparsity>,
    /// One value an entry.
    pub values: Vec<f64>,
}

impl Matrix {
    /// The zero matrix.
    pub fn zero(sparsity: Arc<Sparsity>) -> Self {
        let values = vec![0.0; sparsity.columns.len()];
        Self { sparsity, values }
    }

    /// `A x`.
    pub fn multiply(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        let Sparsity { row_start, columns, .. } = &*self.sparsity;
        product.par_chunks_mut(ROWS_A_TASK).enumerate().for_each(|(task, out)| {
            for (k, y) in out.iter_mut().enumerate() {
                let i = task * ROWS_A_TASK + k;
                let row = row_start[i] as usize..row_start[i + 1] as usize;
                *y = columns[row.clone()]
                    .iter()
                    .zip(&self.values[row])
                    .map(|(&column, value)| value * x[column as usize])
                    .sum();
            }
        });
        product
    }
}
