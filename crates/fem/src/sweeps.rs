//! Gauss-Seidel sweeps in blocks of rows, in single precision: what takes the short waves out of an error.
//!
//! Rows are cut into a fixed number of blocks. A sweep uses new values within a block and old ones of other blocks, so
//! blocks run side by side and threads do not change a bit. With `M` the lower triangles of the blocks, diagonal
//! included,
//! ```text
//! forward from zero:  z = M^-1 r          (reads the lower triangles only)
//! what it leaves:     r - A z = (M - A) z (reads the rest only)
//! backward:           z + M^-T (r - A z)
//! ```
//! A forward and a backward sweep around something symmetric are symmetric. A masked dof has an inverse diagonal of
//! zero: it stays zero.

use std::ops::Range;

use rayon::prelude::*;

use crate::Matrix;
use crate::in_order;

/// Blocks of a matrix that is cut.
const BLOCKS: usize = 8;
/// Matrices of fewer rows are not cut.
const WORTH_CUTTING: usize = 4096;

/// A symmetric matrix, laid out for sweeps.
#[derive(Debug)]
pub(crate) struct Sweeps {
    blocks: Vec<RowBlock>,
    diagonal: Vec<f32>,
    /// One over the diagonal; zero at masked dofs.
    inverse: Vec<f32>,
}

/// The rows of one block.
#[derive(Debug)]
struct RowBlock {
    rows: Range<usize>,
    /// Entries of the block's own columns left of the diagonal, columns counted from the first row of the block.
    lower: Triangle,
    /// Entries of the block's own columns right of the diagonal.
    upper: Triangle,
    /// Entries in columns of other blocks, row by row.
    cross: Vec<Cross>,
}

/// Entries of one triangle of a block, row by row.
#[derive(Debug, Default)]
struct Triangle {
    row_start: Vec<u32>,
    columns: Vec<u32>,
    values: Vec<f32>,
}

/// An entry that joins two blocks; its row is counted from the first of its block.
#[derive(Debug)]
struct Cross {
    row: u32,
    column: u32,
    value: f32,
}

impl Triangle {
    /// No rows yet, and room for so many `rows` and `entries`.
    fn with_room(rows: usize, entries: usize) -> Self {
        let mut row_start = Vec::with_capacity(rows + 1);
        row_start.push(0);
        // One more: an entry that is not kept is written behind the last one.
        Self { row_start, columns: vec![0; entries + 1], values: vec![0.0; entries + 1] }
    }

    /// Row `i` times `x`.
    #[inline(always)]
    fn row_times(&self, i: usize, x: &[f32]) -> f32 {
        let row = self.row_start[i] as usize..self.row_start[i + 1] as usize;
        let ((columns, last_column), (values, last)) =
            (self.columns[row.clone()].as_chunks(), self.values[row].as_chunks());
        // Two sums, so that one need not wait for the other.
        let [mut even, mut odd] = [0.0; 2];
        for ([a, b], [of_a, of_b]) in columns.iter().zip(values) {
            even += of_a * x[*a as usize];
            odd += of_b * x[*b as usize];
        }
        let rest: f32 = last_column.iter().zip(last).map(|(&column, value)| value * x[column as usize]).sum();
        even + odd + rest
    }
}

impl RowBlock {
    fn new(matrix: &Matrix, rows: Range<usize>, scale: f64) -> Self {
        let pattern = &matrix.pattern;
        let entries = pattern.row_start[rows.end] as usize - pattern.row_start[rows.start] as usize;
        let half = entries.saturating_sub(rows.len()).div_ceil(2);
        let mut block = Self {
            lower: Triangle::with_room(rows.len(), half),
            upper: Triangle::with_room(rows.len(), half),
            cross: Vec::new(),
            rows: rows.clone(),
        };
        let [mut below, mut above] = [0; 2];
        for i in rows.clone() {
            for k in pattern.row(i) {
                let column = pattern.columns[k] as usize;
                let value = (matrix.values[k] * scale) as f32;
                if !rows.contains(&column) {
                    block.cross.push(Cross { row: (i - rows.start) as u32, column: column as u32, value });
                    continue;
                }
                // Written on both sides and kept on one: which one cannot be foretold.
                let own = (column - rows.start) as u32;
                (block.lower.columns[below], block.lower.values[below]) = (own, value);
                (block.upper.columns[above], block.upper.values[above]) = (own, value);
                below += usize::from(column < i);
                above += usize::from(column > i);
            }
            block.lower.row_start.push(below as u32);
            block.upper.row_start.push(above as u32);
        }
        block
    }
}

impl Sweeps {
    /// The sweeps of `matrix` times `scale`, nothing masked yet.
    pub(crate) fn new(matrix: &Matrix, scale: f64) -> Self {
        let rows = matrix.pattern.dimension();
        let count = if rows < WORTH_CUTTING { 1 } else { BLOCKS };
        let block = |k| RowBlock::new(matrix, k * rows / count..(k + 1) * rows / count, scale);
        let blocks = in_order((0..count).into_par_iter().map(block));
        let scaled = |i| (matrix.diagonal(i) * scale) as f32;
        let diagonal: Vec<f32> = in_order((0..rows).into_par_iter().map(scaled));
        Self { blocks, inverse: vec![0.0; rows], diagonal }
    }

    /// Masks these dofs and no others.
    pub(crate) fn mask(&mut self, fixed: &[bool]) {
        for ((inverse, diagonal), &fixed) in self.inverse.iter_mut().zip(&self.diagonal).zip(fixed) {
            *inverse = if fixed || *diagonal <= 0.0 { 0.0 } else { 1.0 / diagonal };
        }
    }

    /// Runs `work` on each block with the rows of `out` that it owns.
    fn on_blocks(&self, out: &mut [f32], work: impl Fn(&RowBlock, &mut [f32]) + Sync) {
        let mut parts = Vec::with_capacity(self.blocks.len());
        let mut rest = out;
        for block in &self.blocks {
            let (part, after) = rest.split_at_mut(block.rows.len());
            parts.push((block, part));
            rest = after;
        }
        parts.into_par_iter().for_each(|(block, part)| work(block, part));
    }

    /// `z = M^-1 r`.
    pub(crate) fn forward(&self, r: &[f32]) -> Vec<f32> {
        let mut z = vec![0.0; r.len()];
        self.on_blocks(&mut z, |block, z| {
            let (r, inverse) = (&r[block.rows.clone()], &self.inverse[block.rows.clone()]);
            for i in 0..z.len() {
                z[i] = (r[i] - block.lower.row_times(i, z)) * inverse[i];
            }
        });
        z
    }

    /// What a forward sweep from zero to `z` leaves of the residual; zero at masked dofs.
    pub(crate) fn left_by_forward(&self, z: &[f32]) -> Vec<f32> {
        let mut left = vec![0.0; z.len()];
        self.on_blocks(&mut left, |block, left| {
            let (own, inverse) = (&z[block.rows.clone()], &self.inverse[block.rows.clone()]);
            for (i, left) in left.iter_mut().enumerate() {
                *left = -block.upper.row_times(i, own);
            }
            block.subtract_cross(z, left);
            for (left, &inverse) in left.iter_mut().zip(inverse) {
                *left = if inverse == 0.0 { 0.0 } else { *left };
            }
        });
        left
    }

    /// `z + M^-T (r - A z)`.
    pub(crate) fn backward(&self, r: &[f32], z: &mut [f32]) {
        let mut wanted = r.to_vec();
        self.on_blocks(&mut wanted, |block, wanted| block.subtract_cross(z, wanted));
        self.on_blocks(z, |block, z| {
            let (wanted, inverse) = (&wanted[block.rows.clone()], &self.inverse[block.rows.clone()]);
            for i in (0..z.len()).rev() {
                let others = block.lower.row_times(i, z) + block.upper.row_times(i, z);
                z[i] = (wanted[i] - others) * inverse[i];
            }
        });
    }

    /// `A x` on the dofs that are not masked, zero on the others.
    pub(crate) fn multiply(&self, x: &[f32]) -> Vec<f32> {
        let mut product = vec![0.0; x.len()];
        self.on_blocks(&mut product, |block, product| {
            let (own, rows) = (&x[block.rows.clone()], block.rows.clone());
            for (i, product) in product.iter_mut().enumerate() {
                *product = block.lower.row_times(i, own)
                    + block.upper.row_times(i, own)
                    + self.diagonal[rows.start + i] * own[i];
            }
            for cross in &block.cross {
                product[cross.row as usize] += cross.value * x[cross.column as usize];
            }
            for (product, &inverse) in product.iter_mut().zip(&self.inverse[rows]) {
                *product = if inverse == 0.0 { 0.0 } else { *product };
            }
        });
        product
    }
}

impl RowBlock {
    /// Takes from `rows` what the other blocks' values in `z` contribute.
    fn subtract_cross(&self, z: &[f32], rows: &mut [f32]) {
        for cross in &self.cross {
            rows[cross.row as usize] -= cross.value * z[cross.column as usize];
        }
    }
}
