//! A film at one temperature: at a given position, or at the position in which it carries a load.

use std::time::Instant;

use oilwedge_bearing::{Carrier, InitialGuess, Load, SearchObserver, SearchOptions, find};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmSolution, ReferenceFilm};

use crate::film::Film;
use crate::no_answer::NoAnswer;
use crate::solved::{Balance, Errors, SolveOptions, Solved};

/// Solves a film at the temperature that it has.
///
/// # Errors
/// [`NoAnswer`]: the reason why there is no film or no position.
pub fn isothermal(film: &Film, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    match film.load {
        None => at_given_position(film, options),
        Some(load) => under_load(film, load, options),
    }
}

fn at_given_position(film: &Film, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let solution = match options.guess {
        InitialGuess::Near(near @ (Neighbour::Start(_) | Neighbour::Kept(_))) => {
            film.problem.solve_from(&film.system, near)?
        }
        InitialGuess::Cold | InitialGuess::NearlyBalanced | InitialGuess::Near(Neighbour::None) => {
            film.problem.solve(&film.system)?
        }
    };
    with_reference(film.clone(), solution, options.errors)
}

fn under_load(film: &Film, load: Load, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let clock = Instant::now();
    let by_cubic = options.errors == Errors::Estimated && film.problem.cavitation.is_symmetric();
    let search = SearchOptions {
        accuracy: options.accuracy,
        carrier: if by_cubic { Carrier::Cubic } else { Carrier::Quadratic },
        observer: options.observer.map(|observer| observer as &dyn SearchObserver),
        ..film.search_options(options.deadline)
    };
    let search = match options.guess {
        InitialGuess::Cold => search,
        guess => SearchOptions { guess, ..search },
    };
    let found = find(&film.problem, &film.system, load, &search)?;
    let (parts, seconds) = (found.film.seconds, clock.elapsed().as_secs_f64());
    let balance = Balance {
        unbalanced: found.unbalanced,
        residual: found.residual,
        parts: found.parts,
        unbalanced_moment: (load.tilting.filter(|tilting| tilting.stiffness == 0.0))
            .map(|_| found.unbalanced * found.coordinates.arm),
        coordinates: found.coordinates,
        stiffness: found.stiffness,
        steps: found.steps,
        is_ended: found.is_ended,
        seconds: seconds - parts.assemble - parts.factorise - parts.solve,
    };
    let film = film.with_journal(found.problem.journal);
    let solved = match found.cubic {
        None => with_reference(film, found.film, options.errors)?,
        cubic => Solved {
            reference: cubic.map(ReferenceFilm::Cubic),
            ..with_reference(film, found.film, Errors::Omitted)?
        },
    };
    Ok(Solved {
        balance: Some(balance),
        ..solved
    })
}

/// A solved film at a given position and temperature, with its reference film if errors are estimated.
fn with_reference(film: Film, solution: FilmSolution, errors: Errors) -> Result<Solved, NoAnswer> {
    let clock = Instant::now();
    let reference = match errors {
        Errors::Estimated => film.problem.reference_film(&film.system, &solution)?,
        Errors::Omitted => None,
    };
    Ok(Solved {
        film,
        solution,
        reference,
        balance: None,
        temperature: None,
        reference_seconds: clock.elapsed().as_secs_f64(),
    })
}
