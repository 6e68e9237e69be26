//! Friction and heat carried off around the temperature found, and whether the bearing will do.

use oilwedge_bearing::{Deadline, InitialGuess};
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::solve::Neighbour;

use super::flows::thermal_flows;
use super::measured;
use super::search::from_near_or_cold;
use crate::compile::at_temperature;
use crate::film::Film;
use crate::quantities::{FILM_THICKNESS_MIN, LOAD, Quantity, Row, TEMPERATURE_OUTLET};
use crate::result::{Criterion, TemperaturePoint, TemperatureReport};
use crate::solved::{SolveOptions, Solved};
use crate::thermal_model::ThermalModel;
use oilwedge_scene::Engine;

/// Films on either side of the temperature found.
const FILMS: i32 = 3;
/// They reach so many times as far as the mean temperature lies above that of the oil fed,
const REACH: f64 = 1.5;
/// and this far [K] at least.
const LEAST_REACH: f64 = 10.0;

/// How the temperature of a film was found; none where it was not sought.
pub fn temperature_report(solved: &Solved, quantities: &[Quantity], deadline: Deadline) -> Option<TemperatureReport> {
    let film = &solved.film;
    let (model, found) = (
        film.thermal?,
        solved.temperature.as_ref().filter(|found| !found.is_ended)?,
    );
    let root = found.balanced.temperature;
    let reach = (REACH * (root - model.balance.inlet).abs()).max(LEAST_REACH);
    let temperatures = (-FILMS..=FILMS).map(|k| (k, root + f64::from(k) / f64::from(FILMS) * reach));
    let curve = temperatures
        .filter(|(_, temperature)| *temperature >= model.balance.range()[0])
        .filter_map(|(k, temperature)| match k {
            0 => Some(point(&model, temperature, solved)),
            _ => film_at(&model, temperature, solved, deadline),
        });
    let value = |row: &Row| {
        let quantity = quantities.iter().find(|quantity| quantity.row == row);
        quantity.map(|quantity| quantity.value)
    };
    let (bearing, criteria) = (
        &film.problem.bearing,
        criteria(
            film,
            &model,
            [value(&FILM_THICKNESS_MIN)?, root, value(&TEMPERATURE_OUTLET)?],
        ),
    );
    Some(TemperatureReport {
        preset: model.engine.map(Engine::name),
        inlet_temperature: model.balance.inlet - ZERO_CELSIUS,
        heat_capacity: model.balance.heat_capacity,
        specific_load: value(&LOAD)? / (2.0 * bearing.radius * bearing.length),
        curve: curve.collect(),
        is_fit: criteria.iter().all(|criterion| criterion.is_met || !criterion.decides),
        broken_assumptions: 0,
        criteria,
    })
}

fn film_at(model: &ThermalModel, temperature: f64, near: &Solved, deadline: Deadline) -> Option<TemperaturePoint> {
    let options = SolveOptions {
        deadline,
        guess: InitialGuess::Near(Neighbour::Start(&near.solution)),
        ..SolveOptions::default()
    };
    let solved = from_near_or_cold(&at_temperature(&near.film, temperature), &options).ok()?;
    (!solved.is_ended()).then(|| point(model, temperature, &solved))
}

fn point(model: &ThermalModel, temperature: f64, solved: &Solved) -> TemperaturePoint {
    let balance = &model.balance;
    let film = thermal_flows(model, &solved.film, &measured(solved));
    TemperaturePoint {
        temperature: temperature - ZERO_CELSIUS,
        viscosity: solved.film.problem.lubricant.viscosity,
        friction_power: film.power,
        carried: balance.carried(temperature, &film),
        given_off: balance.given_off(temperature),
        eccentricity: solved.film.position().eccentricity,
    }
}

/// What decides, and what is usual in an engine.
///
/// Least film [m], temperature of the film [K] and of the oil that leaves [degrees C].
fn criteria(film: &Film, model: &ThermalModel, [least_film, temperature, outlet]: [f64; 3]) -> Vec<Criterion> {
    let bearing = &film.problem.bearing;
    let celsius = |temperature: f64| temperature - ZERO_CELSIUS;
    let mut list = vec![
        Criterion::new(
            "thinnest film",
            "um",
            1e6 * least_film,
            [Some(1e6 * model.least_film), None],
            true,
        ),
        Criterion::new(
            "temperature of the film",
            "degC",
            celsius(temperature),
            [None, Some(celsius(model.greatest_temperature))],
            true,
        ),
        Criterion::new(
            "temperature of the oil that leaves",
            "degC",
            outlet,
            [None, Some(celsius(model.greatest_outlet))],
            true,
        ),
    ];
    let Some(engine) = model.engine else { return list };
    let mut usual = |what: &str, unit: &str, value: f64, range: [f64; 2]| {
        list.push(Criterion::new(what, unit, value, range.map(Some), false));
    };
    let ratio = bearing.clearance / bearing.radius;
    usual(
        "diametral clearance over diameter",
        "1e-3",
        1e3 * ratio,
        engine.clearance_ratio().map(|ratio| 1e3 * ratio),
    );
    if let Some(pressure) = film.supply_pressure() {
        let range = engine.feed_pressure().map(|pressure| 1e-5 * pressure);
        usual("pressure of the oil fed", "bar", 1e-5 * pressure, range);
    }
    usual(
        "temperature of the oil fed",
        "degC",
        celsius(model.balance.inlet),
        engine.inlet().map(celsius),
    );
    list
}
