//! Pictures: a convergence study (error against time and unknowns, and the mesh), a balance of heat, maps of cells, and plain charts.
//!
//! Reading order: `canvas.rs` (points on a sheet, over plotters), `axes.rs`, `errors.rs`, `mesh.rs`, `palette.rs`, `raster.rs` (the
//! same drawing as dots); `temperature.rs` (two curves that cross), `cells.rs` (maps), `chart.rs` (curves and marks over linear axes).

mod axes;
mod canvas;
mod cells;
mod chart;
mod errors;
mod mesh;
mod palette;
mod raster;
mod temperature;

pub use cells::{Cell, CellMap, cells_to_svg};
pub use chart::{COLOURS, Chart, Series, Style, charts_to_svg};
pub use raster::to_png;
pub use temperature::{TEMPERATURE_FILES, temperature_to_svg};

use canvas::{LEFT, Letters, sheet};
use palette::GREY;

use crate::Error;
use oilwedge_campaign::convergence::{Convergence, ConvergenceReport};

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

/// The picture of a study as SVG.
///
/// # Errors
/// [`Error::Format`].
pub fn to_svg(study: &Convergence) -> Result<String, Error> {
    let mesh_height = study.mesh.as_ref().map(|marked| mesh::height(marked, INNER[1]));
    let size = [WIDTH, (MESH + mesh_height.unwrap_or(0.0)).ceil()];
    let report = &study.report;
    let left = INNER[0] + 74.0;
    sheet(size, |canvas| {
        canvas.text([left, 30.0], &shortened(&report.title), Letters::new(19.0, LEFT).bold())?;
        canvas.text([left, 57.0], &subtitle(report), Letters::new(13.0, LEFT).coloured(GREY))?;
        errors::draw_legend(canvas, report, left, 90.0)?;
        errors::draw(canvas, report, [INNER[0], CURVES[0], INNER[1], CURVES[1]])?;
        match &study.mesh {
            Some(marked) => mesh::draw(canvas, marked, report, [INNER[0], MESH, INNER[1]]),
            None => Ok(()),
        }
    })
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
        .map(|known| format!(", itself known to {known:.0e}"))
        .unwrap_or_default();
    let decimals = (9.0 - reference.value.abs().log10().floor()).clamp(0.0, 15.0) as usize;
    format!(
        "Error of the {} against the finest answer, {:.decimals$} {unit}: {}, level {}, {} unknowns{known}",
        report.goal.name,
        reference.value,
        reference.strategy.name(),
        reference.level,
        reference.unknowns
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::convergence::tests::example;
    use oilwedge_campaign::convergence::MarkedMesh;
    use oilwedge_mesh::{Mesh, RawMesh};
    use std::sync::Arc;

    /// A strip of `n` by 4 squares, and a share of the error that falls with the distance from its middle.
    fn marked(n: u32) -> MarkedMesh {
        let mut raw = RawMesh::default();
        for k in 0..=n {
            raw.points
                .extend((0..5).map(|j| [0.1 * f64::from(k) / f64::from(n), 0.01 * f64::from(j) - 0.02]));
        }
        for k in 0..n {
            for j in 0..4 {
                let [a, b] = [5 * k + j, 5 * k + 5 + j];
                raw.triangles.extend([[a, b, b + 1], [a, b + 1, a + 1]]);
            }
        }
        let mesh = Mesh::build(raw).expect("a strip");
        let share = |t: usize| 10.0 * (-200.0 * (mesh.corners(t)[0][0] - 0.05).abs()).exp();
        let indicator = (0..mesh.triangles().len()).map(share).collect();
        MarkedMesh {
            level: 2,
            mesh: Arc::new(mesh),
            radius: 0.0375,
            indicator: Some(indicator),
        }
    }

    #[test]
    fn the_picture_tells_title_curves_bars_and_the_mesh() {
        let mut report = example();
        report.title = "A <bearing> & \u{1b}co".into();
        report.prices[0].extrapolated = true;
        let study = Convergence {
            report,
            mesh: Some(marked(20)),
        };
        let svg = to_svg(&study).expect("a drawing");
        let told = [
            "A &lt;bearing&gt; &amp; co",
            "P2 uniform",
            "estimated error bar",
            "predicted",
            "time from the scene to the answer",
            "relative error of the load",
            "Adaptive mesh, level 2: 160 triangles; colour",
            "axis [mm]",
        ];
        for words in told {
            assert!(svg.contains(words), "no {words}");
        }
        assert!(svg.starts_with("<svg width=\"1200\" height="));
        let height = mesh::height(&marked(20), INNER[1]);
        let png = to_png(&svg).expect("dots");
        let dots = |place: usize| u32::from_be_bytes([0, 1, 2, 3].map(|k| png[place + k]));
        assert_eq!(dots(16), 1920);
        assert_eq!(dots(20), (1.6 * (MESH + height).ceil()).ceil() as u32);
    }

    #[test]
    fn one_level_has_a_picture_too() {
        let mut report = example();
        report.strategies[0].levels.truncate(1);
        report.strategies[0].levels[0].relative_error = None;
        report.strategies[0].levels[0].relative_bar = None;
        report.prices.clear();
        if let Some(reference) = &mut report.reference {
            reference.uncertainty = None;
        }
        let study = Convergence { report, mesh: None };
        assert!(to_svg(&study).is_ok_and(|svg| svg.contains("one level only") && !svg.contains("Adaptive mesh")));
        assert_eq!(shortened(&"x".repeat(200)).chars().count(), LONGEST_TITLE + 1);
    }
}
