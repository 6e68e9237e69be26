//! Edges of a triangulation and who touches whom.
//!
//! ```text
//!        2            local edge 0 = 0-1
//!       / \           local edge 1 = 1-2
//!    e2/   \e1        local edge 2 = 2-0
//!     /     \         (the order of gmsh and VTK)
//!    0-------1
//!       e0
//! ```
//! An edge belongs to its lesser end, a triangle to its least vertex. Entities are numbered by
//! their owner, so each contiguous range of vertices owns contiguous ranges of edges and triangles.

/// Marks the absent second triangle of a boundary edge.
pub const NO_TRIANGLE: u32 = u32::MAX;

/// Edges of a triangulation whose triangles list their least vertex first and are sorted by it.
#[derive(Debug, Clone)]
pub struct Topology {
    /// Ends of each edge, the lesser first.
    pub edges: Vec<[u32; 2]>,
    /// The three edges of each triangle, in local order 01, 12, 20.
    pub triangle_edges: Vec<[u32; 3]>,
    /// The one or two triangles at each edge, ascending; [`NO_TRIANGLE`] where there is none.
    pub edge_triangles: Vec<[u32; 2]>,
    /// Edges owned by vertex `v` are `edge_start[v]..edge_start[v + 1]`.
    pub edge_start: Vec<u32>,
    /// Triangles owned by vertex `v` are `triangle_start[v]..triangle_start[v + 1]`.
    pub triangle_start: Vec<u32>,
}

impl Topology {
    /// Finds the edges of `triangles`, which must list their least vertex first and be sorted by it.
    ///
    /// # Errors
    /// The edges (as vertex pairs) that more than two triangles share.
    pub fn new(vertices: usize, triangles: &[[u32; 3]]) -> Result<Self, Vec<[u32; 2]>> {
        // Buckets by lesser end, each with room for every mention of an edge.
        let mut room = vec![0u32; vertices + 1];
        for triangle in triangles {
            for k in 0..3 {
                room[ends(triangle, k)[0] as usize + 1] += 1;
            }
        }
        accumulate(&mut room);
        let mut greater = vec![0u32; room[vertices] as usize];
        let mut count = vec![0u32; vertices];
        // For now an edge is its place in its bucket.
        let mut triangle_edges = vec![[0u32; 3]; triangles.len()];
        for (triangle, edges) in triangles.iter().zip(&mut triangle_edges) {
            for k in 0..3 {
                let [lo, hi] = ends(triangle, k);
                let bucket = room[lo as usize] as usize;
                let used = count[lo as usize] as usize;
                let known = greater[bucket..bucket + used].iter().position(|&end| end == hi);
                let place = known.unwrap_or_else(|| {
                    greater[bucket + used] = hi;
                    count[lo as usize] += 1;
                    used
                });
                edges[k] = place as u32;
            }
        }
        let mut edge_start = vec![0u32; vertices + 1];
        let mut edges = Vec::new();
        for v in 0..vertices {
            let bucket = room[v] as usize;
            let used = count[v] as usize;
            edges.extend(greater[bucket..bucket + used].iter().map(|&hi| [v as u32, hi]));
            edge_start[v + 1] = edges.len() as u32;
        }
        for (triangle, edges) in triangles.iter().zip(&mut triangle_edges) {
            for k in 0..3 {
                edges[k] += edge_start[ends(triangle, k)[0] as usize];
            }
        }
        let edge_triangles = triangles_at(&edges, &triangle_edges)?;
        let mut triangle_start = vec![0u32; vertices + 1];
        for triangle in triangles {
            triangle_start[triangle[0] as usize + 1] += 1;
        }
        accumulate(&mut triangle_start);
        Ok(Self { edges, triangle_edges, edge_triangles, edge_start, triangle_start })
    }

    /// The edge between two vertices, if the triangulation has it.
    pub fn edge_between(&self, a: u32, b: u32) -> Option<u32> {
        let (lo, hi) = (a.min(b) as usize, a.max(b));
        let range = self.edge_start[lo] as usize..self.edge_start[lo + 1] as usize;
        let place = self.edges[range.clone()].iter().position(|edge| edge[1] == hi)?;
        Some((range.start + place) as u32)
    }

    /// True if only one triangle touches the edge.
    pub fn is_boundary(&self, edge: u32) -> bool {
        self.edge_triangles[edge as usize][1] == NO_TRIANGLE
    }
}

/// Vertices of local edge `k`, the lesser first.
fn ends(triangle: &[u32; 3], k: usize) -> [u32; 2] {
    let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
    [a.min(b), a.max(b)]
}

/// Sums from the first entry on.
fn accumulate(counts: &mut [u32]) {
    for k in 1..counts.len() {
        counts[k] += counts[k - 1];
    }
}

/// The one or two triangles at each edge; the ends of the edges that have more are the error.
fn triangles_at(edges: &[[u32; 2]], triangle_edges: &[[u32; 3]]) -> Result<Vec<[u32; 2]>, Vec<[u32; 2]>> {
    let mut at = vec![[NO_TRIANGLE; 2]; edges.len()];
    let mut crowded = Vec::new();
    for (t, edge) in (0u32..).zip(triangle_edges).flat_map(|(t, edges)| edges.map(|edge| (t, edge as usize))) {
        match at[edge].iter().position(|&side| side == NO_TRIANGLE) {
            Some(free) => at[edge][free] = t,
            None => crowded.push(edges[edge]),
        }
    }
    if crowded.is_empty() { Ok(at) } else { Err(crowded) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn square_of_two_triangles() {
        let topology = Topology::new(4, &[[0, 1, 2], [0, 2, 3]]).unwrap();
        assert_eq!(topology.edges, [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3]]);
        assert_eq!(topology.triangle_edges, [[0, 3, 1], [1, 4, 2]]);
        assert_eq!(topology.edge_triangles[1], [0, 1]);
        assert!(topology.is_boundary(0));
        assert_eq!(topology.edge_between(3, 2), Some(4));
        assert_eq!(topology.edge_between(1, 3), None);
        assert_eq!(topology.triangle_start, [0, 2, 2, 2, 2]);
    }

    #[test]
    fn three_triangles_on_one_edge_are_refused() {
        let fans = [[0, 1, 2], [0, 1, 3], [0, 1, 4]];
        assert_eq!(Topology::new(5, &fans).unwrap_err(), [[0, 1]]);
    }
}
