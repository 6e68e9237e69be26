//! What a bearing must meet: the limits of the scene, those that a heat balance has without being asked, and what is usual in an engine.

use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_scene::Engine;

use crate::film::Film;
use crate::measure::Measured;
use crate::quantities::{FILM_THICKNESS_MIN, PRESSURE_MAX, Quantity, Row, TEMPERATURE_OUTLET};
use crate::result::Criterion;
use crate::solved::Solved;
use crate::thermal_model::ThermalModel;
use crate::warning::{self, Warning};

/// Decimals of a value beside its limit.
const DIGITS: usize = 4;

/// What a film has to compare with its limits.
struct Compared {
    /// Least film thickness [m].
    film_thickness_min: Option<f64>,
    /// Greatest pressure [Pa].
    pressure_max: Option<f64>,
    /// Temperature of the oil that leaves [degrees C].
    outlet: Option<f64>,
}

/// What a solved film must meet, and what is usual; nothing where the scene sets no limits.
pub fn design_criteria(solved: &Solved, quantities: &[Quantity]) -> Vec<Criterion> {
    let film = &solved.film;
    let value = |row: &Row| {
        let quantity = quantities.iter().find(|quantity| quantity.row == row);
        quantity.map(|quantity| quantity.value)
    };
    let compared = Compared {
        film_thickness_min: value(&FILM_THICKNESS_MIN),
        pressure_max: value(&PRESSURE_MAX),
        outlet: value(&TEMPERATURE_OUTLET),
    };
    let mut criteria = limits(film, &compared);
    if let Some((model, engine)) = film.thermal.and_then(|model| Some((model, model.engine?))) {
        criteria.extend(usual(film, &model, engine));
    }
    criteria
}

/// Limits of the scene that the film exceeds, in sentences that name them; those of a film whose temperature is found are criteria of its
/// balance.
pub(crate) fn exceeded(film: &Film, measured: &Measured) -> Vec<Warning> {
    if film.thermal.is_some() {
        return Vec::new();
    }
    let compared = Compared {
        film_thickness_min: Some(measured.thinnest.thickness),
        pressure_max: Some(measured.extremes.greatest),
        outlet: None,
    };
    let missed = limits(film, &compared).into_iter().filter(Criterion::is_missed);
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

/// The limits of the scene; of a film whose temperature is found also those that its heat balance has without being asked.
fn limits(film: &Film, compared: &Compared) -> Vec<Criterion> {
    let (limits, model) = (&film.scene.limits, film.thermal.as_ref());
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
    let temperature = film.oil.temperature.map(celsius);
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
