//! Random bearings with temperatures across their films: any eccentricity, speed and direction of the load, with holes
//! and grooves, some of them nearly dry; the same on every run.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use oilwedge_scene::Scene;
use oilwedge_study::picture::{FieldChoice, PictureOptions};
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::random_bearings::Dice;
use oilwedge_tests::scenes::written;

/// Heat capacity [J/(m3 K)] and conductivity [W/(m K)] of the oil of all of them.
const CAPACITY: f64 = 1.8e6;
const CONDUCTIVITY: f64 = 0.13;
/// Fastest surface of a journal [m/s]: beyond, films are turbulent.
const FASTEST: f64 = 60.0;
/// Edges of triangles over the circumference.
const EDGE: f64 = 1.0 / 60.0;
/// The coldest oil may be colder than all that cools it by so much [K]: polynomials across a film overshoot.
const OVERSHOOT: f64 = 1.0;
/// Part of its power by which the heat of a film may be off.
const CLOSED: f64 = 1e-9;

/// A bearing by chance.
#[derive(Debug, Clone)]
pub struct ThermalBearing {
    /// Number of the bearing.
    pub number: u64,
    /// The scene.
    pub text: String,
    /// Temperature [degrees C] below which nothing is cooled: that of the oil fed, or around the bush.
    pub coldest: f64,
}

/// What a bearing became.
#[derive(Debug, Clone)]
pub struct ThermalOutcome {
    /// The numbers.
    pub result: RunResult,
    /// Least and greatest temperature of the film [degrees C]; none where there is no film.
    pub range: Option<[f64; 2]>,
    /// What is wrong with it.
    pub fault: Option<String>,
}

impl ThermalBearing {
    /// The bearing of that number: every second one at a position, the others under a load.
    pub fn new(number: u64) -> Self {
        let mut dice = Dice::new(31_000_000 + number);
        let radius = 0.5 * dice.decades(-1.5, -0.6);
        let length = 2.0 * radius * dice.between(0.3, 1.0);
        let clearance = radius * dice.decades(-3.1, -2.6);
        let speed = dice.decades(300f64.log10(), 4.0).min(FASTEST / radius * 60.0 / TAU);
        let omega = speed * TAU / 60.0;
        let (inlet, warm) = (dice.between(30.0, 90.0), dice.between(0.0, 20.0));
        let (viscosity, beta) = (dice.decades(-2.4, -1.5), dice.between(0.02, 0.04));
        let towards = dice.between(-PI, PI);
        let mut text = format!(
            "title = \"Thermal bearing {number}\"\n[bearing]\ndiameter = \"{} m\"\nlength = \"{length} m\"\nclearance = \"{clearance} m\"\n[mesh]\nsize = \"{} m\"\n",
            2.0 * radius,
            TAU * radius * EDGE
        );
        let _ = writeln!(
            text,
            "[oil]\nexponential = {{ viscosity = \"{viscosity} Pa.s\", at = \"{} C\", beta = \"{beta} 1/K\" }}\nconductivity = \"{CONDUCTIVITY} W/(m.K)\"\n[cavitation]\nmodel = \"jfo\"\n[journal]\nspeed = \"{speed} rpm\"",
            inlet + warm
        );
        let pressure_unit = viscosity * omega * (radius / clearance).powi(2);
        let eccentricity = dice.between(0.05, 0.96);
        let _ = match number % 2 {
            0 => writeln!(text, "eccentricity = {eccentricity}\nmin_film_angle = \"{towards} rad\""),
            _ => {
                let size = 2.0 * radius * length * (length / radius).powi(2).min(1.0);
                let force = 0.35 * pressure_unit * size * eccentricity / (1.0 - eccentricity);
                writeln!(text, "[load]\nforce = \"{force} N\"\nangle = \"{towards} rad\"")
            }
        };
        feeds(&mut text, &mut dice, [radius, length]);
        let ambient = inlet + dice.between(-20.0, 10.0);
        heat(&mut text, &mut dice, (inlet, ambient), radius);
        Self { number, text, coldest: inlet.min(ambient) }
    }

    /// The scene.
    pub fn scene(&self) -> Scene {
        written(&self.text)
    }

    /// The bearing with edges of half the length, and eight layers.
    pub fn finer(&self) -> Self {
        let size = self.text.split("size = \"").nth(1).and_then(|rest| rest.split(' ').next());
        let size: f64 = size.and_then(|size| size.parse().ok()).expect("a size");
        let text = self.text.replace(&format!("size = \"{size} m\""), &format!("size = \"{} m\"", 0.5 * size));
        Self { text: text.replace("field = true", "field = true\nlayers = 8"), ..self.clone() }
    }

    /// Solves the bearing, and judges its heat.
    ///
    /// # Panics
    /// If the scene cannot be compiled.
    pub fn solved(&self, bars: bool) -> ThermalOutcome {
        let scene = self.scene();
        let picture = PictureOptions { fields: FieldChoice::All, ..PictureOptions::default() };
        let options = RunOptions { bars, picture, ..RunOptions::of(&scene) };
        let found = run(&scene, &options).unwrap_or_else(|error| panic!("{error}\n{}", self.text));
        let layers = found.picture.as_ref().and_then(|picture| picture.at_points("temperature_layers [degC]"));
        let range = layers.map(|layers| {
            let numbers = layers.numbers().iter().copied();
            numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], t| [a.min(t), b.max(t)])
        });
        let result = found.result;
        let fault = match (result.head.status, range) {
            (Status::Converged, _) if result.balances.thermal.abs() > CLOSED => {
                Some(format!("{:e} of its heat left", result.balances.thermal))
            }
            (Status::Converged, Some([least, _])) if least < self.coldest - OVERSHOOT => {
                Some(format!("{least:.1} C, below {:.1} C", self.coldest))
            }
            (Status::NotConverged, _) => Some(result.head.reason.clone().unwrap_or_default()),
            _ => None,
        };
        ThermalOutcome { result, range, fault }
    }
}

/// One to three holes or grooves in sectors of their own; one in four is nearly dry.
fn feeds(text: &mut String, dice: &mut Dice, [radius, length]: [f64; 2]) {
    let count = dice.between(1.0, 3.999) as usize;
    let start = dice.between(-PI, PI);
    for k in 0..count {
        let sector = TAU / count as f64;
        let middle = start + sector * (k as f64 + dice.between(-0.1, 0.1));
        let half_angle = dice.between(0.06, 0.25);
        let z = if dice.chance(0.5) { 0.0 } else { dice.between(-0.1, 0.1) * length };
        let place = match dice.chance(0.4) {
            true => {
                let diameter = f64::min(2.0 * half_angle * radius, 0.5 * length);
                format!("hole = {{ diameter = \"{diameter} m\", angle = \"{middle} rad\", z = \"{z} m\" }}")
            }
            false => format!(
                "groove = {{ from = \"{} rad\", to = \"{} rad\", width = \"{} m\", z = \"{z} m\" }}",
                middle - half_angle,
                middle + half_angle,
                dice.between(0.2, 0.7) * length
            ),
        };
        let pressure = if dice.chance(0.25) { dice.decades(2.0, 3.7) } else { dice.decades(4.3, 5.7) };
        let _ = writeln!(text, "[[feed]]\ngroup = \"feed_{k}\"\n{place}\npressure = \"{pressure} Pa\"");
    }
}

/// The table of heat, with a bush in two of three bearings, and a shaft that takes heat in one of three.
fn heat(text: &mut String, dice: &mut Dice, (inlet, ambient): (f64, f64), radius: f64) {
    let _ = writeln!(text, "[heat]\ninlet = \"{inlet} C\"\nheat_capacity = \"{CAPACITY} J/(m3.K)\"\nfield = true");
    if dice.chance(0.67) {
        let _ = writeln!(
            text,
            "bush = {{ outer_diameter = \"{} m\", conductivity = \"{} W/(m.K)\", transfer = \"{} W/(m2.K)\", ambient = \"{ambient} C\" }}",
            2.0 * radius * dice.between(1.2, 2.2),
            dice.decades(1.5, 2.4),
            dice.decades(1.0, 3.3)
        );
    }
    if dice.chance(0.33) {
        let conductance = dice.decades(-0.5, 1.0);
        let _ = writeln!(text, "journal = {{ conductance = \"{conductance} W/K\", ambient = \"{ambient} C\" }}");
    }
}
