//! Quadratic functions as cubic ones on the same mesh, and what cubic functions have that quadratic ones lack.
//!
//! A quadratic is a cubic: its values at the cubic nodes, one and two thirds along an edge and at the centroid, are
//! ```text
//! u(1/3) = (2 u_a + 8 u_m - u_b) / 9,    u(2/3) = (2 u_b + 8 u_m - u_a) / 9,    u_c = (4 sum u_m - sum u_v) / 9
//! ```
//! The cubics are the quadratics and, one to an edge, `l_a l_b (l_b - l_a)` with `a` the lesser vertex, and one to a
//! triangle, `l_0 l_1 l_2`: the hierarchical basis, in which the part that quadratics lack stands by itself.

use oilwedge_mesh::Mesh;
use rayon::prelude::*;

use crate::Space;
use crate::in_order;

/// Value of the edge function at two thirds of its edge, counted from the lesser vertex; at one third it is the
/// negative.
const EDGE_VALUE: f64 = 2.0 / 27.0;
/// Value of the function of a triangle at its centroid.
const BUBBLE_VALUE: f64 = 1.0 / 27.0;

/// The quadratic and the cubic space of one mesh.
#[derive(Debug, Clone)]
pub struct Prolongation {
    quadratic: Space,
    cubic: Space,
    edges: Vec<EdgeDofs>,
    triangles: Vec<TriangleDofs>,
}

/// Dofs of an edge: its ends and middle in the quadratic space, its ends and thirds in the cubic one.
type EdgeDofs = ([u32; 3], [u32; 4]);
/// Dofs of a triangle: its corners and middles in the quadratic space, its centroid in the cubic one.
type TriangleDofs = ([u32; 6], u32);

/// Coefficients of a cubic, or the entries of a residual, in the hierarchical basis.
#[derive(Debug, Clone, PartialEq)]
pub struct Hierarchical {
    /// The quadratic part, one entry a dof of the quadratic space.
    pub quadratic: Vec<f64>,
    /// Functions of edges.
    pub edges: Vec<f64>,
    /// Functions of triangles.
    pub triangles: Vec<f64>,
}

impl Prolongation {
    /// The prolongation between the spaces of degree 2 and 3 on the mesh of `space`.
    pub fn new(space: &Space) -> Self {
        let (quadratic, cubic) = (Space::new(space.mesh().clone(), 2), Space::new(space.mesh().clone(), 3));
        let topology = space.mesh().topology();
        let edge = |(e, ends): (u32, &[u32; 2])| {
            let [a, b] = ends.map(|v| quadratic.vertex_dof(v) as u32);
            let [a3, b3] = ends.map(|v| cubic.vertex_dof(v) as u32);
            let (middle, first) = (quadratic.edge_dof(e) as u32, cubic.edge_dof(e) as u32);
            ([a, b, middle], [a3, b3, first, first + 1])
        };
        let triangle = |t: usize| {
            let dofs = quadratic.element_dofs(t);
            (std::array::from_fn(|i| dofs[i] as u32), cubic.triangle_dof(t as u32) as u32)
        };
        Self {
            edges: (0u32..).zip(&topology.edges).map(edge).collect(),
            triangles: (0..space.mesh().triangles().len()).map(triangle).collect(),
            quadratic,
            cubic,
        }
    }

    /// The cubic space.
    pub fn cubic(&self) -> &Space {
        &self.cubic
    }

    fn mesh(&self) -> &Mesh {
        self.quadratic.mesh()
    }

    fn edge(&self, e: usize) -> ([usize; 3], [usize; 4]) {
        let (quadratic, cubic) = self.edges[e];
        (quadratic.map(|dof| dof as usize), cubic.map(|dof| dof as usize))
    }

    fn triangle(&self, t: usize) -> ([usize; 6], usize) {
        let (quadratic, centroid) = self.triangles[t];
        (quadratic.map(|dof| dof as usize), centroid as usize)
    }

    /// Values at the cubic nodes of the quadratic with the nodal values `u`.
    pub fn prolong(&self, u: &[f64]) -> Vec<f64> {
        let mut cubic = vec![0.0; self.cubic.dofs()];
        for v in 0..self.mesh().points().len() as u32 {
            cubic[self.cubic.vertex_dof(v)] = u[self.quadratic.vertex_dof(v)];
        }
        for e in 0..self.mesh().topology().edges.len() {
            let ([a, b, m], [_, _, first, second]) = self.edge(e);
            cubic[first] = (2.0 * u[a] + 8.0 * u[m] - u[b]) / 9.0;
            cubic[second] = (2.0 * u[b] + 8.0 * u[m] - u[a]) / 9.0;
        }
        for t in 0..self.mesh().triangles().len() {
            let ([a, b, c, ab, bc, ca], centroid) = self.triangle(t);
            cubic[centroid] = (4.0 * (u[ab] + u[bc] + u[ca]) - u[a] - u[b] - u[c]) / 9.0;
        }
        cubic
    }

    /// The transpose of [`Prolongation::prolong`]: a residual tested with quadratic functions.
    pub fn restrict(&self, r: &[f64]) -> Vec<f64> {
        let mut quadratic = vec![0.0; self.quadratic.dofs()];
        for v in 0..self.mesh().points().len() as u32 {
            quadratic[self.quadratic.vertex_dof(v)] = r[self.cubic.vertex_dof(v)];
        }
        for e in 0..self.mesh().topology().edges.len() {
            let ([a, b, m], [_, _, first, second]) = self.edge(e);
            quadratic[a] += (2.0 * r[first] - r[second]) / 9.0;
            quadratic[b] += (2.0 * r[second] - r[first]) / 9.0;
            quadratic[m] += 8.0 * (r[first] + r[second]) / 9.0;
        }
        for t in 0..self.mesh().triangles().len() {
            let (nodes, centroid) = self.triangle(t);
            for (i, dof) in nodes.into_iter().enumerate() {
                quadratic[dof] += r[centroid] * if i < 3 { -1.0 } else { 4.0 } / 9.0;
            }
        }
        quadratic
    }

    /// The cubic with the nodal values `u` in the hierarchical basis.
    pub fn split(&self, u: &[f64]) -> Hierarchical {
        let topology = self.mesh().topology();
        let mut quadratic = vec![0.0; self.quadratic.dofs()];
        for v in 0..self.mesh().points().len() as u32 {
            quadratic[self.quadratic.vertex_dof(v)] = u[self.cubic.vertex_dof(v)];
        }
        let edges = (0..topology.edges.len())
            .map(|e| {
                // The edge function vanishes at the middle; its third difference is -4/9.
                let ([_, _, middle], nodes) = self.edge(e);
                let [a, b, first, second] = nodes.map(|dof| u[dof]);
                quadratic[middle] = (9.0 * (first + second) - a - b) / 16.0;
                -2.25 * (b - 3.0 * second + 3.0 * first - a)
            })
            .collect();
        let triangles = (0..self.mesh().triangles().len())
            .map(|t| {
                let ([a, b, c, ab, bc, ca], centroid) = self.triangle(t);
                let at = |dof: usize| quadratic[dof];
                let smooth = (4.0 * (at(ab) + at(bc) + at(ca)) - at(a) - at(b) - at(c)) / 9.0;
                (u[centroid] - smooth) / BUBBLE_VALUE
            })
            .collect();
        Hierarchical { quadratic, edges, triangles }
    }

    /// A residual tested with the functions of the hierarchical basis.
    pub fn test(&self, r: &[f64]) -> Hierarchical {
        let edges = (0..self.mesh().topology().edges.len())
            .map(|e| {
                let (_, [_, _, first, second]) = self.edge(e);
                EDGE_VALUE * (r[second] - r[first])
            })
            .collect();
        let triangles =
            (0..self.mesh().triangles().len() as u32).map(|t| BUBBLE_VALUE * r[self.cubic.triangle_dof(t)]).collect();
        Hierarchical { quadratic: self.restrict(r), edges, triangles }
    }

    /// Each entry shared equally among the triangles that its function lives on: one sum a triangle.
    pub fn shared(&self, entries: &Hierarchical) -> Vec<f64> {
        let topology = self.mesh().topology();
        let mut around = vec![0u32; self.mesh().points().len()];
        for &v in self.mesh().triangles().iter().flatten() {
            around[v as usize] += 1;
        }
        let sides = |e: u32| if topology.is_boundary(e) { 1.0 } else { 2.0 };
        let share = |t: usize| {
            let dofs = self.triangle(t).0.map(|dof| entries.quadratic[dof]);
            let corners = self.mesh().triangles()[t].iter().zip(&dofs);
            let corners: f64 = corners.map(|(&v, entry)| entry / f64::from(around[v as usize])).sum();
            let edges = topology.triangle_edges[t].iter().zip(&dofs[3..]);
            let edges: f64 = edges.map(|(&e, entry)| (entry + entries.edges[e as usize]) / sides(e)).sum();
            corners + edges + entries.triangles[t]
        };
        in_order((0..self.mesh().triangles().len()).into_par_iter().map(share))
    }
}

impl Hierarchical {
    /// Products entry by entry.
    pub fn times(&self, other: &Self) -> Self {
        let products = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).collect();
        Self {
            quadratic: products(&self.quadratic, &other.quadratic),
            edges: products(&self.edges, &other.edges),
            triangles: products(&self.triangles, &other.triangles),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::tests::wavy_ring;
    use crate::lagrange;

    fn wave(n: usize, k: f64) -> Vec<f64> {
        (0..n).map(|i| (k * i as f64).sin()).collect()
    }

    fn dot(a: &[f64], b: &[f64]) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    #[test]
    fn a_quadratic_stays_itself() {
        let space = Space::new(wavy_ring(5, 3), 2);
        let between = Prolongation::new(&space);
        let u = wave(space.dofs(), 1.3);
        let cubic = between.prolong(&u);
        let quadratic = crate::Field { space: &space, values: &u };
        for t in 0..space.mesh().triangles().len() {
            for (dof, point) in between.cubic().element_dofs(t).into_iter().zip(lagrange::nodes(3)) {
                assert!((cubic[dof] - quadratic.value(t, point)).abs() < 1e-14);
            }
        }
        let split = between.split(&cubic);
        assert!(split.edges.iter().chain(&split.triangles).all(|c| c.abs() < 1e-12));
        assert!(split.quadratic.iter().zip(&u).all(|(a, b)| (a - b).abs() < 1e-14));
    }

    #[test]
    fn both_bases_tell_the_same_products() {
        let space = Space::new(wavy_ring(5, 3), 2);
        let between = Prolongation::new(&space);
        let (u, r) = (wave(between.cubic().dofs(), 0.7), wave(between.cubic().dofs(), 2.1));
        let v = wave(space.dofs(), 0.4);
        assert!((dot(&between.prolong(&v), &r) - dot(&v, &between.restrict(&r))).abs() < 1e-12);
        let shares = between.shared(&between.split(&u).times(&between.test(&r)));
        assert!((shares.iter().sum::<f64>() - dot(&u, &r)).abs() < 1e-12);
    }
}
