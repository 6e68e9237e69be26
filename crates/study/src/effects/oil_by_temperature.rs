//! Oil by temperature: the viscosity that the scene gives is that at the temperature of the film.

use oilwedge_reynolds::lubricant::TemperatureLaw;
use oilwedge_scene::Viscosity;
use oilwedge_scene::wording::celsius;

use super::{BLANK, Effect, Socket};
use crate::film::Film;
use crate::thermal::flows::rounded;
use crate::warning::{self, Warning};

pub(super) const ROW: Effect = Effect {
    name: "oil by temperature",
    sentence: "viscosity and density are those at the temperature of the film",
    socket: Socket::Lubricant,
    is_in: |scene| matches!(scene.oil.viscosity, Viscosity::ByTemperature(_)),
    warnings: |film, _| Vec::from_iter(outside_table(film)),
    ..BLANK
};

/// That a temperature that was sought lies outside the table of viscosities.
fn outside_table(film: &Film) -> Option<Warning> {
    let oil = &film.oil;
    film.thermal?;
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
