//! Square matrices of a few hundred rows, all entries kept, and their factors.

/// A square matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    order: usize,
    entries: Vec<f64>,
}

/// The factors `P A = L U` of a matrix.
#[derive(Debug, Clone)]
pub struct Factors {
    order: usize,
    entries: Vec<f64>,
    rows: Vec<usize>,
}

impl Matrix {
    /// The matrix of zeros with this many rows.
    pub fn zeros(order: usize) -> Self {
        Self {
            order,
            entries: vec![0.0; order * order],
        }
    }

    /// Number of rows, and of columns.
    pub fn order(&self) -> usize {
        self.order
    }

    /// The entry of a row and a column.
    pub fn at(&self, row: usize, column: usize) -> f64 {
        self.entries[row * self.order + column]
    }

    /// Adds to the entry of a row and a column.
    pub fn add(&mut self, row: usize, column: usize, more: f64) {
        self.entries[row * self.order + column] += more;
    }

    /// The matrix times a number.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        self.entries.iter_mut().for_each(|entry| *entry *= factor);
        self
    }

    /// The rows and columns of these numbers.
    pub fn part(&self, rows: &[usize], columns: &[usize]) -> Vec<Vec<f64>> {
        let row = |&row: &usize| columns.iter().map(|&column| self.at(row, column)).collect();
        rows.iter().map(row).collect()
    }

    /// The square matrix of the rows and columns of these numbers.
    #[must_use]
    pub fn of_numbers(&self, numbers: &[usize]) -> Self {
        Self {
            order: numbers.len(),
            entries: self.part(numbers, numbers).concat(),
        }
    }

    /// The product with a vector.
    pub fn times(&self, vector: &[f64]) -> Vec<f64> {
        let rows = self.entries.chunks_exact(self.order.max(1));
        rows.map(|row| product(row, vector)).collect()
    }

    /// The factors by elimination with row pivots; `None` where a pivot vanishes or is no number.
    pub fn factors(&self) -> Option<Factors> {
        let n = self.order;
        let mut entries = self.entries.clone();
        let mut rows: Vec<usize> = (0..n).collect();
        for k in 0..n {
            let size = |row: usize| entries[row * n + k].abs();
            let pivot = (k..n).fold(k, |best, row| if size(row) > size(best) { row } else { best });
            if !(size(pivot) > 0.0 && size(pivot).is_finite()) {
                return None;
            }
            if pivot != k {
                rows.swap(k, pivot);
                (0..n).for_each(|column| entries.swap(k * n + column, pivot * n + column));
            }
            let (above, below) = entries.split_at_mut((k + 1) * n);
            let upper = &above[k * n..];
            for row in below.chunks_exact_mut(n) {
                let factor = row[k] / upper[k];
                row[k] = factor;
                if factor != 0.0 {
                    for (entry, upper) in row[k + 1..].iter_mut().zip(&upper[k + 1..]) {
                        *entry -= factor * upper;
                    }
                }
            }
        }
        Some(Factors {
            order: n,
            entries,
            rows,
        })
    }
}

impl Factors {
    /// The vector whose product with the matrix is `wanted`.
    pub fn solve(&self, wanted: &[f64]) -> Vec<f64> {
        let n = self.order;
        let mut x: Vec<f64> = self.rows.iter().map(|&row| wanted[row]).collect();
        for row in 0..n {
            let (known, rest) = x.split_at_mut(row);
            rest[0] -= product(&self.entries[row * n..row * n + row], known);
        }
        for row in (0..n).rev() {
            let (head, known) = x.split_at_mut(row + 1);
            let upper = &self.entries[row * n..(row + 1) * n];
            head[row] = (head[row] - product(&upper[row + 1..], known)) / upper[row];
        }
        x
    }
}

/// `sum_k a_k b_k`.
pub(super) fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: &[[f64; 3]; 3]) -> Matrix {
        let mut matrix = Matrix::zeros(3);
        for (i, row) in rows.iter().enumerate() {
            row.iter().enumerate().for_each(|(j, entry)| matrix.add(i, j, *entry));
        }
        matrix
    }

    #[test]
    fn what_is_solved_gives_the_vector_back() {
        let needs_pivots = matrix(&[[0.0, 2.0, 1.0], [3.0, 0.0, 0.5], [1.0, -1.0, 0.0]]);
        let wanted = [1.0, -2.0, 0.7];
        let found = needs_pivots.factors().expect("it has an inverse").solve(&wanted);
        let back = needs_pivots.times(&found);
        assert!(back.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-15), "{back:?}");
    }

    #[test]
    fn a_singular_matrix_has_no_factors() {
        assert!(
            matrix(&[[1.0, 2.0, 0.0], [2.0, 4.0, 0.0], [0.0, 0.0, 1.0]])
                .factors()
                .is_none()
        );
    }
}
