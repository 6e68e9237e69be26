//! The second film by which the error of a film is estimated; which one it is the cavitation model decides.

use crate::{FilmProblem, FilmSolution, FilmSystem, NoFilm};

/// A second film of the same problem on the same mesh.
#[derive(Debug)]
pub enum ReferenceFilm {
    /// In cubic elements, on [`FilmSystem::cubic`]: more accurate than the film, its quantities are reported.
    Cubic(FilmSolution),
    /// On [`FilmSystem::vertices_only`]: less accurate than the film, for models that conserve oil.
    Coarse(FilmSolution),
}

impl ReferenceFilm {
    /// The film.
    pub fn film(&self) -> &FilmSolution {
        match self {
            Self::Cubic(film) | Self::Coarse(film) => film,
        }
    }

    /// The system on which it was solved, if the first film was solved on `system`.
    pub fn system<'a>(&self, system: &'a FilmSystem) -> &'a FilmSystem {
        match self {
            Self::Cubic(_) => &system.cubic().system,
            Self::Coarse(_) => system.vertices_only(),
        }
    }
}

impl FilmProblem {
    /// The film by which the error of `film` is estimated. None where a coarse film does not exist: `film` may be sound without it.
    ///
    /// # Errors
    /// [`NoFilm`]: cubic elements have no film, or the mesh does not resolve on which side of the limit of the viscosity law it lies.
    pub fn reference_film(&self, system: &FilmSystem, film: &FilmSolution) -> Result<Option<ReferenceFilm>, NoFilm> {
        if self.cavitation.is_symmetric() {
            return Ok(Some(ReferenceFilm::Cubic(self.cubic_film(system, film, None)?)));
        }
        match self.coarse_comparison(system, film) {
            Ok(coarse) => Ok(Some(ReferenceFilm::Coarse(coarse))),
            Err(reason @ NoFilm::NearLimit { .. }) => Err(reason),
            Err(_) => Ok(None),
        }
    }

    /// The second film whether or not the viscosity law has a pressure for it.
    pub(crate) fn reference_film_unchecked(
        &self,
        system: &FilmSystem,
        film: &FilmSolution,
    ) -> Result<ReferenceFilm, NoFilm> {
        match self.cavitation.is_symmetric() {
            true => (self.cubic_film_unchecked(system, film, None)).map(ReferenceFilm::Cubic),
            false => (self.coarse_comparison_unchecked(system, film)).map(ReferenceFilm::Coarse),
        }
    }
}
