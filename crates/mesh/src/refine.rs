//! Refinement by halving edges: red, green and blue, with the longest edge halved first.
//!
//! ```text
//!     whole           green            blue             blue             red
//!       2               2                2                2                2
//!      / \             /|\              /|\              /|\              / \
//!     /   \           / | \            / | 4            5 | \            5---4
//!    /     \         /  |  \          /  |/ \          / \|  \          / \ / \
//!   0-------1       0---3---1        0---3---1        0---3---1        0---3---1
//! ```
//! Here 01 is the longest edge; red is the same from all sides.
//!
//! A triangle that is asked for has its three edges halved; a triangle of which any edge is halved has its
//! longest halved too. The least angle of repeated refinement stays above half of the first (Rosenberg and
//! Stenger for halving the longest edge, Rivara for the four triangles; for their mixture the tests measure it).
//!
//! The geometry is kept: a new vertex is the mid-side node of the edge that it halves. If that edge
//! lies on a known circle, the vertex and the mid-side nodes of both halves are put on the circle; else the
//! halves are those of the parabola. New edges inside a triangle are straight.
//!
//! Sources: I. G. Rosenberg, F. Stenger, A lower bound on the angles of triangles constructed by bisecting
//! the longest side, Math. Comp. 29 (1975) 390-395; M.-C. Rivara, Algorithms for refining triangular grids
//! suitable for adaptive and multigrid techniques, Int. J. Numer. Meth. Engng 20 (1984) 745-756;
//! C. Carstensen, An adaptive mesh-refining algorithm allowing for an H1 stable L2 projection onto Courant
//! finite element spaces, Constr. Approx. 20 (2004) 549-564 (red, green, blue).

use crate::build::Numbering;
use crate::rim::{chord_bulge, shift_onto};
use crate::topology::NO_TRIANGLE;
use crate::{Circle, Defect, Mesh, RawMesh};

/// Marks an edge that stays whole.
const WHOLE: u32 = u32::MAX;
/// A refined mesh and where its triangles come from.
#[derive(Debug, Clone)]
pub struct Refined {
    /// The finer mesh; regions, circles and the names of vertices are inherited.
    pub mesh: Mesh,
    /// Place in the coarser mesh of each triangle of the finer one.
    pub lineage: Vec<Child>,
}

/// Place of a triangle in its parent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Child {
    /// Triangle of the coarser mesh.
    pub parent: u32,
    /// Reference coordinates `(xi, eta)` in the parent of the corners, in their order in the finer mesh.
    pub corners: [[f64; 2]; 3],
}

/// Divides each triangle into four.
///
/// # Errors
/// Triangles that fold, where a rim is too coarse for its curvature.
pub fn uniform(mesh: &Mesh) -> Result<Refined, Vec<Defect>> {
    divide(mesh, &vec![true; mesh.topology().edges.len()])
}

/// Divides the marked triangles into four and as many others as it takes that no vertex hangs on an edge.
///
/// `marked` has one entry a triangle; entries that are missing count as false.
///
/// # Errors
/// Triangles that fold, where a rim is too coarse for its curvature.
pub fn local(mesh: &Mesh, marked: &[bool]) -> Result<Refined, Vec<Defect>> {
    divide(mesh, &closure(mesh, marked))
}

/// Which edges to halve so that the marked triangles are divided into four, and of each
/// triangle with a halved edge the longest.
fn closure(mesh: &Mesh, marked: &[bool]) -> Vec<bool> {
    let topology = mesh.topology();
    let mut halved = vec![false; topology.edges.len()];
    let mut stack: Vec<u32> = Vec::new();
    let mut halve = |edge: u32, stack: &mut Vec<u32>| {
        if !std::mem::replace(&mut halved[edge as usize], true) {
            let sides = topology.edge_triangles[edge as usize];
            stack.extend(sides.iter().filter(|&&t| t != NO_TRIANGLE));
        }
    };
    let marked = topology.triangle_edges.iter().zip(marked).filter(|(_, marked)| **marked);
    for &edge in marked.flat_map(|(edges, _)| edges) {
        halve(edge, &mut stack);
    }
    while let Some(t) = stack.pop() {
        let edges = topology.triangle_edges[t as usize];
        halve(edges[longest_edge(mesh, t as usize)], &mut stack);
    }
    halved
}

/// The longest edge of a triangle by its chord; of equal ones that of the greatest number.
fn longest_edge(mesh: &Mesh, t: usize) -> usize {
    let corners = mesh.corners(t);
    let edges = mesh.topology().triangle_edges[t];
    // Rounding must not tell equal edges apart, or a pattern would not repeat itself.
    let longer = |k: usize, than: usize| {
        let (a, b) = (squared_length(corners, k), squared_length(corners, than));
        a > b * (1.0 + 1e-9) || (a > b * (1.0 - 1e-9) && edges[k] > edges[than])
    };
    (1..3).fold(0, |longest, k| if longer(k, longest) { k } else { longest })
}

/// Square [m2] of the chord of local edge `k`.
fn squared_length(corners: [[f64; 2]; 3], k: usize) -> f64 {
    let (a, b) = (corners[k], corners[(k + 1) % 3]);
    (b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)
}

/// Children in the local nodes of their parent: corners 0 1 2, mid-side nodes 3 4 5 of edges 01, 12,
/// 20, of which 01 is halved first.
fn pattern(halved: [bool; 3]) -> &'static [[u8; 3]] {
    match halved {
        [true, true, true] => &[[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]],
        [true, true, false] => &[[0, 3, 2], [3, 1, 4], [3, 4, 2]],
        [true, false, true] => &[[0, 3, 5], [5, 3, 2], [3, 1, 2]],
        [true, false, false] => &[[0, 3, 2], [3, 1, 2]],
        // Closed marks halve no other edge without the first.
        [false, _, _] => &[[0, 1, 2]],
    }
}

/// Reference coordinates of the local nodes.
const REFERENCE: [[f64; 2]; 6] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]];

/// New vertices and triangles, before they are numbered.
struct TriangleDivision<'a> {
    mesh: &'a Mesh,
    /// New vertex of each edge, or [`WHOLE`].
    middle: Vec<u32>,
    /// The circle on which each edge lies.
    circle: Vec<Option<&'a Circle>>,
    /// Children of triangle `t` are `first[t]..first[t + 1]`.
    first: Vec<u32>,
    /// Parent of each child.
    parents: Vec<u32>,
    /// Nodes of each child in the local numbers of its parent.
    local: Vec<[u8; 3]>,
    /// Vertices of each child.
    triangles: Vec<[u32; 3]>,
}

/// Halves the edges so marked: in each triangle none, or the longest and any others.
fn divide(mesh: &Mesh, halved: &[bool]) -> Result<Refined, Vec<Defect>> {
    let division = TriangleDivision::new(mesh, halved);
    let mut raw = mesh.to_raw();
    division.add_vertices(&mut raw);
    raw.bulges = division.bulges(&raw);
    for pairs in raw.curves.iter_mut().map(|(_, pairs)| pairs) {
        *pairs = division.halves(pairs);
    }
    for pairs in raw.circles.iter_mut().map(|(_, pairs)| pairs) {
        *pairs = division.halves(pairs);
    }
    for cells in raw.surfaces.iter_mut().map(|(_, cells)| cells) {
        *cells = cells.iter().flat_map(|&t| division.children(t)).collect();
    }
    raw.triangles.clone_from(&division.triangles);
    let (finer, numbering) = Mesh::build_numbered(raw)?;
    let lineage = division.lineage(&finer, &numbering);
    Ok(Refined { mesh: finer, lineage })
}

impl<'a> TriangleDivision<'a> {
    fn new(mesh: &'a Mesh, halved: &[bool]) -> Self {
        let mut vertices = mesh.points.len() as u32;
        let mut number = |halved: bool| {
            vertices += u32::from(halved);
            if halved { vertices - 1 } else { WHOLE }
        };
        let middle: Vec<u32> = halved.iter().map(|&halved| number(halved)).collect();
        let mut circle = vec![None; halved.len()];
        for (known, edges) in &mesh.circles {
            edges.iter().for_each(|&edge| circle[edge as usize] = Some(known));
        }
        let mut division = Self {
            mesh,
            middle,
            circle,
            first: vec![0],
            parents: Vec::new(),
            local: Vec::new(),
            triangles: Vec::new(),
        };
        for t in 0..mesh.triangles.len() {
            division.divide_triangle(t);
        }
        division
    }

    fn divide_triangle(&mut self, t: usize) {
        let [a, b, c] = self.mesh.triangles[t];
        let middles = self.mesh.topology.triangle_edges[t].map(|edge| self.middle[edge as usize]);
        let nodes = [a, b, c, middles[0], middles[1], middles[2]];
        let halved = middles.map(|middle| middle != WHOLE);
        let alike = halved[0] == halved[1] && halved[1] == halved[2];
        let turn = if alike { 0 } else { longest_edge(self.mesh, t) };
        for child in pattern([0, 1, 2].map(|k| halved[(k + turn) % 3])) {
            let local = child.map(|node| node / 3 * 3 + (node + turn as u8) % 3);
            self.local.push(local);
            self.triangles.push(local.map(|node| nodes[usize::from(node)]));
            self.parents.push(t as u32);
        }
        self.first.push(self.triangles.len() as u32);
    }

    fn children(&self, t: u32) -> std::ops::Range<u32> {
        self.first[t as usize]..self.first[t as usize + 1]
    }

    /// Puts a vertex on each halved edge: its mid-side node, on the circle if the edge is on one.
    fn add_vertices(&self, raw: &mut RawMesh) {
        let start = raw.points.iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
        let name = raw.labels.iter().copied().max().unwrap_or(0);
        for (edge, &[a, b]) in self.mesh.topology.edges.iter().enumerate() {
            if self.middle[edge] == WHOLE {
                continue;
            }
            let [mut a, mut b] = [a, b].map(|v| raw.points[v as usize]);
            let across = |period: &f64| (a[0] - b[0]).abs() > 0.5 * period;
            if let Some(period) = raw.period.filter(across) {
                let lower = if a[0] < b[0] { &mut a } else { &mut b };
                lower[0] += period;
            }
            let bulge = self.mesh.bulge(edge as u32);
            let mut point = [0, 1].map(|d| 0.5 * (a[d] + b[d]) + bulge[d]);
            if let Some(circle) = self.circle[edge] {
                let shift = shift_onto(circle, point, raw.period);
                point = [point[0] + shift[0], point[1] + shift[1]];
            }
            if let Some(period) = raw.period.filter(|period| !(start..start + period).contains(&point[0])) {
                point[0] = start + (point[0] - start).rem_euclid(period);
            }
            raw.points.push(point);
            raw.labels.push(name.saturating_add(raw.points.len() as u64));
        }
    }

    /// Bulges of the children: of a whole edge its own; of a half that of the circle, or a quarter.
    fn bulges(&self, raw: &RawMesh) -> Vec<(u32, u8, [f64; 2])> {
        let mut bulges = Vec::new();
        for &(t, k, bulge) in &raw.bulges {
            let edge = self.mesh.topology.triangle_edges[t as usize][usize::from(k)] as usize;
            for [a, b] in self.parts(edge as u32) {
                let bulge = match self.circle[edge] {
                    _ if self.middle[edge] == WHOLE => bulge,
                    Some(circle) => {
                        let [a, b] = [a, b].map(|v| raw.points[v as usize]);
                        chord_bulge(circle, a, b, raw.period)
                    }
                    None => [0.25 * bulge[0], 0.25 * bulge[1]],
                };
                for child in self.children(t) {
                    let triangle = self.triangles[child as usize];
                    let side = |k: usize| [triangle[k], triangle[(k + 1) % 3]];
                    let place = (0..3).find(|&k| side(k) == [a, b] || side(k) == [b, a]);
                    bulges.extend(place.map(|k| (child, k as u8, bulge)));
                }
            }
        }
        bulges
    }

    /// The ends of an edge, or of its two halves.
    fn parts(&self, edge: u32) -> impl Iterator<Item = [u32; 2]> {
        let [a, b] = self.mesh.topology.edges[edge as usize];
        let middle = self.middle[edge as usize];
        let (first, second) = if middle == WHOLE { ([a, b], None) } else { ([a, middle], Some([middle, b])) };
        std::iter::once(first).chain(second)
    }

    /// What becomes of a set of edges.
    fn halves(&self, pairs: &[[u32; 2]]) -> Vec<[u32; 2]> {
        let edges = pairs.iter().filter_map(|&[a, b]| self.mesh.topology.edge_between(a, b));
        edges.flat_map(|edge| self.parts(edge)).collect()
    }

    /// Where each triangle of the finer mesh lies, its corners in the order that they have there.
    fn lineage(&self, finer: &Mesh, numbering: &Numbering) -> Vec<Child> {
        let triangles = finer.triangles.iter().zip(&numbering.listed_triangle);
        triangles
            .map(|(triangle, &listed)| {
                let listed = listed as usize;
                let numbered = self.triangles[listed].map(|v| numbering.vertex_of_listed[v as usize]);
                let corner = |v: u32| {
                    let place = (0..3).find(|&k| numbered[k] == v).unwrap_or(0);
                    REFERENCE[usize::from(self.local[listed][place])]
                };
                Child { parent: self.parents[listed], corners: triangle.map(corner) }
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quality::triangle_area;
    use crate::raw::doubled_area;

    /// One triangle, its edges of all lengths in the order of `turn`.
    fn triangle(turn: usize) -> Mesh {
        let mut points = vec![[0.0, 0.0], [4.0, 0.0], [1.0, 2.0]];
        points.rotate_left(turn);
        Mesh::build(RawMesh {
            points,
            triangles: vec![[0, 1, 2]],
            bulges: vec![(0, 0, [0.0, -0.1]), (0, 1, [0.2, 0.1])],
            curves: vec![("side".to_owned(), vec![[1, 2]])],
            surfaces: vec![("pad".to_owned(), vec![0])],
            ..RawMesh::default()
        })
        .unwrap()
    }

    #[test]
    fn every_pattern_fills_its_parent() {
        for halved in [[true, true, true], [true, true, false], [true, false, true], [true, false, false], [false; 3]] {
            let double = |[a, b, c]: [u8; 3]| doubled_area([a, b, c].map(|node| REFERENCE[usize::from(node)]));
            let areas = pattern(halved).iter().map(|&child| double(child));
            assert!(areas.clone().all(|area| area > 0.0));
            assert_eq!(areas.sum::<f64>(), 1.0);
            assert_eq!(pattern(halved).len(), 1 + halved.iter().filter(|halved| **halved).count());
        }
    }

    #[test]
    fn edges_in_any_order_are_halved_and_inherited() {
        for turn in 0..3 {
            let mesh = triangle(turn);
            let longest = mesh.topology.triangle_edges[0][longest_edge(&mesh, 0)];
            let side = mesh.region("side").unwrap().edges[0];
            for marks in 0..8u32 {
                let halved: Vec<bool> = (0..3).map(|edge| edge == longest || marks >> edge & 1 == 1).collect();
                let finer = divide(&mesh, &halved).unwrap().mesh;
                let count = halved.iter().filter(|halved| **halved).count();
                assert_eq!(finer.triangles.len(), 1 + count);
                assert_eq!(finer.region("pad").unwrap().cells.len(), 1 + count);
                assert_eq!(finer.region("side").unwrap().edges.len(), 1 + usize::from(halved[side as usize]));
                // Halves of a parabola bound the same area as the whole.
                let area: f64 = (0..=count).map(|t| triangle_area(&finer, t)).sum();
                assert!((area - triangle_area(&mesh, 0)).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn nothing_marked_changes_nothing() {
        let mesh = triangle(0);
        let same = local(&mesh, &[]).unwrap();
        assert_eq!(same.mesh.points, mesh.points);
        assert_eq!(same.lineage.len(), 1);
        assert_eq!(same.lineage[0].corners, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    }
}
