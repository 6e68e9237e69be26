//! Roughness: what it changes of the flow of oil.

use std::sync::Arc;

use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::flow_factors::PatirCheng;
use oilwedge_scene::Roughness;

use super::{BLANK, Effect, ROUGHNESS, Socket, changed};
use crate::film::Film;
use crate::measure::Measured;
use crate::regime::broken_assumption;
use crate::warning::{self, Warning};

/// Film over roughness below which the factors were not found.
const FOUND: f64 = 0.5;

pub(super) const ROW: Effect = Effect {
    name: "flow factors",
    sentence: "oil flows between rough surfaces: less by pressure, and through the valleys",
    socket: Socket::FlowFactors,
    kind: ROUGHNESS,
    is_in: |scene| scene.roughness.is_some(),
    install: |scene, sockets| {
        if let (Some(Roughness::PatirCheng), Some(roughness)) = (scene.roughness, scene.bearing.roughness) {
            sockets.flow_factors.push(Arc::new(PatirCheng { roughness }));
        }
    },
    instead: "the flow between smooth surfaces",
    remove: |scene| changed(scene, |scene| scene.roughness = None),
    warnings,
    ..BLANK
};

fn warnings(film: &Film, measured: &Measured) -> Vec<Warning> {
    let ratio = (film.model.roughness).map(|roughness| measured.thinnest.thickness / roughness);
    let beyond = ratio.filter(|ratio| *ratio < FOUND).map(|ratio| {
        let ratio = format!("{ratio:.1e}").parse().unwrap_or(ratio);
        broken_assumption(warning::VALLEYS.says(format!(
            "flow factors: the least film is {} times bearing.roughness, below the {FOUND} times from which on they were found",
            readable(ratio)
        )))
    });
    Vec::from_iter(beyond)
}
