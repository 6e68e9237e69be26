//! Degrees of freedom of continuous Lagrange elements on a mesh.
//!
//! Entities are interleaved by owner, vertex by vertex: the vertex, the interior nodes of the edges
//! it owns, the interior nodes of the triangles it owns. A contiguous range of vertices is then one
//! contiguous range of dofs. On an edge nodes count from its lesser vertex. A ring needs no
//! periodic constraint: its seam is glued in the mesh, so both sides have the same dofs.

use std::sync::Arc;

use oilwedge_mesh::Mesh;

use crate::lagrange::{self, MOST_SHAPES};
use crate::mapping::Mapping;

/// Continuous piecewise polynomials of degree 1, 2 or 3.
#[derive(Debug, Clone)]
pub struct Space {
    mesh: Arc<Mesh>,
    degree: usize,
    /// The mesh by whose obtuse corners triangles are cut in control volumes.
    cut_as: Arc<Mesh>,
}

impl Space {
    /// The space of the given degree (1, 2 or 3; others are taken to the nearest of these).
    pub fn new(mesh: Arc<Mesh>, degree: usize) -> Self {
        Self { cut_as: mesh.clone(), mesh, degree: degree.clamp(1, 3) }
    }

    /// The space on a mesh whose vertices lie elsewhere, with the triangles of this one; control volumes are cut as
    /// here, whatever becomes obtuse.
    #[must_use]
    pub fn on_moved(&self, mesh: Arc<Mesh>) -> Self {
        Self { mesh, ..self.clone() }
    }

    /// The mesh by whose obtuse corners triangles are cut in control volumes: that of the space or, where that has
    /// moved, the one before.
    pub(crate) fn cut_as(&self) -> &Mesh {
        &self.cut_as
    }

    /// The mesh.
    pub fn mesh(&self) -> &Arc<Mesh> {
        &self.mesh
    }

    /// Polynomial degree.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Shape functions of an element.
    pub fn shapes(&self) -> usize {
        lagrange::shapes(self.degree)
    }

    /// Dofs inside an edge.
    pub fn per_edge(&self) -> usize {
        self.degree - 1
    }

    /// Dofs inside a triangle.
    pub fn per_triangle(&self) -> usize {
        (self.degree - 1) * (self.degree.saturating_sub(2)) / 2
    }

    /// Number of dofs.
    pub fn dofs(&self) -> usize {
        self.vertex_dof(self.mesh.points().len() as u32)
    }

    /// Dof of vertex `v`; for the number of vertices, the number of dofs.
    pub fn vertex_dof(&self, v: u32) -> usize {
        let topology = self.mesh.topology();
        v as usize
            + self.per_edge() * topology.edge_start[v as usize] as usize
            + self.per_triangle() * topology.triangle_start[v as usize] as usize
    }

    /// First dof inside edge `e`. Edges are numbered as their dofs are, owner by owner.
    pub fn edge_dof(&self, e: u32) -> usize {
        let topology = self.mesh.topology();
        let owner = topology.edges[e as usize][0] as usize;
        let triangles_before = topology.triangle_start[owner] as usize;
        owner + 1 + self.per_edge() * e as usize + self.per_triangle() * triangles_before
    }

    /// First dof inside triangle `t`.
    pub fn triangle_dof(&self, t: u32) -> usize {
        let topology = self.mesh.topology();
        let owner = self.mesh.triangles()[t as usize][0] as usize;
        let edges = topology.edge_start[owner + 1] - topology.edge_start[owner];
        let place = t - topology.triangle_start[owner];
        self.vertex_dof(owner as u32) + 1 + self.per_edge() * edges as usize + self.per_triangle() * place as usize
    }

    /// Dofs of triangle `t` in the local order of [`lagrange`]; entries past [`Space::shapes`] are zero.
    pub fn element_dofs(&self, t: usize) -> [usize; MOST_SHAPES] {
        match self.degree {
            1 => self.dofs_in::<0, 0>(t),
            2 => self.dofs_in::<1, 0>(t),
            _ => self.dofs_in::<2, 1>(t),
        }
    }

    /// With `NE` dofs inside an edge and `NT` inside a triangle: known when compiled, all loops are straight code.
    fn dofs_in<const NE: usize, const NT: usize>(&self, t: usize) -> [usize; MOST_SHAPES] {
        let topology = self.mesh.topology();
        let (triangle, edges) = (self.mesh.triangles()[t], topology.triangle_edges[t]);
        let triangles_before = |v: u32| match NT {
            0 => 0,
            _ => NT * topology.triangle_start[v as usize] as usize,
        };
        let mut dofs = [0; MOST_SHAPES];
        for k in 0..3 {
            let (v, next) = (triangle[k], triangle[(k + 1) % 3]);
            dofs[k] = v as usize + NE * topology.edge_start[v as usize] as usize + triangles_before(v);
            let owner = v.min(next);
            let first = owner as usize + 1 + NE * edges[k] as usize + triangles_before(owner);
            for m in 0..NE {
                // Counted from the lesser vertex.
                let place = if v < next { m } else { NE - 1 - m };
                dofs[3 + NE * k + m] = first + place;
            }
        }
        if NT > 0 {
            dofs[3 + 3 * NE] = self.triangle_dof(t as u32);
        }
        dofs
    }

    /// All dofs on edge `e`: its two ends and its interior.
    pub fn dofs_on_edge(&self, e: u32) -> impl Iterator<Item = usize> {
        let [a, b] = self.mesh.topology().edges[e as usize];
        let first = if self.per_edge() > 0 { self.edge_dof(e) } else { 0 };
        [self.vertex_dof(a), self.vertex_dof(b)].into_iter().chain(first..first + self.per_edge())
    }

    /// Position [m] of each dof. On a ring `x` may exceed the period by half an element.
    pub fn positions(&self) -> Vec<[f64; 2]> {
        let mut positions = vec![[0.0; 2]; self.dofs()];
        let nodes = lagrange::nodes(self.degree);
        for t in 0..self.mesh.triangles().len() {
            let mapping = Mapping::of(&self.mesh, t);
            for (dof, &node) in self.element_dofs(t).iter().zip(&nodes) {
                positions[*dof] = mapping.position(node);
            }
        }
        for (v, &point) in (0u32..).zip(self.mesh.points()) {
            positions[self.vertex_dof(v)] = point;
        }
        positions
    }

    /// Nodal values of a function of the position [m].
    pub fn interpolate(&self, function: impl Fn([f64; 2]) -> f64) -> Vec<f64> {
        self.positions().into_iter().map(function).collect()
    }
}
