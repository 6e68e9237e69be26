//! The balance of the more accurate force: that of the film in cubic elements, where it is the one reported.
//!
//! Journal and a wall that gives way are moved together, by the tangent of the cubic film. In a rigid wall the tangent
//! of the quadratic film is a good start, for the two forces differ by a thousandth or so; each step corrects it.

use oilwedge_reynolds::solve::Neighbour;

use crate::NoEquilibrium;
use crate::balance::Balance;
use crate::coordinates::moved;
use crate::deflection::CLOSED;
use crate::equilibrium::Equilibrium;
use crate::search::{Search, Trial};

/// The balance has been found when force and load differ by this part of the load; where the wall is moved with the
/// journal, no more than this part of its deflection is left either.
const BALANCED: f64 = 1e-10;
/// Accuracy of the iterations of the cubic film.
const BALANCED_ENOUGH: f64 = 1e-8;
/// Part of a deflection that may be left at the first position, where the balance is not near.
const FIRST_CLOSED: f64 = 1e-5;
/// Part of a deflection that may be left at a later position, over the residual of the position before.
const OF_RESIDUAL: f64 = 1e-4;
/// Most positions tried.
const MOST_STEPS: usize = 12;

/// From the balance of the quadratic film to that of the cubic one.
pub(crate) fn balance_cubic(found: Balance, search: &Search) -> Result<Equilibrium, NoEquilibrium> {
    let mut tried = found.tried;
    let balance = match moved_with_wall(&found.trial, search, &mut tried) {
        None => place_by_place(found, search)?,
        Some(trial) => Balance { trial, tangent: None, tried, is_ended: false },
    };
    search.equilibrium(balance)
}

/// Journal and wall moved together; none where the wall is rigid, or the balance is not near.
fn moved_with_wall(found: &Trial, search: &Search, tried: &mut usize) -> Option<Trial> {
    found.film.problem.deflection()?;
    let place = search.coordinates.at(&found.film.problem.journal);
    let first = search.open_cubic(&found.film.problem, place, (&found.film, None)).ok()?;
    search.with_wall(first, (BALANCED, BALANCED), tried).ok()
}

/// From place to place, a wall that gives way closed at each.
fn place_by_place(found: Balance, search: &Search) -> Result<Balance, NoEquilibrium> {
    let deadline = search.options.deadline;
    let Balance { trial: found, mut tried, .. } = found;
    let near = Neighbour::Start(&found.film);
    let place = search.coordinates.at(&found.film.problem.journal);
    // What may be left of the deflection at the trial; at a rigid wall nothing is.
    let may_leave = |part: f64| found.film.problem.deflection().map_or(CLOSED, |_| CLOSED.max(part));
    let mut closed = may_leave(FIRST_CLOSED);
    let mut trial = search.cubic_trial(&found.film.problem, place, (near, None), closed)?;
    let mut residual = search.residual(&trial);
    let mut tangent = search.tangent(&trial)?;
    let mut is_exact = true;
    for _ in 0..MOST_STEPS {
        if residual < BALANCED && closed <= CLOSED || deadline.is_over() {
            break;
        }
        let step = tangent.stiffness.solve(search.excess(&trial).map(|excess| -excess));
        let place = moved(search.coordinates.at(&trial.film.problem.journal), 1.0, step);
        let near = Neighbour::Start(&trial.film);
        let bent = tangent.bent(&trial.film.problem, step);
        let next_closed = may_leave(OF_RESIDUAL * residual);
        let next = search.cubic_trial(&bent, place, (near, trial.cubic.as_ref()), next_closed)?;
        tried += 1;
        let next_residual = search.residual(&next);
        // A balance whose wall is not closed yet is none.
        if next_residual < residual || closed > CLOSED && next_residual < BALANCED_ENOUGH {
            closed = next_closed;
            tangent = search.corrected(tangent, &trial, &next);
            (trial, residual, is_exact) = (next, next_residual, false);
        } else if is_exact {
            break;
        } else {
            // Perhaps the tangent was too old.
            (tangent, is_exact) = (search.tangent(&trial)?, true);
        }
    }
    let is_ended = residual.max(closed) > BALANCED_ENOUGH && deadline.is_over();
    if residual > BALANCED_ENOUGH && !is_ended {
        return Err(search.confirmed(NoEquilibrium::NotConverged {
            asked: search.load.magnitude(),
            residual,
            journal: Box::new(trial.film.problem.journal),
            history: search.tried.take(),
        }));
    }
    Ok(Balance { trial, tangent: Some(tangent), tried, is_ended })
}
