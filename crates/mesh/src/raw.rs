//! Triangles as a file or a generator lists them: any order, any orientation, unchecked.

use crate::Circle;

/// The input of [`crate::Mesh::build`].
#[derive(Debug, Clone, Default)]
pub struct RawMesh {
    /// Vertices on the developed surface `(x = R phi, y = z)` [m]; mid-side nodes are not listed.
    pub points: Vec<[f64; 2]>,
    /// Name of each vertex in its file (gmsh node tag), for messages; empty: its index plus one.
    pub labels: Vec<u64>,
    /// Three vertices a triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Edges that bulge: triangle, local edge (0: 0-1, 1: 1-2, 2: 2-0), and the vector [m] from
    /// the middle of the straight edge to the mid-side node. May be listed from both sides.
    pub bulges: Vec<(u32, u8, [f64; 2])>,
    /// Circles [m] and the edges that lie on them, each edge by its two vertices: vertices that refinement
    /// puts on such an edge come to lie on the circle. On a ring the centre counts modulo the period.
    pub circles: Vec<(Circle, Vec<[u32; 2]>)>,
    /// Named sets of edges, each edge by its two vertices.
    pub curves: Vec<(String, Vec<[u32; 2]>)>,
    /// Named sets of triangles.
    pub surfaces: Vec<(String, Vec<u32>)>,
    /// Circumference [m] after which `x` repeats; none for an arc.
    pub period: Option<f64>,
}

impl RawMesh {
    /// Name of vertex `v` in its file.
    pub fn label(&self, v: u32) -> u64 {
        self.labels.get(v as usize).copied().unwrap_or(u64::from(v) + 1)
    }

    /// Corners of triangle `t` side by side [m]: on a ring, those left of the seam move up by the period.
    pub fn corners(&self, t: usize) -> [[f64; 2]; 3] {
        unwrap_corners(self.triangles[t].map(|v| self.points[v as usize]), self.period)
    }
}

/// Lays three corners side by side on a ring of the given period: whichever lies more than half a
/// turn below the greatest `x` moves up by one turn.
pub(crate) fn unwrap_corners(mut corners: [[f64; 2]; 3], period: Option<f64>) -> [[f64; 2]; 3] {
    if let Some(period) = period {
        let greatest = corners[0][0].max(corners[1][0]).max(corners[2][0]);
        for corner in &mut corners {
            if greatest - corner[0] > 0.5 * period {
                corner[0] += period;
            }
        }
    }
    corners
}

/// Signed area [m2] of a triangle, positive if counter-clockwise.
pub fn triangle_area(corners: [[f64; 2]; 3]) -> f64 {
    0.5 * doubled_area(corners)
}

/// Twice the signed area [m2] of a triangle, positive if counter-clockwise.
pub(crate) fn doubled_area([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}
