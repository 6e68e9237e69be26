//! Starved inlets: the oil that the journal brings in at the edge of an arc fills part of the gap.

use super::{BLANK, Effect, Socket, changed};

pub(super) const ROW: Effect = Effect {
    name: "starved inlet",
    sentence: "the oil brought in at the edge of the arc fills part of the gap",
    socket: Socket::Supply,
    is_in: |scene| scene.bearing.inlet_fraction.is_some(),
    install: |scene, sockets| sockets.inlet_fraction = scene.bearing.inlet_fraction,
    instead: "a flooded inlet",
    remove: |scene| changed(scene, |scene| scene.bearing.inlet_fraction = None),
    ..BLANK
};
