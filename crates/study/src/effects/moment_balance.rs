//! Balance of moment: the tilt in which the film carries the moment of the load. It is what the scene asks for; leaving
//! out tilt leaves it out too.

use oilwedge_bearing::Tilting;

use super::{BLANK, Effect, Socket};

pub(super) const ROW: Effect = Effect {
    name: "moment balance",
    sentence: "the tilt is found where the film carries the moment of the load",
    socket: Socket::Position,
    is_in: |scene| scene.tilting().is_some(),
    install: |scene, sockets| {
        let force = scene.journal.load().unwrap_or_default();
        sockets.tilting = scene.tilting().map(|tilting| Tilting {
            moment: [0, 1].map(|d| tilting.at * force[d] + tilting.moment[d]),
            stiffness: tilting.support.map_or(0.0, |support| support.tilt_stiffness),
            support: tilting.support.map_or([0.0; 2], |support| support.tilt),
        });
    },
    ..BLANK
};
