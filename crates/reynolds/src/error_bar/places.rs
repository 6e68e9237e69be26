//! Bars of places in a mass-conserving film: of the greatest pressure, and of the ends of the loaded film.
//!
//! The coarse comparison has sub-triangles twice as wide. An end of the film is off by the difference of the two and by
//! a sub-triangle; the greatest pressure by the difference, and by part of a triangle, for pressures are linear on its
//! pieces.

use super::Bar;
use crate::SolvedFilm;
use crate::quantities::extent::{Extent, extent};
use crate::quantities::pressure::extremes;

/// Weights in the bars of places of the width of a triangle: at an end of the film, and at the greatest pressure.
const SUB_TRIANGLE: f64 = 0.5;
const AT_SUMMIT: f64 = 0.6;

/// Half widths of bars of places.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Places {
    /// Bar of the place of the greatest pressure [m], around and along the axis.
    pub summit: [f64; 2],
    /// Bars of the upstream and the downstream end of the loaded film [m]; none where only one film has them.
    pub extent: Option<[Bar; 2]>,
}

/// Bars by a film and its `coarse` comparison; `part` is that of every bar for oil that triangles spread.
pub(super) fn places(films: [&SolvedFilm; 2], part: f64) -> Places {
    let SolvedFilm { problem, system, .. } = films[0];
    let summits = films.map(|film| extremes(film).summit);
    let extents = films.map(|film| extent(film, &extremes(film)));
    let radius = problem.bearing.radius;
    let apart = |a: f64, b: f64| problem.bearing.around(a, b).abs();
    let corners = system.space().mesh().corners(summits[0].triangle);
    let width = |axis: usize| {
        let sides = (0..3).map(|k| (corners[k][axis] - corners[(k + 1) % 3][axis]).abs());
        sides.fold(0.0, f64::max)
    };
    let [a, b] = summits.map(|summit| summit.position);
    let end = |pair: [&Extent; 2], of: fn(&Extent) -> (f64, f64)| {
        let [(x, unsure), (other, _)] = pair.map(of);
        Bar {
            discretisation: apart(x, other),
            front: SUB_TRIANGLE * unsure,
            transport: part * radius,
            ..Bar::default()
        }
    };
    Places {
        summit: [
            apart(a[0], b[0]).max(AT_SUMMIT * width(0)) + part * radius,
            (a[1] - b[1]).abs().max(AT_SUMMIT * width(1)) + part * radius,
        ],
        extent: match &extents {
            [Some(fine), Some(coarse)] => Some([
                end([fine, coarse], |extent| (extent.begins.x, extent.begins.unsure)),
                end([fine, coarse], |extent| (extent.ends.x, extent.ends.unsure)),
            ]),
            _ => None,
        },
    }
}
