//! The picture of a convergence study: error against time and unknowns, and the mesh.
//!
//! Reading order: [`canvas`] (points on a sheet, over plotters), [`axes`], [`errors`], [`mesh`], [`palette`], [`raster`]
//! (the same drawing as dots).

mod axes;
mod canvas;
mod errors;
mod mesh;
mod palette;
mod raster;

pub use raster::to_png;

use axes::plain;
use canvas::{Canvas, Letters, in_points};
use palette::GREY;
use plotters::style::text_anchor::{HPos, VPos};

use crate::convergence::{Convergence, ConvergenceReport};

/// Width of the sheet [points].
const WIDTH: f64 = 1200.0;
/// Where its columns begin and how wide they are together.
const INNER: [f64; 2] = [20.0, 1160.0];
/// Where the curves begin and how high they are.
const CURVES: [f64; 2] = [118.0, 380.0];
/// Where the mesh begins.
const MESH: f64 = 572.0;
/// Longest title [letters].
const LONGEST_TITLE: usize = 90;

/// Why there is no picture.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlotError {
    /// plotters refused.
    #[error("the plots cannot be drawn: {0}; this is a fault of the program, please report the scene")]
    Drawing(String),
    /// The drawing does not become dots.
    #[error("the plots cannot be written as PNG: {0}; this is a fault of the program, please report the scene")]
    Raster(String),
}

/// The picture of a study as SVG.
///
/// # Errors
/// [`PlotError::Drawing`].
pub fn to_svg(study: &Convergence) -> Result<String, PlotError> {
    let mesh_height = study.mesh.as_ref().map(|marked| mesh::height(marked, INNER[1]));
    let size = [WIDTH, (MESH + mesh_height.unwrap_or(0.0)).ceil()];
    let mut text = String::new();
    let canvas = Canvas::new(&mut text, size)?;
    let bold = Letters {
        bold: true,
        ..plain(19.0, (HPos::Left, VPos::Center))
    };
    let report = &study.report;
    let left = INNER[0] + 74.0;
    canvas.text([left, 30.0], &shortened(&report.title), bold)?;
    let lesser = Letters {
        colour: GREY,
        ..plain(13.0, (HPos::Left, VPos::Center))
    };
    canvas.text([left, 57.0], &subtitle(report), lesser)?;
    errors::draw_legend(&canvas, report, left, 90.0)?;
    errors::draw(&canvas, report, [INNER[0], CURVES[0], INNER[1], CURVES[1]])?;
    if let Some(marked) = &study.mesh {
        mesh::draw(&canvas, marked, report, [INNER[0], MESH, INNER[1]])?;
    }
    canvas.finish()?;
    Ok(in_points(&text, size))
}

fn shortened(title: &str) -> String {
    let mut letters = title.chars();
    let short: String = letters.by_ref().take(LONGEST_TITLE).collect();
    match letters.next() {
        Some(_) => short + "\u{2026}",
        None => short,
    }
}

/// What errors are measured against.
fn subtitle(report: &ConvergenceReport) -> String {
    let Some(reference) = &report.reference else {
        return String::new();
    };
    let unit = if report.goal.unit == "1" {
        ""
    } else {
        report.goal.unit.as_str()
    };
    let known = reference
        .uncertainty
        .map(|known| format!(", known to {known:.0e}"))
        .unwrap_or_default();
    format!(
        "Error of the {} against the finest answer, {:.9} {unit}: {}, level {}, {} unknowns{known}",
        report.goal.name,
        reference.value,
        reference.strategy.name(),
        reference.level,
        reference.unknowns
    )
}
