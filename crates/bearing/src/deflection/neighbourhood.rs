//! Films beside a solved one, along its tangent, whose wall has followed.

use std::sync::Arc;

use oilwedge_fem::Error;
use oilwedge_fem::newton::NewtonFailure;
use oilwedge_reynolds::{FilmProblem, FilmSystem, NoFilm, SolvedFilm};

use super::close::WallResidual;
use super::tangent::{EXACT, Follower};

/// The neighbourhood of a solved film: films of problems that differ a little, each by one back-substitution.
pub struct Neighbourhood<'a> {
    film: &'a SolvedFilm,
    /// None where the wall is rigid.
    follower: Option<Follower<'a>>,
}

impl<'a> Neighbourhood<'a> {
    /// The neighbourhood of a film.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub fn of(film: &'a SolvedFilm) -> Result<Self, Error> {
        Ok(Self { film, follower: Follower::of(film)? })
    }

    /// By which coefficients [m] the wall of a neighbouring film follows to first order from the deflection that the
    /// film has, its journal held; none of a rigid wall.
    ///
    /// # Errors
    /// [`NoFilm`]: the linear systems could not be solved.
    pub fn followed(&self, film: &SolvedFilm) -> Result<Vec<f64>, NoFilm> {
        let Some(follower) = &self.follower else { return Ok(Vec::new()) };
        let left = WallResidual::of_film(film).wall;
        Ok(follower.of_wall(&left, EXACT).map_err(NewtonFailure::from)?.deflection)
    }

    /// The film of a neighbouring `problem` under the wall that the problem has.
    ///
    /// # Errors
    /// [`NoFilm`]: the linear system could not be solved.
    pub fn film(&self, problem: FilmProblem, system: &Arc<FilmSystem>) -> Result<SolvedFilm, NoFilm> {
        self.film.chord(problem, system)
    }
}
