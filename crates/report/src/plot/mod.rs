//! Pictures, drawn by the crate `drawing`: of a film, a sweep, a convergence study and a balance of heat.
//!
//! Reading order: `film.rs` (a film as it is drawn), `liner.rs` (the unrolled liner on the sheet), `field_map.rs`,
//! `section.rs` (across the bearing), `sample.rs`, `profiles.rs` and `hottest.rs`, `sweep.rs`, `files.rs` (which
//! pictures there are); `convergence.rs` and `error_map.rs` (errors, and the adaptive mesh), `temperature.rs` (two
//! curves that cross), `tolerances.rs` (what spreads a number), `load.rs` (the load over a cycle), `orbit.rs`,
//! `shaft.rs` (a crankshaft to scale), `shaft_line.rs` (bent), `shaft_cycle.rs` (all its bearings).

mod bore;
mod convergence;
mod error_map;
mod field_map;
mod files;
mod film;
mod hottest;
mod liner;
mod load;
mod orbit;
mod profiles;
mod sample;
mod section;
mod shaft;
mod shaft_cycle;
mod shaft_line;
mod sweep;
mod temperature;
mod tolerances;

pub(crate) use field_map::FieldColours;
pub use files::{
    CONVERGENCE, PLOT_FOLDER, PictureFiles, PlotOptions, Unknown, WIDTHS, figures_of_sweep, film_figures,
    picture_files, write_pictures,
};
pub use film::DrawnFilm;
pub(crate) use film::drawn_fields;
pub use load::load_figures;
pub(crate) use orbit::{film_over_cycle, path_and_load};
pub use orbit::{orbit_figures, orbits_beside};
pub use sample::sampled;
pub(crate) use sample::{Finder, InTriangle};
pub use shaft_cycle::{BENT, SHAFT, shaft_figures};
pub(crate) use sweep::quantity_names;
pub(crate) use temperature::BALANCE;
pub use temperature::TEMPERATURE_FILES;
pub(crate) use temperature::temperature_figure;
pub(crate) use tolerances::TOLERANCES;

use crate::Error;
use oilwedge_campaign::convergence::Convergence;
use oilwedge_drawing::Figure;

/// The picture of a convergence study.
pub fn convergence_figure(study: &Convergence) -> Figure {
    convergence::figure(study)
}

/// The PNG of a figure at 300 dots per inch.
///
/// # Errors
/// [`Error::Format`]: it is too large.
pub fn to_png(figure: &Figure) -> Result<Vec<u8>, Error> {
    figure.to_png().map_err(Error::format("PNG"))
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
            raw.points.extend((0..5).map(|j| [0.1 * f64::from(k) / f64::from(n), 0.01 * f64::from(j) - 0.02]));
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
        MarkedMesh { level: 2, mesh: Arc::new(mesh), radius: 0.0375, indicator: Some(indicator) }
    }

    #[test]
    fn the_picture_has_title_curves_bars_and_the_mesh() {
        let mut report = example();
        report.head.title = "A <bearing> & \u{1b}co".into();
        report.prices[0].extrapolated = true;
        let study = Convergence { report, mesh: Some(marked(20)) };
        let figure = convergence_figure(&study);
        let svg = figure.to_svg();
        let told = [
            "A &lt;bearing&gt; &amp; co",
            "P2 uniform",
            "estimated error bar",
            "predicted",
            "time from the scene to the answer",
            "relative error of the load",
            "Adaptive mesh, level 2: 160 triangles; colour",
            "width=\"170mm\"",
        ];
        for words in told {
            assert!(svg.contains(words), "no {words}");
        }
        assert!(svg.len() < 60_000, "{} bytes", svg.len());
        let png = to_png(&figure).expect("dots");
        let dots = |place: usize| u32::from_be_bytes([0, 1, 2, 3].map(|k| png[place + k]));
        assert_eq!(dots(16), 2008);
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
        let svg = convergence_figure(&Convergence { report, mesh: None }).to_svg();
        assert!(svg.contains("one level only") && !svg.contains("Adaptive mesh"));
    }
}
