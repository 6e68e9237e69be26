//! Engine bearings: a car's crankshaft bearing in balance of heat, and the bearing and bolts of a tractor's
//! connecting rod.

use std::f64::consts::PI;

use oilwedge_bearing::{CapBolts, Shell, ThermalBalance};
use oilwedge_campaign::{Compare, Records};
use oilwedge_study::result::RunResult;
use oilwedge_study::{RunOptions, compile, run_telling};

use crate::scenes::{table, variant};

/// Speed [rpm], load [N], and the numbers that the fits of ISO 7902 were printed to give there: temperature of the film
/// and of the oil that leaves [degrees C], viscosity [mPa.s], eccentricity, thinnest film [um], friction [W], both
/// flows together [l/min].
pub const CAR: [(f64, f64, [f64; 7]); 3] = [
    (1100.0, 901.5, [76.65, 78.29, 12.519, 0.7069, 13.48, 43.66, 0.4418]),
    (1900.0, 1557.1, [78.40, 81.81, 11.899, 0.7143, 13.14, 125.23, 0.6132]),
    (3200.0, 2622.6, [81.20, 87.40, 10.996, 0.7255, 12.63, 334.27, 0.8986]),
];

/// Scene 20 at a speed [rpm] and under a load [N]: its result, and the standard's own balance of heat.
///
/// # Panics
/// If there is none.
pub fn car(turns: f64, force: f64) -> (RunResult, Vec<f64>) {
    let scene = variant("20_heat_balance", |scene| {
        table(scene, "journal").insert("speed".into(), format!("{turns} rpm").into());
        table(scene, "load").insert("force".into(), format!("{force} N").into());
    });
    let options = RunOptions { bars: false, ..RunOptions::default() };
    let model = compile(&scene).expect("a model");
    let found = run_telling(&model, &options, None).expect("a film");
    let mut records = Records::default();
    Compare::Standard.solve((&scene, &model), &options, &found, &mut records).expect("the standard");
    let balance = records.standard.and_then(|record| record.balance).expect("a balance of the standard");
    (found.result, balance.0.into_iter().map(|(_, value)| value).collect())
}

/// The numbers of [`CAR`] by the standard's own balance.
pub fn by_standard(heat: &[f64]) -> [f64; 7] {
    let units = [1.0, 1.0, 1e3, 1.0, 1e6, 1.0, 6e4];
    std::array::from_fn(|k| units[k] * heat[k])
}

/// The numbers of [`CAR`] by a film.
///
/// # Panics
/// If it lacks one.
pub fn by_film(result: &RunResult) -> [f64; 7] {
    let value = |name: &str| result.by_name(name).expect(name).value;
    [
        value("temperature_effective"),
        value("temperature_outlet"),
        1e3 * value("viscosity_effective"),
        value("eccentricity"),
        1e6 * value("film_thickness_min"),
        value("friction_power"),
        6e4 * value("side_flow"),
    ]
}

/// The joint of the tractor's connecting rod with the roundings of the print: lambda = 0.272, pi = 3.14.
pub fn tractor_joint() -> CapBolts {
    CapBolts {
        reciprocating_mass: 2.755 + 0.675,
        rotating_mass: 2.025,
        cap_mass: 0.405,
        crank_radius: 0.0625,
        rod_length: 0.0625 / 0.272,
        bolts: 2,
        diameter: 0.010,
        stress_area: 56.7e-6,
        load_share: 0.18,
        tightness: 3.0,
        torque_coefficient: 0.15,
        shell: Some(Shell {
            protrusion: 0.025e-3,
            modulus: 1.9e11,
            section: 1.32e-4,
            // 0.0335 m, and 3.14 for pi.
            radius: 0.10519 / PI,
        }),
    }
}

/// A line of the tractor's chain: what it is, how it follows, printed, the unit of its last digit, recomputed.
pub struct Link {
    /// What it is, with its unit.
    pub what: &'static str,
    /// How it follows from those above.
    pub formula: &'static str,
    /// Result as printed.
    pub printed: f64,
    /// One in the last digit printed.
    pub digit: f64,
    /// Result from the numbers as printed.
    pub value: f64,
}

/// The chain: mixing of hot oil, flow that the pump adds, and bolts, each from the printed numbers before it.
pub fn tractor() -> Vec<Link> {
    let link = |what, formula, printed, digit, value| Link { what, formula, printed, digit, value };
    let (q_1, q_0, rise, fresh) = (0.16, 0.01, 54.0, 20.0);
    let balance = ThermalBalance { inlet: fresh, heat_capacity: 1.8e6, housing: None };
    let [inlet, _] = balance.ends(fresh + rise * (q_0 / q_1 + 0.5), q_0 / q_1);
    let joint = tractor_joint();
    let pull = joint.inertia_force(260.0);
    let forces = joint.forces(2.0 * 12639.0);
    vec![
        link("oil that enters, t_in [C]", "t_0 + 54 q_0/q_1", 23.4, 0.1, inlet),
        link("film, t [C]", "t_in + 54/2", 50.4, 0.1, inlet + 0.5 * rise),
        link(
            "flow that the pump adds, q_2",
            "beta So (d/l)^2 p/k",
            1.37,
            0.01,
            0.6 * 76.3 * (0.065f64 / 0.032).powi(2) * (0.2 / 27.56),
        ),
        link("lambda", "r/l", 0.272, 1e-3, joint.crank_radius / 0.230),
        link("inertia of the cap [N]", "omega^2 r [m_j (1 + lambda) + (m_r - m_c)]", 25278.01, 0.01, pull),
        link("on each bolt [N]", "P/2", 12639.0, 1.0, joint.forces(pull).bolt_force),
        link("clamping [N]", "nu (1 - chi) P", 31091.94, 0.01, forces.preload - forces.shell_force),
        link("crush of the shell [N]", "Delta E F/(pi rho)", 5960.6, 0.1, forces.shell_force),
        link("preload [N]", "sum", 37053.0, 1.0, forces.preload),
        link("torque [N m]", "k Q d, k = 0.15", 56.0, 1.0, forces.torque),
        link("share of the working load [N]", "chi P", 2275.0, 1.0, forces.greatest - forces.preload),
        link("greatest force [N]", "sum", 39328.0, 1.0, forces.greatest),
    ]
}
