//! The quantities of a solved film, in the order of the report.

use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::quantities::cavity::{self, Cavity};
use oilwedge_reynolds::quantities::flow::{self, Flows};
use oilwedge_reynolds::quantities::friction::friction;
use oilwedge_reynolds::quantities::inlet::inlet_flow;
use oilwedge_reynolds::quantities::load::{self, Load};
use oilwedge_reynolds::quantities::power::{self, Power};
use oilwedge_reynolds::quantities::pressure::{self, Extremes};
use oilwedge_reynolds::quantities::similarity;
use oilwedge_reynolds::supply::Place;
use oilwedge_reynolds::{FilmProblem, FilmSolution, FilmSystem, JournalState};

use crate::compile::Study;
use crate::joint;
use crate::result::Quantity;
use crate::thermal;

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
    /// Flow into the loaded film [m3/s]; none at rest.
    pub inlet_flow: Option<f64>,
    /// Powers, put in and turned into heat.
    pub power: Power,
    /// Least film thickness on the liner [m].
    pub least_thickness: f64,
    /// The cavity, of models that have one while they solve.
    pub cavity: Option<Cavity>,
    /// Share of the meshed area [1] below the pressure of the ends, of a full Sommerfeld film with tension; else zero.
    pub under_tension: f64,
    /// Ways out that the solver had to take, in words.
    pub fallbacks: Vec<String>,
}

impl Measured {
    /// What the journal's centre puts in as it moves [W].
    pub fn motion_power(&self, journal: &JournalState) -> f64 {
        let ([x, y], [by_x, by_y]) = (journal.velocity, self.load.total.force);
        x * by_x + y * by_y
    }
}

/// Measures a solved film.
pub fn measure(problem: &FilmProblem, system: &FilmSystem, film: &FilmSolution) -> Measured {
    let extremes = pressure::extremes(problem, system, film);
    Measured {
        load: load::load(problem, system, film),
        flows: flow::flows(problem, system, film),
        inlet_flow: inlet_flow(problem, system, film),
        power: power::power(problem, system, film),
        least_thickness: pressure::least_thickness(problem, system),
        cavity: problem
            .cavitation
            .has_free_boundary()
            .then(|| cavity::cavity(system, film)),
        under_tension: match problem.cavitation.bears_tension() && has_tension(problem, &extremes) {
            true => cavity::share_below(problem, system, film, problem.bearing.end_pressure),
            false => 0.0,
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
pub(crate) fn drag(problem: &FilmProblem) -> f64 {
    let slenderness = problem.bearing.radius / problem.bearing.clearance;
    problem.lubricant.viscosity * problem.journal.speed.abs() * slenderness.powi(2)
}

/// Load [N] that the pressures of the film could carry, all on one side.
pub fn possible_load(problem: &FilmProblem, measured: &Measured) -> f64 {
    load::possible_load(problem, &measured.load.total)
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
pub fn quantities_at(study: &Study, problem: &FilmProblem, measured: &Measured) -> Vec<Quantity> {
    let (system, supply_pressure) = (&study.system, study.supply_pressure);
    let Measured {
        load,
        extremes,
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
    // A remainder may round to the whole turn.
    let degrees = |angle: f64| angle.to_degrees().rem_euclid(360.0) % 360.0;
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
    if let Some(temperature) = study.oil.temperature {
        add("temperature_effective", "t_m", temperature - ZERO_CELSIUS, "degC");
        add("viscosity_effective", "mu0", problem.lubricant.viscosity, "Pa.s");
    }
    add("viscosity_max", "mu_max", extremes.viscosity, "Pa.s");
    if let Some(cavity) = cavity {
        add("cavity_share", "A_c/A", cavity.share, "1");
    }
    if let Some(least) = cavity.and_then(|cavity| cavity.least_fraction) {
        add("film_fraction_min", "theta_min", least, "1");
    }
    list.extend(flow_quantities(problem, system, measured));
    list.extend(friction_quantities(problem, measured, directed));
    list.extend(thermal::quantities(study, measured));
    list.push(Quantity::new("pressure_integral", "Int p dA", load.total.pressure, "N"));
    for (name, share) in &load.cut_out {
        list.push(Quantity::new(format!("load_x.{name}"), "W_x", share.force[0], "N"));
        list.push(Quantity::new(format!("load_y.{name}"), "W_y", share.force[1], "N"));
    }
    if let Some(cap) = &study.cap {
        list.extend(joint::quantities(cap, journal.speed, load.total.force));
    }
    list
}

/// Where the oil goes; sealed ends have no side flow.
fn flow_quantities(problem: &FilmProblem, system: &FilmSystem, measured: &Measured) -> Vec<Quantity> {
    let Measured { flows, inlet_flow, .. } = measured;
    let by_place = |place: Place| {
        (system.supply.regions().iter().zip(&flows.regions)).filter(move |(region, _)| region.place == place)
    };
    let mut list = Vec::new();
    let mut add = |name: &str, symbol: &str, value: f64, unit: &str| {
        list.push(Quantity::new(name, symbol, value, unit));
    };
    let side: Vec<(&str, f64)> = by_place(Place::End)
        .map(|(region, flow)| (region.name.trim_start_matches("end"), -flow.net))
        .collect();
    let both = side.iter().map(|(_, flow)| flow).sum::<f64>();
    if !side.is_empty() {
        add("side_flow", "Q_s", both, "m3/s");
    }
    for (end, flow) in &side {
        add(&format!("side_flow{end}"), "Q_s", *flow, "m3/s");
    }
    if let Some(inlet) = *inlet_flow {
        add("inlet_flow", "Q", inlet, "m3/s");
    }
    if let Some(unit) = similarity::flow_unit(&problem.bearing, &problem.journal) {
        if !side.is_empty() {
            add("side_flow_number", "Q_s*", both / unit, "1");
        }
        if let Some(inlet) = *inlet_flow {
            add("inlet_flow_number", "Q*", inlet / unit, "1");
        }
    }
    for (region, flow) in by_place(Place::Feed) {
        add(&format!("feed_flow.{}", region.name), "Q_f", flow.net, "m3/s");
    }
    if problem.cavitation.drops_pressures() {
        add("cavity_flow", "Q_c", flows.cavity, "m3/s");
    }
    list
}

/// What it takes to turn and to move the journal; a load without direction has no coefficient of friction.
fn friction_quantities(problem: &FilmProblem, measured: &Measured, directed: bool) -> Vec<Quantity> {
    let (journal, power, load) = (&problem.journal, &measured.power, &measured.load);
    let mut list = Vec::new();
    let mut add = |name: &str, symbol: &str, value: f64, unit: &str| {
        list.push(Quantity::new(name, symbol, value, unit));
    };
    if let Some(friction) = friction(journal, power) {
        add("friction_torque", "T", friction.on_journal, "N.m");
        add("friction_torque_bearing", "T_b", friction.on_bearing, "N.m");
        if directed {
            let coefficient = friction.coefficient(&problem.bearing, load.magnitude());
            add("friction_coefficient", "f", coefficient, "1");
        }
        add("friction_power", "P", power.friction(), "W");
        add("friction_shear_power", "P_s", power.shear, "W");
        add("friction_pressure_power", "P_p", power.pressure, "W");
        if problem.cavitation.drops_pressures() {
            add("friction_cavity_power", "P_sc", power.cavity_shear, "W");
        }
    }
    if journal.velocity != [0.0; 2] {
        add("squeeze_power", "P_e", measured.motion_power(journal), "W");
    }
    list
}
