//! Edge flips to a Delaunay mesh: the two angles that face an inner edge then add up to pi at most.
//!
//! ```text
//!        r                    r
//!       / \                  /|\
//!      / t \                / | \
//!     p-----q      ->      p t|u q
//!      \ u /                \ | /
//!       \ /                  \|/
//!        s                    s
//! ```
//! The stiffness of linear triangles then couples no two vertices inside the film with the wrong sign, and the
//! least angle is the greatest that these vertices allow. Vertices, the boundary and named edges stay as they are,
//! and so do edges between different surfaces, on circles, and edges that bulge. Curved triangles are flipped
//! where they stay far from folding.
//!
//! Source: C. L. Lawson, Software for C1 surface interpolation, in: J. R. Rice (ed.), Mathematical Software III,
//! Academic Press 1977, 161-194.

use std::collections::HashMap;

use crate::mesh::least_jacobian;
use crate::raw::{doubled_area, triangle_area};
use crate::{Mesh, RawMesh, Topology};

/// Edges flip if the sine of the sum of the angles that face them is less than this below zero: those of four
/// points on a circle must not flip for ever.
const FACING: f64 = 1e-10;
/// Flips make no triangle of less area than this fraction of its longest edge squared.
const LEAST_SHAPE: f64 = 1e-9;
/// Flips bring the least Jacobian of a curved triangle over twice its area not below this, or the present one.
const LEAST_JACOBIAN: f64 = 0.5;
/// Flips make no triangle that spans more than this part of a ring.
const LONGEST_SPAN: f64 = 0.49;
/// Flips end after so many an edge.
const MOST_FLIPS: usize = 100;

/// A mesh with flipped edges, and where its triangles come from.
#[derive(Debug, Clone)]
pub struct Flipped {
    /// The mesh: vertices, boundary, circles and named edges of the one before.
    pub mesh: Mesh,
    /// Triangle of the mesh before for each triangle: it belongs to the same surfaces, and is itself if it is an old
    /// one.
    pub parents: Vec<u32>,
    /// Number of flips.
    pub flips: usize,
}

/// Flips edges until the mesh is Delaunay, but for the edges that must stay; `kept` lists further ones that must.
///
/// None if there is nothing to flip.
pub fn to_delaunay(mesh: &Mesh, kept: &[u32]) -> Option<Flipped> {
    let mut flipper = Flipper::new(mesh, kept);
    let flips = flipper.run();
    if flips == 0 {
        return None;
    }
    let (mesh, numbering) = Mesh::build_numbered(flipper.raw()).ok()?;
    Some(Flipped { mesh, parents: numbering.listed_triangle, flips })
}

/// Triangles and edges between flips. Edges that stay keep their numbers; a flipped one takes its number along.
struct Flipper<'a> {
    mesh: &'a Mesh,
    triangles: Vec<[u32; 3]>,
    /// The three edges of each triangle.
    edges: Vec<[u32; 3]>,
    /// The triangles on both sides of each edge.
    sides: Vec<[u32; 2]>,
    /// Edges that must not flip.
    fixed: Vec<bool>,
}

/// An edge with its two triangles.
struct FlipPair {
    /// The triangles on both sides.
    triangles: [usize; 2],
    /// Ends p and q of the edge, then the corners r and s that face it, as in the picture above.
    corners: [u32; 4],
    /// Places of the corners [m], side by side.
    places: [[f64; 2]; 4],
    /// Edges qr, rp of the first triangle, and ps, sq of the second.
    edges: [u32; 4],
}

impl<'a> Flipper<'a> {
    fn new(mesh: &'a Mesh, kept: &[u32]) -> Self {
        let topology = mesh.topology();
        let surfaces = surfaces(mesh);
        let between = |sides: &[u32; 2]| surfaces[sides[0] as usize] != surfaces[sides[1] as usize];
        let mut fixed: Vec<bool> = (0u32..)
            .zip(&topology.edge_triangles)
            .map(|(edge, sides)| topology.is_boundary(edge) || between(sides))
            .collect();
        let named = mesh.regions().iter().flat_map(|region| &region.edges);
        let on_circles = mesh.circles().iter().flat_map(|(_, edges)| edges);
        for &edge in named.chain(on_circles).chain(mesh.bulges.keys()).chain(kept) {
            fixed[edge as usize] = true;
        }
        let Topology { triangle_edges, edge_triangles, .. } = topology;
        Self {
            mesh,
            triangles: mesh.triangles().to_vec(),
            edges: triangle_edges.clone(),
            sides: edge_triangles.clone(),
            fixed,
        }
    }

    /// Flips until no edge wants to; returns how often.
    fn run(&mut self) -> usize {
        let count = self.fixed.len();
        let mut open: Vec<u32> = (0..count as u32).rev().collect();
        let mut is_open = vec![true; count];
        let mut flips = 0;
        while let Some(edge) = open.pop() {
            is_open[edge as usize] = false;
            if self.fixed[edge as usize] || flips == MOST_FLIPS * count {
                continue;
            }
            let pair = self.pair(edge);
            if !(pair.is_wrong() && self.allows(&pair)) {
                continue;
            }
            self.flip(edge, &pair);
            flips += 1;
            for other in pair.edges {
                if !std::mem::replace(&mut is_open[other as usize], true) {
                    open.push(other);
                }
            }
        }
        flips
    }

    /// An inner edge with its two triangles.
    fn pair(&self, edge: u32) -> FlipPair {
        let [t, u] = self.sides[edge as usize].map(|t| t as usize);
        let local = |t: usize| (0..3).find(|&k| self.edges[t][k] == edge).unwrap_or(0);
        let (k, l) = (local(t), local(u));
        let around = [0, 1, 2].map(|step| self.triangles[t][(k + step) % 3]);
        let corners = [around[0], around[1], around[2], self.triangles[u][(l + 2) % 3]];
        let places = self.side_by_side(corners);
        let edge_of = |t: usize, k: usize| self.edges[t][k % 3];
        FlipPair {
            triangles: [t, u],
            corners,
            places,
            edges: [edge_of(t, k + 1), edge_of(t, k + 2), edge_of(u, l + 1), edge_of(u, l + 2)],
        }
    }

    /// Places [m] of four vertices, on a ring each at its shorter way from the first.
    fn side_by_side(&self, corners: [u32; 4]) -> [[f64; 2]; 4] {
        let mut places = corners.map(|v| self.mesh.points()[v as usize]);
        if let Some(period) = self.mesh.period() {
            let first = places[0][0];
            for place in &mut places {
                let along = place[0] - first;
                if along.abs() > 0.5 * period {
                    place[0] -= period.copysign(along);
                }
            }
        }
        places
    }

    /// True if both triangles are sound after the flip.
    fn allows(&self, pair: &FlipPair) -> bool {
        let [p, q, r, s] = pair.places;
        let sound = |corners| is_sound(corners, self.mesh.period());
        if !(sound([p, s, r]) && sound([s, q, r])) {
            return false;
        }
        let [on_qr, on_rp, on_ps, on_sq] = pair.edges.map(|edge| self.mesh.bulge(edge));
        let straight = [0.0; 2];
        if [on_qr, on_rp, on_ps, on_sq] == [straight; 4] {
            return true;
        }
        let before = relative_jacobian([p, q, r], [straight, on_qr, on_rp]);
        let before = before.min(relative_jacobian([q, p, s], [straight, on_ps, on_sq]));
        let after = relative_jacobian([p, s, r], [on_ps, straight, on_rp]);
        let after = after.min(relative_jacobian([s, q, r], [on_sq, on_qr, straight]));
        after >= before.min(LEAST_JACOBIAN)
    }

    fn flip(&mut self, edge: u32, pair: &FlipPair) {
        let [t, u] = pair.triangles;
        let [p, q, r, s] = pair.corners;
        let [qr, rp, ps, sq] = pair.edges;
        self.triangles[t] = [p, s, r];
        self.edges[t] = [ps, edge, rp];
        self.triangles[u] = [s, q, r];
        self.edges[u] = [sq, qr, edge];
        self.hand_over(ps, u, t);
        self.hand_over(qr, t, u);
    }

    /// An edge of one triangle becomes one of another.
    fn hand_over(&mut self, edge: u32, from: usize, to: usize) {
        for side in &mut self.sides[edge as usize] {
            if *side == from as u32 {
                *side = to as u32;
            }
        }
    }

    /// The mesh as a file would list it.
    fn raw(self) -> RawMesh {
        let mut raw = self.mesh.to_raw();
        raw.bulges.clear();
        for (&edge, &bulge) in &self.mesh.bulges {
            let t = self.sides[edge as usize][0];
            let place = (0..3).find(|&k| self.edges[t as usize][k] == edge);
            raw.bulges.extend(place.map(|k| (t, k as u8, bulge)));
        }
        raw.triangles = self.triangles;
        raw
    }
}

impl FlipPair {
    /// True if the angles that face the edge add up to more than pi.
    fn is_wrong(&self) -> bool {
        let [p, q, r, s] = self.places;
        let (first, second) = (facing(r, p, q), facing(s, q, p));
        let sine = first[0] * second[1] + first[1] * second[0];
        sine < -FACING * first[0].hypot(first[1]) * second[0].hypot(second[1])
    }
}

/// Sine and cosine of the angle at `apex` from `from` to `to`, times both distances [m2].
fn facing(apex: [f64; 2], from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let (a, b) = ([from[0] - apex[0], from[1] - apex[1]], [to[0] - apex[0], to[1] - apex[1]]);
    [a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]]
}

/// True if three corners make a triangle that a mesh may have.
fn is_sound(corners: [[f64; 2]; 3], period: Option<f64>) -> bool {
    let (mut longest, mut span) = (0.0f64, 0.0f64);
    for k in 0..3 {
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        longest = longest.max((b[0] - a[0]).hypot(b[1] - a[1]));
        span = span.max((b[0] - a[0]).abs());
    }
    let fits = period.is_none_or(|period| span < LONGEST_SPAN * period);
    fits && triangle_area(corners) > LEAST_SHAPE * longest * longest
}

/// Least Jacobian of a triangle with bulging edges 01, 12, 20 over that of the straight one.
fn relative_jacobian(corners: [[f64; 2]; 3], bulges: [[f64; 2]; 3]) -> f64 {
    let mut nodes = [[0.0; 2]; 6];
    for k in 0..3 {
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        nodes[k] = a;
        nodes[3 + k] = [0, 1].map(|d| 0.5 * (a[d] + b[d]) + bulges[k][d]);
    }
    least_jacobian(&nodes) / doubled_area(corners)
}

/// A number for each triangle that it shares with those that belong to the same surfaces.
fn surfaces(mesh: &Mesh) -> Vec<u32> {
    let mut numbers = vec![0u32; mesh.triangles().len()];
    let mut used = 0;
    for region in mesh.regions() {
        let mut within: HashMap<u32, u32> = HashMap::new();
        for &t in &region.cells {
            let number = &mut numbers[t as usize];
            *number = *within.entry(*number).or_insert_with(|| {
                used += 1;
                used
            });
        }
    }
    numbers
}
