//! `high_shear` of `[oil]`: what is left of the viscosity at the shear rates of a film, as the viscosity at 150 degrees
//! C and 1e6 1/s of a data sheet, or as a factor.

use crate::reader::TableReader;

keys! {
    "oil.high_shear" = Quantity(Viscosity), Number; "2.9 mPa.s", "low shear", "a factor: 0.3 to 1",
        "what shear leaves of the viscosity: that at 150 degrees C and 1e6 1/s (HTHS) of the data sheet, or a factor as 0.8; with a law of temperature";
}

/// What high shear rates leave of the viscosity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HighShear {
    /// Dynamic viscosity [Pa.s] at 150 degrees C and 1e6 1/s, as ASTM D4683 measures it and SAE J300 limits it (HTHS).
    Viscosity(f64),
    /// Viscosity over that at low shear [1], at any temperature.
    Factor(f64),
}

pub(super) fn read(oil: &mut TableReader<'_>) -> Option<HighShear> {
    if oil.holds_text("high_shear") {
        return oil.number("high_shear").positive().given().map(HighShear::Viscosity);
    }
    let factor = oil.number("high_shear").within_or(
        |_, [least, most]| format!("is not what shear leaves of a viscosity: {least} to {most}"),
        "give a factor as 0.8, or the viscosity at 150 C and 1e6 1/s of the data sheet, as \"2.9 mPa.s\"",
    );
    factor.given().map(HighShear::Factor)
}
