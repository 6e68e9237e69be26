//! # Equilibrium: the position in which the film carries the load
//!
//! **Equation.** `W(e) = F` for the journal's offset `e`. Newton's method with the exact tangent of the film bordered by
//! that of the load: `dW/de = -(dW/dp) (dR/dp)^-1 (dR/de)`, the cavity held.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | F | N | `load` |
//! | W | N | `force` |
//! | dW/de | N/m | `stiffness` |
//! | s | - | `stretched` |
//!
//! Far from the balance steps are taken in `ln |W|` against `s = ln eps - 3/2 ln(1 - eps)` and in the angles: the load
//! grows like eps for a centred journal and like (1 - eps)^(-3/2) near contact, so both are nearly linear over the whole
//! range, and the film thickness stays positive by itself. Near the balance they are those in `e`.
//!
//! **Source.** Definition; Hamrock, Schmid, Jacobson (2004), ch. 10, for the limits of the load. **Range.** Steady positions;
//! with squeeze the centre's velocity turns with the line of centres. **Verified by** `tests/tests/equilibrium.rs`: the
//! tangent against differences, and eccentricities given back by their loads.

use crate::estimate::GREATEST_ECCENTRICITY;
use crate::search::{Search, Trial};
use crate::stretched::{eccentricity_at, stretched};
use crate::{NoEquilibrium, Patience};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{CentreVelocity, FilmProblem, FilmSolution, FilmSystem, JournalState};

/// The balance has been found when force and load differ by this part of the load.
pub(crate) const BALANCED: f64 = 1e-12;
/// On coarser meshes, that are only to start from, this part will do.
pub(crate) const ROUGHLY_BALANCED: f64 = 1e-4;
/// Of a search that begins nearby, as a step of Newton's method more would leave rounding.
const NEARLY_BALANCED: f64 = 1e-10;
/// A balance that rounding keeps from [`BALANCED`] is one below this part.
const BALANCED_ENOUGH: f64 = 1e-10;
/// Where force and load differ by less than this part of the load the tangent tells how far the balance is, and steps are taken in `e`.
pub const NEAR: f64 = 0.1;
/// Most positions tried.
const MOST_STEPS: usize = 40;
/// Most halvings of one step.
const MOST_HALVINGS: usize = 8;
/// Least film thickness after a step, over the one before.
const LEAST_SHRINK: f64 = 0.1;
/// Longest turn of the line of centres in one step [rad].
const LONGEST_TURN: f64 = 1.0;
/// Below this part of the load the forms by which a mass-conserving film carries its oil are kept from step to step.
const SMOOTH: f64 = 1e-2;
/// Choices of these forms: the last is that of the balanced position, if they come to rest.
const MOST_CHOICES: usize = 6;
/// Eccentricity up to which a coarser mesh that led nowhere is trusted.
const RESOLVED: f64 = 0.99;
/// A journal whose film is thinner than this part of the clearance touches.
const CONTACT: f64 = 1e-6;
/// Moves by less than this part of the least film thickness are started from the film before.
pub const SHORT_MOVE: f64 = 0.2;

/// `dW/de` [N/m], row: component of W.
type Stiffness = [[f64; 2]; 2];

/// A journal in balance.
#[derive(Debug)]
pub struct Equilibrium {
    /// The film's problem with the journal where it belongs.
    pub problem: FilmProblem,
    /// The film there.
    pub film: FilmSolution,
    /// The film there in cubic elements, where it is that which carries the load.
    pub cubic: Option<FilmSolution>,
    /// Load less force of the film, relative to the load (to the natural one if there is none).
    pub residual: f64,
    /// The same in newtons.
    pub unbalanced: f64,
    /// Positions tried on the mesh of the film.
    pub steps: usize,
    /// True where patience was at its end before the load was balanced: the film is that of the position reached.
    pub is_ended: bool,
    /// `dW/de` [N/m], row: component of W; of a search from nearby and of a cubic balance as its steps have left it, off by the square root of what they gained.
    pub stiffness: Stiffness,
}

/// Finds the position in which the film carries `load` [N], searched from that of `problem`. On coarser
/// meshes first, if the system has any. Where `patience` is at its end before, the position reached is the answer.
///
/// # Errors
/// [`NoEquilibrium`]: the reason why there is none.
pub fn find(
    problem: &FilmProblem,
    system: &FilmSystem,
    load: [f64; 2],
    centre_velocity: CentreVelocity,
    patience: Patience,
) -> Result<Equilibrium, NoEquilibrium> {
    find_within(problem, system, load, centre_velocity, patience, BALANCED)
}

/// The same where force and load may differ by the part `balanced` of the load.
///
/// # Errors
/// As [`find`].
pub(crate) fn find_within(
    problem: &FilmProblem,
    system: &FilmSystem,
    load: [f64; 2],
    centre_velocity: CentreVelocity,
    patience: Patience,
    balanced: f64,
) -> Result<Equilibrium, NoEquilibrium> {
    let search = Search {
        balanced,
        ..Search::new(problem, system, load, centre_velocity, patience)
    };
    search.check_reach(problem)?;
    let found = search.on_levels(problem).map_err(|reason| search.sure(reason))?;
    match found.problem.journal.eccentricity() > GREATEST_ECCENTRICITY * search.clearance {
        true => search.beyond_reach(problem).map_or(Ok(found), Err),
        false => Ok(found),
    }
}

/// The same from the position of `problem`, which a neighbouring operating point suggests, with the film of that point on the same
/// system if there is one to start from; no coarser mesh is asked for a position. Where forms are kept they are not chosen anew.
///
/// # Errors
/// As [`find`]. A search that begins elsewhere may still find a position.
pub fn find_near(
    problem: &FilmProblem,
    system: &FilmSystem,
    load: [f64; 2],
    centre_velocity: CentreVelocity,
    patience: Patience,
    near: Neighbour,
) -> Result<Equilibrium, NoEquilibrium> {
    find_near_within(problem, system, load, centre_velocity, patience, near, NEARLY_BALANCED)
}

/// The same where force and load may differ by the part `balanced` of the load.
///
/// # Errors
/// As [`find_near`].
pub(crate) fn find_near_within(
    problem: &FilmProblem,
    system: &FilmSystem,
    load: [f64; 2],
    centre_velocity: CentreVelocity,
    patience: Patience,
    near: Neighbour,
    balanced: f64,
) -> Result<Equilibrium, NoEquilibrium> {
    let search = Search {
        balanced,
        keeps_forms: matches!(near, Neighbour::Kept(_)),
        keeps_tangent: problem.cavitation.depends_smoothly_on_position(),
        ..Search::new(problem, system, load, centre_velocity, patience)
    };
    let first = search.trial(problem, problem.journal.offset, near)?;
    search.at_rest(first)
}

impl Search<'_> {
    /// Refuses a load that is below rounding and, where the search begins at the greatest eccentricity, one that is beyond reach there.
    fn check_reach(&self, problem: &FilmProblem) -> Result<(), NoEquilibrium> {
        let begins_at_contact =
            problem.journal.eccentricity() > (1.0 - f64::EPSILON.sqrt()) * GREATEST_ECCENTRICITY * self.clearance;
        let beyond = || begins_at_contact.then(|| self.beyond_reach(problem)).flatten();
        self.below_rounding().or_else(beyond).map_or(Ok(()), Err)
    }

    /// Balances the load from where it is balanced on coarser meshes, if the system has any.
    fn on_levels(&self, problem: &FilmProblem) -> Result<Equilibrium, NoEquilibrium> {
        let Some(coarser) = &self.system.coarser else {
            return self.everywhere(problem);
        };
        let reason = match find_within(
            &coarser.problem(problem),
            &coarser.system,
            self.load,
            self.centre_velocity,
            self.patience,
            ROUGHLY_BALANCED,
        ) {
            Ok(found) => return self.run(problem, found.problem.journal),
            Err(reason) => reason,
        };
        // Where a coarser mesh leads nowhere its last position may still be a start, unless the film there is too thin for it.
        let is_resolved = |journal: &JournalState| journal.eccentricity() < RESOLVED * self.clearance;
        let outcome = self.run(problem, problem.journal);
        match reason.last_position().filter(is_resolved) {
            Some(start) if outcome.is_err() => self.run(problem, start),
            _ => outcome,
        }
    }

    /// Balances the load from this start.
    fn run(&self, problem: &FilmProblem, start: JournalState) -> Result<Equilibrium, NoEquilibrium> {
        self.at_rest(self.first(problem, start)?)
    }

    /// Balances the load and, in a mass-conserving film, chooses the forms by which oil is carried anew at the balanced
    /// position until they come to rest.
    fn at_rest(&self, first: Trial) -> Result<Equilibrium, NoEquilibrium> {
        let mut tried = 1;
        let (mut trial, mut tangent) = self.balanced(first, &mut tried)?;
        // A position on a coarser mesh is only to start from.
        let mut at_rest = trial.film.film_fraction.is_none() || self.keeps_forms || self.balanced > BALANCED_ENOUGH;
        for _ in 0..MOST_CHOICES {
            if at_rest || self.patience.is_over() {
                break;
            }
            tried += 1;
            let offset = trial.problem.journal.offset;
            // Where the choice fails the position balanced before stands, with the forms chosen near it.
            let Ok(chosen) = self.trial(&trial.problem, offset, Neighbour::None) else {
                break;
            };
            at_rest = self.residual(&chosen) < BALANCED_ENOUGH;
            if at_rest {
                (trial, tangent) = (chosen, None);
                break;
            }
            match self.balanced(chosen, &mut tried) {
                Ok(balanced) => (trial, tangent) = balanced,
                Err(_) => break,
            }
        }
        if !at_rest && !self.patience.is_over() {
            let told = "the forms by which oil is carried did not come to rest at the balanced position: those chosen near it are kept";
            trial.film.fallbacks.push(told.to_owned());
        }
        let is_balanced = at_rest && self.residual(&trial) < self.balanced.max(BALANCED_ENOUGH);
        Ok(Equilibrium {
            is_ended: !is_balanced && self.patience.is_over(),
            residual: self.residual(&trial),
            unbalanced: self.residual(&trial) * self.natural,
            stiffness: tangent.map_or_else(|| self.stiffness(&trial), Ok)?,
            problem: trial.problem,
            film: trial.film,
            cubic: trial.cubic,
            steps: tried,
        })
    }

    /// The balanced trial, and the tangent that the search has for it, if it kept one.
    fn balanced(&self, mut trial: Trial, tried: &mut usize) -> Result<(Trial, Option<Stiffness>), NoEquilibrium> {
        let last = *tried + MOST_STEPS;
        let mut kept = None;
        while *tried < last {
            let residual = self.residual(&trial);
            if residual < self.balanced || self.patience.is_over() {
                return Ok((trial, kept));
            }
            let tangent = kept.map_or_else(|| self.stiffness(&trial), Ok)?;
            let step = self.step(&trial, tangent);
            match self.damped(&trial, step, tried) {
                // Perhaps the tangent was too old.
                None if kept.take().is_some() => continue,
                // Rounding is reached.
                None if residual < BALANCED_ENOUGH => return Ok((trial, None)),
                None => {
                    return Err(self.unreachable(&trial, "no shorter step brings the force nearer to the load"));
                }
                Some(next) => {
                    kept = self.keeps_tangent.then(|| Self::corrected(tangent, &trial, &next));
                    trial = next;
                }
            }
            if self.clearance - trial.problem.journal.eccentricity() < CONTACT * self.clearance {
                return Err(self.unreachable(&trial, "the journal touches the bearing"));
            }
        }
        match self.residual(&trial) {
            residual if residual < NEAR => Err(NoEquilibrium::NotConverged {
                asked: self.load[0].hypot(self.load[1]),
                residual,
                journal: Box::new(trial.problem.journal),
                history: self.tried.borrow().clone(),
            }),
            _ => Err(self.unreachable(&trial, "the force stays away from the load")),
        }
    }

    /// From the start of `problem` or, where that leads nowhere, from the best of positions all over the bearing.
    fn everywhere(&self, problem: &FilmProblem) -> Result<Equilibrium, NoEquilibrium> {
        const STARTS: usize = 3;
        let mut outcome = self.run(problem, problem.journal);
        if let Err(NoEquilibrium::Unreachable { .. }) = outcome {
            for start in self.starts(problem).into_iter().take(STARTS) {
                outcome = self.run(problem, start);
                if outcome.is_ok() {
                    break;
                }
            }
        }
        outcome.map_err(|reason| self.sure(reason))
    }

    /// Newton's step [m].
    fn step(&self, trial: &Trial, stiffness: [[f64; 2]; 2]) -> [f64; 2] {
        let stretched = (self.residual(trial) > NEAR)
            .then(|| self.stretched_step(trial, stiffness))
            .flatten();
        stretched.unwrap_or_else(|| newton_step(stiffness, self.excess(trial)))
    }

    /// The step in `s` and the angle of the line of centres that brings `ln |W|` and the angle of W to those of the load.
    /// None for a centred journal, without a load, and where the force is turned away from the load.
    fn stretched_step(&self, trial: &Trial, stiffness: [[f64; 2]; 2]) -> Option<[f64; 2]> {
        let [e_x, e_y] = trial.problem.journal.offset;
        let e = e_x.hypot(e_y);
        let eps = e / self.clearance;
        let (force, load) = (trial.force[0].hypot(trial.force[1]), self.load[0].hypot(self.load[1]));
        let along = trial.force[0] * self.load[0] + trial.force[1] * self.load[1];
        if eps < 1e-3 || along <= 0.0 {
            return None;
        }
        let across = trial.force[0] * self.load[1] - trial.force[1] * self.load[0];
        let wanted = [(load / force).ln(), across.atan2(along)];
        // Columns: change of (ln |W|, angle of W) by s and by the angle of the line of centres.
        let radial = [e_x / e, e_y / e];
        let by_stretch = 1.0 / (1.0 / eps + 1.5 / (1.0 - eps)) * self.clearance;
        let moves = [radial.map(|x| x * by_stretch), [-e_y, e_x]];
        let mut tangent = [[0.0; 2]; 2];
        for (k, step) in moves.iter().enumerate() {
            let change = [0, 1].map(|d| stiffness[d][0] * step[0] + stiffness[d][1] * step[1]);
            tangent[0][k] = (change[0] * trial.force[0] + change[1] * trial.force[1]) / force.powi(2);
            tangent[1][k] = (change[1] * trial.force[0] - change[0] * trial.force[1]) / force.powi(2);
        }
        let [stretch, turn] = solve(tangent, wanted);
        if !(stretch.is_finite() && turn.is_finite() && turn.abs() < LONGEST_TURN) {
            return None;
        }
        let eps_next = eccentricity_at(stretched(eps) + stretch);
        let angle = e_y.atan2(e_x) + turn;
        let e_next = self.clearance * eps_next;
        Some([e_next * angle.cos() - e_x, e_next * angle.sin() - e_y])
    }

    /// The longest of the halved steps that brings the force nearer to the load, the film thickness kept positive.
    fn damped(&self, from: &Trial, step: [f64; 2], tried: &mut usize) -> Option<Trial> {
        let [e_x, e_y] = from.problem.journal.offset;
        let gap = self.clearance - e_x.hypot(e_y);
        let at = |part: f64| [e_x + part * step[0], e_y + part * step[1]];
        let thin = |part: f64| {
            let [x, y] = at(part);
            self.clearance - x.hypot(y) < LEAST_SHRINK * gap
        };
        let length = step[0].hypot(step[1]);
        if !length.is_finite() {
            return None;
        }
        let mut part = 1.0;
        while thin(part) {
            part *= 0.8;
        }
        for _ in 0..MOST_HALVINGS {
            let near = match part * length < SHORT_MOVE * gap {
                true if self.keeps_forms || self.residual(from) < SMOOTH => Neighbour::Kept(&from.film),
                true => Neighbour::Start(&from.film),
                false => Neighbour::None,
            };
            *tried += 1;
            if let Ok(trial) = self.trial(&from.problem, at(part), near)
                && self.distance(&trial) < self.distance(from)
            {
                return Some(trial);
            }
            part *= 0.5;
        }
        None
    }
}

/// The step [m] that takes away the `excess` of force [N] to first order; not finite for a singular stiffness.
pub fn newton_step(stiffness: [[f64; 2]; 2], excess: [f64; 2]) -> [f64; 2] {
    solve(stiffness, excess.map(|x| -x))
}

/// Solves a system of two equations; not finite if it is singular.
fn solve(a: [[f64; 2]; 2], b: [f64; 2]) -> [f64; 2] {
    let determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    [
        (a[1][1] * b[0] - a[0][1] * b[1]) / determinant,
        (a[0][0] * b[1] - a[1][0] * b[0]) / determinant,
    ]
}
