//! The map from the reference triangle to a straight or curved (quadratic) triangle.

use nalgebra::{Matrix2, Vector2};
use oilwedge_mesh::Mesh;

use crate::lagrange;

/// Geometry of one triangle: its map `x(xi, eta)` and the derivatives.
#[derive(Debug, Clone, Copy)]
pub enum Mapping {
    /// Straight edges: an affine map by three corners [m].
    Straight([[f64; 2]; 3]),
    /// Quadratic edges: an isoparametric map by six nodes [m].
    Curved([[f64; 2]; 6]),
}

/// The map at one reference point.
#[derive(Debug, Clone, Copy, Default)]
pub struct MappedPoint {
    /// Position on the developed surface [m].
    pub position: [f64; 2],
    /// Jacobian determinant [m2].
    pub determinant: f64,
    /// Inverse transposed Jacobian [1/m]: turns reference gradients into gradients on the surface.
    pub inverse_transposed: Matrix2<f64>,
}

impl MappedPoint {
    /// Gradient on the surface of a function with the given reference gradient.
    #[inline]
    pub fn gradient(&self, reference: [f64; 2]) -> [f64; 2] {
        (self.inverse_transposed * Vector2::from(reference)).into()
    }

    /// Direction in the reference triangle along which functions change as along `direction` on the surface.
    #[inline]
    pub fn reference_direction(&self, direction: [f64; 2]) -> [f64; 2] {
        self.inverse_transposed.tr_mul(&Vector2::from(direction)).into()
    }
}

impl Mapping {
    /// The map of triangle `t`.
    pub fn of(mesh: &Mesh, t: usize) -> Self {
        if mesh.is_curved(t) { Self::Curved(mesh.nodes(t)) } else { Self::Straight(mesh.corners(t)) }
    }

    /// Jacobian determinant [m2] at the reference point `(xi, eta)`.
    pub fn determinant(&self, point: [f64; 2]) -> f64 {
        match self {
            Self::Straight([a, b, c]) => (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]),
            Self::Curved(_) => self.at(point).determinant,
        }
    }

    /// Position [m] at the reference point `(xi, eta)`.
    pub fn position(&self, point: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Straight(corners) => position(&lagrange::barycentric(point), corners),
            Self::Curved(_) => self.at(point).position,
        }
    }

    /// Position and derivatives at the reference point `(xi, eta)`.
    pub fn at(&self, point: [f64; 2]) -> MappedPoint {
        match self {
            Self::Straight(corners) => place(&lagrange::barycentric(point), &lagrange::BARYCENTRIC_GRADIENTS, corners),
            Self::Curved(nodes) => {
                let mut values = [0.0; 6];
                let mut gradients = [[0.0; 2]; 6];
                lagrange::values(2, point, &mut values);
                lagrange::gradients(2, point, &mut gradients);
                place(&values, &gradients, nodes)
            }
        }
    }

    /// Sets the positions [m] at some reference points and the map there, which is the first of `places` alone where
    /// the triangle is straight; what is returned is how many places are set.
    pub(crate) fn all_at(&self, points: &[[f64; 2]], positions: &mut [[f64; 2]], places: &mut [MappedPoint]) -> usize {
        match self {
            Self::Straight(_) => {
                places[0] = self.at(points[0]);
                for (position, &point) in positions.iter_mut().zip(points) {
                    *position = self.position(point);
                }
                1
            }
            Self::Curved(_) => {
                for ((at, place), &point) in positions.iter_mut().zip(places).zip(points) {
                    *place = self.at(point);
                    *at = place.position;
                }
                points.len()
            }
        }
    }
}

fn position(values: &[f64], nodes: &[[f64; 2]]) -> [f64; 2] {
    let add = |at: Vector2<f64>, (&value, &node): (&f64, &[f64; 2])| at + value * Vector2::from(node);
    values.iter().zip(nodes).fold(Vector2::zeros(), add).into()
}

fn place(values: &[f64], gradients: &[[f64; 2]], nodes: &[[f64; 2]]) -> MappedPoint {
    // Row d, column k: d x_d / d xi_k.
    let mut jacobian = Matrix2::zeros();
    for (&gradient, &node) in gradients.iter().zip(nodes) {
        jacobian += Vector2::from(node) * Vector2::from(gradient).transpose();
    }
    let determinant = jacobian.determinant();
    // The cofactors are the inverse transposed times the determinant; meshes have no zero one.
    let cofactors = Matrix2::new(jacobian.m22, -jacobian.m21, -jacobian.m12, jacobian.m11);
    MappedPoint { position: position(values, nodes), determinant, inverse_transposed: cofactors / determinant }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curved_map_of_straight_nodes_is_the_straight_map() {
        let corners = [[0.1, 0.2], [1.3, 0.1], [0.4, 0.9]];
        let mid = |a: usize, b: usize| [0, 1].map(|d| 0.5 * (corners[a][d] + corners[b][d]));
        let nodes = [corners[0], corners[1], corners[2], mid(0, 1), mid(1, 2), mid(2, 0)];
        let (straight, curved) = (Mapping::Straight(corners).at([0.3, 0.2]), Mapping::Curved(nodes).at([0.3, 0.2]));
        assert!((straight.determinant - curved.determinant).abs() < 1e-15);
        for d in 0..2 {
            assert!((straight.position[d] - curved.position[d]).abs() < 1e-15);
            assert!((straight.gradient([0.7, -0.4])[d] - curved.gradient([0.7, -0.4])[d]).abs() < 1e-14);
        }
    }

    #[test]
    fn gradient_of_a_linear_function_is_its_slope() {
        let corners = [[0.1, 0.2], [1.3, 0.1], [0.4, 0.9]];
        let f = |x: [f64; 2]| 3.0 * x[0] - 2.0 * x[1];
        let place = Mapping::Straight(corners).at([0.5, 0.25]);
        let reference = [f(corners[1]) - f(corners[0]), f(corners[2]) - f(corners[0])];
        let gradient = place.gradient(reference);
        assert!((gradient[0] - 3.0).abs() < 1e-13 && (gradient[1] + 2.0).abs() < 1e-13);
    }
}
