//! Thermal films of two independent codes: structured finite volumes with JFO, temperatures across the film, one of the
//! journal, and a bush that conducts heat; the second one has cells across the film and a bush in three dimensions.

use oilwedge_scene::Scene;
use oilwedge_study::result::RunResult;
use oilwedge_study::{Run, RunOptions, run};

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

/// A position in place of [`LOAD`].
pub const AT_POSITION: [(&str, &str); 2] =
    [(LOAD, ""), ("speed = \"4000 rpm\"", "speed = \"4000 rpm\"\neccentricity = 0.7\nmin_film_angle = \"310 deg\"")];

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

    /// The numbers that the reference has too, in its units; none of the bush where it is adiabatic.
    pub fn numbers(&self) -> [Option<f64>; 8] {
        let of = |name: &str, unit: f64| Some(self.value(name) / unit);
        let bush = self.0.quantities.iter().find(|quantity| quantity.name == "temperature_bush_max");
        [
            of("eccentricity", 1.0),
            of("film_thickness_min", 1e-6),
            of("pressure_max", 1e6),
            of("heat_power", 1.0),
            Some(self.fed() * 1e6),
            of("temperature_max", 1.0),
            of("temperature_journal", 1.0),
            bush.map(|quantity| quantity.value),
        ]
    }

    /// Asserts that the film is that of a row: value and uncertainty of each number.
    ///
    /// # Panics
    /// If a number is off by more than the uncertainty of the row and the figure for that number.
    pub fn is(&self, row: &ReferenceRow) {
        let mut wrong = Vec::new();
        for ((found, expected), (name, figure)) in self.numbers().iter().zip(row.numbers).zip(NUMBERS) {
            let (Some(found), Some([value, uncertainty])) = (found, expected) else { continue };
            let figure = match figure {
                Figure::Absolute(figure) => figure,
                Figure::Part(part) => part * value,
            };
            let off = (found - value).abs();
            if off.is_nan() || off > uncertainty + figure {
                wrong.push(format!("{name}: {found}, not {value} +- {uncertainty} +- {figure}"));
            }
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

/// How near a number must be to that of the reference.
#[derive(Debug, Clone, Copy)]
pub enum Figure {
    /// In its unit.
    Absolute(f64),
    /// As a part of it.
    Part(f64),
}

/// The numbers of a row, with how near they must be.
pub const NUMBERS: [(&str, Figure); 8] = [
    ("eps", Figure::Absolute(2e-3)),
    ("h_min [um]", Figure::Part(0.01)),
    ("p_max [MPa]", Figure::Part(0.01)),
    ("power [W]", Figure::Part(0.005)),
    ("flow [ml/s]", Figure::Part(0.005)),
    ("T_max [C]", Figure::Absolute(0.5)),
    ("T_j [C]", Figure::Absolute(0.5)),
    ("T_bush [C]", Figure::Absolute(0.5)),
];

/// A film of the reference.
pub struct ReferenceRow {
    /// Name of the film.
    pub name: &'static str,
    /// What it is.
    pub what: &'static str,
    /// Text of the scene.
    pub text: String,
    /// Numbers in the order of [`NUMBERS`], each with its uncertainty; none of a bush that is adiabatic.
    pub numbers: [Option<[f64; 2]>; 8],
}

/// The films of the reference.
pub fn reference() -> Vec<ReferenceRow> {
    let shaft = format!("{BUSH}\njournal = {{ conductance = \"5 W/K\", ambient = \"30 C\" }}");
    let row = |name, what, text: String, numbers: [[f64; 2]; 7], bush: Option<[f64; 2]>| {
        let number = |k: usize| numbers.get(k).copied().or(bush);
        ReferenceRow { name, what, text, numbers: std::array::from_fn(number) }
    };
    vec![
        row(
            "F1",
            "bronze bush, 4000 rpm, 6 kN",
            FERRON.to_owned(),
            [
                [0.547_272, 0.000_75],
                [65.6456, 0.11],
                [1.799_42, 0.0071],
                [1659.06, 2.5],
                [128.505, 0.57],
                [57.4722, 0.057],
                [48.527, 0.092],
            ],
            Some([56.3495, 0.013]),
        ),
        row(
            "F3",
            "the same at 2000 rpm, 9 kN",
            edited(FERRON, &[("4000 rpm", "2000 rpm"), ("6 kN", "9 kN"), ("6 mm", "4 mm")]),
            [
                [0.750_392, 0.000_89],
                [36.1932, 0.13],
                [3.411_55, 0.014],
                [596.859, 1.8],
                [108.14, 0.33],
                [51.0729, 0.089],
                [46.2434, 0.15],
            ],
            Some([50.4718, 0.079]),
        ),
        row(
            "F4",
            "its bush adiabatic, at a position",
            edited(FERRON, &[AT_POSITION.as_slice(), &[(BUSH, "")]].concat()),
            [
                [0.7, 1e-9],
                [43.5, 1e-6],
                [3.762_76, 0.018],
                [1788.56, 7.2],
                [172.596, 0.59],
                [67.6, 0.3],
                [50.1008, 0.37],
            ],
            None,
        ),
        row(
            "F5",
            "F1 with a shaft that takes 5 W/K",
            edited(FERRON, &[(BUSH, &shaft), ("6 mm", "4 mm")]),
            [
                [0.542_194, 0.000_73],
                [66.3819, 0.11],
                [1.7939, 0.0071],
                [1676.72, 2.2],
                [126.925, 0.53],
                [57.1028, 0.032],
                [47.4047, 0.077],
            ],
            Some([56.0939, 0.015]),
        ),
        row(
            "E1",
            "engine main bearing",
            ENGINE.to_owned(),
            [
                [0.839_844, 0.000_17],
                [4.003_89, 0.0043],
                [21.5087, 0.015],
                [156.568, 0.32],
                [6.056_22, 0.0042],
                [106.994, 0.037],
                [104.333, 0.025],
            ],
            Some([106.956, 0.029]),
        ),
        row(
            "T1",
            "turbine bearing with two grooves",
            TURBINE.to_owned(),
            [
                [0.550_459, 0.0013],
                [67.4312, 0.19],
                [3.530_72, 0.02],
                [14_824.3, 47.0],
                [356.031, 2.3],
                [87.387, 0.14],
                [70.0941, 0.2],
            ],
            Some([87.3208, 0.17]),
        ),
    ]
}

/// Asserts that a film of the reference has its numbers, and that its heat is balanced; gives it back.
///
/// # Panics
/// If the reference has no film of this name, or a number is off.
pub fn is_that_of_the_reference(name: &str) -> ThermalFilm {
    let row = reference().into_iter().find(|row| row.name == name).expect("a film of the reference");
    let film = ThermalFilm::of(&row.text);
    film.heat_closes();
    film.is(&row);
    film
}

/// The engine bearing on a coarse mesh.
pub fn coarse_engine() -> String {
    edited(ENGINE, &[("size = \"1.5 mm\"", "size = \"4 mm\"")])
}

/// The coarse engine bearing under a cycle with these loads in x and y [kN] at every quarter of a turn, and two frames
/// of it; bars are not estimated.
///
/// # Panics
/// If there is no such orbit.
pub fn engine_over_cycle(loads: [[f64; 2]; 4]) -> Run {
    let folder = tempfile::TempDir::new().expect("a folder");
    let row = |(k, [x, y]): (usize, &[f64; 2])| format!("{}, {x}, {y}\n", 90 * k);
    let rows: String = loads.iter().enumerate().map(row).collect();
    std::fs::write(folder.path().join("load.csv"), format!("angle [deg], Fx [kN], Fy [kN]\n{rows}")).expect("a file");
    let orbit = "[load]\nfile = \"load.csv\"\nframe = \"shell\"\nperiod = \"360 deg\"\n[orbit]\ntolerance = 1e-2\n";
    let text = edited(&coarse_engine(), &[("[load]\nforce = \"5 kN\"\nangle = \"270 deg\"\n", orbit)]);
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).expect("a file");
    let scene = oilwedge_study::read(&path).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { bars: false, frames: 2, ..RunOptions::of(&scene) };
    run(&scene, &options).unwrap_or_else(|error| panic!("{error}"))
}
