//! Finds the triangle that holds a point, and the place of the point in it.

mod bounds;

use self::bounds::{BoundingBox, on_turn};
use crate::Mesh;
use crate::developed::shorter_way;
use crate::mesh::quadratic_tangents;

/// A point this far outside a triangle, in reference coordinates, still counts as inside.
const OUTSIDE: f64 = 1e-9;

/// Triangles in a lowest box, and boxes in one of the next level.
const IN_A_BOX: usize = 4;

/// Finds points in a mesh by boxes around its triangles: as these are numbered along a space-filling curve, a few
/// with consecutive numbers fill a small box, a few consecutive boxes a larger one, up to one around all.
#[derive(Debug, Clone)]
pub struct Locator<'a> {
    mesh: &'a Mesh,
    /// Boxes around consecutive triangles; then, level by level, around consecutive boxes.
    levels: Vec<Vec<BoundingBox>>,
}

impl<'a> Locator<'a> {
    /// Lays boxes around the triangles of `mesh`.
    pub fn new(mesh: &'a Mesh) -> Self {
        let period = mesh.period();
        let cells = mesh.triangles().len();
        let mut level: Vec<BoundingBox> = (0..cells)
            .step_by(IN_A_BOX)
            .map(|first| {
                let members = first..cells.min(first + IN_A_BOX);
                BoundingBox::around(members.map(|t| BoundingBox::of_triangle(mesh, t)), period)
            })
            .collect();
        let mut levels = Vec::new();
        while level.len() > 1 {
            let boxes = level.chunks(IN_A_BOX);
            let next = boxes.map(|members| BoundingBox::around(members.iter().copied(), period)).collect();
            levels.push(std::mem::replace(&mut level, next));
        }
        levels.push(level);
        Self { mesh, levels }
    }

    /// The triangle at `(x, z)` [m] and the point in its reference coordinates `(xi, eta)` (corners
    /// (0,0), (1,0), (0,1)); none outside the film. On a ring `x` counts modulo the period. On an
    /// edge one of its triangles is given.
    pub fn find(&self, point: [f64; 2]) -> Option<(usize, [f64; 2])> {
        if !point.iter().all(|x| x.is_finite()) {
            return None;
        }
        let (period, on_first_turn) = (self.mesh.period(), on_turn(point, self.mesh.period()));
        let mut best = (-OUTSIDE, None);
        let mut open = Vec::with_capacity(IN_A_BOX * self.levels.len());
        open.push((self.levels.len() - 1, 0));
        while let Some((level, place)) = open.pop() {
            if level > 0 {
                let members = self.boxes(level, place).rev();
                let holding = members.filter(|member| self.levels[level - 1][*member].holds(on_first_turn, period));
                open.extend(holding.map(|member| (level - 1, member)));
                continue;
            }
            for t in self.members(place) {
                let Some([xi, eta]) = self.invert(t, point) else {
                    continue;
                };
                let inside = xi.min(eta).min(1.0 - xi - eta);
                if inside >= 0.0 {
                    return Some((t, [xi, eta]));
                }
                if inside > best.0 {
                    best = (inside, Some((t, [xi, eta])));
                }
            }
        }
        best.1
    }

    /// The triangle nearest to `(x, z)` [m] and the nearest point of it in its reference coordinates: what
    /// [`Locator::find`] gives where it finds one; outside of the film (in a cut-out, beyond a rim) the
    /// nearest point of the boundary. On a ring `x` counts modulo the period. None only if `point` is not finite.
    pub fn nearest(&self, point: [f64; 2]) -> Option<(usize, [f64; 2])> {
        if !point.iter().all(|x| x.is_finite()) {
            return None;
        }
        let found = self.find(point);
        if found.is_some() {
            return found;
        }
        let (period, on_first_turn) = (self.mesh.period(), on_turn(point, self.mesh.period()));
        let mut best = (f64::INFINITY, None);
        let mut open = vec![(0.0, self.levels.len() - 1, 0)];
        while let Some((distance, level, place)) = open.pop() {
            if distance >= best.0 && best.1.is_some() {
                continue;
            }
            if level > 0 {
                let before = open.len();
                for member in self.boxes(level, place).rev() {
                    let distance = self.levels[level - 1][member].distance(on_first_turn, period);
                    if distance <= best.0 {
                        open.push((distance, level - 1, member));
                    }
                }
                open[before..].sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
                continue;
            }
            for t in self.members(place) {
                let (distance, at) = self.to_rim(t, point);
                if distance < best.0 || best.1.is_none() {
                    best = (distance, Some((t, at)));
                }
            }
        }
        best.1
    }

    /// Boxes of the next lower level in a box.
    fn boxes(&self, level: usize, place: usize) -> std::ops::Range<usize> {
        place * IN_A_BOX..self.levels[level - 1].len().min((place + 1) * IN_A_BOX)
    }

    /// Triangles in a lowest box.
    fn members(&self, place: usize) -> std::ops::Range<usize> {
        place * IN_A_BOX..self.mesh.triangles().len().min((place + 1) * IN_A_BOX)
    }

    /// Distance [m] of a point from the edges of triangle `t`, and the nearest place on them in
    /// reference coordinates.
    fn to_rim(&self, t: usize, point: [f64; 2]) -> (f64, [f64; 2]) {
        let nodes = self.mesh.nodes(t);
        let to_edge = |k: usize| {
            let (a, b, mid) = (nodes[k], nodes[(k + 1) % 3], nodes[3 + k]);
            let middle = [0, 1].map(|d| 0.5 * (a[d] + b[d]));
            let mut arm = [point[0] - middle[0], point[1] - middle[1]];
            if let Some(period) = self.mesh.period() {
                arm[0] = shorter_way(arm[0], period);
            }
            let half = [0, 1].map(|d| 0.5 * (b[d] - a[d]));
            to_parabola(half, [0, 1].map(|d| mid[d] - middle[d]), arm)
        };
        let mut best = (f64::INFINITY, [0.0; 2]);
        for k in 0..3 {
            let (distance, along) = to_edge(k);
            if distance < best.0 {
                let s = 0.5 * (1.0 + along);
                best = (distance, [[s, 0.0], [1.0 - s, s], [0.0, 1.0 - s]][k]);
            }
        }
        best
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
}

/// Distance [m] of `point` from the edge `s half + (1 - s^2) bulge`, `s` in [-1, 1], and the nearest `s`:
/// directly if it is straight, else by the method of Gauss and Newton from the best of five.
fn to_parabola(half: [f64; 2], bulge: [f64; 2], point: [f64; 2]) -> (f64, f64) {
    let off = |s: f64| [0, 1].map(|d| point[d] - s * half[d] - (1.0 - s * s) * bulge[d]);
    let distance = |s: f64| {
        let [x, z] = off(s);
        x.hypot(z)
    };
    let nearer = |best: (f64, f64), s: f64| if distance(s) < best.0 { (distance(s), s) } else { best };
    let chord = ((point[0] * half[0] + point[1] * half[1]) / (half[0] * half[0] + half[1] * half[1])).clamp(-1.0, 1.0);
    if bulge == [0.0; 2] {
        return (distance(chord), chord);
    }
    let mut best = [-1.0, -0.5, 0.0, 0.5, 1.0].into_iter().fold((distance(chord), chord), nearer);
    for _ in 0..20 {
        let s = best.1;
        let tangent = [0, 1].map(|d| half[d] - 2.0 * s * bulge[d]);
        let [x, z] = off(s);
        let step = (x * tangent[0] + z * tangent[1]) / (tangent[0] * tangent[0] + tangent[1] * tangent[1]);
        let next = nearer(best, (s + step).clamp(-1.0, 1.0));
        if next.1 == s {
            break;
        }
        best = next;
    }
    best
}

/// Coefficients of `target` in the basis of two tangents.
fn solve([u, v]: [[f64; 2]; 2], target: [f64; 2]) -> [f64; 2] {
    let determinant = u[0] * v[1] - u[1] * v[0];
    [(target[0] * v[1] - target[1] * v[0]) / determinant, (u[0] * target[1] - u[1] * target[0]) / determinant]
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
        let points = (0..columns * (m + 1)).map(|v| [0.5 + f64::from(v % columns), f64::from(v / columns)]).collect();
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
        for point in [[0.4, 2.0], [9.6, 2.0], [3.0, -0.1], [3.0, 4.1], [f64::NAN, 1.0], [1e300, 1.0]] {
            assert!(locator.find(point).is_none(), "{point:?}");
        }
        for &point in mesh.points() {
            assert!(locator.find(point).is_some(), "{point:?}");
        }
        // The curved edge of the first triangle bends into it.
        assert!(locator.find([1.0, 0.1]).is_none());
        assert!(locator.find([1.0, 0.16]).is_some());
    }

    /// The sheet without the triangles whose centroids lie in a window.
    fn pierced(ring: bool, low: [f64; 2], high: [f64; 2]) -> Mesh {
        let whole = sheet(24, 10, ring);
        let mut raw = whole.to_raw();
        raw.bulges.clear();
        let inside = |t: usize| {
            let corners = whole.corners(t);
            let centre = [0, 1].map(|d| (corners[0][d] + corners[1][d] + corners[2][d]) / 3.0);
            let turned = [centre[0], centre[0] - 24.0];
            turned.iter().any(|x| low[0] < *x && *x < high[0]) && low[1] < centre[1] && centre[1] < high[1]
        };
        let kept = (0..raw.triangles.len()).filter(|&t| !inside(t));
        raw.triangles = kept.map(|t| raw.triangles[t]).collect();
        Mesh::build(raw).unwrap()
    }

    #[test]
    fn nearest_is_nearest_in_cut_outs_and_beyond() {
        // The second window lies across the seam of the ring.
        for (ring, low, high) in
            [(false, [5.5, 2.0], [15.5, 8.0]), (true, [-3.5, 2.0], [4.5, 8.0]), (true, [5.5, 2.0], [17.5, 8.0])]
        {
            let mesh = pierced(ring, low, high);
            let locator = Locator::new(&mesh);
            let mut outside = 0;
            for (i, j) in (-40..300).flat_map(|i| (-30..130).map(move |j| (i, j))) {
                let point = [f64::from(i) * 0.1 + 0.013, f64::from(j) * 0.1 + 0.017];
                let (t, at) = locator.nearest(point).unwrap();
                if let Some(found) = locator.find(point) {
                    assert_eq!((t, at), found);
                    continue;
                }
                outside += 1;
                assert!(at[0].min(at[1]).min(1.0 - at[0] - at[1]) >= -1e-15, "{at:?}");
                let (place, _) = quadratic_map(&mesh.nodes(t), at);
                let along = if ring { shorter_way(place[0] - point[0], 24.0) } else { place[0] - point[0] };
                let distance = along.hypot(place[1] - point[1]);
                let least = (0..mesh.triangles().len()).map(|t| locator.to_rim(t, point).0);
                let least = least.fold(f64::INFINITY, f64::min);
                assert!(distance < least + 1e-12, "{point:?}: {distance} {least}");
            }
            assert!(outside > 5000, "{outside}");
        }
    }

    #[test]
    fn nearest_to_a_curved_rim_is_on_it() {
        let mesh = sheet(9, 4, false);
        let locator = Locator::new(&mesh);
        // Below the first edge, from (0.5, 0) to (1.5, 0), which bends by 0.15: z = 0.6 s (1 - s).
        for k in 0..50 {
            let s = 0.1 + 0.8 * f64::from(k) / 50.0;
            let normal = [0.6 * (1.0 - 2.0 * s), -1.0];
            let point = [0.5 + s + 0.1 * normal[0], 0.6 * s * (1.0 - s) + 0.1 * normal[1]];
            let (t, at) = locator.nearest(point).unwrap();
            let (place, _) = quadratic_map(&mesh.nodes(t), at);
            assert!((place[0] - 0.5 - s).abs() < 1e-6, "{s}: {place:?}");
        }
        assert!(locator.nearest([f64::MAX, -f64::MAX]).is_some());
        assert!(locator.nearest([f64::NAN, 1.0]).is_none());
    }
}
