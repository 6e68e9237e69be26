//! Warnings beside a result, in sentences.

use oilwedge_reynolds::error_bar::UNRESOLVED;

use crate::effects;
use crate::estimate::Estimated;
use crate::film::Film;
use crate::measure::Measured;
use crate::oil::Oil;
use crate::refinement::wide_bars;
use crate::regime::{Regime, constant_viscosity};
use crate::solved::{Errors, Solved};
use crate::warning::{self, Warning};

/// Greatest ratio of film thicknesses at the corners of a triangle of a resolved film.
const RESOLVED: f64 = 2.0;

/// All warnings beside the result of a solved film: about the film, its errors, and assumptions that it breaks. The
/// density of `oil` decides whether the film is laminar.
pub fn all_warnings(oil: &Oil, solved: &Solved, estimated: &Estimated, errors: Errors) -> Vec<Warning> {
    let regime = Regime::of(oil, &solved.film, &estimated.measured);
    let mut warnings = result_warnings(solved, estimated, errors);
    warnings.extend(wide_bar(solved, estimated));
    warnings.extend(regime.warnings(&solved.film, &estimated.measured));
    warnings
}

/// Warnings about a solved film and its errors.
fn result_warnings(solved: &Solved, estimated: &Estimated, errors: Errors) -> Vec<Warning> {
    let bare: Vec<&str> = (estimated.quantities.iter())
        .filter(|quantity| quantity.bar.is_none())
        .map(|quantity| &*quantity.name)
        .collect();
    // Error bars show how well the mesh resolves the film.
    let unresolved = unresolved_thickness(&solved.film).filter(|_| !bare.is_empty());
    let mut warnings = Vec::from_iter(unresolved);
    warnings.extend(film_warnings(&solved.film, &estimated.measured));
    if estimated.spread > UNRESOLVED {
        warnings.push(warning::CROSSWISE.says(format!(
            "the triangles do not follow the flow and spread oil across it, by which numbers may be off by {:.0} %: there are no error bars, and a finer mesh of such triangles is no better; mesh the film in rows along the flow (under [mesh] remove layout = \"file\" or give size, or bring a file whose triangles have an edge along the flow)",
            100.0 * estimated.spread
        )));
    } else if errors == Errors::Estimated && !bare.is_empty() && !solved.is_ended() {
        warnings.push(warning::NO_BAR.says(format!(
            "this mesh does not resolve the film well enough for an error bar of {}; give a finer one ([mesh] size or tolerance)",
            bare.join(", ")
        )));
    }
    warnings
}

/// The warning that bars which an engineer wants narrow are not.
fn wide_bar(solved: &Solved, estimated: &Estimated) -> Option<Warning> {
    let targets = solved.film.model.targets.as_ref()?;
    let wide = wide_bars(&solved.film, estimated, &targets.wanted);
    let (name, _) = wide.first()?;
    let told: Vec<String> = (wide.iter()).map(|(name, bar)| format!("{name} ({})", percent(*bar))).collect();
    Some(warning::WIDE_BAR.says(format!(
        "wide error bars: {}; for narrower ones give a tolerance under [mesh], as tolerance = {{ {name} = \"1 %\" }}: a finer mesh will take longer",
        told.join(", ")
    )))
}

/// Warnings about a film without error bars.
pub fn warnings(film: &Film, measured: &Measured) -> Vec<Warning> {
    let mut warnings = Vec::from_iter(unresolved_thickness(film));
    warnings.extend(film_warnings(film, measured));
    warnings
}

/// Warnings about a film, beside those about how well its mesh resolves it.
fn film_warnings(film: &Film, measured: &Measured) -> Vec<Warning> {
    let mut warnings = mesh_warnings(film);
    warnings.extend(without_coefficients(measured));
    warnings.extend(under_tension(film, measured));
    warnings.extend(unlimited_flow(film));
    warnings.extend(effects::warnings(film, measured));
    warnings.extend(constant_viscosity(film, measured));
    let fallbacks = measured.fallbacks.iter();
    warnings.extend(
        fallbacks.map(|fallback| warning::FALLBACK.says(format!("{fallback}: a fallback; compare with a finer mesh"))),
    );
    warnings
}

/// The warning that the film thickness changes too much within one triangle.
fn unresolved_thickness(film: &Film) -> Option<Warning> {
    let step = steepest_cell(film);
    (step > RESOLVED).then(|| {
        warning::UNRESOLVED.says(format!(
            "the film is not resolved where it is thin: its thickness changes {step:.1} times within one triangle; give a finer mesh ([mesh] size)"
        ))
    })
}

/// Greatest ratio of the film thicknesses at the corners of any triangle.
fn steepest_cell(film: &Film) -> f64 {
    let mesh = film.system.space().mesh();
    (0..mesh.triangles().len())
        .map(|t| {
            let thickness = &film.problem.thickness_at(t, &mesh.corners(t))[..3];
            let least = thickness.iter().copied().fold(f64::INFINITY, f64::min);
            thickness.iter().copied().fold(0.0, f64::max) / least
        })
        .fold(1.0, f64::max)
}

/// How the mesh of the result differs from that of the file.
pub fn mesh_warnings(film: &Film) -> Vec<Warning> {
    let meshed_anew = film.origin.is_laid_anew.then(|| {
        warning::REMESHED.says("the triangles of the mesh file do not follow the flow, along which a mass-conserving film carries its oil: the film was meshed anew in rows along the flow with the file's geometry and edge lengths; layout = \"file\" under [mesh] keeps the triangles of the file")
    });
    let flips = (film.origin.flips > 0).then(|| {
        warning::FLIPPED.says(format!(
            "the mesh was made Delaunay by {} edge flip{} (points, rims and lines stay): obtuse triangles spoil the film fraction of a mass-conserving film",
            film.origin.flips,
            if film.origin.flips == 1 { "" } else { "s" }
        ))
    });
    meshed_anew.into_iter().chain(flips).collect()
}

/// The warning that oil flows round a corner from one pressure to another.
fn unlimited_flow(film: &Film) -> Option<Warning> {
    let jumps = film.system.supply.jumps(film.system.space());
    let mut feeds: Vec<&str> = jumps.iter().map(|[feed, _]| *feed).collect();
    feeds.dedup();
    (!feeds.is_empty()).then(|| {
        warning::DIVERGENT.says(format!(
            "the flow of \"{}\" has no limit: at its corners it meets an end of another pressure, and the oil that flows there from one to the other grows like the logarithm of the mesh; load, pressure and friction are sound; leave a land at the ends (a shorter groove), or give the groove the pressure of the ends",
            feeds.join("\", \"")
        ))
    })
}

/// Why a film that was asked for stiffness and damping has none.
fn without_coefficients(measured: &Measured) -> Option<Warning> {
    let reason = measured.dynamics.as_ref()?.as_ref().err()?;
    Some(warning::NO_COEFFICIENTS.says(format!(
        "stiffness, damping and what follows from them could not be computed and are left out: {reason}; all other numbers stand; give another mesh ([mesh] size), or other frequencies ([dynamics] whirl)"
    )))
}

/// The warning that a film without a model of cavitation bears tension.
fn under_tension(film: &Film, measured: &Measured) -> Option<Warning> {
    (measured.under_tension > 0.0).then(|| {
        warning::TENSION.says(format!(
            "full Sommerfeld film: the pressure falls to {:.2} bar and lies below the {:.2} bar of the ends on {} of the film; oil bears no such tension, but the load counts it; choose a model under [cavitation]",
            1e-5 * measured.extremes.least,
            1e-5 * film.problem.bearing.end_pressure,
            percent(measured.under_tension)
        ))
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
    use std::path::Path;

    use super::{percent, warnings};
    use crate::compile::compile;
    use crate::measure::{Measured, measure};
    use crate::warning;

    /// A film that was asked for stiffness and damping says why it has none; one that was not asked says nothing.
    #[test]
    fn coefficients_that_are_left_out_are_explained() {
        let text = "bearing = { diameter = \"75 mm\", length = \"75 mm\", clearance = \"37.5 um\" }\nmesh = { size = \"20 mm\" }\n\
            oil = { viscosity = \"0.4 Pa.s\" }\njournal = { speed = \"10 rad/s\", eccentricity = 0.4, min_film_angle = \"0 rad\" }\n\
            cavitation = { model = \"reynolds\" }\ndynamics = {}\n";
        let scene = crate::parse(text, Path::new("ring.toml")).expect("a scene");
        let film = compile(&scene).and_then(|model| model.film()).expect("a film");
        let solved = film.problem.solve(&film.system).expect("a solution");
        let plain = measure(&solved);
        let said = |measured: &Measured| {
            let mut warnings = warnings(&film, measured).into_iter();
            warnings.find(|warning| warning.kind == &warning::NO_COEFFICIENTS)
        };
        assert_eq!(said(&plain), None);
        let mut measured = plain.with_dynamics(&film, &solved, None);
        assert!(measured.dynamics().is_some());
        assert_eq!(said(&measured), None);
        measured.dynamics = Some(Err(oilwedge_fem::Error::TooLarge { unknowns: 1_234_567 }));
        assert!(measured.dynamics().is_none());
        let warning = said(&measured).expect("a warning");
        assert!(warning.contains("1234567 unknowns does not fit in memory"), "{warning}");
    }

    #[test]
    fn shares_are_readable() {
        let shares = [1.0, 0.4321, 0.0432, 0.0043, 3e-7].map(percent);
        assert_eq!(shares, ["100 %", "43 %", "4.3 %", "0.43 %", "3e-5 %"]);
    }
}
