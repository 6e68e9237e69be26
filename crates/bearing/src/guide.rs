//! The search for a film that conserves oil, guided by the Swift-Stieber film on the same mesh.
//!
//! **Why.** At one position of the journal the pressure p of a steady film that conserves oil nowhere exceeds the
//! Swift-Stieber pressure q: where p is above that of the cavity, both obey Reynolds' equation with a full gap, q as a
//! supersolution; at the edge of that region p is the pressure of the cavity, which q is not below, and the maximum
//! principle gives q >= p. The obstacle problem costs a small part of a film that conserves oil, and its force changes
//! smoothly with the position. So its balance is where the search begins. Where it has none the load is refused, and
//! the reason names that film: less pressure at every position makes a balance unlikely, but the inequality holds at
//! one position and is no proof for all of them. **Range.** Constant viscosity, Barus' and Roelands' laws.
//! **Verified by** `tests/full/tests/cavitation/guide.rs`.

use std::sync::Arc;

use oilwedge_reynolds::{FilmProblem, FilmSystem, JournalState};

use crate::balance::Balance;
use crate::equilibrium::ROUGHLY_BALANCED;
use crate::search::Search;
use crate::{Carrier, InitialGuess, NoEquilibrium, Purpose, SearchOptions};

impl Search<'_> {
    /// The balance found from that of the Swift-Stieber film, or why no position of that film carries the load. None
    /// where it leads nowhere, and for other films.
    pub(crate) fn guided(&self, problem: &FilmProblem) -> Option<Result<Balance, NoEquilibrium>> {
        let guide = FilmProblem { cavitation: problem.cavitation.guide()?, ..problem.clone() };
        let options = SearchOptions {
            accuracy: Some(ROUGHLY_BALANCED),
            carrier: Carrier::Quadratic,
            guess: InitialGuess::Cold,
            ..self.options
        };
        if problem.deflection().is_some() {
            return self.far_beyond(&guide, &options).map(Err);
        }
        match Search::new(&guide, self.system, self.load, options).on_coarsest(&guide)? {
            Ok(journal) => self.by_guide(problem, journal),
            // Its branch of a growing moment is another one than that of the film that conserves oil.
            Err(NoEquilibrium::EdgeContact { .. } | NoEquilibrium::TiltLimit { .. }) => None,
            Err(reason) => Some(Err(NoEquilibrium::OfGuide(Box::new(reason)))),
        }
    }

    /// Under a wall that gives way the guide has another gap, and starts badly; but where it carries far less than the
    /// load the film that conserves oil will not carry that. What a free tilt leads to is not known so, and for a start
    /// it was asked by the search on the finer mesh: the coarsest one is the same.
    fn far_beyond(&self, guide: &FilmProblem, options: &SearchOptions) -> Option<NoEquilibrium> {
        if self.load.tilting.is_some() || self.options.purpose == Purpose::Start {
            return None;
        }
        let (coarse, system) = self.coarsest(guide);
        let reason = Search::new(&coarse, system, self.load, *options).found(&coarse).err()?;
        reason.is_far_beyond().then(|| NoEquilibrium::OfGuide(Box::new(reason)))
    }

    /// A problem on the coarsest mesh.
    fn coarsest(&self, problem: &FilmProblem) -> (FilmProblem, &Arc<FilmSystem>) {
        let (mut coarse, mut system) = (problem.clone(), self.system);
        while let Some(coarser) = &system.coarser {
            (coarse, system) = (coarser.problem(&coarse), &coarser.system);
        }
        (coarse, system)
    }

    /// The balance found from that of the guide; where the tilt is free, along the branch of balances that begins
    /// there. None where neither leads to an answer.
    fn by_guide(&self, problem: &FilmProblem, journal: JournalState) -> Option<Result<Balance, NoEquilibrium>> {
        match self.run(problem, journal) {
            Ok(found) => Some(Ok(found)),
            Err(_) if self.load.tilting.is_none() => None,
            Err(_) => match self.along_branch(self.first(problem, journal).ok()?) {
                Err(reason) if !reason.is_beyond() && !self.options.deadline.is_over() => None,
                outcome => Some(outcome),
            },
        }
    }

    /// The journal balanced roughly on the coarsest mesh; or why there is no balance. What a thin film carries is
    /// judged by the mesh of the search; where the film of the coarsest mesh carries far less than the load, as it does
    /// there. None where neither is known.
    fn on_coarsest(&self, problem: &FilmProblem) -> Option<Result<JournalState, NoEquilibrium>> {
        let (coarse, system) = self.coarsest(problem);
        let reason = match Search::new(&coarse, system, self.load, self.options).found(&coarse) {
            Ok(found) => return Some(Ok(found.trial.film.problem.journal)),
            Err(reason) => reason,
        };
        match &reason {
            NoEquilibrium::EdgeContact { way: Some(way), .. } | NoEquilibrium::TiltLimit { way: Some(way), .. } => {
                match self.taken_up(problem, way) {
                    Ok(found) => Some(Ok(found.trial.film.problem.journal)),
                    Err(reason) => reason.is_beyond().then_some(Err(reason)),
                }
            }
            NoEquilibrium::BeyondCapacity { journal, .. } => self.beyond_capacity(problem, journal).map(Err),
            _ => reason.is_beyond().then_some(Err(reason)),
        }
    }
}
