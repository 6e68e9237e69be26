//! Which triangle holds a point, and where in it.

use crate::Mesh;
use crate::developed::shorter_way;
use crate::mesh::quadratic_tangents;

/// A point this far outside a triangle, in reference coordinates, still counts as inside.
const OUTSIDE: f64 = 1e-9;

/// Finds points in a mesh by a grid of buckets, about one triangle each.
#[derive(Debug, Clone)]
pub struct Locator<'a> {
    mesh: &'a Mesh,
    low: [f64; 2],
    /// Size of a bucket [m].
    size: [f64; 2],
    counts: [usize; 2],
    /// Triangles that may touch bucket `b` are `members[start[b]..start[b + 1]]`.
    start: Vec<u32>,
    members: Vec<u32>,
}

impl<'a> Locator<'a> {
    /// Sorts the triangles of `mesh` into buckets.
    pub fn new(mesh: &'a Mesh) -> Self {
        let cells = mesh.triangles().len();
        let boxes: Vec<_> = (0..cells).map(|t| bounding_box(mesh, t)).collect();
        let mut low = [f64::INFINITY; 2];
        let mut high = [f64::NEG_INFINITY; 2];
        for (from, to) in &boxes {
            for k in 0..2 {
                low[k] = low[k].min(from[k]);
                high[k] = high[k].max(to[k]);
            }
        }
        if let Some(period) = mesh.period() {
            high[0] = low[0] + period;
        }
        let extent = [high[0] - low[0], high[1] - low[1]];
        let bucket = (extent[0] * extent[1] / cells as f64).sqrt();
        let counts = extent.map(|extent| ((extent / bucket) as usize).clamp(1, cells));
        let mut locator = Self {
            mesh,
            low,
            size: [extent[0] / counts[0] as f64, extent[1] / counts[1] as f64],
            counts,
            start: vec![0; counts[0] * counts[1] + 1],
            members: Vec::new(),
        };
        for span in &boxes {
            locator.each_bucket(span, |locator, bucket| locator.start[bucket + 1] += 1);
        }
        for bucket in 0..counts[0] * counts[1] {
            locator.start[bucket + 1] += locator.start[bucket];
        }
        locator.members = vec![0; locator.start[counts[0] * counts[1]] as usize];
        let mut next = locator.start.clone();
        for (t, span) in (0..).zip(&boxes) {
            locator.each_bucket(span, |locator, bucket| {
                locator.members[next[bucket] as usize] = t;
                next[bucket] += 1;
            });
        }
        locator
    }

    /// The triangle at `(x, z)` [m] and the point in its reference coordinates `(xi, eta)` (corners
    /// (0,0), (1,0), (0,1)); none outside the film. On a ring `x` counts modulo the period. On an
    /// edge one of its triangles is given.
    pub fn find(&self, point: [f64; 2]) -> Option<(usize, [f64; 2])> {
        if !point.iter().all(|x| x.is_finite()) {
            return None;
        }
        let mut from_low = [point[0] - self.low[0], point[1] - self.low[1]];
        if let Some(period) = self.mesh.period() {
            from_low[0] = from_low[0].rem_euclid(period);
        }
        let place = |k: usize| ((from_low[k] / self.size[k]).max(0.0) as usize).min(self.counts[k] - 1);
        let bucket = place(0) + self.counts[0] * place(1);
        let members = &self.members[self.start[bucket] as usize..self.start[bucket + 1] as usize];
        let mut best = (-OUTSIDE, None);
        for &t in members {
            let Some([xi, eta]) = self.invert(t as usize, point) else {
                continue;
            };
            let inside = xi.min(eta).min(1.0 - xi - eta);
            if inside >= 0.0 {
                return Some((t as usize, [xi, eta]));
            }
            if inside > best.0 {
                best = (inside, Some((t as usize, [xi, eta])));
            }
        }
        best.1
    }

    /// Reference coordinates of a point in triangle `t`: directly if it is straight, else by Newton's method.
    fn invert(&self, t: usize, point: [f64; 2]) -> Option<[f64; 2]> {
        let nodes = self.mesh.nodes(t);
        let [a, b, c] = [nodes[0], nodes[1], nodes[2]];
        let mut to_point = [point[0] - a[0], point[1] - a[1]];
        if let Some(period) = self.mesh.period() {
            to_point[0] = shorter_way(to_point[0], period);
        }
        let mut at = solve([[b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]], to_point);
        if !self.mesh.is_curved(t) {
            return Some(at);
        }
        // Far from the triangle Newton's method may go astray, and the point is not in it.
        if at[0].min(at[1]).min(1.0 - at[0] - at[1]) < -1.0 {
            return None;
        }
        for _ in 0..20 {
            let (position, tangents) = quadratic_map(&nodes, at);
            let off = [to_point[0] - (position[0] - a[0]), to_point[1] - (position[1] - a[1])];
            let step = solve(tangents, off);
            at = [at[0] + step[0], at[1] + step[1]];
            if step[0].abs() + step[1].abs() < 1e-13 {
                return Some(at);
            }
        }
        None
    }

    fn each_bucket(&mut self, (from, to): &([f64; 2], [f64; 2]), mut act: impl FnMut(&mut Self, usize)) {
        let place = |k: usize, x: f64| ((x - self.low[k]) / self.size[k]).floor() as i64;
        let columns = self.counts[0] as i64;
        let rows = self.counts[1] as i64 - 1;
        let (left, mut right) = (place(0, from[0]), place(0, to[0]));
        let ring = self.mesh.period().is_some();
        if ring {
            right = right.min(left + columns - 1);
        }
        for row in place(1, from[1]).clamp(0, rows)..=place(1, to[1]).clamp(0, rows) {
            for column in left..=right {
                let column = if ring {
                    column.rem_euclid(columns)
                } else {
                    column.clamp(0, columns - 1)
                };
                act(self, (column + columns * row) as usize);
            }
        }
    }
}

/// Corners of a box around triangle `t`, a little larger; a parabola stays in the triangle of its
/// ends and of the point twice as far out as its middle.
fn bounding_box(mesh: &Mesh, t: usize) -> ([f64; 2], [f64; 2]) {
    let nodes = mesh.nodes(t);
    let mut low = nodes[0];
    let mut high = nodes[0];
    for k in 0..3 {
        let (a, b, middle) = (nodes[k], nodes[(k + 1) % 3], nodes[3 + k]);
        for d in 0..2 {
            let control = 2.0 * middle[d] - 0.5 * (a[d] + b[d]);
            low[d] = low[d].min(b[d]).min(control);
            high[d] = high[d].max(b[d]).max(control);
        }
    }
    let margin = 10.0 * OUTSIDE * (high[0] - low[0] + high[1] - low[1]);
    (low.map(|x| x - margin), high.map(|x| x + margin))
}

/// Coefficients of `target` in the basis of two tangents.
fn solve([u, v]: [[f64; 2]; 2], target: [f64; 2]) -> [f64; 2] {
    let determinant = u[0] * v[1] - u[1] * v[0];
    [
        (target[0] * v[1] - target[1] * v[0]) / determinant,
        (u[0] * target[1] - u[1] * target[0]) / determinant,
    ]
}

/// Image of the reference point `(xi, eta)` under the quadratic map, and the tangents along both.
fn quadratic_map(nodes: &[[f64; 2]; 6], [xi, eta]: [f64; 2]) -> ([f64; 2], [[f64; 2]; 2]) {
    let zeta = 1.0 - xi - eta;
    let shape = [
        zeta * (2.0 * zeta - 1.0),
        xi * (2.0 * xi - 1.0),
        eta * (2.0 * eta - 1.0),
        4.0 * zeta * xi,
        4.0 * xi * eta,
        4.0 * eta * zeta,
    ];
    let mut position = [0.0; 2];
    for (weight, node) in shape.iter().zip(nodes) {
        position = [position[0] + weight * node[0], position[1] + weight * node[1]];
    }
    (position, quadratic_tangents(nodes, [xi, eta]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RawMesh;

    /// A ring or an arc of `n` columns and `m` rows of unit squares, one edge curved.
    fn sheet(n: u32, m: u32, ring: bool) -> Mesh {
        let columns = if ring { n } else { n + 1 };
        let vertex = |i: u32, j: u32| i % columns + columns * j;
        let points = (0..columns * (m + 1))
            .map(|v| [0.5 + f64::from(v % columns), f64::from(v / columns)])
            .collect();
        let mut triangles = Vec::new();
        for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
            let (a, b, c, d) = (vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
            triangles.extend([[a, b, c], [a, c, d]]);
        }
        let raw = RawMesh {
            points,
            triangles,
            bulges: vec![(0, 0, [0.0, 0.15]), (0, 1, [0.1, 0.02]), (5, 0, [-0.1, 0.1])],
            period: ring.then(|| f64::from(n)),
            ..RawMesh::default()
        };
        Mesh::build(raw).unwrap()
    }

    #[test]
    fn finds_what_it_maps() {
        for ring in [true, false] {
            let mesh = sheet(9, 4, ring);
            let locator = Locator::new(&mesh);
            for t in 0..mesh.triangles().len() {
                for at in [[0.2, 0.3], [0.01, 0.01], [0.01, 0.98], [1.0 / 3.0, 1.0 / 3.0]] {
                    let (mut point, _) = quadratic_map(&mesh.nodes(t), at);
                    if ring {
                        point[0] -= 27.0;
                    }
                    let (found, [xi, eta]) = locator.find(point).unwrap();
                    assert_eq!(found, t);
                    assert!((xi - at[0]).abs() + (eta - at[1]).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn outside_is_outside_and_edges_are_inside() {
        let mesh = sheet(9, 4, false);
        let locator = Locator::new(&mesh);
        for point in [
            [0.4, 2.0],
            [9.6, 2.0],
            [3.0, -0.1],
            [3.0, 4.1],
            [f64::NAN, 1.0],
            [1e300, 1.0],
        ] {
            assert!(locator.find(point).is_none(), "{point:?}");
        }
        for &point in mesh.points() {
            assert!(locator.find(point).is_some(), "{point:?}");
        }
        // The curved edge of the first triangle bends into it.
        assert!(locator.find([1.0, 0.1]).is_none());
        assert!(locator.find([1.0, 0.16]).is_some());
    }
}
