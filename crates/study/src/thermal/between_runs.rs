//! The temperature of a film that is found from run to run: of a cycle, and of the films of a shaft.
//!
//! Each run, at one temperature, shows what heats and what cools the film. The next temperature follows by the secant
//! of the last two or, where that is not to be believed, by the slope that friction usually has.

use std::borrow::Cow;
use std::collections::HashMap;

use oilwedge_bearing::thermal_balance::{LONGEST_THINNING, is_usual};
use oilwedge_bearing::{Balanced, NoThermalBalance, ThermalFlows};

use super::{SearchStop, none, powers};
use crate::film::Film;
use crate::no_answer::{NoAnswer, NoTemperature};
use crate::oil::{Oil, first_temperature};
use crate::quantities::Quantity;
use crate::thermal_model::ThermalModel;

/// Temperatures [K] nearer to one another than this do not show how numbers change: orbits differ by their closure.
const APART: f64 = 0.02;
/// Distance [K] of a further run where the others are too near to show how numbers change.
const FURTHER: f64 = 1.0;
/// A temperature without a film is approached so often at most, by half of the way each time: to a sixteenth of a step.
const MOST_RETREATS: usize = 4;
/// Most runs: secants that are believed reduce what is left in each, so that more do not help.
const MOST_RUNS: usize = 40;

/// The temperature of a film from run to run.
pub(crate) struct FilmTemperature {
    /// How its heat is balanced.
    pub(crate) model: ThermalModel,
    /// The temperature of the next run [K].
    pub(crate) temperature: f64,
    oil: Oil,
    runs: Vec<RunAtTemperature>,
    retreats: usize,
}

/// What a run at one temperature has shown.
struct RunAtTemperature {
    temperature: f64,
    flows: ThermalFlows,
    surplus: f64,
    quantities: Vec<Quantity>,
}

impl FilmTemperature {
    /// The search begins at the temperature that the oil has, or at a usual one.
    pub(crate) fn of(film: &Film, model: ThermalModel) -> Self {
        let temperature = film.oil.temperature.unwrap_or(first_temperature(model.balance.inlet));
        Self { model, temperature, oil: film.oil.clone(), runs: Vec::new(), retreats: 0 }
    }

    /// Begins anew on another mesh near a temperature that was found: what other meshes have shown does not count.
    pub(crate) fn begun_again(&mut self) {
        self.runs.clear();
        self.retreats = 0;
    }

    /// How many runs it took.
    pub(crate) fn runs(&self) -> usize {
        self.runs.len()
    }

    /// Adds what a run at the temperature asked for has shown; the heat that is left over, as a part of the power [1].
    pub(crate) fn add(&mut self, flows: ThermalFlows, quantities: Vec<Quantity>) -> f64 {
        let temperature = self.temperature;
        let surplus = self.model.balance.surplus(temperature, &flows);
        self.runs.push(RunAtTemperature { temperature, flows, surplus, quantities });
        self.retreats = 0;
        if surplus == 0.0 { 0.0 } else { (surplus / flows.power).abs() }
    }

    /// Turns to the temperature of the next run.
    ///
    /// # Errors
    /// [`NoAnswer`]: the film is too hot everywhere, or no balance is found.
    pub(crate) fn turn(&mut self) -> Result<(), NoAnswer> {
        let Some(here) = self.runs.last() else { return Ok(()) };
        let balance = &self.model.balance;
        let [coldest, hottest] = balance.range();
        let end = if here.surplus > 0.0 { hottest } else { coldest };
        let (temperature, film) = (here.temperature, here.flows);
        if temperature == end {
            return Err(none(balance, NoThermalBalance::TooHot { temperature, film }));
        }
        if self.runs.len() > MOST_RUNS {
            let (runs, last) = (self.runs.len(), powers(balance, temperature, &film));
            return Err(NoAnswer::Temperature(NoTemperature::NotFound { runs, last }));
        }
        let most = LONGEST_THINNING / self.thinning(temperature).abs();
        let step = (-here.surplus / self.slope(here)).clamp(-most, most);
        self.temperature = (temperature + step).clamp(coldest, hottest);
        Ok(())
    }

    /// Turns back half of the way to the last run, where there is no film at the temperature asked for; false where
    /// there was no run, or it has turned back so often that there is none on the way.
    pub(crate) fn retreat(&mut self) -> bool {
        let Some(last) = self.runs.last().filter(|_| self.retreats < MOST_RETREATS) else {
            return false;
        };
        self.retreats += 1;
        self.temperature = 0.5 * (self.temperature + last.temperature);
        true
    }

    /// Why there is no balance, where there is no film at the temperature asked for, for this `reason`.
    pub(crate) fn without_film(&self, reason: NoAnswer) -> NoAnswer {
        let reason = SearchStop::NoAnswer(reason);
        let why = match self.runs.last() {
            None => NoThermalBalance::NoFilm(reason),
            Some(last) => NoThermalBalance::Ends { temperature: last.temperature, film: last.flows, reason },
        };
        none(&self.model.balance, why)
    }

    /// The balance of a film that is reported with these flows, at the temperature of the last run.
    pub(crate) fn balanced(&self, flows: ThermalFlows) -> Balanced {
        let surplus = self.model.balance.surplus(self.temperature, &flows);
        let slope = self.nearest().map_or(f64::NAN, |[here, there]| secant(here, there));
        Balanced { temperature: self.temperature, film: flows, surplus, slope, films: self.runs.len() }
    }

    /// Turns to a run beside the temperature found, by `sign` of a distance: there with 1 and back with -1.
    pub(crate) fn step_aside(&mut self, sign: f64) {
        self.temperature += sign * FURTHER;
    }

    /// Whether its runs show how numbers change with temperature.
    pub(crate) fn has_slopes(&self) -> bool {
        self.nearest().is_some()
    }

    /// How each number changes with temperature [1/K], by name; none where the runs do not show it.
    pub(crate) fn slopes(&self) -> HashMap<Cow<'static, str>, f64> {
        let Some([here, there]) = self.nearest() else { return HashMap::new() };
        let apart = there.temperature - here.temperature;
        let slope = |quantity: &Quantity| {
            let other = there.quantities.iter().find(|other| other.name == quantity.name)?;
            Some((quantity.name.clone(), quantity.row.difference(other.value, quantity.value) / apart))
        };
        here.quantities.iter().filter_map(slope).collect()
    }

    /// The two runs nearest to the temperature found that are far enough from one another.
    fn nearest(&self) -> Option<[&RunAtTemperature; 2]> {
        let mut by_distance: Vec<&RunAtTemperature> = self.runs.iter().collect();
        let distance = |run: &RunAtTemperature| (run.temperature - self.temperature).abs();
        by_distance.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        let first = *by_distance.first()?;
        let second = by_distance.iter().find(|other| (other.temperature - first.temperature).abs() > APART)?;
        Some([first, second])
    }

    /// How the surplus changes with temperature near a run [W/K], negative.
    fn slope(&self, here: &RunAtTemperature) -> f64 {
        let balance = &self.model.balance;
        let usual = balance.slope_under_load(here.temperature, &here.flows, self.thinning(here.temperature));
        let before = self.runs.iter().rev().find(|run| run.temperature != here.temperature);
        before.map(|before| secant(before, here)).filter(|slope| is_usual(*slope, usual)).unwrap_or(usual)
    }

    /// How the logarithm of the viscosity changes with temperature [1/K].
    fn thinning(&self, temperature: f64) -> f64 {
        let [low, high] = [-0.5, 0.5].map(|part| self.oil.at(temperature + part).viscosity.ln());
        high - low
    }
}

/// How the surplus changes with temperature between two runs [W/K].
fn secant(from: &RunAtTemperature, to: &RunAtTemperature) -> f64 {
    (to.surplus - from.surplus) / (to.temperature - from.temperature)
}
