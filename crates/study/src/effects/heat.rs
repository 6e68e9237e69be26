//! The heat balance: the temperature at which the oil carries off what friction makes.

use oilwedge_bearing::{Housing, ThermalBalance};
use oilwedge_reynolds::existence::readable;
use oilwedge_scene::Scene;
use oilwedge_scene::wording::celsius;

use super::{Effect, Socket, Sockets, changed};
use crate::film::Film;
use crate::measure::Measured;
use crate::thermal::flows::{rounded, thermal_flows};
use crate::thermal_model::ThermalModel;
use crate::warning::{self, Warning};

/// Viscosity where the oil enters over that where it leaves, from which on one temperature does not describe the film.
const UNEVEN: f64 = 2.0;
/// Share of the oil that leaves which a cavity creates, from which the heat that it carries is worth a warning.
const CREATED: f64 = 0.05;

pub(super) const KIND: &str = "heat";

pub(super) const ROW: Effect = Effect {
    name: KIND,
    sentence: "the temperature is found at which the oil carries off what friction makes",
    socket: Socket::Temperature,
    kind: KIND,
    is_in: |scene| scene.heat.is_some_and(|heat| heat.field.is_none()),
    install,
    instead: "a film as warm as the oil that is fed",
    remove: |scene| {
        changed(scene, |scene| {
            if let Some(heat) = scene.heat.take() {
                scene.oil.temperature = Some(heat.inlet);
            }
        })
    },
    no_proportion: Some([
        KIND,
        "finds a temperature, which depends on all motions together",
        "remove [heat], and give oil.temperature or oil.viscosity",
    ]),
    warnings,
};

fn install(scene: &Scene, sockets: &mut Sockets) {
    sockets.thermal = scene.heat.map(|heat| ThermalModel {
        balance: ThermalBalance {
            inlet: heat.inlet,
            heat_capacity: heat.heat_capacity,
            housing: heat.housing.map(|housing| Housing { conductance: housing.conductance, ambient: housing.ambient }),
        },
        mixing: heat.mixing,
        engine: heat.engine,
    });
}

fn warnings(film: &Film, measured: &Measured) -> Vec<Warning> {
    let (Some(model), Some(temperature), Some(oil)) =
        (&film.model.sockets.thermal, film.oil.temperature, &film.oil.thermal)
    else {
        return Vec::new();
    };
    let flows = thermal_flows(model, film, measured);
    let [inlet, outlet] = model.balance.ends(temperature, flows.carried_over);
    let ratio = oil.viscosity(inlet) / oil.viscosity(outlet);
    let created = measured.flows.cavity / flows.flow;
    let created = (flows.flow > 0.0 && created > CREATED).then(|| {
        warning::CREATED.says(format!(
            "{:.0} % of the oil that carries the heat off is created by the cavity, which does not conserve oil where the film forms again: the film is hotter if the feeds bring no more; give [cavitation] the model jfo",
            100.0 * created
        ))
    });
    let uneven = (ratio > UNEVEN).then(|| {
        warning::UNEVEN.says(format!(
            "an assumption does not hold: one temperature of the film: its oil is {} times as viscous where it enters, at {}, as where it leaves, at {}; give heat.field = true",
            readable(format!("{ratio:.1e}").parse().unwrap_or(ratio)),
            celsius(rounded(inlet)),
            celsius(rounded(outlet))
        ))
    });
    created.into_iter().chain(uneven).collect()
}
