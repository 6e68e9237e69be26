//! Makes a [`Mesh`] of listed triangles: orientation, numbering, edges, groups, and every defect at once.

mod checks;

use std::collections::HashMap;

use self::checks::{check_shapes, check_triangles};
use crate::defect::MOST_DEFECTS;
use crate::raw::doubled_area;
use crate::region::{circles, regions};
use crate::{Defect, Mesh, RawMesh, Topology, numbering};

/// Triangles of less area than this fraction of their longest edge squared are degenerate.
const LEAST_SHAPE: f64 = 1e-10;
/// A mid-side node within this fraction of the edge length from the middle is on the straight edge: mesh
/// generators place periodic copies to 1e-11 only.
const STRAIGHT: f64 = 1e-9;
/// Most triangles at one vertex. Edges are sought among those of a vertex, one after the other.
const MOST_AT_VERTEX: u32 = 1000;

/// Numbers that the vertices and triangles of a [`RawMesh`] are given in the mesh.
#[derive(Debug, Clone)]
pub(crate) struct Numbering {
    /// Number in the mesh of each listed vertex; `u32::MAX` for those dropped.
    pub(crate) vertex_of_listed: Vec<u32>,
    /// Place in the list of each triangle of the mesh.
    pub(crate) listed_triangle: Vec<u32>,
}

impl Mesh {
    /// Numbers, orients and checks the triangles of `raw`.
    ///
    /// Vertices that no triangle uses are dropped. If all triangles are clockwise, all are turned.
    ///
    /// # Errors
    /// Every defect found.
    pub fn build(raw: RawMesh) -> Result<Self, Vec<Defect>> {
        Ok(Self::build_numbered(raw)?.0)
    }

    /// [`Mesh::build`], and where everything went.
    pub(crate) fn build_numbered(mut raw: RawMesh) -> Result<(Self, Numbering), Vec<Defect>> {
        let defects = check_triangles(&raw);
        if !defects.is_empty() {
            return Err(defects);
        }
        orient(&mut raw);
        let mut defects = check_shapes(&raw);

        let (order, new_of_old) = order_vertices(&raw);
        let points: Vec<_> = order.iter().map(|&old| raw.points[old as usize]).collect();
        let labels: Vec<_> = order.iter().map(|&old| raw.label(old)).collect();
        let (triangles, triangle_order) = order_triangles(&raw.triangles, &new_of_old, points.len());
        let name = |vertex: u32| labels[vertex as usize];
        let same = |pair: &&[[u32; 3]]| sorted(pair[0]) == sorted(pair[1]);
        let twice = triangles.windows(2).filter(same).take(MOST_DEFECTS);
        defects.extend(twice.map(|pair| Defect::DuplicateTriangle { nodes: pair[0].map(name) }));
        let topology = match Topology::new(points.len(), &triangles) {
            Ok(topology) => topology,
            Err(crowded) => {
                let defect = |edge: [u32; 2]| Defect::CrowdedEdge { nodes: edge.map(name) };
                defects.extend(crowded.into_iter().take(MOST_DEFECTS).map(defect));
                return Err(defects);
            }
        };
        let mut triangle_of_old = vec![0u32; triangles.len()];
        for (new, &old) in triangle_order.iter().enumerate() {
            triangle_of_old[old as usize] = new as u32;
        }
        let bulges = bulged_edges(&raw, &new_of_old, &topology);
        let is_curved = |edges: &[u32; 3]| !bulges.is_empty() && edges.iter().any(|edge| bulges.contains_key(edge));
        let curved = topology.triangle_edges.iter().map(is_curved).collect();
        let regions = regions(&raw, &new_of_old, &triangle_of_old, &topology, &mut defects);
        let circles = circles(&raw, &new_of_old, &topology, &mut defects);
        let mesh = Self { points, labels, triangles, topology, bulges, curved, circles, period: raw.period, regions };
        defects.extend(mesh.folded_triangles());
        defects.extend(mesh.coincident_vertices());
        defects.extend(mesh.pieces());
        if !defects.is_empty() {
            return Err(defects);
        }
        let numbering = Numbering { vertex_of_listed: new_of_old, listed_triangle: triangle_order };
        Ok((mesh, numbering))
    }
}

/// Turns all triangles if all are clockwise.
fn orient(raw: &mut RawMesh) {
    if (0..raw.triangles.len()).all(|t| doubled_area(raw.corners(t)) < 0.0) {
        for triangle in &mut raw.triangles {
            triangle.swap(1, 2);
        }
        // Edges 01, 12, 20 become 02, 21, 10.
        for (_, edge, _) in &mut raw.bulges {
            *edge = 2 - *edge;
        }
    }
}

/// Used vertices along the Hilbert curve (`order[new] = old`) and its inverse.
fn order_vertices(raw: &RawMesh) -> (Vec<u32>, Vec<u32>) {
    let mut used = vec![false; raw.points.len()];
    for &vertex in raw.triangles.iter().flatten() {
        used[vertex as usize] = true;
    }
    let kept: Vec<u32> = (0..raw.points.len() as u32).filter(|&v| used[v as usize]).collect();
    let kept_points: Vec<_> = kept.iter().map(|&v| raw.points[v as usize]).collect();
    let order: Vec<u32> =
        numbering::hilbert_order(&kept_points).into_iter().map(|place| kept[place as usize]).collect();
    let mut new_of_old = vec![u32::MAX; raw.points.len()];
    for (new, &old) in order.iter().enumerate() {
        new_of_old[old as usize] = new as u32;
    }
    (order, new_of_old)
}

/// Triangles in the new numbers, least vertex first, sorted; and their order (`order[new] = old`).
fn order_triangles(triangles: &[[u32; 3]], new_of_old: &[u32], vertices: usize) -> (Vec<[u32; 3]>, Vec<u32>) {
    let rotated: Vec<[u32; 3]> = triangles
        .iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|v| new_of_old[v as usize]);
            match a.min(b).min(c) {
                least if least == a => [a, b, c],
                least if least == b => [b, c, a],
                _ => [c, a, b],
            }
        })
        .collect();
    let mut start = vec![0u32; vertices + 1];
    for triangle in &rotated {
        start[triangle[0] as usize + 1] += 1;
    }
    for v in 0..vertices {
        start[v + 1] += start[v];
    }
    let mut order = vec![0u32; rotated.len()];
    let mut next = start.clone();
    for (old, triangle) in rotated.iter().enumerate() {
        let place = &mut next[triangle[0] as usize];
        order[*place as usize] = old as u32;
        *place += 1;
    }
    // Within one vertex by the others, so that the numbers do not depend on the order of listing.
    for v in 0..vertices {
        order[start[v] as usize..start[v + 1] as usize].sort_unstable_by_key(|&old| sorted(rotated[old as usize]));
    }
    (order.iter().map(|&old| rotated[old as usize]).collect(), order)
}

fn bulged_edges(raw: &RawMesh, new_of_old: &[u32], topology: &Topology) -> HashMap<u32, [f64; 2]> {
    let mut bulges = HashMap::new();
    for &(t, k, bulge) in &raw.bulges {
        let triangle = raw.triangles[t as usize];
        let k = usize::from(k);
        let corners = raw.corners(t as usize);
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        if bulge[0].hypot(bulge[1]) > STRAIGHT * length {
            let [a, b] = [triangle[k], triangle[(k + 1) % 3]].map(|v| new_of_old[v as usize]);
            if let Some(edge) = topology.edge_between(a, b) {
                bulges.insert(edge, bulge);
            }
        }
    }
    bulges
}

fn sorted(mut vertices: [u32; 3]) -> [u32; 3] {
    vertices.sort_unstable();
    vertices
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raw::triangle_area;

    /// A ring of `n` columns and one row of cells, glued.
    fn ring(n: u32) -> RawMesh {
        let points = (0..2 * n).map(|k| [f64::from(k / 2), f64::from(k % 2)]).collect();
        let triangles = (0..n)
            .flat_map(|i| {
                let (a, b) = (2 * i, 2 * ((i + 1) % n));
                [[a, b, b + 1], [a, b + 1, a + 1]]
            })
            .collect();
        RawMesh { points, triangles, period: Some(f64::from(n)), ..RawMesh::default() }
    }

    #[test]
    fn ring_has_no_seam() {
        let mesh = Mesh::build(ring(8)).unwrap();
        let boundary = (0..mesh.topology().edges.len() as u32).filter(|&e| mesh.topology().is_boundary(e));
        assert_eq!(boundary.count(), 16);
        let area: f64 = (0..16).map(|t| triangle_area(mesh.corners(t))).sum();
        assert_eq!(area, 8.0);
    }

    #[test]
    fn numbers_do_not_depend_on_the_order_of_listing() {
        let mut shuffled = ring(8);
        shuffled.triangles.reverse();
        for triangle in &mut shuffled.triangles {
            triangle.rotate_left(1);
        }
        let (mesh, other) = (Mesh::build(ring(8)).unwrap(), Mesh::build(shuffled).unwrap());
        assert_eq!(mesh.triangles(), other.triangles());
        assert_eq!(mesh.points(), other.points());
    }

    #[test]
    fn clockwise_meshes_are_turned_and_mixed_ones_refused() {
        let mut clockwise = ring(8);
        clockwise.triangles.iter_mut().for_each(|triangle| triangle.swap(0, 1));
        assert!(Mesh::build(clockwise).is_ok());
        let mut mixed = ring(8);
        mixed.triangles[3].swap(0, 1);
        assert!(matches!(Mesh::build(mixed).unwrap_err()[0], Defect::Inverted { .. }));
    }

    #[test]
    fn every_defect_is_found_at_once() {
        let mut raw = ring(8);
        raw.triangles.push(raw.triangles[0]);
        raw.points.extend([[20.0, 0.0], [21.0, 0.0], [22.0, 0.0]]);
        raw.triangles.push([16, 17, 18]);
        raw.curves.push(("end".into(), vec![[0, 5]]));
        let defects = Mesh::build(raw).unwrap_err();
        assert!(defects.iter().any(|d| matches!(d, Defect::Degenerate { .. })));
        assert!(defects.iter().any(|d| matches!(d, Defect::DuplicateTriangle { .. })));
    }

    #[test]
    fn a_ring_of_two_columns_is_refused() {
        assert!(Mesh::build(ring(2)).is_err());
    }

    #[test]
    fn a_ring_cut_open_is_found_whatever_the_rounding() {
        for (start, rounding) in [(0.0, 0.0), (3.0, 1e-15), (3.0, -1e-15)] {
            let mut slit = ring(8);
            for point in &mut slit.points {
                point[0] = start + (point[0] - start).rem_euclid(8.0);
            }
            for &[x, z] in &[slit.points[0], slit.points[1]] {
                slit.points.push([x + rounding, z]);
            }
            for triangle in &mut slit.triangles[14..] {
                triangle.iter_mut().filter(|v| **v < 2).for_each(|v| *v += 16);
            }
            let defects = Mesh::build(slit).unwrap_err();
            let pairs = defects.iter().filter(|d| matches!(d, Defect::CoincidentNodes { .. }));
            assert_eq!(pairs.count(), 2);
        }
    }
}
