//! A film at one temperature: at a given position, or at the position in which it carries a load.

use std::collections::HashMap;
use std::time::Instant;

use oilwedge_bearing::deflection::{CLOSED, FilmsOnWall, closed_film, closed_pair, following_wall};
use oilwedge_bearing::{
    Carrier, Equilibrium, Heated, InitialGuess, JournalLoad, SearchOptions, WallByPlace, Work, balance_hill, find,
    find_held,
};
use oilwedge_reynolds::error_bar::sharp;
use oilwedge_reynolds::sharp::{HillStart, SharpFilm};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{ReferenceFilm, SolvedFilm};

use crate::film::Film;
use crate::no_answer::NoAnswer;
use crate::solved::{BalanceFacts, Errors, SolveOptions, Solved};

/// Solves a film at the temperature that it has.
///
/// # Errors
/// [`NoAnswer`]: the reason why there is no film or no position.
pub fn isothermal(film: &Film, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    match film.load() {
        None => at_given_position(film, options),
        Some(load) => sought(film, Some(load), None, options),
    }
}

/// Solves a film at the temperature at which its heat is balanced.
///
/// # Errors
/// [`NoAnswer`]: the reason why none was found.
pub fn heated(film: &Film, warming: &dyn Heated, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    sought(film, film.load(), Some(warming), options)
}

fn at_given_position(film: &Film, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let near = match options.guess {
        InitialGuess::Near(near) => near,
        InitialGuess::Cold | InitialGuess::NearlyBalanced | InitialGuess::Along(_) => Neighbour::None,
    };
    if film.problem.deflection().is_some() {
        return with_wall(film, near, options.errors);
    }
    let solved = match near {
        Neighbour::None => film.problem.solve(&film.system)?,
        near => film.problem.solve_from(&film.system, near)?,
    };
    with_reference(film, solved, options.errors)
}

/// A film whose wall gives way, bent by the film that is reported.
fn with_wall(film: &Film, near: Neighbour, errors: Errors) -> Result<Solved, NoAnswer> {
    let closed = closed_film(film.problem.clone(), &film.system, near)?;
    if errors == Errors::Omitted || !film.problem.cavitation.is_symmetric() {
        return with_reference(film, closed, errors);
    }
    let clock = Instant::now();
    let FilmsOnWall { film: closed, cubic } = closed_pair(closed, None, CLOSED)?;
    Ok(Solved {
        reference: Some(ReferenceFilm::Cubic(cubic)),
        reference_seconds: clock.elapsed().as_secs_f64(),
        ..with_reference(film, closed, Errors::Omitted)?
    })
}

/// A film at the position in which it carries a load, or at its own where there is none, and at the temperature that
/// balances its heat, where that is sought.
fn sought(
    film: &Film,
    load: Option<JournalLoad>,
    warming: Option<&dyn Heated>,
    options: &SolveOptions,
) -> Result<Solved, NoAnswer> {
    let clock = Instant::now();
    let by_cubic = options.errors == Errors::Estimated && film.problem.cavitation.is_symmetric();
    let search = SearchOptions {
        accuracy: options.accuracy,
        carrier: if by_cubic { Carrier::Cubic } else { Carrier::Quadratic },
        warming,
        ..film.search_options(options.watch())
    };
    let search = match options.guess {
        InitialGuess::Cold => search,
        guess => SearchOptions { guess, ..search },
    };
    let found = match load {
        Some(load) => find(&film.problem, &film.system, load, &search),
        None => find_held(&film.problem, &film.system, &search),
    }?;
    let load = load.unwrap_or(JournalLoad::from([0.0; 2]));
    let by_film = balance(&found, load, clock);
    let solved = match found.cubic {
        None => with_reference(film, found.film, options.errors)?,
        Some(cubic) => {
            let solved = with_reference(film, found.film, Errors::Omitted)?;
            let problem = solved.film.problem.clone();
            Solved { reference: Some(ReferenceFilm::Cubic(SolvedFilm { problem, ..cubic })), ..solved }
        }
    };
    let solved = Solved { balance: Some(by_film), wall: found.wall, warming: found.warming, ..solved };
    Ok(balanced_by_hill(solved, load, &search, clock))
}

/// What two searches have cost.
fn sum(mut first: Work, second: Work) -> Work {
    first += second;
    first
}

/// How a `load` is balanced by a search that began at `clock`.
fn balance(found: &Equilibrium, load: JournalLoad, clock: Instant) -> BalanceFacts {
    let (parts, seconds) = (found.film.solution.seconds, clock.elapsed().as_secs_f64());
    BalanceFacts {
        unbalanced: found.unbalanced,
        residual: found.residual,
        parts: found.parts,
        unbalanced_moment: (load.tilting.filter(|tilting| tilting.stiffness == 0.0))
            .map(|_| found.unbalanced * found.coordinates.arm),
        coordinates: found.coordinates,
        stiffness: found.stiffness,
        steps: found.steps,
        work: found.work,
        is_ended: found.is_ended,
        is_of_hill: false,
        seconds: seconds - parts.assemble - parts.factorise - parts.solve,
    }
}

/// The film at the position in which its hill carries the load, near that which the `solved` film has found, where the
/// load is that of the hill; else that film.
fn balanced_by_hill(mut solved: Solved, load: JournalLoad, search: &SearchOptions, clock: Instant) -> Solved {
    let (Some(by_film), Some(hill)) = (solved.balance, hill_with_load(&mut solved)) else {
        return solved;
    };
    let from = (&solved.primary, hill);
    let Some((found, hill)) = balance_hill(from, load, by_film.stiffness, search) else {
        return solved;
    };
    // What the coarse comparison shows changes as little as the position.
    if let Some(ReferenceFilm::Coarse { hill: there, .. }) = &mut solved.reference {
        *there = Some(Box::new(hill));
    }
    let film = solved.film.with_journal(found.film.problem.journal);
    Solved {
        balance: Some(BalanceFacts {
            steps: by_film.steps + found.steps,
            work: sum(by_film.work, found.work),
            is_of_hill: true,
            ..balance(&found, load, clock)
        }),
        primary: film.solved_by(found.film.solution),
        film,
        ..solved
    }
}

/// The hill of a film, taken out of it, if the load of the film is that of the hill.
fn hill_with_load(solved: &mut Solved) -> Option<SharpFilm> {
    solved.balance.filter(|balance| !balance.is_ended)?;
    let Some(ReferenceFilm::Coarse { error: Some(error), hill, .. }) = &mut solved.reference else {
        return None;
    };
    let hill = hill.take_if(|hill| sharp::takes_load_of_hill(error, &solved.primary, hill));
    hill.map(|hill| *hill)
}

/// A film as it was `found`, at a given position and temperature, with its reference film if errors are estimated.
fn with_reference(film: &Film, found: SolvedFilm, errors: Errors) -> Result<Solved, NoAnswer> {
    let clock = Instant::now();
    let film = film.as_found(&found.problem);
    let primary = film.solved_by(found.solution);
    let mut reference = match errors {
        // Without the tangent of the wall nothing is known of errors.
        Errors::Estimated => match following_wall(&primary) {
            Ok(following) => primary.reference_film(following.as_ref())?,
            Err(_) => None,
        },
        Errors::Omitted => None,
    };
    // A balance of heat is that of the film.
    if let Some(ReferenceFilm::Coarse { error: Some(error), hill, .. }) =
        reference.as_mut().filter(|_| film.model.sockets.thermal.is_none())
        && sharp::is_of_use(error, &primary)
    {
        // The film stands without its hill.
        let found = primary.sharp_film(HillStart::Film);
        *hill = found.ok().flatten().map(Box::new);
    }
    Ok(Solved {
        film,
        primary,
        reference,
        balance: None,
        wall: WallByPlace::default(),
        warming: None,
        temperature: None,
        heat_bars: HashMap::new(),
        reference_seconds: clock.elapsed().as_secs_f64(),
    })
}
