//! Inverses of matrices as large as a film has points across.

/// Rows of the largest matrix.
pub(crate) const LARGEST: usize = 9;

/// Replaces a square matrix of `n` rows by its inverse, by Gauss-Jordan elimination with row exchange; `false` where
/// it has none.
pub(crate) fn invert(matrix: &mut [f64], n: usize) -> bool {
    let mut exchanged = [0; LARGEST];
    for step in 0..n {
        let mut pivot = step;
        for row in step + 1..n {
            if matrix[row * n + step].abs() > matrix[pivot * n + step].abs() {
                pivot = row;
            }
        }
        exchanged[step] = pivot;
        for column in 0..n {
            matrix.swap(step * n + column, pivot * n + column);
        }
        let scale = 1.0 / matrix[step * n + step];
        if !scale.is_finite() {
            return false;
        }
        matrix[step * n + step] = 1.0;
        for column in 0..n {
            matrix[step * n + column] *= scale;
        }
        for row in 0..n {
            if row != step {
                let factor = matrix[row * n + step];
                matrix[row * n + step] = 0.0;
                for column in 0..n {
                    matrix[row * n + column] -= factor * matrix[step * n + column];
                }
            }
        }
    }
    for step in (0..n).rev() {
        for row in 0..n {
            matrix.swap(row * n + step, row * n + exchanged[step]);
        }
    }
    true
}

#[cfg(test)]
mod tests {
    #[test]
    fn inverse_of_a_matrix_whose_first_pivot_is_zero() {
        let matrix = [0.0, 2.0, 1.0, 1.0, 1.0, 0.0, 3.0, 0.0, 1.0];
        let mut inverse = matrix;
        assert!(super::invert(&mut inverse, 3));
        for i in 0..3 {
            for j in 0..3 {
                let product: f64 = (0..3).map(|k| matrix[i * 3 + k] * inverse[k * 3 + j]).sum();
                assert!((product - f64::from(i == j)).abs() < 1e-14);
            }
        }
        assert!(!super::invert(&mut [0.0; 4], 2));
    }
}
