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
use crate::result::{Accuracy, Criterion, CriterionSpread, Origin};
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

/// Criteria judged with the spread of the numbers that they compare; one whose number is not spread stays as it is.
pub fn judged_with_spread(criteria: &[Criterion], quantities: &[Quantity]) -> Vec<Criterion> {
    let spread = |criterion: &Criterion| {
        let (quantity, size) = criterion.compared(quantities)?;
        let own = quantity.spread.as_ref()?;
        let (most_by, _) = own.shares.iter().max_by(|a, b| a.1.total_cmp(b.1))?;
        let around = own.corners.map_or([-own.worst_case, own.worst_case], |ends| ends.map(|end| end - quantity.value));
        let range = around.map(|change| criterion.value + size * change);
        Some(CriterionSpread { range, most_by: most_by.clone() })
    };
    let judged = |criterion: &Criterion| match spread(criterion) {
        Some(spread) => criterion.clone().with_spread(spread),
        None => criterion.clone(),
    };
    criteria.iter().map(judged).collect()
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

/// What a criterion compares: words, unit and its size, and the rows of the number, of which a film has one.
struct Judged {
    what: &'static str,
    unit: &'static str,
    /// Size of this unit over that of the number.
    scale: f64,
    rows: &'static [&'static Row],
}

macro_rules! judged {
    ($($name:ident = $what:literal, $unit:literal, $scale:literal, [$($row:ident),+];)+) => {
        $(static $name: Judged = Judged { what: $what, unit: $unit, scale: $scale, rows: &[$(&$row),+] };)+
        /// Everything that the criteria of a scene compare.
        static JUDGED: &[&Judged] = &[$(&$name),+];
    };
}

judged! {
    LEAST_FILM = "least film", "um", 1e6, [FILM_THICKNESS_MIN, CYCLE_FILM_THICKNESS_MIN];
    MIDDLE_FILM = "least film at mid-length", "um", 1e6, [MIDDLE_FILM_MIN, CYCLE_MIDDLE_FILM_MIN];
    END_DEVIATION = "deviation of the film at the ends", "um", 1e6, [DEVIATION, CYCLE_DEVIATION];
    EQUIVALENT = "equivalent film", "um", 1e6, [EQUIVALENT_FILM, CYCLE_EQUIVALENT_FILM];
    PRESSURE = "greatest pressure", "bar", 1e-5, [PRESSURE_MAX, CYCLE_PRESSURE_MAX];
    TEMPERATURE = "temperature of the film", "degC", 1.0, [TEMPERATURE_MAX, TEMPERATURE_EFFECTIVE, CYCLE_TEMPERATURE];
    OUTLET = "temperature of the oil that leaves", "degC", 1.0, [TEMPERATURE_OUTLET, CYCLE_TEMPERATURE_OUTLET];
    CONTACT = "share of contact in the load", "", 1.0, [CONTACT_SHARE, CYCLE_CONTACT_SHARE_MAX];
    DECREMENT = "logarithmic decrement of the rotor", "", 1.0, [LOGARITHMIC_DECREMENT];
}

impl Criterion {
    /// The quantity that this criterion compares, and the size of its unit over that of the quantity; `None` where it
    /// compares what is given.
    pub fn compared<'q>(&self, quantities: &'q [Quantity]) -> Option<(&'q Quantity, f64)> {
        let judged = JUDGED.iter().find(|judged| judged.what == self.what)?;
        let of_row = |row: &&'static Row| quantities.iter().find(|quantity| quantity.row == *row);
        judged.rows.iter().find_map(of_row).map(|quantity| (quantity, judged.scale))
    }
}

/// What the scene judges the bearing by, and what is usual where its heat `is_balanced`.
fn criteria(asked: &Criteria, is_balanced: bool, compared: &Compared) -> Vec<Criterion> {
    let celsius = |kelvin: f64| kelvin - ZERO_CELSIUS;
    let usual = |value: f64| is_balanced.then_some(value);
    let of = |judged: &Judged| {
        let value = match judged.unit {
            "degC" if judged.rows != OUTLET.rows => compared.temperature(),
            _ => compared.value(judged.rows),
        };
        Limited { what: judged.what, unit: judged.unit, scale: judged.scale, value }
    };
    let all = [
        of(&LEAST_FILM).at_least(asked.film_min, usual(USUAL_FILM)),
        of(&MIDDLE_FILM).at_least(asked.middle_film_min, None),
        of(&END_DEVIATION).at_most(asked.deviation_max, None),
        of(&EQUIVALENT).at_least(asked.equivalent_film_min, None),
        of(&PRESSURE).at_most(asked.pressure_max, None),
        of(&TEMPERATURE).at_most(asked.temperature_max.map(celsius), usual(USUAL_TEMPERATURE)),
        of(&OUTLET).at_most(asked.outlet_max.map(celsius), usual(USUAL_OUTLET)),
        of(&CONTACT).at_most(asked.contact_share_max, None),
        of(&DECREMENT).at_least(asked.decrement_min, None),
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
