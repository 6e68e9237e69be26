//! What all models of cavitation share.

use oilwedge_scene::CavitationModel;
use oilwedge_scene::Scene;

use super::{BLANK, CAVITATION, Effect, Socket, changed};

/// What the rows of all models have in common.
pub(super) const ROW: Effect = Effect {
    socket: Socket::Cavitation,
    kind: CAVITATION,
    instead: "a full film that bears tension",
    // Without a cavity that conserves oil there is no starved inlet either.
    remove: |scene| {
        changed(scene, |scene| {
            scene.cavitation = None;
            scene.bearing.inlet_fraction = None;
        })
    },
    ..BLANK
};

/// Whether a scene has this model.
pub(super) fn is(scene: &Scene, model: CavitationModel) -> bool {
    scene.cavitation.is_some_and(|cavitation| cavitation.model == model)
}

/// The cavitation pressure [Pa] of a scene, zero without one.
pub(super) fn pressure(scene: &Scene) -> f64 {
    scene.cavitation.map_or(0.0, |cavitation| cavitation.pressure)
}

/// The cavitation pressure [Pa], nowhere above a given pressure. Equal pressures in other units may differ in the last
/// digit.
pub(super) fn least_pressure(scene: &Scene) -> f64 {
    let fed = scene.feeds.iter().filter_map(|feed| feed.pressure);
    fed.fold(pressure(scene).min(scene.ends.pressure), f64::min)
}
