//! Friction and heat carried off around the temperature found, and whether the bearing will do.

use oilwedge_bearing::{Deadline, InitialGuess};
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::solve::Neighbour;

use super::{balance, film_heat, measured};
use crate::analysis::{Solved, isothermal};
use crate::compile::Study;
use crate::quantities::{FILM_THICKNESS_MIN, LOAD, Quantity, Row};
use crate::result::{Criterion, HeatPoint, HeatReport};
use crate::run::RunOptions;
use oilwedge_scene::{Engine, Heat};

/// Films on either side of the temperature found.
const FILMS: i32 = 3;
/// They reach so many times as far as the mean temperature lies above that of the oil fed,
const REACH: f64 = 1.5;
/// and this far [K] at least.
const LEAST_REACH: f64 = 10.0;

/// What is told of a balance; nothing without one. The study keeps its film.
pub fn heat_report(
    study: &mut Study,
    solved: &Solved,
    quantities: &[Quantity],
    options: &RunOptions,
) -> Option<HeatReport> {
    let (heat, found) = (study.heat?, solved.heat.as_ref().filter(|found| !found.is_ended)?);
    let root = found.balanced.temperature;
    let (problem, oil) = (study.problem.clone(), study.oil.clone());
    let reach = (REACH * (root - heat.inlet).abs()).max(LEAST_REACH);
    let bearing = study.problem.bearing;
    let mut curve = Vec::new();
    for k in -FILMS..=FILMS {
        let temperature = root + f64::from(k) / f64::from(FILMS) * reach;
        if temperature < balance(&heat).range()[0] {
            continue;
        }
        study.problem = problem.clone();
        let point = match k {
            0 => Some(point(study, &heat, temperature, solved)),
            _ => film_at(study, &heat, temperature, solved, options.deadline()),
        };
        curve.extend(point);
    }
    (study.problem, study.oil) = (problem, oil);
    let value = |row: &Row| {
        let quantity = quantities.iter().find(|quantity| quantity.row == row);
        quantity.map(|quantity| quantity.value)
    };
    let criteria = criteria(study, &heat, value(&FILM_THICKNESS_MIN)?, root);
    Some(HeatReport {
        preset: heat.engine.map(Engine::name),
        inlet_temperature: heat.inlet - ZERO_CELSIUS,
        heat_capacity: heat.heat_capacity,
        specific_load: value(&LOAD)? / (2.0 * bearing.radius * bearing.length),
        curve,
        is_fit: criteria.iter().all(|criterion| criterion.is_met || !criterion.decides),
        criteria,
    })
}

fn film_at(study: &mut Study, heat: &Heat, temperature: f64, near: &Solved, deadline: Deadline) -> Option<HeatPoint> {
    study.heat_to(temperature);
    let solved = isothermal(study, false, deadline, InitialGuess::Near(Neighbour::Start(&near.film))).ok();
    let solved = solved.or_else(|| isothermal(study, false, deadline, InitialGuess::Cold).ok());
    let solved = solved.filter(|solved| !solved.is_ended())?;
    Some(point(study, heat, temperature, &solved))
}

fn point(study: &Study, heat: &Heat, temperature: f64, solved: &Solved) -> HeatPoint {
    let balance = balance(heat);
    let film = film_heat(heat, study, &measured(study, solved));
    HeatPoint {
        temperature: temperature - ZERO_CELSIUS,
        viscosity: study.problem.lubricant.viscosity,
        friction_power: film.power,
        heat_carried: balance.carried(temperature, &film),
        heat_housing: balance.given_off(temperature),
        eccentricity: study.problem.journal.eccentricity() / study.problem.bearing.clearance,
    }
}

/// What decides, and what is usual in an engine.
fn criteria(study: &Study, heat: &Heat, least_film: f64, temperature: f64) -> Vec<Criterion> {
    let bearing = &study.problem.bearing;
    let celsius = |temperature: f64| temperature - ZERO_CELSIUS;
    let mut list = vec![
        Criterion::new(
            "thinnest film",
            "um",
            1e6 * least_film,
            [Some(1e6 * heat.least_film), None],
            true,
        ),
        Criterion::new(
            "temperature of the film",
            "degC",
            celsius(temperature),
            [None, Some(celsius(heat.greatest_temperature))],
            true,
        ),
    ];
    let Some(engine) = heat.engine else { return list };
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
    if let Some(pressure) = study.supply_pressure {
        let range = engine.feed_pressure().map(|pressure| 1e-5 * pressure);
        usual("pressure of the oil fed", "bar", 1e-5 * pressure, range);
    }
    usual(
        "temperature of the oil fed",
        "degC",
        celsius(heat.inlet),
        engine.inlet().map(celsius),
    );
    list
}
