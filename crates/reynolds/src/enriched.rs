//! The same film in cubic elements on the same mesh: the better answer by which the quadratic one is judged.
//!
//! Started from the quadratic film and solved on top of its factor. A Swift-Stieber cavity is found anew: with the cavity
//! of the quadratic film the difference of the two would say nothing about the edge of the film, where most of the error is.
//!
//! Source: the difference of two degrees as an error estimate goes back to Bank and Smith, SIAM J. Numer. Anal. 30 (1993) 921.

use oilwedge_fem::LinearSolver;
use oilwedge_fem::complementarity::Start;
use oilwedge_fem::nested::Nested;

use crate::{FilmProblem, FilmSolution, FilmSystem, Form, NoFilm};

impl FilmProblem {
    /// The film in cubic elements, on `system.enriched()`, from the quadratic `film`. Not for mass-conserving films.
    ///
    /// # Errors
    /// [`NoFilm`]: the reason why there is none.
    pub fn enriched(&self, system: &FilmSystem, film: &FilmSolution) -> Result<FilmSolution, NoFilm> {
        let start = self.quadratic_start(system, film);
        self.enriched_from(system, film, start)
    }

    /// The quadratic film as one of cubic elements, its cavity where it is at the pressure of the cavity.
    fn quadratic_start(&self, system: &FilmSystem, film: &FilmSolution) -> Start {
        let u = system.enriched().prolongation.prolong(&film.unknown);
        let held = match self.cavitation.pressure() {
            Some(pressure) => {
                let level = self.unknown_at(pressure);
                u.iter().map(|&u| u <= level).collect()
            }
            None => vec![false; u.len()],
        };
        Start { u, held }
    }

    /// The same with the cavity of the cubic film of a neighbouring operating point to start from.
    ///
    /// # Errors
    /// As [`FilmProblem::enriched`].
    pub fn enriched_near(
        &self,
        system: &FilmSystem,
        film: &FilmSolution,
        neighbour: &FilmSolution,
    ) -> Result<FilmSolution, NoFilm> {
        let u = system.enriched().prolongation.prolong(&film.unknown);
        let held = neighbour.cavity.clone();
        self.enriched_from(system, film, Start { u, held })
    }

    /// The same whether or not the viscosity law has a pressure for it.
    ///
    /// # Errors
    /// [`NoFilm`]: it was not reached.
    pub(crate) fn enriched_unchecked(&self, system: &FilmSystem, film: &FilmSolution) -> Result<FilmSolution, NoFilm> {
        let start = self.quadratic_start(system, film);
        self.cubic_film(system, film, start)
    }

    fn enriched_from(&self, system: &FilmSystem, film: &FilmSolution, start: Start) -> Result<FilmSolution, NoFilm> {
        let cubic = self.cubic_film(system, film, start)?;
        match self.check_existence(&system.enriched().system, &cubic) {
            Ok(()) => Ok(cubic),
            // Quadratic elements have a film.
            Err(NoFilm::AboveLimit { .. }) if matches!(self.form, Form::AsPrinted(_)) => Err(NoFilm::AtFold {
                asked: self.journal.speed.abs(),
                history: film.history.clone(),
            }),
            Err(NoFilm::AboveLimit { limit, .. }) => Err(self.beyond(system, film, limit)),
            Err(reason) => Err(reason),
        }
    }

    fn cubic_film(&self, system: &FilmSystem, film: &FilmSolution, start: Start) -> Result<FilmSolution, NoFilm> {
        let enriched = system.enriched();
        let solver = LinearSolver::Nested(Nested {
            quadratic: film.linearisation.clone(),
            prolongation: enriched.prolongation.clone(),
            direct: enriched.system.analysis.clone(),
        });
        Ok(self.pressure_film(&enriched.system, &solver, 1.0, start)?)
    }
}
