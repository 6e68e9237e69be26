//! The temperature of a film: films at one temperature after the other, until friction heats the oil as much as it
//! carries off.
//!
//! The root is sought by quadratic films first, then by those whose numbers are reported. Its bar comes from those of
//! friction and flow through the slope of their balance; all other numbers change with the temperature as the films on
//! the way have shown.

use oilwedge_bearing::thermal_balance::Start;
use oilwedge_bearing::{NoBalance, ThermalBalance, ThermalFlows};

use crate::compile_error::CompileError;
use crate::film::Film;
use crate::grading::graded;
use crate::liner_mesh::resized;
use crate::no_answer::{NoAnswer, NoTemperature, PowersAt};
use crate::observer::Watch;
use crate::oil::{at_temperature, first_temperature};
use crate::solved::SolveOptions;
use oilwedge_scene::Scene;

mod bars;
mod curve;
pub mod flows;
mod search;

pub use curve::{cycle_temperature_report, temperature_report};
pub(crate) use search::Left;
pub use search::solve;
pub(crate) use search::work_of;
use search::{Kind, ROUGHLY, Search};

/// Edges of the mesh on which the temperature is sought first, over those of the first mesh of the scene.
const COARSE: f64 = 3.0;
/// Most nodes of that mesh, if it has coarser ones.
const COARSE_NODES: usize = 2500;

/// Why there is no temperature.
pub(crate) fn none(balance: &ThermalBalance, reason: NoBalance<Left>) -> NoAnswer {
    let powers = |temperature: f64, film: &ThermalFlows| PowersAt {
        temperature,
        friction: film.power,
        carried_off: balance.carried(temperature, film) + balance.given_off(temperature),
    };
    NoAnswer::Temperature(match reason {
        NoBalance::NoFilm(Left::NoAnswer(reason)) => return reason,
        NoBalance::NoFilm(Left::Ended) => NoTemperature::Ended { nearest: None },
        NoBalance::Ends { temperature, film, reason: Left::Ended } => {
            NoTemperature::Ended { nearest: Some(powers(temperature, &film)) }
        }
        NoBalance::Ends { temperature, film, reason: Left::NoAnswer(reason) } => {
            NoTemperature::NoFilmBeyond { last: powers(temperature, &film), reason: Box::new(reason) }
        }
        NoBalance::TooHot { temperature, film } => NoTemperature::TooHot { hottest: powers(temperature, &film) },
    })
}

/// The scene with the temperature that a coarse film leads to, where one is sought: for meshes graded for it, and quick
/// searches on them.
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
