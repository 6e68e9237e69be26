//! The folder of a sweep: rows are written as cases end, and a sweep that was ended is taken up again.
//!
//! `table.rs` (columns and rows), `rotor_table.rs` (stiffness and damping for programs of rotors), `files.rs` (a table
//! that can be taken up again), `parts.rs` (a sweep that several runs share), `report.rs` (for scripts), `record.rs`
//! (from rows to that), `distribution.rs` and `spread.rs` (what draws of tolerances say).

mod distribution;
mod error;
mod files;
mod parts;
mod record;
mod report;
mod rotor_table;
mod spread;
mod table;

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Instant;

use oilwedge_campaign::sweep::{Event, Forecast, Part, Sweep};
use oilwedge_scene::periodic_table::read_text;
use oilwedge_scene::{MESH_FILE, Scene, ShaftScene};
use oilwedge_study::CompileError;
use oilwedge_study::run_options::RunOptions;
use sha2::{Digest, Sha256};

pub use distribution::{Distribution, SampledNumber, SampledQuantity, ToleranceRecord};
pub use error::SweepError;
pub use files::{REPORT_FILE, TABLE_FILE};
pub use parts::{PARTS_FOLDER, part_folder};
pub use report::{CaseQuantity, CaseRecord, ColumnRecord, Identity, SWEEP_FORMAT, SweepReport, SweepResult};
pub use rotor_table::ROTOR_FILES;
pub(crate) use table::to_csv;
pub use table::{Columns, LIMITS, REASON, SECONDS, TextRow, UNKNOWNS, VERDICT, WARNINGS};

use crate::{Error, folder};
use files::{WrittenTable, case_of, finish};
use parts::rows_of_parts;
use table::whole_rows;

/// How a sweep is run.
#[derive(Debug, Clone, Copy, Default)]
pub struct SweepOptions {
    /// How each case is run; limits are those of one case.
    pub case: RunOptions,
    /// Replace a sweep that stands in the folder, whatever it is.
    pub fresh: bool,
    /// The part of the sweep that is computed; all of it without one.
    pub part: Option<Part>,
}

/// How far a sweep has got.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Cases that earlier runs had computed.
    pub kept: usize,
    /// Cases that are computed, those included.
    pub done: usize,
    /// All cases.
    pub cases: usize,
}

/// What a sweep reports as it runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Notice {
    /// How long it will take; once, if at all.
    Forecast(Forecast),
    /// How far it has got.
    Progress(Progress),
}

/// Runs all cases of a sweep, or of the part that is wanted, and writes them to the folder `dir`, a part to a folder of
/// its own below ([`part_folder`]). Rows that stand there from an earlier run of the same sweep are kept.
///
/// # Errors
/// The first case does not become a film, another sweep stands in the folder, or it cannot be written; or the sweep was
/// interrupted, with its rows kept: [`SweepError::Interrupted`].
pub fn run(
    sweep: &Sweep,
    options: &SweepOptions,
    dir: &Path,
    progress: &mut dyn FnMut(Notice),
) -> Result<SweepReport, SweepError> {
    let clock = Instant::now();
    let cases = cases(sweep, options);
    let dir = (options.part).map_or(dir.to_path_buf(), |part| part_folder(dir, part));
    check(&dir)?;
    let mut report = begun(sweep, options)?;
    let (mut table, rows) = WrittenTable::open(&dir, &report, options.fresh)?;
    report.kept = rows.len();
    let mut now = Progress { kept: rows.len(), done: rows.len(), cases: cases.len() };
    progress(Notice::Progress(now));
    let rows = RefCell::new(rows);
    let is_kept = |case: usize| !cases.contains(&case) || rows.borrow().contains_key(&case);
    sweep.run(&options.case, &is_kept, &mut |event| -> Result<(), SweepError> {
        let (case, found) = match event {
            Event::Ended(case, found) => (case, found),
            Event::Forecast(forecast) => {
                progress(Notice::Forecast(forecast));
                return Ok(());
            }
        };
        let row = report.columns.row(&sweep.plan, case, &found)?;
        table.add(&row)?;
        rows.borrow_mut().insert(case, row);
        now.done += 1;
        progress(Notice::Progress(now));
        Ok(())
    })?;
    if now.done < now.cases {
        return Err(SweepError::Interrupted { done: now.done, cases: now.cases, table: dir.join(TABLE_FILE) });
    }
    report.rows = rows.into_inner().into_values().collect();
    report.seconds = clock.elapsed().as_secs_f64();
    report.rotor_tables = finish(&dir, &report)?;
    Ok(report)
}

/// Joins the parts of a sweep that stand below the folder `parts` to the table in the folder `dir`, which is that of
/// [`run`] except for the times.
///
/// # Errors
/// A part is missing, has not ended, or is one of another sweep; another sweep stands in the folder, or it cannot be
/// written.
pub fn join(sweep: &Sweep, options: &SweepOptions, parts: &Path, dir: &Path) -> Result<SweepReport, SweepError> {
    check(dir)?;
    let mut report = begun(sweep, options)?;
    let rows = rows_of_parts(sweep, &report, parts)?;
    let _alone = WrittenTable::open(dir, &report, options.fresh)?;
    report.join(rows);
    report.rotor_tables = finish(dir, &report)?;
    Ok(report)
}

/// The rows of the part of a sweep that is wanted, as CSV with headings; nothing is written. After an interrupt those
/// of the cases that ended before.
///
/// # Errors
/// The cases cannot be run, or a number is not finite.
pub fn part_rows(sweep: &Sweep, options: &SweepOptions) -> Result<Vec<u8>, SweepError> {
    let (columns, cases) = (columns(sweep, options), cases(sweep, options));
    let mut rows = BTreeMap::new();
    sweep.run(&options.case, &|case| !cases.contains(&case), &mut |event| -> Result<(), SweepError> {
        if let Event::Ended(case, found) = event {
            rows.insert(case, columns.row(&sweep.plan, case, &found)?);
        }
        Ok(())
    })?;
    Ok(to_csv(std::iter::once(&columns.headings()).chain(rows.values())))
}

/// The report of a whole sweep whose rows are given as CSV with headings, as parts of it were written.
///
/// # Errors
/// They are not the rows of this sweep, each case once and in its order.
pub fn of_rows(sweep: &Sweep, options: &SweepOptions, rows: &[u8]) -> Result<SweepReport, SweepError> {
    let mut report = begun(sweep, options)?;
    let rows = whole_rows(rows, &report.columns.headings()).unwrap_or_default();
    let is_whole = rows.iter().map(case_of).eq((0..sweep.scenes.len()).map(Some));
    match is_whole {
        true => {
            report.join(rows);
            Ok(report)
        }
        false => Err(SweepError::NotItsRows),
    }
}

/// The rows of the part of a sweep that cannot be computed, with the reason, as CSV with headings.
pub fn failed_rows(sweep: &Sweep, options: &SweepOptions, reason: &str) -> Vec<u8> {
    let (columns, cases) = (columns(sweep, options), cases(sweep, options));
    let rows: Vec<TextRow> = cases.map(|case| columns.failed(&sweep.plan, case, reason)).collect();
    to_csv(std::iter::once(&columns.headings()).chain(&rows))
}

/// The columns of its table.
fn columns(sweep: &Sweep, options: &SweepOptions) -> Columns {
    Columns::new(&sweep.plan, &sweep.scenes, options.case.bars)
}

/// The cases that are computed.
fn cases(sweep: &Sweep, options: &SweepOptions) -> Range<usize> {
    let all = 0..sweep.scenes.len();
    options.part.map_or(all, |part| sweep.cases_of(part))
}

/// Whether the files of a sweep may stand in the folder `dir`.
fn check(dir: &Path) -> Result<(), Error> {
    let own = [TABLE_FILE, REPORT_FILE].into_iter().chain(ROTOR_FILES);
    folder::check(dir, own.map(OsStr::new))
}

/// The report of a sweep, or a part of it, before its first row.
///
/// # Errors
/// There is no case, or the first one does not become a film.
fn begun(sweep: &Sweep, options: &SweepOptions) -> Result<SweepReport, SweepError> {
    if sweep.scenes.is_empty() {
        return Err(SweepError::NoCases);
    }
    let identity = Identity {
        format: SWEEP_FORMAT.to_owned(),
        title: sweep.title.clone(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene_sha256: sweep.scene_sha256.clone(),
        mesh_sha256: meshes_sha256(&sweep.scenes)?,
        tables_sha256: tables_sha256(sweep)?,
        bars: options.case.bars,
        cases: sweep.scenes.len(),
        draws: sweep.plan.draws.as_ref().map(|draws| draws.options),
        part: options.part,
    };
    Ok(SweepReport {
        identity,
        effects: sweep.effects().map_err(Error::from)?,
        plan: sweep.plan.clone(),
        columns: columns(sweep, options),
        rows: Vec::new(),
        kept: 0,
        seconds: 0.0,
        is_joined: false,
        rotor_tables: Vec::new(),
    })
}

/// SHA-256 of all mesh files, each once; `None` where there are none.
fn meshes_sha256(scenes: &[Scene]) -> Result<Option<String>, Error> {
    let paths = scenes.iter().filter_map(|scene| scene.mesh.path());
    let read = |path: &Path| oilwedge_mesh::gmsh::read_bytes(path).map_err(|error| CompileError::from(error).into());
    sha256_of(paths, read)
}

/// SHA-256 of all tables of loads, gas pressures and measured shapes, and of the scenes of bearings on crankshafts,
/// each once; `None` where there are none.
fn tables_sha256(sweep: &Sweep) -> Result<Option<String>, Error> {
    let of_shafts: Vec<PathBuf> = (sweep.shafts.iter().flat_map(ShaftScene::files)).map(|(_, path, _)| path).collect();
    let tables = (sweep.scenes).iter().flat_map(Scene::files).filter(|(key, ..)| key.as_ref() != MESH_FILE);
    let read = |path: &Path| {
        let text = read_text(path).map_err(|error| CompileError::Duty(error.to_string()))?;
        Ok(text.into_bytes())
    };
    let tables = tables.map(|(_, path, _)| path);
    sha256_of(tables.chain(of_shafts.iter().map(PathBuf::as_path)), read)
}

/// SHA-256 of the digests of files, each once and in the order of their paths; `None` where there are none.
fn sha256_of<'a>(
    paths: impl Iterator<Item = &'a Path>,
    read: impl Fn(&Path) -> Result<Vec<u8>, Error>,
) -> Result<Option<String>, Error> {
    let paths: BTreeSet<&Path> = paths.collect();
    let mut hash = Sha256::new();
    for path in &paths {
        hash.update(Sha256::digest(read(path)?));
    }
    let digest = hash.finalize();
    Ok((!paths.is_empty()).then(|| digest.iter().map(|byte| format!("{byte:02x}")).collect()))
}
