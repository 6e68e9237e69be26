//! Crankshafts on all their films: the shipped scenes, variants of them, and what a second code finds; for the tests
//! and for `docs/validation/crankshafts.md`.

use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use oilwedge_bearing::duty_cycle::{Crank, DutyCycle, GasPressure, Linkage, PressureCurve, Throw};
use oilwedge_scene::ShaftScene;
use oilwedge_study::minimax::{GreatestLeast, greatest_least};
use oilwedge_study::quantities::{CYCLE_FILM_THICKNESS_MIN, Row};
use oilwedge_study::shaft::{BearingReport, ShaftRun, run_shaft};
use oilwedge_study::{RunOptions, parse};

use crate::program::repository;

/// Radial clearance [m] and radius [m] of the bearings of `three_films.toml`.
pub const CLEARANCE: f64 = 30e-6;
/// Radius of the journals, for the [`CLEARANCE`] above [m].
pub const RADIUS: f64 = 30e-3;

/// Path of a file in `scenes/engines/`.
pub fn engines(name: &str) -> PathBuf {
    repository().join("scenes/engines").join(name)
}

/// The text of a shipped scene.
///
/// # Panics
/// There is none of this name.
pub fn text(name: &str) -> String {
    std::fs::read_to_string(engines(name)).expect("a shipped scene")
}

/// A text with one part of it changed.
///
/// # Panics
/// It has no such part.
pub fn changed(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

/// A scene whose bearings `NAME.toml` have one part of their scene changed, which then stands in a folder of its own.
///
/// # Panics
/// That scene has no such part, or cannot be written.
pub fn with_bearing(folder: &Path, name: &str, (from, to): (&str, &str), scene: &str) -> String {
    let file = format!("bearings/{name}.toml");
    let path = folder.join("bearing.toml");
    std::fs::write(&path, changed(&text(&file), from, to)).expect("a file");
    scene.replace(&file, path.to_str().expect("a path"))
}

/// What a run of a scene finds, without error bars.
///
/// # Panics
/// The scene is refused.
pub fn run(text: &str) -> ShaftRun {
    let options = RunOptions { bars: false, max_seconds: f64::INFINITY, ..RunOptions::default() };
    run_with(text, &options)
}

/// What a run of a scene finds.
///
/// # Panics
/// The scene is refused.
pub fn run_with(text: &str, options: &RunOptions) -> ShaftRun {
    let scene = ShaftScene::parse(text, &engines("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
    run_shaft(&scene, options).unwrap_or_else(|error| panic!("{error}"))
}

/// A number of each bearing.
///
/// # Panics
/// A bearing has no such number.
pub fn numbers(run: &ShaftRun, row: &Row) -> Vec<f64> {
    let number = |bearing: &BearingReport| {
        let quantity = bearing.quantity(row);
        quantity.unwrap_or_else(|| panic!("no {} of {}", row.name, bearing.name)).value
    };
    run.result.bearings.iter().map(number).collect()
}

/// The shaft on three films under other loads or supports, and what structured finite volumes of a second code find on
/// all its films, extrapolated.
#[derive(Debug, Clone, Copy)]
pub struct ThreeFilms {
    /// What is special of it.
    pub name: &'static str,
    /// What is changed in the shipped scene.
    pub change: [&'static str; 2],
    /// The mesh of its bearings.
    pub mesh: &'static str,
    /// W_x, W_y [N], g_x, g_y [c/R], least film [um] of each bearing.
    pub bearings: [[f64; 5]; 3],
}

/// The scene as it is shipped; a middle bearing whose housing yields; the second load across the first one.
pub const THREE_FILMS: [ThreeFilms; 3] = [
    ThreeFilms {
        name: "rigid supports",
        change: [SECOND_LOAD, SECOND_LOAD],
        mesh: "",
        bearings: [
            [-84.23, -4094.6, -0.013229, -0.16057, 6.11],
            [168.46, -15811.0, 0.0, 0.0, 3.421],
            [-84.23, -4094.6, 0.013229, 0.16057, 6.11],
        ],
    },
    ThreeFilms {
        name: "middle support 200 MN/m",
        change: ["at    = \"200 mm\"", "at    = \"200 mm\"\nsupport = { stiffness = \"200 MN/m\" }"],
        // The film at an end is a fiftieth of the clearance: the mesh of the scene would leave it off by 2 %.
        mesh: "[mesh]\nsize = \"2 mm\"\n\n",
        bearings: [
            [13.289, -6763.3, -0.0043237, -0.52062, 0.6155],
            [-26.578, -10473.0, 0.0, 0.0, 4.478],
            [13.289, -6763.3, 0.0043237, 0.52062, 0.6155],
        ],
    },
    ThreeFilms {
        name: "loads crossed",
        change: [SECOND_LOAD, "at    = \"300 mm\"\nforce = \"9 kN\"\nangle = \"0 deg\""],
        mesh: "",
        bearings: [
            [-376.17, -5336.8, 0.034798, -0.14291, 4.769],
            [5244.4, -7343.2, 0.09319, 0.20305, 4.711],
            [4131.8, 679.91, -0.18957, 0.099003, 6.776],
        ],
    },
];
const SECOND_LOAD: &str = "at    = \"300 mm\"\nforce = \"12 kN\"\nangle = \"270 deg\"";

impl ThreeFilms {
    /// What a run finds. Each of [`THREE_FILMS`] is run once in a program.
    ///
    /// # Panics
    /// It is none of these, or no folder for a scene can be made.
    pub fn solved(&self) -> &'static ShaftRun {
        static RUNS: [OnceLock<ShaftRun>; 3] = [const { OnceLock::new() }; 3];
        let number = THREE_FILMS.iter().position(|case| case.name == self.name);
        RUNS[number.expect("one of the cases")].get_or_init(|| self.found())
    }

    fn found(&self) -> ShaftRun {
        let folder = tempfile::tempdir().expect("a folder");
        let [from, to] = self.change;
        let scene = changed(&text("three_films.toml"), from, to);
        let mesh = format!("{}[journal]", self.mesh);
        run(&with_bearing(folder.path(), "small_ring", ("[journal]", &mesh), &scene))
    }

    /// Greatest tilt of its journals by the second code [c/R].
    pub fn greatest_tilt(&self) -> f64 {
        let tilts = self.bearings.iter().map(|[_, _, x, y, _]| x.hypot(*y));
        tilts.fold(0.0, f64::max)
    }
}

/// Parts of one load of 12 kN that three rigid knife edges bear.
pub const KNIFE_EDGES: [f64; 3] = [5.0 / 16.0, 11.0 / 8.0, 5.0 / 16.0];

/// The shaft on films of a hundredth of the clearance, which bear no moment. It is run once in a program.
///
/// # Panics
/// No folder for a scene can be made.
pub fn on_thin_films() -> &'static ShaftRun {
    static RUN: OnceLock<ShaftRun> = OnceLock::new();
    RUN.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a folder");
        let modulus = "youngs_modulus = \"206 GPa\"";
        let scene = changed(&text("three_films.toml"), modulus, &format!("{modulus}\ntilt = \"none\""));
        let thin = ("\"30 um\"", "\"0.3 um\"");
        run(&with_bearing(folder.path(), "small_ring", thin, &scene))
    })
}

/// Load [kN] of the right one of [`two_films`].
pub const RIGHT: f64 = (12.0 * 0.1 + 0.22) / 0.4;

/// The shaft without its bearing in the middle, under 12 kN and 1 kN.
pub fn two_films() -> String {
    let scene = text("three_films.toml");
    let middle =
        "[[crankshaft.bearing]]\nname  = \"middle\"\nscene = \"bearings/small_ring.toml\"\nat    = \"200 mm\"\n";
    let scene = changed(&scene, middle, "");
    changed(&scene, "at    = \"300 mm\"\nforce = \"12 kN\"", "at    = \"220 mm\"\nforce = \"1 kN\"")
}

/// [`two_films`] with another modulus of elasticity or further keys in its place.
pub fn two_films_with(keys: &str) -> String {
    changed(&two_films(), "youngs_modulus = \"206 GPa\"", keys)
}

/// A shaft so stiff that it does not bend, on bearings that bear no moment; and one that is cut. Statics decides what
/// their bearings bear.
pub const BY_STATICS: [(&str, &str); 2] = [
    ("rigid shaft", "youngs_modulus = \"206e6 GPa\"\ntilt = \"none\""),
    ("cut shaft", "youngs_modulus = \"206 GPa\"\nstatics = \"cut\""),
];

/// What runs of [`BY_STATICS`] on two films find. They are run once in a program.
pub fn by_statics() -> &'static [ShaftRun; 2] {
    static RUNS: OnceLock<[ShaftRun; 2]> = OnceLock::new();
    RUNS.get_or_init(|| BY_STATICS.map(|(_, keys)| run(&two_films_with(keys))))
}

/// An `engine` of three throws, `three_throws.toml` or a change of it, cut at its main bearings.
pub fn three_throws_cut(engine: &str) -> String {
    changed(engine, "period         = \"720 deg\"", "statics = \"cut\"")
}

/// The throws beside the first two main bearings of `three_throws.toml`, as the scene of a single bearing has them.
pub const BESIDE: [&str; 2] = [
    "[{ share = 0.5, web_mass = \"2.4 kg\" }]",
    "[{ share = 0.5, web_mass = \"2.4 kg\" }, { angle = \"240 deg\", share = 0.5, web_mass = \"2.4 kg\" }]",
];

/// Least film [m] over the orbit of a main bearing of this `engine` of three throws by itself, beside these throws;
/// `bearing` is the text of its scene.
///
/// # Panics
/// It has no orbit.
pub fn single_main(engine: &str, throws: &str, bearing: &str) -> f64 {
    let bearing = changed(bearing, "eccentricity   = 0.8\nmin_film_angle = \"180 deg\"\n", "");
    let (_, crank) = engine.split_once("[crank]").expect("a crank drive");
    let (crank, orbit) = crank.split_once("[orbit]").expect("an orbit");
    let scene = format!(
        "{bearing}\n[load]\nbearing = \"main\"\nperiod = \"720 deg\"\n[crank]{crank}throws = {throws}\n[orbit]{orbit}"
    );
    let scene = parse(&scene, &engines("bearings/alone.toml")).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { bars: false, ..RunOptions::of(&scene) };
    let found = oilwedge_study::run(&scene, &options).unwrap_or_else(|error| panic!("{error}"));
    found.result.quantity(&CYCLE_FILM_THICKNESS_MIN).expect("a film").value
}

/// One throw with a rod without end and without gas: what is best is known in closed form.
#[derive(Debug, Clone, Copy)]
pub struct ClosedThrow {
    /// Rotating and reciprocating mass [kg].
    pub masses: [f64; 2],
    /// Radius of the crank [m].
    pub radius: f64,
    /// Angular speed [rad/s].
    pub speed: f64,
}

/// The throw of the tests.
pub const CLOSED_THROW: ClosedThrow = ClosedThrow { masses: [2.0, 3.0], radius: 0.06, speed: 200.0 };

impl ClosedThrow {
    /// The best counterweight [kg m], opposite to the crank: all that turns, and half of what goes to and fro.
    pub fn best(&self) -> f64 {
        let [rotating, reciprocating] = self.masses;
        self.radius * (rotating + 0.5 * reciprocating)
    }

    /// The greatest load [N] with it.
    pub fn least_peak(&self) -> f64 {
        0.5 * self.masses[1] * self.radius * self.speed * self.speed
    }

    /// The counterweight that the search finds, and minus the greatest load with it.
    pub fn found(&self) -> GreatestLeast {
        let crank = Crank {
            linkage: Linkage { radius: self.radius, rod_length: 1e12 },
            reciprocating_mass: self.masses[1],
            rotating_mass: self.masses[0],
            bore: 0.1,
            gas: GasPressure::Curve(PressureCurve { peak: 0.0, angle: 0.0, sharpness: 1.0, period: TAU }),
        };
        let throw = Throw { angle: 0.0, share: 1.0, web_mass: 0.0 };
        let loads = |unbalance: &[f64]| {
            let cycle = DutyCycle::of_main(crank.clone(), vec![throw], self.speed);
            let cycle = cycle.with_unbalance([unbalance[0], unbalance[1]]);
            let loads = (0..360).map(|k| cycle.at(f64::from(k).to_radians()).force);
            Some(loads.map(|[x, y]| -x.hypot(y)).collect())
        };
        greatest_least(&loads, &[0.0, 0.0], 1.0, self.least_peak()).expect("loads")
    }
}
