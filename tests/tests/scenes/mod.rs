//! Every shipped scene against a number from elsewhere, and relations between scenes.
//!
//! Two kinds of source. *Same mesh*: scikit-fem (`tests/crosscheck/film.py`, quadrature of degree 8) solves the same
//! discrete problem, so the values agree to 1e-9. *Converged*: the recomputation of the FlexPDE study with scikit-fem
//! on a far finer mesh, C_w and angle to four decimals (`tests/crosscheck/test_reference_numbers.py`); 5e-5 of C_w is
//! twice what the shipped meshes are off.

mod agree;
mod shipped;

use oilwedge_scene::Scene;
use oilwedge_study::result::RunResult;
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::scenes::{Solved, solve, table, variant};

fn shipped(name: &str) -> Solved {
    solved(name, |_| ())
}

fn solved(name: &str, edit: impl FnOnce(&mut toml::Table)) -> Solved {
    solve(&variant(name, edit)).unwrap_or_else(|reason| panic!("{name}: {reason}"))
}

/// Sets the key `key` of the table `of`.
fn set(scene: &mut toml::Table, of: &str, key: &str, value: impl Into<toml::Value>) {
    table(scene, of).insert(key.into(), value.into());
}

fn on_mesh(scene: &mut toml::Table, name: &str) {
    set(scene, "mesh", "file", format!("../meshes/{name}.msh"));
}

#[track_caller]
fn close(value: f64, expected: f64, relative: f64) {
    let error = (value / expected - 1.0).abs();
    assert!(error < relative, "{value} is {error:.1e} off {expected}");
}

/// Load coefficient and attitude angle [deg] of a converged recomputation.
#[track_caller]
fn converged(name: &str, load_coefficient: f64, attitude: f64, relative: f64) {
    let film = shipped(name);
    close(film.quantity("load_coefficient"), load_coefficient, relative);
    let error = film.quantity("attitude_angle") - attitude;
    assert!(error.abs() < 100.0 * relative, "{name}: attitude off by {error:.1e} deg");
}

/// Load [N] or load coefficient and attitude angle [deg] that scikit-fem finds on the same mesh.
#[track_caller]
fn same_mesh(name: &str, quantity: &str, value: f64, attitude: f64) {
    let film = shipped(name);
    close(film.quantity(quantity), value, 1e-9);
    close(film.quantity("attitude_angle"), attitude, 1e-7);
}

fn answer(scene: &Scene) -> RunResult {
    let run = run(scene, &RunOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(run.result.head.reason, None);
    run.result
}

fn value(result: &RunResult, name: &str) -> f64 {
    result.by_name(name).unwrap_or_else(|| panic!("no {name}")).value
}
