//! The folder of a run of a crankshaft: `result.json`, `bearings.csv` (a row for each bearing) and, of a cycle,
//! `bearing_N.csv` with the path and the films of each journal and what its shell bears. Shafts beside it, cut or with
//! other counterweights, have files of the same kinds: `cut.json`, `cut_bearings.csv`, `cut_bearing_N.csv`.

use std::ffi::OsString;
use std::path::Path;

use oilwedge_study::shaft::{ShaftResult, ShaftRun, Variant};

use crate::Error;
use crate::folder::replace;
use crate::json::json;
use crate::number_columns::{self, cells, columns_of, exact};
use crate::orbit_table::orbit_table;
use crate::page::PAGE_FILE;
use crate::results::RESULT_FILE;
use crate::sweep::to_csv;

/// File of the bearings.
pub const BEARINGS_FILE: &str = "bearings.csv";

/// A shaft beside that of the scene.
pub type ShaftBeside = (Variant, ShaftRun);

/// File of the numbers of a shaft; `None`: that of the scene.
pub fn result_file(variant: Option<Variant>) -> String {
    variant.map_or(RESULT_FILE.to_owned(), |variant| format!("{}.json", variant.name()))
}

/// Name of the file of a bearing, by its number from 0.
pub fn path_file(variant: Option<Variant>, number: usize) -> String {
    prefixed(variant, &format!("bearing_{}.csv", number + 1))
}

fn prefixed(variant: Option<Variant>, file: &str) -> String {
    variant.map_or(file.to_owned(), |variant| format!("{}_{file}", variant.name()))
}

/// Writes the files of a run and of those beside it into the folder `dir`, which is made if need be, and returns their
/// names. The page of an earlier run is removed, and so are the numbers of shafts beside it.
///
/// # Errors
/// [`Error`]: a number is not finite, or the system refuses; the old files are then left as they were.
pub fn write_shaft(dir: &Path, run: &ShaftRun, beside: &[ShaftBeside]) -> Result<Vec<String>, Error> {
    let others = beside.iter().map(|(variant, run)| files(Some(*variant), run));
    // The numbers of the scene come last.
    let files: Vec<_> = others.chain([files(None, run)]).collect::<Result<Vec<_>, Error>>()?.concat();
    let old = Variant::ALL.map(|variant| result_file(Some(variant)));
    let removed = [RESULT_FILE, PAGE_FILE].into_iter().chain(old.iter().map(String::as_str));
    let removed = removed.map(|name| (OsString::from(name), None));
    let written = files.iter().map(|(name, content)| (name.into(), Some(content.as_slice())));
    let steps: Vec<(OsString, Option<&[u8]>)> = removed.chain(written).collect();
    let steps: Vec<_> = steps.iter().map(|(name, content)| (name.as_os_str(), *content)).collect();
    replace(dir, &steps)?;
    Ok(files.into_iter().map(|(name, _)| name).collect())
}

/// The files of one shaft, the numbers last.
fn files(variant: Option<Variant>, run: &ShaftRun) -> Result<Vec<(String, Vec<u8>)>, Error> {
    let mut files = vec![(prefixed(variant, BEARINGS_FILE), bearings_table(&run.result)?)];
    for (number, path) in run.paths.iter().enumerate() {
        files.push((path_file(variant, number), orbit_table(&path.path)?));
    }
    files.push((result_file(variant), json(&run.result)?.into_bytes()));
    Ok(files)
}

/// The table of the bearings: name, place, motion of the shell, greatest tilt, then all numbers with their bars, if
/// any.
///
/// # Errors
/// A number is not finite.
pub fn bearings_table(result: &ShaftResult) -> Result<Vec<u8>, Error> {
    let columns = columns_of(result.bearings.iter().flat_map(|bearing| &bearing.quantities));
    let mut headings: Vec<String> =
        ["bearing", "z [m]", "shell offset [m]", "shell slope [rad]", "greatest tilt [rad]"].map(str::to_owned).into();
    headings.extend(number_columns::headings(&columns, result.bars));
    let mut rows = vec![headings];
    for bearing in &result.bearings {
        let mut row = vec![bearing.name.clone()];
        for value in [bearing.at, bearing.shell[0], bearing.shell[1], bearing.tilt_max] {
            row.push(exact(value, &bearing.name)?);
        }
        row.extend(cells(&columns, result.bars, &bearing.quantities, &bearing.name)?);
        rows.push(row);
    }
    Ok(to_csv(&rows))
}
