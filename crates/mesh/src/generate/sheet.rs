//! The rectangle that is triangulated, and the outlines of features laid on it.

use super::shape::{Feature, OutlinePiece};
use crate::developed::LinerDomain;

/// Coordinates that differ by less than this part of the length are one.
const SAME: f64 = 1e-9;

/// The rectangle that is triangulated.
#[derive(Debug, Clone, Copy)]
pub(super) struct LinerRectangle {
    pub(super) start: f64,
    pub(super) width: f64,
    pub(super) length: f64,
    pub(super) ring: bool,
}

impl LinerRectangle {
    pub(super) fn of(liner: &LinerDomain, start: f64) -> Self {
        match liner.arc {
            Some((from, to)) => Self {
                start: liner.radius * from,
                width: liner.radius * (to - from),
                length: liner.length,
                ring: false,
            },
            None => Self { start, width: liner.circumference(), length: liner.length, ring: true },
        }
    }

    pub(super) fn period(&self) -> Option<f64> {
        self.ring.then_some(self.width)
    }

    pub(super) fn end(&self) -> f64 {
        self.start + self.width
    }

    /// Whether a piece of the outline of a feature lies on an edge of the sheet: on an end or, on an arc, on one of its
    /// edges. A meshed feature may also begin or end at the seam of a ring, which is a line of edges.
    fn has_on_edge(&self, piece: &OutlinePiece, meshed: bool) -> bool {
        let (near, half) = (SAME * self.length, 0.5 * self.length);
        let points = [0.0, 0.5, 1.0].map(|s| piece.at(s));
        let is_on = |axis: usize, line: f64| points.iter().all(|point| (point[axis] - line).abs() < near);
        let is_on_side = is_on(0, self.start) || is_on(0, self.end());
        is_on(1, -half) || is_on(1, half) || ((meshed || !self.ring) && is_on_side)
    }

    /// Distance [m] from the ends and, on an arc, its edges; negative outside.
    pub(super) fn margin(&self, [x, z]: [f64; 2]) -> f64 {
        let ends = 0.5 * self.length - z.abs();
        if self.ring { ends } else { ends.min(x - self.start).min(self.end() - x) }
    }
}

/// The outline of a feature laid on the sheet: on a ring cut at its sides.
pub(super) fn on_sheet(sheet: &LinerRectangle, feature: &Feature) -> Vec<OutlinePiece> {
    let pieces = feature.shape.outline(sheet.start, sheet.width);
    let is_inside = |piece: &OutlinePiece| !sheet.has_on_edge(piece, feature.meshed);
    if !sheet.ring || feature.shape.is_full_turn() {
        return pieces.into_iter().filter(is_inside).collect();
    }
    let middle = sheet.start + 0.5 * sheet.width;
    let turns = ((middle - feature.shape.centre[0]) / sheet.width).round();
    pieces
        .iter()
        .map(|piece| piece.shifted(turns * sheet.width))
        .flat_map(|piece| piece.split_at(sheet.start))
        .flat_map(|piece| piece.split_at(sheet.end()))
        .map(|piece| match piece.at(0.5)[0] {
            x if x < sheet.start => piece.shifted(sheet.width),
            x if x > sheet.end() => piece.shifted(-sheet.width),
            _ => piece,
        })
        .filter(is_inside)
        .collect()
}
