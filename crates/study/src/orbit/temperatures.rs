//! Temperatures across the films of a cycle, which do not follow the motion of the journal: those that balance the mean
//! heat of the cycle.
//!
//! They are first found on a coarser mesh; on that of the result rounds begin with them. Each orbit begins where the
//! one before had closed.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

use oilwedge_bearing::duty_cycle::DutyCycle;
use oilwedge_bearing::film_heat::FilmHeat;
use oilwedge_bearing::heat_round::NoRound;
use oilwedge_bearing::orbit::OrbitEnd;
use oilwedge_bearing::thermal_film::{HeatRound, HeatSearch, balance_heat};
use oilwedge_reynolds::ViscosityAcross;
use oilwedge_reynolds::error_bar::Bar;
use oilwedge_reynolds::quantities::heat_network::NodeNetwork;
use oilwedge_scene::OrbitTable;

use super::{FollowedCycle, OrbitSeries, OrbitStart, expected_seconds, followed, start};
use crate::compile_error::CompileError;
use crate::film::Film;
use crate::measure::measure;
use crate::model::Model;
use crate::no_answer::{NoAnswer, NoTemperature};
use crate::observer::Watch;
use crate::quantities::{HEAT_POWER, Quantity, View, is_of_heat, of_temperatures};
use crate::run_options::RunOptions;
use crate::thermal::field::{layers, none};
use crate::thermal::field_bars::more_layers;
use crate::thermal_model::HeatFieldModel;

/// Temperatures are found where those of the next round differ by no more than this [K]: the least bar of a temperature
/// that was measured, on the big end of scene 28, is 0.026 K.
const CLOSED: f64 = 0.02;
/// On the coarser mesh, which only gives a start, this is enough [K].
const ROUGHLY_CLOSED: f64 = 0.5;
/// Tolerance of the orbits there.
const ROUGH_TOLERANCE: f64 = 1e-2;

/// Follows the orbit with the temperatures that balance the mean heat of its films.
///
/// # Errors
/// The scene does not become a film.
pub(super) fn balanced(
    (model, orbit, cycle): (&Arc<Model>, &OrbitTable, &DutyCycle),
    heat: &HeatFieldModel,
    watch: Watch,
    options: &RunOptions,
) -> Result<(Film, Result<FollowedCycle, NoAnswer>), CompileError> {
    let quick = RunOptions { bars: false, frames: 0, earlier: None, ..*options };
    let oil = model.oil_at(Some(heat.surroundings.inlet));
    let (film, begin) = start::prepared(model, &oil, (orbit, cycle), watch)?;
    if let Some(observer) = options.observer {
        observer.expects(film.unknowns(), expected_seconds(&film));
        observer.turns_to("the orbits with the temperatures of one round after the other");
    }
    let rough = OrbitTable { tolerance: ROUGH_TOLERANCE.max(orbit.tolerance), ..*orbit };
    let orbits = |film, orbit| OrbitSeries { film, orbit, cycle, watch, options: quick, begin, last: None };
    let mut fine = orbits(film.clone(), *orbit);
    let outcome = on_both(&mut orbits(film.on_coarser(), rough), &mut fine, heat);
    match outcome {
        Err(reason) => Ok((film, Err(reason))),
        Ok((found, film)) => {
            let outcome = fine.reported_with_heat((found, &film), heat, options);
            Ok((film, outcome))
        }
    }
}

/// The temperatures of the finer orbits, and their film.
fn on_both(
    rough: &mut OrbitSeries,
    fine: &mut OrbitSeries,
    model: &HeatFieldModel,
) -> Result<(FilmHeat, Film), NoAnswer> {
    let inlet = model.surroundings.inlet;
    let first = rough.followed(&rough.film, &rough.options)?;
    let layers = layers(&first.solved.primary, model)?;
    rough.last = first.last;
    let clearance = fine.film.problem.bearing.clearance;
    let search = |start, growth, closed| HeatSearch { layers: &layers, start, eddies: None, growth, closed, clearance };
    let at_inlet = vec![inlet; rough.film.system.space().dofs() * layers.points.len()];
    let coarse = rough.rounds(model, search(at_inlet, 0.0, ROUGHLY_CLOSED))?;
    let at_dofs = match &fine.film.system.coarser {
        Some(coarser) => coarser.prolonged(&coarse.at_dofs, layers.points.len()),
        None => coarse.at_dofs.clone(),
    };
    fine.film = fine.film.at_temperature(coarse.mean());
    fine.begin = rough.last.as_ref().map_or(fine.begin, |step| step.at);
    let found = fine.rounds(model, search(at_dofs, coarse.growth, CLOSED))?;
    let base = fine.film.clone();
    let across = found.viscosity_across(base.system.space(), &|temperature| base.viscosity_at(temperature));
    let film = fine.film.at_temperature(found.mean()).with_heat(across, found.growth);
    Ok((found, film))
}

impl OrbitSeries<'_> {
    /// The temperatures that balance the mean heat, round by round.
    fn rounds(&mut self, model: &HeatFieldModel, search: HeatSearch) -> Result<FilmHeat, NoAnswer> {
        let base = self.film.clone();
        let viscosity = |temperature: f64| base.viscosity_at(temperature);
        let round =
            |HeatRound { across, growth, .. }: &HeatRound| self.mean_heat(&base.with_heat(across.clone(), *growth));
        balance_heat(&model.surroundings, base.system.space(), search, &viscosity, round).map_err(none)
    }

    /// The network of the mean heat of a complete orbit on a film.
    fn mean_heat(&mut self, film: &Film) -> Result<NodeNetwork, NoAnswer> {
        let found = self.followed(film, &self.options)?;
        self.last = found.last;
        network_of(found.end, found.network)
    }

    /// The orbit with the temperatures found, and their numbers.
    fn reported_with_heat(
        &self,
        (heat, film): (FilmHeat, &Film),
        model: &HeatFieldModel,
        options: &RunOptions,
    ) -> Result<FollowedCycle, NoAnswer> {
        // The films of the cycle show the temperatures that they have.
        let film = &Film { heat: Some(Arc::new(heat.clone())), ..film.clone() };
        let mut orbit = self.followed(film, options)?;
        let network = network_of(orbit.end, orbit.network.take())?;
        let viscosity = |temperature: f64| self.film.viscosity_at(temperature);
        let heat =
            heat.balanced_on(&model.surroundings, network.clone(), &viscosity).map_err(|reason| none(reason.into()))?;
        orbit.solved.film.heat = Some(Arc::new(heat));
        orbit.quantities.extend(of_heat(&orbit, &orbit.solved.film));
        orbit.path.quantities.iter_mut().for_each(|numbers| settle(numbers, &orbit.quantities));
        if options.bars {
            let open = self.open(&orbit, (film, network), model);
            orbit.are_bars_ended |= open.is_none() && self.watch.deadline.is_over();
            widen(&mut orbit.quantities, open);
        }
        Ok(orbit)
    }

    /// What layers and mesh leave open of each number, by orbits on the vertices of the mesh alone: one with the
    /// temperatures found, one with those of more layers, and one with those that balance its own mean heat. `None`
    /// where one of them does not come to its end.
    fn open(
        &self,
        orbit: &FollowedCycle,
        (film, network): (&Film, NodeNetwork),
        model: &HeatFieldModel,
    ) -> Option<HashMap<Cow<'static, str>, f64>> {
        let (heat, surroundings, fine) = (orbit.solved.film.heat.as_ref()?, &model.surroundings, film.system.space());
        let viscosity = |temperature: f64| self.film.viscosity_at(temperature);
        let vertices = film.on_vertices();
        let begin = orbit.last.as_ref()?.at;
        let beside = |across: Option<Arc<ViscosityAcross>>| {
            let mut film = vertices.clone();
            film.problem.viscosity_across = across.or(film.problem.viscosity_across);
            let options = RunOptions { observer: None, ..self.options };
            let found =
                followed(&film, (&self.orbit, self.cycle), (OrbitStart::At(begin), self.watch.deadline), &options);
            found.ok().filter(|found| found.end != OrbitEnd::Ended)
        };
        let alike = beside(None)?;
        let layers = more_layers(heat)?;
        let by_layers = heat.with_layers(surroundings, (fine, network), &layers, &viscosity).ok()?;
        let spaces = (fine, vertices.system.space());
        let by_mesh = heat.on_vertices(surroundings, spaces, alike.network.clone()?, &viscosity).ok()?;
        let mut open: HashMap<Cow<'static, str>, f64> = HashMap::new();
        let here = of_heat(orbit, &orbit.solved.film);
        let of_layers = Arc::new(by_layers.across.on_vertices());
        for (heat, across) in [(by_layers.heat, of_layers), (by_mesh.heat, by_mesh.across)] {
            let there = beside(Some(across))?;
            let film = Film { heat: Some(Arc::new(heat)), ..orbit.solved.film.clone() };
            for (one, others) in [(&alike.quantities, &there.quantities), (&here, &of_heat(orbit, &film))] {
                for quantity in one {
                    let other = others.iter().find(|other| other.name == quantity.name)?;
                    *open.entry(quantity.name.clone()).or_default() +=
                        quantity.row.difference(other.value, quantity.value).abs();
                }
            }
        }
        Some(open)
    }
}

/// The network of an orbit that has come to its end.
fn network_of(end: OrbitEnd, network: Option<NodeNetwork>) -> Result<NodeNetwork, NoAnswer> {
    match end {
        OrbitEnd::Ended => Err(NoAnswer::Temperature(NoTemperature::Ended { nearest: None })),
        OrbitEnd::Closed | OrbitEnd::NotClosed => network.ok_or_else(|| none(NoRound::MakesOil.into())),
    }
}

/// The numbers of the temperatures that a film of an orbit has.
fn of_heat(orbit: &FollowedCycle, film: &Film) -> Vec<Quantity> {
    let measured = measure(&orbit.solved.primary);
    let mut numbers = of_temperatures(&View::new(film, &orbit.solved.primary.problem, &measured));
    // The mean of the cycle in place of that of one film.
    let of_power = numbers.iter_mut().find(|quantity| quantity.row == &HEAT_POWER);
    if let Some((power, heat)) = of_power.zip(film.heat.as_ref()) {
        power.value = heat.heating();
    }
    numbers
}

/// Gives the numbers of a film of the cycle the temperatures that balance its mean heat; its own are what it makes of
/// heat.
fn settle(numbers: &mut [Quantity], of_cycle: &[Quantity]) {
    for number in numbers.iter_mut().filter(|number| is_of_heat(number) && number.row != &HEAT_POWER) {
        if let Some(found) = of_cycle.iter().find(|other| other.name == number.name) {
            number.value = found.value;
        }
    }
}

/// Adds to each bar what is left open of the number; temperatures have no other one. No number has a bar where that is
/// not known.
fn widen(quantities: &mut [Quantity], open: Option<HashMap<Cow<'static, str>, f64>>) {
    for quantity in quantities {
        let own = if is_of_heat(quantity) { Some(Bar::default()) } else { quantity.bar };
        let open = open.as_ref().and_then(|open| open.get(&quantity.name));
        quantity.set_bar(own.zip(open).map(|(own, &open)| own + Bar { temperature: open, ..Bar::default() }));
    }
}

impl Film {
    /// The film with a viscosity across it, and a clearance that has grown by so much [m].
    fn with_heat(&self, across: Arc<ViscosityAcross>, growth: f64) -> Self {
        let mut film = self.with_clearance(self.problem.bearing.clearance + growth);
        film.problem.viscosity_across = Some(across);
        film
    }
}
