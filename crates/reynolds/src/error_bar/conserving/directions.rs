//! Directions of force and moment in which a film errs independently.
//!
//! **Equation.** With w the weights of a pressure in the forces (W_x, W_y, m_x/l, m_y/l), l half of the bearing's length, and d as in [`super`],
//! ```text
//! C = Int d w w^T dA,    C f_j = lambda_j f_j,    bar_j = bar of Int p (f_j . w) dA
//! ```
//! A film that errs at one place, as a thin one at an end does, errs in one direction: the others have small bars. Bars of two forces and two moments would lose that. In that direction such a film is
//! stiff, so that the position of the journal is known far better than the force.
//!
//! **Source.** Jacobi's method for eigenvectors: Golub and Van Loan, Matrix Computations, section 8.5. **Verified by** `eigenvectors_are_those_of_the_matrix`.

use super::{Pair, Weights};
use crate::error_bar::Bar;

/// A direction of force and moment, and how far the film errs there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorDirection {
    /// Forces towards x and y, and moments over half of the bearing's length, of length one.
    pub direction: [f64; 4],
    /// Bar of the force in that direction [N].
    pub bar: Bar,
}

/// The four directions of a pair, `arm` [m] half of the bearing's length; `bar` sums up the shares of triangles. Those of the forces and moments themselves where differences are not finite.
pub(super) fn directions(pair: &Pair, arm: f64, bar: impl Fn(&[Bar]) -> Bar) -> Vec<ErrorDirection> {
    let forces = |at: Weights| [at.force[0], at.force[1], at.moment[0] / arm, at.moment[1] / arm];
    let mesh = pair.system.space().mesh();
    let mut sum = [[0.0; 4]; 4];
    for (t, corners) in mesh.triangles().iter().enumerate() {
        let area = pair.area(t);
        for &vertex in corners {
            let weights = forces(pair.weights(mesh.points()[vertex as usize]));
            let factor = area / 3.0 * pair.difference[vertex as usize];
            for (row, a) in sum.iter_mut().zip(weights) {
                row.iter_mut()
                    .zip(weights)
                    .for_each(|(entry, b)| *entry += factor * a * b);
            }
        }
    }
    let vectors = match sum.as_flattened().iter().all(|entry| entry.is_finite()) {
        true => eigenvectors(sum),
        false => UNIT,
    };
    let of = |direction: [f64; 4]| ErrorDirection {
        direction,
        bar: bar(&pair.shares(|at| direction.iter().zip(forces(at)).map(|(a, b)| a * b).sum())),
    };
    vectors.map(of).into()
}

/// The unit vectors.
const UNIT: [[f64; 4]; 4] = [
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
];

/// Sweeps of rotations: their number of right digits doubles with each.
const SWEEPS: usize = 10;

/// The eigenvectors of a symmetric matrix, of length one.
fn eigenvectors(mut matrix: [[f64; 4]; 4]) -> [[f64; 4]; 4] {
    let mut vectors = UNIT;
    let pairs = (0..4).flat_map(|p| (p + 1..4).map(move |q| (p, q)));
    for (p, q) in std::iter::repeat_n(pairs, SWEEPS).flatten() {
        if matrix[p][q] == 0.0 {
            continue;
        }
        let cot = (matrix[q][q] - matrix[p][p]) / (2.0 * matrix[p][q]);
        let tan = cot.signum() / (cot.abs() + cot.hypot(1.0));
        let cos = tan.hypot(1.0).recip();
        let turned = |[a, b]: [f64; 2]| [cos * (a - tan * b), cos * (tan * a + b)];
        for row in &mut matrix {
            [row[p], row[q]] = turned([row[p], row[q]]);
        }
        for k in 0..4 {
            [matrix[p][k], matrix[q][k]] = turned([matrix[p][k], matrix[q][k]]);
            [vectors[p][k], vectors[q][k]] = turned([vectors[p][k], vectors[q][k]]);
        }
    }
    vectors
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvectors_are_those_of_the_matrix() {
        // Two directions far apart in size, and two of the same size.
        let matrix = [
            [4.0, 1e6, 0.0, 2.0],
            [1e6, -3.0, 0.5, 0.0],
            [0.0, 0.5, 2.0, 1.0],
            [2.0, 0.0, 1.0, 2.0],
        ];
        let times = |v: [f64; 4]| matrix.map(|row: [f64; 4]| row.iter().zip(v).map(|(a, b)| a * b).sum::<f64>());
        let dot = |a: [f64; 4], b: [f64; 4]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let vectors = eigenvectors(matrix);
        for (i, a) in vectors.into_iter().enumerate() {
            for (j, b) in vectors.into_iter().enumerate() {
                assert!((dot(a, b) - f64::from(u8::from(i == j))).abs() < 1e-14);
                assert!(
                    i == j || dot(a, times(b)).abs() < 1e-9,
                    "{i} {j}: {:e}",
                    dot(a, times(b))
                );
            }
        }
        assert_eq!(eigenvectors(UNIT), UNIT);
    }
}
