//! Why a sweep ended early.

use std::io;
use std::path::PathBuf;

use oilwedge_campaign::sweep::Part;

use super::parts::{PARTS_FOLDER, listed};

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
    /// The sweep has no cases.
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
    /// A sweep in the folder is being written by another run.
    #[error(
        "{} holds a sweep that {} is still writing",
        folder.display(),
        process.map_or("another run".to_owned(), |process| format!("process {process}"))
    )]
    Busy {
        /// The folder.
        folder: PathBuf,
        /// The process that writes it, where it is known.
        process: Option<u32>,
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
    /// The folder has no part to be joined.
    #[error("{} holds no parts of a sweep in its folder {PARTS_FOLDER}", dir.display())]
    NoParts {
        /// Folder of the sweep.
        dir: PathBuf,
    },
    /// Parts of a sweep are not there, or not whole.
    #[error("{} does not hold the whole sweep: of its {of} parts {}", dir.display(), gaps(missing, unfinished))]
    Gaps {
        /// Folder of the sweep.
        dir: PathBuf,
        /// Numbers of the parts that are not there.
        missing: Vec<u32>,
        /// Numbers of the parts that have not ended.
        unfinished: Vec<u32>,
        /// How many parts there are.
        of: u32,
    },
    /// Sweeps that are divided in different ways stand in one folder.
    #[error(
        "{} holds parts of {} and of {}, which have cases in common",
        folder.display(), divisions[0], divisions[1]
    )]
    Divisions {
        /// Folder of the parts.
        folder: PathBuf,
        /// Two numbers of parts.
        divisions: [u32; 2],
    },
    /// Something that is no part stands among the parts.
    #[error("{} is not the folder of a part", path.display())]
    NotAPart {
        /// What stands there.
        path: PathBuf,
    },
    /// A part is not one of this sweep, or cannot be read.
    #[error("{cause}")]
    Part {
        /// The part.
        part: Part,
        /// Folder of the sweep.
        dir: PathBuf,
        /// What is wrong with it.
        cause: Box<SweepError>,
    },
    /// The table of a part does not have each of its cases once.
    #[error("{} is not the table of a part: case {case} is missing, doubled or out of place", table.display())]
    Rows {
        /// The part.
        part: Part,
        /// Folder of the sweep.
        dir: PathBuf,
        /// The table.
        table: PathBuf,
        /// Number of the first wrong case, from 1.
        case: usize,
    },
    /// Rows that were given are not those of the sweep.
    #[error("the rows are not those of this sweep, each case once and in its order")]
    NotItsRows,
}

/// The parts that are not there and those that have not ended, as `3, 7-9 are missing, and 5 has not ended`.
fn gaps(missing: &[u32], unfinished: &[u32]) -> String {
    let words = |numbers: &[u32], one: &str, many: &str| match numbers.len() {
        0 => None,
        1 => Some(format!("{} {one}", listed(numbers))),
        _ => Some(format!("{} {many}", listed(numbers))),
    };
    let parts = [words(missing, "is missing", "are missing"), words(unfinished, "has not ended", "have not ended")];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", and ")
}
