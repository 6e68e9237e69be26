//! One temperature for a cycle: films take up the mean power of the cycle, and its mean flow carries the heat off.
//!
//! The temperature is first found on a coarser mesh; the mesh of the result is made for the viscosity at that
//! temperature. On it the balance is found again, each orbit begun where the one before had closed.

use std::sync::Arc;

use oilwedge_bearing::duty_cycle::DutyCycle;
use oilwedge_bearing::orbit::{NoOrbit, OrbitEnd};
use oilwedge_bearing::{NoThermalBalance, ThermalFlows};
use oilwedge_reynolds::error_bar::Bar;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_scene::OrbitTable;

use super::{FollowedCycle, OrbitSeries, expected_seconds, start};
use crate::compile_error::CompileError;
use crate::film::Film;
use crate::model::Model;
use crate::no_answer::NoAnswer;
use crate::observer::Watch;
use crate::quantities::{
    CYCLE_COOLING_FLOW, CYCLE_POWER_LOSS, CYCLE_TEMPERATURE, CYCLE_TEMPERATURE_OUTLET, Quantity, Row,
};
use crate::run_options::RunOptions;
use crate::thermal::{FilmTemperature, SearchStop, none};
use crate::thermal_model::ThermalModel;

/// Heat that is left over where the heat of a cycle is balanced, over the mean power and the tolerance of the orbit.
pub(crate) const BALANCED: f64 = 0.1;
/// Heat that is left over where it is balanced on the coarser mesh, over the power; orbits there have the tolerance
/// behind it.
const ROUGHLY: f64 = 1e-2;
const ROUGH_TOLERANCE: f64 = 1e-2;

/// What the balance of a cycle has found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CycleTemperature {
    /// How heat is balanced, and what the bearing must meet.
    pub(crate) model: ThermalModel,
    /// Heat that is not carried off, over the mean power [1].
    pub(crate) left_over: f64,
    /// Temperatures that were tried on the mesh of the result.
    pub(crate) steps: usize,
}

/// Follows the orbit at the temperature that balances its heat.
///
/// # Errors
/// The scene does not become a film.
pub(super) fn balanced(
    (model, orbit, cycle): (&Arc<Model>, &OrbitTable, &DutyCycle),
    thermal: ThermalModel,
    watch: Watch,
    options: &RunOptions,
) -> Result<(Film, Result<FollowedCycle, NoAnswer>), CompileError> {
    let quick = RunOptions { bars: false, frames: 0, earlier: None, ..*options };
    let (film, begin) = start::prepared(model, &model.oil, (orbit, cycle), watch)?;
    let mut search = FilmTemperature::of(&film, thermal);
    let rough = OrbitTable { tolerance: ROUGH_TOLERANCE.max(orbit.tolerance), ..*orbit };
    let orbits = |film, begin, orbit| OrbitSeries { film, orbit, cycle, watch, options: quick, begin, last: None };
    let found = orbits(film.on_coarser(), begin, rough).balance(&mut search, ROUGHLY);
    if let Err(reason) = found {
        return Ok((film, Err(reason)));
    }
    let oil = model.oil_at(Some(search.temperature));
    let (film, begin) = start::prepared(model, &oil, (orbit, cycle), watch)?;
    if let Some(observer) = options.observer {
        observer.expects(film.unknowns(), expected_seconds(&film));
        observer.turns_to("the orbits at one temperature after the other");
    }
    search.begun_again();
    let mut orbits = orbits(film, begin, *orbit);
    let outcome = orbits.balance(&mut search, BALANCED * orbit.tolerance);
    let outcome = outcome.and_then(|()| orbits.reported(&mut search, options));
    Ok((orbits.film.at_temperature(search.temperature), outcome))
}

impl OrbitSeries<'_> {
    /// Finds the temperature at which no more than the part `accuracy` of the heat is left over.
    fn balance(&mut self, search: &mut FilmTemperature, accuracy: f64) -> Result<(), NoAnswer> {
        loop {
            match self.add(search) {
                Ok(left) if left < accuracy => return Ok(()),
                Ok(_) => search.turn()?,
                Err(SearchStop::NoAnswer(_)) if search.retreat() => {}
                Err(SearchStop::NoAnswer(reason)) => return Err(search.without_film(reason)),
                Err(SearchStop::Ended) => {
                    return Err(none(&search.model.balance, NoThermalBalance::NoFilm(SearchStop::Ended)));
                }
            }
        }
    }

    /// Adds the orbit at the temperature asked for; the heat that is left over, as a part of the power [1].
    fn add(&mut self, search: &mut FilmTemperature) -> Result<f64, SearchStop> {
        if self.watch.deadline.is_over() {
            return Err(SearchStop::Ended);
        }
        if let Some(observer) = self.options.observer {
            observer.temperature(search.runs() + 1, search.temperature - ZERO_CELSIUS);
        }
        let found =
            self.followed(&self.film.at_temperature(search.temperature), &self.options).map_err(
                |reason| match reason {
                    NoAnswer::Orbit(NoOrbit::Ended { .. }) => SearchStop::Ended,
                    reason => SearchStop::NoAnswer(reason),
                },
            )?;
        if found.end == OrbitEnd::Ended {
            return Err(SearchStop::Ended);
        }
        self.last = found.last;
        Ok(search.add(found.flows.ok_or(SearchStop::Ended)?, found.quantities))
    }

    /// The orbit at the temperature found, with the numbers of the balance.
    fn reported(&mut self, search: &mut FilmTemperature, options: &RunOptions) -> Result<FollowedCycle, NoAnswer> {
        if options.bars && !search.has_slopes() {
            // A second orbit, for the change with temperature; without it the numbers have no bars.
            search.step_aside(1.0);
            drop(self.add(search));
            search.step_aside(-1.0);
        }
        let mut orbit = self.followed(&self.film.at_temperature(search.temperature), options)?;
        if let Some(flows) = orbit.flows {
            add_temperature(search, flows, options.bars, &mut orbit);
        }
        Ok(orbit)
    }
}

/// Adds the numbers of the balance to those of an orbit at the temperature found, and what the bar of the temperature
/// makes of all others.
pub(crate) fn add_temperature(search: &FilmTemperature, flows: ThermalFlows, bars: bool, orbit: &mut FollowedCycle) {
    let (balance, temperature) = (&search.model.balance, search.temperature);
    let [_, outlet] = balance.ends(temperature, flows.carried_over);
    let numbers = [(&CYCLE_TEMPERATURE, temperature), (&CYCLE_TEMPERATURE_OUTLET, outlet)];
    orbit.quantities.extend(numbers.map(|(row, kelvin)| Quantity::new(row, kelvin - ZERO_CELSIUS)));
    if bars && widen(search, flows, &mut orbit.quantities).is_none() {
        orbit.quantities.iter_mut().for_each(|quantity| quantity.set_bar(None));
    }
    let left_over = (balance.surplus(temperature, &flows) / flows.power).abs();
    orbit.temperature = Some(CycleTemperature { model: search.model, left_over, steps: search.runs() });
}

/// Gives the numbers of the balance their bars, and adds to all others what the bar of the temperature makes of them.
/// None where that bar is not known.
fn widen(search: &FilmTemperature, flows: ThermalFlows, quantities: &mut [Quantity]) -> Option<()> {
    search.has_slopes().then_some(())?;
    let (slopes, balanced, balance) = (search.slopes(), search.balanced(flows), &search.model.balance);
    let carried = balance.carried(search.temperature, &flows);
    let error = |row: &Row| quantities.iter().find(|quantity| quantity.row == row)?.error();
    let (power, flow) = error(&CYCLE_POWER_LOSS).zip(error(&CYCLE_COOLING_FLOW))?;
    let bar = (power + carried.abs() * flow / flows.flow + balanced.surplus.abs()) / balanced.slope.abs();
    let outlet = |kelvin: f64| balance.ends(search.temperature + kelvin, flows.carried_over)[1];
    let per_kelvin = outlet(1.0) - outlet(0.0);
    for quantity in quantities {
        let by_temperature = |per_kelvin: f64| Bar { temperature: bar * per_kelvin.abs(), ..Bar::default() };
        let widened = match quantity.row {
            row if row == &CYCLE_TEMPERATURE => Some(by_temperature(1.0)),
            row if row == &CYCLE_TEMPERATURE_OUTLET => Some(by_temperature(per_kelvin)),
            _ => (quantity.bar.zip(slopes.get(&quantity.name))).map(|(own, slope)| own + by_temperature(*slope)),
        };
        quantity.set_bar(widened);
    }
    Some(())
}
