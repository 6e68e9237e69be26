//! What a bearing must meet, compared here alone: the limits of the scene, those that a heat balance has without being asked, what is usual in an engine, and the scene's criteria.

use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_scene::{Engine, Limits, Scene};

use crate::film::Film;
use crate::oil::Oil;
use crate::quantities::{
    CONTACT_SHARE, CYCLE_CONTACT_SHARE_MAX, CYCLE_DEVIATION, CYCLE_EQUIVALENT_FILM, CYCLE_FILM_THICKNESS_MIN,
    CYCLE_MIDDLE_FILM_MIN, CYCLE_PRESSURE_MAX, CYCLE_TEMPERATURE, CYCLE_TEMPERATURE_OUTLET, DEVIATION, EQUIVALENT_FILM,
    FILM_THICKNESS_MIN, LOGARITHMIC_DECREMENT, MIDDLE_FILM_MIN, PRESSURE_MAX, Quantity, Row, TEMPERATURE_EFFECTIVE,
    TEMPERATURE_OUTLET,
};
use crate::result::{Criterion, Verdict};
use crate::thermal_model::ThermalModel;
use crate::warning::{self, Warning};

/// Decimals of a value beside its limit.
const DIGITS: usize = 4;

/// A number and its error bar, in SI units; infinite where bars are estimated and this one is not known.
type Judged = (f64, Option<f64>);

/// The numbers that limits are compared with.
struct Compared<'a> {
    quantities: &'a [Quantity],
    /// Temperature of the film [K].
    temperature: Option<f64>,
}

impl Compared<'_> {
    /// The first of these rows that was measured.
    fn value(&self, rows: &[&Row]) -> Option<Judged> {
        let quantity = self.quantities.iter().find(|quantity| rows.contains(&quantity.row))?;
        let unknown = self.has_bars().then_some(f64::INFINITY);
        Some((quantity.value, quantity.error().or(unknown)))
    }

    /// Temperature of the film [degrees C], with the bar of the one found.
    fn temperature(&self) -> Option<Judged> {
        let given = self.has_bars().then_some(0.0);
        let found = self.value(&[&TEMPERATURE_EFFECTIVE, &CYCLE_TEMPERATURE]);
        Some((self.temperature? - ZERO_CELSIUS, found.map_or(given, |(_, bar)| bar)))
    }

    /// Whether errors were estimated: numbers that follow from given ones have a bar then.
    fn has_bars(&self) -> bool {
        self.quantities.iter().any(|quantity| quantity.bar.is_some())
    }
}

/// What a film of these `quantities`, or the films of a cycle, must meet, and what is usual; nothing where the scene sets no limits. `model` is that by which
/// the temperature was found.
pub fn design_criteria(film: &Film, model: Option<&ThermalModel>, quantities: &[Quantity]) -> Vec<Criterion> {
    let compared = Compared {
        quantities,
        temperature: film.oil.temperature,
    };
    let mut all = limits(&film.scene, model, &compared);
    if let Some((model, engine)) = model.and_then(|model| Some((model, model.engine?))) {
        all.extend(usual(film, model, engine));
    }
    all.extend(criteria(&film.scene, &compared));
    all
}

/// Limits of the scene that numbers of the film exceed, or that lie inside their bars, in sentences that name them; those of a film whose temperature is found are criteria of its
/// balance, those of an orbit are compared over the cycle.
pub(crate) fn exceeded(film: &Film, quantities: &[Quantity]) -> Vec<Warning> {
    if film.thermal.is_some() || film.scene.orbit.is_some() || film.scene.limits == Limits::default() {
        return Vec::new();
    }
    told(&film.scene, film.oil.temperature, quantities)
}

/// Limits of the scene that an orbit at a given temperature exceeds over its cycle, by the numbers of that.
pub(crate) fn exceeded_over_cycle(scene: &Scene, quantities: &[Quantity]) -> Vec<Warning> {
    told(scene, Oil::of(scene).temperature, quantities)
}

/// Sentences about the limits that are missed at a temperature [K].
fn told(scene: &Scene, temperature: Option<f64>, quantities: &[Quantity]) -> Vec<Warning> {
    let compared = Compared {
        quantities,
        temperature,
    };
    let missed = limits(scene, None, &compared).into_iter();
    let missed = missed.filter(|limit| limit.decides && !limit.is_met);
    missed
        .map(|limit| {
            let value = format!("{:.DIGITS$e}", limit.value).parse().unwrap_or(limit.value);
            let (fault, value) = (limit.fault(), readable(value));
            let said = match (limit.verdict, limit.bar) {
                (Verdict::Undecided, None) => {
                    "a limit is open, as the mesh does not resolve the number (give a finer one: [mesh] size)"
                }
                (Verdict::Undecided, _) => "a limit lies inside the error bar",
                _ => "a limit is exceeded",
            };
            warning::LIMIT.says(format!("{said}: {fault} ([limits]): it is {value} {}", limit.unit))
        })
        .collect()
}

/// A limit, in the unit in which people read it.
struct Limit<'a> {
    what: &'a str,
    unit: &'a str,
    /// This unit over that of the number.
    scale: f64,
    value: Option<Judged>,
}

impl Limit<'_> {
    fn at_least(&self, limit: Option<f64>) -> Option<Criterion> {
        self.within([Some(self.scale * limit?), None])
    }

    fn at_most(&self, limit: Option<f64>) -> Option<Criterion> {
        self.within([None, Some(self.scale * limit?)])
    }

    fn within(&self, bounds: [Option<f64>; 2]) -> Option<Criterion> {
        let (value, bar) = self.value?;
        let value = (self.scale * value, bar.map(|bar| self.scale * bar));
        Some(Criterion::new(self.what, self.unit, value, bounds, true))
    }
}

const FILM: [&Row; 2] = [&FILM_THICKNESS_MIN, &CYCLE_FILM_THICKNESS_MIN];
const PRESSURE: [&Row; 2] = [&PRESSURE_MAX, &CYCLE_PRESSURE_MAX];
const OUTLET: [&Row; 2] = [&TEMPERATURE_OUTLET, &CYCLE_TEMPERATURE_OUTLET];

fn length<'a>(what: &'a str, value: Option<Judged>) -> Limit<'a> {
    Limit {
        what,
        unit: "um",
        scale: 1e6,
        value,
    }
}

fn pressure(compared: &Compared) -> Limit<'static> {
    Limit {
        what: "greatest pressure",
        unit: "bar",
        scale: 1e-5,
        value: compared.value(&PRESSURE),
    }
}

/// The limits of the scene; of a film whose temperature is found also those that its heat balance has without being asked.
fn limits(scene: &Scene, model: Option<&ThermalModel>, compared: &Compared) -> Vec<Criterion> {
    let limits = &scene.limits;
    let least_film = model.map(|model| model.least_film).or(limits.least_film);
    let hottest = model
        .map(|model| model.greatest_temperature)
        .or(limits.greatest_temperature);
    let celsius = |kelvin: f64| kelvin - ZERO_CELSIUS;
    let temperature = |what, value| Limit {
        what,
        unit: "degC",
        scale: 1.0,
        value,
    };
    let outlet = temperature("temperature of the oil that leaves", compared.value(&OUTLET));
    let all = [
        length("thinnest film", compared.value(&FILM)).at_least(least_film),
        temperature("temperature of the film", compared.temperature()).at_most(hottest.map(celsius)),
        pressure(compared).at_most(limits.greatest_pressure),
        outlet.at_most(model.map(|model| celsius(model.greatest_outlet))),
    ];
    all.into_iter().flatten().collect()
}

/// What the scene judges the bearing by beside its limits.
fn criteria(scene: &Scene, compared: &Compared) -> Vec<Criterion> {
    let Some(asked) = &scene.criteria else {
        return Vec::new();
    };
    let middle = compared.value(&[&MIDDLE_FILM_MIN, &CYCLE_MIDDLE_FILM_MIN]);
    let deviation = compared.value(&[&DEVIATION, &CYCLE_DEVIATION]);
    let equivalent = compared.value(&[&EQUIVALENT_FILM, &CYCLE_EQUIVALENT_FILM]);
    let decrement = Limit {
        what: "logarithmic decrement of the rotor",
        unit: "",
        scale: 1.0,
        value: compared.value(&[&LOGARITHMIC_DECREMENT]),
    };
    let contact = Limit {
        what: "share of contact in the load",
        unit: "",
        scale: 1.0,
        value: compared.value(&[&CONTACT_SHARE, &CYCLE_CONTACT_SHARE_MAX]),
    };
    let all = [
        length("least film", compared.value(&FILM)).at_least(asked.film_min),
        length("least film at mid-length", middle).at_least(asked.middle_film_min),
        length("deviation of the film at the ends", deviation).at_most(asked.deviation_max),
        length("equivalent film", equivalent).at_least(asked.equivalent_film_min),
        pressure(compared).at_most(asked.pressure_max),
        contact.at_most(asked.contact_share_max),
        decrement.at_least(asked.decrement_min),
    ];
    all.into_iter().flatten().collect()
}

/// What is usual in an engine.
fn usual(film: &Film, model: &ThermalModel, engine: Engine) -> Vec<Criterion> {
    let bearing = &film.problem.bearing;
    let celsius = |temperature: f64| temperature - ZERO_CELSIUS;
    let mut list = Vec::new();
    let mut usual = |what: &str, unit: &str, value: f64, range: [f64; 2]| {
        list.push(Criterion::new(what, unit, (value, None), range.map(Some), false));
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
