//! Orbit: the path of the journal under a load over a cycle. It is what the scene asks for, so it is not taken out.

use super::{BLANK, Effect, Socket};

pub(super) const ROW: Effect = Effect {
    name: "orbit",
    sentence: "the journal moves so that the film carries the load at every crank angle",
    socket: Socket::Position,
    is_in: |scene| scene.orbit.is_some(),
    ..BLANK
};
