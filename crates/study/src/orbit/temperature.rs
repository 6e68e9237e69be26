//! One temperature for a cycle: films take up the mean power of the cycle, and its mean flow carries the heat off.
//!
//! The temperature is first found on a coarser mesh; the mesh of the result is made for the viscosity at that
//! temperature. On it the balance is solved again, each orbit begun where the one before had closed.

use std::borrow::Cow;
use std::collections::HashMap;

use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::duty_cycle::DutyCycle;
use oilwedge_bearing::orbit::{NoOrbit, OrbitEnd};
use oilwedge_bearing::thermal_balance::{Start, find};
use oilwedge_bearing::{Balanced, Deadline, NoBalance, ThermalFlows};
use oilwedge_reynolds::error_bar::Bar;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_scene::{Orbit, Scene};

use super::{Followed, expected_seconds, followed, start};
use crate::compile::at_temperature;
use crate::compile_error::CompileError;
use crate::film::Film;
use crate::no_answer::NoAnswer;
use crate::observer::Watch;
use crate::oil;
use crate::quantities::{
    CYCLE_COOLING_FLOW, CYCLE_POWER_LOSS, CYCLE_TEMPERATURE, CYCLE_TEMPERATURE_OUTLET, Quantity, Row,
};
use crate::run_options::RunOptions;
use crate::thermal::{Left, none};
use crate::thermal_model::ThermalModel;

/// Heat that is left over where the heat of a cycle is balanced, over the mean power and the tolerance of the orbit.
const BALANCED: f64 = 0.1;
/// Heat that is left over where it is balanced on the coarser mesh, over the power; orbits there have the tolerance
/// behind it.
const ROUGHLY: f64 = 1e-2;
const ROUGH_TOLERANCE: f64 = 1e-2;
/// Least distance [K] of orbits that show how numbers change with temperature.
const APART: f64 = 0.02;
/// Distance [K] at which a further orbit is followed where the others are too near.
const FURTHER: f64 = 1.0;

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

/// An orbit at one temperature, without bars.
struct Tried {
    temperature: f64,
    surplus: f64,
    quantities: Vec<Quantity>,
}

/// Orbits at one temperature after the other.
struct Search<'a> {
    scene: &'a Scene,
    model: Orbit,
    thermal: ThermalModel,
    cycle: &'a DutyCycle,
    film: Film,
    begin: Vector,
    deadline: Deadline,
    options: RunOptions,
    tried: Vec<Tried>,
}

/// Follows the orbit at the temperature that balances its heat.
///
/// # Errors
/// The scene does not become a film.
pub(super) fn balanced(
    (scene, model, cycle): (&Scene, &Orbit, &DutyCycle),
    thermal: ThermalModel,
    watch: Watch,
    options: &RunOptions,
) -> Result<(Film, Result<Followed, NoAnswer>), CompileError> {
    let quick = RunOptions { bars: false, frames: 0, earlier: None, ..*options };
    let search = |film: Film, begin: Vector, model: Orbit| Search {
        scene,
        model,
        thermal,
        cycle,
        film,
        begin,
        deadline: watch.deadline,
        options: quick,
        tried: Vec::new(),
    };
    let first = oil::first_temperature(thermal.balance.inlet);
    let (film, begin) = start::prepared(scene, model, cycle, watch)?;
    let rough_model = Orbit { tolerance: ROUGH_TOLERANCE.max(model.tolerance), ..*model };
    let mut rough = search(film.clone().on_coarser(), begin, rough_model);
    let found = match rough.find(Start::at(first), ROUGHLY) {
        Ok(found) => found,
        Err(reason) => return Ok((film, Err(none(&thermal.balance, reason)))),
    };
    let (film, begin) = start::prepared(&oil::at_temperature(scene, found.temperature), model, cycle, watch)?;
    if let Some(observer) = options.observer {
        observer.expects(film.unknowns(), expected_seconds(&film));
        observer.turns_to("the orbits at one temperature after the other");
    }
    let mut fine = search(film, begin, *model);
    let near = Start { temperature: found.temperature, slope: Some(found.slope).filter(|slope| *slope < 0.0) };
    let found = match fine.find(near, BALANCED * model.tolerance) {
        Ok(found) => found,
        Err(reason) => return Ok((fine.film, Err(none(&thermal.balance, reason)))),
    };
    let film = at_temperature(&fine.film, found.temperature);
    let outcome = fine.reported(&film, found, options);
    Ok((film, outcome))
}

impl Search<'_> {
    fn find(&mut self, start: Start, accuracy: f64) -> Result<Balanced, NoBalance<Left>> {
        let balance = self.thermal.balance;
        let slope = start.slope.or_else(|| self.slope_near(start.temperature));
        find(&balance, Start { slope, ..start }, accuracy, |temperature| self.at(temperature))
    }

    /// How the surplus changes with the temperature [W/K], by two orbits.
    fn slope_near(&mut self, temperature: f64) -> Option<f64> {
        let surplus = [temperature, temperature + FURTHER].map(|t| {
            let flows = self.at(t).ok()?;
            Some(self.thermal.balance.surplus(t, &flows))
        });
        let [here, there] = surplus;
        Some((there? - here?) / FURTHER)
    }

    /// The mean flows of the orbit at a temperature [K].
    fn at(&mut self, temperature: f64) -> Result<ThermalFlows, Left> {
        if self.deadline.is_over() {
            return Err(Left::Ended);
        }
        let film = at_temperature(&self.film, temperature);
        if let Some(observer) = self.options.observer {
            observer.temperature(self.tried.len() + 1, temperature - ZERO_CELSIUS);
        }
        let found = followed(&film, (self.scene, &self.model, self.cycle), (self.begin, self.deadline), &self.options);
        let found = found.map_err(|reason| match reason {
            NoAnswer::Orbit(NoOrbit::Ended { .. }) => Left::Ended,
            reason => Left::NoAnswer(reason),
        })?;
        if found.end == OrbitEnd::Ended {
            return Err(Left::Ended);
        }
        self.begin = found.begin;
        let flows = found.flows.ok_or(Left::Ended)?;
        self.tried.push(Tried {
            temperature,
            surplus: self.thermal.balance.surplus(temperature, &flows),
            quantities: found.quantities,
        });
        Ok(flows)
    }

    /// The orbit at the temperature found, with the numbers of the balance.
    fn reported(&mut self, film: &Film, found: Balanced, options: &RunOptions) -> Result<Followed, NoAnswer> {
        if options.bars && self.nearest(found.temperature).is_none() {
            // A second orbit, for the change with temperature; without it the numbers have no bars.
            drop(self.at(found.temperature + FURTHER));
        }
        let mut orbit = followed(film, (self.scene, &self.model, self.cycle), (self.begin, self.deadline), options)?;
        let flows = orbit.flows.unwrap_or(found.film);
        let balance = &self.thermal.balance;
        let surplus = balance.surplus(found.temperature, &flows);
        let [_, outlet] = balance.ends(found.temperature, flows.carried_over);
        let balanced = [
            (&CYCLE_TEMPERATURE, found.temperature - ZERO_CELSIUS),
            (&CYCLE_TEMPERATURE_OUTLET, outlet - ZERO_CELSIUS),
        ];
        orbit.quantities.extend(balanced.map(|(row, value)| Quantity::new(row, value)));
        if options.bars && self.widen(&mut orbit.quantities, (found.temperature, flows, surplus)).is_none() {
            orbit.quantities.iter_mut().for_each(|quantity| quantity.set_bar(None));
        }
        orbit.temperature = Some(CycleTemperature {
            model: self.thermal,
            left_over: (surplus / flows.power).abs(),
            steps: self.tried.len(),
        });
        Ok(orbit)
    }

    /// The two orbits nearest to a temperature that are far enough from one another.
    fn nearest(&self, temperature: f64) -> Option<[&Tried; 2]> {
        let mut by_distance: Vec<&Tried> = self.tried.iter().collect();
        by_distance.sort_by(|a, b| {
            let [a, b] = [a, b].map(|tried| (tried.temperature - temperature).abs());
            a.total_cmp(&b)
        });
        let first = *by_distance.first()?;
        let second = by_distance.iter().find(|other| (other.temperature - first.temperature).abs() > APART)?;
        Some([first, second])
    }

    /// Gives the numbers of the balance their bars, and adds to all others what the bar of the temperature makes of
    /// them. None where that bar is not known.
    fn widen(
        &self,
        quantities: &mut [Quantity],
        (temperature, flows, surplus): (f64, ThermalFlows, f64),
    ) -> Option<()> {
        let [here, there] = self.nearest(temperature)?;
        let apart = there.temperature - here.temperature;
        let slopes: HashMap<Cow<'static, str>, f64> = (here.quantities.iter())
            .filter_map(|quantity| {
                let other = there.quantities.iter().find(|other| other.name == quantity.name)?;
                let change = quantity.row.difference(other.value, quantity.value);
                Some((quantity.name.clone(), change / apart))
            })
            .collect();
        let slope = (there.surplus - here.surplus) / apart;
        let balance = &self.thermal.balance;
        let carried = balance.carried(temperature, &flows);
        let error = |row: &Row| quantities.iter().find(|quantity| quantity.row == row)?.error();
        let of_power = error(&CYCLE_POWER_LOSS);
        let of_flow = error(&CYCLE_COOLING_FLOW);
        let (power, flow) = of_power.zip(of_flow)?;
        let bar = (power + carried.abs() * flow / flows.flow + surplus.abs()) / slope.abs();
        let per_kelvin =
            balance.ends(temperature + 1.0, flows.carried_over)[1] - balance.ends(temperature, flows.carried_over)[1];
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
}
