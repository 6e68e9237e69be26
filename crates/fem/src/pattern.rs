//! The entries of a sparse square matrix.

/// Rows of a pattern: the columns of row `i` are `columns[row_start[i]..row_start[i + 1]]`, in any order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pattern {
    /// Entries of row `i` are `row_start[i]..row_start[i + 1]`.
    pub row_start: Vec<u32>,
    /// Column of each entry.
    pub columns: Vec<u32>,
}

impl Pattern {
    /// Number of rows.
    pub fn dimension(&self) -> usize {
        self.row_start.len() - 1
    }

    /// Entries of row `i`.
    pub fn row(&self, i: usize) -> std::ops::Range<usize> {
        self.row_start[i] as usize..self.row_start[i + 1] as usize
    }
}
