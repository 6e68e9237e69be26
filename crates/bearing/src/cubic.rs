//! The balance of the better force: a load is carried by the film in cubic elements where that is the one reported.
//!
//! The tangent of the quadratic film does to begin with, for the two forces differ by a thousandth or so; each step corrects it.

use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{CentreVelocity, FilmProblem, FilmSystem};

use crate::equilibrium::{Equilibrium, ROUGHLY_BALANCED, find_near_within, find_within, newton_step};
use crate::search::Search;
use crate::{NoEquilibrium, Patience};

/// The balance has been found when force and load differ by this part of the load.
const BALANCED: f64 = 1e-10;
/// What the iterations of the cubic film leave.
const BALANCED_ENOUGH: f64 = 1e-8;
/// Most positions tried.
const MOST_STEPS: usize = 12;

/// Finds the position in which the film in cubic elements carries `load` [N]; the quadratic one is the start. Not for
/// mass-conserving films.
///
/// # Errors
/// [`NoEquilibrium`]: the reason why there is none.
pub fn find_cubic(
    problem: &FilmProblem,
    system: &FilmSystem,
    load: [f64; 2],
    centre_velocity: CentreVelocity,
    patience: Patience,
) -> Result<Equilibrium, NoEquilibrium> {
    let found = find_within(problem, system, load, centre_velocity, patience, ROUGHLY_BALANCED)?;
    balance_cubic(found, problem, system, load, centre_velocity, patience)
}

/// The same from the position of `problem`, as [`crate::find_near`].
///
/// # Errors
/// As there.
pub fn find_cubic_near(
    problem: &FilmProblem,
    system: &FilmSystem,
    load: [f64; 2],
    centre_velocity: CentreVelocity,
    patience: Patience,
    near: Neighbour,
) -> Result<Equilibrium, NoEquilibrium> {
    let found = find_near_within(problem, system, load, centre_velocity, patience, near, ROUGHLY_BALANCED)?;
    balance_cubic(found, problem, system, load, centre_velocity, patience)
}

/// From the balance of the quadratic film to that of the cubic one.
fn balance_cubic(
    found: Equilibrium,
    problem: &FilmProblem,
    system: &FilmSystem,
    load: [f64; 2],
    centre_velocity: CentreVelocity,
    patience: Patience,
) -> Result<Equilibrium, NoEquilibrium> {
    let search = Search {
        cubic: true,
        ..Search::new(problem, system, load, centre_velocity, patience)
    };
    let mut steps = found.steps;
    let mut trial = search.trial(
        &found.problem,
        found.problem.journal.offset,
        Neighbour::Start(&found.film),
    )?;
    let mut residual = search.residual(&trial);
    let mut stiffness = search.stiffness(&trial)?;
    let mut is_exact = true;
    for _ in 0..MOST_STEPS {
        if residual < BALANCED || patience.is_over() {
            break;
        }
        let step = newton_step(stiffness, search.excess(&trial));
        let [x, y] = trial.problem.journal.offset;
        let next = search.trial_near(
            &trial.problem,
            [x + step[0], y + step[1]],
            Neighbour::Start(&trial.film),
            trial.cubic.as_ref(),
        )?;
        steps += 1;
        let next_residual = search.residual(&next);
        if next_residual < residual {
            stiffness = Search::corrected(stiffness, &trial, &next);
            (trial, residual, is_exact) = (next, next_residual, false);
        } else if is_exact {
            break;
        } else {
            // Perhaps the tangent was too old.
            (stiffness, is_exact) = (search.stiffness(&trial)?, true);
        }
    }
    let is_ended = residual > BALANCED_ENOUGH && patience.is_over();
    if residual > BALANCED_ENOUGH && !is_ended {
        return Err(search.sure(NoEquilibrium::NotConverged {
            asked: load[0].hypot(load[1]),
            residual,
            journal: Box::new(trial.problem.journal),
            history: search.tried.take(),
        }));
    }
    Ok(Equilibrium {
        residual,
        unbalanced: residual * search.natural,
        is_ended,
        stiffness,
        problem: trial.problem,
        film: trial.film,
        cubic: trial.cubic,
        steps,
    })
}
