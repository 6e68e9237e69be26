//! `[orbit]`: the path of the journal under a load over a cycle.

use crate::reader::TableReader;
use crate::{Complaints, Scene, Turbulence};

/// Local error of a step where a scene gives none.
const TOLERANCE: f64 = 1e-3;
/// Most cycles where a scene gives no number.
const CYCLES: u32 = 10;
/// Closure over the tolerance where a scene gives none.
const CLOSURE: f64 = 0.1;

keys! {
    "orbit" = Table; "", "one position, in which the load stays", "",
        "the path of the journal under the load over a cycle is followed until it repeats";
    "orbit.tolerance" = Number; "1e-3", "1e-3", "1e-10 to 0.1",
        "error that each step in time may make: offset of the journal over the least film";
    "orbit.cycles" = Number; "10", "10", "whole, 1 to 1000",
        "most cycles that are followed";
    "orbit.closure" = Number; "1e-4", "a tenth of the tolerance", "1e-12 to 0.1",
        "an orbit is closed where a cycle ends this near to where it began, over the clearance, and with `jfo` so does its oil";
    "orbit.mass" = Quantity(Mass); "20 kg", "0", ">= 0",
        "mass of the rotor that the bearing bears; without it the film carries the load at every moment";
    "orbit.start" = Table; "", "near the orbit, by one on a coarser mesh", "",
        "where the journal is at the beginning";
    "orbit.start.eccentricity" = Number; "0.3", "required", "0 <= eps < 1",
        "its eccentricity";
    "orbit.start.angle" = Quantity(Angle); "0 deg", "required", "",
        "the angle of its offset";
}

/// How the orbit of a journal is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrbitTable {
    /// Local error of a step: offset over the least film [1].
    pub tolerance: f64,
    /// Most cycles.
    pub cycles: usize,
    /// Distance between the beginning and the end of a cycle that is closed, over the clearance [1].
    pub closure: f64,
    /// Mass of the rotor [kg].
    pub mass: f64,
    /// Eccentricity ratio [1] and angle [rad] at the beginning; `None`: those of an orbit on a coarser mesh.
    pub start: Option<[f64; 2]>,
}

impl OrbitTable {
    /// The one of an empty table.
    pub fn usual() -> Self {
        Self { tolerance: TOLERANCE, cycles: CYCLES as usize, closure: CLOSURE * TOLERANCE, mass: 0.0, start: None }
    }
}

pub(crate) fn read(mut table: TableReader<'_>) -> OrbitTable {
    let tolerance = (table.number("tolerance"))
        .within("is not between 1e-10 and 0.1", "give 1e-3, or less for a sharper orbit")
        .or(TOLERANCE);
    let cycles = (table.number("cycles"))
        .within("is no whole number from 1 to 1000", "give the greatest number of cycles, such as 10")
        .or(f64::from(CYCLES));
    let closure =
        (table.number("closure")).within("is not between 1e-12 and 0.1", "give 1e-4, or less").or(CLOSURE * tolerance);
    let mass = (table.number("mass")).within("is negative", "give mass >= 0").or_usual();
    OrbitTable {
        tolerance,
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked above; NaN becomes 0")]
        cycles: cycles as usize,
        closure,
        mass,
        start: (table.table_if_given("start")).map(|mut start| {
            let eccentricity = (start.number("eccentricity"))
                .within("is not in 0 <= eps < 1", "give a journal inside the bearing")
                .required();
            [eccentricity, start.required("angle")]
        }),
    }
}

/// An orbit needs a load and a clock.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    if scene.orbit.is_none() {
        return;
    }
    complaints.refuse_if(
        !scene.is_loaded(),
        "orbit",
        "stands without [load], but the orbit is that of a journal under a load",
        "give [load], by force and angle or over a cycle by file, harmonics or bearing",
    );
    complaints.refuse_if(
        scene.load_cycle.is_none() && scene.journal.speed == 0.0,
        "journal.speed",
        "is zero, and a load that does not change has no period: nothing says how long the cycle of [orbit] is",
        "give a speed; or the load over a time, by harmonics = [{ order = 0, cos = { x = \"5 kN\" } }] and frequency = \"50 Hz\"",
    );
    complaints.refuse_if(
        complaints.has("mesh.tolerance"),
        "mesh.tolerance",
        "stands beside [orbit], whose mesh is not refined",
        "remove mesh.tolerance, and give [mesh] size",
    );
    complaints.refuse_if(
        scene.turbulence == Some(Turbulence::Reichardt),
        "turbulence.model",
        "finds eddies for a gap that stands still, but the journal follows an orbit",
        "write model = \"ng-pan\" and remove heat.field, or remove [orbit]",
    );
}
