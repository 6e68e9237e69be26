//! A function of a [`Space`]: values, gradients, and extrema of the polynomials themselves.

use crate::Space;
use crate::extrema;
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
    #[inline]
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
        let values = self.element_values(t);
        let gradient = self.gradient(&Mapping::of(self.space.mesh(), t), &values, point);
        (evaluate(self.space.degree(), &values, point), gradient)
    }

    /// Gradients on the surface [per m] at these reference points of triangle `t`, at most as many as the most nodes of
    /// a triangle.
    pub fn gradients(&self, t: usize, points: &[[f64; 2]]) -> [[f64; 2]; MOST_SHAPES] {
        let (mapping, values) = (Mapping::of(self.space.mesh(), t), self.element_values(t));
        let mut gradients = [[0.0; 2]; MOST_SHAPES];
        for (gradient, point) in gradients.iter_mut().zip(points) {
            *gradient = self.gradient(&mapping, &values, *point);
        }
        gradients
    }

    /// The gradient [per m] of the polynomial with these nodal values at the reference point of a triangle.
    fn gradient(&self, mapping: &Mapping, values: &[f64; MOST_SHAPES], point: [f64; 2]) -> [f64; 2] {
        let mut reference = [[0.0; 2]; MOST_SHAPES];
        lagrange::gradients(self.space.degree(), point, &mut reference[..self.space.shapes()]);
        let mut gradient = [0.0; 2];
        for (value, slope) in values.iter().zip(&reference[..self.space.shapes()]) {
            (0..2).for_each(|d| gradient[d] += value * slope[d]);
        }
        mapping.at(point).gradient(gradient)
    }

    /// The greatest value of the piecewise polynomial, between nodes too. Not a number if a coefficient is not.
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
        Extremum { value: -negative.value, ..negative }
    }

    fn extremum(&self, sign: f64, smooth: &dyn Fn(usize) -> bool) -> Extremum {
        let mut best = Extremum { value: f64::NEG_INFINITY, triangle: 0, point: [0.0; 2] };
        let degree = self.space.degree();
        let nodes = lagrange::nodes(degree);
        for t in 0..self.space.mesh().triangles().len() {
            let values = self.element_values(t).map(|value| sign * value);
            let bound = extrema::bound(degree, &values);
            if bound <= best.value && !values.iter().any(|value| value.is_nan()) {
                continue;
            }
            let mut offer = |value: f64, point: [f64; 2]| {
                if value > best.value || value.is_nan() {
                    best = Extremum { value, triangle: t, point };
                }
            };
            for (i, &node) in nodes.iter().enumerate() {
                offer(values[i], node);
            }
            if bound > best.value && smooth(t) {
                for point in extrema::candidates(degree, &values) {
                    let value = evaluate(degree, &values, point);
                    if value > best.value {
                        best = Extremum { value, triangle: t, point };
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

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_mesh::{Mesh, RawMesh};
    use std::sync::Arc;

    #[test]
    fn maximum_of_a_cubic_lies_between_the_nodes() {
        let raw = RawMesh {
            points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            ..RawMesh::default()
        };
        let space = Space::new(Arc::new(Mesh::build(raw).unwrap()), 3);
        for centre in [[0.7, 0.2], [0.3, 0.0], [0.31, 0.31], [0.05, 0.9]] {
            let u = |x: [f64; 2]| {
                let (a, b) = (x[0] - centre[0], x[1] - centre[1]);
                3.0 - a * a - 2.0 * b * b + 0.4 * a * b - 0.3 * a * a * a + 0.2 * a * b * b
            };
            let values = space.interpolate(u);
            let top = Field { space: &space, values: &values }.maximum();
            assert!((top.value - 3.0).abs() < 1e-13, "{centre:?}: {}", top.value);
            let bottom = Field { space: &space, values: &values }.minimum();
            let sampled = (0..=100).flat_map(|i| (0..=100).map(move |j| u([0.01 * f64::from(i), 0.01 * f64::from(j)])));
            assert!(bottom.value <= sampled.fold(f64::INFINITY, f64::min) + 1e-13);
        }
    }

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
            let field = Field { space: &space, values: &values };
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
