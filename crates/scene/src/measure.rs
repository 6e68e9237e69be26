//! The quantities of a solved film, in the order of the report.

use oilwedge_reynolds::FilmSolution;
use oilwedge_reynolds::quantities::flow::{self, Flows};
use oilwedge_reynolds::quantities::load::{self, Load};
use oilwedge_reynolds::quantities::pressure::{self, Extremes};
use oilwedge_reynolds::quantities::similarity;
use oilwedge_reynolds::supply::Place;

use crate::compile::Study;
use crate::report::Quantity;

/// A load below this fraction of (greatest pressure difference) x (projected area) has no direction.
const NO_LOAD: f64 = 1e-12;

/// Tension below this fraction of the range of pressure may be that of the interpolation.
const TENSION: f64 = 1e-5;

/// Greatest ratio of film thicknesses at the corners of a triangle of a resolved film.
const RESOLVED: f64 = 2.0;

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

/// Everything measured on one film.
#[derive(Debug)]
pub struct Measured {
    /// Load and its shares.
    pub load: Load,
    /// Extremes of pressure.
    pub extremes: Extremes,
    /// Flows by region.
    pub flows: Flows,
    /// Least film thickness on the liner [m].
    pub least_thickness: f64,
}

/// Measures a solved film.
pub fn measure(study: &Study, film: &FilmSolution) -> Measured {
    let Study { problem, system, .. } = study;
    Measured {
        load: load::load(problem, system, film),
        extremes: pressure::extremes(problem, system, film),
        flows: flow::flows(problem, system, film),
        least_thickness: pressure::least_thickness(problem, system),
    }
}

/// The quantities of the report; one without a meaning in this film is absent.
pub fn quantities(study: &Study, measured: &Measured) -> Vec<Quantity> {
    let Study {
        problem,
        system,
        supply_pressure,
        ..
    } = study;
    let Measured {
        load,
        extremes,
        flows,
        least_thickness,
    } = measured;
    let (bearing, journal) = (&problem.bearing, &problem.journal);
    let force = load.magnitude();
    let mut list = Vec::new();
    let mut add = |name: &str, symbol: &str, value: f64, unit: &str| {
        list.push(Quantity {
            name: name.to_owned(),
            symbol: symbol.to_owned(),
            value,
            unit: unit.to_owned(),
            error: None,
        });
    };
    add("load", "W", force, "N");
    add("load_x", "W_x", load.total.force[0], "N");
    add("load_y", "W_y", load.total.force[1], "N");
    let excess = (extremes.greatest - bearing.end_pressure)
        .abs()
        .max((extremes.least - bearing.end_pressure).abs());
    let directed = force > NO_LOAD * excess * 2.0 * bearing.radius * bearing.length;
    let degrees = |angle: f64| angle.to_degrees().rem_euclid(360.0);
    if directed {
        add("load_angle", "phi_W", degrees(load.angle()), "deg");
    }
    if let Some(value) = supply_pressure.and_then(|p_s| similarity::load_coefficient(bearing, p_s, force)) {
        add("load_coefficient", "C_w", value, "1");
    }
    if let Some(value) = similarity::sommerfeld_number(bearing, problem.lubricant.viscosity, journal, force) {
        add("sommerfeld_number", "So", value, "1");
    }
    let eccentric = journal.eccentricity() > 0.0;
    if directed && eccentric {
        let angle = similarity::attitude_angle(journal, load.angle());
        add("attitude_angle", "beta", angle.to_degrees(), "deg");
    }
    add("eccentricity", "eps", journal.eccentricity() / bearing.clearance, "1");
    if eccentric {
        add("min_film_angle", "phi_min", degrees(journal.min_film_angle()), "deg");
    }
    add("pressure_max", "p_max", extremes.greatest, "Pa");
    add("pressure_min", "p_min", extremes.least, "Pa");
    add("film_thickness_min", "h_min", *least_thickness, "m");
    add("viscosity_max", "mu_max", extremes.viscosity, "Pa.s");
    let by_place = |place: Place| {
        (system.supply.regions().iter().zip(&flows.regions)).filter(move |(region, _)| region.place == place)
    };
    let side: f64 = by_place(Place::End).map(|(_, flow)| -flow.net).sum();
    add("side_flow", "Q_s", side, "m3/s");
    for (region, flow) in by_place(Place::Feed) {
        add(&format!("feed_flow.{}", region.name), "Q_f", flow.net, "m3/s");
    }
    add("pressure_integral", "Int p dA", load.total.pressure, "N");
    for (name, share) in &load.cut_out {
        add(&format!("load_x.{name}"), "W_x", share.force[0], "N");
        add(&format!("load_y.{name}"), "W_y", share.force[1], "N");
    }
    list
}

/// What the reader should be warned of.
pub fn warnings(study: &Study, measured: &Measured) -> Vec<String> {
    use oilwedge_reynolds::{Cavitation, Form};
    let Measured { extremes, flows, .. } = measured;
    let end = study.problem.bearing.end_pressure;
    // A centred journal makes no pressure: what is left of its drag then is rounding.
    let bearing = &study.problem.bearing;
    let drag = study.problem.lubricant.viscosity * study.problem.journal.speed.abs();
    let rounding = NO_LOAD * drag * (bearing.radius / bearing.clearance).powi(2);
    let tension = end - extremes.least > (TENSION * (extremes.greatest - extremes.least)).max(rounding);
    let mut warnings = Vec::new();
    let step = steepest_cell(study);
    if step > RESOLVED {
        warnings.push(format!(
            "the film is not resolved where it is thin: its thickness changes {step:.1} times within one triangle; give a finer mesh ([mesh] size)"
        ));
    }
    match study.problem.cavitation {
        Cavitation::None if tension => warnings.push(format!(
            "full Sommerfeld film: the pressure falls to {:.2} bar, below the {:.2} bar at the ends; oil bears no such tension, but the load counts it; choose a model under [cavitation]",
            1e-5 * extremes.least,
            1e-5 * end
        )),
        Cavitation::Guembel { .. } => warnings.push(
            "Guembel's film drops low pressures after the solve: oil is not conserved at its edge, and the flows are those of the full film"
                .to_owned(),
        ),
        Cavitation::None | Cavitation::Reynolds { .. } | Cavitation::Jfo { .. } => {}
    }
    if matches!(study.problem.form, Form::AsPrinted(_)) {
        warnings.push(format!(
            "the as-printed equation is no mass balance: in and out differ by {:.2} % of the oil that enters",
            100.0 * flows.imbalance
        ));
    }
    warnings
}
