//! The tilted bearings of `tests/data/tilted_bearings.json`, numbers of a second, independent code: scenes of them, and
//! films on structured rings.

use std::path::Path;
use std::sync::Arc;

use oilwedge_reynolds::film_thickness::Tilt;
use oilwedge_reynolds::quantities::load::{Resultant, load};
use oilwedge_reynolds::{FilmProblem, FilmSystem};
use oilwedge_study::result::RunResult;
use oilwedge_study::run_options::RunOptions;
use serde_json::Value;

use crate::program::repository;
use crate::{CLEARANCE, RADIUS};

/// Unit of force `mu omega R^2/psi^2` [N] of the scenes: D 100 mm, c 50 um, mu 20 mPa.s, omega 300 rad/s.
pub const FORCE: f64 = 15e3;
/// Unit of moment, that of force times R [N m].
pub const MOMENT: f64 = 750.0;

/// A block of the reference.
///
/// # Panics
/// If there is none of that name.
pub fn block(name: &str) -> Value {
    let path = repository().join("tests/data/tilted_bearings.json");
    let text = std::fs::read_to_string(path).expect("reference of tilted bearings");
    let data: Value = serde_json::from_str(&text).expect("reference is JSON");
    data.get(name).unwrap_or_else(|| panic!("no block {name}")).clone()
}

/// Rows of a list of the reference.
pub fn rows(list: &Value) -> Vec<Value> {
    list.as_array().cloned().unwrap_or_default()
}

/// Numbers of a list.
///
/// # Panics
/// If it is not one of numbers.
pub fn numbers(list: &Value) -> Vec<f64> {
    let numbers = list.as_array().unwrap_or_else(|| panic!("no list: {list}")).iter();
    numbers.map(|number| number.as_f64().expect("a number")).collect()
}

/// The text of a scene with the bearing of [`FORCE`], of the length `ratio` [diameters]; `keys` are further lines of
/// it: first those of `[journal]`, then other tables.
pub fn scene(ratio: f64, tolerance: &str, keys: &str) -> String {
    format!(
        "bearing = {{ diameter = \"100 mm\", length = \"{} mm\", clearance = \"50 um\" }}\nmesh.tolerance = {tolerance}\n\
         oil.viscosity = \"20 mPa.s\"\ncavitation.model = \"reynolds\"\n[journal]\nspeed = \"300 rad/s\"\n{keys}\n",
        100.0 * ratio
    )
}

/// What a run of a scene finds.
///
/// # Panics
/// If the text is no scene, or has no film.
pub fn run(text: &str) -> RunResult {
    let scene = oilwedge_study::parse(text, Path::new("tilted.toml")).unwrap_or_else(|error| panic!("{error}"));
    oilwedge_study::run(&scene, &RunOptions::of(&scene)).unwrap_or_else(|error| panic!("{error}")).result
}

/// The value of a quantity of a run and its bar.
///
/// # Panics
/// If it has none of that name, or no bar.
pub fn quantity(result: &RunResult, name: &str) -> [f64; 2] {
    let quantity = result.by_name(name).unwrap_or_else(|| panic!("no {name}: {:?}", result.head.reason));
    [quantity.value, quantity.error().unwrap_or_else(|| panic!("no bar of {name}"))]
}

/// The film with this slope of the journal's axis [rad], be it zero.
pub fn tilted(mut problem: FilmProblem, tilt: [f64; 2]) -> FilmProblem {
    problem.film_thickness.push(Arc::new(Tilt { radius: RADIUS }));
    problem.journal.tilt = tilt;
    problem
}

/// A slope [rad] in units of c/R.
pub fn slope(gamma: [f64; 2]) -> [f64; 2] {
    gamma.map(|gamma| gamma * CLEARANCE / RADIUS)
}

/// Force and moment of a film.
///
/// # Panics
/// If there is no film.
pub fn carried(problem: &FilmProblem, system: &Arc<FilmSystem>) -> Resultant {
    let film = problem.solve(system).unwrap_or_else(|reason| panic!("{reason}"));
    load(&film).total.resultant()
}
