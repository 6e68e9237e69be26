//! First-order changes of a solved film with the position of the journal, by the factors of its tangent.

use oilwedge_fem::Error;
use oilwedge_fem::complementarity::WarmStart;
use oilwedge_fem::newton::NewtonFailure;

use crate::cavitation;
use crate::film_law::FilmLaw;
use crate::film_start::FilmStart;
use crate::solve::Neighbour;
use crate::{FilmChange, FilmProblem, JournalChange, NoFilm, SolvedFilm};

/// First-order change of a film at each dof: of the unknown [Pa] or, in the cavity of a film that conserves oil, of the
/// film fraction [1].
#[derive(Debug, Clone, Default)]
pub struct MixedChange(Vec<f64>);

impl MixedChange {
    /// Sum of several changes, each times a factor.
    pub fn sum<'a>(changes: impl IntoIterator<Item = (f64, &'a Self)>) -> Self {
        let mut sum = Vec::new();
        for (factor, Self(change)) in changes {
            sum.resize(change.len().max(sum.len()), 0.0);
            sum.iter_mut().zip(change).for_each(|(sum, change)| *sum += factor * change);
        }
        Self(sum)
    }
}

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
        let unknown = self.unknown_change(change).map_err(NewtonFailure::from)?;
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
        let solution = solution.beside(add(&solution.unknown, unknown), add(&inflow, &through), None);
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

    /// First-order changes of pressure and film fraction with each of some `changes` of the journal or the gap.
    ///
    /// # Errors
    /// A linear system could not be solved.
    pub fn mixed_changes(&self, changes: &[FilmChange<'_>]) -> Result<Vec<MixedChange>, Error> {
        let residuals = self.residual_changes(changes)?;
        residuals.iter().map(|residual| self.mixed_answer(residual, 0.0)).collect()
    }

    /// First-order change of pressure and film fraction by which a film answers to a change of its residual at each
    /// dof; its linear system may leave this `part` of that [1].
    ///
    /// # Errors
    /// The linear system could not be solved.
    pub fn mixed_answer(&self, residual: &[f64], part: f64) -> Result<MixedChange, Error> {
        let minus: Vec<f64> = residual.iter().map(|r| -r).collect();
        Ok(MixedChange(self.solution.linearisation.solve_within(&minus, part)?))
    }

    /// The change of the unknown at each dof [Pa] in a change of pressure and film fraction: none in the cavity of a
    /// film that conserves oil.
    pub fn unknown_in(&self, MixedChange(change): &MixedChange) -> Vec<f64> {
        let mut unknown = change.clone();
        if self.solution.film_fraction.is_some() {
            let in_cavity = unknown.iter_mut().zip(&self.solution.cavity).filter(|(_, cavity)| **cavity);
            in_cavity.for_each(|(change, _)| *change = 0.0);
        }
        unknown
    }

    /// The start of a step of a film near this one, which pressure and film fraction of this one lead to by a `change`:
    /// its unknown there, and the cavity by the sides on which the dofs are.
    pub fn start_after(&self, MixedChange(change): &MixedChange) -> FilmStart {
        let solution = &self.solution;
        let floor = self.problem.cavitation.pressure().map_or(f64::NEG_INFINITY, |p| self.problem.unknown_at(p));
        let mut start = WarmStart { u: solution.unknown.clone(), held: solution.cavity.clone() };
        let Some(fraction) = &solution.film_fraction else {
            start.u.iter_mut().zip(change).for_each(|(u, change)| *u += change);
            if self.problem.cavitation.obstacle().is_some() {
                let below = start.u.iter().map(|u| *u < floor);
                start.held.iter_mut().zip(below).for_each(|(held, below)| *held |= below);
            }
            return FilmStart(start);
        };
        for (dof, change) in change.iter().enumerate() {
            start.held[dof] = match solution.cavity[dof] {
                true => fraction.values[dof] + change <= 1.0,
                false => solution.unknown[dof] + change < floor,
            };
        }
        // Full dofs at an edge through which pressure would drive oil in have the pressure of the cavity.
        let at_edges = solution.wrong.iter().filter(|dof| !solution.cavity[**dof] && solution.unknown[**dof] >= floor);
        at_edges.for_each(|dof| start.held[*dof] = true);
        FilmStart(start)
    }

    /// First-order change of the unknown at each dof [Pa] by which a film answers to a change of its residual at each
    /// dof; its linear system may leave this `part` of that [1].
    ///
    /// # Errors
    /// The linear system could not be solved.
    pub fn answer(&self, residual: &[f64], part: f64) -> Result<Vec<f64>, Error> {
        Ok(self.unknown_in(&self.mixed_answer(residual, part)?))
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
        Ok(self.residual_changes(&[change])?.remove(0))
    }

    /// The changes of [`Self::residual_change`] with each of some `changes`.
    fn residual_changes(&self, changes: &[FilmChange<'_>]) -> Result<Vec<Vec<f64>>, Error> {
        let with_law = |change: &FilmChange<'_>| {
            self.system.assembler.residual(&FilmLaw::changed(&self.problem, *change), &self.solution.unknown)
        };
        match &self.solution.film_fraction {
            Some(fraction) => cavitation::residual_changes(self, fraction, changes),
            None => Ok(changes.iter().map(with_law).collect()),
        }
    }
}
