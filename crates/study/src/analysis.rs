//! The analysis of a film: at the position and the temperature that its scene gives, or that are found.

use crate::film::Film;
use crate::isothermal::isothermal;
use crate::no_answer::NoAnswer;
use crate::solved::{SolveOptions, Solved};
use crate::thermal;

/// Solves a film; under a load at the position found, or reached when the deadline came; with a heat balance at the
/// temperature found.
///
/// # Errors
/// [`NoAnswer`]: the reason why there is no film or no position; from near another operating point also where a cold
/// start finds an answer.
pub fn solve(film: &Film, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let sockets = &film.model.sockets;
    match (&sockets.heat_field, &sockets.thermal) {
        (Some(model), _) => thermal::field::solve(film, model, options),
        (None, Some(model)) => thermal::solve(film, model, options),
        (None, None) => isothermal(film, options),
    }
}
