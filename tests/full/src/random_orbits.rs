//! Random bearings under random loads over a cycle; the same on every run.

use std::f64::consts::PI;
use std::fmt::Write;
use std::path::Path;

use oilwedge_scene::Scene;
use oilwedge_study::quantities::{CYCLE_FILM_THICKNESS_MIN, CYCLE_PRESSURE_MAX, Row};
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::{RunOptions, parse, run};

use oilwedge_tests::random_bearings::Dice;

/// The numbers whose bars are judged.
pub const JUDGED: [&Row; 2] = [&CYCLE_FILM_THICKNESS_MIN, &CYCLE_PRESSURE_MAX];
/// Edges of triangles over the circumference of the references.
const REFERENCE: f64 = 60.0;
/// Tolerance of the references over that of the orbits, and the least one.
const SHARPER: f64 = 0.1;
const LEAST_TOLERANCE: f64 = 1e-5;

/// How an orbit is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Followed {
    /// Edges of triangles in the circumference.
    pub edges: f64,
    /// Tolerance of the steps [1].
    pub tolerance: f64,
}

impl Followed {
    /// The reference of an orbit: some four times the unknowns and more, and a tenth of the tolerance.
    pub fn reference(self) -> Self {
        Self { edges: REFERENCE, tolerance: (SHARPER * self.tolerance).max(LEAST_TOLERANCE) }
    }
}

/// A bearing and its load by chance.
#[derive(Debug, Clone)]
pub struct RandomOrbit {
    /// Number of the orbit.
    pub number: u64,
    diameter: f64,
    /// Tables but for the mesh and the orbit.
    text: String,
    /// Keys of the orbit but for the tolerance.
    orbit: String,
}

impl RandomOrbit {
    /// An ordinary bearing: a full ring whose film is some 2 to 40 % of the clearance.
    pub fn ordinary(number: u64) -> Self {
        Self::new(number, [0.5, 4.0], "cycles = 6")
    }

    /// A bearing under loads from almost none to far too much, at times with a rotor, off the middle, with a hole, or
    /// an arc.
    pub fn of_any_kind(number: u64) -> Self {
        let mut dice = Dice::new(9_500_000 + number);
        let mass = match dice.chance(0.2) {
            true => format!(", mass = \"{:.3} kg\"", dice.decades(-1.0, 2.0)),
            false => String::new(),
        };
        let mut orbit = Self::new(number, [0.01, 40.0], &format!("cycles = 4{mass}"));
        if dice.chance(0.15) {
            let place = dice.between(-0.1, 0.1) * orbit.diameter * 1e3;
            orbit.text = orbit.text.replacen("load = {", &format!("load = {{ at = \"{place:.4} mm\","), 1);
        }
        if dice.chance(0.2) {
            let hole = 0.06 * orbit.diameter * 1e3;
            let angle = dice.between(0.0, 360.0);
            let pressure = dice.between(0.0, 4.0);
            writeln!(
                orbit.text,
                "feed = [{{ group = \"hole\", hole = {{ diameter = \"{hole:.3} mm\", angle = \"{angle:.1} deg\" }}, pressure = \"{pressure:.2} bar\" }}]"
            )
            .expect("text grows");
        } else if dice.chance(0.15) {
            let from = dice.between(0.0, 360.0);
            let arc = format!(
                "arc = {{ from = \"{from:.1} deg\", to = \"{:.1} deg\" }}, diameter",
                from + dice.between(120.0, 200.0)
            );
            orbit.text = orbit.text.replacen("diameter", &arc, 1);
        }
        orbit
    }

    fn new(number: u64, loads: [f64; 2], orbit: &str) -> Self {
        let mut dice = Dice::new(9_000_000 + number);
        let diameter = dice.decades(0.03f64.log10(), 0.15f64.log10());
        let length = diameter * dice.decades(0.25f64.log10(), 0.0);
        let clearance = 0.5 * diameter * dice.between(0.5e-3, 1.5e-3);
        let speed = dice.decades(2.7, 3.7) * PI / 30.0;
        let viscosity = dice.decades(-2.2, -1.5);
        let psi = 2.0 * clearance / diameter;
        let unit = viscosity * speed * diameter * length / (psi * psi);
        let load = unit * dice.decades(loads[0].log10(), loads[1].log10());
        let mut harmonics = Vec::new();
        for order in [0.0, 0.5, 1.0, 1.5, 2.0, 3.0] {
            let size = load * dice.between(0.0, 1.0) / (1.0 + order * order);
            let [x, y, u, v] = [0, 1, 2, 3].map(|_| size * dice.between(-1.0, 1.0));
            harmonics.push(format!(
                "{{ order = {order}, cos = {{ x = \"{x} N\", y = \"{y} N\" }}, sin = {{ x = \"{u} N\", y = \"{v} N\" }} }}"
            ));
        }
        let model = ["reynolds", "reynolds", "guembel"][(dice.between(0.0, 2.999)) as usize];
        let sense = if dice.chance(0.3) { -1.0 } else { 1.0 };
        let text = format!(
            "bearing = {{ diameter = \"{} mm\", length = \"{} mm\", clearance = \"{} um\" }}\n\
             journal.speed = \"{} rad/s\"\noil.viscosity = \"{viscosity} Pa.s\"\ncavitation.model = \"{model}\"\n\
             load = {{ frame = \"shell\", period = \"720 deg\", harmonics = [{}] }}\n",
            1e3 * diameter,
            1e3 * length,
            1e6 * clearance,
            sense * speed,
            harmonics.join(", ")
        );
        Self { number, diameter, text, orbit: orbit.to_owned() }
    }

    /// Scene of the orbit.
    pub fn text(&self, how: Followed) -> String {
        let size = 1e3 * PI * self.diameter / how.edges;
        format!(
            "{}mesh.size = \"{size:.5} mm\"\norbit = {{ tolerance = {}, {} }}\n",
            self.text, how.tolerance, self.orbit
        )
    }

    /// Result of the orbit.
    ///
    /// # Panics
    /// The scene is refused.
    pub fn solved(&self, how: Followed, bars: Bars) -> RunResult {
        let text = self.text(how);
        let scene: Scene = parse(&text, Path::new("orbit.toml")).unwrap_or_else(|error| panic!("{error}\n{text}"));
        let options = RunOptions { bars: bars == Bars::Estimated, max_seconds: 600.0, ..RunOptions::default() };
        run(&scene, &options).unwrap_or_else(|error| panic!("{error}\n{text}")).result
    }
}

/// Whether error bars are estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bars {
    /// Bars are estimated.
    Estimated,
    /// No bars are estimated.
    Omitted,
}

/// True error over bar of each judged number of an orbit, against its reference.
pub fn ratios(found: &RunResult, reference: &RunResult) -> [Option<f64>; 2] {
    JUDGED.map(|row| {
        let (found, reference) = (found.quantity(row)?, reference.quantity(row)?);
        Some((found.value - reference.value).abs() / found.error()?)
    })
}

/// What is wrong with an answer: neither closed nor explained, a journal in the wall, or no number.
pub fn fault(result: &RunResult) -> Option<String> {
    if result.head.status != Status::Converged && result.head.reason.is_none() {
        return Some("not converged, without a reason".to_owned());
    }
    if result.head.status == Status::Converged && result.quantities.is_empty() {
        return Some("converged, without numbers".to_owned());
    }
    if let Some(quantity) = result.quantities.iter().find(|quantity| !quantity.value.is_finite()) {
        return Some(format!("{} is {}", quantity.name, quantity.value));
    }
    let thinnest = result.quantity(&CYCLE_FILM_THICKNESS_MIN)?.value;
    (thinnest <= 0.0).then(|| format!("the least film is {thinnest}"))
}
