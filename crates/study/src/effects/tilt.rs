//! Misalignment: the journal's axis is inclined to that of the bearing.

use std::sync::Arc;

use oilwedge_reynolds::film_thickness::Tilt;
use oilwedge_scene::Scene;

use super::{BLANK, Contribution, Effect, Socket, changed};

/// How reports call what is left out without it.
pub(super) const KIND: &str = "misalignment";

pub(super) const ROW: Effect = Effect {
    name: "tilt",
    sentence: "the journal's axis is inclined to that of the bearing",
    socket: Socket::FilmThickness,
    kind: KIND,
    is_in: Scene::can_tilt,
    install: |scene, sockets| {
        let tilt = Arc::new(Tilt { radius: scene.bearing.radius() });
        sockets.film_thickness.push(Contribution::Given(tilt));
        sockets.tilt_rate = scene.journal.tilt_rate.unwrap_or_default();
    },
    instead: "a journal parallel to the bearing",
    remove: |scene| {
        changed(scene, |scene| {
            scene.journal.tilt = None;
            scene.journal.tilt_rate = None;
            scene.load_at = None;
            scene.load_moment = None;
            scene.support = None;
        })
    },
    ..BLANK
};
