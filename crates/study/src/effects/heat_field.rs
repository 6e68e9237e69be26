//! The temperature as a field: across the film and along it, in the bush, the journal and the feeds.

use oilwedge_bearing::ThermalBalance;
use oilwedge_bearing::heat_round::{HeatSurroundings, WallExpansion};
use oilwedge_heat::{BushRing, BushShape, BushSide, JournalSide, Layers, OilProperties};
use oilwedge_scene::{HeatBush, Scene};

use super::{BLANK, Effect, Socket, Sockets, changed, heat};
use crate::thermal_model::{HeatFieldModel, ThermalModel};

pub(super) const ROW: Effect = Effect {
    name: "heat: field",
    sentence: "the temperature is found at each place of the film and across it, with bush, journal and feeds",
    socket: Socket::Temperature,
    kind: heat::KIND,
    is_in: |scene| scene.heat.is_some_and(|heat| heat.field.is_some()),
    install,
    instead: "a film of one temperature",
    remove: |scene| {
        changed(scene, |scene| {
            if let Some(heat) = &mut scene.heat {
                heat.field = None;
            }
        })
    },
    no_proportion: Some([
        "heat.field",
        "finds temperatures, which depend on all motions together",
        "remove [heat], and give oil.temperature or oil.viscosity",
    ]),
    ..BLANK
};

fn install(scene: &Scene, sockets: &mut Sockets) {
    let asked = scene.heat.and_then(|heat| Some((heat, heat.field?)));
    sockets.heat_field = asked.map(|(heat, field)| {
        let balance = ThermalBalance { inlet: heat.inlet, heat_capacity: heat.heat_capacity, housing: None };
        HeatFieldModel {
            even: ThermalModel { balance, mixing: None, engine: heat.engine },
            layers: field.layers.and_then(Layers::new),
            surroundings: HeatSurroundings {
                oil: OilProperties { capacity: heat.heat_capacity, conductivity: scene.oil.conductivity },
                inlet: heat.inlet,
                bush: field.bush.map_or(BushSide::Adiabatic, |bush| ring(scene, &bush)),
                journal: field
                    .journal
                    .map_or(JournalSide::Turning { conductance: 0.0, ambient: heat.inlet }, |shaft| {
                        JournalSide::Turning { conductance: shaft.conductance, ambient: shaft.ambient }
                    }),
                expansion: field.expansion.map(|walls| WallExpansion {
                    radius: scene.bearing.radius(),
                    journal: walls.shaft,
                    bush: walls.bush,
                    at: walls.at,
                }),
            },
        }
    });
}

/// The ring around the film of a scene.
fn ring(scene: &Scene, bush: &HeatBush) -> BushSide {
    let shape = BushShape {
        inner_radius: scene.bearing.radius(),
        outer_radius: 0.5 * bush.outer_diameter,
        length: scene.bearing.length,
        conductivity: bush.conductivity,
        transfer: bush.transfer,
        ambient: bush.ambient,
    };
    BushSide::Ring(BushRing::new(shape, BushRing::AROUND, BushRing::ALONG))
}
