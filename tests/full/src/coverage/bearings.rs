//! Bearings by chance, by family, the same on every run for a seed.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use oilwedge_scene::Scene;

use oilwedge_tests::random_bearings::{Dice, PRESSURE_UNIT, RandomBearing};
use oilwedge_tests::scenes::{path, table};

/// Radius [m] and radial clearance [m] of all that are drawn.
const RADIUS: f64 = 0.05;
const CLEARANCE: f64 = 1e-4;
/// Speed [rad/s].
const SPEED: f64 = 200.0;
/// Viscosity [Pa s].
const VISCOSITY: f64 = 0.02;
/// Least land [m] between openings, and from them to edges of the liner.
const LAND: f64 = 0.08 * RADIUS;

/// What bearings of a family have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Family {
    /// Plain periodic rings.
    Ring,
    /// Rings with a film start.
    Start,
    /// Rings and shells with one to three holes.
    Holes,
    /// Rings and shells with grooves.
    Grooves,
    /// Rings with a pocket that deepens the film.
    Pockets,
    /// Viscosity that grows with pressure.
    Thickening,
    /// Journals that move.
    Squeeze,
    /// Thin films: eccentricities from 0.93 on.
    Thin,
    /// Meshes of files, their rims curved or straight.
    Imported,
    /// Positions under a load.
    Loaded,
    /// Mass-conserving films.
    Conserving,
}

impl Family {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Ring,
        Self::Start,
        Self::Holes,
        Self::Grooves,
        Self::Pockets,
        Self::Thickening,
        Self::Squeeze,
        Self::Thin,
        Self::Imported,
        Self::Loaded,
        Self::Conserving,
    ];

    /// Name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ring => "plain ring",
            Self::Start => "film start",
            Self::Holes => "holes",
            Self::Grooves => "grooves",
            Self::Pockets => "pocket",
            Self::Thickening => "Barus, Roelands",
            Self::Squeeze => "squeeze",
            Self::Thin => "eps from 0.93",
            Self::Imported => "mesh of a file",
            Self::Loaded => "under a load",
            Self::Conserving => "`jfo`",
        }
    }
}

/// A bearing.
#[derive(Debug, Clone)]
pub struct Bearing {
    /// Name in messages.
    pub name: String,
    /// Family of the bearing.
    pub family: Family,
    /// Model of cavitation.
    pub model: &'static str,
    /// The scene.
    pub table: toml::Table,
}

impl Bearing {
    /// The scene with longest edges of `size` [m]; without, with the mesh that it says itself.
    pub fn scene(&self, size: Option<f64>) -> Scene {
        let mut scene = self.table.clone();
        if let Some(size) = size {
            table(&mut scene, "mesh").insert("size".into(), format!("{size} m").into());
        }
        oilwedge_study::parse(&scene.to_string(), &path("written"))
            .unwrap_or_else(|error| panic!("{}: {error}", self.name))
    }

    /// True if the mesh is drawn, else that of a file.
    pub fn is_drawn(&self) -> bool {
        let mesh = self.table.get("mesh").and_then(|mesh| mesh.as_table());
        mesh.is_none_or(|mesh| !mesh.contains_key("file"))
    }
}

/// `each` bearings of each family.
pub fn bearings(seed: u64, each: u64) -> Vec<Bearing> {
    let numbered = |number: u64| Family::ALL.map(|family| bearing(family, 1000 * seed + number));
    (0..each).flat_map(numbered).collect()
}

/// The bearing of that family and number.
pub fn bearing(family: Family, number: u64) -> Bearing {
    let name = format!("{} {number}", family.name());
    let mut bearing = match family {
        Family::Conserving => {
            Bearing { name, family, model: "jfo", table: RandomBearing::new(number).text.parse().expect("TOML") }
        }
        Family::Imported => imported(name, number),
        _ => drawn(name, family, number),
    };
    // Stiffness and damping are counted too.
    table(&mut bearing.table, "dynamics");
    bearing
}

fn model(dice: &mut Dice) -> &'static str {
    match dice.between(0.0, 1.0) {
        x if x < 0.3 => "none",
        x if x < 0.45 => "guembel",
        _ => "reynolds",
    }
}

fn drawn(name: String, family: Family, number: u64) -> Bearing {
    let mut dice = Dice::new(number * 64 + family as u64);
    let length = 2.0 * RADIUS * dice.decades(0.25f64.log10(), 1.5f64.log10());
    let eccentricity = match family {
        Family::Thin => 1.0 - dice.decades(-2.0, 0.07f64.log10()),
        _ => dice.between(0.1, 0.93),
    };
    let model = model(&mut dice);
    let ends = match dice.chance(0.5) {
        true => 0.0,
        false => PRESSURE_UNIT * dice.decades(-3.0, -0.5),
    };
    let minimum = dice.between(-PI, PI);
    let speed = if dice.chance(0.5) { SPEED } else { -SPEED };
    let mixed = matches!(family, Family::Thickening | Family::Squeeze | Family::Thin | Family::Loaded);
    let has_start = family == Family::Start || (mixed && dice.chance(0.5));
    let opens = matches!(family, Family::Holes | Family::Grooves | Family::Pockets) || (mixed && dice.chance(0.5));
    let shell = !has_start && opens && family != Family::Pockets && dice.chance(0.3);
    // Openings lie in sectors of their own, the film starts between two of them.
    let first = minimum + PI + dice.between(-1.0, 1.0);
    let span = if shell { dice.between(2.5, 5.0) } else { TAU };
    let mut text = format!(
        "title = \"{name}\"\n[bearing]\ndiameter = \"{} m\"\nlength = \"{length} m\"\nclearance = \"{CLEARANCE} m\"\n",
        2.0 * RADIUS
    );
    let _ = match (has_start, shell) {
        (true, _) => writeln!(text, "film_start = \"{first} rad\""),
        (_, true) => writeln!(text, "arc = {{ from = \"{first} rad\", to = \"{} rad\" }}", first + span),
        _ => Ok(()),
    };
    let at_rest = family == Family::Squeeze && dice.chance(0.5);
    let _ = writeln!(
        text,
        "[ends]\npressure = \"{ends} Pa\"\n[cavitation]\nmodel = \"{model}\"\n[journal]\nspeed = \"{} rad/s\"",
        if at_rest { 0.0 } else { speed }
    );
    if family == Family::Loaded {
        let force = dice.decades(-0.3, 0.7) * PRESSURE_UNIT * 2.0 * RADIUS * length * (length / RADIUS).min(1.0);
        let _ = writeln!(text, "[load]\nforce = \"{force} N\"\nangle = \"{minimum} rad\"");
    } else {
        let _ = writeln!(text, "eccentricity = {eccentricity}\nmin_film_angle = \"{minimum} rad\"");
    }
    if family == Family::Squeeze {
        let [radial, tangential] = [0, 1].map(|_| CLEARANCE * SPEED * dice.between(-0.5, 0.5));
        let _ = writeln!(text, "squeeze = {{ radial = \"{radial} m/s\", tangential = \"{tangential} m/s\" }}");
    }
    let _ = writeln!(text, "[oil]\nviscosity = \"{VISCOSITY} Pa.s\"");
    if family == Family::Thickening {
        let greatest = PRESSURE_UNIT * (4.0 + 8.0 * (1.0 - eccentricity).powi(-2));
        let alpha = dice.between(0.05, 0.5) / greatest;
        let _ = match dice.chance(0.5) {
            true => writeln!(text, "barus = {{ alpha = \"{alpha} 1/Pa\" }}"),
            false => writeln!(text, "roelands = {{ z = {} }}", dice.between(0.3, 0.7)),
        };
    }
    if opens {
        let count = 1 + (dice.between(0.0, 2.999) as usize);
        for k in 0..count {
            let sector = span / count as f64;
            let middle = first + sector * (k as f64 + 0.5);
            let as_pocket = family == Family::Pockets && k == 0;
            let round = family == Family::Holes || (mixed && dice.chance(0.5));
            opening(&mut text, &mut dice, k, [middle, sector], length, round, as_pocket, ends);
        }
    }
    Bearing { name, family, model, table: text.parse().expect("TOML") }
}

#[expect(clippy::too_many_arguments, reason = "one opening of the bearing above")]
fn opening(
    text: &mut String,
    dice: &mut Dice,
    k: usize,
    [middle, sector]: [f64; 2],
    length: f64,
    round: bool,
    as_pocket: bool,
    ambient: f64,
) {
    let half_length = 0.5 * length;
    let widest = 0.5 * sector - LAND / RADIUS;
    let mut half_angle = dice.decades(-1.3, -0.2).min(0.8 * widest);
    let mut half_width = dice.between(0.15, 0.9) * (half_length - LAND);
    if round {
        half_width = (half_angle * RADIUS).min(0.7 * (half_length - LAND));
        half_angle = half_width / RADIUS;
    }
    let play = half_length - half_width - LAND;
    let z = if dice.chance(0.5) { 0.0 } else { dice.between(-play, play) };
    let shift = dice.between(-1.0, 1.0) * (widest - half_angle).max(0.0);
    let angle = middle + shift;
    let _ = writeln!(text, "[[feed]]\ngroup = \"opening_{k}\"");
    let _ = match round {
        true => {
            writeln!(text, "hole = {{ diameter = \"{} m\", angle = \"{angle} rad\", z = \"{z} m\" }}", 2.0 * half_width)
        }
        false => {
            let corner = match dice.chance(0.5) {
                true => String::new(),
                false => {
                    let radius = dice.between(0.2, 0.9) * half_width.min(RADIUS * half_angle);
                    format!(", corner = \"{radius} m\"")
                }
            };
            writeln!(
                text,
                "groove = {{ from = \"{} rad\", to = \"{} rad\", width = \"{} m\", z = \"{z} m\"{corner} }}",
                angle - half_angle,
                angle + half_angle,
                2.0 * half_width
            )
        }
    };
    let _ = match as_pocket {
        true => writeln!(text, "depth = \"{} m\"", CLEARANCE * dice.decades(-1.0, 1.0)),
        false => writeln!(text, "pressure = \"{} Pa\"", ambient + PRESSURE_UNIT * dice.decades(-3.0, 0.3)),
    };
}

/// A shipped scene with another position and model, on its mesh or that with straight edges.
fn imported(name: String, number: u64) -> Bearing {
    let mut dice = Dice::new(number * 64 + Family::Imported as u64);
    let meshes = [
        ("02_flexpde_shell", "flexpde_shell.msh"),
        ("02_flexpde_shell", "flexpde_shell_straight.msh"),
        ("04_flexpde_ring", "flexpde_ring_straight.msh"),
        ("05_flexpde_ring_top", "flexpde_ring_top.msh"),
        ("07_grooved_liner", "grooved_liner_straight.msh"),
        ("08_flexpde_study_size", "flexpde_study_size.msh"),
    ];
    let (scene, mesh) = meshes[(number % meshes.len() as u64) as usize];
    let model = model(&mut dice);
    let text = std::fs::read_to_string(path(scene)).expect("shipped scene");
    let mut edited: toml::Table = text.parse().expect("shipped scene is TOML");
    table(&mut edited, "mesh").insert("file".into(), format!("../meshes/{mesh}").into());
    table(&mut edited, "journal").insert("eccentricity".into(), dice.between(0.1, 0.9).into());
    let cavitation = table(&mut edited, "cavitation");
    cavitation.insert("model".into(), model.into());
    cavitation.insert("pressure".into(), "0 Pa".into());
    if dice.chance(0.5) {
        table(&mut edited, "oil").remove("barus");
    }
    Bearing { name: format!("{name} {mesh}"), family: Family::Imported, model, table: edited }
}

/// The shipped scenes as they are; those with a sweep are another one again.
pub fn shipped() -> Vec<Bearing> {
    let folder = path("any").with_file_name("");
    let mut names: Vec<String> = (std::fs::read_dir(folder).expect("scenes").flatten())
        .filter_map(|entry| Some(entry.file_name().to_str()?.strip_suffix(".toml")?.to_owned()))
        .filter(|name| !name.contains("_sweep_"))
        .collect();
    names.sort();
    let one = |name: String| {
        let text = std::fs::read_to_string(path(&name)).expect("shipped scene");
        let table: toml::Table = text.parse().expect("shipped scene is TOML");
        let cavitation = table.get("cavitation").and_then(|cavitation| cavitation.get("model"));
        let model = match cavitation.and_then(toml::Value::as_str) {
            Some("reynolds") => "reynolds",
            Some("jfo") => "jfo",
            Some("guembel") => "guembel",
            _ => "none",
        };
        let family = match (table.contains_key("load"), model) {
            (_, "jfo") => Family::Conserving,
            (true, _) => Family::Loaded,
            _ => Family::Imported,
        };
        Bearing { name, family, model, table }
    };
    names.into_iter().map(one).collect()
}
