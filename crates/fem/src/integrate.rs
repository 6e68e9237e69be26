//! Integrals over triangles and edges: the quadrature of everything that is not assembled.
//!
//! A [`Rule`] visits the points of one triangle in batches of at most [`MOST_POINTS`]; [`integrate`] sums over the
//! triangles of a mesh; [`edge_points`] are the points of a straight or quadratic edge. Verified by
//! `areas_and_moments_of_a_curved_mesh`.

use std::ops::{AddAssign, Range};

use oilwedge_mesh::Mesh;
use rayon::prelude::*;

use crate::in_order;
use crate::lagrange::{self, MOST_SHAPES};
use crate::mapping::{MappedPoint, Mapping};
use crate::quadrature::{MOST_POINTS, Quadrature, gauss_interval};

/// Triangles that one task sums; fixed, so that the number of threads does not change a bit.
const CELLS_A_TASK: usize = 2048;

/// Shape functions of quadratic and of cubic elements.
const QUADRATIC: usize = 6;
const CUBIC: usize = 10;

/// Values at the nodes of one triangle, in local order.
pub type Nodal = [f64; MOST_SHAPES];

/// A quadrature rule with the shape functions at its points.
#[derive(Debug, Clone)]
pub struct Rule {
    quadrature: Quadrature,
    /// Shape functions of a triangle.
    shapes: usize,
    values: Vec<Nodal>,
    gradients: Vec<[[f64; 2]; MOST_SHAPES]>,
}

/// A batch of points of one triangle.
pub struct Points<'a> {
    /// The triangle.
    pub cell: usize,
    /// Positions on the developed surface [m].
    pub positions: &'a [[f64; 2]],
    /// The map at each point, or one for all points of a straight triangle.
    places: &'a [MappedPoint],
    weights: &'a [f64],
    values: &'a [Nodal],
    gradients: &'a [[[f64; 2]; MOST_SHAPES]],
    shapes: usize,
}

impl Rule {
    /// The rule for elements of this polynomial degree.
    pub fn for_degree(degree: usize) -> Self {
        Self::new(Quadrature::for_degree(degree), degree)
    }

    /// A rule with the shape functions of elements of degree `degree`.
    pub fn new(quadrature: Quadrature, degree: usize) -> Self {
        let gradients = quadrature.points.iter().map(|&point| {
            let mut gradients = [[0.0; 2]; MOST_SHAPES];
            lagrange::gradients(degree, point, &mut gradients[..lagrange::shapes(degree)]);
            gradients
        });
        Self {
            values: lagrange::tabulated(degree, &quadrature.points),
            gradients: gradients.collect(),
            shapes: lagrange::shapes(degree),
            quadrature,
        }
    }

    /// Barycentric coordinates of point `q`.
    #[inline]
    pub fn barycentric(&self, q: usize) -> [f64; 3] {
        lagrange::barycentric(self.quadrature.points[q])
    }

    /// Values of the shape functions at point `q`.
    #[inline]
    pub fn shapes(&self, q: usize) -> &Nodal {
        &self.values[q]
    }

    /// Value at point `q` of the function with the given nodal values.
    #[inline]
    pub fn value(&self, q: usize, nodal: &Nodal) -> f64 {
        value(&self.values[q], self.shapes, nodal)
    }

    /// Gradient [1/m] of shape function `i` at point `q`, which lies at `place` in a triangle.
    #[inline]
    pub fn gradient(&self, q: usize, i: usize, place: &MappedPoint) -> [f64; 2] {
        place.gradient(self.gradients[q][i])
    }

    /// Number of its points.
    pub(crate) fn points(&self) -> usize {
        self.quadrature.points.len()
    }

    /// Calls `visit` with every batch of points of triangle `t`.
    pub fn visit(&self, mesh: &Mesh, t: usize, mut visit: impl FnMut(&Points)) {
        let mapping = Mapping::of(mesh, t);
        for first in (0..self.points()).step_by(MOST_POINTS) {
            self.visit_batch(&mapping, t, first..(first + MOST_POINTS).min(self.points()), &mut visit);
        }
    }

    /// Calls `visit` with a batch of at most [`MOST_POINTS`] points of triangle `t`, which has this `mapping`.
    pub(crate) fn visit_batch(&self, mapping: &Mapping, t: usize, batch: Range<usize>, mut visit: impl FnMut(&Points)) {
        let Quadrature { points, weights, .. } = &self.quadrature;
        let (mut positions, mut places) = ([[0.0; 2]; MOST_POINTS], [MappedPoint::default(); MOST_POINTS]);
        let set = mapping.all_at(&points[batch.clone()], &mut positions[..batch.len()], &mut places);
        visit(&Points {
            cell: t,
            positions: &positions[..batch.len()],
            places: &places[..set],
            weights: &weights[batch.clone()],
            values: &self.values[batch.clone()],
            gradients: &self.gradients[batch],
            shapes: self.shapes,
        });
    }

    /// The integral over triangle `t`, to which `add` adds the contributions of a batch of points.
    pub fn integrate<T: Default>(&self, mesh: &Mesh, t: usize, mut add: impl FnMut(&Points, &mut T)) -> T {
        let mut sum = T::default();
        self.visit(mesh, t, |points| add(points, &mut sum));
        sum
    }
}

impl Points<'_> {
    /// The map of the triangle at point `q`, but for the position.
    #[inline]
    pub fn place(&self, q: usize) -> &MappedPoint {
        match self.places {
            [one] => one,
            each => &each[q],
        }
    }

    /// Weight times Jacobian determinant [m2] of point `q`.
    #[inline]
    pub fn area(&self, q: usize) -> f64 {
        self.weights[q] * self.place(q).determinant
    }

    /// Value at point `q` of the function with the given nodal values.
    #[inline]
    pub fn value(&self, q: usize, nodal: &Nodal) -> f64 {
        value(&self.values[q], self.shapes, nodal)
    }

    /// Gradient [per m] at point `q` of the function with the given nodal values.
    #[inline]
    pub fn gradient(&self, q: usize, nodal: &Nodal) -> [f64; 2] {
        let add = |[x, y]: [f64; 2], (g, u): (&[f64; 2], &f64)| [x + u * g[0], y + u * g[1]];
        let reference = match self.shapes {
            QUADRATIC => (self.gradients[q][..QUADRATIC].iter().zip(nodal)).fold([0.0; 2], add),
            shapes => (self.gradients[q][..shapes].iter().zip(nodal)).fold([0.0; 2], add),
        };
        self.place(q).gradient(reference)
    }

    /// Values of the shape functions at point `q`.
    pub fn shapes(&self, q: usize) -> &Nodal {
        &self.values[q]
    }

    /// Adds to each entry the slope [1/m] of its shape function along `direction` at point `q`.
    #[inline]
    pub fn add_slopes(&self, q: usize, direction: [f64; 2], entries: &mut Nodal) {
        let [along_xi, along_eta] = self.place(q).reference_direction(direction);
        for (entry, [xi, eta]) in entries.iter_mut().zip(&self.gradients[q]) {
            *entry += along_xi * xi + along_eta * eta;
        }
    }

    /// Gradient [1/m] of shape function `i` at point `q`.
    #[inline]
    pub fn shape_gradient(&self, q: usize, i: usize) -> [f64; 2] {
        self.place(q).gradient(self.gradients[q][i])
    }
}

/// Value of a function of the first `count` shape functions.
#[inline]
pub(crate) fn value(shapes: &Nodal, count: usize, nodal: &Nodal) -> f64 {
    match count {
        QUADRATIC => value_of::<QUADRATIC>(shapes, nodal),
        CUBIC => value_of::<CUBIC>(shapes, nodal),
        count => (shapes[..count].iter().zip(nodal)).map(|(shape, u)| u * shape).sum(),
    }
}

/// Value of a function of `N` shape functions: a loop of known length.
#[inline]
fn value_of<const N: usize>(shapes: &Nodal, nodal: &Nodal) -> f64 {
    (shapes[..N].iter().zip(&nodal[..N])).map(|(shape, u)| u * shape).sum()
}

/// The sum of `share` over all triangles of a mesh, in parallel; the result does not depend on the number of threads.
pub fn integrate<T: Default + AddAssign + Send>(mesh: &Mesh, share: impl Fn(usize) -> T + Sync) -> T {
    let cells = mesh.triangles().len();
    let add = |mut sum: T, part: T| {
        sum += part;
        sum
    };
    // One type for all callers, so that the scheduler of tasks is compiled once for each type of sum.
    let task: &(dyn Fn(usize) -> T + Sync) =
        &|first| (first..(first + CELLS_A_TASK).min(cells)).map(&share).fold(T::default(), add);
    let firsts: Vec<usize> = (0..cells).step_by(CELLS_A_TASK).collect();
    in_order(firsts.into_par_iter().map(task)).into_iter().fold(T::default(), add)
}

/// A quadrature point of an edge.
#[derive(Debug, Clone, Copy)]
pub struct EdgePoint {
    /// A triangle that the edge bounds, which lies on its left.
    pub cell: usize,
    /// Reference coordinates in that triangle.
    pub point: [f64; 2],
    /// Position on the developed surface [m].
    pub position: [f64; 2],
    /// Derivative [m] of the position along the edge, whose parameter runs from 0 to 1.
    pub tangent: [f64; 2],
    /// Weight on that interval.
    pub weight: f64,
}

/// Gauss points of a straight or quadratic edge.
pub fn edge_points(mesh: &Mesh, edge: u32) -> [EdgePoint; 4] {
    let cell = mesh.topology().edge_triangles[edge as usize][0] as usize;
    let (k, nodes) = (mesh.local_edge(cell, edge), mesh.nodes(cell));
    let (a, b, m) = (nodes[k], nodes[(k + 1) % 3], nodes[3 + k]);
    let corners = lagrange::nodes(1);
    let (from, to) = (corners[k], corners[(k + 1) % 3]);
    gauss_interval().map(|(s, weight)| {
        let shapes = [(1.0 - s) * (1.0 - 2.0 * s), s * (2.0 * s - 1.0), 4.0 * s * (1.0 - s)];
        let slopes = [4.0 * s - 3.0, 4.0 * s - 1.0, 4.0 - 8.0 * s];
        EdgePoint {
            cell,
            point: [0, 1].map(|d| from[d] + s * (to[d] - from[d])),
            position: [0, 1].map(|d| shapes[0] * a[d] + shapes[1] * b[d] + shapes[2] * m[d]),
            tangent: [0, 1].map(|d| slopes[0] * a[d] + slopes[1] * b[d] + slopes[2] * m[d]),
            weight,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_mesh::RawMesh;

    /// Two triangles of the unit square, one edge of which bulges outwards by a parabola of height 0.1: area 1 + 0.2/3.
    #[test]
    fn areas_and_moments_of_a_curved_mesh() {
        let mesh = Mesh::build(RawMesh {
            points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            bulges: vec![(0, 0, [0.0, -0.1])],
            ..RawMesh::default()
        })
        .expect("a mesh");
        let area = 1.0 + 0.2 / 3.0;
        for rule in [Rule::for_degree(2), Rule::new(Quadrature::for_degree(3).quartered(2), 3)] {
            let found: f64 = integrate(&mesh, |t| {
                rule.integrate(&mesh, t, |points, sum| {
                    (0..points.positions.len()).for_each(|q| *sum += points.area(q));
                })
            });
            assert!((found - area).abs() < 1e-14, "{found}");
        }
        // Green's theorem: the area is the integral of x dz around.
        let around: f64 = (0..mesh.topology().edge_triangles.len() as u32)
            .filter(|&edge| mesh.topology().edge_triangles[edge as usize][1] == u32::MAX)
            .flat_map(|edge| edge_points(&mesh, edge))
            .map(|at| at.weight * at.position[0] * at.tangent[1])
            .sum();
        assert!((around - area).abs() < 1e-14, "{around}");
    }
}
