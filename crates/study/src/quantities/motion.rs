//! What it takes to move the journal's centre.

use super::row::Measure::One;
use super::rule::ErrorRule;
use crate::effects::Sockets;

rows! {
    /// `P_e = W . de/dt`: the load times the velocity of the journal's centre; with P the whole power of a film that is fed no pressure;
    /// none where the centre rests
    MOTION_POWER = "squeeze_power", "P_e", Watt, "power of the load as the journal's centre moves":
        One(|film| { let moves = film.journal().velocity != [0.0; 2]; moves.then(|| film.measured.motion_power(film.journal())) }),
        ErrorRule::Of("dual-weighted, along and across the load",
            |estimate, at| Some(estimate.product(at.view.journal().velocity))),
        only(|scene| Sockets::of(scene).centre_velocity.speed() > 0.0);
}
