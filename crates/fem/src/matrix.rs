//! A sparse matrix on a fixed pattern.

use std::sync::Arc;

use rayon::prelude::*;

use crate::Pattern;
use crate::in_order;

/// Rows of a product that one task computes; fixed, so that threads do not change a bit.
const ROWS_A_TASK: usize = 8192;

/// Vectors that one pass over a matrix multiplies.
pub const AT_ONCE: usize = 4;

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

    /// `A x` into `product`, zero at `fixed` dofs; what is returned is `x . A x` of the others.
    pub(crate) fn multiply_free(&self, x: &[f64], fixed: &[bool], product: &mut [f64]) -> f64 {
        self.rows_of_product(x, product, |i| !fixed[i])
    }

    /// The wanted rows of `A x`, others zero, and their product with `x`.
    fn rows_of_product(&self, x: &[f64], product: &mut [f64], is_wanted: impl Fn(usize) -> bool + Sync) -> f64 {
        let rows = |(task, out): (usize, &mut [f64])| {
            let mut curvature = 0.0;
            for (i, y) in (task * ROWS_A_TASK..).zip(out) {
                *y = if is_wanted(i) { self.row_times(i, x) } else { 0.0 };
                curvature += *y * x[i];
            }
            curvature
        };
        let curvatures = product.par_chunks_mut(ROWS_A_TASK).enumerate().map(rows);
        in_order::<f64>(curvatures).iter().sum()
    }

    /// Row `i` times `x`.
    #[inline(always)]
    fn row_times(&self, i: usize, x: &[f64]) -> f64 {
        let row = self.pattern.row(i);
        let (columns, values) = (&self.pattern.columns[row.clone()], &self.values[row]);
        // Three rows in four.
        if let (Ok(columns), Ok(values)) = (columns.try_into(), values.try_into()) {
            return row_of_edge(columns, values, x);
        }
        let ((columns, last_column), (values, last)) = (columns.as_chunks(), values.as_chunks());
        // Two sums, so that one need not wait for the other.
        let [mut even, mut odd] = [0.0; 2];
        for ([a, b], [of_a, of_b]) in columns.iter().zip(values) {
            even += of_a * x[*a as usize];
            odd += of_b * x[*b as usize];
        }
        let rest: f64 = last_column.iter().zip(last).map(|(&column, value)| value * x[column as usize]).sum();
        even + odd + rest
    }

    /// `A x` for vectors that stand side by side, by one pass over the entries.
    pub fn multiply_at_once(&self, x: &[[f64; AT_ONCE]]) -> Vec<[f64; AT_ONCE]> {
        let row = |i: usize| {
            let row = self.pattern.row(i);
            let mut sums = [0.0; AT_ONCE];
            for (&column, value) in self.pattern.columns[row.clone()].iter().zip(&self.values[row]) {
                for (sum, x) in sums.iter_mut().zip(&x[column as usize]) {
                    *sum += value * x;
                }
            }
            sums
        };
        in_order((0..x.len()).into_par_iter().with_min_len(ROWS_A_TASK).map(row))
    }

    /// `A^T x`.
    pub fn multiply_transposed(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        for (i, x) in x.iter().enumerate().filter(|(_, x)| **x != 0.0) {
            for k in self.pattern.row(i) {
                product[self.pattern.columns[k] as usize] += self.values[k] * x;
            }
        }
        product
    }
}

/// The product of the row of an edge between two quadratic triangles, nine entries, with `x`.
#[inline(always)]
fn row_of_edge(columns: &[u32; 9], values: &[f64; 9], x: &[f64]) -> f64 {
    (0..9).map(|k| values[k] * x[columns[k] as usize]).sum()
}
