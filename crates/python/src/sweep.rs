//! One scene for many values of its keys.

use std::path::{Path, PathBuf};

use oilwedge_report::json;
use oilwedge_report::sweep::{SweepOptions, TABLE_FILE, run};
use oilwedge_report::tables::sweep_report;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::cases::{SweepTexts, sweep_of};
use crate::failure::PythonFailure;
use crate::run::RunRequest;
use crate::scene::PyScene;
use crate::work::done;

/// Runs the sweep of a scene into the folder `out`, or into none that stays.
#[pyfunction]
pub(crate) fn sweep<'py>(
    py: Python<'py>,
    scene: &PyScene,
    asked: RunRequest,
    out: Option<PathBuf>,
    fresh: bool,
) -> PyResult<SweepTexts<'py>> {
    let (own, path) = (scene.scene.clone(), scene.path.clone());
    let (csv, json, words) = done(py, asked.threads, move |interrupt| {
        let cases = sweep_of(&own, &path)?;
        let temporary;
        let folder = match &out {
            Some(out) => out,
            None => {
                temporary = tempfile::tempdir().map_err(|source| system(&std::env::temp_dir(), source))?;
                temporary.path()
            }
        };
        let options = SweepOptions { case: asked.options(&own, interrupt), fresh, part: None };
        let report =
            run(&cases, &options, folder, &mut |_| {}).map_err(|error| PythonFailure::Sweep(path, Box::new(error)))?;
        let table = folder.join(TABLE_FILE);
        let csv = std::fs::read(&table).map_err(|source| system(&table, source))?;
        Ok((csv, json(&report)?, sweep_report(&report, None)))
    })?;
    Ok((PyBytes::new(py, &csv), json, words))
}

fn system(path: &Path, source: std::io::Error) -> PythonFailure {
    let path = path.to_path_buf();
    PythonFailure::Report(oilwedge_report::Error::System { path, source })
}
