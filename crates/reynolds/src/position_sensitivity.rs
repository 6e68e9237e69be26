//! How a solved film changes, to first order, where the journal moves: with the factors that are there.

use std::sync::OnceLock;

use oilwedge_fem::Error;
use oilwedge_fem::newton::Failure;

use crate::cavitation;
use crate::film_law::FilmLaw;
use crate::solve::Neighbour;
use crate::{FilmChange, FilmProblem, FilmSolution, FilmSystem, JournalChange, NoFilm};

impl FilmProblem {
    /// The film where the journal has moved by a small `change`: along the tangent, but for a mass-conserving one, which is
    /// solved again from the film that is there.
    ///
    /// # Errors
    /// [`NoFilm`]: the reason why there is none.
    pub fn displaced(
        &self,
        system: &FilmSystem,
        film: &FilmSolution,
        change: &JournalChange,
    ) -> Result<(Self, FilmSolution), NoFilm> {
        let mut problem = self.clone();
        problem.journal = problem.journal.changed(change);
        if film.film_fraction.is_some() {
            let film = problem.solve_from(system, Neighbour::Start(film))?;
            return Ok((problem, film));
        }
        let unknown = self.unknown_change(system, film, change).map_err(Failure::from)?;
        Ok((problem, self.along_tangent(system, film, &[change.into()], &unknown)))
    }

    /// A film without a film fraction along its tangent: after `changes`, by which its unknown changes by `unknown` at each dof.
    pub fn along_tangent(
        &self,
        system: &FilmSystem,
        film: &FilmSolution,
        changes: &[FilmChange<'_>],
        unknown: &[f64],
    ) -> FilmSolution {
        let add = |base: &[f64], change: &[f64]| base.iter().zip(change).map(|(b, c)| b + c).collect::<Vec<f64>>();
        let direct = |inflow: Vec<f64>, change: &FilmChange<'_>| {
            let changed = FilmLaw::changed(self, *change);
            add(&inflow, &system.assembler.residual(&changed, &film.unknown))
        };
        let inflow = changes.iter().fold(film.inflow.clone(), direct);
        let through = film.linearisation.matrix().multiply(unknown);
        FilmSolution {
            inflow: add(&inflow, &through),
            unknown: add(&film.unknown, unknown),
            cavity: film.cavity.clone(),
            film_fraction: None,
            linearisation: film.linearisation.clone(),
            gap_tangent: OnceLock::new(),
            history: Vec::new(),
            seconds: film.seconds,
            levels: 0,
            fallbacks: Vec::new(),
        }
    }

    /// First-order change of the unknown at each dof [Pa] with a `change` of the journal or the gap. The cavity stays, as
    /// it does to first order: the pressure is level at its edge.
    ///
    /// # Errors
    /// The linear system could not be solved.
    pub fn unknown_change<'a>(
        &self,
        system: &FilmSystem,
        film: &FilmSolution,
        change: impl Into<FilmChange<'a>>,
    ) -> Result<Vec<f64>, Error> {
        self.answer(film, &self.residual_change(system, film, change.into())?, 0.0)
    }

    /// First-order change of the unknown at each dof [Pa] by which a film answers to a change of its residual at each dof; its linear system may leave this `part` of that [1].
    ///
    /// # Errors
    /// The linear system could not be solved.
    pub fn answer(&self, film: &FilmSolution, residual: &[f64], part: f64) -> Result<Vec<f64>, Error> {
        let minus: Vec<f64> = residual.iter().map(|r| -r).collect();
        let mut unknown = film.linearisation.solve_within(&minus, part)?;
        if film.film_fraction.is_some() {
            // In the cavity it is the film fraction that changes.
            let in_cavity = unknown.iter_mut().zip(&film.cavity).filter(|(_, cavity)| **cavity);
            in_cavity.for_each(|(change, _)| *change = 0.0);
        }
        Ok(unknown)
    }

    /// The transposed of [`Self::answer`]: how a sum over the unknown with these `weights` of the dofs changes with the residual at each dof, zero where the unknown is given; its linear system may leave this `part` of the weights [1].
    ///
    /// # Errors
    /// The linear system could not be solved.
    pub fn answer_transposed(film: &FilmSolution, weights: &[f64], part: f64) -> Result<Vec<f64>, Error> {
        let minus = weights.iter().zip(&film.cavity);
        // In the cavity of a film that conserves oil it is the film fraction that changes.
        let changes = |in_cavity: bool| film.film_fraction.is_none() || !in_cavity;
        let minus: Vec<f64> =
            minus.map(|(weight, &in_cavity)| if changes(in_cavity) { -weight } else { 0.0 }).collect();
        film.linearisation.solve_transposed_within(&minus, part)
    }

    /// First-order change of the residual at each dof with a `change` of the journal or the gap while the unknown stays.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub(crate) fn residual_change(
        &self,
        system: &FilmSystem,
        film: &FilmSolution,
        change: FilmChange<'_>,
    ) -> Result<Vec<f64>, Error> {
        match &film.film_fraction {
            Some(fraction) => cavitation::residual_change(self, system, film, fraction, change),
            None => {
                let changed = FilmLaw::changed(self, change);
                Ok(system.assembler.residual(&changed, &film.unknown))
            }
        }
    }
}
