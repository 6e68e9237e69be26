//! Generalised minimal residuals for a preconditioned system.
//!
//! Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856; modified Gram-Schmidt, Givens rotations.

/// Adds to `x` the combination of a Krylov space that makes `residual - A dx` least, until its norm is `target`.
/// Operator and residual are preconditioned. The answer is the number of steps, at most `most`.
pub(crate) fn gmres(
    mut operator: impl FnMut(&[f64], &mut [f64]),
    residual: &[f64],
    target: f64,
    most: usize,
    x: &mut [f64],
) -> usize {
    let size = norm(residual);
    if size <= target {
        return 0;
    }
    let mut basis = vec![residual.iter().map(|r| r / size).collect::<Vec<f64>>()];
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut rotations: Vec<[f64; 2]> = Vec::new();
    let mut right = vec![size];
    for step in 0..most {
        let mut next = vec![0.0; residual.len()];
        operator(&basis[step], &mut next);
        let mut column = Vec::with_capacity(step + 2);
        for vector in &basis {
            let along = dot(vector, &next);
            next.iter_mut().zip(vector).for_each(|(a, b)| *a -= along * b);
            column.push(along);
        }
        let length = norm(&next);
        for (k, [cosine, sine]) in rotations.iter().enumerate() {
            let (a, b) = (column[k], column[k + 1]);
            (column[k], column[k + 1]) = (cosine * a + sine * b, cosine * b - sine * a);
        }
        let size = column[step].hypot(length);
        let [cosine, sine] = [column[step] / size, length / size];
        column[step] = size;
        rotations.push([cosine, sine]);
        columns.push(column);
        right.push(-sine * right[step]);
        right[step] *= cosine;
        if right[step + 1].abs() <= target || step + 1 == most {
            break;
        }
        next.iter_mut().for_each(|entry| *entry /= length);
        basis.push(next);
    }
    let steps = columns.len();
    for k in (0..steps).rev() {
        let above: f64 = (k + 1..steps).map(|j| columns[j][k] * right[j]).sum();
        right[k] = (right[k] - above) / columns[k][k];
    }
    for (vector, factor) in basis.iter().zip(&right[..steps]) {
        x.iter_mut().zip(vector).for_each(|(x, v)| *x += factor * v);
    }
    steps
}

/// Euclidean norm.
pub(crate) fn norm(vector: &[f64]) -> f64 {
    dot(vector, vector).sqrt()
}

/// Lanes of a sum, by which the compiler adds several products at a time.
const LANES: usize = 8;

fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (of_a, of_b) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest: f64 = of_a.remainder().iter().zip(of_b.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in of_a.zip(of_b) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    sums.iter().sum::<f64>() + rest
}
