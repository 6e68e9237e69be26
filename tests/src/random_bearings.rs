//! Random bearings with supplies anywhere, the same on every run.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use oilwedge_scene::Scene;

use crate::scenes::written;

/// Radius [m], radial clearance [m], viscosity [Pa s] and speed [rad/s] of all of them.
const RADIUS: f64 = 0.05;
const CLEARANCE: f64 = 1e-4;
const VISCOSITY: f64 = 0.02;
const SPEED: f64 = 200.0;
/// `mu omega/psi^2` [Pa].
pub const PRESSURE_UNIT: f64 = VISCOSITY * SPEED * (RADIUS / CLEARANCE) * (RADIUS / CLEARANCE);

/// Least land [m] between features, and from them to edges of the liner.
const LAND: f64 = 0.06 * RADIUS;

/// A sequence of numbers without order (PCG of 64 bits, XSH-RR; O'Neill, HMC-CS-2014-0905).
#[derive(Debug, Clone)]
pub struct Dice(u64);

impl Dice {
    /// The sequence number `seed`.
    pub fn new(seed: u64) -> Self {
        let mut dice = Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x853c_49e6_748f_ea9b);
        dice.next();
        dice
    }

    fn next(&mut self) -> u32 {
        let old = self.0;
        self.0 = old.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let shifted = (((old >> 18) ^ old) >> 27) as u32;
        shifted.rotate_right((old >> 59) as u32)
    }

    /// A random number between two.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(self.next()) / f64::from(u32::MAX)
    }

    /// True so often.
    pub fn chance(&mut self, share: f64) -> bool {
        self.between(0.0, 1.0) < share
    }

    /// Ten to the power of a number between two.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(self.between(low, high))
    }
}

/// A hole or groove.
#[derive(Debug, Clone, Copy)]
struct Opening {
    /// Angle of its middle [rad].
    angle: f64,
    /// Axial position of its middle [m].
    z: f64,
    /// Half its angle [rad]; infinite all around.
    half_angle: f64,
    /// Half its axial width [m].
    half_width: f64,
    round: bool,
    /// Pressure above that of the cavity [Pa], or the depth [m] of a pocket.
    given: Given,
}

#[derive(Debug, Clone, Copy)]
enum Given {
    Pressure(f64),
    Depth(f64),
}

/// A bearing by chance.
#[derive(Debug, Clone)]
pub struct RandomBearing {
    /// Number of the bearing.
    pub number: u64,
    /// The scene, with the model `jfo`.
    pub text: String,
}

impl RandomBearing {
    /// The bearing of that number.
    pub fn new(number: u64) -> Self {
        let mut dice = Dice::new(number);
        let length = 2.0 * RADIUS * dice.decades(0.2f64.log10(), 2f64.log10());
        let eccentricity = match dice.chance(0.3) {
            true => 1.0 - dice.decades(0.02f64.log10(), 0.2f64.log10()),
            false => dice.between(0.05, 0.95),
        };
        let arc = dice.chance(0.15).then(|| {
            let from = dice.between(-PI, PI);
            [from, from + dice.between(2.0, 5.0)]
        });
        let openings = openings(&mut dice, length, arc);
        let cavity = if dice.chance(0.5) { 0.0 } else { -0.7e5 };
        let ends = cavity + if dice.chance(0.5) { 0.0 } else { PRESSURE_UNIT * dice.decades(-3.0, -0.5) };
        let area = length * RADIUS * arc.map_or(TAU, |[from, to]| to - from);
        // Two nodes a triangle of area 0.433 size^2.
        let nodes = dice.decades(60f64.log10(), 800f64.log10());
        let size = (2.0 * area / (0.433 * nodes)).sqrt();
        let start = if arc.is_none() && dice.chance(0.25) { free_angle(&mut dice, &openings) } else { None };
        let speed = if dice.chance(0.5) { SPEED } else { -SPEED };
        let minimum = dice.between(-PI, PI);
        let mut text = format!("title = \"Bearing {number}\"\n[bearing]\n");
        let _ =
            writeln!(text, "diameter = \"{} m\"\nlength = \"{length} m\"\nclearance = \"{CLEARANCE} m\"", 2.0 * RADIUS);
        if let Some([from, to]) = arc {
            let _ = writeln!(text, "arc = {{ from = \"{from} rad\", to = \"{to} rad\" }}");
        }
        if let Some(angle) = start {
            let _ = writeln!(text, "film_start = \"{angle} rad\"");
        }
        let _ = writeln!(text, "[mesh]\nsize = \"{size} m\"\n[ends]\npressure = \"{ends} Pa\"");
        let _ = writeln!(
            text,
            "[journal]\nspeed = \"{speed} rad/s\"\neccentricity = {eccentricity}\nmin_film_angle = \"{minimum} rad\""
        );
        let _ = writeln!(
            text,
            "[cavitation]\nmodel = \"jfo\"\npressure = \"{cavity} Pa\"\n[oil]\nviscosity = \"{VISCOSITY} Pa.s\""
        );
        if dice.chance(0.2) {
            // The reduced pressure stays below the limit 1/alpha.
            let greatest = PRESSURE_UNIT * (4.0 + 8.0 * (1.0 - eccentricity).powi(-2));
            let _ = writeln!(text, "barus = {{ alpha = \"{} 1/Pa\" }}", dice.between(0.05, 0.5) / greatest);
        }
        for (index, opening) in openings.iter().enumerate() {
            opening.write(&mut text, index, cavity.max(ends));
        }
        Self { number, text }
    }

    /// The scene.
    pub fn scene(&self) -> Scene {
        written(&self.text)
    }
}

/// One or two supplies, and sometimes a pocket.
fn openings(dice: &mut Dice, length: f64, arc: Option<[f64; 2]>) -> Vec<Opening> {
    let count = if dice.chance(0.6) { 1 } else { 2 };
    let pocket = dice.chance(0.1);
    let mut found: Vec<Opening> = Vec::new();
    for k in 0..count + usize::from(pocket) {
        for _ in 0..40 {
            let opening = opening(dice, length, arc, k == count);
            if found.iter().all(|other| opening.is_apart(other)) {
                found.push(opening);
                break;
            }
        }
    }
    found
}

fn opening(dice: &mut Dice, length: f64, arc: Option<[f64; 2]>, pocket: bool) -> Opening {
    let half_length = 0.5 * length;
    let round = dice.chance(0.35);
    let mut half_angle = 0.5 * dice.between(0.1, 0.6);
    let mut half_width = dice.between(0.2, 0.9) * (half_length - LAND);
    if round {
        half_width = (half_angle * RADIUS).min(0.7 * half_length);
        half_angle = half_width / RADIUS;
    } else if arc.is_none() && !pocket && dice.chance(0.12) {
        half_angle = f64::INFINITY;
        half_width = dice.between(0.05, 0.4) * half_length;
    }
    let play = half_length - half_width - LAND;
    let z = if dice.chance(0.5) { 0.0 } else { dice.between(-play, play) };
    let margin = half_angle + LAND / RADIUS;
    let angle = match arc {
        Some([from, to]) => dice.between(from + margin, to - margin),
        None => dice.between(-PI, PI),
    };
    let given = match pocket {
        true => Given::Depth(CLEARANCE * dice.decades(-1.0, 1.0)),
        false => Given::Pressure(PRESSURE_UNIT * dice.decades(-3.0, 0.5)),
    };
    Opening { angle, z, half_angle, half_width, round, given }
}

/// An angle [rad] where no opening is near.
fn free_angle(dice: &mut Dice, openings: &[Opening]) -> Option<f64> {
    (0..20).map(|_| dice.between(-PI, PI)).find(|angle| {
        let apart = |opening: &Opening| {
            !opening.half_angle.is_finite() || around(opening.angle, *angle) > opening.half_angle + 2.0 * LAND / RADIUS
        };
        openings.iter().all(apart)
    })
}

/// Angle [rad] between two, the shorter way around.
fn around(a: f64, b: f64) -> f64 {
    let apart = (a - b).rem_euclid(TAU);
    apart.min(TAU - apart)
}

impl Opening {
    fn is_apart(&self, other: &Self) -> bool {
        let along = around(self.angle, other.angle) - self.half_angle - other.half_angle;
        let across = (self.z - other.z).abs() - self.half_width - other.half_width;
        along > 2.0 * LAND / RADIUS || across > 2.0 * LAND
    }

    fn write(&self, text: &mut String, index: usize, ambient: f64) {
        let Self { angle, z, half_angle, half_width, .. } = self;
        let _ = writeln!(text, "[[feed]]\ngroup = \"opening_{index}\"");
        let _ = match (self.round, half_angle.is_finite()) {
            (true, _) => writeln!(
                text,
                "hole = {{ diameter = \"{} m\", angle = \"{angle} rad\", z = \"{z} m\" }}",
                2.0 * half_width
            ),
            (false, false) => writeln!(text, "groove = {{ width = \"{} m\", z = \"{z} m\" }}", 2.0 * half_width),
            (false, true) => writeln!(
                text,
                "groove = {{ from = \"{} rad\", to = \"{} rad\", width = \"{} m\", z = \"{z} m\" }}",
                angle - half_angle,
                angle + half_angle,
                2.0 * half_width
            ),
        };
        let _ = match self.given {
            Given::Pressure(above) => writeln!(text, "pressure = \"{} Pa\"", ambient + above),
            Given::Depth(depth) => writeln!(text, "depth = \"{depth} m\""),
        };
    }
}
