//! Named sets of edges and cells: ends, arc edges, seams, feeds.

/// A named part of the liner. A gmsh physical curve gives `edges`, a physical surface `cells`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Region {
    /// Name of the physical group.
    pub name: String,
    /// Edges of the curve of that name, ascending.
    pub edges: Vec<u32>,
    /// Triangles of the surface of that name, ascending.
    pub cells: Vec<u32>,
}
