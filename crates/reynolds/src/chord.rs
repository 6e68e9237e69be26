//! The film of a neighbouring problem by one step of the chord method: with the tangent and the cavity of a film that
//! is solved.
//!
//! ```text
//! u' = u - K^-1 R'(u)
//! ```
//!
//! R' is the residual of the neighbouring problem, u and K are unknown and tangent of the film at hand. The step costs
//! one residual and one back-substitution, and is exact to first order in whatever differs: oil, speed, clearance,
//! given pressures, place and wall. The difference of two films on both sides of the one at hand gives derivatives
//! whose error falls with the square of their distance.
//!
//! **Source.** Kelley, Iterative Methods for Linear and Nonlinear Equations (1995), 5.4. **Range.** The cavity stays:
//! where it changes its nodes there are kinks of the discrete film. **Verified by** `tests/tests/sensitivity.rs`.

use std::sync::{Arc, OnceLock};

use oilwedge_fem::newton::NewtonFailure;

use crate::cavitation::{self, FilmFraction};
use crate::film_law::FilmLaw;
use crate::{FilmProblem, FilmSolution, FilmSystem, NoFilm, SolvedFilm};

impl SolvedFilm {
    /// The film of a neighbouring `problem`, on a `system` of the same unknowns, after one step from this one.
    ///
    /// # Errors
    /// [`NoFilm`]: no oil is supplied there, or the linear system could not be solved.
    pub fn chord(&self, problem: FilmProblem, system: &Arc<FilmSystem>) -> Result<Self, NoFilm> {
        let solution = match &self.solution.film_fraction {
            Some(fraction) => cavitation::chord(self, fraction, (&problem, system))?,
            None => {
                let (unknown, inflow) = self.pressure_chord(&problem, system).map_err(NewtonFailure::from)?;
                self.solution.beside(unknown, inflow, None)
            }
        };
        Ok(Self::new(problem, system, solution))
    }

    /// Unknown and inflow of a neighbouring film that is described by its pressure alone.
    fn pressure_chord(
        &self,
        problem: &FilmProblem,
        system: &FilmSystem,
    ) -> Result<(Vec<f64>, Vec<f64>), oilwedge_fem::Error> {
        let solution = &self.solution;
        let given = system.supply.constraints(|p| problem.unknown_at(p));
        let floor = |problem: &FilmProblem| problem.cavitation.obstacle().map_or(0.0, |p| problem.unknown_at(p));
        let raised = floor(problem) - floor(&self.problem);
        let mut start = solution.unknown.clone();
        for (dof, start) in start.iter_mut().enumerate() {
            match (given.fixed[dof], solution.cavity[dof]) {
                (true, _) => *start = given.values[dof],
                (false, true) => *start += raised,
                (false, false) => {}
            }
        }
        let before = system.assembler.residual(&FilmLaw::new(problem, 1.0), &start);
        let minus: Vec<f64> = before.iter().map(|r| -r).collect();
        let step = solution.linearisation.solve(&minus)?;
        let through = solution.linearisation.matrix().multiply(&step);
        let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + b).collect();
        Ok((sum(&start, &step), sum(&before, &through)))
    }
}

impl FilmSolution {
    /// The solution of a neighbouring film that the tangent of this one has led to: with its cavity.
    pub(crate) fn beside(&self, unknown: Vec<f64>, inflow: Vec<f64>, film_fraction: Option<FilmFraction>) -> Self {
        Self {
            unknown,
            inflow,
            film_fraction,
            cavity: self.cavity.clone(),
            linearisation: self.linearisation.clone(),
            gap_tangent: OnceLock::new(),
            wrong: self.wrong.clone(),
            history: Vec::new(),
            seconds: self.seconds,
            levels: 0,
            fallbacks: Vec::new(),
        }
    }
}
