//! Why a sweep ended early.

use std::io;
use std::path::PathBuf;

/// Why a sweep was not run, or not to its end. Rows that were written stay.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The first case cannot be compiled, or the files cannot be written.
    #[error(transparent)]
    Report(#[from] crate::Error),
    /// The cases cannot be run.
    #[error(transparent)]
    Campaign(#[from] oilwedge_campaign::Error),
    /// There are no cases.
    #[error("the sweep has no cases; give each axis below [sweep] at least one value")]
    NoCases,
    /// The folder holds another sweep.
    #[error("{} holds a sweep {difference}", folder.display())]
    Other {
        /// The folder.
        folder: PathBuf,
        /// How it differs.
        difference: &'static str,
    },
    /// Another run writes the sweep in the folder.
    #[error(
        "{} holds a sweep that {} is still writing",
        folder.display(),
        process.map_or("another run".to_owned(), |process| format!("process {process}"))
    )]
    Busy {
        /// The folder.
        folder: PathBuf,
        /// The process that writes it, where it is known.
        process: Option<u64>,
    },
    /// The sweep was interrupted.
    #[error("interrupted: {done} of {cases} cases are in {}", table.display())]
    Interrupted {
        /// Cases in the table.
        done: usize,
        /// All cases.
        cases: usize,
        /// The table.
        table: PathBuf,
    },
    /// The files of an earlier run cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Earlier {
        /// The file.
        path: PathBuf,
        /// The system's message.
        source: io::Error,
    },
}
