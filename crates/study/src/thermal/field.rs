//! A film whose temperatures are found across it: from the film of one temperature, round by round.

use std::sync::Arc;

use oilwedge_bearing::InitialGuess;
use oilwedge_bearing::heat_round::NoRound;
use oilwedge_bearing::thermal_film::{HeatRound, NoHeat, balance_heat};
use oilwedge_reynolds::solve::Neighbour;

use super::heating::Heating;
use crate::film::Film;
use crate::isothermal::{heated, isothermal};
use crate::no_answer::{NoAnswer, NoTemperature};
use crate::solved::{Errors, SolveOptions, Solved};
use crate::thermal_model::HeatFieldModel;

/// Force and load of films of a round differ by this part of the load, for each kelvin of the change before.
const PER_KELVIN: f64 = 1e-4;
/// Least such part.
const BALANCED: f64 = 1e-10;
/// Greatest such part.
const ROUGHLY_BALANCED: f64 = 1e-5;

/// Solves a film with the temperatures that balance its heat.
///
/// # Errors
/// [`NoAnswer`]: there is no film, no position, or no such temperatures.
pub(crate) fn solve(film: &Film, model: &HeatFieldModel, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let first = of_one_temperature(film, model, options)?;
    let mut last = first;
    let base = last.film.clone();
    let start = base.oil.temperature.unwrap_or(model.surroundings.inlet);
    let viscosity = |temperature: f64| match &base.oil.thermal {
        Some(thermal) => thermal.viscosity(temperature),
        None => base.oil.viscosity,
    };
    let space = base.system.space();
    let round = |round: &HeatRound| {
        let near = last.film.in_round(&base, round);
        let accuracy = (PER_KELVIN * round.change).clamp(BALANCED, ROUGHLY_BALANCED);
        let guess = InitialGuess::Near(Neighbour::Start(&last.primary));
        let leading = SolveOptions { accuracy: Some(accuracy), errors: Errors::Omitted, guess, ..*options };
        let solved = isothermal(&near, &leading)
            .or_else(|_| isothermal(&near, &SolveOptions { guess: InitialGuess::Cold, ..leading }))?;
        let found = solved.primary.clone();
        last = solved;
        Ok(found)
    };
    let found = balance_heat(&model.surroundings, (space, &model.layers), start, &viscosity, round);
    let found = found.map_err(none)?;
    let mean = last.film.at_temperature(found.mean());
    let film = Film { heat: Some(Arc::new(found)), ..mean };
    let guess = InitialGuess::Near(Neighbour::Start(&last.primary));
    let solved = isothermal(&film, &SolveOptions { guess, ..*options })?;
    Ok(solved)
}

/// The film of one temperature with which rounds begin: that which balances the heat or, where there is none, the one
/// that the oil has.
fn of_one_temperature(film: &Film, model: &HeatFieldModel, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let leading = SolveOptions { accuracy: Some(ROUGHLY_BALANCED), errors: Errors::Omitted, ..*options };
    heated(film, &Heating::with(film, model.even), &leading).or_else(|_| isothermal(film, &leading))
}

impl Film {
    /// The film of a round: that of `base` with the viscosity and the clearance of the round, the journal of this one.
    fn in_round(&self, base: &Self, round: &HeatRound) -> Self {
        let mut film = base.with_clearance(base.problem.bearing.clearance + round.growth);
        film.problem.journal = self.problem.journal;
        film.problem = film.problem.deflected(self.problem.deflection());
        film.problem.viscosity_across = Some(round.across.clone());
        film
    }
}

fn none(reason: NoHeat<NoAnswer>) -> NoAnswer {
    match reason {
        NoHeat::NoFilm(reason) => reason,
        NoHeat::NoRound(NoRound::TooLarge(reason)) => {
            NoAnswer::Film(oilwedge_fem::newton::Failure::from(reason).into())
        }
        NoHeat::NoRound(reason) => NoAnswer::Temperature(NoTemperature::NoRound(reason)),
        NoHeat::NotClosed { change, rounds } => NoAnswer::Temperature(NoTemperature::NotClosed { change, rounds }),
    }
}
