//! The quantities of a solved film, in the order of the report.

use oilwedge_reynolds::quantities::cavity::{self, Cavity};
use oilwedge_reynolds::quantities::flow::{self, Flows};
use oilwedge_reynolds::quantities::load::{self, Load};
use oilwedge_reynolds::quantities::pressure::{self, Extremes};
use oilwedge_reynolds::quantities::similarity;
use oilwedge_reynolds::supply::Place;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSolution, FilmSystem};

use crate::compile::Study;
pub use crate::doubts::warnings;
use crate::joint;
use crate::report::Quantity;

/// A load below this fraction of (greatest pressure difference, or pressure of drag) x (projected area) has no direction.
const NO_LOAD: f64 = 1e-12;

/// Tension below this fraction of the range of pressure may be that of the interpolation.
const TENSION: f64 = 1e-5;

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
    /// The cavity, of models that have one while they solve.
    pub cavity: Option<Cavity>,
    /// Share of the meshed area [1] below the pressure of the ends, of a full Sommerfeld film with tension; else zero.
    pub under_tension: f64,
    /// Ways out that the solver had to take, in words.
    pub fallbacks: Vec<String>,
}

/// Measures a solved film.
pub fn measure(problem: &FilmProblem, system: &FilmSystem, film: &FilmSolution) -> Measured {
    let extremes = pressure::extremes(problem, system, film);
    let breaks = matches!(problem.cavitation, Cavitation::Reynolds { .. } | Cavitation::Jfo { .. });
    Measured {
        load: load::load(problem, system, film),
        flows: flow::flows(problem, system, film),
        least_thickness: pressure::least_thickness(problem, system),
        cavity: breaks.then(|| cavity::cavity(system, film)),
        under_tension: match problem.cavitation {
            Cavitation::None if has_tension(problem, &extremes) => {
                cavity::share_below(problem, system, film, problem.bearing.end_pressure)
            }
            _ => 0.0,
        },
        extremes,
        fallbacks: film.fallbacks.clone(),
    }
}

/// True if the pressure falls below that of the ends by more than rounding and interpolation explain.
fn has_tension(problem: &FilmProblem, extremes: &Extremes) -> bool {
    // A centred journal makes no pressure: what is left of its drag then is rounding.
    let tension = problem.bearing.end_pressure - extremes.least;
    tension > (TENSION * (extremes.greatest - extremes.least)).max(NO_LOAD * drag(problem))
}

/// Pressure [Pa] that drag through the clearance makes.
fn drag(problem: &FilmProblem) -> f64 {
    let slenderness = problem.bearing.radius / problem.bearing.clearance;
    problem.lubricant.viscosity * problem.journal.speed.abs() * slenderness.powi(2)
}

/// Load [N] that the pressures of the film could carry, all on one side.
pub(crate) fn possible_load(problem: &FilmProblem, measured: &Measured) -> f64 {
    load::possible_load(problem, excess(problem, &measured.extremes))
}

/// Greatest difference [Pa] of the pressure from that of the ends.
fn excess(problem: &FilmProblem, extremes: &Extremes) -> f64 {
    let off = |p: f64| (p - problem.bearing.end_pressure).abs();
    off(extremes.greatest).max(off(extremes.least))
}

/// The quantities of the report; one without a meaning in this film is absent.
pub fn quantities(study: &Study, measured: &Measured) -> Vec<Quantity> {
    quantities_at(study, &study.problem, measured)
}

/// The same of a film of the study whose journal is elsewhere.
pub(crate) fn quantities_at(study: &Study, problem: &FilmProblem, measured: &Measured) -> Vec<Quantity> {
    let (system, supply_pressure) = (&study.system, study.supply_pressure);
    let Measured {
        load,
        extremes,
        flows,
        least_thickness,
        cavity,
        ..
    } = measured;
    let (bearing, journal) = (&problem.bearing, &problem.journal);
    let force = load.magnitude();
    let mut list = Vec::new();
    let mut add = |name: &str, symbol: &str, value: f64, unit: &str| {
        list.push(Quantity::new(name, symbol, value, unit));
    };
    add("load", "W", force, "N");
    add("load_x", "W_x", load.total.force[0], "N");
    add("load_y", "W_y", load.total.force[1], "N");
    let natural = excess(problem, extremes).max(drag(problem)) * 2.0 * bearing.radius * bearing.length;
    let directed = force > NO_LOAD * natural;
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
    if let Some(cavity) = cavity {
        add("cavity_share", "A_c/A", cavity.share, "1");
    }
    if let Some(least) = cavity.and_then(|cavity| cavity.least_fraction) {
        add("film_fraction_min", "theta_min", least, "1");
    }
    let by_place = |place: Place| {
        (system.supply.regions().iter().zip(&flows.regions)).filter(move |(region, _)| region.place == place)
    };
    let side: f64 = by_place(Place::End).map(|(_, flow)| -flow.net).sum();
    add("side_flow", "Q_s", side, "m3/s");
    for (region, flow) in by_place(Place::Feed) {
        add(&format!("feed_flow.{}", region.name), "Q_f", flow.net, "m3/s");
    }
    if matches!(problem.cavitation, Cavitation::Reynolds { .. }) {
        add("cavity_flow", "Q_c", flows.cavity, "m3/s");
    }
    add("pressure_integral", "Int p dA", load.total.pressure, "N");
    for (name, share) in &load.cut_out {
        add(&format!("load_x.{name}"), "W_x", share.force[0], "N");
        add(&format!("load_y.{name}"), "W_y", share.force[1], "N");
    }
    if let Some(cap) = &study.cap {
        list.extend(joint::quantities(cap, journal.speed, load.total.force));
    }
    list
}
