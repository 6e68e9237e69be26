//! A film whose temperatures are found across it: from the coarser meshes on, on each round by round.

use std::sync::Arc;

use oilwedge_bearing::film_heat::FilmHeat;
use oilwedge_bearing::heat_round::NoRound;
use oilwedge_bearing::thermal_film::{HeatRound, HeatSearch, NoHeat, balance_heat};
use oilwedge_bearing::{InitialGuess, graetz_number};
use oilwedge_heat::{BushSide, Layers};
use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::quantities::heat_network::EddySources;
use oilwedge_reynolds::solve::Neighbour;

use super::heating::Heating;
use crate::film::Film;
use crate::isothermal::{heated, isothermal};
use crate::no_answer::{NoAnswer, NoTemperature};
use crate::solved::{Errors, SolveOptions, Solved};
use crate::thermal_model::HeatFieldModel;

/// Temperatures are found where those of the next round differ by no more than this [K].
const CLOSED: f64 = 5e-4;
/// On coarser meshes, which only give a start, this is enough [K].
const ROUGHLY_CLOSED: f64 = 0.05;
/// Dofs below which a coarser mesh shows nothing of the temperatures.
const LEAST_DOFS: usize = 1000;
/// Force and load of films of a round differ by this part of the load, for each kelvin of the change before.
const PER_KELVIN: f64 = 2e-3;
/// Least such part.
const BALANCED: f64 = 1e-8;
/// Greatest such part.
const ROUGHLY_BALANCED: f64 = 1e-3;
/// A film of N layers follows Graetz numbers up to this part of N^4 well.
const WELL: f64 = 0.5;
/// Layers that there may be.
const LAYERS: [usize; 3] = [4, 6, 8];
/// Fewest layers beside a bush that takes no heat: with fewer the oil at a hot rim is 9 to 13 K too hot there.
const BESIDE_ADIABATIC: usize = 6;

/// Layers of a turbulent film: steps, of which it takes more than a polynomial has terms.
const OF_TURBULENT: usize = 8;

/// Solves a film with the temperatures that balance its heat.
///
/// # Errors
/// [`NoAnswer`]: there is no film, no position, or no such temperatures.
pub(crate) fn solve(film: &Film, model: &HeatFieldModel, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let (last, heat) = on_levels(film, model, options, CLOSED)?;
    let film = last.film.at_temperature(heat.mean());
    let guess = InitialGuess::Near(Neighbour::Start(&last.primary));
    let mut solved = isothermal(&film, &SolveOptions { guess, ..*options })?;
    let viscosity = |temperature: f64| film.viscosity_at(temperature);
    let network = model.surroundings.network(&solved.primary);
    let heat = network.and_then(|network| heat.balanced_on(&model.surroundings, network, &viscosity));
    solved.film.heat = Some(Arc::new(heat.map_err(NoHeat::from).map_err(none)?));
    Ok(super::field_bars::widened(solved, model, options))
}

/// The film of the last round, and its temperatures: from those on the coarser mesh, if there is one.
fn on_levels(
    film: &Film,
    model: &HeatFieldModel,
    options: &SolveOptions,
    closed: f64,
) -> Result<(Solved, FilmHeat), NoAnswer> {
    let coarser = film.system.coarser.as_ref().filter(|coarser| coarser.system.space().dofs() >= LEAST_DOFS);
    let start = coarser.and_then(|coarser| {
        let (last, heat) = on_levels(&film.on_coarser(), model, options, ROUGHLY_CLOSED).ok()?;
        let at_dofs = coarser.prolonged(&heat.at_dofs, heat.layers.points.len());
        let near = film.with_clearance(film.problem.bearing.clearance + heat.growth).as_found(&last.film.problem);
        let leading = SolveOptions { guess: InitialGuess::NearlyBalanced, ..leading(options) };
        Some((isothermal(&near, &leading).ok()?, at_dofs, heat.growth, heat.layers))
    });
    let (first, at_dofs, growth, layers) = match start {
        Some(start) => start,
        None => {
            let first = of_one_temperature(film, model, options)?;
            let layers = layers(&first.primary, model)?;
            let temperature = first.film.oil.temperature.unwrap_or(model.surroundings.inlet);
            let at_dofs = vec![temperature; film.system.space().dofs() * layers.points.len()];
            (first, at_dofs, 0.0, layers)
        }
    };
    let search = HeatSearch {
        layers: &layers,
        start: at_dofs,
        eddies: EddySources::of(&first.primary),
        growth,
        closed,
        clearance: film.problem.bearing.clearance,
    };
    balanced((film, first), model, options, search)
}

/// The film of the last round from a `first` one, and its temperatures.
fn balanced(
    (film, first): (&Film, Solved),
    model: &HeatFieldModel,
    options: &SolveOptions,
    search: HeatSearch<'_>,
) -> Result<(Solved, FilmHeat), NoAnswer> {
    let base = first.film.oil.temperature.map_or(film.clone(), |temperature| film.at_temperature(temperature));
    let mut last = first;
    let viscosity = |temperature: f64| base.viscosity_at(temperature);
    let round = |round: &HeatRound| {
        if options.deadline.is_over() {
            return Err(NoAnswer::Temperature(NoTemperature::Ended { nearest: None }));
        }
        let near = last.film.in_round(&base, round);
        let accuracy = Some((PER_KELVIN * round.change).clamp(BALANCED, ROUGHLY_BALANCED));
        let guess = InitialGuess::Near(Neighbour::Start(&last.primary));
        let leading = SolveOptions { accuracy, guess, ..leading(options) };
        let cold = || isothermal(&near, &SolveOptions { guess: InitialGuess::Cold, ..leading });
        let solved = isothermal(&near, &leading).or_else(|_| cold())?;
        let found = model.surroundings.network(&solved.primary);
        last = solved;
        found.map_err(NoHeat::from).map_err(none)
    };
    let space = film.system.space();
    let found = balance_heat(&model.surroundings, space, search, &viscosity, round).map_err(none)?;
    Ok((last, found))
}

/// How films that only lead to the temperatures are solved.
fn leading<'a>(options: &SolveOptions<'a>) -> SolveOptions<'a> {
    SolveOptions { accuracy: Some(ROUGHLY_BALANCED), errors: Errors::Omitted, guess: InitialGuess::Cold, ..*options }
}

/// The film of one temperature with which rounds begin: that which balances the heat or, where there is none, the one
/// that the oil has.
fn of_one_temperature(film: &Film, model: &HeatFieldModel, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let leading = leading(options);
    heated(film, &Heating::with(film, model.even), &leading).or_else(|_| isothermal(film, &leading))
}

/// The points across a film that the model gives, or that its Graetz number asks for.
pub(crate) fn layers(film: &SolvedFilm, model: &HeatFieldModel) -> Result<Layers, NoAnswer> {
    if !film.problem.is_laminar() {
        let count = model.layers.as_ref().map_or(OF_TURBULENT, Layers::count);
        return Ok(Layers::linear(count).expect("a number that laminar films have too"));
    }
    if let Some(layers) = &model.layers {
        return Ok(layers.clone());
    }
    let network = model.surroundings.network(film).map_err(NoHeat::from).map_err(none)?;
    let graetz = graetz_number(film, &network, &model.surroundings.oil);
    let fewest = if model.surroundings.bush == BushSide::Adiabatic { BESIDE_ADIABATIC } else { LAYERS[0] };
    let enough = LAYERS.into_iter().filter(|layers| *layers >= fewest);
    let follows = |part: f64| enough.clone().find(|&layers| graetz <= part * (layers as f64).powi(4));
    let layers = follows(WELL).or(follows(1.0)).and_then(Layers::new);
    layers.ok_or(NoAnswer::Temperature(NoTemperature::Graetz { graetz }))
}

impl Film {
    /// Viscosity of the oil at a temperature [K], in Pa s.
    pub(crate) fn viscosity_at(&self, temperature: f64) -> f64 {
        self.oil.thermal.as_ref().map_or(self.oil.viscosity, |thermal| thermal.viscosity(temperature))
    }

    /// The film of a round: that of `base` with the viscosity and the clearance of the round, the journal of this one.
    fn in_round(&self, base: &Self, round: &HeatRound) -> Self {
        let clearance = base.problem.bearing.clearance + round.growth;
        let mut film = base.with_clearance(clearance).as_found(&self.problem);
        film.problem.viscosity_across = Some(round.across.clone());
        film
    }
}

/// Why there is no answer, by the reason why no temperatures were found.
pub(crate) fn none(reason: NoHeat<NoAnswer>) -> NoAnswer {
    match reason {
        NoHeat::NoFilm(reason) => reason,
        NoHeat::NoRound(NoRound::TooLarge(reason)) => {
            NoAnswer::Film(oilwedge_fem::newton::NewtonFailure::from(reason).into())
        }
        NoHeat::NoRound(reason) => NoAnswer::Temperature(NoTemperature::NoRound(reason)),
        NoHeat::NotClosed { change, rounds } => NoAnswer::Temperature(NoTemperature::NotClosed { change, rounds }),
    }
}
