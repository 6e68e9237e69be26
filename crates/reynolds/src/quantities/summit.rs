//! # Where the pressure is greatest
//!
//! **Equation.** `grad p = 0` at `(R phi, z)`, or the vertex or edge at which the piecewise polynomial is greatest. A field that is off by `delta grad p` has its
//! maximum at a distance of `H^-1 delta grad p`, H the matrix of second derivatives.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | (R phi, z) | m | `position` |
//!
//! **Source.** Definition. **Range.** Not where the greatest pressure is a given one: that of a feed or an edge is not at one place. Beside the cavity of a
//! mass-conserving film the place is a node. **Verified by** `tests/tests/film_places.rs`.

use oilwedge_fem::field::Extremum;
use oilwedge_fem::mapping::Mapping;

use crate::supply::BoundaryKind;
use crate::{FilmProblem, FilmSystem};

/// A pressure that exceeds the given ones by less than this part of the range is one of them.
const ABOVE: f64 = 1e-6;

/// Below this part of the pressure that motion or given pressures make it is rounding.
const NOTHING: f64 = 1e-9;

/// The place of the greatest pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summit {
    /// Where it is [m], `(R phi, z)`.
    pub position: [f64; 2],
    /// Triangle that it is in.
    pub triangle: usize,
    /// Reference coordinates in it.
    pub point: [f64; 2],
    /// True where the greatest pressure is a given one, so that it has no place of its own.
    pub is_given: bool,
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

/// Place of the greatest value `top` of the unknown, where the least pressure is `least` [Pa].
pub(super) fn summit(problem: &FilmProblem, system: &FilmSystem, top: &Extremum, least: f64) -> Summit {
    let greatest = problem.pressure_at(top.value);
    let regions = system.supply.regions().iter();
    let given = regions.filter(|region| region.kind != BoundaryKind::Sealed);
    let given = given.map(|region| region.pressure).fold(f64::NEG_INFINITY, f64::max);
    let scale = problem.pressure_scale(&system.supply.constraints(|p| problem.unknown_at(p)));
    let rounding = NOTHING * scale;
    Summit {
        position: Mapping::of(system.space().mesh(), top.triangle).at(top.point).position,
        triangle: top.triangle,
        point: top.point,
        greatest,
        rounding,
        is_given: greatest - given <= rounding.max(ABOVE * (greatest - least)),
    }
}
