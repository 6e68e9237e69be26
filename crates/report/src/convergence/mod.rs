//! The folder of a study: `converge.csv`, `.json`, `.svg` and `.png`, written whole or not at all.

mod csv;
#[cfg(test)]
pub(crate) mod tests;

use std::ffi::OsStr;
use std::path::Path;

use crate::json::json;
use crate::page::STUDY_PAGE_FILE;
use crate::{Error, folder, plot};
use oilwedge_campaign::convergence::Convergence;

/// Everything that a study found, for scripts.
pub const REPORT_FILE: &str = "converge.json";
/// The files of a study. The numbers for scripts are taken away first and come last, so they are the sign that all are
/// there and of one study.
pub const FILES: [&str; 4] = ["converge.csv", "converge.svg", "converge.png", REPORT_FILE];

/// Whether the files of a study may stand in the folder `dir`: better asked before the study than after it.
///
/// # Errors
/// `dir` is no folder, or a folder stands in the place of a file.
pub fn check(dir: &Path) -> Result<(), Error> {
    folder::check(dir, FILES.iter().map(OsStr::new))
}

/// Writes the files of a study into the folder `dir`, which is made if need be. Those of an earlier study are replaced;
/// where there are no levels only `converge.json` is written, and the others of an earlier study are removed.
///
/// # Errors
/// A number is not finite, the plots cannot be drawn, or the system refuses; the old files are then left as they were.
pub fn write(dir: &Path, study: &Convergence) -> Result<(), Error> {
    let json = json(&study.report)?;
    let (mut table, mut svg, mut png) = (None, None, None);
    if study.report.levels().next().is_some() {
        let figure = plot::convergence_figure(study);
        png = Some(plot::to_png(&figure)?);
        svg = Some(figure.to_svg());
        table = Some(csv::to_csv(&study.report));
    }
    let [csv_file, svg_file, png_file, json_file] = FILES.map(OsStr::new);
    let steps = [
        (json_file, None),
        (STUDY_PAGE_FILE.as_ref(), None),
        (csv_file, table.as_deref().map(str::as_bytes)),
        (svg_file, svg.as_deref().map(str::as_bytes)),
        (png_file, png.as_deref()),
        (json_file, Some(json.as_bytes())),
    ];
    folder::replace(dir, &steps)
}
