//! Guembel's (half Sommerfeld) film: low pressures are dropped after the solve.

use oilwedge_reynolds::Cavitation;
use oilwedge_scene::CavitationModel;

use super::{Effect, closure};
use crate::measure::Measured;
use crate::warning::{self, Warning};
use crate::warnings::percent;

/// Oil that is made below this part of what passes is below round-off.
const NOTHING: f64 = 1e-9;

pub(super) const ROW: Effect = Effect {
    name: "cavitation: guembel",
    sentence: "pressures below that of the cavity are dropped",
    is_in: |scene| closure::is(scene, CavitationModel::Guembel),
    install: |scene, sockets| {
        let pressure = closure::pressure(scene);
        sockets.cavitation = Cavitation::Guembel { pressure };
    },
    warnings: |_, measured| vec![unconserved(measured)],
    ..closure::ROW
};

fn unconserved(measured: &Measured) -> Warning {
    let change = match measured.flows.made() {
        little if little.abs() < NOTHING => "nothing was dropped here".to_owned(),
        made if made > 0.0 => format!("some {} of the oil that passes is created there", percent(made)),
        lost => format!("some {} of the oil that passes is lost there", percent(-lost)),
    };
    warning::UNBALANCED.says(format!(
        "Guembel's film drops low pressures after the solve: oil is not conserved at its edge ({change})"
    ))
}
