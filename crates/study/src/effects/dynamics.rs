//! Stiffness and damping: how the film answers to small motions of the journal. The film itself is the same without.

use super::{BLANK, Effect, Socket, changed};

pub(super) const ROW: Effect = Effect {
    name: "stiffness and damping",
    sentence: "forces of the film on a journal that moves a little, at the temperature of the film",
    socket: Socket::Analysis,
    is_in: |scene| scene.dynamics.is_some(),
    install: |scene, sockets| sockets.dynamics.clone_from(&scene.dynamics),
    instead: "the film alone, without its stiffness and damping",
    remove: |scene| changed(scene, |scene| scene.dynamics = None),
    ..BLANK
};
