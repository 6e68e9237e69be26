//! The rectangle that is triangulated, and the outlines of features laid on it.

use super::shape::{Feature, Piece, Shape};
use crate::developed::Liner;

/// Coordinates that differ by less than this part of the length are one.
const SAME: f64 = 1e-9;

/// The rectangle that is triangulated.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sheet {
    pub(super) start: f64,
    pub(super) width: f64,
    pub(super) length: f64,
    pub(super) ring: bool,
}

impl Sheet {
    pub(super) fn of(liner: &Liner, start: f64) -> Self {
        match liner.arc {
            Some((from, to)) => Self {
                start: liner.radius * from,
                width: liner.radius * (to - from),
                length: liner.length,
                ring: false,
            },
            None => Self {
                start,
                width: liner.circumference(),
                length: liner.length,
                ring: true,
            },
        }
    }

    pub(super) fn period(&self) -> Option<f64> {
        self.ring.then_some(self.width)
    }

    pub(super) fn end(&self) -> f64 {
        self.start + self.width
    }

    /// Whether a shape reaches from one end to the other, with straight sides.
    pub(super) fn is_spanned_by(&self, shape: &Shape) -> bool {
        let off = (shape.half[1] - 0.5 * self.length).abs() + shape.centre[1].abs();
        shape.corner == 0.0 && !shape.is_full_turn() && off < SAME * self.length
    }

    /// Distance [m] from the ends and, on an arc, its edges; negative outside.
    pub(super) fn margin(&self, [x, z]: [f64; 2]) -> f64 {
        let ends = 0.5 * self.length - z.abs();
        if self.ring {
            ends
        } else {
            ends.min(x - self.start).min(self.end() - x)
        }
    }
}

/// The outline of a feature laid on the sheet: on a ring cut at its sides.
pub(super) fn on_sheet(sheet: &Sheet, feature: &Feature) -> Vec<Piece> {
    let is_on_end = |piece: &Piece| {
        let off = |s: f64| (piece.at(s)[1].abs() - 0.5 * sheet.length).abs();
        [0.0, 0.5, 1.0].into_iter().all(|s| off(s) < SAME * sheet.length)
    };
    let mut pieces = feature.shape.outline(sheet.start, sheet.width);
    pieces.retain(|piece| !is_on_end(piece));
    if !sheet.ring || feature.shape.is_full_turn() {
        return pieces;
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
        .collect()
}
