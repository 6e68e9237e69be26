//! What a bearing must meet: the limits of the scene, those that a heat balance has without being asked, and what is usual in an engine.

use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_scene::{Engine, Scene};

use crate::film::Film;
use crate::measure::Measured;
use crate::oil::Oil;
use crate::quantities::{
    CYCLE_FILM_THICKNESS_MIN, CYCLE_PRESSURE_MAX, CYCLE_TEMPERATURE_OUTLET, FILM_THICKNESS_MIN, PRESSURE_MAX, Quantity,
    Row, TEMPERATURE_OUTLET,
};
use crate::result::{Criterion, RunResult};
use crate::thermal_model::ThermalModel;
use crate::warning::{self, Warning};

/// Decimals of a value beside its limit.
const DIGITS: usize = 4;

/// What a film, or the films of a cycle, have to compare with their limits.
struct Compared {
    /// Least film thickness [m].
    film_thickness_min: Option<f64>,
    /// Greatest pressure [Pa].
    pressure_max: Option<f64>,
    /// Temperature of the oil that leaves [degrees C].
    outlet: Option<f64>,
}

impl Compared {
    /// By the numbers reported of a film, or of a cycle.
    fn of(quantities: &[Quantity]) -> Self {
        let value = |rows: [&Row; 2]| {
            let quantity = quantities.iter().find(|quantity| rows.contains(&quantity.row));
            quantity.map(|quantity| quantity.value)
        };
        Self {
            film_thickness_min: value([&FILM_THICKNESS_MIN, &CYCLE_FILM_THICKNESS_MIN]),
            pressure_max: value([&PRESSURE_MAX, &CYCLE_PRESSURE_MAX]),
            outlet: value([&TEMPERATURE_OUTLET, &CYCLE_TEMPERATURE_OUTLET]),
        }
    }
}

/// What a film of these `quantities` must meet, and what is usual; nothing where the scene sets no limits. `model` is that by which its temperature was found.
pub fn design_criteria(film: &Film, model: Option<&ThermalModel>, quantities: &[Quantity]) -> Vec<Criterion> {
    let mut criteria = limits(&film.scene, film.oil.temperature, model, &Compared::of(quantities));
    if let Some((model, engine)) = model.and_then(|model| Some((model, model.engine?))) {
        criteria.extend(usual(film, model, engine));
    }
    criteria
}

/// Limits of the scene that the film exceeds, in sentences that name them; those of a film whose temperature is found are criteria of its
/// balance, those of an orbit are compared over the cycle.
pub(crate) fn exceeded(film: &Film, measured: &Measured) -> Vec<Warning> {
    if film.thermal.is_some() || film.scene.orbit.is_some() {
        return Vec::new();
    }
    let compared = Compared {
        film_thickness_min: Some(measured.thinnest.thickness),
        pressure_max: Some(measured.extremes.greatest),
        outlet: None,
    };
    told(limits(&film.scene, film.oil.temperature, None, &compared))
}

/// Limits of the scene that an orbit at a given temperature exceeds over its cycle, by the numbers of that.
pub(crate) fn exceeded_over_cycle(scene: &Scene, quantities: &[Quantity]) -> Vec<Warning> {
    told(over_cycle(scene, quantities))
}

/// What an orbit must meet over its cycle; nothing where the scene sets no limits.
pub fn cycle_criteria(scene: &Scene, result: &RunResult) -> Vec<Criterion> {
    match &result.temperature {
        Some(report) => report.criteria.clone(),
        None => over_cycle(scene, &result.quantities),
    }
}

/// The limits of a scene with an orbit at a given temperature.
fn over_cycle(scene: &Scene, quantities: &[Quantity]) -> Vec<Criterion> {
    limits(scene, Oil::of(scene).temperature, None, &Compared::of(quantities))
}

/// Sentences about the limits that are missed.
fn told(limits: Vec<Criterion>) -> Vec<Warning> {
    let missed = limits.into_iter().filter(Criterion::is_missed);
    missed
        .map(|limit| {
            let value = format!("{:.DIGITS$e}", limit.value).parse().unwrap_or(limit.value);
            let (fault, value) = (limit.fault(), readable(value));
            warning::LIMIT.says(format!(
                "a limit is exceeded: {fault} ([limits]): it is {value} {}",
                limit.unit
            ))
        })
        .collect()
}

/// The limits of the scene, whose film has this `temperature` [K]; of a film whose temperature is found also those that its heat balance has without being asked.
fn limits(
    scene: &Scene,
    temperature: Option<f64>,
    model: Option<&ThermalModel>,
    compared: &Compared,
) -> Vec<Criterion> {
    let limits = &scene.limits;
    let least_film = model.map(|model| model.least_film).or(limits.least_film);
    let hottest = model
        .map(|model| model.greatest_temperature)
        .or(limits.greatest_temperature);
    let celsius = |kelvin: f64| kelvin - ZERO_CELSIUS;
    let at_least = |what: &str, unit: &str, scale: f64, value: Option<f64>, limit: Option<f64>| {
        let bounds = [Some(scale * limit?), None];
        Some(Criterion::new(what, unit, scale * value?, bounds, true))
    };
    let at_most = |what: &str, unit: &str, scale: f64, value: Option<f64>, limit: Option<f64>| {
        let bounds = [None, Some(scale * limit?)];
        Some(Criterion::new(what, unit, scale * value?, bounds, true))
    };
    let temperature = temperature.map(celsius);
    let hottest = hottest.map(celsius);
    let hottest_outlet = model.map(|model| celsius(model.greatest_outlet));
    let highest = limits.greatest_pressure;
    let all = [
        at_least("thinnest film", "um", 1e6, compared.film_thickness_min, least_film),
        at_most("temperature of the film", "degC", 1.0, temperature, hottest),
        at_most("greatest pressure", "bar", 1e-5, compared.pressure_max, highest),
        at_most(
            "temperature of the oil that leaves",
            "degC",
            1.0,
            compared.outlet,
            hottest_outlet,
        ),
    ];
    all.into_iter().flatten().collect()
}

/// What is usual in an engine.
fn usual(film: &Film, model: &ThermalModel, engine: Engine) -> Vec<Criterion> {
    let bearing = &film.problem.bearing;
    let celsius = |temperature: f64| temperature - ZERO_CELSIUS;
    let mut list = Vec::new();
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
