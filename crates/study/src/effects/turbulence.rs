//! Turbulence: the film resists flow and shear by its Reynolds number at each place.

use std::sync::Arc;

use oilwedge_reynolds::flow_factors::TurbulenceModel;
use oilwedge_scene::Turbulence;

use super::{Effect, Socket, changed};
use crate::film::Film;
use crate::measure::Measured;
use crate::regime::{Regime, broken_assumption, rounded};
use crate::warning::{self, Warning};

/// Kind of the effect.
pub(super) const KIND: &str = "turbulence";

pub(super) const ROW: Effect = Effect {
    name: "turbulence",
    sentence: "the film resists flow and shear more than a laminar one, by its Reynolds number at each place",
    socket: Socket::FlowFactors,
    kind: KIND,
    is_in: |scene| scene.turbulence.is_some(),
    install: |scene, sockets| {
        sockets.flow_factors.extend(scene.turbulence.map(|model| {
            let model = match model {
                Turbulence::NgPan => TurbulenceModel::NgPan,
                Turbulence::Constantinescu => TurbulenceModel::Constantinescu,
                Turbulence::Reichardt => TurbulenceModel::Reichardt,
            };
            Arc::new(model) as _
        }));
    },
    instead: "a laminar film",
    remove: |scene| changed(scene, |scene| scene.turbulence = None),
    no_proportion: Some([
        "turbulence.model",
        "makes a film whose pressures grow faster than the speed of its journal",
        "remove [turbulence] for the characteristics of the film",
    ]),
    warnings,
};

fn warnings(film: &Film, measured: &Measured) -> Vec<Warning> {
    let Regime { reynolds_number, taylor_limit, .. } = Regime::of(&film.oil, film, measured);
    let is_laminar = reynolds_number < taylor_limit;
    Vec::from_iter(is_laminar.then(|| {
        broken_assumption(warning::LAMINAR.says(format!(
            "turbulent film: the Reynolds number {} lies below {}, where Taylor's vortices begin; remove [turbulence], which resists too much here",
            rounded(reynolds_number),
            rounded(taylor_limit)
        )))
    }))
}
