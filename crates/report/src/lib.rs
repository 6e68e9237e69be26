//! Results out: JSON, CSV, VTU, pictures, and folders that are whole after a kill.
//!
//! Reading order: [`mod@json`], [`folder`], [`results`] (the folder of a run), [`sweep`], [`convergence`], [`vtu`], [`plot`], [`mod@check`].

pub mod check;
pub mod convergence;
pub mod folder;
pub mod json;
pub mod oil_sheet;
pub mod plot;
pub mod results;
mod sketch;
pub mod sweep;
pub mod vtu;

pub use check::{check_mesh, check_scene, write_mesh};
pub use json::{ReportError, json, result_json};

use std::path::PathBuf;

use oilwedge_study::CompileError;
use plot::PlotError;
use results::WriteError;
use vtu::PictureError;

/// Why a scene was not run. That a scene has no solution is no error: it is a [`crate::result::Status`].
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The mesh is unreadable, defective, or not that of the scene.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// The result holds what must not be written.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// The picture does not fit together.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// The results cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// A campaign ended without an answer.
    #[error(transparent)]
    Campaign(oilwedge_campaign::Error),
    /// The plots cannot be drawn.
    #[error(transparent)]
    Plot(#[from] PlotError),
    /// A sweep has no cases.
    #[error("the sweep has no cases; give each axis below [sweep] a value at least")]
    NoCases,
    /// The folder of a sweep holds another one.
    #[error(
        "{} holds a sweep {why}; choose another folder with --out, or replace it with --fresh",
        folder.display()
    )]
    OtherSweep {
        /// The folder.
        folder: PathBuf,
        /// What is other about it.
        why: &'static str,
    },
    /// Another run writes the sweep in the folder.
    #[error(
        "{} holds a sweep that {} is still writing; wait until it ends, end it, or choose another folder with --out",
        folder.display(),
        process.map_or("another run".to_owned(), |process| format!("process {process}"))
    )]
    BusySweep {
        /// The folder.
        folder: PathBuf,
        /// The process that writes it, where the folder tells.
        process: Option<u64>,
    },
    /// A sweep was asked to end before it had.
    #[error(
        "interrupted: {done} of {cases} cases are in {}; the same command goes on from there",
        table.display()
    )]
    Interrupted {
        /// Cases in the table.
        done: usize,
        /// All cases.
        cases: usize,
        /// The table.
        table: PathBuf,
    },
    /// What an earlier run of a sweep wrote cannot be read.
    #[error("cannot read {}: {source}; choose another folder with --out, or replace it with --fresh", path.display())]
    Earlier {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
}

impl From<oilwedge_campaign::Error> for Error {
    fn from(error: oilwedge_campaign::Error) -> Self {
        match error {
            oilwedge_campaign::Error::Compile(error) => Self::Compile(error),
            other => Self::Campaign(other),
        }
    }
}
