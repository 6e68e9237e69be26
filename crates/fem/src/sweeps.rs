//! Gauss-Seidel sweeps in blocks of rows, in single precision: what takes the short waves out of an error.
//!
//! Rows are cut into a fixed number of blocks. A sweep uses new values within a block and old ones of other blocks, so
//! blocks run side by side and threads do not change a bit. With `M` the lower triangles of the blocks, diagonal
//! included,
//! ```text
//! forward from zero:  z = M^-1 r
//! what it leaves:     r - A z = (M - A) z
//! backward:           z + M^-T (r - A z)
//! ```
//! A forward and a backward sweep around something symmetric are symmetric. A masked dof has an inverse diagonal of
//! zero: it stays zero.
//!
//! The matrix is symmetric, so entries left of the diagonal are stored alone: `a_ij` counts in row i with `x_j`, and in
//! row j with `x_i`. One pass over this half is a sweep, and gives what the sweep leaves.

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
    /// One over the diagonal; zero at masked dofs.
    inverse: Vec<f32>,
}

/// The rows of one block.
#[derive(Debug)]
struct RowBlock {
    rows: Range<usize>,
    /// First entry of each row, and the end.
    row_start: Vec<u32>,
    /// Entries of the block's own columns left of the diagonal, row by row, columns counted from the first row of the
    /// block.
    entries: Vec<LowerEntry>,
    /// Entries in columns of other blocks, row by row.
    cross: Vec<Cross>,
    /// Entries on the diagonal.
    diagonal: Vec<f32>,
}

/// An entry of a row.
#[derive(Debug, Clone, Copy)]
struct LowerEntry {
    column: u32,
    value: f32,
}

/// An entry that joins two blocks; its row is counted from the first of its block.
#[derive(Debug)]
struct Cross {
    row: u32,
    column: u32,
    value: f32,
}

impl RowBlock {
    fn new(matrix: &Matrix, rows: Range<usize>, scale: f64) -> Self {
        let pattern = &matrix.pattern;
        let all = pattern.row_start[rows.end] as usize - pattern.row_start[rows.start] as usize;
        let mut row_start = Vec::with_capacity(rows.len() + 1);
        row_start.push(0);
        // One more: an entry that is not kept is written behind the last one.
        let mut entries = vec![LowerEntry { column: 0, value: 0.0 }; all.saturating_sub(rows.len()).div_ceil(2) + 1];
        let (mut cross, mut diagonal) = (Vec::new(), vec![0.0; rows.len()]);
        let mut kept = 0;
        for i in rows.clone() {
            for k in pattern.row(i) {
                let column = pattern.columns[k] as usize;
                let value = (matrix.values[k] * scale) as f32;
                if !rows.contains(&column) {
                    cross.push(Cross { row: (i - rows.start) as u32, column: column as u32, value });
                    continue;
                }
                if column == i {
                    diagonal[i - rows.start] = value;
                }
                // Written in any case: on which side it is cannot be foretold.
                entries[kept] = LowerEntry { column: (column - rows.start) as u32, value };
                kept += usize::from(column < i);
            }
            row_start.push(kept as u32);
        }
        Self { rows, row_start, entries, cross, diagonal }
    }

    /// The entries of row `i`.
    #[inline(always)]
    fn row(&self, i: usize) -> &[LowerEntry] {
        &self.entries[self.row_start[i] as usize..self.row_start[i + 1] as usize]
    }

    /// Takes from `rows` what the other blocks' values in `z` contribute.
    fn subtract_cross(&self, z: &[f32], rows: &mut [f32]) {
        for cross in &self.cross {
            rows[cross.row as usize] -= cross.value * z[cross.column as usize];
        }
    }
}

/// A row times `x`.
#[inline(always)]
fn times(row: &[LowerEntry], x: &[f32]) -> f32 {
    let (pairs, rest) = row.as_chunks();
    // Two sums, so that one need not wait for the other.
    let [mut even, mut odd] = [0.0; 2];
    for [a, b] in pairs {
        even += a.value * x[a.column as usize];
        odd += b.value * x[b.column as usize];
    }
    even + odd + rest.iter().map(|entry| entry.value * x[entry.column as usize]).sum::<f32>()
}

/// Takes a row times `x` from its columns.
#[inline(always)]
fn subtract(row: &[LowerEntry], x: f32, columns: &mut [f32]) {
    for entry in row {
        columns[entry.column as usize] -= entry.value * x;
    }
}

impl Sweeps {
    /// The sweeps of `matrix` times `scale`, nothing masked yet.
    pub(crate) fn new(matrix: &Matrix, scale: f64) -> Self {
        let rows = matrix.pattern.dimension();
        let count = if rows < WORTH_CUTTING { 1 } else { BLOCKS };
        let block = |k| RowBlock::new(matrix, k * rows / count..(k + 1) * rows / count, scale);
        let blocks = in_order((0..count).into_par_iter().map(block));
        Self { blocks, inverse: vec![0.0; rows] }
    }

    /// Masks these dofs and no others.
    pub(crate) fn mask(&mut self, fixed: &[bool]) {
        let diagonal = self.blocks.iter().flat_map(|block| &block.diagonal);
        for ((inverse, diagonal), &fixed) in self.inverse.iter_mut().zip(diagonal).zip(fixed) {
            *inverse = if fixed || *diagonal <= 0.0 { 0.0 } else { 1.0 / diagonal };
        }
    }

    /// Runs `work` on each block with the rows of `out` that it owns.
    fn on_blocks(&self, out: &mut [f32], work: impl Fn(&RowBlock, &mut [f32]) + Sync) {
        self.parts(out).into_par_iter().for_each(|(block, part)| work(block, part));
    }

    /// Each block with the rows of `out` that it owns.
    fn parts<'a>(&'a self, out: &'a mut [f32]) -> Vec<(&'a RowBlock, &'a mut [f32])> {
        let mut parts = Vec::with_capacity(self.blocks.len());
        let mut rest = out;
        for block in &self.blocks {
            let (part, after) = rest.split_at_mut(block.rows.len());
            parts.push((block, part));
            rest = after;
        }
        parts
    }

    /// `z = M^-1 r`, and what that leaves of the residual: zero at masked dofs.
    pub(crate) fn forward(&self, r: &[f32]) -> [Vec<f32>; 2] {
        let [mut z, mut left] = [vec![0.0; r.len()], vec![0.0; r.len()]];
        let parts = self.parts(&mut z).into_par_iter().zip(self.parts(&mut left));
        parts.for_each(|((block, z), (_, left))| {
            let (r, inverse) = (&r[block.rows.clone()], &self.inverse[block.rows.clone()]);
            for i in 0..z.len() {
                let row = block.row(i);
                z[i] = (r[i] - times(row, z)) * inverse[i];
                subtract(row, z[i], left);
            }
        });
        self.on_blocks(&mut left, |block, left| {
            block.subtract_cross(&z, left);
            for (left, &inverse) in left.iter_mut().zip(&self.inverse[block.rows.clone()]) {
                *left = if inverse == 0.0 { 0.0 } else { *left };
            }
        });
        [z, left]
    }

    /// `z + M^-T (r - A z)`.
    pub(crate) fn backward(&self, r: &[f32], z: &mut [f32]) {
        let mut wanted = r.to_vec();
        self.on_blocks(&mut wanted, |block, wanted| block.subtract_cross(z, wanted));
        let parts = self.parts(z).into_par_iter().zip(self.parts(&mut wanted));
        parts.for_each(|((block, z), (_, wanted))| {
            let inverse = &self.inverse[block.rows.clone()];
            for i in (0..z.len()).rev() {
                let row = block.row(i);
                z[i] = (wanted[i] - times(row, z)) * inverse[i];
                subtract(row, z[i], wanted);
            }
        });
    }

    /// `A x` on the dofs that are not masked, zero on the others.
    pub(crate) fn multiply(&self, x: &[f32]) -> Vec<f32> {
        let mut product = vec![0.0; x.len()];
        self.on_blocks(&mut product, |block, product| {
            let (own, diagonal) = (&x[block.rows.clone()], &block.diagonal);
            for i in 0..product.len() {
                let row = block.row(i);
                product[i] += times(row, own) + diagonal[i] * own[i];
                subtract(row, -own[i], product);
            }
            for cross in &block.cross {
                product[cross.row as usize] += cross.value * x[cross.column as usize];
            }
            for (product, &inverse) in product.iter_mut().zip(&self.inverse[block.rows.clone()]) {
                *product = if inverse == 0.0 { 0.0 } else { *product };
            }
        });
        product
    }
}
