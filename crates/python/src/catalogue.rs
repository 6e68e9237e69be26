//! What names mean: the catalogues of the program, and units.

use numpy::PyReadonlyArray1;
use oilwedge_report::catalogue::{CatalogueEntry, entries, explain as meant};
use oilwedge_report::digits::{bar, quantity_value};
use oilwedge_report::json;
use oilwedge_study::column::Column;
use oilwedge_study::quantities::row;
use pyo3::prelude::*;

use crate::failure::PythonFailure;

/// All names in JSON.
#[pyfunction]
pub(crate) fn catalogue(py: Python<'_>) -> PyResult<String> {
    json(&entries()).map_err(|error| PythonFailure::Report(error).raised(py))
}

/// What a name means, in words.
#[pyfunction]
pub(crate) fn explain(py: Python<'_>, name: &str) -> PyResult<String> {
    let entries = meant(name.trim()).map_err(|near| {
        let hint = near.map_or(String::new(), |near| format!("; did you mean \"{near}\"?"));
        PythonFailure::Argument(format!("nothing is called \"{name}\"{hint}")).raised(py)
    })?;
    Ok(entries.iter().map(CatalogueEntry::in_words).collect::<Vec<_>>().join("\n"))
}

/// Value and error of a quantity in another unit.
#[pyfunction]
pub(crate) fn converted(
    py: Python<'_>,
    name: String,
    unit: &str,
    value: f64,
    error: Option<f64>,
) -> PyResult<(f64, Option<f64>)> {
    let refused = |message: String| PythonFailure::Argument(message).raised(py);
    let row = row(&name).ok_or_else(|| refused(format!("\"{name}\" is no quantity")))?;
    let column = Column::in_unit(name.into(), row, unit);
    let column = column.map_err(|(message, help)| refused(format!("{message}; {help}")))?;
    Ok((column.value(value), error.map(|error| column.error(error))))
}

/// A value with its error and unit, to the digits that are known.
#[pyfunction]
pub(crate) fn shown(value: f64, error: Option<f64>, unit: &str) -> String {
    let number = quantity_value(value, error, DIGITS);
    let error = error.filter(|error| *error > 0.0);
    let bar = error.map_or(String::new(), |error| format!(" \u{b1} {}", bar(error)));
    format!("{number}{bar} {}", if unit == "1" { "" } else { unit }).trim_end().to_owned()
}

/// Digits of a value without a bar.
const DIGITS: usize = 6;

/// Numbers as tables have them; empty where there is none.
#[pyfunction]
pub(crate) fn texts(numbers: PyReadonlyArray1<'_, f64>) -> PyResult<Vec<String>> {
    let text = |number: &f64| {
        if number.is_nan() { String::new() } else { format!("{number:?}") }
    };
    Ok(numbers.as_slice()?.iter().map(text).collect())
}

/// Version of the program.
#[pyfunction]
pub(crate) fn version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}
