//! The method of generalised minimal residuals (Saad, Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856), without restarts.

/// Most products with the operator.
const MOST_STEPS: usize = 400;

/// A solution, and how many products with the operator it took.
pub(super) struct Solved {
    pub(super) x: Vec<f64>,
    pub(super) steps: usize,
}

/// Solves `A x = b` until the residual is below `accuracy` of b, or no further product helps; `nearly` solves a system much like it.
///
/// # Errors
/// Those of the operator.
pub(super) fn gmres<E>(
    operator: impl Fn(&[f64]) -> Result<Vec<f64>, E>,
    nearly: impl Fn(&[f64]) -> Vec<f64>,
    b: &[f64],
    accuracy: f64,
) -> Result<Solved, E> {
    let size = norm(b);
    let mut basis: Vec<Vec<f64>> = vec![b.iter().map(|b| b / size).collect()];
    // Columns of the triangular factor, the rotations that made it, and the right-hand side turned by them.
    let (mut triangle, mut rotations, mut turned) = (Vec::<Vec<f64>>::new(), Vec::<[f64; 2]>::new(), vec![size]);
    if size == 0.0 || !size.is_finite() {
        return Ok(Solved {
            x: b.to_vec(),
            steps: 0,
        });
    }
    for k in 0..MOST_STEPS {
        let mut next = operator(&nearly(&basis[k]))?;
        let mut column = orthogonalised(&mut next, &basis);
        let left = norm(&next);
        for (i, [cos, sin]) in rotations.iter().enumerate() {
            let [a, b] = [column[i], column[i + 1]];
            (column[i], column[i + 1]) = (cos * a + sin * b, cos * b - sin * a);
        }
        let length = column[k].hypot(left);
        let [cos, sin] = [column[k] / length, left / length];
        column[k] = length;
        rotations.push([cos, sin]);
        let last = turned[k];
        turned[k] = cos * last;
        turned.push(-sin * last);
        triangle.push(column);
        if (sin * last).abs() <= accuracy * size || left == 0.0 || !length.is_finite() {
            break;
        }
        basis.push(next.iter().map(|x| x / left).collect());
    }
    Ok(Solved {
        x: nearly(&combined(&triangle, &turned, &basis)),
        steps: triangle.len(),
    })
}

/// Makes `next` orthogonal to the basis, by Gram and Schmidt twice; its parts along the basis, and room for one more.
fn orthogonalised(next: &mut [f64], basis: &[Vec<f64>]) -> Vec<f64> {
    let mut column = vec![0.0; basis.len() + 1];
    for _ in 0..2 {
        for (part, base) in column.iter_mut().zip(basis) {
            let along: f64 = next.iter().zip(base).map(|(a, b)| a * b).sum();
            next.iter_mut().zip(base).for_each(|(a, b)| *a -= along * b);
            *part += along;
        }
    }
    column
}

/// The combination of the basis with the least residual.
fn combined(triangle: &[Vec<f64>], turned: &[f64], basis: &[Vec<f64>]) -> Vec<f64> {
    let n = triangle.len();
    let mut weights = vec![0.0; n];
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| triangle[j][i] * weights[j]).sum();
        weights[i] = (turned[i] - known) / triangle[i][i];
    }
    let mut x = vec![0.0; basis[0].len()];
    for (weight, base) in weights.iter().zip(basis) {
        x.iter_mut().zip(base).for_each(|(x, b)| *x += weight * b);
    }
    x
}

/// Euclidean norm.
pub(super) fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::convert::Infallible;

    /// An unsymmetric matrix of order 40.
    fn times(x: &[f64]) -> Vec<f64> {
        let n = x.len();
        let before = |i: usize| if i > 0 { 0.7 * x[i - 1] } else { 0.0 };
        let behind = |i: usize| if i + 3 < n { -0.4 * x[i + 3] } else { 0.0 };
        (0..n)
            .map(|i| (2.0 + i as f64) * x[i] + before(i) + behind(i))
            .collect()
    }

    #[test]
    fn systems_are_solved_as_exactly_as_asked() {
        let b: Vec<f64> = (0..40).map(|i| (1.3 * f64::from(i)).cos()).collect();
        let mut before = 0;
        for accuracy in [1e-2, 1e-6, 1e-12] {
            let Ok(Solved { x, steps }) = gmres(|x| Ok::<_, Infallible>(times(x)), <[f64]>::to_vec, &b, accuracy);
            let residual: Vec<f64> = times(&x).iter().zip(&b).map(|(a, b)| a - b).collect();
            assert!(norm(&residual) < 1.5 * accuracy * norm(&b), "{accuracy:e}");
            assert!(steps > before && steps <= 40, "{steps}");
            before = steps;
        }
    }

    #[test]
    fn a_system_much_like_it_saves_products() {
        let b: Vec<f64> = (0..40).map(|i| (1.3 * f64::from(i)).cos()).collect();
        let of_diagonal = |r: &[f64]| r.iter().enumerate().map(|(i, r)| r / (2.0 + i as f64)).collect();
        let Ok(plain) = gmres(|x| Ok::<_, Infallible>(times(x)), <[f64]>::to_vec, &b, 1e-10);
        let Ok(Solved { x, steps }) = gmres(|x| Ok::<_, Infallible>(times(x)), of_diagonal, &b, 1e-10);
        let residual: Vec<f64> = times(&x).iter().zip(&b).map(|(a, b)| a - b).collect();
        assert!(norm(&residual) < 1.5e-10 * norm(&b));
        assert!(2 * steps < plain.steps, "{steps} {}", plain.steps);
    }

    #[test]
    fn nothing_gives_nothing_and_errors_pass() {
        let Ok(nothing) = gmres(|x| Ok::<_, Infallible>(times(x)), <[f64]>::to_vec, &[0.0; 5], 1e-6);
        assert_eq!((nothing.x, nothing.steps), (vec![0.0; 5], 0));
        assert!(gmres(|_| Err("no"), <[f64]>::to_vec, &[1.0; 5], 1e-6).is_err());
    }
}
