//! How a solved film changes, to first order, where the journal moves: with the factors that are there.

use oilwedge_fem::Error;

use crate::cavitation::jfo;
use crate::film_law::FilmLaw;
use crate::{FilmProblem, FilmSolution, FilmSystem, JournalChange};

impl FilmProblem {
    /// First-order change of the unknown at each dof [Pa] where the journal moves by `change`. The cavity stays, as
    /// it does to first order: the pressure is level at its edge.
    ///
    /// # Errors
    /// The linear system could not be solved.
    pub fn unknown_change(
        &self,
        system: &FilmSystem,
        film: &FilmSolution,
        change: &JournalChange,
    ) -> Result<Vec<f64>, Error> {
        let residual = match &film.film_fraction {
            Some(fraction) => jfo::residual_change(self, system, film, fraction, change)?,
            None => {
                let changed = FilmLaw::changed(self, *change);
                system.assembler.residual(&changed, &film.unknown)
            }
        };
        let minus: Vec<f64> = residual.iter().map(|r| -r).collect();
        let mut unknown = film.linearisation.solve(&minus)?;
        if film.film_fraction.is_some() {
            // In the cavity it is the film fraction that changes.
            let in_cavity = unknown.iter_mut().zip(&film.cavity).filter(|(_, cavity)| **cavity);
            in_cavity.for_each(|(change, _)| *change = 0.0);
        }
        Ok(unknown)
    }
}
