//! A row solved, and what its result must hold by itself.

use oilwedge_scene::ShaftScene;
use oilwedge_study::RunOptions;
use oilwedge_study::quantities::Quantity;
use oilwedge_study::result::{Balances, RunResult, Status};
use oilwedge_study::shaft::{ShaftResult, run_shaft};

use super::scene::{Frame, ORBIT_TOLERANCE, written};
use super::{Row, is_turned};

/// Greatest part of a balance that may be left at rest.
const BALANCED: f64 = 1e-6;
/// What steps in time leave of a balance, over the error that a step may make.
const BY_STEPS: f64 = 0.1;
/// Names of a number that only films with this value have, at rest and over a cycle.
const WITNESSES: [(&[&str], [&str; 2]); 3] = [
    (&["contact"], ["contact_thrust", "cycle_contact_share_max"]),
    (&["layer", "ring"], ["deflection_max", "cycle_deflection_max"]),
    (&["heat"], ["temperature_effective", "cycle_temperature"]),
];

fn is_shaft(row: &Row) -> bool {
    row[1].ends_with("shaft")
}

/// The numbers of each bearing of a row, or what is wrong with its result.
///
/// # Errors
/// It does not converge, a balance is not closed, or a value of the row is not in it.
///
/// # Panics
/// No folder for a scene can be made.
pub(super) fn solved(row: &Row, frame: Frame) -> Result<Vec<Vec<Quantity>>, String> {
    let (status, balances, films) = match run(row, frame)? {
        Found::Film(result) => {
            let balances = of_film(&result.balances, row[1] == "orbit");
            ((result.head.status, result.head.reason), balances, vec![result.quantities])
        }
        Found::Shaft(result) => {
            let balances = of_shaft(&result);
            let films = result.bearings.into_iter().map(|bearing| bearing.quantities).collect();
            ((result.head.status, result.head.reason), balances, films)
        }
    };
    if status.0 != Status::Converged {
        return Err(format!("{}: {}", status.0.name(), status.1.unwrap_or_default()));
    }
    if let Some((name, left, most)) =
        balances.into_iter().find(|(_, left, most)| left.abs().is_nan() || left.abs() > *most)
    {
        return Err(format!("{left:e} of {name} is left, not {most:e}"));
    }
    match films.iter().all(|film| has_its_values(row, film)) {
        true => Ok(films),
        false => Err("a value of the row is not in its result".to_owned()),
    }
}

enum Found {
    Film(Box<RunResult>),
    Shaft(Box<ShaftResult>),
}

/// What the library finds, or with which words it refuses.
fn run(row: &Row, frame: Frame) -> Result<Found, String> {
    let folder = tempfile::tempdir().expect("a folder");
    let frame = if is_turned(row) { frame } else { Frame { turn: 0.0, ..frame } };
    let text = written(row, frame, folder.path());
    let path = folder.path().join("scene.toml");
    let options = RunOptions { bars: false, max_seconds: f64::INFINITY, ..RunOptions::default() };
    match is_shaft(row) {
        true => {
            let scene = ShaftScene::parse(&text, &path).map_err(|error| error.to_string())?;
            run_shaft(&scene, &options).map(|run| Found::Shaft(Box::new(run.result))).map_err(|error| error.to_string())
        }
        false => {
            let scene = oilwedge_study::parse(&text, &path).map_err(|error| error.to_string())?;
            oilwedge_study::run(&scene, &options)
                .map(|run| Found::Film(Box::new(run.result)))
                .map_err(|error| error.to_string())
        }
    }
}

/// Name of a balance, what is left of it, and what may be.
type Left = (&'static str, f64, f64);

fn of_film(balances: &Balances, in_time: bool) -> Vec<Left> {
    let by_steps = if in_time { BY_STEPS * ORBIT_TOLERANCE } else { BALANCED };
    vec![
        ("the oil", balances.mass, BALANCED),
        ("the power", balances.power, BALANCED),
        ("the force", balances.force, by_steps),
        ("the tilt", balances.tilt, BALANCED),
        ("the deflection", balances.deflection.unwrap_or_default(), BALANCED),
        ("the heat", balances.thermal, by_steps),
        ("the energy", balances.energy.unwrap_or_default(), by_steps),
    ]
}

fn of_shaft(result: &ShaftResult) -> Vec<Left> {
    let balances = &result.balances;
    let energy = result.bearings.iter().filter_map(|bearing| bearing.energy).fold(0.0, f64::max);
    let by_steps = BY_STEPS * ORBIT_TOLERANCE;
    vec![
        ("the force", balances.force, BALANCED),
        ("the moment", balances.moment, BALANCED),
        ("the journals", balances.journals, BALANCED),
        ("the power", balances.power.unwrap_or_default(), by_steps),
        ("the energy", energy, by_steps),
        ("the heat", balances.thermal, by_steps),
    ]
}

/// Whether a film has the numbers that its values bring, and no others.
fn has_its_values(row: &Row, film: &[Quantity]) -> bool {
    let is_shown = |names: &[&str]| film.iter().any(|number| names.contains(&&*number.name) && number.value > 0.0);
    let is_named = |names: &[&str]| film.iter().any(|number| names.contains(&&*number.name));
    WITNESSES.iter().all(|(values, names)| match values.iter().any(|value| row.contains(value)) {
        true => is_shown(names),
        false => !is_named(names),
    })
}
