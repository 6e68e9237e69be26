//! How a solved film changes, to first order, where the journal moves: with the factors that are there.

use std::sync::OnceLock;

use oilwedge_fem::Error;
use oilwedge_fem::newton::Failure;

use crate::cavitation;
use crate::film_law::FilmLaw;
use crate::solve::Neighbour;
use crate::{FilmChange, FilmProblem, FilmSolution, JournalChange, NoFilm, SolvedFilm};

impl SolvedFilm {
    /// The film where the journal has moved by a small `change`: along the tangent, but for a mass-conserving one,
    /// which is solved again from the film that is there.
    ///
    /// # Errors
    /// [`NoFilm`]: the reason why there is none.
    pub fn displaced(&self, change: &JournalChange) -> Result<Self, NoFilm> {
        let moved = FilmProblem { journal: self.problem.journal.changed(change), ..self.problem.clone() };
        if self.solution.film_fraction.is_some() {
            return moved.solve_from(&self.system, Neighbour::Start(self));
        }
        let unknown = self.unknown_change(change).map_err(Failure::from)?;
        Ok(self.along_tangent(moved, &[change.into()], &unknown))
    }

    /// The film of a problem that is `moved` from that of a film without a film fraction, along its tangent: after
    /// `changes`, by which its unknown changes by `unknown` at each dof.
    pub fn along_tangent(&self, moved: FilmProblem, changes: &[FilmChange<'_>], unknown: &[f64]) -> Self {
        let Self { problem, system, solution } = self;
        let add = |base: &[f64], change: &[f64]| base.iter().zip(change).map(|(b, c)| b + c).collect::<Vec<f64>>();
        let direct = |inflow: Vec<f64>, change: &FilmChange<'_>| {
            let changed = FilmLaw::changed(problem, *change);
            add(&inflow, &system.assembler.residual(&changed, &solution.unknown))
        };
        let inflow = changes.iter().fold(solution.inflow.clone(), direct);
        let through = solution.linearisation.matrix().multiply(unknown);
        let solution = FilmSolution {
            inflow: add(&inflow, &through),
            unknown: add(&solution.unknown, unknown),
            cavity: solution.cavity.clone(),
            film_fraction: None,
            linearisation: solution.linearisation.clone(),
            gap_tangent: OnceLock::new(),
            history: Vec::new(),
            seconds: solution.seconds,
            levels: 0,
            fallbacks: Vec::new(),
        };
        Self::new(moved, system, solution)
    }

    /// First-order change of the unknown at each dof [Pa] with a `change` of the journal or the gap. The cavity stays,
    /// as it does to first order: the pressure is level at its edge.
    ///
    /// # Errors
    /// The linear system could not be solved.
    pub fn unknown_change<'a>(&self, change: impl Into<FilmChange<'a>>) -> Result<Vec<f64>, Error> {
        self.answer(&self.residual_change(change.into())?, 0.0)
    }

    /// First-order change of the unknown at each dof [Pa] by which a film answers to a change of its residual at each
    /// dof; its linear system may leave this `part` of that [1].
    ///
    /// # Errors
    /// The linear system could not be solved.
    pub fn answer(&self, residual: &[f64], part: f64) -> Result<Vec<f64>, Error> {
        let film = &self.solution;
        let minus: Vec<f64> = residual.iter().map(|r| -r).collect();
        let mut unknown = film.linearisation.solve_within(&minus, part)?;
        if film.film_fraction.is_some() {
            // In the cavity it is the film fraction that changes.
            let in_cavity = unknown.iter_mut().zip(&film.cavity).filter(|(_, cavity)| **cavity);
            in_cavity.for_each(|(change, _)| *change = 0.0);
        }
        Ok(unknown)
    }

    /// The transposed of [`Self::answer`]: how a sum over the unknown with these `weights` of the dofs changes with the
    /// residual at each dof, zero where the unknown is given; its linear system may leave this `part` of the weights
    /// [1].
    ///
    /// # Errors
    /// The linear system could not be solved.
    pub fn answer_transposed(&self, weights: &[f64], part: f64) -> Result<Vec<f64>, Error> {
        let film = &self.solution;
        let minus = weights.iter().zip(&film.cavity);
        // In the cavity of a film that conserves oil it is the film fraction that changes.
        let changes = |in_cavity: bool| film.film_fraction.is_none() || !in_cavity;
        let minus: Vec<f64> =
            minus.map(|(weight, &in_cavity)| if changes(in_cavity) { -weight } else { 0.0 }).collect();
        film.linearisation.solve_transposed_within(&minus, part)
    }

    /// First-order change of the residual at each dof with a `change` of the journal or the gap while the unknown
    /// stays.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub(crate) fn residual_change(&self, change: FilmChange<'_>) -> Result<Vec<f64>, Error> {
        match &self.solution.film_fraction {
            Some(fraction) => cavitation::residual_change(self, fraction, change),
            None => {
                let changed = FilmLaw::changed(&self.problem, change);
                Ok(self.system.assembler.residual(&changed, &self.solution.unknown))
            }
        }
    }
}
