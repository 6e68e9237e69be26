//! The cases of a sweep, in parts for workers that share it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use oilwedge_campaign::sweep::{Part, Sweep};
use oilwedge_report::json;
use oilwedge_report::sweep::{SweepOptions, failed_rows, of_rows, part_rows};
use oilwedge_report::tables::sweep_report;
use oilwedge_study::Interrupt;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::failure::PythonFailure;
use crate::run::RunRequest;
use crate::scene::PyScene;
use crate::work::done;

/// A table as Python has it: CSV, JSON, and words for people.
pub(crate) type SweepTexts<'py> = (Bound<'py, PyBytes>, String, String);

/// The cases of a sweep, read and checked.
#[pyclass(frozen, module = "oilwedge._native")]
pub(crate) struct Cases {
    sweep: Arc<Sweep>,
    scene: Arc<oilwedge_scene::Scene>,
    path: PathBuf,
}

#[pymethods]
impl Cases {
    /// The cases of a scene.
    #[new]
    fn of(py: Python<'_>, scene: &PyScene) -> PyResult<Self> {
        let (own, path) = (Arc::new(scene.scene.clone()), scene.path.clone());
        let read = Arc::clone(&own);
        let place = path.clone();
        let sweep = done(py, Some(1), move |_| sweep_of(&read, &place))?;
        Ok(Self { sweep: Arc::new(sweep), scene: own, path })
    }

    /// How many there are.
    #[getter]
    fn count(&self) -> usize {
        self.sweep.scenes.len()
    }

    /// How many chains of neighbours there are.
    #[getter]
    fn chains(&self) -> usize {
        self.sweep.chains().len()
    }

    /// The rows of part `number` of so many, as CSV with headings.
    fn part<'py>(&self, py: Python<'py>, asked: RunRequest, number: u32, of: u32) -> PyResult<Bound<'py, PyBytes>> {
        let (sweep, scene, path) = (Arc::clone(&self.sweep), Arc::clone(&self.scene), self.path.clone());
        let rows = done(py, asked.threads, move |interrupt| {
            let options = options(&asked, &scene, interrupt, Some(part(number, of)?));
            part_rows(&sweep, &options).map_err(|error| PythonFailure::Sweep(path, Box::new(error)))
        });
        Ok(PyBytes::new(py, &rows?))
    }

    /// Rows for the part at `place`, its number and how many there are, where it cannot be computed, as CSV with
    /// headings.
    fn failed<'py>(
        &self,
        py: Python<'py>,
        asked: RunRequest,
        place: (u32, u32),
        reason: &str,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let part = part(place.0, place.1).map_err(|failure| failure.raised(py))?;
        let options = options(&asked, &self.scene, Interrupt::NEVER, Some(part));
        Ok(PyBytes::new(py, &failed_rows(&self.sweep, &options, reason)))
    }

    /// The table of all rows, which are CSV with headings.
    fn joined<'py>(&self, py: Python<'py>, asked: RunRequest, rows: Vec<u8>) -> PyResult<SweepTexts<'py>> {
        let (sweep, scene, path) = (Arc::clone(&self.sweep), Arc::clone(&self.scene), self.path.clone());
        let table = done(py, Some(1), move |interrupt| {
            let options = options(&asked, &scene, interrupt, None);
            let report =
                of_rows(&sweep, &options, &rows).map_err(|error| PythonFailure::Sweep(path, Box::new(error)))?;
            Ok((rows, json(&report)?, sweep_report(&report, None)))
        });
        let (csv, json, words) = table?;
        Ok((PyBytes::new(py, &csv), json, words))
    }
}

/// The sweep of a scene.
///
/// # Errors
/// It has none, or a case cannot be used.
pub(crate) fn sweep_of(scene: &oilwedge_scene::Scene, path: &Path) -> Result<Sweep, PythonFailure> {
    Sweep::of(scene)?
        .ok_or_else(|| PythonFailure::Argument(format!("the scene {} has no [sweep]; give axes", path.display())))
}

fn part(number: u32, of: u32) -> Result<Part, PythonFailure> {
    Part::new(number, of).ok_or_else(|| PythonFailure::Argument(format!("there is no part {number} of {of}")))
}

fn options(
    asked: &RunRequest,
    scene: &oilwedge_scene::Scene,
    interrupt: Interrupt,
    part: Option<Part>,
) -> SweepOptions {
    SweepOptions { case: asked.options(scene, interrupt), fresh: false, part }
}
