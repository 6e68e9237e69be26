//! A triangle mesh of the developed liner, numbered for speed and checked.

use std::collections::HashMap;

use crate::raw::unwrap_corners;
use crate::{Circle, RawMesh, Region, Topology};

/// A conforming triangulation of the developed liner: vertices `(x = R phi, y = z)` [m],
/// counter-clockwise triangles with straight or quadratic edges, and named regions.
#[derive(Debug, Clone)]
pub struct Mesh {
    pub(crate) points: Vec<[f64; 2]>,
    pub(crate) labels: Vec<u64>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) topology: Topology,
    /// Edges that are not straight: the vector from the middle of the straight edge to the mid-side node.
    pub(crate) bulges: HashMap<u32, [f64; 2]>,
    pub(crate) curved: Vec<bool>,
    /// Circles, each with the edges on it, ascending.
    pub(crate) circles: Vec<(Circle, Vec<u32>)>,
    pub(crate) period: Option<f64>,
    pub(crate) regions: Vec<Region>,
}

impl Mesh {
    /// Vertices on the developed surface [m].
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Vertices of each triangle, counter-clockwise, the least first.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Edges and neighbours.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// Circumference [m] of a ring; none for an arc.
    pub fn period(&self) -> Option<f64> {
        self.period
    }

    /// Named sets of edges and cells, in the order of the file.
    pub fn regions(&self) -> &[Region] {
        &self.regions
    }

    /// The region of that name.
    pub fn region(&self, name: &str) -> Option<&Region> {
        self.regions.iter().find(|region| region.name == name)
    }

    /// Name of vertex `v` in its file (gmsh node tag), for messages.
    pub fn label(&self, v: u32) -> u64 {
        self.labels[v as usize]
    }

    /// True if an edge of triangle `t` is not straight.
    pub fn is_curved(&self, t: usize) -> bool {
        self.curved[t]
    }

    /// The three corners of triangle `t` [m], side by side also across the seam of a ring.
    #[inline]
    pub fn corners(&self, t: usize) -> [[f64; 2]; 3] {
        unwrap_corners(self.triangles[t].map(|v| self.points[v as usize]), self.period)
    }

    /// The six nodes of triangle `t` [m]: corners, then the mid-side nodes of edges 01, 12, 20.
    pub fn nodes(&self, t: usize) -> [[f64; 2]; 6] {
        let corners = self.corners(t);
        let mut nodes = [[0.0; 2]; 6];
        nodes[..3].copy_from_slice(&corners);
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            let bulge = self.bulge(self.topology.triangle_edges[t][k]);
            nodes[3 + k] = [0.5 * (a[0] + b[0]) + bulge[0], 0.5 * (a[1] + b[1]) + bulge[1]];
        }
        nodes
    }

    /// The two ends and the mid-side node of an edge [m], in the order of its vertices, side by side.
    pub fn edge_nodes(&self, edge: u32) -> [[f64; 2]; 3] {
        let t = self.topology.edge_triangles[edge as usize][0] as usize;
        let k = self.local_edge(t, edge);
        let nodes = self.nodes(t);
        let (a, b) = (nodes[k], nodes[(k + 1) % 3]);
        if self.triangles[t][k] == self.topology.edges[edge as usize][0] {
            [a, b, nodes[3 + k]]
        } else {
            [b, a, nodes[3 + k]]
        }
    }

    /// Which of the three edges of triangle `t` the given edge is.
    pub fn local_edge(&self, t: usize, edge: u32) -> usize {
        let edges = self.topology.triangle_edges[t];
        (0..3).find(|&k| edges[k] == edge).unwrap_or(0)
    }

    /// Vector [m] from the middle of the straight edge to the mid-side node; zero for a straight edge.
    pub fn bulge(&self, edge: u32) -> [f64; 2] {
        self.bulges.get(&edge).copied().unwrap_or([0.0; 2])
    }

    /// Circles [m], each with the edges that lie on it, ascending. On a ring the centre counts modulo the period.
    pub fn circles(&self) -> &[(Circle, Vec<u32>)] {
        &self.circles
    }

    /// The circle that the edge lies on, if one is known.
    pub fn circle(&self, edge: u32) -> Option<&Circle> {
        let on = |edges: &Vec<u32>| edges.binary_search(&edge).is_ok();
        Some(&self.circles.iter().find(|(_, edges)| on(edges))?.0)
    }

    /// Number of nodes when each triangle has six: vertices and edges.
    pub fn quadratic_nodes(&self) -> usize {
        self.points.len() + self.topology.edges.len()
    }

    /// The mesh as it would be listed in a file, in the present numbering.
    ///
    /// With [`Mesh::build`] this is the way to change geometry: take out, edit, build again.
    pub fn to_raw(&self) -> RawMesh {
        let mut bulges = Vec::new();
        for (t, edges) in self.topology.triangle_edges.iter().enumerate() {
            for k in (0..3).filter(|_| self.curved[t]) {
                if let Some(&bulge) = self.bulges.get(&edges[k]) {
                    bulges.push((t as u32, k as u8, bulge));
                }
            }
        }
        let pairs = |edges: &[u32]| edges.iter().map(|&e| self.topology.edges[e as usize]).collect();
        RawMesh {
            points: self.points.clone(),
            labels: self.labels.clone(),
            triangles: self.triangles.clone(),
            bulges,
            circles: self.circles.iter().map(|(circle, edges)| (*circle, pairs(edges))).collect(),
            curves: self
                .regions
                .iter()
                .filter(|region| !region.edges.is_empty())
                .map(|region| (region.name.clone(), pairs(&region.edges)))
                .collect(),
            surfaces: self
                .regions
                .iter()
                .filter(|region| !region.cells.is_empty())
                .map(|region| (region.name.clone(), region.cells.clone()))
                .collect(),
            period: self.period,
        }
    }
}

/// A lower bound of the Jacobian determinant [m2] of the quadratic map over the triangle: the
/// determinant is itself quadratic, and its least Bernstein coefficient bounds it.
pub(crate) fn least_jacobian(nodes: &[[f64; 2]; 6]) -> f64 {
    let corner_and_mid = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]];
    let at = corner_and_mid.map(|xi| quadratic_jacobian(nodes, xi));
    let middle = |k: usize| 2.0 * at[3 + k] - 0.5 * (at[k] + at[(k + 1) % 3]);
    [at[0], at[1], at[2], middle(0), middle(1), middle(2)].into_iter().fold(f64::INFINITY, f64::min)
}

/// Jacobian determinant [m2] of the quadratic map at a reference point.
fn quadratic_jacobian(nodes: &[[f64; 2]; 6], at: [f64; 2]) -> f64 {
    let [along_xi, along_eta] = quadratic_tangents(nodes, at);
    along_xi[0] * along_eta[1] - along_xi[1] * along_eta[0]
}

/// Derivatives [m] of the quadratic map by `xi` and by `eta` at the reference point `(xi, eta)`.
pub(crate) fn quadratic_tangents(nodes: &[[f64; 2]; 6], [xi, eta]: [f64; 2]) -> [[f64; 2]; 2] {
    let zeta = 1.0 - xi - eta;
    let by_xi = [1.0 - 4.0 * zeta, 4.0 * xi - 1.0, 0.0, 4.0 * (zeta - xi), 4.0 * eta, -4.0 * eta];
    let by_eta = [1.0 - 4.0 * zeta, 0.0, 4.0 * eta - 1.0, -4.0 * xi, 4.0 * xi, 4.0 * (zeta - eta)];
    let mut tangents = [[0.0; 2]; 2];
    for (i, node) in nodes.iter().enumerate() {
        for d in 0..2 {
            tangents[0][d] += by_xi[i] * node[d];
            tangents[1][d] += by_eta[i] * node[d];
        }
    }
    tangents
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jacobian_bound_sees_a_fold() {
        let straight = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]];
        assert!((least_jacobian(&straight) - 1.0).abs() < 1e-15);
        let mut folded = straight;
        folded[3] = [0.5, 0.6];
        assert!(least_jacobian(&folded) < 0.0);
    }
}
