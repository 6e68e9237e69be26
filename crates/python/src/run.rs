//! One scene to its result.

use oilwedge_campaign::{Compare, Records, with_derivatives};
use oilwedge_report::orbit_table::orbit_table;
use oilwedge_report::result_json;
use oilwedge_study::orbit::no_map;
use oilwedge_study::picture::{FieldChoice, FilmPicture, PictureOptions, Surface};
use oilwedge_study::run::Run;
use oilwedge_study::{Interrupt, RunOptions};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::failure::PythonFailure;
use crate::film::moved;
use crate::numbers::Numbers;
use crate::scene::PyScene;
use crate::work::done;

/// How a scene is run, as Python says it.
#[derive(Debug, Clone, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct RunRequest {
    /// Whether error bars are estimated.
    bars: bool,
    /// Time limit of a search [s]; that of the program where none is given.
    max_seconds: Option<f64>,
    /// Most unknowns of refined meshes.
    max_unknowns: usize,
    /// Whether the film is drawn unrolled.
    unrolled: bool,
    /// Whether all numbers of the scene have their derivatives, not those with tolerances alone.
    sensitivity: bool,
    /// Threads; one for each core where no number is given.
    pub(crate) threads: Option<usize>,
}

impl RunRequest {
    /// The options as the program has them.
    pub(crate) fn options(&self, scene: &oilwedge_scene::Scene, interrupt: Interrupt) -> RunOptions {
        let usual = RunOptions::of(scene);
        let surface = if self.unrolled { Surface::Developed } else { Surface::Cylinder };
        RunOptions {
            picture: PictureOptions { surface, fields: FieldChoice::All },
            bars: self.bars,
            curve: true,
            max_unknowns: self.max_unknowns,
            interrupt,
            ..usual.limited(self.max_seconds)
        }
    }
}

/// What Python is given: numbers, film, path of the journal; and why some derivatives are not there.
type SolveReturn<'py> = ((Numbers, Option<Bound<'py, PyDict>>, Option<Bound<'py, PyBytes>>), Vec<String>);
/// What it is made of.
type SolvedParts = (Numbers, Option<FilmPicture>, Option<Vec<u8>>, Vec<String>);

/// Solves a scene.
#[pyfunction]
pub(crate) fn solve<'py>(
    py: Python<'py>,
    scene: &PyScene,
    asked: RunRequest,
    add_ons: Vec<String>,
) -> PyResult<SolveReturn<'py>> {
    let (own, path) = (scene.scene.clone(), scene.path.clone());
    let found = done(py, asked.threads, move |interrupt| {
        let options = asked.options(&own, interrupt);
        let model = oilwedge_study::compile(&own).map_err(PythonFailure::of(&path))?;
        if let Some(reason) = no_map(&model).filter(|_| add_ons.iter().any(|name| name == Compare::Mobility.name())) {
            return Err(PythonFailure::Argument(format!(
                "add_ons: no map stands for the film of {}, since {reason}; leave out \"{}\"",
                path.display(),
                Compare::Mobility.name()
            )));
        }
        if asked.sensitivity && own.differentiated(true).is_empty() {
            return Err(PythonFailure::Argument(
                "sensitivity=True: a cycle is differentiated by numbers with tolerances only, and the scene has none; give some, as \"30 um +- 3 um\"".to_owned(),
            ));
        }
        let run = oilwedge_study::run_telling(&model, &options, None).map_err(PythonFailure::of(&path))?;
        let (result, reasons) = with_derivatives(&own, &run, own.differentiated(asked.sensitivity), &options);
        let run = Run { result, solved: None, ..run };
        let mut records = Records::default();
        for kind in Compare::ALL.into_iter().filter(|kind| add_ons.iter().any(|name| name == kind.name())) {
            kind.solve((&own, &model), &options, &run, &mut records).map_err(PythonFailure::of(&path))?;
        }
        let orbit = run.orbit.as_ref().map(orbit_table).transpose()?;
        let json = result_json(&run.result, &records)?;
        Ok((Numbers::of_run(json, run.result, records), run.picture, orbit, reasons))
    });
    let (numbers, picture, orbit, reasons): SolvedParts = found?;
    let film = picture.map(|picture| moved(py, picture)).transpose()?;
    Ok(((numbers, film, orbit.map(|table| PyBytes::new(py, &table))), reasons))
}
