//! Defects of a mesh: of its list of triangles, of their shapes, and of the film as a whole.

use super::{LEAST_SHAPE, MOST_AT_VERTEX};
use crate::defect::MOST_DEFECTS;
use crate::mesh::least_jacobian;
use crate::raw::triangle_area;
use crate::topology::NO_TRIANGLE;
use crate::{Defect, Mesh, RawMesh};

/// Defects that forbid any further work: nothing there, not finite, a vertex named twice.
pub(super) fn check_triangles(raw: &RawMesh) -> Vec<Defect> {
    if raw.triangles.is_empty() {
        return vec![Defect::Empty];
    }
    let bad_points = (0u32..).zip(&raw.points).filter(|(_, point)| !point.iter().all(|x| x.is_finite()));
    let mut defects: Vec<_> = bad_points
        .take(MOST_DEFECTS)
        .map(|(v, point)| Defect::NotFinite { node: raw.label(v), coordinates: point.to_vec() })
        .collect();
    let repeats = |&&[a, b, c]: &&[u32; 3]| a == b || b == c || c == a;
    let repeated = raw.triangles.iter().filter(repeats).take(MOST_DEFECTS);
    defects.extend(repeated.map(|nodes| Defect::RepeatedNode { nodes: nodes.map(|v| raw.label(v)) }));
    let mut at_vertex = vec![0u32; raw.points.len()];
    raw.triangles.iter().flatten().for_each(|&v| at_vertex[v as usize] += 1);
    let crowded = (0u32..).zip(&at_vertex).filter(|(_, count)| **count > MOST_AT_VERTEX);
    defects.extend(crowded.take(MOST_DEFECTS).map(|(v, &triangles)| Defect::CrowdedNode {
        node: raw.label(v),
        triangles,
        most: MOST_AT_VERTEX,
    }));
    defects
}

/// Degenerate and inverted triangles, and those that span too much of a ring.
pub(super) fn check_shapes(raw: &RawMesh) -> Vec<Defect> {
    let mut defects = Vec::new();
    for t in 0..raw.triangles.len() {
        if defects.len() >= MOST_DEFECTS {
            break;
        }
        let corners = raw.corners(t);
        let nodes = || raw.triangles[t].map(|v| raw.label(v));
        let [x, z] = corners[0];
        // Squared.
        let longest = (0..3)
            .map(|k| {
                let (a, b) = (corners[k], corners[(k + 1) % 3]);
                (b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)
            })
            .fold(0.0, f64::max);
        let area = triangle_area(corners);
        if area.abs() <= LEAST_SHAPE * longest {
            defects.push(Defect::Degenerate { nodes: nodes(), x, z, area });
        } else if area < 0.0 {
            defects.push(Defect::Inverted { nodes: nodes(), x, z });
        }
        if let Some(period) = raw.period {
            let xs = corners.map(|corner| corner[0]);
            let span = xs.iter().copied().fold(f64::MIN, f64::max) - xs.iter().copied().fold(f64::MAX, f64::min);
            if span > 0.49 * period {
                defects.push(Defect::SpansRing { nodes: nodes(), degrees: 360.0 * span / period });
            }
        }
    }
    defects
}

impl Mesh {
    /// Curved triangles whose quadratic map folds.
    pub(super) fn folded_triangles(&self) -> Vec<Defect> {
        (0..self.triangles.len())
            .filter(|&t| self.curved[t] && least_jacobian(&self.nodes(t)) <= 0.0)
            .take(MOST_DEFECTS)
            .map(|t| {
                let [x, z] = self.corners(t)[0];
                Defect::Inverted { nodes: self.triangles[t].map(|v| self.label(v)), x, z }
            })
            .collect()
    }

    /// Boundary vertices at one place: the film is cut open there.
    pub(super) fn coincident_vertices(&self) -> Vec<Defect> {
        let mut rim: Vec<u32> = (0..self.topology.edges.len() as u32)
            .filter(|&edge| self.topology.is_boundary(edge))
            .flat_map(|edge| self.topology.edges[edge as usize])
            .collect();
        rim.sort_unstable();
        rim.dedup();
        let (mut extent, mut start) = (0.0f64, f64::INFINITY);
        for &v in &rim {
            let [x, z] = self.points[v as usize];
            extent = extent.max(x.abs()).max(z.abs());
            start = start.min(x);
        }
        let near = 1e-10 * extent;
        let at = |v: u32| {
            let [x, z] = self.points[v as usize];
            let period = self.period.filter(|period| x - start > period - near);
            [x - period.unwrap_or(0.0), z]
        };
        rim.sort_unstable_by(|&a, &b| at(a)[0].total_cmp(&at(b)[0]).then(a.cmp(&b)));
        // Among those at one x, up to rounding, neighbours in z.
        let mut defects = Vec::new();
        for column in rim.chunk_by_mut(|&a, &b| at(b)[0] - at(a)[0] <= near) {
            column.sort_unstable_by(|&a, &b| at(a)[1].total_cmp(&at(b)[1]).then(a.cmp(&b)));
            let pairs = column.windows(2).filter(|pair| at(pair[1])[1] - at(pair[0])[1] <= near);
            defects.extend(pairs.take(MOST_DEFECTS.saturating_sub(defects.len())).map(|pair| {
                Defect::CoincidentNodes {
                    first: self.label(pair[0]),
                    second: self.label(pair[1]),
                    x: self.points[pair[0] as usize][0],
                    z: self.points[pair[0] as usize][1],
                }
            }));
        }
        defects
    }

    /// The defect of a film in several pieces, if it is. Pieces that reach from end to end are the lands between
    /// grooves of full length.
    pub(super) fn pieces(&self) -> Option<Defect> {
        let mut piece_of = vec![u32::MAX; self.triangles.len()];
        let mut sizes: Vec<(usize, usize)> = Vec::new();
        let mut stack = Vec::new();
        for seed in 0..self.triangles.len() {
            if piece_of[seed] != u32::MAX {
                continue;
            }
            let piece = sizes.len() as u32;
            sizes.push((0, seed));
            piece_of[seed] = piece;
            stack.push(seed);
            while let Some(t) = stack.pop() {
                sizes[piece as usize].0 += 1;
                for edge in self.topology.triangle_edges[t] {
                    for side in self.topology.edge_triangles[edge as usize] {
                        if side != NO_TRIANGLE && piece_of[side as usize] == u32::MAX {
                            piece_of[side as usize] = piece;
                            stack.push(side as usize);
                        }
                    }
                }
            }
        }
        let mut reached = [vec![false; sizes.len()], vec![false; sizes.len()]];
        for (reached, end) in reached.iter_mut().zip(["end_low", "end_high"]) {
            for &edge in self.region(end).map_or(&[][..], |region| &region.edges) {
                let triangle = self.topology.edge_triangles[edge as usize][0];
                reached[piece_of[triangle as usize] as usize] = true;
            }
        }
        if sizes.len() < 2 || (0..sizes.len()).all(|piece| reached[0][piece] && reached[1][piece]) {
            return None;
        }
        let &(cells, seed) = sizes.iter().min()?;
        let [x, z] = self.corners(seed)[0];
        Some(Defect::Disconnected { parts: sizes.len(), cells, x, z })
    }
}
