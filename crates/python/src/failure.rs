//! What goes wrong, as exceptions of the package. The exceptions themselves are Python, in
//! `python/oilwedge/_errors.py`.

use std::path::{Path, PathBuf};

use oilwedge_report::sweep::SweepError;
use oilwedge_report::tables::printable;
use oilwedge_scene::{Complaint, SceneError};
use oilwedge_study::CompileError;
use pyo3::exceptions::{PyKeyboardInterrupt, PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;

/// Module of the exceptions.
const ERRORS: &str = "oilwedge._errors";

/// Why there is no result.
#[derive(Debug)]
pub(crate) enum PythonFailure {
    /// The scene cannot be used.
    Scene(SceneError),
    /// The scene in this file does not become a film.
    Compile(PathBuf, CompileError),
    /// Results are not made or not written.
    Report(oilwedge_report::Error),
    /// A sweep is not run, or not to its end.
    Sweep(PathBuf, Box<SweepError>),
    /// An argument is wrong.
    Argument(String),
    /// The program has failed.
    Panic(String),
}

impl From<oilwedge_report::Error> for PythonFailure {
    fn from(error: oilwedge_report::Error) -> Self {
        Self::Report(error)
    }
}

impl From<SceneError> for PythonFailure {
    fn from(error: SceneError) -> Self {
        Self::Scene(error)
    }
}

impl PythonFailure {
    /// A failure of the scene at `path`.
    pub(crate) fn of(path: &Path) -> impl Fn(CompileError) -> Self {
        move |error| Self::Compile(path.to_path_buf(), error)
    }

    /// The failure as an exception.
    pub(crate) fn raised(self, py: Python<'_>) -> PyErr {
        match self {
            Self::Scene(error) => scene(py, error),
            Self::Compile(path, error) => compile(py, &path, &error),
            Self::Report(error) => report(py, Path::new(""), error),
            Self::Sweep(path, error) => sweep(py, &path, *error),
            Self::Argument(message) => PyValueError::new_err(message),
            Self::Panic(message) => {
                let words = format!("{message}; this is a fault of the program, please report the scene");
                exception(py, "InternalError", (words,))
            }
        }
    }
}

/// An exception of the package.
fn exception<'py>(py: Python<'py>, name: &str, arguments: impl pyo3::call::PyCallArgs<'py>) -> PyErr {
    let made = py.import(ERRORS).and_then(|errors| errors.getattr(name)?.call1(arguments));
    made.map_or_else(|error| error, PyErr::from_value)
}

/// A complaint as the arguments of `oilwedge.Complaint`.
type ComplaintArguments = (String, String, String, String, Option<(usize, usize)>);

fn parts(text: &str, complaint: &Complaint) -> ComplaintArguments {
    // Python counts letters, not bytes.
    let letters = |byte: usize| text.get(..byte).map(|before| before.chars().count());
    let span = complaint.span.as_ref().and_then(|span| Some((letters(span.start)?, letters(span.end)?)));
    let [key, value, message, help] =
        [&complaint.key, &complaint.value, &complaint.message, &complaint.help].map(|text| printable(text));
    (key, value, message, help, span)
}

fn scene(py: Python<'_>, error: SceneError) -> PyErr {
    let words = printable(&error.to_string());
    let complaints: Vec<ComplaintArguments> = match &error {
        SceneError::Syntax { text, complaints, .. } | SceneError::Complaints { text, complaints, .. } => {
            complaints.iter().map(|complaint| parts(text, complaint)).collect()
        }
        _ => Vec::new(),
    };
    exception(py, "SceneError", (words, complaints))
}

/// Faults of the mesh, but for those that are faults of the scene.
fn compile(py: Python<'_>, path: &Path, error: &CompileError) -> PyErr {
    let words = printable(&format!("the scene {}: {error}", path.display()));
    match error {
        CompileError::NoSteadyFilm | CompileError::UnusedMoment | CompileError::Duty(_) => {
            exception(py, "SceneError", (words, Vec::<ComplaintArguments>::new()))
        }
        _ => exception(py, "MeshError", (words,)),
    }
}

fn report(py: Python<'_>, path: &Path, error: oilwedge_report::Error) -> PyErr {
    use oilwedge_report::Error;
    match error {
        Error::Compile(error) => compile(py, path, &error),
        Error::System { .. } | Error::Busy { .. } | Error::Folder { .. } => {
            PyOSError::new_err(format!("{error}; give another folder as out"))
        }
        Error::Unreadable { .. } => PyValueError::new_err(error.to_string()),
        other => exception(py, "InternalError", (other.to_string(),)),
    }
}

fn campaign(py: Python<'_>, path: &Path, error: oilwedge_campaign::Error) -> PyErr {
    use oilwedge_campaign::Error;
    match error {
        Error::Compile(error) => compile(py, path, &error),
        Error::Threads(_) => PyRuntimeError::new_err(format!("{error}; give fewer threads")),
        other => PyValueError::new_err(other.to_string()),
    }
}

fn sweep(py: Python<'_>, path: &Path, error: SweepError) -> PyErr {
    match error {
        SweepError::Report(error) => report(py, path, error),
        SweepError::Campaign(error) => campaign(py, path, error),
        SweepError::Interrupted { .. } => PyKeyboardInterrupt::new_err(error.to_string()),
        SweepError::Other { .. } | SweepError::Earlier { .. } => {
            PyValueError::new_err(format!("{error}; give another folder as out, or replace it with fresh=True"))
        }
        SweepError::Busy { .. } => PyOSError::new_err(format!(
            "{error}; wait until it ends (a sweep that Ctrl-C ended still ends its last cases), or give another folder as out"
        )),
        other => PyValueError::new_err(other.to_string()),
    }
}
