//! The FlexPDE study (Mordvinkin, Gorkun, Sergienko 2016) and its independent recomputation.

use std::sync::OnceLock;

use oilwedge_reynolds::NoFilm;
use oilwedge_scene::Scene;
use serde_json::Value;

use crate::program::repository;
use crate::scenes::{Solved, solve, table, variant};

/// Supply pressure P_s of the study [Pa], its unit of pressure.
pub const SUPPLY_PRESSURE: f64 = 1.96e5;

/// One row of `tests/data/flexpde_study.json`.
pub struct Row {
    /// `shell` or `ring`.
    pub liner: String,
    /// `constant`, `conservative` or `as-printed`.
    pub viscosity: String,
    /// `none`, or a model and the cavitation pressure in P_s: `guembel P`, `reynolds P`, `jfo P`.
    pub cavitation: String,
    /// Eccentricity, viscosity [Pa s], speed [rad/s].
    pub eccentricity: f64,
    /// Viscosity mu0 [Pa s].
    pub mu0: f64,
    /// Speed [rad/s].
    pub omega: f64,
    /// The reference: C_w, attitude_deg, p_max, feed_flux, ...
    pub reference: Value,
}

fn data() -> Value {
    let path = repository().join("tests/data/flexpde_study.json");
    let text = std::fs::read_to_string(path).expect("reference of the study");
    serde_json::from_str(&text).expect("reference of the study is JSON")
}

/// All rows of the reference.
pub fn rows() -> Vec<Row> {
    let text = |row: &Value, key: &str| row[key].as_str().unwrap_or_default().to_owned();
    let number = |row: &Value, key: &str| row[key].as_f64().unwrap_or(f64::NAN);
    let list = data()["rows"].as_array().cloned().unwrap_or_default();
    list.into_iter()
        .map(|row| Row {
            liner: text(&row, "liner"),
            viscosity: text(&row, "viscosity"),
            cavitation: text(&row, "cavitation"),
            eccentricity: number(&row, "eccentricity"),
            mu0: number(&row, "mu0"),
            omega: number(&row, "omega"),
            reference: row,
        })
        .collect()
}

/// Greatest speeds [rad/s] with a film, each by the reference and as found here.
pub struct Limit {
    /// `shell` or `ring`.
    pub liner: String,
    /// Eccentricity.
    pub eccentricity: f64,
    /// Limits of a conservative film.
    pub conservative: [f64; 2],
    /// Limits of a film of the printed equation.
    pub as_printed: [f64; 2],
}

/// All limits of the reference, found once.
///
/// # Panics
/// If there is a film beyond one of them.
pub fn limits() -> &'static [Limit] {
    static LIMITS: OnceLock<Vec<Limit>> = OnceLock::new();
    LIMITS.get_or_init(|| {
        let list = data()["limits"].as_array().cloned().unwrap_or_default();
        let number = |row: &Value, key: &str| row[key].as_f64().unwrap_or(f64::NAN);
        let find = |row: &Value| {
            let liner = row["liner"].as_str().unwrap_or_default().to_owned();
            let eccentricity = number(row, "eccentricity");
            let [conservative, as_printed] = ["conservative", "as_printed"].map(|form| number(row, form));
            Limit {
                conservative: [conservative, limit_of_existence(&liner, eccentricity, 2.0 * conservative)],
                as_printed: [as_printed, fold(&liner, eccentricity, conservative)],
                liner,
                eccentricity,
            }
        };
        list.iter().map(find).collect()
    })
}

impl Row {
    /// The row as a scene: scene 02 or 04 with its keys changed.
    pub fn scene(&self) -> Scene {
        let name = if self.liner == "ring" { "04_flexpde_ring" } else { "02_flexpde_shell" };
        variant(name, |scene| {
            let journal = table(scene, "journal");
            journal.insert("eccentricity".into(), self.eccentricity.into());
            journal.insert("speed".into(), format!("{} rad/s", self.omega).into());
            let oil = table(scene, "oil");
            oil.insert("viscosity".into(), format!("{} Pa.s", self.mu0).into());
            match self.viscosity.as_str() {
                "constant" => drop(oil.remove("barus")),
                form => drop(table(oil, "barus").insert("form".into(), form.into())),
            }
            if let Some((model, pressure)) = self.cavitation.split_once(' ') {
                let pressure: f64 = pressure.parse().expect("cavitation pressure");
                let cavitation = table(scene, "cavitation");
                cavitation.insert("model".into(), model.into());
                cavitation.insert("pressure".into(), format!("{} Pa", pressure * SUPPLY_PRESSURE).into());
            }
        })
    }

    /// A number of the reference; none where the row does not give it.
    pub fn reference(&self, key: &str) -> Option<f64> {
        self.reference[key].as_f64()
    }

    /// What the row is, for messages.
    pub fn name(&self) -> String {
        format!(
            "{} {} {} eps {} mu0 {} omega {}",
            self.liner, self.viscosity, self.cavitation, self.eccentricity, self.mu0, self.omega
        )
    }
}

/// The Poiseuille part of the feed flow in units of `c^3 P_s/(12 mu0)`, as the reference gives it.
///
/// Our flow is what the feed delivers. The journal drags oil into the hole on one side and out on the
/// other; with `h` at the rim that is `Int (U/2) dh/dx dA` over the hole, here by its series.
pub fn poiseuille_feed_flux(solved: &Solved, hole_radius: f64, hole_angle: f64) -> f64 {
    let problem = &solved.study.problem;
    let (bearing, journal) = (&problem.bearing, &problem.journal);
    // Int_disc cos(x/R - a) dA = cos(phi_c - a) 2 pi R r J1(r/R), J1(t) = t/2 (1 - t^2/8 + t^4/192 - ...).
    let t = hole_radius / bearing.radius;
    let bessel = 0.5 * t * (1.0 - t * t / 8.0 + t.powi(4) / 192.0 - t.powi(6) / 9216.0);
    let disc = std::f64::consts::TAU * bearing.radius * hole_radius * bessel;
    // dh/dx = |e| sin(phi - phi_min) / R
    let slope = journal.eccentricity() / bearing.radius * (hole_angle - journal.min_film_angle()).sin();
    let dragged = 0.5 * journal.speed * bearing.radius * slope * disc;
    let delivered = solved.quantity("feed_flow.feed_hole");
    let unit = bearing.clearance.powi(3) * SUPPLY_PRESSURE / (12.0 * problem.lubricant.viscosity);
    (delivered - dragged) / unit
}

/// Scene 02 or 04 with another eccentricity, form and speed [rad/s].
pub fn barus_scene(liner: &str, eccentricity: f64, form: &str, speed: f64) -> Scene {
    let name = if liner == "ring" { "04_flexpde_ring" } else { "02_flexpde_shell" };
    variant(name, |scene| {
        let journal = table(scene, "journal");
        journal.insert("eccentricity".into(), eccentricity.into());
        journal.insert("speed".into(), format!("{speed} rad/s").into());
        table(table(scene, "oil"), "barus").insert("form".into(), form.into());
    })
}

/// The greatest speed [rad/s] with a conservative film, as a run at the too high speed `above` tells.
fn limit_of_existence(liner: &str, eccentricity: f64, above: f64) -> f64 {
    match solve(&barus_scene(liner, eccentricity, "conservative", above)) {
        Err(NoFilm::AboveLimit { greatest_speed: Some(speed), .. }) => speed,
        Err(reason) => panic!("{liner} {eccentricity}: {reason}"),
        Ok(_) => panic!("{liner} {eccentricity}: a film at {above} rad/s"),
    }
}

/// The last speed [rad/s] with an as-printed film, as a run at the too high speed `above` tells.
fn fold(liner: &str, eccentricity: f64, above: f64) -> f64 {
    match solve(&barus_scene(liner, eccentricity, "as-printed", above)) {
        Err(NoFilm::Fold { last, .. }) => last,
        Err(reason) => panic!("{liner} {eccentricity}: {reason}"),
        Ok(_) => panic!("{liner} {eccentricity}: a film at {above} rad/s"),
    }
}
