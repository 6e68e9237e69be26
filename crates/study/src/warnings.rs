//! Warnings beside a result, in sentences.

use crate::compile::Study;
use crate::effects;
use crate::measure::Measured;
use crate::regime::constant_viscosity;

/// Greatest ratio of film thicknesses at the corners of a triangle of a resolved film.
const RESOLVED: f64 = 2.0;
/// What the reader should be warned of.
pub fn warnings(study: &Study, measured: &Measured) -> Vec<String> {
    let mut warnings = Vec::from_iter(mesh(study));
    warnings.extend(warnings_beside_bars(study, measured));
    warnings
}

/// Warnings where error bars show how well the mesh resolves the film.
pub fn warnings_beside_bars(study: &Study, measured: &Measured) -> Vec<String> {
    let mut warnings = mesh_warnings(study);
    warnings.extend(under_tension(study, measured));
    warnings.extend(effects::warnings(study, measured));
    warnings.extend(constant_viscosity(study, measured));
    let fallbacks = measured.fallbacks.iter();
    warnings.extend(fallbacks.map(|fallback| format!("{fallback}: a fallback; compare with a finer mesh")));
    warnings
}

fn mesh(study: &Study) -> Option<String> {
    let step = steepest_cell(study);
    (step > RESOLVED).then(|| {
        format!(
            "the film is not resolved where it is thin: its thickness changes {step:.1} times within one triangle; give a finer mesh ([mesh] size)"
        )
    })
}

/// Greatest ratio of the film thicknesses at the corners of any triangle.
fn steepest_cell(study: &Study) -> f64 {
    let mesh = study.system.space().mesh();
    (0..mesh.triangles().len())
        .map(|t| {
            let thickness = study.problem.thickness_at(t, &mesh.corners(t));
            let least = thickness.iter().copied().fold(f64::INFINITY, f64::min);
            thickness.iter().copied().fold(0.0, f64::max) / least
        })
        .fold(1.0, f64::max)
}

/// How the mesh of the result differs from that of the file.
pub fn mesh_warnings(study: &Study) -> Vec<String> {
    let meshed_anew = study.is_laid_anew.then(|| {
        "the triangles of the mesh file do not follow the flow, along which a mass-conserving film carries its oil: the film was meshed anew in rows along the flow with the file's geometry and edge lengths; layout = \"file\" under [mesh] keeps the triangles of the file".to_owned()
    });
    let flips = (study.flips > 0).then(|| {
        format!(
            "the mesh was made Delaunay by {} edge flip{} (points, rims and lines stay): obtuse triangles spoil the film fraction of a mass-conserving film",
            study.flips,
            if study.flips == 1 { "" } else { "s" }
        )
    });
    meshed_anew.into_iter().chain(flips).collect()
}

/// That a film without a model of cavitation bears tension.
fn under_tension(study: &Study, measured: &Measured) -> Option<String> {
    (measured.under_tension > 0.0).then(|| {
        format!(
            "full Sommerfeld film: the pressure falls to {:.2} bar and lies below the {:.2} bar of the ends on {} of the film; oil bears no such tension, but the load counts it; choose a model under [cavitation]",
            1e-5 * measured.extremes.least,
            1e-5 * study.problem.bearing.end_pressure,
            percent(measured.under_tension)
        )
    })
}

/// A share with two significant digits or more.
pub(crate) fn percent(share: f64) -> String {
    match 100.0 * share {
        large if large >= 10.0 => format!("{large:.0} %"),
        middle if middle >= 1.0 => format!("{middle:.1} %"),
        small if small >= 0.01 => format!("{small:.2} %"),
        tiny => format!("{tiny:.0e} %"),
    }
}

#[cfg(test)]
mod tests {
    use super::percent;

    #[test]
    fn shares_are_readable() {
        let shares = [1.0, 0.4321, 0.0432, 0.0043, 3e-7].map(percent);
        assert_eq!(shares, ["100 %", "43 %", "4.3 %", "0.43 %", "3e-5 %"]);
    }
}
