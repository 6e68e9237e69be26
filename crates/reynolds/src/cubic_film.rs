//! The film in cubic elements on the same mesh: the more accurate one by which the error of the quadratic one is
//! estimated.
//!
//! It starts from the quadratic film and is solved on top of its factor. A Swift-Stieber cavity is found anew: with the
//! cavity of the quadratic film the difference of the two would not contain the error of the cavity's edge, which is
//! most of it.
//!
//! Source: the difference of two degrees as an error estimate goes back to Bank and Smith, SIAM J. Numer. Anal. 30
//! (1993) 921.

use oilwedge_fem::LinearSolver;
use oilwedge_fem::complementarity::WarmStart;
use oilwedge_fem::nested::Nested;

use crate::film_start::StepBudget;
use crate::{Form, NoFilm, SolvedFilm};

impl SolvedFilm {
    /// The film in cubic elements, on [`FilmSystem::cubic`](crate::FilmSystem::cubic), from this one in quadratic
    /// elements; from the cavity of a cubic film at a `neighbour`ing operating point, if there is one. Not for models
    /// that conserve oil.
    ///
    /// # Errors
    /// [`NoFilm`]: the reason why there is none.
    pub fn cubic_film(&self, neighbour: Option<&Self>) -> Result<Self, NoFilm> {
        let cubic = match (self.cubic_film_unchecked(neighbour), self.problem.form) {
            // Quadratic elements have a film.
            (Err(NoFilm::NotConverged(_)), Form::AsPrinted) => {
                let asked = self.problem.journal.speed.abs();
                return Err(NoFilm::AtFold { asked, history: self.solution.history.clone() });
            }
            (cubic, _) => cubic?,
        };
        match cubic.check_existence() {
            Ok(()) => Ok(cubic),
            Err(NoFilm::AboveLimit { limit, .. }) => Err(self.beyond(limit)),
            Err(reason) => Err(reason),
        }
    }

    /// The film in cubic elements whether or not the viscosity law has a pressure for it.
    pub(crate) fn cubic_film_unchecked(&self, neighbour: Option<&Self>) -> Result<Self, NoFilm> {
        let Self { problem, system, solution } = self;
        let (cubic, neighbour) = (system.cubic(), neighbour.map(|neighbour| &neighbour.solution));
        // While a wall is closed the neighbour comes as near as the wall, and conjugate gradients end at a part of what
        // they begin with.
        let u = match neighbour.filter(|_| problem.deflection().is_some()) {
            Some(neighbour) => neighbour.unknown.clone(),
            None => cubic.prolongation.prolong(&solution.unknown),
        };
        let held = match (neighbour, problem.cavitation.pressure()) {
            (Some(neighbour), _) => neighbour.cavity.clone(),
            (None, Some(pressure)) => {
                let level = problem.unknown_at(pressure);
                u.iter().map(|&u| u <= level).collect()
            }
            (None, None) => vec![false; u.len()],
        };
        let solver = LinearSolver::Nested(Nested {
            quadratic: solution.linearisation.clone(),
            prolongation: cubic.prolongation.clone(),
            direct: cubic.system.analysis.clone(),
        });
        let solution =
            problem.pressure_film((&cubic.system, &solver, 1.0), WarmStart { u, held }, StepBudget::UntilSettled)?;
        Ok(Self::new(problem.clone(), &cubic.system, solution))
    }
}
