//! Directions of force and moment in which a film errs independently.
//!
//! **Equation.** With w the weights of a pressure in the forces (W_x, W_y, m_x/l, m_y/l), l half of the bearing's
//! length, and d as in [`super`],
//! ```text
//! C = Int d w w^T dA,    C f_j = lambda_j f_j,    bar_j = bar of Int p (f_j . w) dA
//! ```
//! A film that errs at one place, as a thin one at an end does, errs in one direction: the others have small bars. Bars
//! of two forces and two moments would lose that. In that direction such a film is stiff, so that the position of the
//! journal is known far better than the force.

use nalgebra::{Matrix4, SymmetricEigen, Vector4};

use super::{FilmPair, Weights};
use crate::error_bar::Bar;

/// A direction of force and moment, and how far the film errs there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorDirection {
    /// Forces towards x and y, and moments over half of the bearing's length, of length one.
    pub direction: [f64; 4],
    /// Bar of the force in that direction [N].
    pub bar: Bar,
}

/// The four directions of a pair, `arm` [m] half of the bearing's length; `bar` sums up the shares of triangles. Those
/// of the forces and moments themselves where differences are not finite.
pub(super) fn directions(pair: &FilmPair, arm: f64, bar: impl Fn(&[Bar]) -> Bar) -> Vec<ErrorDirection> {
    let forces = |at: Weights| Vector4::new(at.force[0], at.force[1], at.moment[0] / arm, at.moment[1] / arm);
    let mesh = pair.film.system.space().mesh();
    let mut sum = Matrix4::zeros();
    for (t, corners) in mesh.triangles().iter().enumerate() {
        let area = pair.area(t);
        for &vertex in corners {
            let weights = forces(pair.weights(mesh.points()[vertex as usize]));
            sum += area / 3.0 * pair.difference[vertex as usize] * weights * weights.transpose();
        }
    }
    let vectors = match sum.iter().all(|entry| entry.is_finite()) {
        true => SymmetricEigen::new(sum).eigenvectors,
        false => Matrix4::identity(),
    };
    let of = |direction: Vector4<f64>| ErrorDirection {
        direction: direction.into(),
        bar: bar(&pair.shares(|at| direction.dot(&forces(at)))),
    };
    vectors.column_iter().map(|column| of(column.into())).collect()
}
