//! One front of a multifrontal LU factorisation: a dense matrix of the unknowns that are eliminated together and of
//! those that they touch.
//!
//! ```text
//!            own  below
//!     own  ( L\U |  U  )     panel: own columns (L\U and L), then the own rows below, transposed (U)
//!   below  (  L  |  S  )     update S: what the elimination leaves for the fronts above
//! ```
//! Without pivoting. Columns of upwind schemes are dominated by their diagonals, and stay so; whether a factor is any
//! good, the residual of each solve shows ([`crate::Linearisation`]).

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};

/// Columns that are eliminated one by one, before the others are brought up to date by a product of matrices.
const BLOCK: usize = 8;
/// Partial sums of a dot product: a fixed number, so that its bits are always the same.
const LANES: usize = 8;

/// Number of unknowns of a front.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FrontExtent {
    /// Eliminated in it.
    pub(crate) own: usize,
    /// Eliminated later.
    pub(crate) below: usize,
}

impl FrontExtent {
    /// Number of rows of the whole front.
    pub(crate) fn rows(self) -> usize {
        self.own + self.below
    }

    /// Entries of the panel.
    pub(crate) fn panel(self) -> usize {
        self.own * (self.own + 2 * self.below)
    }

    /// Entries of the update.
    pub(crate) fn update(self) -> usize {
        self.below * self.below
    }

    /// Place in the panel of the entry in row `i` and column `j` of the front, one of which must be its own.
    pub(crate) fn place(self, i: usize, j: usize) -> usize {
        match j < self.own {
            true => i + j * self.rows(),
            false => self.rows() * self.own + (j - self.own) + i * self.below,
        }
    }

    /// Adds the update `from` of a front below, whose rows have these `places` here, ascending.
    pub(crate) fn add(self, from: &[f64], places: &[u32], panel: &mut [f64], update: &mut [f64]) {
        let rows = self.rows();
        let (lower, upper) = panel.split_at_mut(rows * self.own);
        let (own, below) = places.split_at(places.partition_point(|&place| (place as usize) < self.own));
        let columns = from.chunks_exact(places.len().max(1));
        for (column, &j) in columns.zip(places) {
            let j = j as usize;
            if j < self.own {
                let to = &mut lower[j * rows..(j + 1) * rows];
                places.iter().zip(column).for_each(|(&i, value)| to[i as usize] += value);
            } else {
                let j = j - self.own;
                let to = &mut update[j * self.below..(j + 1) * self.below];
                let (above, column) = column.split_at(own.len());
                below.iter().zip(column).for_each(|(&i, value)| to[i as usize - self.own] += value);
                own.iter().zip(above).for_each(|(&i, value)| upper[j + i as usize * self.below] += value);
            }
        }
    }

    /// Eliminates the own unknowns.
    pub(crate) fn eliminate(self, panel: &mut [f64], update: &mut [f64]) {
        let (own, rows) = (self.own, self.rows());
        let (lower, upper) = panel.split_at_mut(rows * own);
        for from in (0..own).step_by(BLOCK) {
            let to = (from + BLOCK).min(own);
            self.eliminate_block(from, to, lower, upper);
            if to == own {
                break;
            }
            let (done, rest) = lower.split_at_mut(to * rows);
            let done = columns(done, rows, to).subcols(from, to - from);
            let (above, below) = columns_mut(rest, rows, own - to).split_at_row_mut(to);
            subtract(below, done.subrows(to, rows - to), above.as_ref().subrows(from, to - from));
            if self.below > 0 {
                let (done_above, rest) = upper.split_at_mut(to * self.below);
                let done_above = columns(done_above, self.below, to).subcols(from, to - from);
                let rest = columns_mut(rest, self.below, own - to);
                subtract(rest, done_above, done.subrows(to, own - to).transpose());
            }
        }
        if self.below > 0 {
            let lower = columns(lower, rows, own).subrows(own, self.below);
            let upper = columns(upper, self.below, own);
            subtract(columns_mut(update, self.below, self.below), lower, upper.transpose());
        }
    }

    /// The columns `from..to` one by one, and their rows of the columns after.
    fn eliminate_block(self, from: usize, to: usize, lower: &mut [f64], upper: &mut [f64]) {
        let rows = self.rows();
        for j in from..to {
            let (done, rest) = lower.split_at_mut((j + 1) * rows);
            let column = &mut done[j * rows + j..];
            let inverse = 1.0 / column[0];
            column[1..].iter_mut().for_each(|entry| *entry *= inverse);
            let factors = &column[1..];
            let (block, after) = rest.split_at_mut((to - j - 1) * rows);
            for next in block.chunks_exact_mut(rows) {
                let (pivot, next) = next[j..].split_at_mut(1);
                subtract_scaled(next, pivot[0], factors);
            }
            for next in after.chunks_exact_mut(rows) {
                let (pivot, next) = next[j..to].split_at_mut(1);
                subtract_scaled(next, pivot[0], factors);
            }
            if self.below > 0 {
                let (done, rest) = upper.split_at_mut((j + 1) * self.below);
                let row = &done[j * self.below..];
                for (next, factor) in rest.chunks_exact_mut(self.below).zip(&factors[..to - j - 1]) {
                    subtract_scaled(next, *factor, row);
                }
            }
        }
    }

    /// `L y = x` in place: `x` holds the own unknowns, and from the rows below it takes what these leave.
    pub(crate) fn solve_lower(self, panel: &[f64], x: &mut [f64]) {
        for (j, column) in panel.chunks_exact(self.rows()).take(self.own).enumerate() {
            let (value, after) = x[j..].split_at_mut(1);
            subtract_scaled(after, value[0], &column[j + 1..]);
        }
    }

    /// `U x = y` in place, those below being solved for.
    pub(crate) fn solve_upper(self, panel: &[f64], x: &mut [f64]) {
        let (lower, upper) = panel.split_at(self.rows() * self.own);
        let (own, below) = x.split_at_mut(self.own);
        if self.below > 0 {
            for (own, row) in own.iter_mut().zip(upper.chunks_exact(self.below)) {
                *own -= dot(row, below);
            }
        }
        for j in (0..self.own).rev() {
            let column = &lower[j * self.rows()..][..=j];
            let (before, value) = own[..=j].split_at_mut(j);
            value[0] /= column[j];
            subtract_scaled(before, value[0], column);
        }
    }

    /// `U^T y = x` in place, as [`FrontExtent::solve_lower`].
    pub(crate) fn solve_upper_transposed(self, panel: &[f64], x: &mut [f64]) {
        let (lower, upper) = panel.split_at(self.rows() * self.own);
        let (own, below) = x.split_at_mut(self.own);
        for j in 0..self.own {
            let column = &lower[j * self.rows()..][..=j];
            own[j] = (own[j] - dot(&column[..j], &own[..j])) / column[j];
            subtract_scaled(below, own[j], &upper[j * self.below..]);
        }
    }

    /// `L^T x = y` in place, those below being solved for.
    pub(crate) fn solve_lower_transposed(self, panel: &[f64], x: &mut [f64]) {
        for (j, column) in panel.chunks_exact(self.rows()).take(self.own).enumerate().rev() {
            let (value, after) = x[j..].split_at_mut(1);
            value[0] -= dot(&column[j + 1..], after);
        }
    }
}

fn columns(values: &[f64], rows: usize, columns: usize) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(&values[..rows * columns], rows, columns)
}

fn columns_mut(values: &mut [f64], rows: usize, columns: usize) -> MatMut<'_, f64> {
    MatMut::from_column_major_slice_mut(values, rows, columns)
}

/// `from -= a b`
fn subtract(from: MatMut<'_, f64>, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    matmul(from, Accum::Add, a, b, -1.0, Par::Seq);
}

/// `from -= factor x`, as far as `from` goes.
fn subtract_scaled(from: &mut [f64], factor: f64, x: &[f64]) {
    for (from, x) in from.iter_mut().zip(x) {
        *from -= factor * x;
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (mut a, mut b) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let mut sums = [0.0; LANES];
    for (a, b) in a.by_ref().zip(b.by_ref()) {
        for ((sum, a), b) in sums.iter_mut().zip(a).zip(b) {
            *sum += a * b;
        }
    }
    let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}
