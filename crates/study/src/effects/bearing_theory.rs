//! Short and long bearings: pressure drives oil in one direction only.

use oilwedge_reynolds::Theory;
use oilwedge_scene::{self as scene, Scene};

use super::{BLANK, Effect, Socket, changed};
use crate::film::Film;
use crate::warning::{self, Warning};

/// The B/D up to which the theory of short bearings suits.
pub const SHORT_TO: f64 = 0.25;
/// The B/D from which on the theory of long bearings suits.
pub const LONG_FROM: f64 = 2.0;

pub(super) const SHORT: Effect = Effect {
    name: "theory: short",
    sentence: "pressure drives oil along the axis only",
    is_in: |scene| scene.bearing.theory == scene::TheoryKey::Short,
    install: |_, sockets| sockets.theory = Theory::Short,
    warnings: |film, _| {
        let slenderness = slenderness(film);
        let warning = || left_out(film, "around", format!("below {SHORT_TO}"));
        Vec::from_iter((slenderness > SHORT_TO).then(warning))
    },
    ..ROW
};

pub(super) const LONG: Effect = Effect {
    name: "theory: long",
    sentence: "pressure drives oil around only, the ends are sealed",
    is_in: |scene| scene.bearing.theory == scene::TheoryKey::Long,
    install: |_, sockets| sockets.theory = Theory::Long,
    warnings: |film, _| {
        let slenderness = slenderness(film);
        let warning = || left_out(film, "along the axis", format!("above {LONG_FROM}"));
        Vec::from_iter((slenderness < LONG_FROM).then(warning))
    },
    ..ROW
};

const ROW: Effect =
    Effect { socket: Socket::FlowFactors, instead: "pressure flow in both directions", remove: without, ..BLANK };

fn without(scene: &Scene) -> Option<Scene> {
    changed(scene, |scene| scene.bearing.theory = scene::TheoryKey::Full)
}

fn slenderness(film: &Film) -> f64 {
    0.5 * film.problem.bearing.length / film.problem.bearing.radius
}

fn left_out(film: &Film, direction: &str, fit: String) -> Warning {
    warning::THEORY.says(format!(
        "theory = \"{}\" leaves out the flow that pressure drives {direction}; it suits B/D {fit}, and here B/D is {:.2}; --theories compares the result with that of both flows",
        film.problem.theory.name(),
        slenderness(film)
    ))
}
