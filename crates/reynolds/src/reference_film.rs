//! The second film by which the error of a film is estimated; which one it is the cavitation model decides.

use crate::error_bar::conserving::{ConservingError, conserving_error};
use crate::error_bar::following::FollowingWall;
use crate::sharp::SharpFilm;
use crate::{FilmProblem, FilmSolution, FilmSystem, NoFilm};

/// A second film of the same problem on the same mesh.
#[derive(Debug)]
pub enum ReferenceFilm {
    /// In cubic elements, on [`FilmSystem::cubic`]: more accurate than the film, its quantities are reported.
    Cubic(FilmSolution),
    /// Of models that conserve oil.
    Coarse {
        /// On [`FilmSystem::vertices_only`]: less accurate than the film.
        film: FilmSolution,
        /// What it shows of the errors of the film; none where it shows nothing.
        error: Option<Box<ConservingError>>,
        /// The hill over the cavity ([`FilmProblem::sharp_film`]), more accurate than the film where that is smooth; none where it was not sought or found.
        hill: Option<Box<SharpFilm>>,
    },
}

impl ReferenceFilm {
    /// The `coarse` comparison of a mass-conserving film, whose wall is `following` if it gives way, and its `hill`.
    pub fn coarse(
        (problem, system, film): (&FilmProblem, &FilmSystem, &FilmSolution),
        coarse: FilmSolution,
        hill: Option<SharpFilm>,
        following: Option<&FollowingWall>,
    ) -> Self {
        Self::Coarse {
            error: conserving_error(problem, system, film, &coarse, following).map(Box::new),
            film: coarse,
            hill: hill.map(Box::new),
        }
    }

    /// The film.
    pub fn film(&self) -> &FilmSolution {
        match self {
            Self::Cubic(film) | Self::Coarse { film, .. } => film,
        }
    }

    /// The system on which it was solved, if the first film was solved on `system`.
    pub fn system<'a>(&self, system: &'a FilmSystem) -> &'a FilmSystem {
        match self {
            Self::Cubic(_) => &system.cubic().system,
            Self::Coarse { .. } => system.vertices_only(),
        }
    }
}

impl FilmProblem {
    /// The film by which the error of `film` is estimated, without a hill, where a wall that gives way is `following`. None where a coarse film does not exist: `film` may be sound without it.
    ///
    /// # Errors
    /// [`NoFilm`]: cubic elements have no film, or the mesh does not resolve on which side of the limit of the viscosity law it lies.
    pub fn reference_film(
        &self,
        system: &FilmSystem,
        film: &FilmSolution,
        following: Option<&FollowingWall>,
    ) -> Result<Option<ReferenceFilm>, NoFilm> {
        if self.cavitation.is_symmetric() {
            return Ok(Some(ReferenceFilm::Cubic(self.cubic_film(system, film, None)?)));
        }
        match self.coarse_comparison(system, film) {
            Ok(coarse) => Ok(Some(ReferenceFilm::coarse((self, system, film), coarse, None, following))),
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
            false => {
                let coarse = self.coarse_comparison_unchecked(system, film)?;
                Ok(ReferenceFilm::Coarse { film: coarse, error: None, hill: None })
            }
        }
    }
}
