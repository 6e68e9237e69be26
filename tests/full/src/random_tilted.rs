//! Random bearings whose journal tilts: under loads off the middle, moments and supports, or at given tilts, with every
//! model of cavitation, with holes and grooves; the same on every run.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use std::path::Path;

use oilwedge_bearing::Clock;
use oilwedge_scene::Scene;

use crate::coverage::bearings::{Bearing, Family};
use crate::performance::clock::processor_seconds;
use oilwedge_tests::random_bearings::Dice;

/// Radius [m], radial clearance [m], viscosity [Pa s] and speed [rad/s] of all of them.
const RADIUS: f64 = 0.05;
const CLEARANCE: f64 = 5e-5;
const VISCOSITY: f64 = 0.02;
const SPEED: f64 = 100.0;
/// `mu omega/psi^2` [Pa].
const PRESSURE_UNIT: f64 = VISCOSITY * SPEED * (RADIUS / CLEARANCE) * (RADIUS / CLEARANCE);

/// What tilts a journal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tilting {
    /// Position and tilt are given.
    Given,
    /// The tilt is given, the position found.
    Held,
    /// The journal is parallel to the bearing, its position found.
    Parallel,
    /// A load off the middle, or a moment, tilts it.
    Free,
    /// The journal tilts against a support.
    Supported,
}

/// A bearing by chance.
#[derive(Debug, Clone)]
pub struct TiltedBearing {
    /// Number of the bearing.
    pub number: u64,
    /// What tilts its journal.
    pub tilting: Tilting,
    /// Model of cavitation.
    pub model: &'static str,
    /// The scene.
    pub text: String,
}

impl TiltedBearing {
    /// The bearing of that number.
    pub fn new(number: u64) -> Self {
        let mut dice = Dice::new(7_000_000 + number);
        Self::drawn(number, &mut dice, |dice| {
            [Tilting::Given, Tilting::Held, Tilting::Free, Tilting::Free, Tilting::Supported]
                [(dice.between(0.0, 4.999)) as usize]
        })
    }

    /// The bearing of that number whose journal is parallel to it under a load.
    pub fn under_load(number: u64) -> Self {
        Self::drawn(number, &mut Dice::new(21_000_000 + number), |_| Tilting::Parallel)
    }

    fn drawn(number: u64, dice: &mut Dice, tilting: impl Fn(&mut Dice) -> Tilting) -> Self {
        let length = 2.0 * RADIUS * dice.decades(0.25f64.log10(), 1.2f64.log10());
        let model = ["none", "guembel", "reynolds", "reynolds", "jfo"][(dice.between(0.0, 4.999)) as usize];
        let tilting = tilting(dice);
        let minimum = dice.between(-PI, PI);
        let speed = if dice.chance(0.5) { SPEED } else { -SPEED };
        let mut text = format!(
            "title = \"Tilted bearing {number}\"\n[bearing]\ndiameter = \"{} m\"\nlength = \"{length} m\"\nclearance = \"{CLEARANCE} m\"\n",
            2.0 * RADIUS
        );
        if dice.chance(0.2) {
            let _ = writeln!(text, "film_start = \"{} rad\"", minimum + PI);
        }
        let _ = writeln!(
            text,
            "[oil]\nviscosity = \"{VISCOSITY} Pa.s\"\n[cavitation]\nmodel = \"{model}\"\n[journal]\nspeed = \"{speed} rad/s\""
        );
        journal(&mut text, dice, tilting, length, minimum);
        feeds(&mut text, dice, length, minimum);
        if model == "jfo" && !text.contains("[[feed]]") && !text.contains("film_start") {
            // Something must supply a film that conserves its oil.
            let _ = writeln!(text, "[ends]\npressure = \"{} Pa\"", 1e-3 * PRESSURE_UNIT);
        }
        Self { number, tilting, model, text }
    }

    /// The bearing of that number with rough surfaces that touch, in a wall that gives way, or a bore out of round.
    pub fn with_walls(number: u64) -> Self {
        let bearing = Self::new(number);
        let mut dice = Dice::new(9_000_000 + number);
        let walls = crate::random_walls::tables(&mut dice, PRESSURE_UNIT, CLEARANCE);
        let clearance = format!("clearance = \"{CLEARANCE} m\"\n");
        let rough = format!("{clearance}roughness = \"{} m\"\n", walls.roughness);
        Self { text: bearing.text.replacen(&clearance, &rough, 1) + &walls.tables, ..bearing }
    }

    /// The scene.
    ///
    /// # Panics
    /// If the text is none.
    pub fn scene(&self) -> Scene {
        let name = format!("tilted_{}.toml", self.number);
        oilwedge_study::parse(&self.text, Path::new(&name)).unwrap_or_else(|error| panic!("{error}\n{}", self.text))
    }
}

/// The keys of `[journal]` after the speed, and the tables of the load.
fn journal(text: &mut String, dice: &mut Dice, tilting: Tilting, length: f64, minimum: f64) {
    let half = 0.5 * length;
    // A slope that takes this part of the room at an end.
    let slope = |dice: &mut Dice, room: f64| {
        let (size, angle) = (dice.between(0.05, 0.98) * room * CLEARANCE / half, dice.between(-PI, PI));
        format!("{{ x = \"{} rad\", y = \"{} rad\" }}", size * angle.cos(), size * angle.sin())
    };
    if tilting == Tilting::Given {
        let eccentricity = dice.between(0.0, 0.95);
        let tilt = slope(dice, 1.0 - eccentricity);
        let _ = writeln!(text, "eccentricity = {eccentricity}\nmin_film_angle = \"{minimum} rad\"\ntilt = {tilt}");
        return;
    }
    if tilting == Tilting::Held {
        let tilt = slope(dice, 0.8);
        let _ = writeln!(text, "tilt = {tilt}");
    }
    let force = dice.decades(-0.8, 0.5) * PRESSURE_UNIT * 2.0 * RADIUS * length * (length / RADIUS).min(1.0);
    let _ = writeln!(text, "[load]\nforce = \"{force} N\"\nangle = \"{minimum} rad\"");
    if matches!(tilting, Tilting::Free | Tilting::Supported) {
        if dice.chance(0.7) {
            let _ = writeln!(text, "at = \"{} m\"", dice.between(-0.45, 0.45) * half);
        }
        let (arm, angle) = (dice.between(0.0, 0.25) * half, dice.between(-PI, PI));
        let [x, y] = [angle.cos(), angle.sin()].map(|part| force * arm * part);
        let _ = writeln!(text, "moment = {{ x = \"{x} N.m\", y = \"{y} N.m\" }}");
    }
    if tilting == Tilting::Supported {
        let stiffness = force * half * half / CLEARANCE * dice.decades(-2.0, 1.0);
        let tilt = slope(dice, 0.9);
        let _ = writeln!(text, "[support]\ntilt_stiffness = \"{stiffness} N.m/rad\"\ntilt = {tilt}");
    }
}

/// None to two holes or grooves in sectors of their own, away from the film start.
fn feeds(text: &mut String, dice: &mut Dice, length: f64, minimum: f64) {
    let count = dice.between(0.0, 2.999) as usize;
    for k in 0..count {
        let sector = TAU / count as f64;
        let middle = minimum + PI + sector * (k as f64 + 0.5) + dice.between(-0.2, 0.2) * sector;
        let half_angle = dice.between(0.05, 0.3);
        let _ = writeln!(text, "[[feed]]\ngroup = \"feed_{k}\"");
        let shift = if dice.chance(0.5) { 0.0 } else { dice.between(-0.15, 0.15) * length };
        let _ = match dice.chance(0.5) {
            true => {
                let diameter = f64::min(2.0 * half_angle * RADIUS, 0.5 * length);
                writeln!(text, "hole = {{ diameter = \"{diameter} m\", angle = \"{middle} rad\", z = \"{shift} m\" }}")
            }
            false => {
                let width = dice.between(0.1, 0.6) * length;
                let (from, to) = (middle - half_angle, middle + half_angle);
                writeln!(
                    text,
                    "groove = {{ from = \"{from} rad\", to = \"{to} rad\", width = \"{width} m\", z = \"{shift} m\" }}"
                )
            }
        };
        let _ = writeln!(text, "pressure = \"{} Pa\"", PRESSURE_UNIT * dice.decades(-3.0, -0.5));
    }
}

impl TiltedBearing {
    /// The bearing as one of those whose bars are counted.
    ///
    /// # Panics
    /// If the text is no TOML.
    pub fn counted(&self) -> Bearing {
        Bearing {
            name: format!("tilted {}", self.number),
            family: match (self.model, self.tilting) {
                ("jfo", _) => Family::Conserving,
                (_, Tilting::Given) => Family::Ring,
                _ => Family::Loaded,
            },
            model: self.model,
            table: self.text.parse().expect("TOML"),
        }
    }
}

/// What a run may not do.
#[derive(Debug, Clone)]
pub struct Fault {
    /// The bearing.
    pub number: u64,
    /// What it is.
    pub what: String,
}

/// The greatest residual of the balances of force and moment of a run that has converged.
const BALANCED: f64 = 1e-10;

/// What is left of the balances of force, moment and deflection, the greatest one.
pub fn left(result: &oilwedge_study::result::RunResult) -> f64 {
    let balances = &result.balances;
    balances.force.max(balances.tilt).max(balances.deflection.unwrap_or_default())
}

/// Solves a bearing with the usual options, its limit of time one of processor time; how it ended, and what is wrong
/// with it.
///
/// # Panics
/// If the scene cannot be compiled.
pub fn solved(bearing: &TiltedBearing) -> (oilwedge_study::result::RunResult, Option<Fault>) {
    let scene = bearing.scene();
    let options = oilwedge_study::RunOptions {
        clock: Clock::Showing(processor_seconds),
        ..oilwedge_study::RunOptions::of(&scene)
    };
    let run = oilwedge_study::run(&scene, &options).unwrap_or_else(|error| panic!("{error}\n{}", bearing.text));
    let result = run.result;
    use oilwedge_study::result::Status;
    let fault = match result.head.status {
        Status::Converged => (left(&result) > BALANCED).then(|| format!("balances: {:e} left", left(&result))),
        Status::NoSolution => None,
        Status::NotConverged => Some(result.head.reason.clone().unwrap_or_default()),
    };
    let number = bearing.number;
    (result, fault.map(|what| Fault { number, what }))
}
