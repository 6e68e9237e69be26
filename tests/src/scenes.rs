//! The shipped scenes and variants of them.

use std::path::{Path, PathBuf};

use oilwedge_reynolds::{NoFilm, SolvedFilm};
use oilwedge_scene::{Scene, SceneError};
use oilwedge_study::compile::compile;
use oilwedge_study::film::Film;
use oilwedge_study::measure::{Measured, measure};
use oilwedge_study::quantities::{View, measured};

use crate::program::repository;

/// An axial groove that is fed.
pub const GROOVE: &str = r#"
[[feed]]
group = "groove"
groove = { from = "80 deg", to = "100 deg", width = "40 mm" }
pressure = "0.7 bar"
"#;
/// A hole off the middle that is fed.
pub const HOLE: &str = r#"
[[feed]]
group = "hole"
hole = { diameter = "10 mm", angle = "-40 deg", z = "12 mm" }
pressure = "0.3 bar"
"#;
/// A pocket whose pressure is found.
pub const POCKET: &str = r#"
[[feed]]
group = "pocket"
groove = { from = "150 deg", to = "190 deg", width = "30 mm" }
depth = "60 um"
"#;

/// Path of the scene `NAME.toml` in `scenes/`.
pub fn path(name: &str) -> PathBuf {
    repository().join("scenes").join(format!("{name}.toml"))
}

/// The scene `name` with its text edited as a table.
pub fn variant(name: &str, edit: impl FnOnce(&mut toml::Table)) -> Scene {
    let text = std::fs::read_to_string(path(name)).expect("shipped scene");
    let mut table: toml::Table = text.parse().expect("shipped scene is TOML");
    edit(&mut table);
    oilwedge_study::parse(&table.to_string(), &path(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// The scene that `text` says, as if it lay in `scenes/`.
pub fn written(text: &str) -> Scene {
    oilwedge_study::parse(text, &path("written")).unwrap_or_else(|error| panic!("{error}"))
}

/// A table of the scene, made if absent.
pub fn table<'a>(scene: &'a mut toml::Table, name: &str) -> &'a mut toml::Table {
    scene.entry(name).or_insert_with(|| toml::Table::new().into()).as_table_mut().expect("a table")
}

/// A solved scene.
pub struct Solved {
    /// The compiled scene.
    pub study: Film,
    /// Film of the scene.
    pub film: SolvedFilm,
    /// What was measured.
    pub measured: Measured,
}

impl Solved {
    /// Value of a quantity of the report.
    pub fn quantity(&self, name: &str) -> f64 {
        let list = measured(&View::new(&self.study, &self.study.problem, &self.measured));
        let found = list.iter().find(|quantity| quantity.name == name);
        found.unwrap_or_else(|| panic!("no quantity {name}")).value
    }
}

/// Compiles, solves and measures.
///
/// # Errors
/// The reason why there is no film.
pub fn solve(scene: &Scene) -> Result<Solved, NoFilm> {
    let study = compile(scene).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"));
    let film = study.problem.solve(&study.system)?;
    let measured = measure(&film);
    Ok(Solved { study, film, measured })
}

/// The scene of a text, or its complaints one behind the other.
///
/// # Errors
/// The complaints.
pub fn parsed(text: &str) -> Result<Scene, String> {
    oilwedge_study::parse(text, Path::new("a.toml")).map_err(|error| match error {
        SceneError::Complaints { complaints, .. } => complaints.iter().map(ToString::to_string).collect(),
        other => other.to_string(),
    })
}

/// Quantities whose derivatives are compared with differences of films.
pub const DIFFERENTIATED: [&str; 12] = [
    "load",
    "eccentricity",
    "attitude_angle",
    "tilt_x",
    "film_thickness_min",
    "pressure_max",
    "friction_power",
    "side_flow",
    "temperature_effective",
    "stiffness_xx",
    "damping_xy",
    "critical_mass",
];
