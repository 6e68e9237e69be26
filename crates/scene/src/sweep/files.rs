//! The folder of a sweep: rows are added to `sweep.csv` as cases end; a sweep that was killed is taken up again from them.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::Write;
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::report::{Identity, SweepReport};
use super::table::{Columns, Row, to_csv, whole_rows};
use crate::folder;
use crate::report::json;
use crate::results::WriteError;
use crate::run::Error;

/// The table.
pub const TABLE_FILE: &str = "sweep.csv";
/// What it was computed from and, once all is computed, everything again for scripts.
pub const REPORT_FILE: &str = "sweep.json";

/// A table that is being written.
pub(crate) struct Table {
    path: PathBuf,
    file: File,
}

impl Table {
    /// Begins the table in the folder `dir`, or takes up the one that stands there: the rows of those chains are kept that are whole.
    /// With `fresh` one that stands there is replaced.
    ///
    /// # Errors
    /// Another sweep stands there, or the system refuses.
    pub(crate) fn open(
        dir: &Path,
        identity: &Identity,
        columns: &Columns,
        chains: &[Range<usize>],
        fresh: bool,
    ) -> Result<(Self, BTreeMap<usize, Row>), Error> {
        let kept = match fresh {
            true => BTreeMap::new(),
            false => kept(dir, identity, columns, chains)?,
        };
        let headings = columns.headings();
        let table = to_csv(std::iter::once(&headings).chain(kept.values()));
        let begun = Begun {
            identity,
            complete: false,
        };
        let about = json(&begun)?;
        folder::replace(
            dir,
            &[(TABLE_FILE, Some(&table)), (REPORT_FILE, Some(about.as_bytes()))],
        )?;
        let path = dir.join(TABLE_FILE);
        let opened = OpenOptions::new().append(true).open(&path);
        match opened {
            Ok(file) => Ok((Self { path, file }, kept)),
            Err(source) => Err(WriteError::System { path, source }.into()),
        }
    }

    /// Adds a row, whole.
    ///
    /// # Errors
    /// The system refuses.
    pub(crate) fn add(&mut self, row: &Row) -> Result<(), Error> {
        let path = &self.path;
        let refused = |source| WriteError::System {
            path: path.clone(),
            source,
        };
        Ok(self.file.write_all(&to_csv([row])).map_err(refused)?)
    }
}

/// What stands beside a table that is being written.
#[derive(serde::Serialize)]
struct Begun<'a> {
    #[serde(flatten)]
    identity: &'a Identity,
    complete: bool,
}

/// Replaces table and report by those of the finished sweep.
///
/// # Errors
/// The system refuses; the rows that were added stand there still.
pub(crate) fn finish(dir: &Path, report: &SweepReport) -> Result<(), Error> {
    let headings = report.columns.headings();
    let table = to_csv(std::iter::once(&headings).chain(&report.rows));
    let about = report.to_json()?;
    Ok(folder::replace(
        dir,
        &[(TABLE_FILE, Some(&table)), (REPORT_FILE, Some(about.as_bytes()))],
    )?)
}

/// The rows in the folder that are those of this sweep, by the number of their case, of all chains that are whole.
fn kept(
    dir: &Path,
    identity: &Identity,
    columns: &Columns,
    chains: &[Range<usize>],
) -> Result<BTreeMap<usize, Row>, Error> {
    let other = |why: &'static str| Error::OtherSweep {
        folder: dir.to_path_buf(),
        why,
    };
    let (table, about) = (dir.join(TABLE_FILE), dir.join(REPORT_FILE));
    if !table.exists() {
        return Ok(BTreeMap::new());
    }
    let read = |path: &Path| {
        std::fs::read(path).map_err(|source| Error::Earlier {
            path: path.to_path_buf(),
            source,
        })
    };
    if !about.exists() {
        return Err(other("of which nothing tells what it was computed from"));
    }
    let about: serde_json::Value = serde_json::from_slice(&read(&about)?).unwrap_or_default();
    let differs = |key: &str, own: &serde_json::Value| about.get(key) != Some(own);
    if differs("format", &identity.format.as_str().into()) || differs("version", &identity.version.as_str().into()) {
        return Err(other("of another version of the program"));
    }
    if differs("scene_sha256", &identity.scene_sha256.as_str().into()) {
        return Err(other("of another scene, or of this one before it was changed"));
    }
    let mesh = serde_json::Value::from(identity.mesh_sha256.clone());
    if differs("mesh_sha256", &mesh) {
        return Err(other("of another mesh file, or of this one before it was changed"));
    }
    if differs("bars", &identity.bars.into()) {
        return Err(other(match identity.bars {
            true => "without error bars",
            false => "with error bars",
        }));
    }
    let rows = whole_rows(&read(&table)?, &columns.headings()).ok_or_else(|| other("with other columns"))?;
    let number = |row: &Row| row[0].parse::<usize>().ok()?.checked_sub(1);
    let mut all: BTreeMap<usize, Row> = (rows.into_iter())
        .filter_map(|row| Some((number(&row)?, row)))
        .collect();
    let whole: Vec<bool> = (chains.iter())
        .map(|chain| chain.clone().all(|case| all.contains_key(&case)))
        .collect();
    let chain_of = |case: &usize| chains.iter().position(|chain| chain.contains(case));
    all.retain(|case, _| chain_of(case).is_some_and(|chain| whole[chain]));
    Ok(all)
}
