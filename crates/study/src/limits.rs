//! The limits of a scene against a solved film.

use oilwedge_reynolds::existence::readable;
use oilwedge_scene::wording::{bars, celsius};

use crate::film::Film;
use crate::measure::Measured;
use crate::warning::{self, Warning};

/// Limits of the scene that the film exceeds, in sentences that name them; those of a film whose temperature is found are criteria of its balance.
pub(crate) fn exceeded(film: &Film, measured: &Measured) -> Vec<Warning> {
    if film.thermal.is_some() {
        return Vec::new();
    }
    let limits = &film.scene.limits;
    let micrometres = |length: f64| {
        format!(
            "{} um",
            readable(format!("{:.3e}", 1e6 * length).parse().unwrap_or(1e6 * length))
        )
    };
    let thickness = measured.thinnest.thickness;
    let thin = limits.least_film.filter(|&least| thickness < least).map(|least| {
        format!(
            "the least film is {}, below limits.film_min, {}",
            micrometres(thickness),
            micrometres(least)
        )
    });
    let pressure = measured.extremes.greatest;
    let high = limits.greatest_pressure.filter(|&most| pressure > most).map(|most| {
        format!(
            "the pressure reaches {}, above limits.pressure_max, {}",
            bars(pressure),
            bars(most)
        )
    });
    let hot = limits
        .greatest_temperature
        .zip(film.oil.temperature)
        .filter(|(most, t)| t >= most)
        .map(|(most, t)| {
            format!(
                "the film is at {}, and limits.temperature_max is {}",
                celsius(t),
                celsius(most)
            )
        });
    let all = [thin, high, hot].into_iter().flatten();
    let told = |limit: String| warning::LIMIT.says(format!("a limit is exceeded: {limit}"));
    all.map(told).collect()
}
