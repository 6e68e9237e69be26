//! Holes and grooves: rectangles with round corners on the developed surface.
//!
//! A round hole is a square whose corners take all of it; a groove all around has no ends. One signed
//! distance serves all: with `q = |p - centre| - half + corner`,
//! `d = |max(q, 0)| + min(max(q_x, q_z), 0) - corner`.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::Circle;
use crate::developed::shorter_way;

/// A feature of a liner as it is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Feature {
    /// Name of the region in the mesh.
    pub name: String,
    /// Shape of the feature.
    pub shape: RoundedRectangle,
    /// True if its inside is meshed (a surface region), false if it is cut out (a curve region).
    pub meshed: bool,
}

/// A rectangle with round corners; lengths in m on the developed surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoundedRectangle {
    /// Centre `(x = R phi, z)`.
    pub centre: [f64; 2],
    /// Half the extent along `x` and `z`; infinite along `x` for a groove all around.
    pub half: [f64; 2],
    /// Radius of the corners, at most the lesser half extent.
    pub corner: f64,
}

/// A piece of an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum OutlinePiece {
    /// A straight line.
    Line([f64; 2], [f64; 2]),
    /// An arc of a circle, from one angle to another [rad], counter-clockwise.
    Arc(Circle, f64, f64),
}

impl RoundedRectangle {
    /// A round hole.
    pub fn disc(centre: [f64; 2], radius: f64) -> Self {
        Self { centre, half: [radius, radius], corner: radius }
    }

    /// True if it runs all around the bearing.
    pub fn is_full_turn(&self) -> bool {
        self.half[0].is_infinite()
    }

    /// Area [m2]; of a groove all around that of one turn of length `turn` [m].
    pub fn area(&self, turn: f64) -> f64 {
        let width = if self.is_full_turn() { turn } else { 2.0 * self.half[0] };
        width * 2.0 * self.half[1] - (4.0 - std::f64::consts::PI) * self.corner * self.corner
    }

    /// Distance [m] of a point from the outline, negative inside; on a ring the shorter way around.
    pub fn distance(&self, [x, z]: [f64; 2], period: Option<f64>) -> f64 {
        let along = x - self.centre[0];
        let along = period.map_or(along, |period| shorter_way(along, period));
        let across = (z - self.centre[1]).abs() - self.half[1];
        if self.is_full_turn() {
            return across;
        }
        let q = [along.abs() - self.half[0] + self.corner, across + self.corner];
        q[0].max(0.0).hypot(q[1].max(0.0)) + q[0].max(q[1]).min(0.0) - self.corner
    }

    /// Length [m] of the shortest straight side that there is; infinite if there is none.
    pub(super) fn shortest_side(&self) -> f64 {
        let sides = self.half.map(|half| 2.0 * (half - self.corner));
        sides.into_iter().filter(|&side| side > 1e-12 * self.half[1]).fold(f64::INFINITY, f64::min)
    }

    /// Middle and length [m] of the straight sides, where round corners leave any; both of each kind.
    pub(super) fn short_sides(&self) -> Vec<([f64; 2], f64)> {
        if self.is_full_turn() || self.corner == 0.0 {
            return Vec::new();
        }
        let [x, z] = self.centre;
        let [a, b] = self.half;
        let sides = [([x, z - b], a), ([x, z + b], a), ([x - a, z], b), ([x + a, z], b)];
        let lengths = sides.map(|(middle, half)| (middle, 2.0 * (half - self.corner)));
        lengths.into_iter().filter(|(_, side)| *side > 1e-12 * b).collect()
    }

    /// True if nothing of the outline is straight.
    pub(super) fn is_disc(&self) -> bool {
        self.half == [self.corner; 2]
    }

    /// Centres of the round corners.
    pub(super) fn round_corners(&self) -> Vec<[f64; 2]> {
        if self.is_full_turn() || self.corner == 0.0 {
            return Vec::new();
        }
        let [x, z] = self.centre;
        let [a, b] = self.half.map(|half| half - self.corner);
        vec![[x - a, z - b], [x + a, z - b], [x + a, z + b], [x - a, z + b]]
    }

    /// Sharp corners of the outline.
    pub(super) fn sharp_corners(&self) -> Vec<[f64; 2]> {
        if self.is_full_turn() || self.corner > 0.0 {
            return Vec::new();
        }
        let [x, z] = self.centre;
        let [a, b] = self.half;
        vec![[x - a, z - b], [x + a, z - b], [x + a, z + b], [x - a, z + b]]
    }

    /// The outline, counter-clockwise; of a groove all around the two lines from `start` over one turn.
    pub(super) fn outline(&self, start: f64, turn: f64) -> Vec<OutlinePiece> {
        let [x, z] = self.centre;
        let [a, b] = self.half;
        if self.is_full_turn() {
            let line = |z: f64| OutlinePiece::Line([start, z], [start + turn, z]);
            return vec![line(z - b), line(z + b)];
        }
        let (inner_a, inner_b) = (a - self.corner, b - self.corner);
        let mut pieces = Vec::new();
        for quarter in 0..4u8 {
            // Corners counter-clockwise from the lower right; each followed by the side after it.
            let (sx, sz) = [(1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)][usize::from(quarter)];
            let centre = [x + sx * inner_a, z + sz * inner_b];
            let from = FRAC_PI_2 * (f64::from(quarter) - 1.0);
            if self.corner > 0.0 {
                let circle = Circle { centre, radius: self.corner };
                pieces.push(OutlinePiece::Arc(circle, from, from + FRAC_PI_2));
            }
            let (next_sx, next_sz) = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)][usize::from(quarter)];
            let next = [x + next_sx * inner_a, z + next_sz * inner_b];
            // The side lies a corner radius outside of the line between the two centres.
            let out = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][usize::from(quarter)];
            let side = [centre, next].map(|p| [p[0] + self.corner * out[0], p[1] + self.corner * out[1]]);
            if (side[1][0] - side[0][0]).hypot(side[1][1] - side[0][1]) > 1e-12 * (a + b) {
                pieces.push(OutlinePiece::Line(side[0], side[1]));
            }
        }
        pieces
    }
}

impl OutlinePiece {
    /// Length [m].
    pub(super) fn length(&self) -> f64 {
        match self {
            Self::Line(a, b) => (b[0] - a[0]).hypot(b[1] - a[1]),
            Self::Arc(circle, from, to) => circle.radius * (to - from),
        }
    }

    /// The point at the fraction `s` of its length.
    pub(super) fn at(&self, s: f64) -> [f64; 2] {
        match self {
            Self::Line(a, b) => [0, 1].map(|d| if s == 1.0 { b[d] } else { a[d] + s * (b[d] - a[d]) }),
            Self::Arc(circle, from, to) => {
                let (sin, cos) = (from + s * (to - from)).sin_cos();
                [circle.centre[0] + circle.radius * cos, circle.centre[1] + circle.radius * sin]
            }
        }
    }

    /// The parts of the piece left and right of the line at `x`, cut there.
    pub(super) fn split_at(&self, x: f64) -> Vec<Self> {
        let mut cuts: Vec<f64> = match self {
            Self::Line(a, b) => vec![(x - a[0]) / (b[0] - a[0])],
            Self::Arc(circle, from, to) => {
                let cos = (x - circle.centre[0]) / circle.radius;
                let angle = cos.acos();
                let turns = [angle, -angle].map(|angle| angle + TAU * ((from - angle) / TAU).ceil());
                turns.map(|angle| (angle - from) / (to - from)).into()
            }
        };
        cuts.retain(|&s| s > 1e-9 && s < 1.0 - 1e-9);
        cuts.sort_unstable_by(f64::total_cmp);
        let ends: Vec<f64> = [0.0].into_iter().chain(cuts).chain([1.0]).collect();
        ends.windows(2).map(|pair| self.part(pair[0], pair[1], x)).collect()
    }

    /// The part between two fractions; a line's end that is cut lies on `x` exactly.
    fn part(&self, from: f64, to: f64, x: f64) -> Self {
        match self {
            Self::Line(..) => {
                let end = |s: f64| {
                    let point = self.at(s);
                    if s > 0.0 && s < 1.0 { [x, point[1]] } else { point }
                };
                Self::Line(end(from), end(to))
            }
            Self::Arc(circle, a, b) => Self::Arc(*circle, a + from * (b - a), a + to * (b - a)),
        }
    }

    /// Direction of its course at the fraction `s` of its length.
    pub(super) fn direction(&self, s: f64) -> [f64; 2] {
        match self {
            Self::Line(a, b) => [0, 1].map(|d| (b[d] - a[d]) / self.length()),
            Self::Arc(_, from, to) => {
                let (sin, cos) = (from + s * (to - from)).sin_cos();
                [-sin, cos]
            }
        }
    }

    /// Where it meets another piece, or an end of it: fractions of its length. Points nearer than `near` [m] are one.
    pub(super) fn meets(&self, other: &Self, near: f64) -> Vec<f64> {
        let crossings = match (self, other) {
            (Self::Line(a, b), Self::Line(c, d)) => lines_meet([*a, *b], [*c, *d]),
            (Self::Line(a, b), Self::Arc(circle, ..)) | (Self::Arc(circle, ..), Self::Line(a, b)) => {
                line_meets_circle([*a, *b], circle, near)
            }
            (Self::Arc(one, ..), Self::Arc(two, ..)) => circles_meet(one, two, near),
        };
        let ends = [other.at(0.0), other.at(1.0)];
        (crossings.into_iter().chain(ends))
            .filter(|&point| other.place(point, near).is_some())
            .filter_map(|point| self.place(point, near))
            .collect()
    }

    /// The fraction of its length at which a point lies on it.
    fn place(&self, point: [f64; 2], near: f64) -> Option<f64> {
        let slack = near / self.length();
        let s = match self {
            Self::Line(a, _) => {
                let ([u, v], [x, z]) = (self.direction(0.0), [point[0] - a[0], point[1] - a[1]]);
                ((x * v - z * u).abs() <= near).then(|| (x * u + z * v) / self.length())?
            }
            Self::Arc(circle, from, to) => {
                let turn = ((point[1] - circle.centre[1]).atan2(point[0] - circle.centre[0]) - from).rem_euclid(TAU);
                let turn = if turn > TAU - slack * (to - from) { turn - TAU } else { turn };
                (circle.distance(point).abs() <= near).then(|| turn / (to - from))?
            }
        };
        (s >= -slack && s <= 1.0 + slack).then(|| s.clamp(0.0, 1.0))
    }

    /// The parts of the piece between places along it (fractions, ascending); none is shorter than `near` [m].
    pub(super) fn divided(&self, places: &[f64], near: f64) -> Vec<Self> {
        let slack = near / self.length();
        let mut ends = vec![0.0];
        for &place in places {
            if place - ends[ends.len() - 1] > slack && 1.0 - place > slack {
                ends.push(place);
            }
        }
        ends.push(1.0);
        if ends.len() == 2 {
            return vec![*self];
        }
        ends.windows(2)
            .map(|pair| match self {
                Self::Line(..) => Self::Line(self.at(pair[0]), self.at(pair[1])),
                Self::Arc(circle, a, b) => Self::Arc(*circle, a + pair[0] * (b - a), a + pair[1] * (b - a)),
            })
            .collect()
    }

    /// Moved along `x`.
    pub(super) fn shifted(&self, by: f64) -> Self {
        let shift = |p: &[f64; 2]| [p[0] + by, p[1]];
        match self {
            Self::Line(a, b) => Self::Line(shift(a), shift(b)),
            Self::Arc(circle, from, to) => {
                let circle = Circle { centre: shift(&circle.centre), radius: circle.radius };
                Self::Arc(circle, *from, *to)
            }
        }
    }
}

/// The point in which two lines meet; none if they are parallel.
fn lines_meet([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
    let ([u, v], [x, z]) = ([b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]);
    let cross = u * z - v * x;
    let s = ((c[0] - a[0]) * z - (c[1] - a[1]) * x) / cross;
    match s.is_finite() {
        true => vec![[a[0] + s * u, a[1] + s * v]],
        false => Vec::new(),
    }
}

/// The points in which a line meets a circle; one where it comes as near as `near` [m] to touching it.
fn line_meets_circle([a, b]: [[f64; 2]; 2], circle: &Circle, near: f64) -> Vec<[f64; 2]> {
    let ([u, v], arm) = (OutlinePiece::Line(a, b).direction(0.0), [0, 1].map(|d| circle.centre[d] - a[d]));
    let (along, off) = (arm[0] * u + arm[1] * v, arm[0] * v - arm[1] * u);
    let half_chord = half_chord(circle.radius, off, near);
    let at = |s: f64| [a[0] + s * u, a[1] + s * v];
    half_chord.map_or(Vec::new(), |half| vec![at(along - half), at(along + half)])
}

/// The points in which two circles meet.
fn circles_meet(one: &Circle, two: &Circle, near: f64) -> Vec<[f64; 2]> {
    let [x, z] = [0, 1].map(|d| two.centre[d] - one.centre[d]);
    let apart = x.hypot(z);
    if apart <= near {
        return Vec::new();
    }
    let along = 0.5 * (apart + (one.radius - two.radius) * (one.radius + two.radius) / apart);
    let [u, v] = [x / apart, z / apart];
    let at = |across: f64| [one.centre[0] + along * u - across * v, one.centre[1] + along * v + across * u];
    half_chord(one.radius, along, near).map_or(Vec::new(), |half| vec![at(-half), at(half)])
}

/// Half the chord [m] of a circle at the distance `off` [m] from its centre: none outside, zero where it almost
/// touches.
fn half_chord(radius: f64, off: f64, near: f64) -> Option<f64> {
    let inside = radius - off.abs();
    (inside >= -near).then(|| match inside > near {
        true => (inside * (radius + off.abs())).sqrt(),
        false => 0.0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outline_lies_at_distance_zero_and_closes() {
        let shapes = [
            RoundedRectangle::disc([0.3, 0.1], 0.05),
            RoundedRectangle { centre: [0.3, 0.1], half: [0.1, 0.04], corner: 0.0 },
            RoundedRectangle { centre: [0.3, 0.1], half: [0.1, 0.04], corner: 0.02 },
            RoundedRectangle { centre: [0.3, 0.1], half: [0.1, 0.04], corner: 0.04 },
        ];
        for shape in shapes {
            let pieces = shape.outline(0.0, 1.0);
            let mut twice_area = 0.0;
            for (piece, next) in pieces.iter().zip(pieces.iter().cycle().skip(1)) {
                let (end, start) = (piece.at(1.0), next.at(0.0));
                assert!((end[0] - start[0]).hypot(end[1] - start[1]) < 1e-15);
                for k in 0..1000 {
                    let (p, q) = (piece.at(f64::from(k) / 1000.0), piece.at(f64::from(k + 1) / 1000.0));
                    assert!(shape.distance(p, Some(1.0)).abs() < 1e-15);
                    twice_area += p[0] * q[1] - p[1] * q[0];
                }
            }
            assert!((0.5 * twice_area / shape.area(1.0) - 1.0).abs() < 1e-5);
        }
    }

    #[test]
    fn a_circle_is_cut_twice() {
        let pieces = RoundedRectangle::disc([0.3, 0.1], 0.05).outline(0.0, 1.0);
        let parts: Vec<OutlinePiece> = pieces.iter().flat_map(|piece| piece.split_at(0.32)).collect();
        assert_eq!(parts.len(), 6);
        let length: f64 = parts.iter().map(OutlinePiece::length).sum();
        assert!((length - TAU * 0.05).abs() < 1e-15);
    }
}
