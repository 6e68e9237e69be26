//! Friction and heat carried off around the temperature found, and whether the bearing will do.

use oilwedge_bearing::Deadline;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;

use super::flows::thermal_flows;
use super::search::{ROUGHLY, near_or_cold};
use crate::film::Film;
use crate::limits::design_criteria;
use crate::measure::measure;
use crate::quantities::{CYCLE_LOAD_MAX, LOAD, Quantity};
use crate::result::{Criterion, TemperaturePoint, TemperatureReport};
use crate::run_options::RunOptions;
use crate::solved::{SolveOptions, Solved};
use crate::thermal_model::ThermalModel;

/// Films on either side of the temperature found.
const FILMS: i32 = 3;
/// Reach of the curve on both sides, over the distance of the mean temperature from that of the oil fed.
const REACH: f64 = 1.5;
/// Least reach of the curve [K].
const LEAST_REACH: f64 = 10.0;

/// How the temperature of a film was found; none where it was not sought.
pub fn temperature_report(solved: &Solved, quantities: &[Quantity], options: &RunOptions) -> Option<TemperatureReport> {
    let deadline = options.deadline();
    let film = &solved.film;
    let (model, found) = (film.model.sockets.thermal?, solved.temperature.as_ref().filter(|found| !found.is_ended)?);
    let root = found.balanced.temperature;
    let curve = if options.curve { curve(&model, solved, root, deadline) } else { Vec::new() };
    fitness(film, &model, (quantities, options.bars), curve)
}

/// Whether the bearing will do over a cycle whose heat is balanced by `model`. Without curves: each of their points
/// would be an orbit.
pub fn cycle_temperature_report(
    film: &Film,
    model: &ThermalModel,
    quantities: &[Quantity],
    options: &RunOptions,
) -> Option<TemperatureReport> {
    fitness(film, model, (quantities, options.bars), Vec::new())
}

/// The criteria of a film, or of the films of a cycle, by the numbers reported.
fn fitness(
    film: &Film,
    model: &ThermalModel,
    (quantities, bars): (&[Quantity], bool),
    curve: Vec<TemperaturePoint>,
) -> Option<TemperatureReport> {
    let load = quantities.iter().find(|it| it.row == &LOAD || it.row == &CYCLE_LOAD_MAX)?;
    let bearing = &film.problem.bearing;
    let criteria = design_criteria(film, Some(model), quantities, bars);
    Some(TemperatureReport {
        preset: model.engine.map(|engine| engine.name().to_owned()),
        inlet_temperature: model.balance.inlet - ZERO_CELSIUS,
        heat_capacity: model.balance.heat_capacity,
        specific_load: load.value / (2.0 * bearing.radius * bearing.length),
        curve,
        is_fit: !criteria.iter().any(Criterion::is_missed),
        broken_assumptions: 0,
        criteria,
    })
}

/// Films at temperatures around the one found.
fn curve(model: &ThermalModel, solved: &Solved, root: f64, deadline: Deadline) -> Vec<TemperaturePoint> {
    let reach = (REACH * (root - model.balance.inlet).abs()).max(LEAST_REACH);
    let step = reach / f64::from(FILMS);
    let mut curve = side(model, solved, root, -step, deadline);
    curve.reverse();
    curve.push(point(model, root, solved));
    curve.extend(side(model, solved, root, step, deadline));
    curve
}

/// Films on one side of the temperature found, `step` [K] apart, as far as there are any: each started from the one
/// before.
fn side(model: &ThermalModel, found: &Solved, root: f64, step: f64, deadline: Deadline) -> Vec<TemperaturePoint> {
    let (mut points, mut last): (_, Option<Solved>) = (Vec::new(), None);
    for k in 1..=FILMS {
        let temperature = root + f64::from(k) * step;
        // The curve of a run that ends is left out.
        if temperature < model.balance.range()[0] || deadline.is_over() {
            break;
        }
        let Some(solved) = film_at(temperature, last.as_ref().unwrap_or(found), deadline) else {
            continue;
        };
        points.push(point(model, temperature, &solved));
        last = Some(solved);
    }
    points
}

/// The film at a temperature [K], balanced roughly, from another one.
fn film_at(temperature: f64, near: &Solved, deadline: Deadline) -> Option<Solved> {
    let options = SolveOptions { deadline, accuracy: Some(ROUGHLY), ..SolveOptions::default() };
    let solved = near_or_cold(temperature, (&near.film, Some(near)), &options).ok()?;
    (!solved.is_ended()).then_some(solved)
}

fn point(model: &ThermalModel, temperature: f64, solved: &Solved) -> TemperaturePoint {
    let balance = &model.balance;
    let film = thermal_flows(model, &solved.film, &measure(solved.reported()));
    TemperaturePoint {
        temperature: temperature - ZERO_CELSIUS,
        viscosity: solved.film.problem.lubricant.viscosity,
        friction_power: film.power,
        eccentricity: solved.film.position().eccentricity,
        ..TemperaturePoint::removing(balance.carried(temperature, &film), balance.given_off(temperature))
    }
}
