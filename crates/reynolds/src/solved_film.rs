//! A solved film: the noun of nearly everything that is asked above a solve.
//!
//! Loads, flows, powers, tangents and error bars are functions of a [`FilmProblem`], of the [`FilmSystem`] on which it
//! was solved and of its [`FilmSolution`], all three of the same film. A [`SolvedFilm`] keeps them together, so that
//! they cannot be of different films, and whoever bears a film bears one value. What is known before a solve, as the
//! gap or the points of contact, takes a problem and a system.

use std::sync::Arc;

use oilwedge_fem::Field;
use oilwedge_fem::field::Extremum;

use crate::film_thickness::Closing;
use crate::{FilmProblem, FilmSolution, FilmSystem};

/// A solved film. It never changes; copies share system and solution.
#[derive(Debug, Clone)]
pub struct SolvedFilm {
    /// What was solved: where the journal is, how its wall is bent, what is simulated.
    pub problem: FilmProblem,
    /// Mesh, unknowns and given pressures of the film.
    pub system: Arc<FilmSystem>,
    /// Solution of the problem on the system.
    pub solution: Arc<FilmSolution>,
}

impl SolvedFilm {
    /// The film of a problem with its solution on a system.
    pub fn new(problem: FilmProblem, system: &Arc<FilmSystem>, solution: FilmSolution) -> Self {
        Self { problem, system: system.clone(), solution: Arc::new(solution) }
    }

    /// The film under a deflection that was found so.
    #[must_use]
    pub fn closed_by(self, closing: Closing) -> Self {
        Self { problem: self.problem.closed_by(closing), ..self }
    }

    /// The greatest value of the unknown, between nodes too where the film is full.
    pub fn greatest_unknown(&self) -> Extremum {
        let (space, solution) = (self.system.space(), &self.solution);
        let field = Field { space, values: &solution.unknown };
        let full = |t: usize| space.element_dofs(t)[..space.shapes()].iter().all(|&dof| !solution.cavity[dof]);
        match solution.film_fraction {
            Some(_) => field.maximum_where(&full),
            None => field.maximum(),
        }
    }
}
