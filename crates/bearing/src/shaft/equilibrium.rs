//! A shaft at rest on its films under loads that do not change, by the one Newton's method ([`crate::newton`]).
//!
//! The journals begin near the middle of their bearings with pseudo-time, on the coarsest meshes; from there the
//! balance is led from mesh to mesh. Pseudo-time leads the tilting journals of a shaft on full films round and round:
//! where it ends without a balance they sink by implicit steps in time that grow. These alone would not do: films that
//! conserve their oil, in walls that give way, have no such steps on coarse meshes.

use oilwedge_reynolds::NoFilm;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::solve::Neighbour;
use rayon::prelude::*;

use super::films::{Films, ShaftFilm};
use super::joined::{ShaftBalance, magnitude};
use crate::coordinates::{Vector, length, moved};
use crate::coupled::FilmSolve;
use crate::deflection::CLOSED;
use crate::newton::{BalanceTolerance, Damping};
use crate::no_equilibrium::SearchEnd;
use crate::orbit::{Instant, Moving};
use crate::search::{Search, Trial};
use crate::stiffness::Stiffness;
use crate::time_terms::TimeTerms;
use crate::together::Coupled;
use crate::{Deadline, JournalLoad, SearchOptions, Tilting};

/// What a balance may leave: round-off of the films.
const GOAL: BalanceTolerance = BalanceTolerance { balanced: 1e-11, closed: CLOSED, moved: 1e-8, rounding: 1e-8 };
/// What a step in time may leave, which only leads to the balance.
const ROUGHLY: BalanceTolerance = BalanceTolerance { balanced: 1e-3, closed: 1e-3, moved: 1e-2, rounding: 1e-3 };
/// The first step in time, over 1/omega: that of half a radian.
const FIRST: f64 = 0.5;
/// A step in time is longer by this factor than the one before.
const GROWTH: f64 = 2.5;
/// A step in time without a solution is divided by this.
const RETRY: f64 = 4.0;
/// Shortest step in time, over 1/omega.
const SHORTEST: f64 = 5e-7;
/// Sinking ends where a step in time is this long, over 1/omega: then the journals rest.
const LONGEST: f64 = 1e6;
/// A balance at rest is tried where the journals move by less than this part of their gaps in the time 1/omega.
const AT_REST: f64 = 1e-2;
/// Most steps in time: some 25 lead from the first to the longest, four times as many are for retries.
const MOST_STEPS: usize = 120;

/// A shaft in balance.
#[derive(Debug)]
pub struct ShaftEquilibrium {
    /// The films.
    pub instants: Vec<Instant>,
    /// What is left of the balance, over the load [1].
    pub residual: f64,
    /// Films solved on the meshes of the bearings.
    pub films: usize,
}

/// A bearing, by its number from 0, that has no film, and why.
#[derive(Debug, thiserror::Error)]
#[error("{reason}")]
pub struct NoFilmAt {
    /// The bearing.
    pub bearing: usize,
    /// Why.
    pub reason: NoFilm,
}

/// Why a shaft has no balance.
#[derive(Debug, thiserror::Error)]
pub enum NoBalance {
    /// A journal has no film.
    #[error("no film: {0}")]
    Film(NoFilmAt),
    /// The search does not converge.
    #[error(
        "not converged: the balance of the shaft is left by {residual:.1e} of the load, where the least film is {gap:.2e} of the clearance"
    )]
    Stuck {
        /// What is left of the balance, over the load [1].
        residual: f64,
        /// The bearing with the least film, by its number from 0.
        bearing: usize,
        /// Least film over the clearance [1].
        gap: f64,
    },
    /// The time was over.
    #[error("not converged: the search for the balance of the shaft was ended")]
    Ended,
}

impl From<NoFilmAt> for NoBalance {
    fn from(reason: NoFilmAt) -> Self {
        Self::Film(reason)
    }
}

/// Where a journal and its film begin.
#[derive(Clone, Copy)]
struct JournalStart<'a> {
    at: Vector,
    wall: Option<&'a Deflection>,
    near: Neighbour<'a>,
}

/// How a balance is found from a beginning.
#[derive(Clone, Copy)]
struct BalanceSearch {
    goal: BalanceTolerance,
    damping: Damping,
    /// `1/dt` of a step in time [1/s]; `None`: the journals are at rest.
    per_time: Option<f64>,
    deadline: Deadline,
}

impl BalanceSearch {
    /// To journals at rest.
    fn at_rest(deadline: Deadline) -> Self {
        Self { goal: GOAL, damping: Damping::None, per_time: None, deadline }
    }
}

impl ShaftEquilibrium {
    /// A beginning from its journals, walls and films.
    fn begun(&self) -> Vec<JournalStart<'_>> {
        self.instants.iter().map(|here| JournalStart::of(here, Neighbour::Start(&here.film))).collect()
    }
}

impl<'a> JournalStart<'a> {
    /// At a place [m], under a wall that is not bent.
    fn at(at: Vector) -> Self {
        Self { at, wall: None, near: Neighbour::None }
    }

    /// At a journal and under its wall, with a film near to it.
    fn of(here: &'a Instant, near: Neighbour<'a>) -> Self {
        Self { at: here.at, wall: here.film.problem.deflection(), near }
    }
}

impl ShaftFilm<'_> {
    /// The search for its journal under what the shaft gives it; residuals are relative to the force `scale` [N].
    fn search<'s>(&'s self, options: SearchOptions<'s>, scale: f64) -> Search<'s> {
        let free = Tilting { moment: [0.0; 2], stiffness: 0.0, support: [0.0; 2] };
        let load = JournalLoad { force: [0.0; 2], tilting: (self.coordinates.order == 4).then_some(free) };
        Search::new(&self.problem, self.system, load, options).relative_to(scale)
    }
}

impl Films<'_> {
    /// The balance under loads on the journals [N], the shaft turned by `angle` [rad].
    ///
    /// # Errors
    /// [`NoBalance`]: why there is none.
    pub fn balance(&self, asked: &[Vector], angle: f64, deadline: Deadline) -> Result<ShaftEquilibrium, NoBalance> {
        let joined = self.joined(asked, angle);
        let coarser = self.coarser();
        let found = coarser.and_then(|coarser| coarser.balance(asked, angle, deadline).ok());
        if let Some(found) = found {
            let films = self.films.iter().zip(&found.instants);
            let starts: Vec<_> = films
                .map(|(film, here)| film.system.coarser.as_ref().map(|coarser| coarser.start_of(&here.film)))
                .collect();
            let near = starts.iter().map(|start| start.as_ref().map_or(Neighbour::None, Neighbour::Coarser));
            let begun: Vec<JournalStart> =
                found.instants.iter().zip(near).map(|(here, near)| JournalStart::of(here, near)).collect();
            if let Ok(found) = self.rested(&joined, &begun, BalanceSearch::at_rest(deadline)) {
                return Ok(found);
            }
        }
        let begun: Vec<JournalStart> = self.first_places(asked).into_iter().map(JournalStart::at).collect();
        let way = BalanceSearch { damping: Damping::PseudoTime, ..BalanceSearch::at_rest(deadline) };
        match self.rested(&joined, &begun, way) {
            Err(_) if !deadline.is_over() => self.sunk(&joined, &begun, deadline),
            outcome => outcome,
        }
    }

    /// The balance, by sinking from these beginnings.
    fn sunk(
        &self,
        joined: &ShaftBalance,
        first: &[JournalStart],
        deadline: Deadline,
    ) -> Result<ShaftEquilibrium, NoBalance> {
        let speed = self.films.iter().map(|film| film.problem.journal.speed.abs()).fold(f64::MIN_POSITIVE, f64::max);
        let (mut here, mut dt): (Option<ShaftEquilibrium>, f64) = (None, FIRST);
        for _ in 0..MOST_STEPS {
            let near = here.as_ref().map(ShaftEquilibrium::begun);
            let way = BalanceSearch { goal: ROUGHLY, per_time: Some(speed / dt), ..BalanceSearch::at_rest(deadline) };
            match self.rested(joined, near.as_deref().unwrap_or(first), way) {
                Ok(found) => {
                    let is_last = dt > LONGEST;
                    let is_slow = here.as_ref().is_some_and(|here| self.part_of_gap(here, &found) < AT_REST * dt);
                    if is_last || is_slow {
                        match self.rested(joined, &found.begun(), BalanceSearch::at_rest(deadline)) {
                            // A slower journal may have one.
                            Err(_) if !is_last && !deadline.is_over() => {}
                            outcome => return outcome,
                        }
                    }
                    (here, dt) = (Some(found), GROWTH * dt);
                }
                Err(reason) if dt < SHORTEST || deadline.is_over() => return Err(reason),
                Err(_) => dt /= RETRY,
            }
        }
        self.rested(
            joined,
            here.as_ref().map(ShaftEquilibrium::begun).as_deref().unwrap_or(first),
            BalanceSearch::at_rest(deadline),
        )
    }

    /// The greatest way of a journal from one balance to another, over its least gap [1].
    fn part_of_gap(&self, from: &ShaftEquilibrium, to: &ShaftEquilibrium) -> f64 {
        let gap = |(film, here): (&ShaftFilm, &Instant)| film.motion().least_gap_under(here.wall(), here.at);
        let gaps = self.films.iter().zip(&to.instants).map(gap);
        let ways = from.instants.iter().zip(&to.instants).map(|(from, to)| length(moved(to.at, -1.0, from.at)));
        ways.zip(gaps).map(|(way, gap)| way / gap).fold(0.0, f64::max)
    }

    /// The balance near another one, where more accurate films carry so much `more` [N] in its places: it is that of
    /// those films.
    ///
    /// # Errors
    /// [`NoBalance`]: why there is none.
    pub fn rebalanced(
        &self,
        asked: &[Vector],
        angle: f64,
        near: &ShaftEquilibrium,
        more: &[Vector],
    ) -> Result<ShaftEquilibrium, NoBalance> {
        let joined = self.joined(asked, angle);
        let by_more = joined.by_films(more);
        let asked: Vec<Vector> = asked.iter().zip(by_more).map(|(asked, more)| moved(*asked, -1.0, more)).collect();
        self.rested(&self.joined(&asked, angle), &near.begun(), BalanceSearch::at_rest(Deadline::default()))
    }

    /// How all journals move [m] where one film carries somewhat more [N] in its place, for each such bearing, by its
    /// number, and force; not finite where the tangent is singular.
    ///
    /// # Errors
    /// [`NoFilmAt`]: the linear systems of a film could not be solved.
    pub fn moved_by(
        &self,
        instants: &[Instant],
        angle: f64,
        more: &[(usize, Vector)],
    ) -> Result<Vec<Vec<Vector>>, NoFilmAt> {
        let slope = |(bearing, (film, here)): (usize, (&ShaftFilm, &Instant))| {
            let slope = film.motion().tangent(here, 1.0, 0.0);
            slope.map_err(|reason| NoFilmAt { bearing, reason })
        };
        let films = self.films.par_iter().zip(instants).enumerate();
        let slopes = films.map(slope).collect::<Result<Vec<Stiffness>, NoFilmAt>>()?;
        let joined = self.joined(&vec![[0.0; 4]; self.films.len()], angle);
        let moved_by = |&(bearing, force): &(usize, Vector)| {
            let mut carried = vec![[0.0; 4]; self.films.len()];
            carried[bearing] = force.map(|part| -part);
            let step = joined.solve(&slopes, &joined.by_films(&carried));
            step.unwrap_or_else(|| vec![[f64::NAN; 4]; self.films.len()])
        };
        Ok(more.iter().map(moved_by).collect())
    }

    /// The balance from this beginning: of journals at rest, or at the end of a step in time from their places there.
    fn rested(
        &self,
        joined: &ShaftBalance,
        begun: &[JournalStart],
        way: BalanceSearch,
    ) -> Result<ShaftEquilibrium, NoBalance> {
        let BalanceSearch { goal, damping, per_time, deadline } = way;
        let options = SearchOptions { deadline, ..SearchOptions::default() };
        let scale = match magnitude(&joined.asked) {
            0.0 => self.films.iter().map(|film| film.motion().peak_load()).fold(f64::MIN_POSITIVE, f64::max),
            load => load,
        };
        let in_time = |begin: &JournalStart| {
            let still = |per_time: f64| TimeTerms { per_time, offset: begin.at, rate: [0.0; 4], masses: [0.0; 4] };
            per_time.map(still)
        };
        let searches: Vec<Search> = (self.films.iter().zip(begun))
            .map(|(film, begin)| Search { time: in_time(begin), ..film.search(options, scale) })
            .collect();
        let open = |(bearing, (search, begin)): (usize, (&Search, &JournalStart))| {
            let bent = self.films[bearing].problem.clone().deflected(begin.wall);
            let film = search.open(&bent, begin.at, FilmSolve::Settled(begin.near), goal.closed);
            film.map_err(|reason| NoFilmAt { bearing, reason })
        };
        let films = searches.par_iter().zip(begun).enumerate();
        let first = films.map(open).collect::<Result<Vec<Trial>, NoFilmAt>>()?;
        let mut tried = first.len();
        let coupled = Coupled { searches: &searches, shaft: Some(joined) };
        let (trials, end) = coupled.newton(first, goal, damping, &mut tried);
        let residual = coupled.residual(&trials);
        match end {
            None => {}
            Some(SearchEnd::Ended) => return Err(NoBalance::Ended),
            Some(_) => return Err(self.stuck(residual, &searches, &trials)),
        }
        let instant = |(bearing, trial): (usize, Trial)| {
            let (motion, at) = (self.films[bearing].motion(), searches[bearing].place(&trial));
            let here = motion.instant(Moving { time: 0.0, at, velocity: [0.0; 4] }, trial.film, &trial.carried);
            motion.accepted(here).map_err(|reason| NoFilmAt { bearing, reason })
        };
        let instants = trials.into_iter().enumerate().map(instant).collect::<Result<Vec<Instant>, NoFilmAt>>()?;
        Ok(ShaftEquilibrium { instants, residual, films: tried })
    }

    /// Where a search has got to that does not converge.
    fn stuck(&self, residual: f64, searches: &[Search], trials: &[Trial]) -> NoBalance {
        let gap = |(search, trial): (&Search, &Trial)| search.least_film(trial) / search.gap.bearing().clearance;
        let gaps = searches.iter().zip(trials).map(gap).enumerate();
        let first = (0, f64::INFINITY);
        let (bearing, gap) = gaps.fold(first, |best, it| if it.1 < best.1 { it } else { best });
        NoBalance::Stuck { residual, bearing, gap }
    }
}
