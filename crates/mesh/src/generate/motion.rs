//! A mesh that moves with its drawing: a liner or a feature becomes a little larger or lies elsewhere, and vertices
//! follow. Triangles, edges and their numbers stay, so that a film on the moved mesh has the same unknowns.
//!
//! Liner and features have a map each, exact on their outlines: a rectangle with round corners is stretched between
//! its corners, which are scaled. Vertices follow the liner, and beside a feature that feature: the edge of a cavity
//! is where nodes are, and would go with them if all of the mesh moved with a feature that is far away.

use super::{Blueprint, Feature, RoundedRectangle};
use crate::developed::{LinerDomain, shorter_way};
use crate::rim::chord_bulge;
use crate::{Circle, Mesh};

/// A vertex this near to an outline lies on it, over the radius of the liner.
const ON_OUTLINE: f64 = 1e-9;
/// Vertices up to this distance move with a feature, over its lesser half extent, where nothing else is nearer. With 1
/// and 4 the derivatives of scene 17 by its groove are the same within 2 %.
const REACH: f64 = 2.0;

/// The mesh of the drawing `from` moved to the drawing `to`; `None` where the drawings have other parts, where their
/// features overlap or touch, or where the way is so long that triangles turn over.
pub fn moved(mesh: &Mesh, from: &Blueprint, to: &Blueprint) -> Option<Mesh> {
    let motion = DrawingMotion { from, to };
    if !motion.has_same_parts() {
        return None;
    }
    let points = mesh.points().iter().map(|point| motion.moved(*point)).collect::<Option<Vec<_>>>()?;
    let mut moved = Mesh { points, period: to.liner.arc.is_none().then(|| to.liner.circumference()), ..mesh.clone() };
    for (circle, _) in &mut moved.circles {
        *circle = motion.circle(circle)?;
    }
    let circles = moved.circles.clone();
    for (circle, edges) in &circles {
        for edge in edges {
            let [a, b] = moved.topology.edges[*edge as usize].map(|v| moved.points[v as usize]);
            moved.bulges.insert(*edge, chord_bulge(circle, a, b, moved.period));
        }
    }
    let is_on_circle = |edge: &u32| circles.iter().any(|(_, edges)| edges.binary_search(edge).is_ok());
    let is_upright = |t: usize| {
        let [a, b, c] = moved.corners(t);
        (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0])
    };
    (moved.bulges.keys().all(is_on_circle) && (0..moved.triangles.len()).all(is_upright)).then_some(moved)
}

/// The way from one drawing to another.
struct DrawingMotion<'a> {
    from: &'a Blueprint,
    to: &'a Blueprint,
}

impl DrawingMotion<'_> {
    fn has_same_parts(&self) -> bool {
        let (from, to) = (self.from, self.to);
        let is_alike = |(a, b): (&Feature, &Feature)| {
            let kind = |shape: &RoundedRectangle| (shape.is_full_turn(), shape.corner > 0.0, shape.is_disc());
            a.name == b.name && a.meshed == b.meshed && kind(&a.shape) == kind(&b.shape)
        };
        from.features.len() == to.features.len()
            && from.liner.arc.is_some() == to.liner.arc.is_some()
            && from.line == to.line
            && from.features.iter().zip(&to.features).all(is_alike)
    }

    /// Where a point goes; `None` on two outlines that move apart.
    fn moved(&self, point: [f64; 2]) -> Option<[f64; 2]> {
        let (from, to) = (&self.from.liner, &self.to.liner);
        let period = from.arc.is_none().then(|| from.circumference());
        let close = ON_OUTLINE * from.radius;
        let of_liner = with_liner(from, to, point);
        let to_liner = self.distance_to_liner(point);
        let distances: Vec<f64> =
            self.from.features.iter().map(|it| it.shape.distance(point, period).max(0.0)).collect();
        let mut place = of_liner;
        for (k, (a, b)) in self.from.features.iter().zip(&self.to.features).enumerate() {
            let others = distances.iter().enumerate().filter(|(other, _)| *other != k).map(|(_, distance)| *distance);
            let to_others = others.fold(to_liner, f64::min);
            let own = with_feature((&a.shape, from), (&b.shape, to), point);
            let apart = [own[0] - of_liner[0], own[1] - of_liner[1]];
            if distances[k] <= close && to_others <= close && apart.iter().any(|d| d.abs() > 1e-3 * close) {
                return None;
            }
            let reach = f64::min(REACH * a.shape.half[1].min(a.shape.half[0]), distances[k] + to_others);
            let left = if distances[k] <= close { 1.0 } else { (1.0 - distances[k] / reach).max(0.0) };
            // Smooth at both ends.
            let part = left * left * (3.0 - 2.0 * left);
            place = [place[0] + part * apart[0], place[1] + part * apart[1]];
        }
        Some(place)
    }

    /// Distance [m] from ends and edges of the liner, and from the line of a film start.
    fn distance_to_liner(&self, [x, z]: [f64; 2]) -> f64 {
        let LinerDomain { radius, length, arc } = self.from.liner;
        let ends = 0.5 * length - z.abs();
        let edges = arc.map_or(f64::INFINITY, |(low, high)| f64::min(x - radius * low, radius * high - x));
        let line = self
            .from
            .line
            .map_or(f64::INFINITY, |angle| shorter_way(x - radius * angle, self.from.liner.circumference()).abs());
        ends.min(edges).min(line).max(0.0)
    }

    /// The circle that one of the round corners becomes.
    fn circle(&self, circle: &Circle) -> Option<Circle> {
        let close = ON_OUTLINE * self.from.liner.radius;
        let period = self.from.liner.circumference();
        let is_at = |centre: &[f64; 2]| {
            shorter_way(centre[0] - circle.centre[0], period).abs() < close
                && (centre[1] - circle.centre[1]).abs() < close
        };
        self.from.features.iter().zip(&self.to.features).find_map(|(a, b)| {
            let corner = a.shape.round_corners().iter().position(is_at)?;
            let is_of_it = (a.shape.corner - circle.radius).abs() < close;
            is_of_it.then(|| Circle { centre: b.shape.round_corners()[corner], radius: b.shape.corner })
        })
    }
}

/// A point that moves with the liner: angles stay, on an arc parts of it.
fn with_liner(from: &LinerDomain, to: &LinerDomain, [x, z]: [f64; 2]) -> [f64; 2] {
    let angle = x / from.radius;
    let angle = match (from.arc, to.arc) {
        (Some((low, high)), Some((to_low, to_high))) => to_low + (angle - low) / (high - low) * (to_high - to_low),
        _ => angle,
    };
    [angle * to.radius, z * to.length / from.length]
}

/// A point that moves with a feature.
fn with_feature(
    (from, liner): (&RoundedRectangle, &LinerDomain),
    (to, to_liner): (&RoundedRectangle, &LinerDomain),
    point: [f64; 2],
) -> [f64; 2] {
    let z = to.centre[1] + stretched(point[1] - from.centre[1], (from.half[1], from.corner), (to.half[1], to.corner));
    if from.is_full_turn() {
        return [with_liner(liner, to_liner, point)[0], z];
    }
    let along = point[0] - from.centre[0];
    let turns = if liner.arc.is_some() { 0.0 } else { (along / liner.circumference()).round() };
    let along = along - turns * liner.circumference();
    let along = stretched(along, (from.half[0], from.corner), (to.half[0], to.corner));
    [to.centre[0] + along + turns * to_liner.circumference(), z]
}

/// A distance from the middle of a side, half as long as it, whose round corners take a part of both ends.
fn stretched(distance: f64, (half, corner): (f64, f64), (to_half, to_corner): (f64, f64)) -> f64 {
    let (inner, to_inner) = (half - corner, to_half - to_corner);
    let size = distance.abs();
    let moved = if size < inner {
        size * to_inner / inner
    } else if size < half {
        to_inner + (size - inner) * to_corner / corner
    } else {
        to_half + (size - half)
    };
    moved.copysign(distance)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::generate;

    fn blueprint(radius: f64, length: f64, groove: f64, hole: f64) -> Blueprint {
        let feature = |name: &str, shape| Feature { name: name.to_owned(), shape, meshed: false };
        let rounded = |angle: f64, half| RoundedRectangle { centre: [radius * angle, 0.0], half, corner: 0.5e-3 };
        Blueprint {
            liner: LinerDomain { radius, length, arc: None },
            features: vec![
                feature("groove", rounded(0.1, [8e-3, groove])),
                feature("hole", RoundedRectangle::disc([radius * 2.0, 1e-3], hole)),
            ],
            line: None,
        }
    }

    /// Rims, mid-side nodes and ends of the moved mesh lie on the outlines of the new drawing, to round-off.
    #[test]
    fn vertices_lie_on_the_outlines_of_the_new_drawing() {
        let (from, to) = (blueprint(25e-3, 20e-3, 1.5e-3, 2e-3), blueprint(25.1e-3, 20.2e-3, 1.6e-3, 1.95e-3));
        let mesh = generate(&from, &|_| 2e-3).expect("a mesh");
        let moved = moved(&mesh, &from, &to).expect("a moved mesh");
        assert_eq!(moved.triangles(), mesh.triangles());
        assert_eq!(moved.period(), Some(to.liner.circumference()));
        for feature in &to.features {
            let region = moved.region(&feature.name).expect("a region");
            for edge in &region.edges {
                for node in moved.edge_nodes(*edge) {
                    let off = feature.shape.distance(node, moved.period());
                    assert!(off.abs() < 1e-12, "{}: {off:e}", feature.name);
                }
            }
        }
        let highest = moved.points().iter().map(|point| point[1]).fold(0.0, f64::max);
        assert!((highest - 10.1e-3).abs() < 1e-15, "{highest:e}");
    }

    #[test]
    fn drawings_of_other_parts_have_no_motion() {
        let from = blueprint(25e-3, 20e-3, 1.5e-3, 2e-3);
        let mesh = generate(&from, &|_| 2e-3).expect("a mesh");
        let fewer = Blueprint { features: from.features[..1].to_vec(), ..from.clone() };
        assert!(moved(&mesh, &from, &fewer).is_none());
        // The hole would lie in the groove.
        let mut far = from.clone();
        far.features[1].shape.centre = far.features[0].shape.centre;
        assert!(moved(&mesh, &from, &far).is_none());
    }
}
