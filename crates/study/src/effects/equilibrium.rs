//! Equilibrium: the position in which the film carries a load. It is what the scene asks for, so it is not taken out.

use super::{BLANK, Effect, Socket};

pub(super) const ROW: Effect = Effect {
    name: "equilibrium",
    sentence: "the position is found where the film carries the load",
    socket: Socket::Position,
    is_in: |scene| scene.journal.load().is_some() && scene.orbit.is_none(),
    install: |scene, sockets| sockets.load = scene.journal.load(),
    ..BLANK
};
