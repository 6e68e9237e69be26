//! Solution of a film: from rest, from coarser meshes, from a neighbouring film, and by continuation in the speed.

use std::sync::Arc;

use oilwedge_fem::complementarity::{self, Obstacle, WarmStart};
use oilwedge_fem::newton::{self, Equation, NewtonFailure};
use oilwedge_fem::{Constraints, Error, LinearSolver};

use crate::film_law::FilmLaw;
use crate::film_start::{FilmStart, StepBudget};
use crate::{FilmProblem, FilmSolution, FilmSystem, FilmTrace, Form, NoFilm, SolvedFilm};

/// Part of the given speed to which the greatest speed of an as-printed film is bisected.
const FOLD_RESOLUTION: f64 = 1e-4;

/// The film from which a solve starts.
#[derive(Debug, Clone, Copy)]
pub enum Neighbour<'a> {
    /// No film: coarser meshes are solved first, if there are any.
    None,
    /// A film of the same system.
    Start(&'a SolvedFilm),
    /// A film of the same system, as it was stored.
    Found(&'a FilmTrace),
    /// The film of a coarser mesh.
    Coarser(&'a FilmStart),
}

impl FilmProblem {
    /// Solves the film.
    ///
    /// # Errors
    /// [`NoFilm`]: the reason why there is none.
    pub fn solve(&self, system: &Arc<FilmSystem>) -> Result<SolvedFilm, NoFilm> {
        self.solve_from(system, Neighbour::None).map_err(|reason| match reason {
            NoFilm::AboveLimit { reached, limit, ratio, law, .. } => {
                NoFilm::AboveLimit { reached, limit, ratio, law, greatest_speed: self.greatest_speed(system, limit) }
            }
            other => other,
        })
    }

    /// Solves the film, started from that of a neighbouring operating point on the same system.
    ///
    /// # Errors
    /// [`NoFilm`]: the reason why there is none; up to which speed there is one is not sought here.
    pub fn solve_from(&self, system: &Arc<FilmSystem>, neighbour: Neighbour) -> Result<SolvedFilm, NoFilm> {
        let solution = self.closed_film(system, 1.0, neighbour);
        let solution = match self.form {
            Form::Conservative => solution?,
            Form::AsPrinted => solution.or_else(|_| self.continue_in_speed(system))?,
        };
        let film = SolvedFilm::new(self.clone(), system, solution);
        match film.check_existence() {
            Ok(()) => Ok(film),
            Err(NoFilm::AboveLimit { limit, .. }) => Err(film.beyond(limit)),
            Err(reason) => Err(reason),
        }
    }

    /// Solves the film with the cavity of `start` alone: one factorisation of a film whose law is linear. The dofs that
    /// are then on the wrong side are [`FilmSolution::wrong`]; the film is settled where there are none.
    ///
    /// # Errors
    /// [`NoFilm`]: the reason why there is none.
    pub fn step(&self, system: &Arc<FilmSystem>, start: FilmStart) -> Result<SolvedFilm, NoFilm> {
        if self.form == Form::AsPrinted {
            return self.solve_from(system, Neighbour::None);
        }
        let FilmStart(start) = start;
        let solution = self.cavitation.solve((self, system, 1.0), start, StepBudget::One)?;
        let film = SolvedFilm::new(self.clone(), system, solution);
        match film.solution.wrong.is_empty() {
            true => film.check_existence().map(|()| film),
            false => Ok(film),
        }
    }

    /// Prepares `system` for the solves of this film at once, so that one too large for the machine is refused before
    /// any work.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub fn prepare(&self, system: &FilmSystem) -> Result<(), Error> {
        match self.cavitation.is_symmetric() {
            true => system.solver().map(drop),
            false => Ok(()),
        }
    }

    /// True if the film is found by iteration, and faster from the film of a coarser mesh.
    pub fn needs_start(&self) -> bool {
        self.cavitation.has_free_boundary() || self.form == Form::AsPrinted
    }

    /// The film with all motion of the journal scaled by `motion`, its equation closed by the cavitation model,
    /// whether or not the viscosity law has a pressure for it.
    pub(crate) fn closed_film(
        &self,
        system: &FilmSystem,
        motion: f64,
        neighbour: Neighbour,
    ) -> Result<FilmSolution, NoFilm> {
        let (start, levels) = match neighbour {
            Neighbour::Start(film) => (film.solution.as_start(), 0),
            Neighbour::Found(trace) => (trace.as_start(), 0),
            Neighbour::Coarser(FilmStart(start)) => (start.clone(), 0),
            // What the film held is known on its own mesh alone.
            Neighbour::None if self.storage.is_some() => (full_film(system), 0),
            Neighbour::None => self.start(system, motion),
        };
        let film = self.cavitation.solve((self, system, motion), start, StepBudget::UntilSettled)?;
        Ok(FilmSolution { levels, ..film })
    }

    /// The film of the next coarser mesh, if there is one, and on how many meshes it was solved; else nothing.
    fn start(&self, system: &FilmSystem, motion: f64) -> (WarmStart, usize) {
        let coarse = system.coarser.as_ref().and_then(|coarser| {
            let film = coarser.problem(self).closed_film(&coarser.system, motion, Neighbour::None).ok()?;
            Some((coarser.carried(&film, self.cavitation), film.levels + 1))
        });
        coarse.unwrap_or_else(|| (full_film(system), 0))
    }

    /// Pressure [Pa] that a film makes whose thickness changes by itself within the time `1/rate` [1/s].
    pub(crate) fn pressure_of(&self, rate: f64) -> f64 {
        self.lubricant.viscosity * rate * (self.bearing.radius / self.bearing.clearance).powi(2)
    }

    /// Pressure [Pa] that drag through the clearance makes, `mu0 U R/c^2`, that of squeeze likewise, or the
    /// greatest given one.
    pub(crate) fn pressure_scale(&self, constraints: &Constraints) -> f64 {
        let gap_speed = self.journal.gap_speed(0.5 * self.bearing.length);
        let motion = self.journal.speed.abs() + gap_speed / self.bearing.clearance;
        let drag = self.pressure_of(motion);
        (constraints.values.iter()).fold(drag, |scale, given| scale.max(given.abs()))
    }

    /// A film described by its pressure alone: full, or nowhere below the cavitation pressure.
    pub(crate) fn pressure_film(
        &self,
        (system, solver, motion): (&FilmSystem, &LinearSolver, f64),
        start: WarmStart,
        steps: StepBudget,
    ) -> Result<FilmSolution, NewtonFailure> {
        let law = FilmLaw::new(self, motion);
        let constraints = system.supply.constraints(|p| self.unknown_at(p));
        let equation = Equation {
            assembler: &system.assembler,
            solver,
            law: &law,
            constraints: &constraints,
            scale: self.pressure_scale(&constraints),
        };
        let Some(pressure) = self.cavitation.obstacle() else {
            return Ok(FilmSolution::full(newton::solve(&equation, start.u)?));
        };
        let floor = self.unknown_at(pressure);
        let obstacle = match system.space().degree() {
            2 => Obstacle::at_midpoints(system.space(), floor),
            _ => Obstacle::at_nodes(system.space(), floor),
        };
        let (contact, wrong) = match steps {
            StepBudget::UntilSettled => (complementarity::solve(&equation, &obstacle, start)?, Vec::new()),
            StepBudget::One => complementarity::step(&equation, &obstacle, start)?,
        };
        Ok(FilmSolution { cavity: contact.held, wrong, ..FilmSolution::full(contact.solution) })
    }

    /// Raises the speed from rest in steps, each started from the last solution. The least steps
    /// close in on the fold, the speed past which the stable branch has no solution.
    fn continue_in_speed(&self, system: &FilmSystem) -> Result<FilmSolution, NoFilm> {
        let mut film = self.closed_film(system, 0.0, Neighbour::None)?;
        let (mut reached, mut step) = (0.0, 0.25);
        loop {
            let next: f64 = f64::min(reached + step, 1.0);
            match self.cavitation.solve((self, system, next), film.as_start(), StepBudget::UntilSettled) {
                Ok(mut solution) => {
                    let mut history = film.history;
                    history.append(&mut solution.history);
                    film = FilmSolution { history, ..solution };
                    reached = next;
                    if reached == 1.0 {
                        return Ok(film);
                    }
                }
                Err(_) if step > FOLD_RESOLUTION => step *= 0.5,
                Err(failure) => return Err(self.fold_between([reached, next], failure)),
            }
        }
    }

    /// Outcome of the least step that fails, between two parts of the speed: the fold of the stable branch, or else the
    /// failure itself.
    fn fold_between(&self, [reached, next]: [f64; 2], failure: NoFilm) -> NoFilm {
        let asked = self.journal.speed.abs();
        let part = match &failure {
            // The tangent is singular at a fold, and Newton's method finds nothing beyond.
            NoFilm::NotConverged(
                NewtonFailure::Stagnated { .. }
                | NewtonFailure::TooManySteps { .. }
                | NewtonFailure::Linear { error: Error::NotPositiveDefinite, .. },
            ) if reached > 0.0 => reached,
            // There is a film at rest, and none after the least step: the fold lies between.
            NoFilm::NotConverged(NewtonFailure::Linear { error: Error::NotPositiveDefinite, .. }) => next,
            _ => return failure,
        };
        NoFilm::Fold { last: part * asked, asked }
    }
}

/// A full film without pressure.
fn full_film(system: &FilmSystem) -> WarmStart {
    let dofs = system.space().dofs();
    let (u, held) = (vec![0.0; dofs], vec![false; dofs]);
    WarmStart { u, held }
}
