//! Modes of the bush at the cells of a film: sums of modes at each cell, and sums over cells for each mode.
//!
//! A mode is a product of a wave around and a wave along; cells stand in blocks, so that sums run over cells that are
//! neighbours in memory.

use crate::{BushRing, FilmCell};

/// Cells of a block.
const BLOCK: usize = 64;
/// Lanes of a sum over a block.
const LANES: usize = 8;

/// One number for each cell of a block.
type BlockRow = [f64; BLOCK];

pub(crate) struct Waves {
    cells: usize,
    /// Number of waves around, and along.
    around_count: usize,
    along_count: usize,
    /// Waves around of block after block, one row for each.
    around: Vec<BlockRow>,
    /// Waves along, likewise.
    along: Vec<BlockRow>,
}

impl Waves {
    pub(crate) fn new(ring: &BushRing, cells: &[FilmCell]) -> Self {
        let (around_count, along_count) = (2 * ring.around + 1, ring.along + 1);
        let blocks = cells.len().div_ceil(BLOCK);
        let mut around = vec![[0.0; BLOCK]; blocks * around_count];
        let mut along = vec![[0.0; BLOCK]; blocks * along_count];
        for (c, cell) in cells.iter().enumerate() {
            let (block, place) = (c / BLOCK, c % BLOCK);
            let waves = ring.waves(cell.angle, cell.along);
            for (rows, waves) in [
                (&mut around[block * around_count..(block + 1) * around_count], waves.0),
                (&mut along[block * along_count..(block + 1) * along_count], waves.1),
            ] {
                rows.iter_mut().zip(waves).for_each(|(row, wave)| row[place] = wave);
            }
        }
        Self { cells: cells.len(), around_count, along_count, around, along }
    }

    /// Sum of the modes at each cell, to which `put` is called.
    pub(crate) fn sum(&self, modes: &[f64], mut put: impl FnMut(usize, f64)) {
        let blocks = self.around.chunks_exact(self.around_count).zip(self.along.chunks_exact(self.along_count));
        for (block, (around, along)) in blocks.enumerate() {
            let mut total = [0.0; BLOCK];
            for (m, along) in along.iter().enumerate() {
                let mut sums = [0.0; BLOCK];
                for (wave, row) in around.iter().zip(modes.chunks_exact(self.along_count)) {
                    for i in 0..BLOCK {
                        sums[i] += row[m] * wave[i];
                    }
                }
                for i in 0..BLOCK {
                    total[i] += sums[i] * along[i];
                }
            }
            for c in block * BLOCK..self.cells.min((block + 1) * BLOCK) {
                put(c, total[c % BLOCK]);
            }
        }
    }

    /// For each mode the sum over the cells of `value` times the mode.
    pub(crate) fn project(&self, value: impl Fn(usize) -> f64, modes: &mut [f64]) {
        modes.fill(0.0);
        let blocks = self.around.chunks_exact(self.around_count).zip(self.along.chunks_exact(self.along_count));
        for (block, (around, along)) in blocks.enumerate() {
            let mut values = [0.0; BLOCK];
            for c in block * BLOCK..self.cells.min((block + 1) * BLOCK) {
                values[c % BLOCK] = value(c);
            }
            for (m, along) in along.iter().enumerate() {
                let weighted: BlockRow = std::array::from_fn(|i| values[i] * along[i]);
                for (wave, row) in around.iter().zip(modes.chunks_exact_mut(self.along_count)) {
                    row[m] += product(wave, &weighted);
                }
            }
        }
    }

    /// For each mode the sum over the cells of `value` times the square of the mode.
    pub(crate) fn squares(&self, value: impl Fn(usize) -> f64) -> Vec<f64> {
        let square = |rows: &[BlockRow]| rows.iter().map(|row| row.map(|wave| wave * wave)).collect();
        let squared = Self { around: square(&self.around), along: square(&self.along), ..*self };
        let mut sums = vec![0.0; self.around_count * self.along_count];
        squared.project(value, &mut sums);
        sums
    }
}

#[inline]
fn product(a: &BlockRow, b: &BlockRow) -> f64 {
    let mut sums = [0.0; LANES];
    for (a, b) in a.chunks_exact(LANES).zip(b.chunks_exact(LANES)) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    sums.iter().sum()
}
