//! What to doubt in the temperature of a film.

use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::lubricant::TemperatureLaw;

use super::film_heat;
use crate::compile::Study;
use crate::measure::Measured;
use oilwedge_scene::wording::celsius;

/// Viscosity where the oil enters over that where it leaves, from which one temperature for all of the film tells little.
const UNEVEN: f64 = 2.0;
/// Share of the oil that leaves which a cavity makes, from which the heat that it carries is worth a warning.
const MADE: f64 = 0.05;

/// Doubts, in sentences; none without a balance of heat.
pub fn doubts(study: &Study, measured: &Measured) -> Vec<String> {
    let (Some(heat), Some(temperature), Some(oil)) = (&study.heat, study.oil.temperature, &study.oil.thermal) else {
        return Vec::new();
    };
    let film = film_heat(heat, study, measured);
    let [inlet, outlet] = heat.balance().ends(temperature, film.carried_over);
    let ratio = oil.viscosity(inlet) / oil.viscosity(outlet);
    let made = measured.flows.cavity / film.flow;
    let outside = match &oil.law {
        TemperatureLaw::Table(table) => {
            Some(table.range()).filter(|[from, to]| temperature < *from || temperature > *to)
        }
        TemperatureLaw::Vogel(_) | TemperatureLaw::Walther(_) => None,
    };
    let told = [
        (film.flow > 0.0 && made > MADE).then(|| {
            format!(
                "{:.0} % of the oil that carries the heat off is made by the cavity, which conserves none where the film forms again: the film is hotter than that if the feeds bring no more; take [cavitation] model = \"jfo\"",
                100.0 * made
            )
        }),
        (ratio > UNEVEN).then(|| {
            format!(
                "an assumption does not hold: one temperature of the film: its oil is {} times as viscous where it enters, at {}, as where it leaves, at {}",
                readable(format!("{ratio:.1e}").parse().unwrap_or(ratio)),
                celsius(rounded(inlet)),
                celsius(rounded(outlet))
            )
        }),
        outside.map(|[from, to]| {
            format!(
                "the film has {}, but oil.table reaches from {} to {}: its last line was followed beyond",
                celsius(rounded(temperature)),
                celsius(from),
                celsius(to)
            )
        }),
    ];
    told.into_iter().flatten().collect()
}

/// To a tenth of a kelvin [K].
fn rounded(temperature: f64) -> f64 {
    // That of the ice point is a tenth and a twentieth.
    (10.0 * (temperature - 0.05)).round() / 10.0 + 0.05
}
