//! What can be wrong with a mesh. All defects are found at once; each names what, where and the way out.

/// Most defects of one kind that are kept.
pub(crate) const MOST_DEFECTS: usize = 1000;

/// One defect of a mesh. Positions are `(x, z)` [m] on the developed surface unless said.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Defect {
    /// A coordinate is NaN or infinite.
    #[error("node {node} has a coordinate that is not a number ({coordinates:?}); export the mesh again")]
    NotFinite {
        /// Node tag in the file.
        node: u64,
        /// The coordinates as read.
        coordinates: Vec<f64>,
    },
    /// The mesh has no triangle.
    #[error("the mesh holds no triangle; in gmsh give the physical surface \"film\" and mesh in 2-D (gmsh -2)")]
    Empty,
    /// A triangle names one vertex twice.
    #[error("the triangle of nodes {nodes:?} names a node twice; remove it or mesh the surface again")]
    RepeatedNode {
        /// Node tags of the triangle.
        nodes: [u64; 3],
    },
    /// A triangle has (almost) no area.
    #[error(
        "the triangle of nodes {nodes:?} near ({x:.6}, {z:.6}) has no area ({area:.1e} m2); mesh the surface again"
    )]
    Degenerate {
        /// Node tags of the triangle.
        nodes: [u64; 3],
        /// Developed position [m].
        x: f64,
        /// Axial position [m].
        z: f64,
        /// Signed area [m2].
        area: f64,
    },
    /// A triangle is turned against the others, or folds over itself.
    #[error(
        "the triangle of nodes {nodes:?} near ({x:.6}, {z:.6}) is inverted (the Jacobian of its map is not positive); orient all surfaces alike, or refine where edges are curved"
    )]
    Inverted {
        /// Node tags of the triangle.
        nodes: [u64; 3],
        /// Developed position [m].
        x: f64,
        /// Axial position [m].
        z: f64,
    },
    /// Two triangles stand on the same three vertices.
    #[error("the triangle of nodes {nodes:?} is listed twice; in gmsh remove the duplicate surface (Coherence)")]
    DuplicateTriangle {
        /// Node tags of the triangle.
        nodes: [u64; 3],
    },
    /// Two vertices lie at the same place, so the film is cut open between them.
    #[error("nodes {first} and {second} lie at the same place ({x:.6}, {z:.6}); merge them (gmsh: Coherence Mesh)")]
    CoincidentNodes {
        /// Node tag.
        first: u64,
        /// Node tag.
        second: u64,
        /// Developed position [m].
        x: f64,
        /// Axial position [m].
        z: f64,
    },
    /// An edge is shared by more than two triangles.
    #[error("more than two triangles share the edge between nodes {nodes:?}; remove the overlapping surface")]
    CrowdedEdge {
        /// Node tags of the edge.
        nodes: [u64; 2],
    },
    /// A vertex carries so many triangles that they are needles.
    #[error("{triangles} triangles share node {node}, more than {most}; mesh the surface again")]
    CrowdedNode {
        /// Node tag.
        node: u64,
        /// Number of triangles.
        triangles: u32,
        /// Most that are read.
        most: u32,
    },
    /// A curve of a group runs where the triangles have no edge.
    #[error(
        "group \"{group}\" has an edge between nodes {nodes:?} that no triangle has; mesh the curve and the surface together"
    )]
    LooseEdge {
        /// Name of the group.
        group: String,
        /// Node tags of the edge.
        nodes: [u64; 2],
    },
    /// The film falls apart.
    #[error(
        "the film falls apart in {parts} pieces; one piece of {cells} triangles lies near ({x:.6}, {z:.6}); join the surfaces (gmsh: Coherence) or remove the piece"
    )]
    Disconnected {
        /// Number of connected pieces.
        parts: usize,
        /// Number of triangles of the smallest piece.
        cells: usize,
        /// Developed position of a corner of that piece [m].
        x: f64,
        /// Axial position of the vertex [m].
        z: f64,
    },
    /// A triangle spans half a turn or more.
    #[error(
        "the triangle of nodes {nodes:?} spans {degrees:.0} degrees of the ring; use at least three elements around it"
    )]
    SpansRing {
        /// Node tags of the triangle.
        nodes: [u64; 3],
        /// Angle it spans.
        degrees: f64,
    },
}
