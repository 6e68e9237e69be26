//! The balance of the more accurate force: that of the film in cubic elements, where it is the one reported.
//!
//! In a rigid wall the tangent is that of the quadratic film, whose force differs by a thousandth or so.

use crate::NoEquilibrium;
use crate::balance::JournalBalance;
use crate::equilibrium::Equilibrium;
use crate::newton::{BalanceTolerance, CUBIC_ROUNDING, Damping};
use crate::search::Search;

/// The balance has been found where less than this part of the load, and of a deflection, is left.
const BALANCED: f64 = 1e-10;

/// From the balance of the quadratic film to that of the cubic one.
pub(crate) fn balance_cubic(found: JournalBalance, search: &Search) -> Result<Equilibrium, NoEquilibrium> {
    let JournalBalance { trial, tried, .. } = found;
    let place = search.coordinates.at(&trial.film.problem.journal);
    let first = search.open_cubic(&trial.film.problem, place, (&trial.film, None))?;
    let goal =
        BalanceTolerance { balanced: BALANCED, closed: BALANCED, moved: f64::INFINITY, rounding: CUBIC_ROUNDING };
    search.equilibrium(search.balanced((first, tried), goal, Damping::None)?)
}
