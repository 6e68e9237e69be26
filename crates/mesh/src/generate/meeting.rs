//! How the features of a liner lie to each other and to its edges: apart, touching along straight sides, or
//! overlapping.
//!
//! Straight sides may lie on one line: a pocket begins where a groove ends, or at the edge of an arc. Sides that differ
//! by rounding are moved onto one line first, so that each point of a common side is one node.

use super::shape::{Feature, OutlinePiece, RoundedRectangle};
use super::sheet::{LinerRectangle, on_sheet};
use super::union::SAME;
use crate::developed::{LinerDomain, shorter_way};

/// Straight sides within this part of the radius lie on one line: numbers of seven digits differ by less.
const ONE_LINE: f64 = 1e-6;

/// How two shapes on a liner lie to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Meeting {
    /// The two features have land between them.
    Apart,
    /// The outlines of the features meet, and no point lies in both.
    Touching,
    /// Some points lie in both.
    Overlapping,
}

/// How two shapes on a liner lie to each other, before their sides are moved onto one line.
pub fn meeting(liner: &LinerDomain, one: &RoundedRectangle, other: &RoundedRectangle) -> Meeting {
    let sheet = LinerRectangle::of(liner, 0.0);
    let are_sharp = one.corner == 0.0 && other.corner == 0.0;
    let near = if are_sharp { ONE_LINE * liner.radius } else { SAME * sheet.width };
    let [one, other] = [one, other].map(|shape| Feature { name: String::new(), shape: *shape, meshed: false });
    between(&sheet, &one, &other, near)
}

/// How two features lie to each other; points nearer than `near` [m] are one.
pub(super) fn between(sheet: &LinerRectangle, one: &Feature, other: &Feature, near: f64) -> Meeting {
    // The bounding boxes of two shapes lie apart along one axis, or they overlap.
    let gap = gaps_between(sheet, &one.shape, &other.shape).map(|[least, _]| least);
    let apart = gap[0].max(gap[1]);
    if apart > near || distance_between(sheet, one, other) > near {
        Meeting::Apart
    } else if apart >= -near {
        Meeting::Touching
    } else {
        Meeting::Overlapping
    }
}

/// Gaps [m] between the bounding boxes of two shapes along x and z, negative where they overlap: the lesser one, and on
/// a ring the one on the other side, infinite where there is none.
fn gaps_between(sheet: &LinerRectangle, one: &RoundedRectangle, other: &RoundedRectangle) -> [[f64; 2]; 2] {
    let halves = [0, 1].map(|axis| one.half[axis] + other.half[axis]);
    let between = [0, 1].map(|axis| one.centre[axis] - other.centre[axis]);
    let along = sheet.period().map_or(between[0], |period| shorter_way(between[0], period)).abs();
    let other_way = |period: f64| period - along - halves[0];
    let is_band = halves[0].is_infinite();
    let around = sheet.period().filter(|_| !is_band).map_or(f64::INFINITY, other_way);
    [[along - halves[0], around], [between[1].abs() - halves[1], f64::INFINITY]]
}

/// The narrow land [m] that two touching features leave on the other side of the ring; infinite where there is none.
pub(super) fn land_around(sheet: &LinerRectangle, one: &Feature, other: &Feature, near: f64) -> f64 {
    let [[_, around], [across, _]] = gaps_between(sheet, &one.shape, &other.shape);
    match across < -near && around.abs() > near {
        true => around,
        false => f64::INFINITY,
    }
}

/// Distance [m] between the outlines of two features; zero or less where they overlap.
pub(super) fn distance_between(sheet: &LinerRectangle, a: &Feature, b: &Feature) -> f64 {
    let to = |from: &Feature, to: &Feature| {
        outline_points(sheet, from)
            .into_iter()
            .map(|point| to.shape.distance(point, sheet.period()))
            .fold(f64::INFINITY, f64::min)
    };
    let near = SAME * sheet.width;
    let outlines = [a, b].map(|feature| on_sheet(sheet, feature));
    let meet = |piece: &OutlinePiece| outlines[1].iter().any(|other| !piece.meets(other, near).is_empty());
    let met = if outlines[0].iter().any(meet) { 0.0 } else { f64::INFINITY };
    to(a, b).min(to(b, a)).min(met)
}

/// Points along the outline of a feature, on its own turn of the ring.
pub(super) fn outline_points(sheet: &LinerRectangle, feature: &Feature) -> Vec<[f64; 2]> {
    const A_PIECE: u32 = 64;
    let pieces = feature.shape.outline(sheet.start, sheet.width);
    pieces.iter().flat_map(|piece| (0..A_PIECE).map(|k| piece.at(f64::from(k) / f64::from(A_PIECE)))).collect()
}

/// Land [m] between a feature and the edges of the liner, negative where it reaches out; on a ring also what it leaves
/// around.
pub(super) fn lands(sheet: &LinerRectangle, shape: &RoundedRectangle) -> Vec<f64> {
    let [x, z] = shape.centre;
    let [along, across] = shape.half;
    let mut lands = vec![0.5 * sheet.length - z - across, 0.5 * sheet.length + z - across];
    match (sheet.ring, shape.is_full_turn()) {
        (true, true) => {}
        (true, false) => lands.push(sheet.width - 2.0 * along),
        (false, true) => lands.push(-sheet.width),
        (false, false) => lands.extend([x - along - sheet.start, sheet.end() - x - along]),
    }
    lands
}

/// Moves straight sides that are almost on one line onto it: the edges of the liner, the axial line at `line` [m], and
/// sides of features without round corners before them.
pub(super) fn align(features: &mut [Feature], liner: &LinerDomain, line: Option<f64>) {
    let sheet = LinerRectangle::of(liner, 0.0);
    let reach = ONE_LINE * liner.radius;
    let half = 0.5 * sheet.length;
    let edges = if sheet.ring { Vec::new() } else { vec![sheet.start, sheet.end()] };
    let mut lines = [edges.into_iter().chain(line).collect::<Vec<f64>>(), vec![-half, half]];
    for feature in features.iter_mut().filter(|feature| feature.shape.corner == 0.0) {
        for (axis, lines) in lines.iter_mut().enumerate() {
            let (centre, half) = (feature.shape.centre[axis], feature.shape.half[axis]);
            if half.is_infinite() {
                continue;
            }
            let period = sheet.period().filter(|_| axis == 0);
            let onto = |side: f64| {
                let off = |line: &f64| period.map_or(line - side, |period| shorter_way(line - side, period));
                lines.iter().map(off).find(|off| off.abs() < reach)
            };
            let sides = [centre - half, centre + half];
            let moved = sides.map(onto);
            let [low, high] = [0, 1].map(|k| sides[k] + moved[k].unwrap_or(0.0));
            if moved.iter().flatten().any(|by| *by != 0.0) && low < high {
                feature.shape.centre[axis] = 0.5 * (low + high);
                feature.shape.half[axis] = 0.5 * (high - low);
            }
            lines.extend([low, high]);
        }
    }
}
