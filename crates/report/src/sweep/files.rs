//! The folder of a sweep: rows are added to `sweep.csv` as cases end; a sweep that was killed is taken up again from
//! them.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::Write;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::SweepError;
use super::report::{Identity, SweepReport};
use super::rotor_table::{ROTOR_FILES, rotor_tables};
use super::table::{Columns, TextRow, to_csv, whole_rows};
use crate::json::json;
use crate::page::SWEEP_PAGE_FILE;
use crate::{Error, folder};

/// The table.
pub const TABLE_FILE: &str = "sweep.csv";
/// What it was computed from and, once all is computed, everything again for scripts.
pub const REPORT_FILE: &str = "sweep.json";

/// A table that is being written. No other run may write it as long as this one lives: its file is locked.
pub(crate) struct WrittenTable {
    path: PathBuf,
    file: File,
}

impl WrittenTable {
    /// Begins the table in the folder `dir`, or takes up the one that stands there: its whole rows are kept.
    /// With `fresh` one that stands there is replaced.
    ///
    /// # Errors
    /// Another sweep stands there or is being written, or the system refuses.
    pub(crate) fn open(
        dir: &Path,
        begun: &SweepReport,
        fresh: bool,
    ) -> Result<(Self, BTreeMap<usize, TextRow>), SweepError> {
        let (identity, columns) = (&begun.identity, &begun.columns);
        let path = dir.join(TABLE_FILE);
        std::fs::create_dir_all(dir).map_err(Error::system(&path))?;
        let _alone = folder::alone_in(dir)?;
        let _earlier = free(dir, &path)?;
        let kept = match fresh {
            true => BTreeMap::new(),
            false => kept(dir, identity, columns)?,
        };
        let headings = columns.headings();
        let table = to_csv(std::iter::once(&headings).chain(kept.values()));
        let about =
            json(&TableCompanions { identity: identity.clone(), complete: false, process: Some(std::process::id()) })?;
        let (about_step, table_step) =
            ((OsStr::new(REPORT_FILE), Some(about.as_bytes())), (OsStr::new(TABLE_FILE), Some(&table[..])));
        let page_step = (OsStr::new(SWEEP_PAGE_FILE), None);
        let [rotor_step, rotor_step_3] = ROTOR_FILES.map(|name| (OsStr::new(name), None));
        // A table is never beside a report that is not its own. Rows that are kept are those of the report that stands
        // there.
        match kept.is_empty() {
            true => folder::replace_alone(
                dir,
                &[page_step, rotor_step, rotor_step_3, (table_step.0, None), about_step, table_step],
            )?,
            false => folder::replace_alone(dir, &[page_step, rotor_step, rotor_step_3, about_step, table_step])?,
        }
        let file = OpenOptions::new().append(true).open(&path).map_err(Error::system(&path))?;
        // Without locks in the file system runs must not share a folder.
        let _ = file.try_lock();
        Ok((Self { path, file }, kept))
    }

    /// Adds a row, whole.
    ///
    /// # Errors
    /// The system refuses.
    pub(crate) fn add(&mut self, row: &TextRow) -> Result<(), Error> {
        self.file.write_all(&to_csv([row])).map_err(Error::system(&self.path))
    }
}

/// What stands beside a table that is being written; of a sweep that has ended this is how its report begins.
#[derive(Default, Serialize, Deserialize)]
#[serde(default)]
struct TableCompanions {
    #[serde(flatten)]
    identity: Identity,
    complete: bool,
    /// Number of the process that writes.
    process: Option<u32>,
}

impl TableCompanions {
    /// What a report says; what is no report of a sweep says nothing.
    fn read(report: &[u8]) -> Self {
        serde_json::from_slice(report).unwrap_or_default()
    }
}

/// The table that stands at `path`, locked, if there is one: no other run writes it.
///
/// # Errors
/// Another run writes it.
fn free(dir: &Path, path: &Path) -> Result<Option<File>, SweepError> {
    let Ok(earlier) = File::open(path) else { return Ok(None) };
    match earlier.try_lock() {
        Err(TryLockError::WouldBlock) => Err(SweepError::Busy {
            folder: dir.to_path_buf(),
            process: std::fs::read(dir.join(REPORT_FILE)).ok().and_then(|about| TableCompanions::read(&about).process),
        }),
        Ok(()) | Err(TryLockError::Error(_)) => Ok(Some(earlier)),
    }
}

/// Replaces table and report by those of the finished sweep, and adds the tables for programs of rotors; which of them
/// there are. Between the two the report says still that the sweep has not ended.
///
/// # Errors
/// The system refuses; the rows that were added stand there still.
pub(crate) fn finish(dir: &Path, report: &SweepReport) -> Result<Vec<&'static str>, Error> {
    let headings = report.columns.headings();
    let table = to_csv(std::iter::once(&headings).chain(&report.rows));
    let about = json(report)?;
    let rotor = rotor_tables(report);
    let steps = [
        (OsStr::new(ROTOR_FILES[0]), rotor[0].as_deref()),
        (OsStr::new(ROTOR_FILES[1]), rotor[1].as_deref()),
        (OsStr::new(TABLE_FILE), Some(&table[..])),
        (OsStr::new(REPORT_FILE), Some(about.as_bytes())),
    ];
    folder::replace(dir, &steps)?;
    let there = ROTOR_FILES.into_iter().zip(rotor).filter(|(_, table)| table.is_some());
    Ok(there.map(|(name, _)| name).collect())
}

/// The rows in the folder that are those of this sweep, by the number of their case (from 0).
fn kept(dir: &Path, identity: &Identity, columns: &Columns) -> Result<BTreeMap<usize, TextRow>, SweepError> {
    let Some(earlier) = Earlier::read(dir, identity, columns)? else {
        return Ok(BTreeMap::new());
    };
    let rows = earlier.rows.into_iter();
    Ok(rows.filter_map(|row| Some((case_of(&row).filter(|case| *case < identity.cases)?, row))).collect())
}

/// Number (from 0) of the case of a row.
pub(super) fn case_of(row: &TextRow) -> Option<usize> {
    row.first()?.parse::<usize>().ok()?.checked_sub(1)
}

/// What earlier runs of a sweep have left in a folder.
pub(super) struct Earlier {
    /// The rows of its table.
    pub(super) rows: Vec<TextRow>,
    /// Whether the sweep has ended.
    pub(super) is_complete: bool,
}

impl Earlier {
    /// What stands in the folder `dir`; `None` where there is no table.
    ///
    /// # Errors
    /// It is another sweep than the one of this identity and these columns, or cannot be read.
    pub(super) fn read(dir: &Path, identity: &Identity, columns: &Columns) -> Result<Option<Self>, SweepError> {
        let other = |difference: &'static str| SweepError::Other { folder: dir.to_path_buf(), difference };
        let (table, about) = (dir.join(TABLE_FILE), dir.join(REPORT_FILE));
        if !table.exists() {
            return Ok(None);
        }
        let read = |path: &Path| {
            std::fs::read(path).map_err(|source| SweepError::Earlier { path: path.to_path_buf(), source })
        };
        if !about.exists() {
            return Err(other("without the record of what it was computed from"));
        }
        let about = TableCompanions::read(&read(&about)?);
        if let Some(difference) = difference(&about.identity, identity) {
            return Err(other(difference));
        }
        let rows = whole_rows(&read(&table)?, &columns.headings()).ok_or_else(|| other("with other columns"))?;
        Ok(Some(Self { rows, is_complete: about.complete }))
    }
}

/// How the sweep that is recorded differs from one with this identity, if it does.
fn difference(about: &Identity, identity: &Identity) -> Option<&'static str> {
    if about.format != identity.format || about.version != identity.version {
        Some("of another version of the program")
    } else if about.scene_sha256 != identity.scene_sha256 {
        Some("of another scene, or of this one before it was changed")
    } else if about.mesh_sha256 != identity.mesh_sha256 {
        Some("of another mesh file, or of this one before it was changed")
    } else if about.tables_sha256 != identity.tables_sha256 {
        Some("of another table of loads or gas pressures or scene of a bearing, or of this one before it was changed")
    } else if about.bars != identity.bars {
        Some(match identity.bars {
            true => "without error bars",
            false => "with error bars",
        })
    } else if about.draws != identity.draws {
        Some("of other draws")
    } else {
        (about.part != identity.part).then_some("of which another part is computed")
    }
}
