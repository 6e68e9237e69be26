//! What the reader of a result should doubt, in sentences.

use oilwedge_reynolds::{Cavitation, Form, Theory};

use crate::compile::Study;
use crate::measure::Measured;

/// The B/D up to which short bearings are taken for such.
pub const SHORT_TO: f64 = 0.25;
/// The B/D from which on long bearings are.
pub const LONG_FROM: f64 = 2.0;
/// Greatest ratio of film thicknesses at the corners of a triangle of a resolved film.
const RESOLVED: f64 = 2.0;
/// Oil that is made below this part of what passes is rounding.
const NOTHING: f64 = 1e-9;

/// What the reader should be warned of.
pub fn warnings(study: &Study, measured: &Measured) -> Vec<String> {
    let mut warnings = Vec::from_iter(mesh(study));
    warnings.extend(warnings_beside_bars(study, measured));
    warnings
}

/// The same where error bars tell how well the mesh resolves the film.
pub fn warnings_beside_bars(study: &Study, measured: &Measured) -> Vec<String> {
    let mut warnings: Vec<String> = [laid_anew(study), flips(study), theory(study), closure(study, measured)]
        .into_iter()
        .flatten()
        .collect();
    if study.problem.form == Form::AsPrinted {
        warnings.push(format!(
            "the as-printed equation is no mass balance: in and out differ by {:.2} % of the oil that enters",
            100.0 * measured.flows.imbalance
        ));
    }
    warnings.extend(crate::thermal::doubts(study, measured));
    let ways_out = measured.fallbacks.iter();
    warnings.extend(ways_out.map(|way| format!("{way}: a way out; compare with a finer mesh")));
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

/// That the triangles of the result are not those of the file.
pub fn laid_anew(study: &Study) -> Option<String> {
    study.is_laid_anew.then(|| {
        "the triangles of the mesh file do not follow the flow, along which model = \"jfo\" carries oil: the film was meshed anew in rows along the flow with the file's geometry and edge lengths; layout = \"file\" under [mesh] keeps the triangles of the file".to_owned()
    })
}

/// That the mesh of the result is not quite that of the file.
pub fn flips(study: &Study) -> Option<String> {
    (study.flips > 0).then(|| {
        format!(
            "the mesh was made Delaunay by {} edge flip{} (points, rims and lines stay): obtuse triangles spoil the film fraction of model = \"jfo\"",
            study.flips,
            if study.flips == 1 { "" } else { "s" }
        )
    })
}

/// Which flow a theory leaves out, where it should not.
fn theory(study: &Study) -> Option<String> {
    let bearing = &study.problem.bearing;
    let slenderness = 0.5 * bearing.length / bearing.radius;
    let (left_out, fit) = match study.problem.theory {
        Theory::Short if slenderness > SHORT_TO => ("around", format!("below {SHORT_TO}")),
        Theory::Long if slenderness < LONG_FROM => ("along the axis", format!("above {LONG_FROM}")),
        _ => return None,
    };
    Some(format!(
        "theory = \"{}\" leaves out the flow that pressure drives {left_out}, as suits B/D {fit}, and here B/D is {slenderness:.2}; --theories tells how far the result is from that of both flows",
        study.problem.theory.name()
    ))
}

/// What the closure gets wrong in this film.
fn closure(study: &Study, measured: &Measured) -> Option<String> {
    let Measured { extremes, flows, .. } = measured;
    match study.problem.cavitation {
        Cavitation::None if measured.under_tension > 0.0 => Some(format!(
            "full Sommerfeld film: the pressure falls to {:.2} bar and lies below the {:.2} bar of the ends on {} of the film; oil bears no such tension, but the load counts it; choose a model under [cavitation]",
            1e-5 * extremes.least,
            1e-5 * study.problem.bearing.end_pressure,
            percent(measured.under_tension)
        )),
        Cavitation::Guembel { .. } => Some(format!(
            "Guembel's film drops low pressures after the solve: oil is not conserved at its edge ({})",
            match flows.made() {
                little if little.abs() < NOTHING => "nothing was dropped here".to_owned(),
                made if made > 0.0 => format!("some {} of the oil that passes is made there", percent(made)),
                lost => format!("some {} of the oil that passes is lost there", percent(-lost)),
            }
        )),
        _ => None,
    }
}

/// A share with two significant digits or more.
fn percent(share: f64) -> String {
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
