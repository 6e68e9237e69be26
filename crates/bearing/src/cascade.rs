//! The search for the position in which the film carries the load: from coarser meshes to the mesh asked for, step by
//! step.

use oilwedge_reynolds::solve::Neighbour;
use std::sync::Arc;

use oilwedge_reynolds::{FilmProblem, FilmSystem, JournalState, NoFilm};

use crate::balance::JournalBalance;
use crate::coupled::FilmSolve;
use crate::cubic::balance_cubic;
use crate::equilibrium::{Equilibrium, NEAR, ROUGHLY_BALANCED};
use crate::newton::{BalanceTolerance, Damping, ROUNDING, Unbalanced};
use crate::no_equilibrium::{BranchLimit, SearchEnd};
use crate::search::{Search, Trial};
use crate::work::Work;
use crate::{Carrier, InitialGuess, JournalLoad, NoEquilibrium, Purpose, SearchOptions, Waypoint};

/// Finds the position, and the tilt where that is free, in which the film carries `load`, searched from that of
/// `problem`. Where the deadline passes before, the position reached is the answer.
///
/// # Errors
/// [`NoEquilibrium`]: the reason why there is none. A search from a neighbouring point may fail where a cold one finds
/// a position.
pub fn find(
    problem: &FilmProblem,
    system: &Arc<FilmSystem>,
    load: impl Into<JournalLoad>,
    options: &SearchOptions,
) -> Result<Equilibrium, NoEquilibrium> {
    let load = load.into();
    by_carrier(problem, || Search::new(problem, system, load, *options))
}

/// Finds what is unknown of a film whose journal stays where `problem` has it: the deflection of its wall, and its
/// temperature.
///
/// # Errors
/// [`NoEquilibrium`]: the reason why there is none.
pub fn find_held(
    problem: &FilmProblem,
    system: &Arc<FilmSystem>,
    options: &SearchOptions,
) -> Result<Equilibrium, NoEquilibrium> {
    by_carrier(problem, || Search::held(problem, system, *options))
}

/// The balance of the film that carries the load: of the quadratic one, and from there of the cubic one.
fn by_carrier<'a>(problem: &FilmProblem, new_search: impl Fn() -> Search<'a>) -> Result<Equilibrium, NoEquilibrium> {
    let search = new_search();
    let balance = search.found(problem)?;
    match search.options.carrier {
        Carrier::Quadratic => search.equilibrium(balance),
        Carrier::Cubic => {
            let by_cubic = new_search();
            by_cubic.spend(search.record().work);
            by_cubic.record().row = search.record().row;
            balance_cubic(balance, &by_cubic)
        }
    }
}

impl Search<'_> {
    /// The balance of the film in quadratic elements, searched as the options have it.
    pub(crate) fn found(&self, problem: &FilmProblem) -> Result<JournalBalance, NoEquilibrium> {
        match self.options.guess {
            InitialGuess::Cold => self.cold(problem),
            InitialGuess::NearlyBalanced => match self.near(problem, Neighbour::None) {
                Ok(found) if !self.is_in_contact(&found.trial) => Ok(found),
                _ => self.cold(problem),
            },
            InitialGuess::Along(way) => match self.continued(problem, way) {
                // A way that ends without a reason is followed anew.
                Some(Err(reason)) if reason.branch_end().is_none() && !self.options.deadline.is_over() => {
                    self.cold(problem)
                }
                Some(outcome) => self.inside(outcome, Some(way)),
                None => self.cold(problem),
            },
            InitialGuess::Near(near) => self.inside(self.near(problem, near), None),
        }
    }

    /// Balances the load from coarser meshes on.
    fn cold(&self, problem: &FilmProblem) -> Result<JournalBalance, NoEquilibrium> {
        if self.coordinates.order > 0
            && let Some(reason) = self.below_rounding()
        {
            return Err(reason);
        }
        self.inside(self.on_levels(problem), None)
    }

    /// An outcome; that the journal is in contact where it is, with the `way` there that another mesh has shown.
    fn inside(
        &self,
        outcome: Result<JournalBalance, NoEquilibrium>,
        way: Option<&Waypoint>,
    ) -> Result<JournalBalance, NoEquilibrium> {
        let found = outcome.map_err(|reason| self.confirmed(reason))?;
        match self.coordinates.order > 0 && self.is_in_contact(&found.trial) {
            true => Err(self.branch_end(&found.trial.film.problem, BranchLimit::Contact, (1.0, None), way.cloned())),
            false => Ok(found),
        }
    }

    /// Balances the load from its balance on coarser meshes, if the system has any.
    fn on_levels(&self, problem: &FilmProblem) -> Result<JournalBalance, NoEquilibrium> {
        let Some(coarser) = &self.system.coarser else {
            return self.anywhere(problem);
        };
        let rough = SearchOptions {
            accuracy: Some(ROUGHLY_BALANCED),
            carrier: Carrier::Quadratic,
            guess: InitialGuess::Cold,
            purpose: self.options.purpose.on_coarser(),
            ..self.options
        };
        let on_coarser = coarser.problem(problem);
        let search = Search::new(&on_coarser, &coarser.system, self.load, rough);
        let search = Search { coordinates: self.coordinates, ..search };
        let found = search.found(&on_coarser);
        self.record().row = search.record().row;
        self.spend(Work { films: search.record().work.films, ..Work::default() });
        match found {
            Ok(found) => self.prolonged(problem, &found.trial),
            // What a thin film carries is shown by a mesh that resolves it.
            Err(reason) => match reason.way() {
                Some(way) => self.taken_up(problem, way),
                None => self.anywhere(problem),
            },
        }
    }

    /// Balances the load from its balance on the coarser mesh.
    fn prolonged(&self, problem: &FilmProblem, found: &Trial) -> Result<JournalBalance, NoEquilibrium> {
        let bent = problem.clone().deflected(found.film.problem.deflection());
        let journal = found.film.problem.journal;
        let start = self.system.coarser.as_ref().map(|coarser| coarser.start_of(&found.film));
        let near = start.as_ref().map_or(Neighbour::None, Neighbour::Coarser);
        let lubricant = found.film.problem.lubricant.clone();
        let placed = FilmProblem { journal, lubricant, ..bent };
        self.near(&placed, near).or_else(|_| self.run(&placed, journal))
    }

    /// Balances the load near the place of a problem.
    fn near(&self, problem: &FilmProblem, near: Neighbour) -> Result<JournalBalance, NoEquilibrium> {
        let here = self.coordinates.at(&problem.journal);
        self.rested(self.open(problem, here, FilmSolve::Settled(near), self.left_at_balance())?, Damping::None)
    }

    /// The film at the start, under the wall of the problem as it is, or, where there is none, nearer to the middle.
    pub(crate) fn first(&self, problem: &FilmProblem, mut start: JournalState) -> Result<Trial, NoFilm> {
        const RETREATS: usize = 12;
        let gap = self.gap_under(problem);
        for _ in 0..RETREATS {
            // A film may seem to exist where the gap vanishes at the very end of the bearing only.
            if gap.least(&start) > 0.0 || self.options.deadline.is_over() {
                let at = self.coordinates.at(&start);
                match self.open(problem, at, FilmSolve::Settled(Neighbour::None), self.left_at_balance()) {
                    // Without a supply there is no film anywhere.
                    Err(reason) if !matches!(reason, NoFilm::NoSupply { .. }) => {}
                    // Beyond the viscosity law there is none either.
                    Ok(trial) if !trial.film.is_within_law() => {}
                    other => return other,
                }
            }
            start = self.coordinates.placed(&start, self.coordinates.at(&start).map(|x| 0.5 * x));
        }
        self.open(problem, self.coordinates.at(&start), FilmSolve::Settled(Neighbour::None), self.left_at_balance())
    }

    /// Balances the load from this start.
    pub(crate) fn run(&self, problem: &FilmProblem, start: JournalState) -> Result<JournalBalance, NoEquilibrium> {
        self.rested(self.first(problem, start)?, Damping::PseudoTime)
    }

    /// Balances the load of a quadratic film from a trial.
    fn rested(&self, first: Trial, damping: Damping) -> Result<JournalBalance, NoEquilibrium> {
        let goal = BalanceTolerance {
            balanced: self.options.balanced(),
            closed: self.left_at_balance(),
            moved: f64::INFINITY,
            rounding: ROUNDING,
        };
        self.balanced((first, 1), goal, damping)
    }

    /// Balances the load from a trial, before which so many were tried.
    pub(crate) fn balanced(
        &self,
        (first, mut tried): (Trial, usize),
        goal: BalanceTolerance,
        damping: Damping,
    ) -> Result<JournalBalance, NoEquilibrium> {
        match self.newton(first, goal, damping, &mut tried) {
            Ok(trial) => Ok(JournalBalance { trial: self.accepted(trial)?, tried, is_ended: false }),
            Err(Unbalanced { trial, end: SearchEnd::Ended }) => {
                let problem = &trial.film.problem;
                let near = FilmSolve::Settled(Neighbour::Start(&trial.film));
                let settled = match trial.film.solution.wrong.is_empty() {
                    true => *trial,
                    false => self.open(problem, self.coordinates.at(&problem.journal), near, goal.closed)?,
                };
                Ok(JournalBalance { trial: self.accepted(settled)?, tried, is_ended: true })
            }
            Err(Unbalanced { trial, .. }) if self.residual(&trial) < NEAR => Err(NoEquilibrium::NotConverged {
                asked: self.load.magnitude(),
                residual: self.residual(&trial),
                journal: Box::new(trial.film.problem.journal),
                history: self.record().tried.clone(),
            }),
            Err(Unbalanced { trial, end }) => Err(self.unreachable(&trial, end)),
        }
    }

    /// The balance from the start of a problem; where there is none near it, that at the end of a branch.
    fn anywhere(&self, problem: &FilmProblem) -> Result<JournalBalance, NoEquilibrium> {
        if self.load.tilting.is_some() {
            return self.along_branch(problem);
        }
        let outcome = self.run(problem, problem.journal);
        let is_found = outcome.as_ref().is_ok_and(|found| !self.is_in_contact(&found.trial));
        if is_found || self.coordinates.order == 0 || self.options.purpose == Purpose::Branch {
            return outcome;
        }
        match self.along_branch(problem) {
            Err(reason) if reason.branch_end().is_none() => outcome,
            followed => followed,
        }
    }
}
