//! How good a mesh is: angles, shapes, sizes, and what its boundary looks like.

use std::collections::HashMap;

use crate::Mesh;
use crate::raw::doubled_area;

/// Measures of a mesh. Angles, shapes and lengths are those of the straight triangles between the
/// corners; the area is that of the curved ones.
#[derive(Debug, Clone, Default, PartialEq, serde::Serialize)]
pub struct Quality {
    /// Number of triangles.
    pub cells: usize,
    /// Number of vertices.
    pub vertices: usize,
    /// Number of vertices and edges: the nodes of a quadratic film.
    pub quadratic_nodes: usize,
    /// Number of triangles with an edge that is not straight.
    pub curved_cells: usize,
    /// Least angle of any triangle [deg].
    pub least_angle: f64,
    /// Mean over the triangles of their least angles [deg].
    pub mean_angle: f64,
    /// Median over the triangles of their least angles [deg].
    pub median_angle: f64,
    /// Greatest ratio of the longest edge to the height on it; 1.15 for an equilateral triangle.
    pub worst_aspect: f64,
    /// Median of that ratio.
    pub median_aspect: f64,
    /// Shortest edge [m].
    pub shortest_edge: f64,
    /// Longest edge [m].
    pub longest_edge: f64,
    /// Area of the developed film [m2], curved edges counted exactly.
    pub area: f64,
    /// Number of closed curves that bound the film: 2 for a ring, 1 for an arc, one more for each hole.
    pub boundary_loops: usize,
    /// Number of boundary edges that belong to no region: the film has a wall there.
    pub unnamed_boundary_edges: usize,
}

/// Share of the triangles whose longest edge is more than `aspect` times the height on it.
pub fn needle_share(mesh: &Mesh, aspect: f64) -> f64 {
    let is_needle = |t: usize| {
        let corners = mesh.corners(t);
        let longest = (0..3).map(|k| distance(corners[k], corners[(k + 1) % 3])).fold(0.0, f64::max);
        longest * longest > aspect * doubled_area(corners)
    };
    let cells = mesh.triangles().len();
    (0..cells).filter(|&t| is_needle(t)).count() as f64 / cells as f64
}

/// Share of the area in triangles without an edge along x: oil that is carried along x spreads across them.
pub fn share_across_flow(mesh: &Mesh) -> f64 {
    let (mut across, mut whole) = (0.0, 0.0);
    for t in 0..mesh.triangles().len() {
        let corners = mesh.corners(t);
        let area = doubled_area(corners);
        whole += area;
        if !follows_flow(corners) {
            across += area;
        }
    }
    across / whole
}

/// True of a mesh most of whose area lies in triangles with an edge along x.
pub fn lies_in_rows(mesh: &Mesh) -> bool {
    const MOST_ACROSS: f64 = 0.5;
    share_across_flow(mesh) <= MOST_ACROSS
}

/// True if an edge of the triangle lies along x: its ends differ by little of the extent of the triangle across the
/// flow.
fn follows_flow(corners: [[f64; 2]; 3]) -> bool {
    const LITTLE: f64 = 0.1;
    let z = corners.map(|corner| corner[1]);
    let (low, high) = (z[0].min(z[1]).min(z[2]), z[0].max(z[1]).max(z[2]));
    (0..3).any(|k| (z[k] - z[(k + 1) % 3]).abs() < LITTLE * (high - low))
}

impl Quality {
    /// Measures `mesh`.
    pub fn of(mesh: &Mesh) -> Self {
        let cells = mesh.triangles().len();
        let topology = mesh.topology();
        let mut angles = Vec::with_capacity(cells);
        let mut aspects = Vec::with_capacity(cells);
        let (mut shortest, mut longest) = (f64::INFINITY, 0.0f64);
        let mut area = 0.0;
        for t in 0..cells {
            let corners = mesh.corners(t);
            let lengths: [f64; 3] = std::array::from_fn(|k| distance(corners[k], corners[(k + 1) % 3]));
            let most = lengths[0].max(lengths[1]).max(lengths[2]);
            shortest = shortest.min(lengths[0]).min(lengths[1]).min(lengths[2]);
            longest = longest.max(most);
            angles.push(least_angle(corners));
            aspects.push(most * most / doubled_area(corners));
            area += triangle_area(mesh, t);
        }
        let named = named_edges(mesh);
        let boundary: Vec<u32> = (0..topology.edges.len() as u32).filter(|&e| topology.is_boundary(e)).collect();
        Self {
            cells,
            vertices: mesh.points().len(),
            quadratic_nodes: mesh.quadratic_nodes(),
            curved_cells: (0..cells).filter(|&t| mesh.is_curved(t)).count(),
            least_angle: angles.iter().copied().fold(f64::INFINITY, f64::min),
            mean_angle: angles.iter().sum::<f64>() / cells as f64,
            median_angle: median(&mut angles),
            worst_aspect: aspects.iter().copied().fold(0.0, f64::max),
            median_aspect: median(&mut aspects),
            shortest_edge: shortest,
            longest_edge: longest,
            area,
            boundary_loops: loops(mesh, &boundary),
            unnamed_boundary_edges: boundary.iter().filter(|&&edge| !named[edge as usize]).count(),
        }
    }
}

/// Least angle [deg] of any triangle, as in [`Quality`] and without the rest.
pub fn least_angle_of(mesh: &Mesh) -> f64 {
    // The angle with the greatest cotangent: only that of one triangle is worked out.
    let (mut sharpest, mut greatest) = (0, f64::NEG_INFINITY);
    for t in 0..mesh.triangles().len() {
        let corners = mesh.corners(t);
        let dots = [0, 1, 2].map(|k| corner_dot(corners, k));
        let cotangent = dots[0].max(dots[1]).max(dots[2]) / doubled_area(corners);
        if cotangent > greatest {
            (sharpest, greatest) = (t, cotangent);
        }
    }
    least_angle(mesh.corners(sharpest))
}

/// Area [m2] of triangle `t` with its curved edges: a parabola holds two thirds of the
/// parallelogram over its chord.
pub fn triangle_area(mesh: &Mesh, t: usize) -> f64 {
    let corners = mesh.corners(t);
    let mut area = 0.5 * doubled_area(corners);
    if mesh.is_curved(t) {
        for (k, &edge) in mesh.topology().triangle_edges[t].iter().enumerate() {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            let bulge = mesh.bulge(edge);
            area += 2.0 / 3.0 * (bulge[0] * (b[1] - a[1]) - bulge[1] * (b[0] - a[0]));
        }
    }
    area
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// Least corner angle [deg].
fn least_angle(corners: [[f64; 2]; 3]) -> f64 {
    let area = doubled_area(corners);
    let angle = |k: usize| area.atan2(corner_dot(corners, k)).to_degrees();
    angle(0).min(angle(1)).min(angle(2))
}

/// Dot product [m2] of the two edges that leave corner `k`.
fn corner_dot(corners: [[f64; 2]; 3], k: usize) -> f64 {
    let [p, a, b] = [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]];
    (a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1])
}

fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

fn named_edges(mesh: &Mesh) -> Vec<bool> {
    let mut named = vec![false; mesh.topology().edges.len()];
    for &edge in mesh.regions().iter().flat_map(|region| &region.edges) {
        named[edge as usize] = true;
    }
    named
}

/// Connected parts of the boundary.
fn loops(mesh: &Mesh, boundary: &[u32]) -> usize {
    let mut at_vertex: HashMap<u32, Vec<u32>> = HashMap::new();
    for &edge in boundary {
        for v in mesh.topology().edges[edge as usize] {
            at_vertex.entry(v).or_default().push(edge);
        }
    }
    let mut seen = vec![false; mesh.topology().edges.len()];
    let mut count = 0;
    for &seed in boundary {
        if seen[seed as usize] {
            continue;
        }
        count += 1;
        let mut stack = vec![seed];
        while let Some(edge) = stack.pop() {
            if !std::mem::replace(&mut seen[edge as usize], true) {
                let ends = mesh.topology().edges[edge as usize];
                stack.extend(ends.iter().filter_map(|v| at_vertex.get(v)).flatten());
            }
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RawMesh;

    #[test]
    fn square_with_a_bulging_side() {
        let raw = RawMesh {
            points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            bulges: vec![(0, 0, [0.0, -0.3]), (1, 1, [0.0, -0.03])],
            curves: vec![("side".to_owned(), vec![[0, 1]])],
            ..RawMesh::default()
        };
        let mesh = Mesh::build(raw).unwrap();
        let quality = Quality::of(&mesh);
        assert!((quality.area - (1.0 + 0.2 - 0.02)).abs() < 1e-15);
        assert!((quality.least_angle - 45.0).abs() < 1e-12);
        assert_eq!(quality.least_angle, least_angle_of(&mesh));
        assert!((quality.median_angle - 45.0).abs() < 1e-12);
        assert!((quality.worst_aspect - 2.0).abs() < 1e-15);
        assert_eq!((quality.shortest_edge, quality.longest_edge), (1.0, 2f64.sqrt()));
        assert_eq!((quality.boundary_loops, quality.unnamed_boundary_edges), (1, 3));
        assert_eq!((quality.curved_cells, quality.quadratic_nodes), (2, 9));
    }
}
