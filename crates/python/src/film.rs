//! Fields as arrays of numpy: memory is moved there, and nobody can write to it. For pictures and samples a copy is
//! made, which lives as long as they are drawn.

use numpy::{
    Element, IntoPyArray, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArray3, PyUntypedArrayMethods,
};
use oilwedge_study::fields::file_fields;
use oilwedge_study::picture::{FieldValues, FilmPicture, PictureField};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Names of the parts of a film.
const POINTS: &str = "points";
const CELLS: &str = "cells";
const POINT_DATA: &str = "point_data";
const CELL_DATA: &str = "cell_data";
const LINES: &str = "lines";

/// The parts of a film as arrays that cannot be written to: points and triangles, fields on both, lines.
pub(crate) fn moved(py: Python<'_>, picture: FilmPicture) -> PyResult<Bound<'_, PyDict>> {
    let film = PyDict::new(py);
    film.set_item(POINTS, array(py, picture.points.into_flattened(), &[3])?)?;
    film.set_item(CELLS, array(py, picture.cells.into_flattened(), &[6])?)?;
    film.set_item(POINT_DATA, fields(py, picture.point_data)?)?;
    film.set_item(CELL_DATA, fields(py, picture.cell_data)?)?;
    let lines = PyDict::new(py);
    for (name, pieces) in picture.lines {
        let numbers = pieces.into_flattened().into_flattened();
        lines.set_item(name, array(py, numbers, &[2, 3])?)?;
    }
    film.set_item(LINES, lines)?;
    Ok(film)
}

fn fields(py: Python<'_>, fields: Vec<PictureField>) -> PyResult<Bound<'_, PyDict>> {
    let arrays = PyDict::new(py);
    for field in fields {
        let values = match field.values {
            FieldValues::Scalars(values) => array(py, values, &[])?,
            FieldValues::Vectors(values) => array(py, values.into_flattened(), &[3])?,
            FieldValues::Rows(width, values) => array(py, values, &[width])?,
        };
        arrays.set_item(field.name, values)?;
    }
    Ok(arrays)
}

/// An array of rows of this shape.
fn array<'py, T: Element>(py: Python<'py>, values: Vec<T>, shape: &[usize]) -> PyResult<Bound<'py, PyAny>> {
    let rows = values.len() / shape.iter().product::<usize>();
    let flat = values.into_pyarray(py);
    flat.getattr("flags")?.setattr("writeable", false)?;
    let whole: Vec<usize> = std::iter::once(rows).chain(shape.iter().copied()).collect();
    match shape.is_empty() {
        true => Ok(flat.into_any()),
        // A view of an array that cannot be written to cannot be either.
        false => Ok(flat.reshape(whole)?.into_any()),
    }
}

/// A picture of arrays; with the field of this name alone, if one is given.
///
/// # Errors
/// An array has another shape than those of a film.
pub(crate) fn picture(film: &Bound<'_, PyDict>, only: Option<&str>) -> PyResult<FilmPicture> {
    let points: PyReadonlyArray2<'_, f64> = part(film, POINTS)?.extract()?;
    let cells: PyReadonlyArray2<'_, u32> = part(film, CELLS)?.extract()?;
    let mut lines = Vec::new();
    for (name, pieces) in part(film, LINES)?.cast::<PyDict>()?.iter() {
        let pieces: PyReadonlyArray3<'_, f64> = pieces.extract()?;
        let piece = |[a, b, c, d, e, f]: [f64; 6]| [[a, b, c], [d, e, f]];
        let pieces = rows(pieces.as_slice()?).into_iter().map(piece);
        lines.push((name.extract()?, pieces.collect()));
    }
    Ok(FilmPicture {
        points: rows::<f64, 3>(points.as_slice()?),
        cells: rows::<u32, 6>(cells.as_slice()?),
        point_data: picture_fields(&part(film, POINT_DATA)?, only)?,
        cell_data: picture_fields(&part(film, CELL_DATA)?, only)?,
        lines,
    })
}

fn part<'py>(film: &Bound<'py, PyDict>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    let part = film.get_item(name)?;
    part.ok_or_else(|| PyValueError::new_err(format!("the film has no {name}")))
}

fn rows<T: Copy, const N: usize>(numbers: &[T]) -> Vec<[T; N]> {
    numbers.as_chunks::<N>().0.to_vec()
}

fn picture_fields(fields: &Bound<'_, PyAny>, only: Option<&str>) -> PyResult<Vec<PictureField>> {
    let mut found = Vec::new();
    for (name, values) in fields.cast::<PyDict>()?.iter() {
        let name: String = name.extract()?;
        if only.is_some_and(|only| only != name) {
            continue;
        }
        let scalars: Result<PyReadonlyArray1<'_, f64>, _> = values.extract();
        let values = match scalars {
            Ok(scalars) => FieldValues::Scalars(scalars.as_slice()?.to_vec()),
            Err(_) => {
                let vectors: PyReadonlyArray2<'_, f64> = values.extract()?;
                match vectors.shape()[1] {
                    3 => FieldValues::Vectors(rows::<f64, 3>(vectors.as_slice()?)),
                    width => FieldValues::Rows(width, vectors.as_slice()?.to_vec()),
                }
            }
        };
        let row = file_fields().find(|row| row.name == name);
        found.push(PictureField { unit: row.map_or("", |row| row.unit).into(), name: name.into(), values });
    }
    Ok(found)
}
