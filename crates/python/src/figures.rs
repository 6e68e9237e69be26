//! Pictures, pages and samples of results that Python holds.

use std::path::PathBuf;

use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use oilwedge_report::json::ResultFile;
use oilwedge_report::orbit_course::OrbitCourse;
use oilwedge_report::page::{self as pages, SceneFile};
use oilwedge_report::plot::{self, DrawnFilm, PlotOptions, Unknown, WIDTHS, figures_of_sweep, film_figures};
use oilwedge_study::fields::field as field_row;
use oilwedge_study::result::RunResult;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use serde::de::DeserializeOwned;

use crate::failure::PythonFailure;
use crate::film::picture;
use crate::work::done;

fn results<T: DeserializeOwned>(json: &str) -> Result<T, PythonFailure> {
    serde_json::from_str(json).map_err(|error| PythonFailure::Argument(format!("the result is no JSON: {error}")))
}

fn unknown(Unknown { name, known }: Unknown) -> PythonFailure {
    PythonFailure::Argument(format!("there is no \"{name}\" to draw; there are {}", known.join(", ")))
}

fn options(name: String, width: f64) -> Result<PlotOptions, PythonFailure> {
    let wanted = format!("width={width}: a number of mm from {} to {} is wanted", WIDTHS.start(), WIDTHS.end());
    let options = PlotOptions { selected: vec![name], width };
    (WIDTHS.contains(&width).then_some(options)).ok_or(PythonFailure::Argument(wanted))
}

/// Values of a field at angles [deg] and places along the axis [m], both of one length; NaN where there is no film.
#[pyfunction]
pub(crate) fn sampled<'py>(
    py: Python<'py>,
    json: String,
    film: &Bound<'py, PyDict>,
    field: String,
    places: [PyReadonlyArray1<'py, f64>; 2],
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let picture = picture(film, Some(&field))?;
    let [angles, z] = &places;
    let places: Vec<[f64; 2]> = angles.as_slice()?.iter().zip(z.as_slice()?).map(|(angle, z)| [*angle, *z]).collect();
    let values = done(py, Some(1), move |_| {
        let result: RunResult = results(&json)?;
        let radius = result.geometry.radius;
        let film = DrawnFilm::new(result, &picture)?;
        let points: Vec<[f64; 2]> = places.iter().map(|[angle, z]| [radius * angle.to_radians(), *z]).collect();
        let values = field_row(&field).and_then(|row| plot::sampled(&film, row, &points));
        values.ok_or_else(|| PythonFailure::Argument(format!("there is no field \"{field}\" to sample")))
    });
    Ok(values?.into_pyarray(py))
}

/// A picture of a film, or of a sweep where no film is given, as SVG; and as PNG if that is wanted.
#[pyfunction]
pub(crate) fn figure<'py>(
    py: Python<'py>,
    json: String,
    film: Option<&Bound<'py, PyDict>>,
    name: String,
    width: f64,
    format: String,
) -> PyResult<Bound<'py, PyBytes>> {
    let picture = film.map(|film| picture(film, None)).transpose()?;
    let bytes = done(py, Some(1), move |_| {
        let options = options(name, width)?;
        let figures = match &picture {
            Some(picture) => film_figures(&DrawnFilm::new(results(&json)?, picture)?, &options),
            None => figures_of_sweep(&results(&json)?, &options),
        };
        let figures = figures.map_err(unknown)?;
        let nothing = || PythonFailure::Argument(format!("\"{}\" has nothing to draw", options.selected[0]));
        let (_, figure) = figures.first().ok_or_else(nothing)?;
        match format.as_str() {
            "svg" => Ok(figure.to_svg().into_bytes()),
            _ => Ok(plot::to_png(figure)?),
        }
    });
    Ok(PyBytes::new(py, &bytes?))
}

/// The page of a result whose scene stands at `path`; `orbit` is the table of its path over a cycle.
#[pyfunction]
pub(crate) fn page<'py>(
    py: Python<'py>,
    json: String,
    film: Option<&Bound<'py, PyDict>>,
    orbit: Option<Vec<u8>>,
    path: PathBuf,
) -> PyResult<String> {
    let picture = film.map(|film| picture(film, None)).transpose()?;
    done(py, None, move |_| {
        let ResultFile { result, records } = results(&json)?;
        let course = orbit.map(|table| OrbitCourse::from_csv(&table)).transpose()?;
        let files = SceneFile::all(&result.head.scene, &path);
        let extras = pages::Extras { records: Some(&records), course: course.as_ref(), files: &files };
        Ok(pages::film_page(&result, picture.as_ref(), extras)?)
    })
}

/// The page of a sweep.
#[pyfunction]
pub(crate) fn sweep_page(py: Python<'_>, json: String) -> PyResult<String> {
    done(py, None, move |_| Ok(pages::sweep_page(&results(&json)?, &[])?))
}
