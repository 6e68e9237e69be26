//! What a bearing is judged by, compared here alone: the limits of the scene, and what is usual where nobody sets a
//! limit: in an engine, and where heat is balanced.

use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_scene::{Criteria, EngineKind};

use crate::film::Film;
use crate::quantities::{
    CONTACT_SHARE, CYCLE_CONTACT_SHARE_MAX, CYCLE_DEVIATION, CYCLE_EQUIVALENT_FILM, CYCLE_FILM_THICKNESS_MIN,
    CYCLE_MIDDLE_FILM_MIN, CYCLE_PRESSURE_MAX, CYCLE_TEMPERATURE, CYCLE_TEMPERATURE_OUTLET, DEVIATION, EQUIVALENT_FILM,
    FILM_THICKNESS_MIN, LOGARITHMIC_DECREMENT, MIDDLE_FILM_MIN, PRESSURE_MAX, Quantity, Row, TEMPERATURE_EFFECTIVE,
    TEMPERATURE_MAX, TEMPERATURE_OUTLET,
};
use crate::result::{Accuracy, Criterion, Origin};
use crate::thermal_model::ThermalModel;

/// Usual least film thickness [m] of a bearing whose heat is balanced.
const USUAL_FILM: f64 = 4e-6;
/// Usual greatest mean temperature [degrees C] of its film.
const USUAL_TEMPERATURE: f64 = 115.0;
/// Usual greatest temperature [degrees C] of the oil that leaves, the greatest that ISO 7902-3 permits.
const USUAL_OUTLET: f64 = 125.0;

/// A number in SI units, and how well it is known.
type JudgedNumber = (f64, Accuracy);

/// The numbers that limits are compared with.
struct Compared<'a> {
    quantities: &'a [Quantity],
    /// Temperature of the film [K].
    temperature: Option<f64>,
    /// Whether error bars were asked for.
    bars: bool,
}

impl Compared<'_> {
    /// The first of these rows that was measured.
    fn value(&self, rows: &[&Row]) -> Option<JudgedNumber> {
        let quantity = self.quantities.iter().find(|quantity| rows.contains(&quantity.row))?;
        let accuracy = match quantity.error() {
            Some(error) => Accuracy::Within(error),
            None if self.bars => Accuracy::NotResolved,
            None => Accuracy::NotAsked,
        };
        Some((quantity.value, accuracy))
    }

    /// Temperature of the film [degrees C], the greatest where it varies across the film, with the bar of the one
    /// found; a given one is exact.
    fn temperature(&self) -> Option<JudgedNumber> {
        if let Some(hottest) = self.value(&[&TEMPERATURE_MAX]) {
            return Some(hottest);
        }
        let found = self.value(&[&TEMPERATURE_EFFECTIVE, &CYCLE_TEMPERATURE]);
        let accuracy = found.map_or(Accuracy::Within(0.0), |(_, accuracy)| accuracy);
        Some((self.temperature? - ZERO_CELSIUS, accuracy))
    }
}

/// What a film of these `quantities`, or the films of a cycle, must meet, and what is usual; nothing where the scene
/// sets no limits. `model` is that by which the temperature was found; `bars`: error bars were asked for.
pub fn design_criteria(
    film: &Film,
    model: Option<&ThermalModel>,
    quantities: &[Quantity],
    bars: bool,
) -> Vec<Criterion> {
    let compared = Compared { quantities, temperature: film.oil.temperature, bars };
    let mut all = criteria(&film.model.criteria, model.is_some(), &compared);
    if let Some((model, engine)) = model.and_then(|model| Some((model, model.engine?))) {
        all.extend(usual(film, model, engine));
    }
    all
}

/// A number, in the unit in which people read its limit.
struct Limited<'a> {
    what: &'a str,
    unit: &'a str,
    /// Size of this unit over that of the number.
    scale: f64,
    value: Option<JudgedNumber>,
}

impl Limited<'_> {
    /// Compared with the limit of the scene [SI], or with a usual value where there is none; `None` where there is
    /// neither, or no number.
    fn at_least(&self, limit: Option<f64>, usual: Option<f64>) -> Option<Criterion> {
        let (limit, origin) = self.chosen(limit, usual)?;
        self.within([Some(limit), None], origin)
    }

    fn at_most(&self, limit: Option<f64>, usual: Option<f64>) -> Option<Criterion> {
        let (limit, origin) = self.chosen(limit, usual)?;
        self.within([None, Some(limit)], origin)
    }

    fn chosen(&self, limit: Option<f64>, usual: Option<f64>) -> Option<(f64, Origin)> {
        let set = limit.map(|limit| (self.scale * limit, Origin::Scene));
        set.or(usual.map(|usual| (self.scale * usual, Origin::Usual)))
    }

    fn within(&self, bounds: [Option<f64>; 2], origin: Origin) -> Option<Criterion> {
        let (value, accuracy) = self.value?;
        let accuracy = match accuracy {
            Accuracy::Within(bar) => Accuracy::Within(self.scale * bar),
            unknown => unknown,
        };
        let value = (self.scale * value, accuracy);
        Some(Criterion::new(self.what, self.unit, value, bounds, origin))
    }
}

/// What the scene judges the bearing by, and what is usual where its heat `is_balanced`.
fn criteria(asked: &Criteria, is_balanced: bool, compared: &Compared) -> Vec<Criterion> {
    let of = |what, unit, scale, value| Limited { what, unit, scale, value };
    let length = |what, rows: [&Row; 2]| of(what, "um", 1e6, compared.value(&rows));
    let celsius = |kelvin: f64| kelvin - ZERO_CELSIUS;
    let usual = |value: f64| is_balanced.then_some(value);
    let outlet = compared.value(&[&TEMPERATURE_OUTLET, &CYCLE_TEMPERATURE_OUTLET]);
    let pressure = compared.value(&[&PRESSURE_MAX, &CYCLE_PRESSURE_MAX]);
    let contact = compared.value(&[&CONTACT_SHARE, &CYCLE_CONTACT_SHARE_MAX]);
    let decrement = compared.value(&[&LOGARITHMIC_DECREMENT]);
    let all = [
        length("least film", [&FILM_THICKNESS_MIN, &CYCLE_FILM_THICKNESS_MIN])
            .at_least(asked.film_min, usual(USUAL_FILM)),
        length("least film at mid-length", [&MIDDLE_FILM_MIN, &CYCLE_MIDDLE_FILM_MIN])
            .at_least(asked.middle_film_min, None),
        length("deviation of the film at the ends", [&DEVIATION, &CYCLE_DEVIATION]).at_most(asked.deviation_max, None),
        length("equivalent film", [&EQUIVALENT_FILM, &CYCLE_EQUIVALENT_FILM]).at_least(asked.equivalent_film_min, None),
        of("greatest pressure", "bar", 1e-5, pressure).at_most(asked.pressure_max, None),
        of("temperature of the film", "degC", 1.0, compared.temperature())
            .at_most(asked.temperature_max.map(celsius), usual(USUAL_TEMPERATURE)),
        of("temperature of the oil that leaves", "degC", 1.0, outlet)
            .at_most(asked.outlet_max.map(celsius), usual(USUAL_OUTLET)),
        of("share of contact in the load", "", 1.0, contact).at_most(asked.contact_share_max, None),
        of("logarithmic decrement of the rotor", "", 1.0, decrement).at_least(asked.decrement_min, None),
    ];
    all.into_iter().flatten().collect()
}

/// What is usual in an engine.
fn usual(film: &Film, model: &ThermalModel, engine: EngineKind) -> Vec<Criterion> {
    let bearing = &film.problem.bearing;
    let celsius = |temperature: f64| temperature - ZERO_CELSIUS;
    let mut list = Vec::new();
    let mut usual = |what: &str, unit: &str, value: f64, range: [f64; 2]| {
        let given = (value, Accuracy::Within(0.0));
        list.push(Criterion::new(what, unit, given, range.map(Some), Origin::Usual));
    };
    let ratio = bearing.clearance / bearing.radius;
    usual("diametral clearance over diameter", "1e-3", 1e3 * ratio, engine.clearance_ratio().map(|ratio| 1e3 * ratio));
    if let Some(pressure) = film.supply_pressure() {
        let range = engine.feed_pressure().map(|pressure| 1e-5 * pressure);
        usual("pressure of the oil fed", "bar", 1e-5 * pressure, range);
    }
    usual("temperature of the oil fed", "degC", celsius(model.balance.inlet), engine.inlet().map(celsius));
    list
}
