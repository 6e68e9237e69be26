//! # Where the pressure is greatest
//!
//! **Equation.** `grad p = 0` at `(R phi, z)`, or the vertex or edge at which the piecewise polynomial is greatest. A
//! field that is off by `delta grad p` has its maximum at a distance of `H^-1 delta grad p`, H the matrix of second
//! derivatives.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | (R phi, z) | m | `position` |
//!
//! **Source.** Definition. **Range.** Not where the greatest pressure is a given one: that of a feed or an edge is not
//! at one place. Beside the cavity of a mass-conserving film the place is a node. **Verified by**
//! `tests/full/tests/film_places.rs`.

use oilwedge_fem::field::Extremum;
use oilwedge_fem::mapping::Mapping;

use crate::SolvedFilm;
use crate::supply::BoundaryKind;

/// A pressure that exceeds the given ones by less than this part of the range is one of them.
const ABOVE: f64 = 1e-6;

/// Below this part of the pressure that motion or given pressures make it is rounding.
const NOTHING: f64 = 1e-9;

/// The place of the greatest pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summit {
    /// Place of the summit [m], `(R phi, z)`.
    pub position: [f64; 2],
    /// Triangle that it is in.
    pub triangle: usize,
    /// Reference coordinates in it.
    pub point: [f64; 2],
    /// True where the greatest pressure is a given one, so that it has no place of its own.
    pub is_given: bool,
    /// How far the pressure at the node nearest to the mirror image of the place, beyond the middle of the width, is
    /// below that at the node nearest to it [Pa]: a symmetric bearing with two equal summits leaves open which one is
    /// the greatest.
    pub below_here: f64,
    /// The greatest pressure [Pa], and what is rounding of it.
    greatest: f64,
    rounding: f64,
}

impl Summit {
    /// True if it is above a pressure [Pa] by more than rounding.
    pub fn is_above(&self, pressure: f64) -> bool {
        self.greatest - pressure > self.rounding
    }
}

/// Place of the greatest value `top` of the unknown of a film, where the least pressure is `least` [Pa].
pub(super) fn summit(film: &SolvedFilm, top: &Extremum, least: f64) -> Summit {
    let SolvedFilm { problem, system, solution } = film;
    let greatest = problem.pressure_at(top.value);
    let regions = system.supply.regions().iter();
    let given = regions.filter(|region| region.kind != BoundaryKind::Sealed);
    let given = given.map(|region| region.pressure).fold(f64::NEG_INFINITY, f64::max);
    let scale = problem.pressure_scale(&system.supply.constraints(|p| problem.unknown_at(p)));
    let rounding = NOTHING * scale;
    let position = Mapping::of(system.space().mesh(), top.triangle).at(top.point).position;
    let nodes = system.space().positions();
    let at = |place: [f64; 2]| problem.pressure_at(solution.unknown[nearest(&nodes, place)]);
    Summit {
        position,
        below_here: at(position) - at([position[0], -position[1]]),
        triangle: top.triangle,
        point: top.point,
        greatest,
        rounding,
        is_given: greatest - given <= rounding.max(ABOVE * (greatest - least)),
    }
}

/// Number of the place that is nearest to another one [m].
fn nearest(places: &[[f64; 2]], [x, z]: [f64; 2]) -> usize {
    let distances = places.iter().map(|at| (at[0] - x).powi(2) + (at[1] - z).powi(2));
    let nearest = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
    nearest.map_or(0, |(dof, _)| dof)
}
