//! The search for the position in which the film carries the load: from coarser meshes to the mesh asked for, step by
//! step.

use oilwedge_reynolds::solve::Neighbour;
use std::sync::Arc;

use oilwedge_reynolds::{FilmProblem, FilmSystem, JournalState, NoFilm};

use crate::balance::Balance;
use crate::cubic::balance_cubic;
use crate::equilibrium::{Equilibrium, NEAR, ROUGHLY_BALANCED};
use crate::estimate::GREATEST_ECCENTRICITY;
use crate::load_capacity::yields_to_contact;
use crate::no_equilibrium::SearchEnd;
use crate::search::{OF_BALANCE, Search, Trial};
use crate::tangent::Tangent;
use crate::with_wall::WITHIN;
use crate::{Carrier, InitialGuess, Load, NoEquilibrium, Purpose, SearchOptions, Waypoint};

/// Most positions tried.
const MOST_STEPS: usize = 40;
/// A balance that round-off keeps from its accuracy is one below this part.
const BALANCED_ENOUGH: f64 = 1e-10;
/// Force and wall are sought together again where less than this part is left of what was left where that has failed.
const OF_FAILED: f64 = 0.1;
/// Part of the clearance that the film may lose where it is thinnest, if the last position of a failed search on a
/// coarser mesh is to be a start.
const RESOLVED: f64 = 0.99;
/// A journal whose film is thinner than this part of the clearance touches.
const CONTACT: f64 = 1e-6;
/// A mass-conserving film that is thinner than this part while force and moment are far from balanced was driven into
/// contact: the branch of balances leads on from elsewhere.
const DRIVEN: f64 = 1e-3;
/// A failed search whose film is thinner than this part of the clearance was driven into contact.
const NEARLY_CONTACT: f64 = 1e-2;

/// Finds the position, and the tilt where that is free, in which the film carries `load`, searched from that of
/// `problem`. Where the deadline passes before, the position reached is the answer.
///
/// # Errors
/// [`NoEquilibrium`]: the reason why there is none. A search from a neighbouring point may fail where a cold one finds
/// a position.
pub fn find(
    problem: &FilmProblem,
    system: &Arc<FilmSystem>,
    load: impl Into<Load>,
    options: &SearchOptions,
) -> Result<Equilibrium, NoEquilibrium> {
    let load = load.into();
    let search = Search::new(problem, system, load, *options);
    let balance = search.found(problem)?;
    match options.carrier {
        Carrier::Quadratic => search.equilibrium(balance),
        Carrier::Cubic => balance_cubic(balance, &Search::new(problem, system, load, *options)),
    }
}

/// Finds the position as [`find`] does from a cold start with quadratic elements, where the coarser mesh of the system
/// is known to have no balance, for this `reason`.
///
/// # Errors
/// [`NoEquilibrium`]: the reason why there is none.
pub fn find_after(
    problem: &FilmProblem,
    system: &Arc<FilmSystem>,
    load: impl Into<Load>,
    options: &SearchOptions,
    reason: NoEquilibrium,
) -> Result<Equilibrium, NoEquilibrium> {
    let search = Search::new(problem, system, load.into(), *options);
    search.equilibrium(search.cold_after(problem, Some(reason))?)
}

impl Search<'_> {
    /// The balance of the film in quadratic elements, searched as the options have it.
    pub(crate) fn found(&self, problem: &FilmProblem) -> Result<Balance, NoEquilibrium> {
        match self.options.guess {
            InitialGuess::Cold => self.cold(problem),
            InitialGuess::NearlyBalanced => match self.run(problem, problem.journal) {
                Ok(found) if !self.is_in_contact(&found.trial) => Ok(found),
                _ => self.cold(problem),
            },
            InitialGuess::Along(way) => match self.continued(problem, way) {
                // A way that ends without a reason is followed anew.
                Some(Err(reason)) if !reason.is_beyond() && !self.options.deadline.is_over() => self.cold(problem),
                Some(outcome) => self.inside(outcome, Some(way)),
                None => self.cold(problem),
            },
            InitialGuess::Near(near) => {
                let here = self.coordinates.at(&problem.journal);
                let first = (self.opened(problem, here, near, self.left_at_balance()))
                    .map_or_else(|| self.trial(problem, here, near), Ok)?;
                self.inside(self.at_rest(first), None)
            }
        }
    }

    /// Balances the load from coarser meshes on.
    fn cold(&self, problem: &FilmProblem) -> Result<Balance, NoEquilibrium> {
        self.cold_after(problem, None)
    }

    /// As [`Self::cold`]; `known` is why the coarser mesh has no balance, where that was asked.
    fn cold_after(&self, problem: &FilmProblem, known: Option<NoEquilibrium>) -> Result<Balance, NoEquilibrium> {
        self.below_rounding().map_or(Ok(()), Err)?;
        let found = match self.guided(problem) {
            Some(outcome) => outcome,
            None => self.check_capacity(problem).map_or_else(|| self.on_levels(problem, known), Err),
        };
        let found = self.inside(found, None)?;
        match self.is_in_contact(&found.trial) {
            true => (self.beyond_capacity(problem, &problem.journal)).map_or(Ok(found), Err),
            false => Ok(found),
        }
    }

    /// An outcome; that the journal is in contact where a free tilt has led it there, on the `way` that another mesh
    /// has shown.
    fn inside(
        &self,
        outcome: Result<Balance, NoEquilibrium>,
        way: Option<&Waypoint>,
    ) -> Result<Balance, NoEquilibrium> {
        let found = outcome.map_err(|reason| self.confirmed(reason))?;
        match self.load.tilting.is_some() && self.is_in_contact(&found.trial) {
            true => Err(self.in_contact(&found.trial.film.problem, (1.0, None), way.cloned())),
            false => Ok(found),
        }
    }

    /// The reason where the search begins at the greatest eccentricity and the load exceeds the capacity there.
    fn check_capacity(&self, problem: &FilmProblem) -> Option<NoEquilibrium> {
        let bearing = &problem.bearing;
        let nearly = (1.0 - f64::EPSILON.sqrt()) * GREATEST_ECCENTRICITY * bearing.clearance;
        // What the film carries at this tilt is no limit where the tilt is free.
        let is_limit = self.load.tilting.is_none();
        let begins_at_contact = is_limit && bearing.clearance - self.least_under(problem, &problem.journal) > nearly;
        begins_at_contact.then(|| self.beyond_capacity(problem, &problem.journal)).flatten()
    }

    /// Balances the load from its balance on coarser meshes, if the system has any; `known` is why they have none.
    fn on_levels(&self, problem: &FilmProblem, known: Option<NoEquilibrium>) -> Result<Balance, NoEquilibrium> {
        let Some(coarser) = &self.system.coarser else {
            return self.everywhere(problem);
        };
        let rough = SearchOptions {
            accuracy: Some(ROUGHLY_BALANCED),
            carrier: Carrier::Quadratic,
            guess: InitialGuess::Cold,
            purpose: self.options.purpose.on_coarser(),
            ..self.options
        };
        let on_coarser = || {
            let problem = coarser.problem(problem);
            Search::new(&problem, &coarser.system, self.load, rough).found(&problem)
        };
        let reason = match known.map_or_else(on_coarser, Err) {
            Ok(found) => {
                let bent = problem.clone().deflected(found.trial.film.problem.deflection());
                return self.run(&bent, found.trial.film.problem.journal);
            }
            Err(reason) => reason,
        };
        if let NoEquilibrium::EdgeContact { way: Some(way), .. } | NoEquilibrium::TiltLimit { way: Some(way), .. } =
            &reason
        {
            // What a thin film carries is shown by a mesh that resolves it.
            return self.taken_up(problem, way).map_err(|reason| self.confirmed(reason));
        }
        if let NoEquilibrium::BeyondCapacity { journal, .. } = &reason
            && let Some(beyond) = self.still_beyond(problem, journal)
        {
            return Err(beyond);
        }
        if matches!(reason, NoEquilibrium::Unreachable { why: SearchEnd::FarBelow, .. }) {
            return Err(reason);
        }
        // Where a coarser mesh has no balance its last position may still be a start, unless the film there is too thin
        // for it.
        let is_resolved = |journal: &JournalState| {
            let bearing = &problem.bearing;
            bearing.clearance - self.gap.least(journal) < RESOLVED * bearing.clearance
        };
        let outcome = self.run(problem, problem.journal);
        let outcome = match reason.last_position().filter(is_resolved) {
            _ if outcome.is_err() && self.load.tilting.is_some() => self.by_parts_of_tilting(problem),
            Some(start) if outcome.is_err() => self.run(problem, start),
            _ => outcome,
        };
        // A mass-conserving film takes long at so many contacts; the search for its guide has asked there.
        let is_held = self.load.tilting.is_none() && problem.journal.tilt != [0.0; 2];
        let is_asked = is_held && !problem.cavitation.conserves_oil() && self.options.purpose != Purpose::Branch;
        outcome.map_err(|reason| match is_asked {
            true => self.beyond_contact(problem).unwrap_or(reason),
            false => reason,
        })
    }

    /// Balances the load from this start.
    pub(crate) fn run(&self, problem: &FilmProblem, start: JournalState) -> Result<Balance, NoEquilibrium> {
        let rough = self.options.balanced().max(ROUGHLY_BALANCED);
        let at = self.coordinates.at(&start);
        // To close the wall would take as many films as a search.
        if problem.has_bent_wall()
            && self.options.deadline.is_over()
            && let Ok(begun) = self.open(problem, at, Neighbour::None, self.left_at_balance())
        {
            return self.at_rest(begun);
        }
        let opened = self.opened(problem, at, Neighbour::None, rough);
        match opened.map(|opened| self.with_wall(opened, (rough, rough), &mut 0)) {
            Some(Ok(near)) => self.at_rest(near),
            Some(Err(begun)) if self.options.deadline.is_over() => self.at_rest(*begun),
            Some(Err(_)) | None => self.at_rest(self.first(problem, start)?),
        }
    }

    /// Balances the load from a trial.
    fn at_rest(&self, first: Trial) -> Result<Balance, NoEquilibrium> {
        let mut tried = 1;
        let (trial, tangent) = self.balanced(first, &mut tried)?;
        let is_closed = trial.may_leave <= self.left_at_balance().max(BALANCED_ENOUGH);
        let is_balanced = is_closed && self.residual(&trial) < self.options.balanced().max(BALANCED_ENOUGH);
        Ok(Balance { is_ended: !is_balanced && self.options.deadline.is_over(), trial, tangent, tried })
    }

    /// The balanced trial, and the tangent that the search has for it, if it kept one.
    fn balanced(&self, mut trial: Trial, tried: &mut usize) -> Result<(Trial, Option<Tangent>), NoEquilibrium> {
        let mut kept: Option<Tangent> = None;
        let keeps_tangent = matches!(self.options.guess, InitialGuess::Near(_));
        let mut last = *tried + MOST_STEPS;
        let mut within = WITHIN;
        while *tried < last {
            let residual = self.residual(&trial);
            let is_balanced = residual < self.options.balanced();
            let closed = self.left_at_balance();
            let is_closed = trial.may_leave <= closed;
            if is_balanced && is_closed || self.options.deadline.is_over() {
                return Ok((trial, kept));
            }
            if trial.film.problem.has_bent_wall() && self.left(&trial) < within {
                within = OF_FAILED * self.left(&trial);
                let before = *tried;
                trial = match self.with_wall(trial, (self.options.balanced(), closed), tried) {
                    Ok(found) => return Ok((found, None)),
                    Err(from) if self.options.deadline.is_over() => return Ok((*from, None)),
                    Err(from) if from.left.is_some() => self.closed_here(&from, tried)?,
                    Err(from) => *from,
                };
                // What has failed leaves as many positions to the search from place to place as it had.
                last += *tried - before;
                continue;
            }
            if is_balanced {
                trial = self.closed_further(&trial, tried)?;
                continue;
            }
            let tangent = kept.clone().map_or_else(|| self.tangent(&trial), Ok)?;
            match self.next_trial(&trial, &tangent, tried) {
                // Perhaps the tangent was too old.
                None if kept.take().is_some() => continue,
                // Round-off is reached.
                None if residual < BALANCED_ENOUGH && is_closed => return Ok((trial, None)),
                None if residual < BALANCED_ENOUGH => trial = self.closed_further(&trial, tried)?,
                None => return Err(self.unreachable(&trial, SearchEnd::NoStep)),
                Some(next) => {
                    kept = keeps_tangent.then(|| self.corrected(tangent, &trial, &next));
                    trial = next;
                }
            }
            if self.least_film(&trial) < self.contact(&trial) * trial.film.problem.bearing.clearance {
                return Err(self.unreachable(&trial, SearchEnd::Touching));
            }
        }
        match self.residual(&trial) {
            residual if residual < NEAR => Err(NoEquilibrium::NotConverged {
                asked: self.load.magnitude(),
                residual,
                journal: Box::new(trial.film.problem.journal),
                history: self.tried.borrow().clone(),
            }),
            _ => Err(self.unreachable(&trial, SearchEnd::NoProgress)),
        }
    }

    /// The trial at this place with its wall closed roughly.
    fn closed_here(&self, trial: &Trial, tried: &mut usize) -> Result<Trial, NoFilm> {
        *tried += 1;
        let here = self.coordinates.at(&trial.film.problem.journal);
        self.trial_within(&trial.film.problem, here, Neighbour::Start(&trial.film), OF_BALANCE * NEAR)
    }

    /// A trial whose wall is closed as far as a balance asks for.
    fn closed_further(&self, trial: &Trial, tried: &mut usize) -> Result<Trial, NoFilm> {
        *tried += 1;
        let here = self.coordinates.at(&trial.film.problem.journal);
        self.trial(&trial.film.problem, here, Neighbour::Start(&trial.film))
    }

    /// Part of the clearance below which the film of a journal far from its balance is one in contact.
    fn contact(&self, trial: &Trial) -> f64 {
        match self.is_costly(trial) && self.residual(trial) > NEAR {
            true => DRIVEN,
            false => CONTACT,
        }
    }

    /// From the start of `problem` or, where that fails, from the best of positions all over the bearing; with a free
    /// tilt from the balance of the force alone on.
    fn everywhere(&self, problem: &FilmProblem) -> Result<Balance, NoEquilibrium> {
        const STARTS: usize = 3;
        let mut outcome = self.run(problem, problem.journal);
        if yields_to_contact(problem) && self.load.tilting.is_none() {
            outcome = outcome.or_else(|reason| self.by_parts_of_load(problem).map_err(|_| reason));
        }
        if self.load.tilting.is_some() {
            let outcome = outcome.or_else(|_| self.by_parts_of_tilting(problem));
            return outcome.map_err(|reason| self.confirmed(reason));
        }
        if let Err(NoEquilibrium::Unreachable { journal, .. }) = &outcome
            && self.options.purpose != Purpose::Branch
        {
            // A search that was driven into contact: what the film carries there shows whether there is a position
            // elsewhere.
            let is_driven = self.gap.least(journal) < NEARLY_CONTACT * problem.bearing.clearance;
            let is_tilted = problem.journal.tilt != [0.0; 2];
            // A tilted film may point towards the load at several contacts: the best of them counts.
            let beyond = match is_tilted {
                true => self.beyond_contact(problem),
                false => is_driven.then(|| self.beyond_capacity(problem, journal)).flatten(),
            };
            if let Some(beyond) = beyond {
                return Err(beyond);
            }
            // Where the wall gives way films take long, and those in a rigid one lead as near.
            let guide = problem.deflection().map(|_| self.in_rigid_wall(problem));
            let (asked, search) = guide.as_ref().map_or((problem, self), |(rigid, search)| (rigid, search));
            let starts = search.starts(asked);
            let descended = starts.iter().take(STARTS).map(|start| search.descended(asked, start));
            let starts = starts.iter().take(STARTS).copied().chain(descended);
            for start in starts {
                outcome = self.run(problem, start);
                if outcome.is_ok() {
                    break;
                }
            }
        }
        outcome.map_err(|reason| self.confirmed(reason))
    }
}
