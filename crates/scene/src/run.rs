//! From a scene to its numbers and fields: what a caller asks, and what it is given.

use crate::report::{CheckReport, ReportError, RunResult};
use crate::results::WriteError;
use crate::scene::Scene;
use crate::vtu::{FilmPicture, PictureError};
use std::path::Path;

/// How a scene is run. None of this changes a number.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct RunOptions {
    /// Draw the film on the developed surface (x = R phi, y = z) instead of on the cylinder.
    pub unrolled: bool,
}

/// What a run found.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// The numbers; its status tells whether there are any.
    pub result: RunResult,
    /// The fields; `None` where there is no solution to draw.
    pub picture: Option<FilmPicture>,
}

/// Why a scene was not run. That a scene has no solution is no error: it is a [`crate::report::Status`].
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The result holds what must not be written.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// The picture does not fit together.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// The results cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// This version reads scenes, and computes nothing yet.
    #[error("{what} is not served yet; only scenes are checked")]
    NotServed {
        /// What was asked.
        what: &'static str,
    },
}

/// Computes the film of a scene.
///
/// # Errors
/// [`Error`] where the mesh cannot be read or does not fit the scene.
pub fn run(_scene: &Scene, _options: &RunOptions) -> Result<Run, Error> {
    Err(Error::NotServed { what: "solving" })
}

/// Reads the mesh of a scene and tells what would be computed.
///
/// # Errors
/// [`Error`] where the mesh cannot be read or does not fit the scene.
pub fn check_scene(_scene: &Scene) -> Result<CheckReport, Error> {
    Err(Error::NotServed {
        what: "checking the mesh of a scene",
    })
}

/// Reads a mesh file by itself, its lengths in metres.
///
/// # Errors
/// [`Error`] where the mesh cannot be read.
pub fn check_mesh(_path: &Path) -> Result<CheckReport, Error> {
    Err(Error::NotServed {
        what: "checking a mesh",
    })
}
