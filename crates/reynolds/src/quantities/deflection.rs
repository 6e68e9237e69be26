//! # Greatest deflection of the wall
//!
//! **Equation.** `delta_max = max d(phi, z)` over the triangles of the film, between nodes by the polynomial through
//! them.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d | m | [`crate::film_thickness::Deflection`] |
//!
//! **Source.** Definition. **Range.** Walls whose deflection the triangles resolve. **Verified by**
//! `tests/tests/liner`.

use oilwedge_fem::Field;

use crate::{FilmProblem, FilmSystem};

/// Greatest deflection outwards [m]; none of a rigid wall.
pub fn deflection_max(problem: &FilmProblem, system: &FilmSystem) -> Option<f64> {
    let deflection = problem.deflection()?;
    let space = system.space();
    let values: Vec<f64> = space.positions().into_iter().map(|place| deflection.at(place)).collect();
    Some(Field { space, values: &values }.maximum().value)
}
