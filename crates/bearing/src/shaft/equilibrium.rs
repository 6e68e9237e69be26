//! A shaft at rest on its films under loads that do not change, by the one Newton's method ([`crate::newton`]): from the
//! middle on the coarsest meshes, from mesh to mesh from there.

use oilwedge_reynolds::NoFilm;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::solve::Neighbour;
use rayon::prelude::*;

use super::films::{Film, Films};
use super::joined::{ShaftBalance, magnitude};
use crate::coordinates::{Vector, moved};
use crate::coupled::FilmSolve;
use crate::deflection::CLOSED;
use crate::newton::{Damping, Goal};
use crate::no_equilibrium::SearchEnd;
use crate::orbit::{Instant, Moving};
use crate::search::{Search, Trial};
use crate::stiffness::Stiffness;
use crate::together::Coupled;
use crate::{Deadline, Load, SearchOptions, Tilting};

/// What a balance may leave.
const GOAL: Goal = Goal { balanced: 1e-11, closed: CLOSED, moved: 1e-8, rounding: 1e-8 };

/// A shaft in balance.
#[derive(Debug)]
pub struct Balance {
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
        /// That film over the clearance [1].
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
struct Begin<'a> {
    at: Vector,
    wall: Option<&'a Deflection>,
    near: Neighbour<'a>,
}

impl<'a> Begin<'a> {
    /// At a journal and under its wall, with a film near to it.
    fn of(here: &'a Instant, near: Neighbour<'a>) -> Self {
        Self { at: here.at, wall: here.film.problem.deflection(), near }
    }
}

impl Film<'_> {
    /// The search for its journal under what the shaft gives it; residuals are relative to the force `scale` [N].
    fn search<'s>(&'s self, options: SearchOptions<'s>, scale: f64) -> Search<'s> {
        let free = Tilting { moment: [0.0; 2], stiffness: 0.0, support: [0.0; 2] };
        let load = Load { force: [0.0; 2], tilting: (self.coordinates.order == 4).then_some(free) };
        Search::new(&self.problem, self.system, load, options).relative_to(scale)
    }
}

impl Films<'_> {
    /// The balance under loads on the journals [N], the shaft turned by `angle` [rad].
    ///
    /// # Errors
    /// [`NoBalance`]: why there is none.
    pub fn balance(&self, asked: &[Vector], angle: f64, deadline: Deadline) -> Result<Balance, NoBalance> {
        let joined = self.joined(asked, angle);
        let coarser = self.coarser();
        let found = coarser.and_then(|coarser| coarser.balance(asked, angle, deadline).ok());
        if let Some(found) = found {
            let films = self.films.iter().zip(&found.instants);
            let starts: Vec<_> = films
                .map(|(film, here)| film.system.coarser.as_ref().map(|coarser| coarser.start_of(&here.film)))
                .collect();
            let near = starts.iter().map(|start| start.as_ref().map_or(Neighbour::None, Neighbour::Coarser));
            let begun: Vec<Begin> = found.instants.iter().zip(near).map(|(here, near)| Begin::of(here, near)).collect();
            if let Ok(found) = self.rested(&joined, &begun, Damping::None, deadline) {
                return Ok(found);
            }
        }
        let begin = |at: Vector| Begin { at, wall: None, near: Neighbour::None };
        let begun: Vec<Begin> = self.first_places(asked).into_iter().map(begin).collect();
        self.rested(&joined, &begun, Damping::PseudoTime, deadline)
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
        near: &Balance,
        more: &[Vector],
    ) -> Result<Balance, NoBalance> {
        let joined = self.joined(asked, angle);
        let by_more = joined.by_films(more);
        let asked: Vec<Vector> = asked.iter().zip(by_more).map(|(asked, more)| moved(*asked, -1.0, more)).collect();
        let near = near.instants.iter();
        let begun: Vec<Begin> = near.map(|here| Begin::of(here, Neighbour::Start(&here.film))).collect();
        self.rested(&self.joined(&asked, angle), &begun, Damping::None, Deadline::default())
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
        let slope = |(bearing, (film, here)): (usize, (&Film, &Instant))| {
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

    /// The balance from this beginning.
    fn rested(
        &self,
        joined: &ShaftBalance,
        begun: &[Begin],
        damping: Damping,
        deadline: Deadline,
    ) -> Result<Balance, NoBalance> {
        let options = SearchOptions { deadline, ..SearchOptions::default() };
        let scale = match magnitude(&joined.asked) {
            0.0 => self.films.iter().map(|film| film.motion().peak_load()).fold(f64::MIN_POSITIVE, f64::max),
            load => load,
        };
        let searches: Vec<Search> = self.films.iter().map(|film| film.search(options, scale)).collect();
        let open = |(bearing, (search, begin)): (usize, (&Search, &Begin))| {
            let bent = self.films[bearing].problem.clone().deflected(begin.wall);
            let film = search.open(&bent, begin.at, FilmSolve::Settled(begin.near), GOAL.closed);
            film.map_err(|reason| NoFilmAt { bearing, reason })
        };
        let films = searches.par_iter().zip(begun).enumerate();
        let first = films.map(open).collect::<Result<Vec<Trial>, NoFilmAt>>()?;
        let mut tried = first.len();
        let coupled = Coupled { searches: &searches, shaft: Some(joined) };
        let (trials, end) = coupled.newton(first, GOAL, damping, &mut tried);
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
        Ok(Balance { instants, residual, films: tried })
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
