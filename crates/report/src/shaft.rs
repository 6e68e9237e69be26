//! The folder of a run of a crankshaft: `result.json`, `bearings.csv` (a row for each bearing) and, of a cycle, `bearing_N.csv` with the path and the films of each
//! journal and what its shell bears.

use std::ffi::OsString;
use std::path::Path;

use oilwedge_study::column::Column;
use oilwedge_study::quantities::Quantity;
use oilwedge_study::shaft::{ShaftResult, ShaftRun};

use crate::Error;
use crate::folder::replace;
use crate::json::json;
use crate::orbit_table::{exact, orbit_table};
use crate::results::RESULT_FILE;
use crate::sweep::to_csv;

/// File of the bearings.
pub const BEARINGS_FILE: &str = "bearings.csv";

/// Name of the file of a bearing, by its number from 0.
pub fn path_file(number: usize) -> String {
    format!("bearing_{}.csv", number + 1)
}

/// Writes the files of a run into the folder `dir`, which is made if need be, and returns their names.
///
/// # Errors
/// [`Error`]: a number is not finite, or the system refuses; the old files are then left as they were.
pub fn write_shaft(dir: &Path, run: &ShaftRun) -> Result<Vec<String>, Error> {
    let result = json(&run.result)?;
    let bearings = bearings_table(&run.result)?;
    let paths: Result<Vec<_>, Error> = run.paths.iter().map(|path| orbit_table(&path.path)).collect();
    let paths = paths?;
    let mut files = vec![(OsString::from(RESULT_FILE), None)];
    files.push((BEARINGS_FILE.into(), Some(bearings.as_slice())));
    files.extend(
        (0..)
            .zip(&paths)
            .map(|(number, path)| (path_file(number).into(), Some(path.as_slice()))),
    );
    files.push((RESULT_FILE.into(), Some(result.as_bytes())));
    let steps: Vec<_> = files
        .iter()
        .map(|(name, content)| (name.as_os_str(), *content))
        .collect();
    replace(dir, &steps)?;
    let names = files
        .iter()
        .skip(1)
        .map(|(name, _)| name.to_string_lossy().into_owned());
    Ok(names.collect())
}

/// The table of the bearings: name, place, motion of the shell, greatest tilt, then all numbers with their bars, if any.
///
/// # Errors
/// A number is not finite.
pub fn bearings_table(result: &ShaftResult) -> Result<Vec<u8>, Error> {
    let mut columns: Vec<(Column, bool)> = Vec::new();
    for quantity in result.bearings.iter().flat_map(|bearing| &bearing.quantities) {
        if columns.iter().all(|(column, _)| column.quantity != quantity.name) {
            columns.push((Column::of(quantity.name.clone(), quantity.row), result.bars));
        }
    }
    let mut headings: Vec<String> = [
        "bearing",
        "z [m]",
        "shell offset [m]",
        "shell slope [rad]",
        "greatest tilt [rad]",
    ]
    .map(str::to_owned)
    .into();
    for (column, has_bar) in &columns {
        headings.push(column.heading());
        headings.extend(has_bar.then(|| column.error_heading()));
    }
    let mut rows = vec![headings];
    for bearing in &result.bearings {
        let mut row = vec![bearing.name.clone()];
        for value in [bearing.at, bearing.shell[0], bearing.shell[1], bearing.tilt_max] {
            row.push(exact(value)?);
        }
        for (column, has_bar) in &columns {
            let found = bearing
                .quantities
                .iter()
                .find(|quantity| quantity.name == column.quantity);
            let text = |value: Option<f64>| value.map_or(Ok(String::new()), exact);
            row.push(text(found.map(|quantity| quantity.value))?);
            if *has_bar {
                row.push(text(found.and_then(Quantity::error))?);
            }
        }
        rows.push(row);
    }
    Ok(to_csv(&rows))
}
