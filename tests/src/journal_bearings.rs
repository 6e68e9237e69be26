//! The rings of `tests/data/journal_bearings.json`: numbers of published and recomputed journal bearings.

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};

use oilwedge_scene::Scene;
use serde_json::Value;

use crate::program::repository;
use crate::scenes::{Solved, solve, table, variant};

/// Pressure `mu omega/psi^2` [Pa] of the ring of scene 09, which all rings here are variants of.
pub const PRESSURE_UNIT: f64 = 0.4 * 10.0 * 1e6;
const DIAMETER: f64 = 0.075;
const CLEARANCE: f64 = 37.5e-6;
const VISCOSITY: f64 = 0.4;

/// A block of the reference.
///
/// # Panics
/// If there is none of that name.
pub fn block(name: &str) -> Value {
    let path = repository().join("tests/data/journal_bearings.json");
    let text = std::fs::read_to_string(path).expect("reference of journal bearings");
    let data: Value = serde_json::from_str(&text).expect("reference is JSON");
    data.get(name).unwrap_or_else(|| panic!("no block {name}")).clone()
}

/// A list of a block: rows, misprints, ...
pub fn reference(block_name: &str, list: &str) -> Vec<Value> {
    block(block_name)[list].as_array().cloned().unwrap_or_default()
}

/// A number of a row.
///
/// # Panics
/// If the row has none of that name.
pub fn number(row: &Value, key: &str) -> f64 {
    row[key].as_f64().unwrap_or_else(|| panic!("no {key} in {row}"))
}

/// Checks all rows, side by side, and tells all that fail.
///
/// Threads of their own, as programs would be: a film that waits inside rayon would take up the next row on its stack.
///
/// # Panics
/// If one fails.
pub fn each<T: Sync>(rows: &[T], check: impl Fn(&T) -> Result<(), String> + Sync) {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut complaints = Vec::new();
        while let Some(row) = rows.get(next.fetch_add(1, Ordering::Relaxed)) {
            complaints.extend(check(row).err());
        }
        complaints
    };
    let threads = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let complaints: Vec<String> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        let told = workers.into_iter().map(|worker| worker.join().expect("a check panicked"));
        told.flatten().collect()
    });
    assert!(complaints.is_empty(), "{} of {}:\n{}", complaints.len(), rows.len(), complaints.join("\n"));
}

/// A plain ring that cavitates at the pressure of its ends; the widest film is at 0 degrees.
#[derive(Debug, Clone, Copy)]
pub struct Ring {
    /// B/D.
    pub slenderness: f64,
    /// Eccentricity eps; where it is negative and the journal moves radially, it moves towards the centre.
    pub eccentricity: f64,
    /// True if the line at the widest film is held at the pressure of the ends.
    pub film_start: bool,
    /// `G = alpha mu0 omega/psi^2`; 0 for constant viscosity.
    pub barus: f64,
    /// True for a journal that does not turn but moves radially, with `deps/dt` = 1/s.
    pub squeezed: bool,
    /// Model under `[cavitation]`.
    pub model: &'static str,
    /// Longest edges over the radius; none for the mesh that the program chooses.
    pub size: Option<f64>,
}

impl Ring {
    /// The ring with B/D and eps of a row: turning, periodic, constant viscosity, Swift-Stieber.
    pub fn of(row: &Value) -> Self {
        Self::new(number(row, "B_over_D"), number(row, "eps"))
    }

    /// The ring with B/D and eps: turning, periodic, constant viscosity, Swift-Stieber. The mesh leaves some 5e-5 of So
    /// and 0.003 degrees (halved sizes tell).
    pub fn new(slenderness: f64, eccentricity: f64) -> Self {
        Self {
            slenderness,
            eccentricity,
            film_start: false,
            barus: 0.0,
            squeezed: false,
            model: "reynolds",
            size: Some(0.1),
        }
    }

    /// The ring as a scene.
    pub fn scene(&self) -> Scene {
        variant("09_drawn_ring", |scene| {
            let bearing = table(scene, "bearing");
            bearing.insert("length".into(), format!("{} m", self.slenderness * DIAMETER).into());
            if self.film_start {
                bearing.insert("film_start".into(), "0 deg".into());
            }
            if let Some(size) = self.size {
                let size = format!("{} m", 0.5 * size * DIAMETER);
                table(scene, "mesh").insert("size".into(), size.into());
            }
            let journal = table(scene, "journal");
            journal.insert("eccentricity".into(), self.eccentricity.abs().into());
            if self.squeezed {
                journal.insert("speed".into(), "0 rad/s".into());
                let velocity = CLEARANCE * if self.eccentricity < 0.0 { -1.0 } else { 1.0 };
                table(journal, "squeeze").insert("radial".into(), format!("{velocity} m/s").into());
            }
            if self.barus > 0.0 {
                let alpha = format!("{} 1/Pa", self.barus / PRESSURE_UNIT);
                table(table(scene, "oil"), "barus").insert("alpha".into(), alpha.into());
            }
            table(scene, "cavitation").insert("model".into(), self.model.into());
        })
    }

    /// The ring, solved.
    ///
    /// # Panics
    /// If it has no film.
    pub fn solve(&self) -> SolvedRing {
        let solved = solve(&self.scene()).unwrap_or_else(|reason| panic!("{self:?}: {reason}"));
        SolvedRing { ring: *self, solved }
    }
}

/// A ring and its film.
pub struct SolvedRing {
    /// The ring.
    pub ring: Ring,
    /// Film of the ring.
    pub solved: Solved,
}

impl SolvedRing {
    /// `F psi^2/(B D mu omega)`; of a journal that moves radially `F psi^2/(B D mu |deps/dt|)`.
    pub fn sommerfeld_number(&self) -> f64 {
        if !self.ring.squeezed {
            return self.solved.quantity("sommerfeld_number");
        }
        let psi = 2.0 * CLEARANCE / DIAMETER;
        let area = self.ring.slenderness * DIAMETER * DIAMETER;
        self.solved.quantity("load") * psi * psi / (area * VISCOSITY)
    }

    /// Attitude angle [deg].
    pub fn attitude(&self) -> f64 {
        self.solved.quantity("attitude_angle")
    }

    /// `(R/c) f`.
    pub fn friction(&self) -> f64 {
        self.solved.quantity("friction_coefficient") * 0.5 * DIAMETER / CLEARANCE
    }

    /// Flow into the loaded film and out of the ends, over `R c N B`.
    pub fn flows(&self) -> [f64; 2] {
        let speed = self.solved.study.problem.journal.speed.abs() / std::f64::consts::TAU;
        let unit = 0.5 * DIAMETER * CLEARANCE * speed * self.ring.slenderness * DIAMETER;
        ["inlet_flow", "side_flow"].map(|name| self.solved.quantity(name) / unit)
    }

    /// Greatest reduced pressure over [`PRESSURE_UNIT`]; that of a given greatest pressure as second.
    fn reduced_pressures(&self, p_max: f64) -> [f64; 2] {
        let law = &self.solved.study.problem.lubricant.pressure_law;
        [self.solved.quantity("pressure_max"), p_max * PRESSURE_UNIT].map(|p| law.reduced_pressure(p) / PRESSURE_UNIT)
    }

    /// Compares So (relative), attitude (degrees) and greatest reduced pressure (relative) with those of a row.
    ///
    /// # Errors
    /// What is off.
    pub fn compare(&self, row: &Value, of_so: f64, of_attitude: f64, of_p_max: f64) -> Result<(), String> {
        let [q, expected_q] = self.reduced_pressures(number(row, "P_max"));
        self.off("So", self.sommerfeld_number(), number(row, "So"), of_so * number(row, "So"))?;
        self.off("attitude", self.attitude(), number(row, "attitude_deg"), of_attitude)?;
        self.off("greatest pressure", q, expected_q, of_p_max * expected_q)
    }

    /// Compares two numbers.
    ///
    /// # Errors
    /// They differ by more than `tolerance`.
    pub fn off(&self, what: &str, value: f64, expected: f64, tolerance: f64) -> Result<(), String> {
        let Ring { slenderness, eccentricity, .. } = self.ring;
        if (value - expected).abs() < tolerance {
            return Ok(());
        }
        let error = 100.0 * (value / expected - 1.0);
        Err(format!("B/D {slenderness} eps {eccentricity}: {what} {value:.5} is {error:.2} % off {expected}"))
    }
}
