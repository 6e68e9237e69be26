//! Median dual cells on the linear sub-mesh of quadratic triangles, for schemes of finite volumes.
//!
//! A space of linear elements is its own sub-mesh: the same scheme on the vertices alone.
//!
//! ```text
//!        2
//!       / \          each triangle is four on its six nodes: (0 3 5) (3 1 4) (5 4 2) (3 4 5),
//!      5---4         with straight sides between them; a node's cell is bounded by the lines from the
//!     / \ / \        middles of the sides to the centroids.
//!    0---3---1
//! ```
//! In a triangle with an obtuse corner the inner side across from it is flipped (0-4 instead of 3-5): both angles
//! across from it would be obtuse, and its coupling of the wrong sign.

use std::sync::{Arc, OnceLock};

use oilwedge_mesh::Mesh;

use crate::integrate::Rule;
use crate::ordering::elimination_order;
use crate::{Error, HarmonicAnalysis, Pattern, Quadrature, Space, UnsymmetricAnalysis, lagrange};

/// Sub-triangles of a quadratic triangle that is obtuse at its first, second or third corner, or at none.
const QUARTERS: [[[usize; 3]; 4]; 4] = [
    [[0, 3, 4], [3, 1, 4], [5, 4, 2], [0, 4, 5]],
    [[0, 3, 5], [3, 1, 5], [5, 4, 2], [1, 4, 5]],
    [[0, 3, 5], [3, 1, 4], [3, 4, 2], [3, 2, 5]],
    [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]],
];

/// One quadrature rule per sub-triangle that triangles of these elements may have, with the shape functions of the
/// whole triangle.
#[derive(Debug)]
pub struct SubTriangleRules(Vec<([usize; 3], Rule)>);

impl SubTriangleRules {
    /// Rules that are exact for polynomials of degree `exact`, for elements of degree `degree`.
    pub fn new(degree: usize, exact: usize) -> Self {
        let nodes = lagrange::nodes(degree);
        let mut rules: Vec<([usize; 3], Rule)> = Vec::new();
        let corners = match degree {
            1 => vec![[0, 1, 2]],
            _ => QUARTERS.concat(),
        };
        for corners in corners {
            if rules.iter().all(|(other, _)| *other != corners) {
                let part = Quadrature::for_degree(exact).on_part(corners.map(|node| nodes[node]));
                rules.push((corners, Rule::new(part, degree)));
            }
        }
        Self(rules)
    }

    /// The rule of the sub-triangle with these corners, one of [`sub_triangles`].
    ///
    /// # Panics
    /// No triangle has such a sub-triangle.
    pub fn of(&self, corners: &[usize; 3]) -> &Rule {
        let found = self.0.iter().find(|(other, _)| other == corners);
        &found.expect("corners of a sub-triangle").1
    }
}

/// The sub-triangles of triangle `t` by its local nodes, counter-clockwise: four, or itself where the elements are
/// linear.
pub fn sub_triangles(space: &Space, t: usize) -> &'static [[usize; 3]] {
    match space.degree() {
        1 => &[[0, 1, 2]],
        _ => quarters(space.cut_as(), t),
    }
}

/// The sub-triangle of triangle `t` that holds a point of the reference triangle: its number, and the barycentric
/// coordinates of the point in it.
pub fn sub_triangle_at(space: &Space, t: usize, [xi, eta]: [f64; 2]) -> (usize, [f64; 3]) {
    let places = lagrange::nodes(space.degree());
    let weights = |sub: &[usize; 3]| {
        let [a, b, c] = sub.map(|node| places[node]);
        let twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let at_b = ((xi - a[0]) * (c[1] - a[1]) - (eta - a[1]) * (c[0] - a[0])) / twice;
        let at_c = ((b[0] - a[0]) * (eta - a[1]) - (b[1] - a[1]) * (xi - a[0])) / twice;
        [1.0 - at_b - at_c, at_b, at_c]
    };
    let least = |weights: [f64; 3]| weights.into_iter().fold(f64::INFINITY, f64::min);
    let subs = sub_triangles(space, t).iter().map(weights).enumerate();
    subs.max_by(|(_, a), (_, b)| least(*a).total_cmp(&least(*b))).expect("a triangle has sub-triangles")
}

fn quarters(mesh: &Mesh, t: usize) -> &'static [[usize; 3]; 4] {
    let corners = mesh.corners(t);
    let is_obtuse = |k: usize| {
        let (at, next, previous) = (corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]);
        let along = |d: usize| (next[d] - at[d]) * (previous[d] - at[d]);
        along(0) + along(1) < 0.0
    };
    &QUARTERS[(0..3).find(|&k| is_obtuse(k)).unwrap_or(3)]
}

/// The sub-mesh of a space of quadratic or linear elements and the pattern of couplings between its nodes.
#[derive(Debug)]
pub struct ControlVolumes {
    /// Dofs at the corners of each sub-triangle, triangle by triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Sub-triangles of each triangle: four of a quadratic one, one of a linear one.
    pub per_triangle: usize,
    /// Address of entry `[row][column]` of each sub-triangle's matrix.
    pub addresses: Vec<[[u32; 3]; 3]>,
    /// The pattern, columns ascending.
    pub pattern: Arc<Pattern>,
    /// The pattern of the LU factors.
    pub analysis: Arc<UnsymmetricAnalysis>,
    /// Pieces of the boundary that bound a dof's cell.
    pub faces: Vec<BoundaryFace>,
    /// Analysis that is made when a harmonic motion is first asked for.
    harmonic: OnceLock<Result<HarmonicAnalysis, Error>>,
}

/// A piece of the boundary at a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryFace {
    /// The dof.
    pub dof: usize,
    /// Triangle that the face belongs to.
    pub cell: usize,
    /// The middle of the piece [m].
    pub middle: [f64; 2],
    /// Outward normal times length [m].
    pub normal: [f64; 2],
}

impl ControlVolumes {
    /// The sub-mesh of `space`, whose degree must be one or two.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if the factor's indices do not fit in memory.
    pub fn new(space: &Space) -> Result<Self, Error> {
        let triangles: Vec<[u32; 3]> = (0..space.mesh().triangles().len())
            .flat_map(|t| {
                let dofs = space.element_dofs(t);
                let subs = sub_triangles(space, t).iter();
                subs.map(move |nodes| nodes.map(|node| dofs[node] as u32))
            })
            .collect();
        let pattern = Arc::new(pattern(space.dofs(), &triangles));
        let find = |i: u32, j: u32| {
            let row = pattern.row(i as usize);
            let place = pattern.columns[row.clone()].binary_search(&j).unwrap_or(0);
            (row.start + place) as u32
        };
        let addresses = triangles.iter().map(|nodes| nodes.map(|i| nodes.map(|j| find(i, j)))).collect();
        Ok(Self {
            addresses,
            analysis: Arc::new(UnsymmetricAnalysis::new(pattern.clone(), elimination_order(space))?),
            pattern,
            per_triangle: space.degree() * space.degree(),
            triangles,
            faces: boundary_faces(space),
            harmonic: OnceLock::new(),
        })
    }

    /// The analysed pattern of systems of harmonic motions.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if the factor's indices do not fit in memory.
    pub fn harmonic(&self) -> Result<&HarmonicAnalysis, Error> {
        let analysis = self.harmonic.get_or_init(|| HarmonicAnalysis::new(&self.analysis));
        analysis.as_ref().map_err(Clone::clone)
    }
}

/// Every node with itself and its neighbours, ascending.
fn pattern(dofs: usize, triangles: &[[u32; 3]]) -> Pattern {
    let mut count = vec![0u32; dofs + 1];
    for nodes in triangles {
        for &node in nodes {
            count[node as usize + 1] += 2;
        }
    }
    for i in 0..dofs {
        count[i + 1] += count[i];
    }
    let mut next = count.clone();
    let mut mentions = vec![0u32; count[dofs] as usize];
    for nodes in triangles {
        for k in 0..3 {
            for other in [nodes[(k + 1) % 3], nodes[(k + 2) % 3]] {
                let slot = &mut next[nodes[k] as usize];
                mentions[*slot as usize] = other;
                *slot += 1;
            }
        }
    }
    let (mut row_start, mut columns) = (vec![0u32], Vec::with_capacity(mentions.len()));
    for i in 0..dofs {
        let mut row = mentions[count[i] as usize..count[i + 1] as usize].to_vec();
        row.push(i as u32);
        row.sort_unstable();
        row.dedup();
        columns.extend_from_slice(&row);
        row_start.push(columns.len() as u32);
    }
    Pattern { row_start, columns }
}

fn boundary_faces(space: &Space) -> Vec<BoundaryFace> {
    let mesh = space.mesh();
    let topology = mesh.topology();
    let mut faces = Vec::new();
    for edge in (0..topology.edges.len() as u32).filter(|&edge| topology.is_boundary(edge)) {
        let cell = topology.edge_triangles[edge as usize][0] as usize;
        let k = mesh.local_edge(cell, edge);
        let (dofs, nodes) = (space.element_dofs(cell), mesh.nodes(cell));
        // The film lies on the left of the way from corner k, over the middle if that is a node, to the next corner.
        let (corner, middle, next) = (k, 3 + k, (k + 1) % 3);
        let pieces: &[(usize, usize)] = match space.degree() {
            1 => &[(corner, next)],
            _ => &[(corner, middle), (middle, next)],
        };
        for &(from, to) in pieces {
            let (a, b) = (nodes[from], nodes[to]);
            let normal = [0.5 * (b[1] - a[1]), -0.5 * (b[0] - a[0])];
            for (node, share) in [(from, 0.25), (to, 0.75)] {
                faces.push(BoundaryFace {
                    dof: dofs[node],
                    cell,
                    middle: [0, 1].map(|d| a[d] + share * (b[d] - a[d])),
                    normal,
                });
            }
        }
    }
    faces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::tests::wavy_ring;

    /// Whichever corner is obtuse, the four have the area and the orientation of the whole.
    #[test]
    fn sub_triangles_fill_the_triangle() {
        let corners = [[0.0, 0.0], [1.0, 0.0], [-0.4, 0.3]];
        for turn in 0..4 {
            let points = match turn {
                3 => vec![[0.0, 0.0], [1.0, 0.0], [0.4, 0.9]],
                _ => (0..3).map(|k| corners[(k + turn) % 3]).collect(),
            };
            let raw =
                oilwedge_mesh::RawMesh { points, triangles: vec![[0, 1, 2]], ..oilwedge_mesh::RawMesh::default() };
            let mesh = Mesh::build(raw).unwrap();
            let nodes = mesh.nodes(0);
            let doubled = |[a, b, c]: [usize; 3]| {
                let [a, b, c] = [nodes[a], nodes[b], nodes[c]];
                (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            };
            let quarter = 0.25 * doubled([0, 1, 2]);
            for &sub in quarters(&mesh, 0) {
                assert!((doubled(sub) - quarter).abs() < 1e-15, "{turn}: {sub:?}");
            }
        }
    }

    #[test]
    fn addresses_hold_their_columns_and_faces_close_the_boundary() {
        for degree in [1, 2] {
            let space = Space::new(wavy_ring(7, 3), degree);
            let volumes = ControlVolumes::new(&space).unwrap();
            assert_eq!(volumes.triangles.len(), volumes.per_triangle * space.mesh().triangles().len());
            for (nodes, addresses) in volumes.triangles.iter().zip(&volumes.addresses) {
                for i in 0..3 {
                    for j in 0..3 {
                        let address = addresses[i][j] as usize;
                        assert_eq!(volumes.pattern.columns[address], nodes[j]);
                        assert!(volumes.pattern.row(nodes[i] as usize).contains(&address));
                    }
                }
            }
            // The ends of a ring face -z and +z and have its period each.
            let total = |sign: f64| {
                let faces = volumes.faces.iter().filter(|face| face.normal[1] * sign > 0.0);
                faces.map(|face| face.normal[1]).sum::<f64>()
            };
            assert!((total(1.0) - 7.0).abs() < 1e-12 && (total(-1.0) + 7.0).abs() < 1e-12);
        }
    }
}
