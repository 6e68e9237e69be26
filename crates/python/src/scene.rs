//! Scenes: texts that were read and checked.

use std::path::{Path, PathBuf};

use oilwedge_report::kinds::{KINDS, kind as text_of};
use oilwedge_scene::sweep::{changed, with_axes};
use pyo3::prelude::*;

use crate::failure::PythonFailure;
use crate::node::{Values, document, lines};

/// A scene that was read and checked.
#[pyclass(frozen, name = "Scene", module = "oilwedge._native")]
pub(crate) struct PyScene {
    /// The scene as the program reads it.
    pub(crate) scene: oilwedge_scene::Scene,
    /// Path at which the scene stands.
    #[pyo3(get)]
    pub(crate) path: PathBuf,
}

#[pymethods]
impl PyScene {
    /// Reads the file `path`.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let scene = py.detach(|| oilwedge_study::read(&path));
        let scene = scene.map_err(|error| PythonFailure::Scene(error).raised(py))?;
        Ok(Self { scene, path })
    }

    /// Reads the TOML `text`, which stands at `path`: files that it names count from the folder of that.
    #[staticmethod]
    fn parse(py: Python<'_>, text: &str, path: PathBuf) -> PyResult<Self> {
        Self::of_text(text, path).map_err(|failure| failure.raised(py))
    }

    /// Reads a mapping.
    #[staticmethod]
    fn of_mapping(py: Python<'_>, description: &Bound<'_, PyAny>, path: PathBuf) -> PyResult<Self> {
        let text = document(description)?;
        Self::parse(py, &text, path)
    }

    /// The scene with keys set to other values.
    fn changed(&self, py: Python<'_>, changes: &Bound<'_, PyAny>) -> PyResult<Self> {
        let changes = lines(changes, Values::Single)?;
        let text = changed(&self.scene.text, &self.path, &changes).map_err(PythonFailure::Scene);
        let scene = text.and_then(|text| Self::of_text(&text, self.path.clone()));
        scene.map_err(|failure| failure.raised(py))
    }

    /// The scene with the axes of a sweep.
    fn with_axes(&self, py: Python<'_>, axes: &Bound<'_, PyAny>) -> PyResult<Self> {
        let sweep = format!("[sweep]\n{}", lines(axes, Values::Listed)?);
        let text = with_axes(&self.scene.text, &self.path, &sweep).map_err(PythonFailure::Scene);
        let scene = text.and_then(|text| Self::of_text(&text, self.path.clone()));
        scene.map_err(|failure| failure.raised(py))
    }

    /// Text of the scene.
    #[getter]
    fn text(&self) -> &str {
        &self.scene.text
    }

    /// Title of the scene.
    #[getter]
    fn title(&self) -> &str {
        &self.scene.title
    }

    /// SHA-256 of its text.
    #[getter]
    fn sha256(&self) -> &str {
        &self.scene.sha256
    }

    /// Keys of the axes of its sweep.
    #[getter]
    fn axes(&self) -> Vec<&str> {
        let plan = self.scene.sweep.iter();
        plan.flat_map(|plan| plan.axes.iter().map(|axis| axis.path.as_str())).collect()
    }

    /// The files that it names, by their keys.
    #[getter]
    fn files(&self) -> Vec<(String, &Path)> {
        (self.scene.files()).map(|(key, path, _)| (key.into_owned(), path)).collect()
    }

    /// Whether it gives a tolerance.
    #[getter]
    fn gives_tolerance(&self) -> bool {
        self.scene.gives_tolerance()
    }
}

impl PyScene {
    fn of_text(text: &str, path: PathBuf) -> Result<Self, PythonFailure> {
        let scene = oilwedge_study::parse(text, Path::new(&path))?;
        Ok(Self { scene, path })
    }
}

/// Names of the kinds of scenes to begin with.
#[pyfunction]
pub(crate) fn kinds() -> Vec<&'static str> {
    KINDS.iter().map(|(name, _)| *name).collect()
}

/// The text of the scene of a kind; `None` where there is no such kind.
#[pyfunction]
pub(crate) fn kind(name: &str) -> Option<&'static str> {
    text_of(name)
}
