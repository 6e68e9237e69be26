//! Oil by temperature: the viscosity that the scene gives is that at the temperature of the film.

use oilwedge_reynolds::lubricant::TemperatureLaw;
use oilwedge_scene::Viscosity;
use oilwedge_scene::wording::celsius;

use super::{BLANK, Effect, Socket};
use crate::film::Film;
use crate::measure::Measured;
use crate::regime::broken_assumption;
use crate::thermal::flows::rounded;
use crate::warning::{self, Warning};

pub(super) const ROW: Effect = Effect {
    name: "oil by temperature",
    sentence: "viscosity and density are those at the temperature of the film",
    socket: Socket::Lubricant,
    is_in: |scene| matches!(scene.oil.viscosity, Viscosity::ByTemperature(_)),
    warnings: |film, measured| outside_table(film).into_iter().chain(sheared(film, measured)).collect(),
    ..BLANK
};

/// Shear rate [1/s] at which engine oils are measured at high shear, and from which on their polymers yield (SAE J300).
const HIGH_SHEAR: f64 = 1e6;

/// The warning that a multigrade oil is sheared faster than its viscosity holds.
fn sheared(film: &Film, measured: &Measured) -> Option<Warning> {
    let name = film.oil.unsheared?;
    let rate = (film.problem.surface_velocity()[0] / measured.thinnest.thickness).abs();
    (rate > HIGH_SHEAR).then(|| {
        broken_assumption(warning::SHEARED.says(format!(
            "viscosity at low shear: the thinnest film is sheared at {rate:.1e} 1/s, where a multigrade oil as {name} has lost some 20 to 30 % of its viscosity; give oil.high_shear, the viscosity at 150 C and 1e6 1/s of its data sheet or a factor as 0.8"
        )))
    })
}

/// The warning that a temperature that was sought lies outside the table of viscosities.
fn outside_table(film: &Film) -> Option<Warning> {
    let oil = &film.oil;
    film.model.sockets.thermal?;
    let (temperature, TemperatureLaw::Table(table)) = (oil.temperature?, &oil.thermal.as_ref()?.law) else {
        return None;
    };
    let [from, to] = table.range();
    (temperature < from || temperature > to).then(|| {
        warning::VISCOSITY_LAW.says(format!(
            "the film has {}, but oil.table reaches from {} to {}: its last line was extrapolated",
            celsius(rounded(temperature)),
            celsius(from),
            celsius(to)
        ))
    })
}
