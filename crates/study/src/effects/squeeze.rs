//! Squeeze: the journal's centre moves.

use std::sync::Arc;

use oilwedge_reynolds::CentreVelocity;
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_scene::Scene;

use super::{BLANK, Effect, changed};

/// How reports call it.
pub(super) const KIND: &str = "squeeze";

pub(super) const ROW: Effect = Effect {
    name: KIND,
    sentence: "oil pressed out as the journal's centre moves or its axis turns",
    kind: KIND,
    is_in: |scene| scene.journal.motion().is_some() || scene.journal.tilts() || scene.orbit.is_some(),
    install: |scene, sockets| {
        sockets.terms.push(Arc::new(Squeeze));
        sockets.centre_velocity = (scene.journal.motion()).map_or(Default::default(), |motion| CentreVelocity {
            radial: motion.radial,
            tangential: motion.tangential,
        });
    },
    instead: "a journal whose axis is at rest",
    remove: |scene| {
        // A journal on an orbit moves.
        let at_rest = |scene: &mut Scene| {
            scene.journal.squeeze = None;
            scene.journal.tilt_rate = scene.journal.tilt_rate.map(|_| [0.0; 2]);
        };
        scene.orbit.is_none().then(|| changed(scene, at_rest)).flatten()
    },
    ..BLANK
};
