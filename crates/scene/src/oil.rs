//! `[oil]`: one viscosity or one law of temperature, one law of pressure at most, and the density.

pub(crate) mod barus;
pub(crate) mod density;
pub(crate) mod high_shear;
pub(crate) mod roelands;
pub(crate) mod temperature;

pub use barus::{BarusForm, BarusTable};
pub use density::MeasuredDensity;
pub use high_shear::HighShear;
pub use roelands::{RoelandsExponent, RoelandsTable};
pub use temperature::{PointViscosity, TemperatureLawTable, ViscosityPoint};

use crate::reader::TableReader;
use crate::{Complaints, Scene};

keys! {
    "oil" = Table; "", "required", "",
        "viscosity and density of the oil";
    "oil.viscosity" = Quantity(Viscosity); "40 mPa.s", "required unless a law of temperature", "> 0",
        "dynamic viscosity mu0 at gauge pressure zero";
    "oil.temperature" = Quantity(Temperature); "80 C", "required with a law of temperature, unless `[heat]` finds it", "-60 to 350 C; within the `table`",
        "temperature of the oil in the film, at which its viscosity is taken";
    "oil.conductivity" = Quantity(ThermalConductivity); "0.13 W/(m.K)", "0.13 W/(m K)", "0.01 to 10 W/(m K)",
        "heat conductivity k of the oil, by which heat goes from layer to layer where `heat.field` finds the temperature as a field";
}

/// The oil.
#[derive(Debug, Clone, PartialEq)]
pub struct OilTable {
    /// Viscosity of the oil at gauge pressure zero.
    pub viscosity: Viscosity,
    /// How the viscosity depends on pressure.
    pub pressure_law: PressureLawTable,
    /// Temperature of the film [K], where the scene gives it.
    pub temperature: Option<f64>,
    /// Heat conductivity k [W/(m K)].
    pub conductivity: f64,
    /// Density, where the scene gives it.
    pub density: Option<MeasuredDensity>,
    /// What high shear rates leave of the viscosity, where the scene gives it.
    pub high_shear: Option<HighShear>,
}

/// Dynamic viscosity at gauge pressure zero.
#[derive(Debug, Clone, PartialEq)]
pub enum Viscosity {
    /// One number mu0 [Pa.s].
    Constant(f64),
    /// Falls with temperature.
    ByTemperature(TemperatureLawTable),
}

/// How the viscosity depends on pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PressureLawTable {
    /// Constant viscosity: mu = mu0.
    Constant,
    /// Barus' law: mu = mu0 exp(alpha p).
    Barus(BarusTable),
    /// Roelands' law: mu = mu0 exp((ln mu0 + 9.67) ((1 + p/p_r)^z - 1)), mu0 in Pa.s.
    Roelands(RoelandsTable),
}

/// Reads a law of pressure.
type ReadLaw = fn(TableReader<'_>) -> PressureLawTable;
/// Laws of pressure by the table that gives them.
const PRESSURE_LAWS: &[(&str, ReadLaw)] = &[
    ("barus", barus::read),       // mu0 exp(alpha p)
    ("roelands", roelands::read), // mu0 exp((ln mu0 + 9.67) ((1 + p/p_r)^z - 1))
];

/// Keys of the laws of pressure.
pub(crate) fn pressure_law_keys() -> impl Iterator<Item = String> {
    PRESSURE_LAWS.iter().map(|(name, _)| format!("oil.{name}"))
}

/// What a law of pressure may not do, as the end of a sentence.
const THINNER: &str = "is negative, so the oil would grow thinner under pressure";

/// Keys that must fit each other.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    barus::check(scene, complaints);
}

/// Reads the table; `wanted` is an example of the temperature that a viscosity which depends on it needs, if the scene
/// must give it.
pub(crate) fn read(mut table: TableReader<'_>, wanted: Option<&str>) -> OilTable {
    let constant = table.given("viscosity");
    let law = temperature::read(&mut table);
    let temperature = table.oil_temperature("temperature").given();
    match (constant, &law) {
        (None, None) => {
            table.require_as("viscosity", "\"40 mPa.s\", or grade = \"SAE 10W-40\" with temperature = \"80 C\"")
        }
        (Some(_), Some(_)) => table.complain(
            "viscosity",
            "stands beside a law by which viscosity depends on temperature",
            "keep one of viscosity, grade, walther, vogel, exponential and table",
        ),
        (Some(_), None) if temperature.is_some() && wanted.is_some() => table.complain(
            "temperature",
            "has a meaning only where viscosity depends on it",
            "remove it, or give grade = \"SAE 10W-40\", walther, vogel, exponential or table in place of viscosity",
        ),
        _ => {}
    }
    if let (Some(example), Some(_)) = (wanted, &law) {
        table.require_as("temperature", example);
    }
    let conductivity = table
        .number("conductivity")
        .within("is not the heat conductivity of an oil", "give some 0.13 W/(m.K), or remove it");
    let conductivity = conductivity.or_usual();
    let high_shear = high_shear::read(&mut table);
    table.refuse_if(
        high_shear.is_some() && law.is_none(),
        "high_shear",
        "has a meaning only beside a law by which viscosity depends on temperature",
        "remove it, and give the viscosity of the sheared oil",
    );
    let laws = PRESSURE_LAWS.iter().filter_map(|(key, read)| Some((*key, read(table.table_if_given(key)?))));
    let laws: Vec<_> = laws.collect();
    if let [(first, _), (second, _), ..] = laws[..] {
        let message = format!("stands beside {first}, but viscosity follows one law of pressure");
        table.complain(second, message, "keep one law, and remove the other");
    }
    let constant = Viscosity::Constant(constant.unwrap_or(f64::NAN));
    OilTable {
        viscosity: law.map_or(constant, Viscosity::ByTemperature),
        pressure_law: laws.first().map_or(PressureLawTable::Constant, |(_, law)| *law),
        temperature,
        conductivity,
        density: density::read(&mut table),
        high_shear,
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::tests::told_one;

    #[test]
    fn there_is_one_law_of_pressure() {
        told_one("1/Pa\" }", "1/Pa\" }, roelands = { z = 0.6 }", "oil.roelands: stands beside barus");
    }
}
