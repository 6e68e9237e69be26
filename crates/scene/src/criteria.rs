//! `[criteria]`: what a bearing is judged by. Nothing of the film depends on it.

use crate::reader::TableReader;
use crate::{Complaints, Scene};

keys! {
    "criteria" = Table; "", "the bearing is not judged; with `[heat]` usual values are compared", "one key or more",
        "what the bearing is judged by: each number gets a verdict, pass, fail, or undecided where the limit lies inside its error bar";
    "criteria.film_min" = Quantity(Length); "2 um", "not judged; with `[heat]` the usual value is 4 um", "> 0",
        "the least film thickness h_min must be greater than this";
    "criteria.middle_film_min" = Quantity(Length); "4 um", "not judged", "> 0",
        "the least film thickness h_0 at mid-length must be greater than this";
    "criteria.deviation_max" = Quantity(Length); "5 um", "not judged", "> 0",
        "the deviation Delta_gamma must be less than this: h_0 less the least film at both ends";
    "criteria.equivalent_film_min" = Quantity(Length); "3 um", "not judged", "> 0",
        "the equivalent film h* = h_0/(1 + (Delta_gamma/s)^2) must be greater than this, s the `deviation_scale`";
    "criteria.deviation_scale" = Quantity(Length); "10 um", "10 um", "> 0",
        "deviation s that halves the equivalent film";
    "criteria.pressure_max" = Quantity(Pressure); "600 bar", "not judged", "> 0",
        "the greatest pressure p_max must be below this";
    "criteria.temperature_max" = Quantity(Temperature); "115 C", "not judged; with `[heat]` the usual value is 115 C", "-60 to 350 C, where the film has a temperature",
        "the temperature of the film must be below this";
    "criteria.outlet_max" = Quantity(Temperature); "125 C", "not judged; with `[heat]` the usual value is 125 C", "-60 to 350 C, with `[heat]`",
        "the temperature of the oil that leaves must be below this; 125 C is the greatest that ISO 7902-3 permits";
    "criteria.contact_share_max" = Number; "0.05", "not judged", "0 to 1, with `[contact]`",
        "the part of the load that contact carries must be below this";
    "criteria.decrement_min" = Number; "0.1", "not judged", ">= 0, with `dynamics.mass`",
        "the logarithmic decrement of the rotor must be greater than this: 0 is the limit of stability";
}

/// Deviation that halves the equivalent film [m] where none is given.
const USUAL_SCALE: f64 = 10e-6;

/// Tables in which a limit may stand; the second has older names of it.
pub(crate) const TABLES: [&str; 2] = ["criteria", "limits"];
/// Limits that may stand in several tables.
pub(crate) const SHARED: [&str; 4] = ["film_min", "temperature_max", "outlet_max", "pressure_max"];

/// Limits of the numbers that a bearing is judged by; `None`: a number is not judged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Criteria {
    /// Least film thickness [m].
    pub film_min: Option<f64>,
    /// Least film thickness at mid-length [m].
    pub middle_film_min: Option<f64>,
    /// Greatest deviation [m]: film at mid-length less that at the thinner end.
    pub deviation_max: Option<f64>,
    /// Least equivalent film [m].
    pub equivalent_film_min: Option<f64>,
    /// Deviation that halves the equivalent film [m].
    pub deviation_scale: f64,
    /// Greatest pressure [Pa].
    pub pressure_max: Option<f64>,
    /// Greatest mean temperature of the film [K].
    pub temperature_max: Option<f64>,
    /// Greatest temperature of the oil that leaves [K].
    pub outlet_max: Option<f64>,
    /// Greatest part of the load that contact carries [1].
    pub contact_share_max: Option<f64>,
    /// Least logarithmic decrement [1].
    pub decrement_min: Option<f64>,
}

impl Default for Criteria {
    /// Nothing is judged.
    fn default() -> Self {
        Self {
            film_min: None,
            middle_film_min: None,
            deviation_max: None,
            equivalent_film_min: None,
            deviation_scale: USUAL_SCALE,
            pressure_max: None,
            temperature_max: None,
            outlet_max: None,
            contact_share_max: None,
            decrement_min: None,
        }
    }
}

impl Criteria {
    /// The limits, and the shared ones of `other` where there are none.
    pub(crate) fn or(self, other: Self) -> Self {
        Self {
            film_min: self.film_min.or(other.film_min),
            pressure_max: self.pressure_max.or(other.pressure_max),
            temperature_max: self.temperature_max.or(other.temperature_max),
            outlet_max: self.outlet_max.or(other.outlet_max),
            ..self
        }
    }
}

impl Scene {
    /// Deviation [m] that halves the equivalent film, where a scene asks for the film at mid-length, the deviation or
    /// the equivalent film.
    pub fn deviation_scale(&self) -> Option<f64> {
        let criteria = &self.criteria;
        let asked = [criteria.middle_film_min, criteria.deviation_max, criteria.equivalent_film_min];
        (asked.iter().any(Option::is_some)).then_some(criteria.deviation_scale)
    }
}

/// The limits that stand in `[limits]` or `[heat]`.
pub(crate) fn read_shared(table: &mut TableReader<'_>) -> Criteria {
    Criteria {
        film_min: table.given("film_min"),
        temperature_max: table.oil_temperature("temperature_max").given(),
        outlet_max: table.oil_temperature("outlet_max").given(),
        ..Criteria::default()
    }
}

/// The limit of the pressure, which may stand in `[limits]` too.
pub(crate) fn read_pressure(table: &mut TableReader<'_>) -> Option<f64> {
    table.given("pressure_max")
}

pub(crate) fn read(mut table: TableReader<'_>) -> Criteria {
    let shared = read_shared(&mut table);
    let pressure_max = read_pressure(&mut table);
    let scale = table.number("deviation_scale");
    let scale = scale.or(USUAL_SCALE);
    let decrement = table
        .number("decrement_min")
        .within("is negative: it would pass rotors that whirl", "give 0 for the limit of stability, or more");
    let decrement_min = decrement.given();
    let contact_share = table
        .number("contact_share_max")
        .within("is no part of the load", "give the greatest part that contact may carry, from 0 to 1");
    let contact_share_max = contact_share.given();
    let mut length = |key: &'static str| table.given(key);
    let criteria = Criteria {
        middle_film_min: length("middle_film_min"),
        deviation_max: length("deviation_max"),
        equivalent_film_min: length("equivalent_film_min"),
        deviation_scale: scale,
        decrement_min,
        contact_share_max,
        pressure_max,
        ..shared
    };
    if table.is_readable() && table.keys().iter().all(|key| *key == "deviation_scale") {
        table.complain_here("has no criteria", "give a limit, for example film_min = \"2 um\", or remove the table");
    }
    criteria
}

/// Refuses a limit in a table that stands in one of `others` too.
pub(crate) fn refuse_beside(complaints: &mut Complaints, table: &str, others: &[&str], key: &str) {
    let own = format!("{table}.{key}");
    let other = others.iter().map(|other| format!("{other}.{key}"));
    let given: Vec<String> = other.filter(|other| complaints.has(&own) && complaints.has(other)).collect();
    if let Some(other) = given.first() {
        let help = "keep one of them; [criteria] works with [heat] and without";
        complaints.add(&own, format!("stands beside {other}"), help);
    }
}

/// A limit stands in one table, and has something to be compared with.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    for key in SHARED {
        refuse_beside(complaints, "limits", &["criteria"], key);
    }
    for table in TABLES {
        complaints.refuse_if(
            complaints.has(&format!("{table}.temperature_max")) && scene.given_temperature().is_none(),
            &format!("{table}.temperature_max"),
            "has nothing to be compared with: the film of this scene has no temperature",
            "add [heat], which finds it, or give oil.temperature with a law of temperature; or remove the limit",
        );
        complaints.refuse_if(
            complaints.has(&format!("{table}.outlet_max")) && scene.inlet_temperature().is_none(),
            &format!("{table}.outlet_max"),
            "has nothing to be compared with: without [heat] the oil leaves as warm as it enters",
            "add [heat], which finds the temperature, or remove the limit",
        );
    }
    let has_rotor = scene.dynamics.as_ref().is_some_and(|dynamics| dynamics.mass.is_some());
    complaints.refuse_if(
        complaints.has("criteria.decrement_min") && !has_rotor,
        "criteria.decrement_min",
        "has nothing to be compared with: the scene gives no rotor",
        "add [dynamics] with mass = \"200 kg\", the mass of the rotor for this bearing, or remove the criterion",
    );
    complaints.refuse_if(
        complaints.has("criteria.decrement_min") && scene.orbit.is_some(),
        "criteria.decrement_min",
        "stands beside [orbit]: the decrement is that of small motions around a position at rest",
        "remove it, or remove [orbit]",
    );
}

#[cfg(test)]
mod tests {
    use crate::scene::tests::{STUDY, read};

    #[test]
    fn criteria_are_read_or_refused() {
        let scene = |keys: &str| read(&format!("{STUDY}\n[criteria]\n{keys}\n"));
        let found = scene("film_min = \"2 um\"\ndeviation_max = \"5 um\"").expect("a scene");
        let criteria = found.criteria;
        assert_eq!((criteria.film_min, criteria.deviation_max), (Some(2.0 * 1e-6), Some(5.0 * 1e-6)));
        assert_eq!((criteria.deviation_scale, found.deviation_scale()), (1e-5, Some(1e-5)));
        assert_eq!(scene("film_min = \"2 um\"").expect("a scene").deviation_scale(), None);
        for (keys, wanted) in [
            ("", "criteria: has no criteria"),
            ("deviation_scale = \"5 um\"", "criteria: has no criteria"),
            ("film_min = \"0 um\"", "criteria.film_min"),
            ("decrement_min = 0.1", "criteria.decrement_min: has nothing to be compared with"),
            ("contact = 1", "criteria.contact: this key is not known"),
            ("contact_share_max = 0.1", "criteria.contact_share_max: has nothing to be compared with"),
            ("contact_share_max = 2", "criteria.contact_share_max: is no part of the load"),
        ] {
            let error = scene(keys).expect_err(keys).to_string();
            assert!(error.contains(wanted), "{error}");
        }
    }
}
