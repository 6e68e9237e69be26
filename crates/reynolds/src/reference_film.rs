//! The second film by which the error of a film is estimated; which one it is the cavitation model decides.

use crate::error_bar::conserving::{ConservingError, conserving_error};
use crate::error_bar::following::FollowingWall;
use crate::sharp::SharpFilm;
use crate::{NoFilm, SolvedFilm};

/// A second film of the same problem on the same mesh.
#[derive(Debug)]
pub enum ReferenceFilm {
    /// Film in cubic elements, on [`FilmSystem::cubic`](crate::FilmSystem::cubic): more accurate than the film, its
    /// quantities are reported.
    Cubic(SolvedFilm),
    /// The film that judges models which conserve oil.
    Coarse {
        /// Film on [`FilmSystem::vertices_only`](crate::FilmSystem::vertices_only): less accurate than the film itself.
        film: SolvedFilm,
        /// What it shows of the errors of the film; none where it shows nothing.
        error: Option<Box<ConservingError>>,
        /// The hill over the cavity ([`SolvedFilm::sharp_film`]), more accurate than the film where that is smooth;
        /// none where it was not sought or found.
        hill: Option<Box<SharpFilm>>,
    },
}

impl ReferenceFilm {
    /// The `coarse` comparison of a mass-conserving film, whose wall is `following` if it gives way, and its `hill`.
    pub fn coarse(
        film: &SolvedFilm,
        coarse: SolvedFilm,
        hill: Option<SharpFilm>,
        following: Option<&FollowingWall>,
    ) -> Self {
        Self::Coarse {
            error: conserving_error(film, &coarse, following).map(Box::new),
            film: coarse,
            hill: hill.map(Box::new),
        }
    }

    /// The film.
    pub fn film(&self) -> &SolvedFilm {
        match self {
            Self::Cubic(film) | Self::Coarse { film, .. } => film,
        }
    }
}

impl SolvedFilm {
    /// The film by which the error of this one is estimated, without a hill, where a wall that gives way is
    /// `following`. None where a coarse film does not exist: this one may be sound without it.
    ///
    /// # Errors
    /// [`NoFilm`]: cubic elements have no film, or the mesh does not resolve on which side of the limit of the
    /// viscosity law it lies.
    pub fn reference_film(&self, following: Option<&FollowingWall>) -> Result<Option<ReferenceFilm>, NoFilm> {
        if self.problem.cavitation.is_symmetric() {
            return Ok(Some(ReferenceFilm::Cubic(self.cubic_film(None)?)));
        }
        match self.coarse_comparison() {
            Ok(coarse) => Ok(Some(ReferenceFilm::coarse(self, coarse, None, following))),
            Err(reason @ NoFilm::NearLimit { .. }) => Err(reason),
            Err(_) => Ok(None),
        }
    }

    /// The second film whether or not the viscosity law has a pressure for it.
    pub(crate) fn reference_film_unchecked(&self) -> Result<ReferenceFilm, NoFilm> {
        match self.problem.cavitation.is_symmetric() {
            true => self.cubic_film_unchecked(None).map(ReferenceFilm::Cubic),
            false => {
                let film = self.coarse_comparison_unchecked()?;
                Ok(ReferenceFilm::Coarse { film, error: None, hill: None })
            }
        }
    }
}
