//! The temperature of a film: films at one temperature after the other, until friction heats the oil as much as it carries off.
//!
//! The root is sought by quadratic films first, then by those whose numbers are reported. Its bar comes from those of friction and flow
//! through the slope of their balance; all other numbers change with the temperature as the films on the way have shown.

use oilwedge_bearing::thermal_balance::Start;
use oilwedge_bearing::{NoBalance, ThermalBalance, ThermalFlows};
use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::{FilmProblem, FilmSolution, FilmSystem, ReferenceFilm};

use crate::compile_error::CompileError;
use crate::film::Film;
use crate::grading::graded;
use crate::liner_mesh::resized;
use crate::measure::{Measured, measure};
use crate::no_answer::{EndedSearch, NoAnswer, NoTemperature};
use crate::observer::Watch;
use crate::oil::{at_temperature, first_temperature};
use crate::solved::{SolveOptions, Solved};
use oilwedge_scene::Scene;
use oilwedge_scene::wording::celsius;

mod bars;
mod curve;
pub mod flows;
mod search;

pub use curve::{cycle_temperature_report, temperature_report};
pub(crate) use search::Left;
pub use search::solve;
use search::{Kind, ROUGHLY, Search};

/// Edges of the mesh on which the temperature is sought first, over those of the first mesh of the scene,
const COARSE: f64 = 3.0;
/// and its most nodes, if it has coarser ones.
const COARSE_NODES: usize = 2500;

/// System and solution of the film whose numbers are reported.
fn reported(solved: &Solved) -> (&FilmProblem, &FilmSystem, &FilmSolution) {
    let Film { problem, system, .. } = &solved.film;
    match &solved.reference {
        Some(ReferenceFilm::Cubic(cubic)) => (problem, &system.cubic().system, cubic),
        _ => (problem, system, &solved.solution),
    }
}

/// What was measured on it.
fn measured(solved: &Solved) -> Measured {
    let (problem, system, solution) = reported(solved);
    measure(problem, system, solution)
}

/// Why there is no temperature, in words.
pub(crate) fn none(balance: &ThermalBalance, reason: NoBalance<Left>) -> NoAnswer {
    let watts = |film: &ThermalFlows, t: f64| {
        let off = balance.carried(t, film) + balance.given_off(t);
        format!("friction makes {} W, and {} W are carried off", readable(film.power), readable(off))
    };
    let (mut is_unreached, mut ended) = (false, None);
    let told = match reason {
        NoBalance::NoFilm(Left::NoAnswer(reason)) => return reason,
        NoBalance::NoFilm(Left::Ended) => {
            (is_unreached, ended) = (true, Some(EndedSearch { left_over: None }));
            "the search for the temperature was ended".to_owned()
        }
        NoBalance::Ends { temperature, film, reason: Left::Ended } => {
            let left_over = balance.surplus(temperature, &film) / film.power;
            (is_unreached, ended) = (true, Some(EndedSearch { left_over: Some(left_over.abs()) }));
            format!(
                "the search for the temperature was ended: at {} {}",
                celsius(temperature),
                watts(&film, temperature)
            )
        }
        NoBalance::Ends { temperature, film, reason: Left::NoAnswer(reason) } => {
            is_unreached = reason.is_unreached();
            format!(
                "no temperature balances the heat: at {} {}, and there is no film beyond: {reason}",
                celsius(temperature),
                watts(&film, temperature)
            )
        }
        NoBalance::TooHot { temperature, film } => format!(
            "no temperature balances the heat: at {} still {}; feed more oil, or give [heat] housing",
            celsius(temperature),
            watts(&film, temperature)
        ),
    };
    NoAnswer::Temperature(NoTemperature { told, is_unreached, ended })
}

/// The scene with the temperature that a coarse film leads to, where one is sought: for meshes graded for it, and quick searches on them.
///
/// # Errors
/// The scene does not become a film.
pub fn warmed(scene: &Scene, watch: Watch) -> Result<Option<Scene>, CompileError> {
    if scene.inlet_temperature().is_none() {
        return Ok(None);
    }
    let coarse = resized(scene, COARSE).unwrap_or_else(|| scene.clone());
    let mut film = graded(&coarse, watch)?;
    while film.system.coarser.is_some() && film.system.space().dofs() > COARSE_NODES {
        film = film.on_coarser();
    }
    Ok(rough_temperature(&film, watch).map(|temperature| at_temperature(scene, temperature)))
}

fn rough_temperature(film: &Film, watch: Watch) -> Option<f64> {
    let model = film.thermal?;
    let first = film.oil.temperature.unwrap_or(first_temperature(model.balance.inlet));
    let options = SolveOptions { deadline: watch.deadline, observer: watch.observer, ..SolveOptions::default() };
    let found = Search::new(film, model, &options).find(Start::at(first), ROUGHLY, Kind::Leading);
    found.ok().map(|found| found.temperature)
}
