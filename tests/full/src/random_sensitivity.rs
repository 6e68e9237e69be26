//! Random bearings whose derivatives by all numbers that leave the mesh as it is are compared with films solved again
//! on that mesh.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use oilwedge_campaign::sweep::{CaseOutcome, chain_of};
use oilwedge_campaign::with_derivatives;
use oilwedge_scene::unit::Dimension;
use oilwedge_scene::{KeyTolerance, Scene};
use oilwedge_study::quantities::Quantity;
use oilwedge_study::result::Status;
use oilwedge_study::{CHECKS, RunOptions, run};
use oilwedge_tests::random_bearings::Dice;
use oilwedge_tests::scenes::{DIFFERENTIATED, written};

/// Edges of triangles over the circumference.
const EDGE: f64 = 1.0 / 50.0;
/// Films solved again are as far from the one at hand as those of the tangent: over the number of the key [1], in
/// radians, and for temperatures over [`KELVIN`].
const APART: f64 = 3e-5;
const KELVIN: f64 = 100.0;
/// A quantity with a greater exponent is next to nothing.
const NOTHING: f64 = 333.0;

/// A derivative beside the difference of two films.
#[derive(Debug, Clone)]
pub struct Compared {
    /// Number of the bearing.
    pub bearing: u64,
    /// What is differentiated.
    pub quantity: String,
    /// The key of the scene.
    pub key: String,
    /// Exponent by the tangent.
    pub told: f64,
    /// Exponent by two films on both sides.
    pub central: f64,
    /// Whether the program says that there is a kink.
    pub is_named: bool,
}

impl Compared {
    /// How far tangent and films are apart, over the exponent where that is greater than one.
    pub fn off(&self) -> f64 {
        (self.told - self.central).abs() / f64::max(1.0, self.central.abs())
    }
}

/// The scene of a bearing by chance: any cavitation model, at a position or under a load, some with holes and grooves,
/// a moment, a wall that gives way, or heat.
pub fn scene(number: u64) -> Scene {
    let mut dice = Dice::new(57_000_000 + number);
    let radius = 0.5 * dice.decades(-1.5, -0.7);
    let length = 2.0 * radius * dice.between(0.3, 1.0);
    let clearance = radius * dice.decades(-3.1, -2.7);
    let omega = dice.decades(1.5, 2.7);
    let viscosity = dice.decades(-2.2, -1.3);
    let is_hot = dice.chance(0.2);
    let mut text = format!(
        "title = \"Bearing {number}\"\n[bearing]\ndiameter = \"{} m\"\nlength = \"{length} m\"\nclearance = \"{clearance} m\"\n[mesh]\nsize = \"{} m\"\n",
        2.0 * radius,
        TAU * radius * EDGE
    );
    let model = ["none", "guembel", "reynolds", "jfo"][dice.between(0.0, 3.999) as usize];
    let _ = writeln!(text, "[cavitation]\nmodel = \"{model}\"\n[journal]\nspeed = \"{omega} rad/s\"");
    let eccentricity = dice.between(0.1, 0.9);
    let towards = dice.between(-PI, PI);
    let is_loaded = dice.chance(0.7);
    if is_loaded {
        let unit = viscosity * omega * (radius / clearance).powi(2);
        let size = 2.0 * radius * length * (length / radius).powi(2).min(1.0);
        let force = 0.35 * unit * size * eccentricity / (1.0 - eccentricity);
        let _ = writeln!(text, "[load]\nforce = \"{force} N\"\nangle = \"{towards} rad\"");
        if dice.chance(0.25) {
            let _ = writeln!(text, "at = \"{} m\"", dice.between(0.01, 0.06) * length);
        }
    } else {
        let _ = writeln!(text, "eccentricity = {eccentricity}\nmin_film_angle = \"{towards} rad\"");
    }
    match is_hot {
        true => text += "[oil]\ngrade = \"ISO VG 46\"\n[heat]\ninlet = \"50 C\"\n",
        false => {
            let _ = writeln!(text, "[oil]\nviscosity = \"{viscosity} Pa.s\"");
            if dice.chance(0.5) {
                let _ = writeln!(text, "barus = {{ alpha = \"{} 1/Pa\" }}", dice.decades(-8.5, -7.8));
            }
        }
    }
    if is_loaded && dice.chance(0.2) {
        let _ = writeln!(
            text,
            "[liner]\nwall = {{ thickness = \"{} m\", modulus = \"{} GPa\", poisson = 0.3 }}",
            dice.between(0.05, 0.15) * radius,
            dice.decades(1.0, 1.8)
        );
    }
    // A film that conserves its oil needs some.
    let least = if model == "jfo" { 1 } else { 0 };
    for k in 0..(dice.between(0.0, 2.999) as usize).max(least) {
        let angle = towards + PI * (0.5 + k as f64) + dice.between(-0.4, 0.4);
        let place = match dice.chance(0.5) {
            true => format!("hole = {{ diameter = \"{} m\", angle = \"{angle} rad\" }}", 0.2 * length),
            false => format!(
                "groove = {{ from = \"{} rad\", to = \"{} rad\", width = \"{} m\" }}",
                angle - 0.2,
                angle + 0.2,
                0.3 * length
            ),
        };
        let _ = writeln!(text, "[[feed]]\ngroup = \"feed_{k}\"\n{place}\npressure = \"{} Pa\"", dice.decades(4.5, 5.7));
    }
    if is_loaded && dice.chance(0.3) {
        text += "[dynamics]\n";
    }
    written(&text)
}

/// The derivatives of a bearing beside films solved again; the reason where there is no film.
///
/// # Errors
/// The film was not found.
pub fn compared(number: u64) -> Result<Vec<Compared>, String> {
    let scene = scene(number);
    let options = RunOptions { bars: false, ..RunOptions::default() };
    let moves = |input: &KeyTolerance| {
        ["bearing.diameter", "bearing.length"].contains(&&*input.key)
            || [".hole.", ".groove."].iter().any(|table| input.key.contains(table))
    };
    let inputs: Vec<KeyTolerance> = scene.inputs.iter().filter(|input| !moves(input)).cloned().collect();
    let found = run(&scene, &options).map_err(|error| error.to_string())?;
    if found.result.head.status != Status::Converged {
        return Err(found.result.head.reason.unwrap_or_default());
    }
    let (result, reasons) = with_derivatives(&scene, &found, &inputs, &options);
    if !reasons.is_empty() {
        return Err(reasons.join("; "));
    }
    let unit = |input: &KeyTolerance| match input.dimension {
        Some(Dimension::Angle) => 1.0,
        Some(Dimension::Temperature) => KELVIN,
        _ => input.nominal,
    };
    let beside = |(input, sign): (&KeyTolerance, f64)| {
        scene.with_values(&[(input, input.nominal + sign * APART * unit(input))], &CHECKS).expect("a scene")
    };
    let ends = inputs.iter().flat_map(|input| [(input, -1.0), (input, 1.0)]);
    let scenes: Vec<Scene> = std::iter::once(scene.clone()).chain(ends.map(beside)).collect();
    let films = chain_of(&scenes, &options);
    let mut all = Vec::new();
    for (input, ends) in inputs.iter().zip(films[1..].chunks(2)) {
        for quantity in result.quantities.iter().filter(|quantity| DIFFERENTIATED.contains(&&*quantity.name)) {
            let Some(own) = quantity.sensitivity.get(&input.key) else { continue };
            let of = |film: &CaseOutcome| -> Option<Quantity> {
                film.quantities.iter().find(|it| it.name == quantity.name).cloned()
            };
            let (Some(low), Some(high)) = (of(&ends[0]), of(&ends[1])) else {
                return Err(format!("no film with a little more or less of {}", input.key));
            };
            let change = quantity.row.difference(high.value, low.value) / (2.0 * APART);
            all.push(Compared {
                bearing: number,
                quantity: quantity.name.to_string(),
                key: input.key.clone(),
                told: own.value / input.unit_size() * unit(input) / quantity.value.abs(),
                central: change / quantity.value.abs(),
                is_named: own.has_kink,
            });
        }
    }
    let is_nothing =
        |it: &Compared| all.iter().any(|other| other.quantity == it.quantity && other.told.abs() > NOTHING);
    Ok(all.iter().filter(|it| !is_nothing(it)).cloned().collect())
}
