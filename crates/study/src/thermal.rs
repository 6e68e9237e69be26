//! The temperature of a film: films at one temperature after the other, until friction heats the oil as much as it carries off.
//!
//! The root is sought by quadratic films first, then by those whose numbers are reported. Its bar comes from those of friction and flow
//! through the slope of their balance; all other numbers change with the temperature as the films on the way have shown.

use std::borrow::Cow;
use std::collections::HashMap;

use oilwedge_bearing::{Balanced, Deadline, FilmHeat, HeatBalance, NoBalance};
use oilwedge_reynolds::ReferenceFilm;
use oilwedge_reynolds::existence::readable;

use crate::analysis::{NoAnswer, SolveOptions, Solved, graded};
use crate::compile::CompileError;
use crate::film::Film;
use crate::liner_mesh::resized;
use crate::measure::{Measured, measure};
use crate::oil::at_temperature;
use crate::quantities::{FRICTION_POWER, HEAT_CARRIED, HEAT_HOUSING, MOTION_POWER, Quantity, Row};
use oilwedge_scene::wording::celsius;
use oilwedge_scene::{Heat, Scene};

mod bars;
mod curve;
pub(crate) mod film_heat;
mod search;

pub use curve::heat_report;
pub(crate) use film_heat::film_heat;
pub use film_heat::{balance, leaving};
pub use search::solve;
use search::{Kind, Left, ROUGHLY, Search};

/// Edges of the mesh on which the temperature is sought first, over those of the first mesh of the scene.
const COARSE: f64 = 3.0;
/// The film's temperature is first taken to be so much above that of the oil fed [K].
const FIRST_RISE: f64 = 10.0;

/// Temperature [K] at which the search for that of the film begins.
pub fn first_temperature(heat: &Heat) -> f64 {
    heat.inlet + FIRST_RISE
}

/// A temperature found.
#[derive(Debug, Clone, PartialEq)]
pub struct TemperatureFound {
    /// The film there.
    pub balanced: Balanced,
    /// True where the search was ended before the heat was balanced.
    pub is_ended: bool,
    /// How each number changes with the temperature [1/K], by name.
    slopes: HashMap<Cow<'static, str>, f64>,
    /// Seconds that the films at other temperatures took.
    pub seconds: f64,
}

impl TemperatureFound {
    /// Heat that is not carried off, over what heats the film.
    pub fn left_over(&self) -> f64 {
        (self.balanced.surplus / self.balanced.film.power).abs()
    }
}

/// Why there is no temperature.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{told}")]
pub struct NoTemperature {
    told: String,
    /// True if there may be one.
    pub(crate) is_unreached: bool,
}

/// To a tenth of a kelvin [K].
pub(crate) fn rounded(temperature: f64) -> f64 {
    // That of the ice point is a tenth and a twentieth.
    (10.0 * (temperature - 0.05)).round() / 10.0 + 0.05
}

/// Heat of friction and squeeze that is not carried off, relative to it; zero where no temperature was sought.
pub fn left_over(quantities: &[Quantity]) -> f64 {
    let value = |row: &Row| {
        let quantity = quantities.iter().find(|quantity| quantity.row == row);
        quantity.map(|quantity| quantity.value)
    };
    let Some(carried) = value(&HEAT_CARRIED) else {
        return 0.0;
    };
    let part = |row: &Row| value(row).unwrap_or(0.0);
    match part(&FRICTION_POWER) + part(&MOTION_POWER) {
        0.0 => 0.0,
        power => ((power - carried - part(&HEAT_HOUSING)) / power).abs(),
    }
}

/// What was measured on the film whose numbers are reported.
fn measured(solved: &Solved) -> Measured {
    let Film { problem, system, .. } = &solved.film;
    match &solved.reference {
        Some(ReferenceFilm::Cubic(cubic)) => measure(problem, &system.cubic().system, cubic),
        _ => measure(problem, system, &solved.solution),
    }
}

/// Why there is no temperature, in words.
fn none(balance: &HeatBalance, reason: NoBalance<Left>) -> NoAnswer {
    let watts = |film: &FilmHeat, t: f64| {
        let off = balance.carried(t, film) + balance.given_off(t);
        format!(
            "friction makes {} W, and {} W are carried off",
            readable(film.power),
            readable(off)
        )
    };
    let mut is_unreached = false;
    let told = match reason {
        NoBalance::NoFilm(Left::NoAnswer(reason)) => return reason,
        NoBalance::NoFilm(Left::Ended) => {
            is_unreached = true;
            "the search for the temperature was ended; give --max-seconds a higher limit".to_owned()
        }
        NoBalance::Ends {
            temperature,
            film,
            reason,
        } => {
            let why = match reason {
                Left::NoAnswer(reason) => {
                    is_unreached = reason.is_unreached();
                    reason.to_string()
                }
                Left::Ended => {
                    is_unreached = true;
                    "the search was ended".to_owned()
                }
            };
            format!(
                "no temperature balances the heat: at {} {}, and there is no film beyond: {why}",
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
    NoAnswer::Temperature(NoTemperature { told, is_unreached })
}

/// The scene with the temperature that a coarse film leads to, where one is sought: for meshes graded for it, and quick searches on them.
///
/// # Errors
/// The scene does not become a film.
pub fn warmed(scene: &Scene, deadline: Deadline) -> Result<Option<Scene>, CompileError> {
    if scene.heat.is_none() {
        return Ok(None);
    }
    let coarse = resized(scene, COARSE).unwrap_or_else(|| scene.clone());
    let film = graded(&coarse, deadline)?;
    Ok(rough_temperature(&film, deadline).map(|temperature| at_temperature(scene, temperature)))
}

fn rough_temperature(film: &Film, deadline: Deadline) -> Option<f64> {
    let heat = film.scene.heat?;
    let first = film.oil.temperature.unwrap_or(first_temperature(&heat));
    let options = SolveOptions {
        deadline,
        ..SolveOptions::default()
    };
    let found = Search::new(film, heat, &options).find(first, ROUGHLY, Kind::Chosen);
    found.ok().map(|found| found.temperature)
}
