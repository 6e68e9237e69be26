//! The processor time that an orbit will take: an estimate of its order of magnitude.
//!
//! ```text
//! seconds = cycles (films a cycle) (seconds a film)         films a cycle = 600 (1e-2/tolerance)^(1/4)
//! ```
//!
//! A film takes some four linear solves of a sparse symmetric matrix, which grow a little faster than its unknowns: 0.5
//! ms with 160 unknowns, 30 ms with 7700. Error bars take about as long as the cycles; with a balance of heat several
//! orbits are followed.

use crate::film::Film;

/// Films of a cycle at a tolerance of [`TOLERANCE`].
const FILMS: f64 = 600.0;
const TOLERANCE: f64 = 1e-2;
/// Seconds for each unknown of a film [s].
const PER_UNKNOWN: f64 = 4e-6;
/// Seconds for each unknown of a film that conserves its oil, whose matrix is not symmetric [s].
const PER_UNKNOWN_CONSERVING: f64 = 2e-5;
/// Cycles until an orbit closes, the one on a coarser mesh and the films of the error bars counted in.
const CYCLES: f64 = 4.0;
/// Orbits until heat is balanced.
const TEMPERATURES: f64 = 5.0;

/// Processor time that the orbit of a film will take, estimated [s]; none where the scene asks for no orbit.
pub fn expected_seconds(film: &Film) -> Option<f64> {
    let orbit = film.model.scope.orbit.as_ref()?;
    let per_unknown = match film.problem.cavitation.conserves_oil() {
        true => PER_UNKNOWN_CONSERVING,
        false => PER_UNKNOWN,
    };
    let films = FILMS * (TOLERANCE / orbit.tolerance).powf(0.25);
    let orbits = if film.model.sockets.finds_temperature() { TEMPERATURES } else { 1.0 };
    Some(orbits * CYCLES * films * per_unknown * film.unknowns() as f64)
}
