//! Where a branch begins: the balance of the force alone, that of a lighter load, or a point that a coarser mesh has
//! shown.

use oilwedge_reynolds::FilmProblem;

use super::Branch;
use crate::balance::JournalBalance;
use crate::equilibrium::ROUGHLY_BALANCED;
use crate::no_equilibrium::Waypoint;
use crate::search::{Search, Trial};
use crate::{Carrier, InitialGuess, JournalLoad, NoEquilibrium, Purpose, SearchOptions};

/// A branch of a growing load begins at this part of the load at most.
const LIGHTER: f64 = 0.5;
/// The force of the film at this part of the journal's offset shows which part of the load is carried there.
const HALFWAY: f64 = 0.5;

impl Search<'_> {
    /// Balances what grows along a branch from its beginning: the moment where the tilt is free, else the load.
    pub(crate) fn along_branch(&self, problem: &FilmProblem) -> Result<JournalBalance, NoEquilibrium> {
        match self.load.tilting {
            Some(_) => self.by_growing_moment(problem),
            None => self.by_growing_load(problem),
        }
    }

    /// How balances that a branch begins with are searched.
    fn roughly(&self) -> SearchOptions<'_> {
        SearchOptions {
            guess: InitialGuess::Cold,
            carrier: Carrier::Quadratic,
            accuracy: Some(ROUGHLY_BALANCED),
            ..self.options
        }
    }

    /// Balances the force alone, and from there the moment. Where that leads nowhere, the branch of a growing moment is
    /// followed.
    fn by_growing_moment(&self, problem: &FilmProblem) -> Result<JournalBalance, NoEquilibrium> {
        let straight = JournalLoad { tilting: None, ..self.load };
        let straightened = |problem: &FilmProblem, purpose: Purpose| {
            let options = SearchOptions { purpose, ..self.roughly() };
            Search::new(problem, self.system, straight, options).found(problem)
        };
        let mut parallel = problem.clone();
        parallel.journal.tilt = [0.0; 2];
        let found = match problem.journal.tilt {
            [0.0, 0.0] => straightened(problem, self.options.purpose),
            // What the film carries at one tilt is no limit where the tilt is free: a parallel journal carries more.
            _ => straightened(problem, Purpose::Branch).or_else(|_| straightened(&parallel, self.options.purpose)),
        }?;
        let FilmProblem { journal, .. } = found.trial.film.problem;
        let trial = self.recorded(found.trial);
        // Of several balances the one that a growing moment leads to is nearest to this start.
        match self.run(&trial.film.problem, journal) {
            Ok(found) if !self.is_in_contact(&found.trial) => Ok(found),
            _ => self.followed_from(trial),
        }
    }

    /// Balances a part of the load, and follows the branch of a growing load from there.
    fn by_growing_load(&self, problem: &FilmProblem) -> Result<JournalBalance, NoEquilibrium> {
        let half = self.coordinates.at(&problem.journal).map(|x| HALFWAY * x);
        let start = FilmProblem { journal: self.coordinates.placed(&problem.journal, half), ..problem.clone() };
        let [x, y] = self.first(&start, start.journal)?.carried.force;
        let share = LIGHTER.min(x.hypot(y) / self.load.magnitude());
        let lighter = JournalLoad::from(self.load.force.map(|force| share * force));
        let found = Search::new(&start, self.system, lighter, self.roughly()).run(&start, start.journal)?;
        self.followed_from(self.recorded(found.trial))
    }

    /// Follows the branch that begins with this trial.
    fn followed_from(&self, trial: Trial) -> Result<JournalBalance, NoEquilibrium> {
        let branch =
            Branch { search: self, first: self.excess(&trial), clearance: trial.film.problem.bearing.clearance };
        branch.followed(branch.point(trial, 0.0)?)
    }

    /// Follows the branch that a coarser mesh has shown from a point of it on; none where there is no balance near that
    /// point.
    pub(crate) fn continued(
        &self,
        problem: &FilmProblem,
        way: &Waypoint,
    ) -> Option<Result<JournalBalance, NoEquilibrium>> {
        let load = self.load.with(way.first.map(|first| (1.0 - way.part) * first), self.coordinates.arm);
        let search = Search::new(problem, self.system, load, self.roughly());
        let bent = problem.clone().deflected(way.deflection.as_ref());
        let found = search.run(&bent, way.journal).ok()?;
        let branch = Branch { search: self, first: way.first, clearance: problem.bearing.clearance };
        Some(branch.followed(branch.point(self.recorded(found.trial), way.part).ok()?))
    }

    /// Follows the branch from a point that a coarser mesh has shown or, where there is no balance near it, from its
    /// beginning.
    pub(crate) fn taken_up(&self, problem: &FilmProblem, way: &Waypoint) -> Result<JournalBalance, NoEquilibrium> {
        let outcome = self.continued(problem, way);
        outcome.unwrap_or_else(|| self.along_branch(problem))
    }
}
