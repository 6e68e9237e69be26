//! `density` of `[oil]`: `density = "885 kg/m3"` at 20 degrees C, or a table with the temperature at which it was
//! measured.

use crate::reader::{Number, TableReader};
use crate::unit::ZERO_CELSIUS;

keys! {
    "oil.density" = Quantity(Density), Table; "885 kg/m3", "that of the grade; else 870 kg/m3", "500 to 2500 kg/m3",
        "density at 20 degrees C, or a table with the temperature of its measurement; it makes kinematic viscosity dynamic";
    "oil.density.value" = Quantity(Density); "868 kg/m3", "required", "500 to 2500 kg/m3",
        "the density measured at the temperature `at`";
    "oil.density.at" = Quantity(Temperature); "15 C", "20 C", "-60 to 350 C",
        "temperature at which the density was measured";
    "oil.density.expansion" = Quantity(InverseTemperature); "68.8e-5 1/K", "68.8e-5 1/K", "0 to 2e-3 1/K",
        "relative expansion k_v in rho = rho_20 [1 - k_v (t - 20 C)]";
}

/// A density that was measured at some temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredDensity {
    /// Density [kg/m3].
    pub value: f64,
    /// Temperature [K] at which it was measured.
    pub at: f64,
    /// Relative expansion k_v [1/K]; `None`: that of mineral oils.
    pub expansion: Option<f64>,
}

pub(super) fn read(oil: &mut TableReader<'_>) -> Option<MeasuredDensity> {
    if !oil.holds_table("density") {
        let value = of_liquid(oil.number("density")).given()?;
        return Some(MeasuredDensity { value, at: ZERO_CELSIUS + 20.0, expansion: None });
    }
    let mut table = oil.table_if_given("density")?;
    let expansion = table.number("expansion").within_or(
        |_, [least, most]| format!("is not the expansion of an oil: {least} to {most} 1/K"),
        "give some 65e-5 to 75e-5 1/K for mineral oil, or remove it",
    );
    Some(MeasuredDensity {
        expansion: expansion.given(),
        value: of_liquid(table.number("value")).required(),
        at: table.oil_temperature("at").or_usual(),
    })
}

fn of_liquid<'t, 'a>(density: Number<'t, 'a>) -> Number<'t, 'a> {
    density.within_or(
        |_, [least, most]| format!("is not the density of an oil: {least} to {most} kg/m3"),
        "give some 850 to 900 kg/m3 for mineral oil; is it in kg/m3?",
    )
}
