//! The keys of `[oil]`: one viscosity or one law of temperature, and one law of pressure at most.

use oilwedge_reynolds::lubricant::density::EXPANSION;
use oilwedge_reynolds::lubricant::{Density, ThermalOil};

use super::oil_law;
use crate::reader::TableReader;
use crate::scene::{BarusForm, Heat, Oil, PressureLaw, RoelandsExponent};
use crate::unit::Dimension;

/// Roelands' reference pressure where the scene gives none [Pa].
pub const ROELANDS_REFERENCE_PRESSURE: f64 = 196.2e6;
/// Temperature [K] at which a density without its own is given.
const AT_20: f64 = 293.15;

/// Reads `[oil]`; with `[heat]` the temperature of the film is found, and is that at which the search begins.
pub(super) fn read(mut table: TableReader<'_>, heat: Option<&Heat>) -> Oil {
    let viscosity = table.quantity_if_given("viscosity", Dimension::Viscosity, "40 mPa.s");
    let given_density = density(&mut table);
    let law = oil_law::read(&mut table, given_density);
    let temperature = table.quantity_if_given("temperature", Dimension::Temperature, "80 C");
    match (viscosity, law.is_given) {
        (None, false) => table.require(
            "viscosity",
            "\"40 mPa.s\", or grade = \"SAE 10W-40\" with temperature = \"80 C\"",
        ),
        (Some(_), true) => table.complain(
            "viscosity",
            "stands beside a law by which viscosity depends on temperature",
            "keep one of viscosity, grade, walther, vogel and table",
        ),
        (Some(_), false) if heat.is_some() => table.complain(
            "viscosity",
            "is one viscosity, but [heat] needs one that falls with temperature",
            "give grade = \"SAE 10W-40\", walther, vogel or table in place of it, or remove [heat]",
        ),
        (Some(_), false) if temperature.is_some() => table.complain(
            "temperature",
            "has a meaning only where viscosity depends on it",
            "remove it, or give grade = \"SAE 10W-40\", walther, vogel or table in place of viscosity",
        ),
        _ => {}
    }
    match heat {
        Some(_) if temperature.is_some() && law.is_given => table.complain(
            "temperature",
            "stands beside [heat], which finds it",
            "remove it, or remove [heat]",
        ),
        None if law.is_given => table.require("temperature", "\"80 C\", or a table [heat] that finds it"),
        _ => {}
    }
    let temperature = match heat {
        Some(heat) if law.is_given => Some(heat.first_temperature()),
        _ => temperature,
    };
    if table.has("barus") && table.has("roelands") {
        let help = "keep one law, and remove the other";
        table.complain(
            "roelands",
            "stands beside barus, but viscosity follows one law of pressure",
            help,
        );
    }
    let barus = table.table_if_given("barus").map(barus);
    let roelands = table.table_if_given("roelands").map(roelands);
    table.finish();
    let of_law = law.law.map(|law_of_temperature| ThermalOil {
        law: law_of_temperature,
        density: law.density.unwrap_or_default(),
    });
    let at = |oil: &ThermalOil| temperature.map_or(f64::NAN, |temperature| oil.viscosity(temperature));
    Oil {
        viscosity: viscosity.or_else(|| of_law.as_ref().map(at)).unwrap_or(f64::NAN),
        pressure_law: barus.or(roelands).unwrap_or(PressureLaw::Constant),
        thermal: of_law,
        temperature,
        density: law.density,
    }
}

/// `density = "885 kg/m3"` at 20 degrees C, or a table with the temperature at which it was measured.
fn density(table: &mut TableReader<'_>) -> Option<Density> {
    if !table.holds_table("density") {
        let density = table.quantity_if_given("density", Dimension::Density, "885 kg/m3")?;
        return Some(Density::of(density, AT_20, EXPANSION));
    }
    let mut table = table.table_if_given("density")?;
    let density = table.quantity("value", Dimension::Density, "868 kg/m3");
    let at = table.quantity_if_given("at", Dimension::Temperature, "15 C");
    let expansion = table.quantity_if_given("expansion", Dimension::InverseTemperature, "68.8e-5 1/K");
    table.finish();
    Some(Density::of(
        density,
        at.unwrap_or(AT_20),
        expansion.unwrap_or(EXPANSION),
    ))
}

fn barus(mut table: TableReader<'_>) -> PressureLaw {
    let alpha = table.quantity("alpha", Dimension::InversePressure, "2.5e-8 1/Pa");
    let forms = [
        ("conservative", BarusForm::Conservative),
        ("as-printed", BarusForm::AsPrinted),
    ];
    let form = table.word_if_given("form", &forms).unwrap_or_default();
    table.finish();
    PressureLaw::Barus { alpha, form }
}

fn roelands(mut table: TableReader<'_>) -> PressureLaw {
    let z = table.number_if_given("z", "0.6");
    let alpha = table.quantity_if_given("alpha", Dimension::InversePressure, "2.0e-8 1/Pa");
    let reference_pressure = table.quantity_if_given("reference_pressure", Dimension::Pressure, "196.2 MPa");
    let exponent = match (z, alpha) {
        (Some(z), None) => RoelandsExponent::Z(z),
        (None, Some(alpha)) => RoelandsExponent::Alpha(alpha),
        (Some(_), Some(_)) => {
            table.complain(
                "alpha",
                "stands beside z, but one of them gives the other",
                "keep one of z and alpha",
            );
            RoelandsExponent::Z(f64::NAN)
        }
        (None, None) => {
            if table.is_readable() {
                table.complain("z", "is missing", "write z = 0.6, or alpha = \"2.0e-8 1/Pa\" instead");
            }
            RoelandsExponent::Z(f64::NAN)
        }
    };
    table.finish();
    PressureLaw::Roelands {
        exponent,
        reference_pressure: reference_pressure.unwrap_or(ROELANDS_REFERENCE_PRESSURE),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schema::tests::{STUDY, read, told_one};

    #[test]
    fn laws_are_checked() {
        told_one(
            "1/Pa\"",
            "1/Pa\", form = \"printed\"",
            "oil.barus.form: \"printed\" is not known",
        );
        told_one(
            "1/Pa\" }",
            "1/Pa\" }, roelands = { z = 0.6 }",
            "oil.roelands: stands beside barus",
        );
        told_one(
            "barus = { alpha = \"2.5e-8 1/Pa\" }",
            "roelands = {}",
            "oil.roelands.z: is missing",
        );
        told_one(
            "barus = { alpha = ",
            "roelands = { z = 0.6, alpha = ",
            "oil.roelands.alpha: stands beside z",
        );
    }

    #[test]
    fn other_laws_are_read() {
        let text = STUDY.replace(
            "barus = { alpha = \"2.5e-8 1/Pa\" }",
            "roelands = { alpha = \"20 1/GPa\" }",
        );
        let law = read(&text).map(|scene| scene.oil.pressure_law).ok();
        let exponent = RoelandsExponent::Alpha(20.0 * 1e-9);
        assert_eq!(
            law,
            Some(PressureLaw::Roelands {
                exponent,
                reference_pressure: 196.2e6
            })
        );
        let text = STUDY.replace("1/Pa\"", "1/Pa\", form = \"as-printed\"");
        let law = read(&text).map(|scene| scene.oil.pressure_law).ok();
        assert_eq!(
            law,
            Some(PressureLaw::Barus {
                alpha: 2.5e-8,
                form: BarusForm::AsPrinted
            })
        );
    }
}
