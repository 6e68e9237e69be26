//! # Continuation: a balance that no start leads to at once, along a branch of balances and around its folds
//!
//! **Equation.** With the difference R of forces and load and the first balance x_0 of the branch,
//! `R(x) = (1 - part) R(x_0)`: x_0 at `part = 0`, the balance of the load at `part = 1`. Where the tilt is free, x_0
//! balances the force alone, and the moment grows along the branch; where it is given, x_0 balances a part of the load,
//! and the load grows. Where a film resists no more, the part has a greatest value and falls beyond it. So steps are
//! taken along the length of the branch, in clearances and parts, and corrected across it.
//!
//! **Source.** Keller, in: Applications of Bifurcation Theory, Academic Press (1977) 359 (continuation by arc length).
//! **Verified by** `tests/tests/tilt/balance.rs`, `tests/tests/equilibrium.rs`.

mod error;
mod start;

use std::rc::Rc;

use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, NoFilm};

use crate::balance::JournalBalance;
use crate::coordinates::{Vector, length, moved};
use crate::coupled::{FilmSolve, Tangents};
use crate::deflection::Moves;
use crate::equilibrium::ROUGHLY_BALANCED;
use crate::no_equilibrium::{BranchEnd, BranchLimit, SearchEnd, Waypoint};
use crate::search::{Search, Trial};
use crate::{NoEquilibrium, Purpose};

/// First step along the branch.
const FIRST: f64 = 0.25;
/// Growth of the steps where they are corrected quickly.
const GROWTH: f64 = 1.6;
/// Corrections that count as quick, and most corrections of one step.
const CORRECTIONS: [usize; 2] = [3, 5];
/// The two numbers of corrections under a wall that gives way, where each film is a correction.
const CORRECTIONS_WITH_WALL: [usize; 2] = [6, 9];
/// Part of what the branch balances, or of the load, that a point of the branch may leave in a wall that gives way.
const ON_BRANCH: f64 = 1e-3;
/// Part of the deflection that a point of the branch may leave.
const CLOSED_ON_BRANCH: f64 = 1e-2;
/// Accuracy of the linear systems of film and wall.
const FOLLOWED: f64 = 1e-3;
/// Least film after a step over that before.
const LEAST_SHRINK: f64 = 0.3;
/// A step this much shorter than the least film over the clearance leads no further.
const SHORTEST: f64 = 0.1;
/// Points of a branch at most.
const MOST_POINTS: usize = 60;
/// A branch whose part has fallen by so much from its greatest value does not return.
const FALLEN: f64 = 0.5;
/// A film that has lost so much of the clearance at an end, where the branch cannot be followed further, is one in
/// contact there.
const NEAR_CONTACT: f64 = 0.05;
/// A finer mesh begins where the film on the coarser one was still this part of the clearance.
const WAYPOINT: f64 = 0.02;
/// A finer mesh begins where the part that is balanced still grew by so much of its first growth.
const AHEAD: f64 = 0.3;
/// In a wall that gives way a film thinner than this part of the clearance is left to a finer mesh.
const LEFT_TO_FINER: f64 = 0.01;

/// A point of the branch.
struct BranchPoint {
    trial: Trial,
    /// How journal and wall move with the part.
    ahead: Moves,
    part: f64,
}

/// A direction of the branch, one long: changes of the coordinates and of the wall [m], and of the part.
#[derive(Clone)]
struct Direction {
    moves: Moves,
    part: f64,
}

/// The branch of one search.
struct Branch<'a, 'b> {
    search: &'a Search<'b>,
    /// Difference of forces and load at its beginning [N].
    first: Vector,
    clearance: f64,
}

impl Search<'_> {
    /// The reason that a branch ends with the film of a problem, at which this part of what grows is balanced.
    pub(crate) fn branch_end(
        &self,
        problem: &FilmProblem,
        limit: BranchLimit,
        (carried, error): (f64, Option<f64>),
        way: Option<Waypoint>,
    ) -> NoEquilibrium {
        let FilmProblem { journal, bearing, .. } = problem;
        let place = self.gap_under(problem).thinnest(journal);
        let [x, y] = self.load.force;
        let degrees = |angle: f64| angle.to_degrees().rem_euclid(360.0);
        NoEquilibrium::Branch(Box::new(BranchEnd {
            limit,
            is_tilting: self.load.tilting.is_some(),
            asked: [self.load.magnitude(), degrees(y.atan2(x))],
            carried,
            error,
            z: place.z,
            angle: degrees(place.angle),
            thickness: place.thickness,
            eccentricity: journal.eccentricity() / bearing.clearance,
            journal: *journal,
            way,
        }))
    }
}

impl Branch<'_, '_> {
    /// The balance at the end of the branch.
    fn followed(&self, first: BranchPoint) -> Result<JournalBalance, NoEquilibrium> {
        let search = self.search;
        let mut here = Rc::new(first);
        let mut way: Option<Direction> = None;
        let mut wanted = FIRST;
        // The point with the greatest part.
        let mut greatest = Rc::clone(&here);
        let mut waypoint = self.waypoint(&here);
        let mut first_part = None;
        for _ in 0..MOST_POINTS {
            let Some(along) = self.direction(&here, way.as_ref()) else {
                break;
            };
            let is_ahead = along.part > AHEAD * *first_part.get_or_insert(along.part);
            if is_ahead && self.gap(&here.trial) > WAYPOINT {
                waypoint = self.waypoint(&here);
            }
            if along.part < 0.0 && here.part < greatest.part - FALLEN {
                way = Some(along);
                break;
            }
            let next = self.next(&here, &along, &mut wanted);
            way = Some(along);
            let Some(next) = next else { break };
            match next {
                BranchStep::Contact(problem) => {
                    return Err(search.branch_end(&problem, BranchLimit::Contact, (1.0, None), Some(waypoint)));
                }
                BranchStep::End(found) => return Ok(*found),
                BranchStep::Point(next) => here = Rc::from(next),
            }
            if search.options.deadline.is_over() {
                return search.run(&here.trial.film.problem, here.trial.film.problem.journal);
            }
            if search.is_in_contact(&here.trial) || self.is_left(&here) {
                break;
            }
            if here.part > greatest.part {
                greatest = Rc::clone(&here);
            }
        }
        Err(self.why(&here, way, &greatest, waypoint))
    }

    /// Whether a finer mesh is to show what follows a point.
    fn is_left(&self, here: &BranchPoint) -> bool {
        let is_start = self.search.options.purpose == Purpose::Start;
        is_start && here.trial.film.problem.deflection().is_some() && self.gap(&here.trial) < LEFT_TO_FINER
    }

    /// A point as one that a finer mesh begins at.
    fn waypoint(&self, at: &BranchPoint) -> Waypoint {
        Waypoint {
            journal: at.trial.film.problem.journal,
            deflection: at.trial.film.problem.deflection().cloned(),
            part: at.part,
            first: self.first,
        }
    }

    /// Why a branch that was followed up to a point does not lead to the balance.
    fn why(
        &self,
        here: &BranchPoint,
        way: Option<Direction>,
        greatest: &BranchPoint,
        waypoint: Waypoint,
    ) -> NoEquilibrium {
        let search = self.search;
        let has_turned = way.is_some_and(|way| way.part < 0.0);
        let is_at_end = search.is_in_contact(&here.trial) || has_turned && here.part < greatest.part - FALLEN;
        let carried = |at: &BranchPoint| match is_at_end {
            true => self.carried_with_error(at),
            // No step leads on: the branch itself may.
            false => (self.carried(at.part), None),
        };
        if search.options.deadline.is_over() {
            return search.confirmed(search.unreachable(&here.trial, SearchEnd::Ended));
        }
        match has_turned {
            true => {
                search.branch_end(&greatest.trial.film.problem, BranchLimit::Fold, carried(greatest), Some(waypoint))
            }
            false if self.gap(&here.trial) < NEAR_CONTACT => {
                search.branch_end(&here.trial.film.problem, BranchLimit::Contact, carried(here), Some(waypoint))
            }
            false => NoEquilibrium::NotConverged {
                asked: search.load.magnitude(),
                residual: search.residual(&here.trial),
                journal: Box::new(here.trial.film.problem.journal),
                history: search.record().tried.clone(),
            },
        }
    }

    /// Least film of a trial over the clearance.
    fn gap(&self, trial: &Trial) -> f64 {
        self.search.least_film(trial) / self.clearance
    }

    /// The direction of the branch at a point: on from the one `before` or, at its beginning, towards greater parts.
    /// None where the tangent is singular.
    fn direction(&self, at: &BranchPoint, before: Option<&Direction>) -> Option<Direction> {
        let long = (length(at.ahead.place) / self.clearance).hypot(1.0);
        let is_back = before.is_some_and(|before| self.product(before, at.ahead.place, 1.0) < 0.0);
        let long = if is_back { -long } else { long };
        long.is_finite().then(|| Direction { moves: at.ahead.over(long), part: 1.0 / long })
    }

    /// A point of the branch at this part.
    fn point(&self, trial: Trial, part: f64) -> Result<BranchPoint, NoFilm> {
        let wall = self.search.left_of_wall(&trial).into_owned();
        let ahead = self.ahead(&self.search.tangents(&trial, &trial.film, &wall, (FOLLOWED, 0.0))?)?;
        Ok(BranchPoint { trial, ahead, part })
    }

    /// How journal and wall move with the part, by their tangents at a point.
    fn ahead(&self, tangents: &Tangents) -> Result<Moves, NoFilm> {
        tangents.solve(self.first.map(|first| -first), None)
    }

    /// Product of a direction with a change of coordinates and part.
    fn product(&self, along: &Direction, place: Vector, part: f64) -> f64 {
        let places = (0..4).fold(0.0, |sum, k| sum + along.moves.place[k] * place[k]);
        places / (self.clearance * self.clearance) + along.part * part
    }

    /// What follows a point: the next one, or the end of the branch. `wanted` is the length of the step, longer or
    /// shorter afterwards. None where no step leads on.
    fn next(&self, here: &BranchPoint, along: &Direction, wanted: &mut f64) -> Option<BranchStep> {
        let (search, gap, [quick, _]) = (self.search, self.gap(&here.trial), corrections(&here.trial));
        // A search that was ended may begin where the gap vanishes.
        (gap > 0.0).then_some(())?;
        let least = LEAST_SHRINK * gap * self.clearance;
        let thin = |step: f64| {
            let (bent, at) = search.led_to(&here.trial, &along.moves, step);
            search.least_under(&bent, &search.coordinates.placed(&bent.journal, at)) < least
        };
        loop {
            while thin(*wanted) {
                *wanted *= 0.8;
            }
            if *wanted < SHORTEST * gap.min(1.0) || search.options.deadline.is_over() {
                return None;
            }
            if here.part + *wanted * along.part >= 1.0 {
                let last = (1.0 - here.part) / along.part;
                let found = (search.led_on(&here.trial, &along.moves, last, least))
                    .map(|(bent, _)| search.run(&bent, bent.journal));
                match found {
                    Some(Ok(found)) if search.is_in_contact(&found.trial) => {
                        return Some(BranchStep::Contact(Box::new(found.trial.film.problem)));
                    }
                    Some(Ok(found)) => return Some(BranchStep::End(Box::new(found))),
                    Some(Err(_)) | None => {}
                }
            } else if let Some((point, corrections)) = self.corrected(here, along, *wanted) {
                if corrections <= quick {
                    *wanted *= GROWTH;
                }
                return Some(BranchStep::Point(Box::new(point)));
            }
            *wanted *= 0.5;
        }
    }

    /// The point of the branch across a step of this length along it, and the corrections that it took.
    fn corrected(&self, here: &BranchPoint, along: &Direction, step: f64) -> Option<(BranchPoint, usize)> {
        let search = self.search;
        let least = 0.5 * LEAST_SHRINK * search.least_film(&here.trial);
        let (mut bent, mut place) = search.led_on(&here.trial, &along.moves, step, least)?;
        let mut part = here.part + step * along.part;
        let (mut last, mut before): (f64, Option<Trial>) = (f64::INFINITY, None);
        let [_, most] = corrections(&here.trial);
        for corrections in 0..most {
            let near = Neighbour::Start(&before.as_ref().unwrap_or(&here.trial).film);
            let tried = |near| search.open(&bent, place, FilmSolve::Settled(near), ROUGHLY_BALANCED);
            let trial = match (tried(near), &before) {
                (Err(_), Some(_)) => tried(Neighbour::None),
                (trial, _) => trial,
            };
            let trial = trial.ok()?;
            let (correction, change) = match self.judged(along, &trial, part)? {
                BranchFilm::Point(ahead) => return Some((BranchPoint { trial, ahead, part }, corrections)),
                BranchFilm::Beside(correction, change) => (correction, change),
            };
            let size = length(correction.place) / self.clearance;
            if !(size + change.abs()).is_finite() || size > 2.0 * last.min(step) {
                return None;
            }
            (bent, place) = search.led_on(&trial, &correction, 1.0, least)?;
            (part, last, before) = (part + change, size, Some(trial));
        }
        None
    }

    /// Whether a film at this part is a point of the branch or, where it lies beside, the moves and the change of the
    /// part that lead across `along` to it.
    fn judged(&self, along: &Direction, trial: &Trial, part: f64) -> Option<BranchFilm> {
        let search = self.search;
        let wall = search.left_of_wall(trial);
        let tangents = search.tangents(trial, &trial.film, &wall, (FOLLOWED, 0.0)).ok()?;
        let ahead = self.ahead(&tangents).ok()?;
        let left = moved(search.excess(trial), -(1.0 - part), self.first);
        // Under a rigid wall a correction costs little.
        let near = match trial.film.problem.deflection() {
            None => ROUGHLY_BALANCED * search.scale.min(length(search.response(trial))),
            Some(_) => ON_BRANCH * length(self.first).min(search.scale),
        };
        if length(left) < near && wall.residual < CLOSED_ON_BRANCH {
            return Some(BranchFilm::Point(ahead));
        }
        let back = tangents.solve(left.map(|left| -left), Some(&wall.wall)).ok()?;
        let change = -self.product(along, back.place, 0.0) / (along.part + self.product(along, ahead.place, 0.0));
        Some(BranchFilm::Beside(back.plus(change, &ahead), change))
    }
}

/// How many corrections of a step are quick, and how many it has at most.
fn corrections(trial: &Trial) -> [usize; 2] {
    match trial.film.problem.deflection() {
        None => CORRECTIONS,
        Some(_) => CORRECTIONS_WITH_WALL,
    }
}

/// What a film near a branch is.
enum BranchFilm {
    /// A point of it, with how journal and wall move with the part.
    Point(Moves),
    /// One beside it: the moves to it, and the change of the part.
    Beside(Moves, f64),
}

/// What follows a point of a branch.
enum BranchStep {
    Point(Box<BranchPoint>),
    /// The balance.
    End(Box<JournalBalance>),
    /// The film of a balance in which the journal is in contact.
    Contact(Box<FilmProblem>),
}
