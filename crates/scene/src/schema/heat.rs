//! The keys of `[heat]`: what heats the oil, what carries the heat off, and what will do.

use oilwedge_bearing::Housing;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;

use crate::reader::TableReader;
use crate::scene::{Engine, Heat, Mixing};
use crate::unit::Dimension;

/// Heat capacity per volume of mineral oil [J/(m3 K)].
const HEAT_CAPACITY: f64 = 1.8e6;
/// Least film thickness that will do where the scene gives none [m].
const LEAST_FILM: f64 = 4e-6;
/// Mean temperature that must not be reached where the scene gives none [K].
const GREATEST_TEMPERATURE: f64 = ZERO_CELSIUS + 115.0;

pub(super) fn read(mut table: TableReader<'_>) -> Heat {
    let engines = [Engine::Petrol, Engine::Diesel].map(|engine| (engine.name(), engine));
    let engine = table.word_if_given("preset", &engines);
    if !table.has("preset") {
        table.require(
            "inlet",
            "\"75 C\", the temperature of the oil that is fed, or preset = \"petrol\"",
        );
    }
    let inlet = table.quantity_if_given("inlet", Dimension::Temperature, "75 C");
    let usual = || engine.map_or(f64::NAN, |engine| Engine::middle(engine.inlet()));
    let mut given = |key, dimension, example| table.quantity_if_given(key, dimension, example);
    let heat_capacity = given("heat_capacity", Dimension::HeatCapacity, "1.8 MJ/(m3.K)");
    let least_film = given("film_min", Dimension::Length, "4 um");
    let greatest_temperature = given("temperature_max", Dimension::Temperature, "115 C");
    let housing = table.table_if_given("housing").map(housing);
    let mixing = table.table_if_given("mixing").and_then(mixing);
    table.finish();
    Heat {
        inlet: inlet.unwrap_or_else(usual),
        heat_capacity: heat_capacity.unwrap_or(HEAT_CAPACITY),
        housing,
        mixing,
        engine,
        least_film: least_film.unwrap_or(LEAST_FILM),
        greatest_temperature: greatest_temperature.unwrap_or(GREATEST_TEMPERATURE),
    }
}

/// The heat that goes through it per kelvin, as one number or as that of a surface times its area.
fn housing(mut table: TableReader<'_>) -> Housing {
    let of_surface = table.has("transfer") || table.has("area");
    if of_surface && table.has("conductance") {
        let help = "keep conductance, or transfer and area";
        table.complain("conductance", "stands beside transfer and area, which give it", help);
    }
    let conductance = match of_surface {
        true => {
            table.quantity_if_given("conductance", Dimension::Conductance, "5 W/K");
            let transfer = table.quantity("transfer", Dimension::HeatTransfer, "17 W/(m2.K)");
            transfer * table.quantity("area", Dimension::Area, "500 cm2")
        }
        false => {
            let example = "\"5 W/K\", or transfer = \"17 W/(m2.K)\" and area = \"500 cm2\"";
            table.require("conductance", example);
            let conductance = table.quantity_if_given("conductance", Dimension::Conductance, "5 W/K");
            table.quantity_if_given("transfer", Dimension::HeatTransfer, "17 W/(m2.K)");
            table.quantity_if_given("area", Dimension::Area, "500 cm2");
            conductance.unwrap_or(f64::NAN)
        }
    };
    let ambient = table.quantity("ambient", Dimension::Temperature, "40 C");
    table.finish();
    Housing { conductance, ambient }
}

fn mixing(mut table: TableReader<'_>) -> Option<Mixing> {
    let ratio = table.number_if_given("ratio", "0.06");
    let share = table.number_if_given("share", "0.7");
    let help = "write mixing = { ratio = 0.06 }, hot oil over fresh oil, or mixing = { share = 0.7 } of what the film carries round";
    match (ratio, share) {
        (Some(_), Some(_)) => table.complain_here("has ratio and share, but one of them gives the hot oil", help),
        (None, None) if table.is_readable() && table.keys().is_empty() => {
            table.complain_here("says not how much hot oil mixes", help);
        }
        _ => {}
    }
    table.finish();
    ratio.map(Mixing::Ratio).or(share.map(Mixing::Share))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schema::tests::{STUDY, read, told};

    const OIL: &str = "oil = { viscosity = \"0.4 Pa.s\"";

    fn with(heat: &str) -> String {
        format!("heat = {{ {heat} }}\n") + &STUDY.replacen(OIL, "oil = { grade = \"SAE 30\"", 1)
    }

    #[test]
    fn a_balance_is_read_in_si() {
        let heat = |keys: &str| {
            read(&with(keys))
                .unwrap_or_else(|error| panic!("{error}"))
                .heat
                .expect("a balance")
        };
        let plain = heat("inlet = \"75 C\"");
        assert_eq!(
            (plain.inlet, plain.heat_capacity, plain.least_film),
            (348.15, 1.8e6, 4e-6)
        );
        assert_eq!(
            (plain.greatest_temperature, plain.housing, plain.mixing),
            (388.15, None, None)
        );
        let scene = read(&with("inlet = \"75 C\"")).expect("a scene");
        assert_eq!(scene.oil.temperature, Some(358.15));
        assert!(scene.oil.viscosity > 0.005 && scene.oil.viscosity < 0.02);
        let full = heat(
            "preset = \"diesel\", heat_capacity = \"1800 kJ/(m3 K)\", film_min = \"2 um\", temperature_max = \"130 C\", \
             housing = { transfer = \"20 W/(m2 K)\", area = \"0.1 m2\", ambient = \"30 C\" }, mixing = { share = 0.5 }",
        );
        assert_eq!(
            (full.inlet, full.engine, full.mixing),
            (350.65, Some(Engine::Diesel), Some(Mixing::Share(0.5)))
        );
        let housing = full.housing.expect("a housing");
        assert!((housing.conductance - 2.0).abs() < 1e-12 && (housing.ambient - 303.15).abs() < 1e-9);
        assert_eq!(heat("inlet = \"60 C\", preset = \"petrol\"").inlet, 333.15);
        assert_eq!(
            heat("inlet = \"60 C\", mixing = { ratio = 0.1 }").mixing,
            Some(Mixing::Ratio(0.1))
        );
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
        let error = read(&text.replace("preset", "inlet = \"75 C\", zzz"))
            .expect_err("no clearance")
            .to_string();
        assert!(error.contains("bearing.clearance: is missing"), "{error}");
    }

    #[test]
    fn what_is_wrong_with_a_balance_is_told() {
        for (keys, wanted) in [
            ("", "heat.inlet: is missing"),
            (
                "inlet = 75",
                "heat.inlet: a bare number has no unit; a temperature is wanted",
            ),
            ("preset = \"steam\"", "heat.preset: \"steam\" is not known"),
            (
                "inlet = \"75 C\", heat_capacity = \"1.8 kJ/K\"",
                "heat.heat_capacity: \"kJ/K\" is not a unit",
            ),
            (
                "inlet = \"75 C\", housing = { ambient = \"30 C\" }",
                "heat.housing.conductance: is missing",
            ),
            (
                "inlet = \"75 C\", housing = { conductance = \"5 W/K\" }",
                "heat.housing.ambient: is missing",
            ),
            (
                "inlet = \"75 C\", housing = { transfer = \"20 W/(m2.K)\", ambient = \"30 C\" }",
                "heat.housing.area: is missing",
            ),
            (
                "inlet = \"75 C\", housing = { conductance = \"5 W/K\", transfer = \"20 W/(m2.K)\", area = \"1 m2\", ambient = \"30 C\" }",
                "heat.housing.conductance: stands beside transfer and area",
            ),
            ("inlet = \"75 C\", mixing = {}", "heat.mixing: says not how much"),
            (
                "inlet = \"75 C\", mixing = { ratio = 0.1, share = 0.1 }",
                "heat.mixing: has ratio and share",
            ),
            ("inlet = \"75 C\", mixing = 0.1", "heat.mixing: a table is wanted"),
            (
                "inlet = \"75 C\", ambient = \"30 C\"",
                "heat.ambient: this key is not known",
            ),
        ] {
            let error = read(&with(keys)).expect_err(wanted).to_string();
            assert!(error.contains(wanted) && error.lines().count() == 2, "{keys}: {error}");
        }
        let told = told("title = ", "heat = { inlet = \"75 C\" }\ntitle = ");
        assert_eq!(told.len(), 1);
        assert!(
            told[0].to_string().starts_with("oil.viscosity: is one viscosity"),
            "{told:?}"
        );
        let text = with("inlet = \"75 C\"").replace("\"SAE 30\"", "\"SAE 30\", temperature = \"80 C\"");
        let error = read(&text).expect_err("two temperatures").to_string();
        assert!(error.contains("oil.temperature: stands beside [heat]"), "{error}");
    }
}
