//! The map of where the solver is stable: eccentricity against the coefficient of the viscosity law over its limit, and
//! against slenderness.

use super::map_picture::{CellMap, Outcome};
use serde::Deserialize;
use toml::{Table, Value};

use oilwedge_verification::answer::{CaseAnswer, limit, solve_within, with_law};
use oilwedge_verification::cases::put;
use oilwedge_verification::family::{Expect, LimitedLaw};
use oilwedge_verification::suite::{SuiteError, in_threads};

/// Eccentricities of both maps.
const ECCENTRICITIES: [f64; 12] = [0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.999, 0.9999];
/// Coefficients of the viscosity law over the greatest with a film.
const OF_LIMIT: [f64; 9] = [0.1, 0.5, 0.8, 0.9, 0.99, 1.01, 1.1, 2.0, 10.0];
/// Lengths over diameter.
const SLENDERNESS: [f64; 11] = [0.01, 0.03, 0.1, 0.3, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 100.0];

/// The scene of all cells, Swift-Stieber's film of a ring, the viscosity law with a limit, and the title of its map.
const RECIPE: &str = include_str!("../../../hard_cases/map.toml");

/// Unknowns of a cell at most: films a hundred diameters long, and those near the limit of existence, need many.
pub const MOST_UNKNOWNS: usize = 300_000;

/// Cells of both maps.
pub const CELLS: usize = ECCENTRICITIES.len() * (OF_LIMIT.len() + SLENDERNESS.len());

/// What the cells are made of.
#[derive(Deserialize)]
pub struct Recipe {
    /// Title of the map.
    pub title: String,
    /// The viscosity law with a limit.
    pub limited: LimitedLaw,
    /// The scene of all cells.
    pub scene: Table,
}

/// The recipe of the cells.
///
/// # Panics
/// If the recipe, which is part of the program, is none: a test reads it.
pub fn recipe() -> Recipe {
    toml::from_str(RECIPE).expect("the recipe of the map")
}

/// A column: cells of all rows at one eccentricity.
fn column(place: usize) -> Vec<Outcome> {
    let eccentricity = ECCENTRICITIES[place % ECCENTRICITIES.len()];
    let Recipe { mut scene, limited, .. } = recipe();
    put(&mut scene, "journal.eccentricity", Value::Float(eccentricity));
    match place < ECCENTRICITIES.len() {
        true => match limit(&scene, &limited) {
            Ok(limit) => (OF_LIMIT.iter())
                .map(|&part| {
                    let scene = with_law(&scene, part * limit, &limited);
                    let answer = solve_within(&scene, MOST_UNKNOWNS);
                    cell(&answer, part > 1.0)
                })
                .collect(),
            Err(reason) => vec![Outcome::Unexplained(reason); OF_LIMIT.len()],
        },
        false => (SLENDERNESS.iter())
            .map(|slenderness| {
                put(&mut scene, "bearing.length", Value::String(format!("{} mm", 100.0 * slenderness)));
                cell(&solve_within(&scene, MOST_UNKNOWNS), false)
            })
            .collect(),
    }
}

/// What became of a cell whose film must not exist (`beyond`), or must.
pub fn cell(answer: &CaseAnswer, beyond: bool) -> Outcome {
    match (answer, answer.end(), beyond) {
        (CaseAnswer::Run(run), Expect::Converged, false) => Outcome::Answer(run.result.counts.nonlinear_iterations),
        (_, Expect::NoSolution, true) => Outcome::Absent("no film".to_owned()),
        (_, end, _) => Outcome::Unexplained(end.name().to_owned()),
    }
}

/// Solves all cells, and reports after each column how many cells it has.
///
/// # Errors
/// [`SuiteError::Threads`].
pub fn run_map(ended: &mut dyn FnMut(usize)) -> Result<[CellMap; 2], SuiteError> {
    let columns = 2 * ECCENTRICITIES.len();
    let mut found = in_threads(columns, column, &mut |cells: &Vec<Outcome>| ended(cells.len()))?;
    found.sort_by_key(|(place, _)| *place);
    let mut columns = found.into_iter().map(|(_, cells)| cells);
    let mut map = |title: &str, y: &str, rows: &[f64]| {
        let columns: Vec<Vec<Outcome>> = columns.by_ref().take(ECCENTRICITIES.len()).collect();
        CellMap {
            title: title.to_owned(),
            x: "eccentricity".to_owned(),
            columns: ECCENTRICITIES.iter().map(f64::to_string).collect(),
            y: y.to_owned(),
            rows: rows.iter().map(f64::to_string).collect(),
            cells: (0..rows.len()).map(|row| columns.iter().map(|column| column[row].clone()).collect()).collect(),
        }
    };
    Ok([
        map(&recipe().title, "alpha over its limit", &OF_LIMIT),
        map("From short to long, constant viscosity", "B/D", &SLENDERNESS),
    ])
}

/// Cells of a map without an explanation, in words.
pub fn unexplained(map: &CellMap) -> Vec<String> {
    let mut list = Vec::new();
    for (row, cells) in map.rows.iter().zip(&map.cells) {
        for (column, cell) in map.columns.iter().zip(cells) {
            if let Outcome::Unexplained(word) = cell {
                list.push(format!("{} {column}, {} {row}: {word}", map.x, map.y));
            }
        }
    }
    list
}
