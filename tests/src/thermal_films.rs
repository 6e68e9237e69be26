//! Thermal films of two independent codes: structured finite volumes with JFO, temperatures across the film, one of the
//! journal, and a bush that conducts heat; the second one has cells across the film and a bush in three dimensions.

use oilwedge_scene::Scene;
use oilwedge_study::result::RunResult;
use oilwedge_study::{RunOptions, run};

use crate::scenes::written;

/// A bearing like that of Ferron, Frene and Boncompain (1983): one axial groove, bronze around it.
pub const FERRON: &str = r#"
[bearing]
diameter = "100 mm"
length = "80 mm"
clearance = "145 um"
[mesh]
size = "6 mm"
[[feed]]
group = "groove"
pressure = "0.7 bar"
groove = { from = "81 deg", to = "99 deg", width = "70 mm" }
[journal]
speed = "4000 rpm"
[load]
force = "6 kN"
angle = "270 deg"
[oil]
exponential = { viscosity = "27.7 mPa.s", at = "40 C", beta = "0.034 1/K" }
conductivity = "0.13 W/(m.K)"
[cavitation]
model = "jfo"
[heat]
inlet = "40 C"
heat_capacity = "1.72 MJ/(m3.K)"
field = true
layers = 6
bush = { outer_diameter = "200 mm", conductivity = "250 W/(m.K)", transfer = "80 W/(m2.K)", ambient = "40 C" }
"#;

/// The keys of the bush of [`FERRON`].
pub const BUSH: &str =
    r#"bush = { outer_diameter = "200 mm", conductivity = "250 W/(m.K)", transfer = "80 W/(m2.K)", ambient = "40 C" }"#;

/// The load of [`FERRON`], which a position may replace.
pub const LOAD: &str = "[load]\nforce = \"6 kN\"\nangle = \"270 deg\"\n";

/// A main bearing of a petrol engine with a groove in the upper half.
pub const ENGINE: &str = r#"
[bearing]
diameter = "50 mm"
length = "20 mm"
clearance = "25 um"
[mesh]
size = "1.5 mm"
[[feed]]
group = "groove"
pressure = "4 bar"
groove = { from = "20 deg", to = "160 deg", width = "3 mm" }
[journal]
speed = "4000 rpm"
[load]
force = "5 kN"
angle = "270 deg"
[oil]
exponential = { viscosity = "10 mPa.s", at = "90 C", beta = "0.027 1/K" }
conductivity = "0.13 W/(m.K)"
[cavitation]
model = "jfo"
[heat]
inlet = "90 C"
heat_capacity = "1.8275 MJ/(m3.K)"
field = true
bush = { outer_diameter = "70 mm", conductivity = "45 W/(m.K)", transfer = "2000 W/(m2.K)", ambient = "95 C" }
"#;

/// A turbine bearing with two axial grooves.
pub const TURBINE: &str = r#"
[bearing]
diameter = "250 mm"
length = "200 mm"
clearance = "150 um"
[mesh]
size = "8 mm"
[[feed]]
group = "right"
pressure = "1.5 bar"
groove = { from = "350 deg", to = "370 deg", width = "150 mm" }
[[feed]]
group = "left"
pressure = "1.5 bar"
groove = { from = "170 deg", to = "190 deg", width = "150 mm" }
[journal]
speed = "3000 rpm"
[load]
force = "75 kN"
angle = "270 deg"
[oil]
exponential = { viscosity = "27.7 mPa.s", at = "40 C", beta = "0.034 1/K" }
conductivity = "0.13 W/(m.K)"
[cavitation]
model = "jfo"
[heat]
inlet = "45 C"
heat_capacity = "1.72 MJ/(m3.K)"
field = true
layers = 6
bush = { outer_diameter = "380 mm", conductivity = "45 W/(m.K)", transfer = "50 W/(m2.K)", ambient = "40 C" }
"#;

/// A text with edits, each of which it contains.
///
/// # Panics
/// If the text does not contain what an edit replaces.
pub fn edited(text: &str, edits: &[(&str, &str)]) -> String {
    edits.iter().fold(text.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    })
}

/// A solved film with its temperatures.
pub struct ThermalFilm(pub RunResult);

impl ThermalFilm {
    /// The film of a text.
    pub fn of(text: &str) -> Self {
        Self::of_scene(&written(text))
    }

    /// The film of a scene, without bars.
    ///
    /// # Panics
    /// If there is none.
    pub fn of_scene(scene: &Scene) -> Self {
        let run = run(scene, &RunOptions { bars: false, ..RunOptions::of(scene) });
        let result = run.unwrap_or_else(|error| panic!("{error}")).result;
        assert!(result.head.reason.is_none(), "{:?}", result.head.reason);
        Self(result)
    }

    /// A quantity.
    ///
    /// # Panics
    /// If it is not reported.
    pub fn value(&self, name: &str) -> f64 {
        let found = self.0.quantities.iter().find(|quantity| quantity.name == name);
        found.unwrap_or_else(|| panic!("no {name}")).value
    }

    /// Flow of all feeds together [m3/s].
    pub fn fed(&self) -> f64 {
        let feeds = self.0.quantities.iter().filter(|quantity| quantity.name.starts_with("feed_flow."));
        feeds.map(|quantity| quantity.value).sum()
    }

    /// Asserts that the film is that of a row: value and uncertainty of each number.
    ///
    /// # Panics
    /// If a number is off by more than the uncertainty of the row and the figure for that number.
    pub fn is(&self, row: &ReferenceRow) {
        let of = |name: &str, unit: f64| self.value(name) / unit;
        let relative = |[value, _]: [f64; 2], figure: f64| figure * value;
        let mut wrong = Vec::new();
        let mut compare = |name: &str, found: f64, expected: [f64; 2], figure: f64| {
            let off = (found - expected[0]).abs();
            if off.is_nan() || off > expected[1] + figure {
                wrong.push(format!("{name}: {found}, not {} +- {} +- {figure}", expected[0], expected[1]));
            }
        };
        compare("eccentricity", of("eccentricity", 1.0), row.eccentricity, 2e-3);
        compare("least film", of("film_thickness_min", 1e-6), row.least_film, relative(row.least_film, 0.01));
        compare("pressure", of("pressure_max", 1e6), row.pressure, relative(row.pressure, 0.01));
        compare("power", of("heat_power", 1.0), row.power, relative(row.power, 0.005));
        compare("flow", self.fed() * 1e6, row.flow, relative(row.flow, 0.005));
        compare("hottest point", of("temperature_max", 1.0), row.hottest, 0.5);
        compare("journal", of("temperature_journal", 1.0), row.journal, 0.5);
        if let Some(bush) = row.bush {
            compare("bush", of("temperature_bush_max", 1.0), bush, 0.5);
        }
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }

    /// Asserts that the heat of the film is what leaves it, as well as the linear system of its temperatures is solved.
    ///
    /// # Panics
    /// If it is not.
    pub fn heat_closes(&self) {
        let off = |name: &str| self.0.quantities.iter().find(|it| it.name == name).map_or(0.0, |it| it.value);
        let leaves = self.value("heat_carried") + off("heat_bush") + self.value("heat_journal");
        let power = self.value("heat_power");
        assert!((leaves - power).abs() < 1e-9 * power, "{leaves} W of {power} W");
        assert!(self.0.balances.thermal.abs() < 1e-9, "{:e}", self.0.balances.thermal);
    }
}

/// Numbers of a film, each with its uncertainty.
pub struct ReferenceRow {
    /// Eccentricity [1].
    pub eccentricity: [f64; 2],
    /// Least film [um].
    pub least_film: [f64; 2],
    /// Greatest pressure [MPa].
    pub pressure: [f64; 2],
    /// Power of friction and pressure [W].
    pub power: [f64; 2],
    /// Flow of all feeds [ml/s].
    pub flow: [f64; 2],
    /// Greatest temperature of the film [degrees C].
    pub hottest: [f64; 2],
    /// Temperature of the journal [degrees C].
    pub journal: [f64; 2],
    /// Greatest temperature of the bush [degrees C]; none where it is adiabatic.
    pub bush: Option<[f64; 2]>,
}
