//! A function of a [`Space`]: values, gradients, and extrema of the polynomials themselves.

use crate::Space;
use crate::lagrange::{self, MOST_SHAPES};
use crate::mapping::Mapping;

/// Coefficients (nodal values) on a space.
#[derive(Debug, Clone, Copy)]
pub struct Field<'a> {
    /// The space.
    pub space: &'a Space,
    /// One value a dof.
    pub values: &'a [f64],
}

/// A value of a field and where it is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremum {
    /// The value.
    pub value: f64,
    /// Triangle.
    pub triangle: usize,
    /// Reference coordinates in it.
    pub point: [f64; 2],
}

impl Field<'_> {
    /// Nodal values of triangle `t` in local order.
    pub fn element_values(&self, t: usize) -> [f64; MOST_SHAPES] {
        let dofs = self.space.element_dofs(t);
        let mut values = [0.0; MOST_SHAPES];
        for i in 0..self.space.shapes() {
            values[i] = self.values[dofs[i]];
        }
        values
    }

    /// Value at the reference point of triangle `t`.
    pub fn value(&self, t: usize, point: [f64; 2]) -> f64 {
        evaluate(self.space.degree(), &self.element_values(t), point)
    }

    /// Value and gradient on the surface [per m] at the reference point of triangle `t`.
    pub fn value_and_gradient(&self, t: usize, point: [f64; 2]) -> (f64, [f64; 2]) {
        let mut reference = [[0.0; 2]; MOST_SHAPES];
        lagrange::gradients(self.space.degree(), point, &mut reference[..self.space.shapes()]);
        let values = self.element_values(t);
        let mut gradient = [0.0; 2];
        for i in 0..self.space.shapes() {
            for d in 0..2 {
                gradient[d] += values[i] * reference[i][d];
            }
        }
        let place = Mapping::of(self.space.mesh(), t).at(point);
        (self.value(t, point), place.gradient(gradient))
    }

    /// The greatest value of the piecewise polynomial, between nodes too. Exact for degree 1 and 2;
    /// of a cubic only the nodes count. Not a number if a coefficient is not.
    pub fn maximum(&self) -> Extremum {
        self.extremum(1.0, &|_| true)
    }

    /// The greatest value of the polynomials of triangles that are `smooth`, and of nodes elsewhere.
    pub fn maximum_where(&self, smooth: &dyn Fn(usize) -> bool) -> Extremum {
        self.extremum(1.0, smooth)
    }

    /// The least value, likewise.
    pub fn minimum(&self) -> Extremum {
        let negative = self.extremum(-1.0, &|_| true);
        Extremum {
            value: -negative.value,
            ..negative
        }
    }

    fn extremum(&self, sign: f64, smooth: &dyn Fn(usize) -> bool) -> Extremum {
        let mut best = Extremum {
            value: f64::NEG_INFINITY,
            triangle: 0,
            point: [0.0; 2],
        };
        let nodes = lagrange::nodes(self.space.degree());
        for t in 0..self.space.mesh().triangles().len() {
            let values = self.element_values(t).map(|value| sign * value);
            let mut offer = |value: f64, point: [f64; 2]| {
                if value > best.value || value.is_nan() {
                    best = Extremum {
                        value,
                        triangle: t,
                        point,
                    };
                }
            };
            for (i, &node) in nodes.iter().enumerate() {
                offer(values[i], node);
            }
            if self.space.degree() == 2 && quadratic_bound(&values) > best.value && smooth(t) {
                for point in quadratic_candidates(&values) {
                    let value = evaluate(2, &values, point);
                    if value > best.value {
                        best = Extremum {
                            value,
                            triangle: t,
                            point,
                        };
                    }
                }
            }
        }
        best
    }
}

/// Value of the element polynomial with the given nodal values.
pub fn evaluate(degree: usize, nodal: &[f64; MOST_SHAPES], point: [f64; 2]) -> f64 {
    let mut shapes = [0.0; MOST_SHAPES];
    let n = lagrange::shapes(degree);
    lagrange::values(degree, point, &mut shapes[..n]);
    (0..n).map(|i| nodal[i] * shapes[i]).sum()
}

/// An upper bound of a quadratic over its triangle: the greatest Bernstein coefficient.
fn quadratic_bound(nodal: &[f64; MOST_SHAPES]) -> f64 {
    (0..3)
        .map(|k| nodal[k].max(2.0 * nodal[3 + k] - 0.5 * (nodal[k] + nodal[(k + 1) % 3])))
        .fold(f64::NEG_INFINITY, f64::max)
}

/// Where a quadratic may have its maximum besides the nodes: its stationary points on the edges
/// and inside the triangle.
fn quadratic_candidates(nodal: &[f64; MOST_SHAPES]) -> Vec<[f64; 2]> {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let mut candidates = Vec::with_capacity(4);
    for k in 0..3 {
        // On the edge u(s) = u_a + (4 u_m - 3 u_a - u_b) s + 2 (u_a + u_b - 2 u_m) s^2.
        let (a, b, m) = (nodal[k], nodal[(k + 1) % 3], nodal[3 + k]);
        let s = (4.0 * m - 3.0 * a - b) / (-4.0 * (a + b - 2.0 * m));
        if s > 0.0 && s < 1.0 {
            let (from, to) = (corners[k], corners[(k + 1) % 3]);
            candidates.push([from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])]);
        }
    }
    // Inside, grad u = g + H (xi, eta) = 0 with the constant Hessian H.
    let [u0, u1, u2, u01, u12, u20] = [nodal[0], nodal[1], nodal[2], nodal[3], nodal[4], nodal[5]];
    let g = [4.0 * u01 - 3.0 * u0 - u1, 4.0 * u20 - 3.0 * u0 - u2];
    let h = [
        4.0 * (u0 + u1 - 2.0 * u01),
        4.0 * (u0 + u12 - u01 - u20),
        4.0 * (u0 + u2 - 2.0 * u20),
    ];
    let determinant = h[0] * h[2] - h[1] * h[1];
    let inside = [
        (-g[0] * h[2] + g[1] * h[1]) / determinant,
        (-g[1] * h[0] + g[0] * h[1]) / determinant,
    ];
    if inside[0] > 0.0 && inside[1] > 0.0 && inside[0] + inside[1] < 1.0 {
        candidates.push(inside);
    }
    candidates
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_mesh::{Mesh, RawMesh};
    use std::sync::Arc;

    #[test]
    fn maximum_of_a_paraboloid_lies_between_the_nodes() {
        let raw = RawMesh {
            points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            ..RawMesh::default()
        };
        let space = Space::new(Arc::new(Mesh::build(raw).unwrap()), 2);
        for centre in [[0.7, 0.2], [0.3, 0.0], [0.31, 0.31]] {
            let u = |x: [f64; 2]| 3.0 - (x[0] - centre[0]).powi(2) - 2.0 * (x[1] - centre[1]).powi(2);
            let values = space.interpolate(u);
            let field = Field {
                space: &space,
                values: &values,
            };
            let top = field.maximum();
            assert!((top.value - 3.0).abs() < 1e-14);
            let place = Mapping::of(space.mesh(), top.triangle).at(top.point).position;
            assert!((place[0] - centre[0]).abs() < 1e-7 && (place[1] - centre[1]).abs() < 1e-7);
            let (value, gradient) = field.value_and_gradient(0, [0.2, 0.3]);
            let at = Mapping::of(space.mesh(), 0).at([0.2, 0.3]).position;
            assert!((value - u(at)).abs() < 1e-14);
            assert!((gradient[1] + 4.0 * (at[1] - centre[1])).abs() < 1e-13);
        }
    }
}
