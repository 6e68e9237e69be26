//! The balance of a moment that no start leads to at once: the moment grows from nothing, each balance the start of the next.

use oilwedge_reynolds::FilmProblem;

use crate::equilibrium::Equilibrium;
use crate::estimate::is_contact;
use crate::search::Search;
use crate::{InitialGuess, Load, NoEquilibrium, SearchOptions, find};

/// First part of what tilts the journal by which it grows.
const FIRST: f64 = 0.25;
/// Shortest part.
const SHORTEST: f64 = 2e-3;
/// Growth of the parts after a balance.
const GROWTH: f64 = 1.6;
/// A film that has lost so much of the clearance at an end, when the moment grows no more, is one in contact there.
const NEAR_CONTACT: f64 = 0.05;
/// With such a film the parts are not made shorter.
const AT_CONTACT: f64 = 1e-3;

impl Search<'_> {
    /// Balances the force alone, and then the moment by parts.
    pub(crate) fn by_parts_of_tilting(&self, problem: &FilmProblem) -> Result<Equilibrium, NoEquilibrium> {
        let straight = Load {
            tilting: None,
            ..self.load
        };
        let options = SearchOptions {
            guess: InitialGuess::Cold,
            ..self.options
        };
        let mut found = find(problem, self.system, straight, &options)?;
        let (mut reached, mut part) = (0.0, FIRST);
        loop {
            let next = f64::min(reached + part, 1.0);
            let search = Search::new(problem, self.system, self.load.with_part_of_tilting(next), self.options);
            match search.run(&found.problem, found.problem.journal) {
                Ok(balanced) if next == 1.0 => return Ok(balanced),
                // The best position so far, judged by the whole load.
                Ok(balanced) if balanced.is_ended => return self.run(problem, balanced.problem.journal),
                Ok(balanced) if !is_contact(&balanced.problem.bearing, &balanced.problem.journal) => {
                    (found, reached, part) = (balanced, next, GROWTH * part);
                }
                _ if part > SHORTEST && gap(&found) > AT_CONTACT && !self.options.deadline.is_over() => part *= 0.5,
                outcome => {
                    let reason = || self.in_contact(&found, reached);
                    let is_near = gap(&found) < NEAR_CONTACT && !self.options.deadline.is_over();
                    return outcome
                        .and_then(|_| Err(reason()))
                        .map_err(|other| if is_near { reason() } else { other });
                }
            }
        }
    }

    /// That the journal comes into contact with the liner at an end when this part of what tilts it is balanced.
    pub(crate) fn in_contact(&self, found: &Equilibrium, carried: f64) -> NoEquilibrium {
        let place = found.problem.bearing.thinnest(&found.problem.journal);
        NoEquilibrium::EdgeContact {
            asked: self.load.magnitude(),
            carried,
            end: place.z,
            angle: place.angle.to_degrees().rem_euclid(360.0),
            thickness: place.thickness,
            journal: Box::new(found.problem.journal),
        }
    }
}

/// Least film over the clearance.
fn gap(found: &Equilibrium) -> f64 {
    let bearing = &found.problem.bearing;
    bearing.least_gap(&found.problem.journal) / bearing.clearance
}
