//! `[heat]`: the balance that finds the temperature of the film, and what carries the heat off.

pub(crate) mod field;

pub use field::{HeatBush, HeatExpansion, HeatField, HeatJournal};

use crate::criteria::{Criteria, SHARED, TABLES, read_shared, refuse_beside};
use crate::reader::TableReader;
use crate::{Complaints, Scene, TheoryKey, Viscosity};

keys! {
    "heat" = Table; "", "the temperature of the film is given, or has no effect", "",
        "the film temperature at which the oil carries off the heat of friction";
    "heat.inlet" = Quantity(Temperature); "75 C", "required unless `preset`", "-60 to 350 C",
        "temperature t_0 of the oil that is fed";
    "heat.heat_capacity" = Quantity(HeatCapacity); "1.8 MJ/(m3.K)", "1.8 MJ/(m3 K)", "0.5 to 5 MJ/(m3 K)",
        "rho c, density times specific heat";
    "heat.housing" = Table; "", "all heat leaves with the oil", "",
        "the heat that the housing gives off";
    "heat.housing.conductance" = Quantity(Conductance); "5 W/K", "required unless `transfer` and `area`", "> 0",
        "conductance G of the housing, which gives off the heat G (t - t_a), t the temperature of the film";
    "heat.housing.transfer" = Quantity(HeatTransfer); "17 W/(m2.K)", "`conductance` gives it", "> 0",
        "instead of `conductance`: G is `transfer` times `area`";
    "heat.housing.area" = Quantity(Area); "500 cm2", "required with `transfer`", "> 0",
        "surface of the housing, with `transfer`";
    "heat.housing.ambient" = Quantity(Temperature); "40 C", "required", "-60 to 350 C",
        "temperature t_a around the housing";
    "heat.mixing" = Table; "", "fresh oil only", "",
        "hot oil that goes round and mixes with the fresh one";
    "heat.mixing.ratio" = Number; "0.06", "required unless `share`", ">= 0",
        "hot oil over fresh oil, q_0/q_1; the film is fed with t_in = t_0 + (t_out - t_in) q_0/q_1";
    "heat.mixing.share" = Number; "0.7", "`ratio` gives it", "0 to 1",
        "instead of `ratio`: the share of the oil carried round that mixes with the fresh oil";
    "heat.film_min" = Quantity(Length); "2 um", "`criteria.film_min`", "> 0",
        "an older name of `criteria.film_min`";
    "heat.temperature_max" = Quantity(Temperature); "115 C", "`criteria.temperature_max`", "-60 to 350 C",
        "an older name of `criteria.temperature_max`";
    "heat.outlet_max" = Quantity(Temperature); "125 C", "`criteria.outlet_max`", "-60 to 350 C",
        "an older name of `criteria.outlet_max`";
    "heat.preset" = Choice(&["petrol", "diesel"]); "petrol", "none", "",
        "a crankshaft bearing of such an engine: fills `inlet`, `bearing.clearance` and the `pressure` of feeds where the scene leaves them out, and values outside the usual ranges are reported";
}

/// The heat balance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heat {
    /// Temperature of the oil that is fed [K].
    pub inlet: f64,
    /// Heat capacity per volume rho c [J/(m3 K)].
    pub heat_capacity: f64,
    /// What the housing gives off; `None`: all heat leaves with the oil.
    pub housing: Option<HousingTable>,
    /// Hot oil that is carried over and mixes with the fresh one; `None`: the film gets fresh oil.
    pub mixing: Option<Mixing>,
    /// The engine that the bearing belongs to.
    pub engine: Option<EngineKind>,
    /// The temperature as a field; `None`: the film has one temperature.
    pub field: Option<HeatField>,
}

/// A housing at the temperature of the film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HousingTable {
    /// Heat conductance G from the film to its surroundings [W/K].
    pub conductance: f64,
    /// Temperature t_a of the surroundings [K].
    pub ambient: f64,
}

/// How much hot oil is carried over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mixing {
    /// Hot oil over fresh oil, q_0/q_1 [1].
    Ratio(f64),
    /// A share [1] of the oil that the film carries around.
    Share(f64),
}

/// Usual values of an engine's crankshaft bearings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EngineKind {
    /// Spark ignition.
    Petrol,
    /// Compression ignition.
    Diesel,
}

impl EngineKind {
    /// Name in scenes and reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Petrol => "petrol",
            Self::Diesel => "diesel",
        }
    }

    /// Usual diametral clearance over the diameter [1].
    pub fn clearance_ratio(self) -> [f64; 2] {
        match self {
            Self::Petrol => [0.5e-3, 0.7e-3],
            Self::Diesel => [0.7e-3, 1.0e-3],
        }
    }

    /// Usual pressure of the oil that is fed [Pa].
    pub fn feed_pressure(self) -> [f64; 2] {
        match self {
            Self::Petrol => [0.3e6, 0.4e6],
            Self::Diesel => [0.4e6, 0.6e6],
        }
    }

    /// Usual temperature of the oil that is fed [K].
    pub fn inlet(self) -> [f64; 2] {
        match self {
            Self::Petrol => [343.15, 348.15],
            Self::Diesel => [348.15, 353.15],
        }
    }

    /// The middle of a range.
    pub(crate) fn middle([from, to]: [f64; 2]) -> f64 {
        0.5 * (from + to)
    }
}

impl Complaints {
    /// True if something is wrong with a table that the temperature of the film depends on.
    pub fn concern_temperature(&self) -> bool {
        self.concern("oil") || self.concern("heat")
    }
}

impl Scene {
    /// Temperature [K] of the oil fed, where that of the film is found.
    pub fn inlet_temperature(&self) -> Option<f64> {
        self.heat.map(|heat| heat.inlet)
    }

    /// Key and value [K] of the temperature at which the scene gives the oil: of that fed where the film's is found,
    /// else of the film; none where the viscosity does not depend on it.
    pub fn given_temperature(&self) -> Option<(&'static str, f64)> {
        match &self.heat {
            Some(heat) => Some(("heat.inlet", heat.inlet)),
            None => Some(("oil.temperature", self.oil.temperature?)),
        }
    }
}

/// The table, and the limits in it.
pub(crate) fn read(mut table: TableReader<'_>) -> (Heat, Criteria) {
    let engines = [EngineKind::Petrol, EngineKind::Diesel].map(|engine| (engine.name(), engine));
    let engine = table.word("preset", &engines);
    if !table.has("preset") {
        let example = "\"75 C\", the temperature of the oil that is fed, or preset = \"petrol\"";
        table.require_as("inlet", example);
    }
    let usual = engine.map_or(f64::NAN, |engine| EngineKind::middle(engine.inlet()));
    let heat_capacity = table.number("heat_capacity").within_or(
        |_, [least, most]| format!("is not the heat capacity of an oil: {least:e} to {most:e} J/(m3.K)"),
        "give some 1.8 MJ/(m3.K), density times specific heat, or remove it",
    );
    let heat_capacity = heat_capacity.or_usual();
    let limits = read_shared(&mut table);
    let heat = Heat {
        heat_capacity,
        inlet: table.oil_temperature("inlet").or(usual),
        housing: table.table_if_given("housing").map(housing),
        mixing: table.table_if_given("mixing").and_then(mixing),
        engine,
        field: field::read(&mut table),
    };
    (heat, limits)
}

/// The conductance as one number, or as that of a surface times its area.
fn housing(mut table: TableReader<'_>) -> HousingTable {
    let conductance = table.given("conductance");
    let transfer = table.given("transfer");
    let area = table.given("area");
    let conductance = match (conductance, transfer, area) {
        (None, None, None) => {
            let example = "\"5 W/K\", or transfer = \"17 W/(m2.K)\" and area = \"500 cm2\"";
            table.require_as("conductance", example);
            f64::NAN
        }
        (Some(conductance), None, None) => conductance,
        (conductance, transfer, area) => {
            let help = "keep conductance, or transfer and area";
            let message = "stands beside transfer and area, which give it";
            table.refuse_if(conductance.is_some(), "conductance", message, help);
            table.require("transfer");
            table.require("area");
            transfer.unwrap_or(f64::NAN) * area.unwrap_or(f64::NAN)
        }
    };
    let ambient = table.oil_temperature("ambient").required();
    HousingTable { conductance, ambient }
}

fn mixing(mut table: TableReader<'_>) -> Option<Mixing> {
    let ratio = table.number("ratio").within("is negative", "give hot oil over fresh oil, q_0/q_1, or remove mixing");
    let ratio = ratio.given();
    let share = table.number("share").within(
        "is not between 0 and 1",
        "give the share of the oil carried around that mixes with the fresh one, some 0.5 to 0.9",
    );
    let share = share.given();
    let help = "write mixing = { ratio = 0.06 }, hot oil over fresh oil, or mixing = { share = 0.7 } of what the film carries around";
    if ratio.is_some() && share.is_some() {
        table.complain_here("has ratio and share, but one of them gives the hot oil", help);
    } else if table.is_readable() && table.keys().is_empty() {
        table.complain_here("does not say how much hot oil mixes", help);
    }
    ratio.map(Mixing::Ratio).or(share.map(Mixing::Share))
}

/// A balance needs an oil whose viscosity falls with temperature, and a way out for the heat.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    field::check(scene, complaints);
    let Some(heat) = &scene.heat else { return };
    for key in SHARED {
        refuse_beside(complaints, "heat", &TABLES, key);
    }
    match scene.oil.viscosity {
        Viscosity::Constant(viscosity) => complaints.refuse_if(
            !viscosity.is_nan(),
            "oil.viscosity",
            "is one viscosity, but [heat] needs one that falls with temperature",
            "give grade = \"SAE 10W-40\", walther, vogel, exponential or table in place of it, or remove [heat]",
        ),
        Viscosity::ByTemperature(_) => complaints.refuse_if(
            complaints.has("oil.temperature"),
            "oil.temperature",
            "stands beside [heat], which finds it",
            "remove it, or remove [heat]",
        ),
    }
    complaints.refuse_if(
        scene.bearing.theory == TheoryKey::Long && heat.housing.is_none(),
        "bearing.theory",
        "\"long\" seals the ends, so that no oil carries heat off",
        "give heat.housing, or another theory",
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::tests::{STUDY, good, read, told};

    const OIL: &str = "oil = { viscosity = \"0.4 Pa.s\"";

    fn with(heat: &str) -> String {
        format!("heat = {{ {heat} }}\n") + &STUDY.replacen(OIL, "oil = { grade = \"SAE 30\"", 1)
    }

    #[test]
    fn a_balance_is_read_in_si() {
        let scene = |keys: &str| read(&with(keys)).unwrap_or_else(|error| panic!("{error}"));
        let heat = |keys: &str| scene(keys).heat.expect("a balance");
        let plain = heat("inlet = \"75 C\"");
        assert_eq!((plain.inlet, plain.heat_capacity), (348.15, 1.8e6));
        assert_eq!((plain.housing, plain.mixing), (None, None));
        let limits = scene("inlet = \"75 C\", film_min = \"2 um\", temperature_max = \"130 C\"").criteria;
        assert_eq!((limits.film_min, limits.temperature_max), (Some(2e-6), Some(403.15)));
        let full = heat(
            "preset = \"diesel\", heat_capacity = \"1800 kJ/(m3 K)\", film_min = \"2 um\", temperature_max = \"130 C\", \
             housing = { transfer = \"20 W/(m2 K)\", area = \"0.1 m2\", ambient = \"30 C\" }, mixing = { share = 0.5 }",
        );
        assert_eq!(
            (full.inlet, full.engine, full.mixing),
            (350.65, Some(EngineKind::Diesel), Some(Mixing::Share(0.5)))
        );
        let housing = full.housing.expect("a housing");
        assert!((housing.conductance - 2.0).abs() < 1e-12 && (housing.ambient - 303.15).abs() < 1e-9);
        assert_eq!(heat("inlet = \"60 C\", preset = \"petrol\"").inlet, 333.15);
        assert_eq!(heat("inlet = \"60 C\", mixing = { ratio = 0.1 }").mixing, Some(Mixing::Ratio(0.1)));
    }

    /// What an engine usually has fills what the scene leaves out, and nothing else.
    #[test]
    fn a_preset_fills_clearance_and_pressure() {
        let text = with("preset = \"petrol\"")
            .replace(", clearance = \"37.5 um\"", "")
            .replace(", pressure = \"1.96 bar\"", "");
        let scene = read(&text).expect("a scene");
        assert!((scene.bearing.clearance / (0.5 * 0.6e-3 * 0.075) - 1.0).abs() < 1e-12);
        assert!((scene.feeds[0].pressure.expect("a pressure") / 0.35e6 - 1.0).abs() < 1e-12);
        let scene = read(&with("preset = \"petrol\"")).expect("a scene");
        assert_eq!(scene.bearing.clearance, 37.5e-6);
        let error = read(&text.replace("preset", "inlet = \"75 C\", zzz")).expect_err("no clearance").to_string();
        assert!(error.contains("bearing.clearance: is missing"), "{error}");
    }

    #[test]
    fn what_is_wrong_with_a_balance_is_told() {
        for (keys, wanted) in [
            ("", "heat.inlet: is missing"),
            ("inlet = 75", "heat.inlet: a bare number has no unit; a temperature is wanted"),
            ("preset = \"steam\"", "heat.preset: \"steam\" is not known"),
            ("inlet = \"75 C\", heat_capacity = \"1.8 kJ/K\"", "heat.heat_capacity: \"kJ/K\" is not a unit"),
            ("inlet = \"75 C\", housing = { ambient = \"30 C\" }", "heat.housing.conductance: is missing"),
            ("inlet = \"75 C\", housing = { conductance = \"5 W/K\" }", "heat.housing.ambient: is missing"),
            (
                "inlet = \"75 C\", housing = { transfer = \"20 W/(m2.K)\", ambient = \"30 C\" }",
                "heat.housing.area: is missing",
            ),
            (
                "inlet = \"75 C\", housing = { conductance = \"5 W/K\", transfer = \"20 W/(m2.K)\", area = \"1 m2\", ambient = \"30 C\" }",
                "heat.housing.conductance: stands beside transfer and area",
            ),
            ("inlet = \"75 C\", mixing = {}", "heat.mixing: does not say how much"),
            ("inlet = \"75 C\", mixing = { ratio = 0.1, share = 0.1 }", "heat.mixing: has ratio and share"),
            ("inlet = \"75 C\", mixing = 0.1", "heat.mixing: a table is wanted"),
            ("inlet = \"75 C\", ambient = \"30 C\"", "heat.ambient: this key is not known"),
        ] {
            let error = read(&with(keys)).expect_err(wanted).to_string();
            assert!(error.contains(wanted) && error.lines().count() == 2, "{keys}: {error}");
        }
        let told = told("title = ", "heat = { inlet = \"75 C\" }\ntitle = ");
        assert_eq!(told.len(), 1);
        assert!(told[0].to_string().starts_with("oil.viscosity: is one viscosity"), "{told:?}");
        let text = with("inlet = \"75 C\"").replace("\"SAE 30\"", "\"SAE 30\", temperature = \"80 C\"");
        let error = read(&text).expect_err("two temperatures").to_string();
        assert!(error.contains("oil.temperature: stands beside [heat]"), "{error}");
    }

    const VISCOSITY: &str = "[oil]\nviscosity = \"0.4 Pa.s\"";

    fn beside(heat: &str) -> String {
        format!("[heat]\n{heat}\n[oil]\ngrade = \"SAE 30\"\n")
    }

    #[test]
    fn balances_are_checked() {
        assert!(good::told(VISCOSITY, &beside("inlet = \"75 C\"")).is_empty());
        for (heat, wanted) in [
            ("inlet = \"75 K\"", "heat.inlet: is -198.15 C, but oil films are liquid"),
            ("inlet = \"75 C\"\nheat_capacity = \"1.8 kJ/(m3.K)\"", "heat.heat_capacity: is not the heat capacity"),
            ("inlet = \"75 C\"\nfilm_min = \"0 um\"", "heat.film_min: is not positive"),
            ("inlet = \"75 C\"\ntemperature_max = \"500 C\"", "heat.temperature_max: is 500 C"),
            (
                "inlet = \"75 C\"\nhousing = { conductance = \"0 W/K\", ambient = \"40 C\" }",
                "heat.housing.conductance: is not positive",
            ),
            (
                "inlet = \"75 C\"\nhousing = { transfer = \"-1 W/(m2.K)\", area = \"1 m2\", ambient = \"40 C\" }",
                "heat.housing.transfer: is not positive",
            ),
            ("inlet = \"75 C\"\nmixing = { ratio = -0.1 }", "heat.mixing.ratio: is negative"),
            ("inlet = \"75 C\"\nmixing = { share = 1.1 }", "heat.mixing.share: is not between"),
        ] {
            good::told_one(VISCOSITY, &beside(heat), wanted);
        }
    }
}
