//! Reynolds' (Swift-Stieber) film: pressure meets that of the cavity without a kink.

use oilwedge_reynolds::Cavitation;
use oilwedge_scene::CavitationModel;

use super::{Effect, closure};

pub(super) const ROW: Effect = Effect {
    name: "cavitation: reynolds",
    sentence: "the film ends where pressure meets that of the cavity without a kink",
    is_in: |scene| closure::is(scene, CavitationModel::Reynolds),
    install: |scene, sockets| {
        let pressure = closure::least_pressure(scene);
        sockets.cavitation = Cavitation::Reynolds { pressure };
    },
    ..closure::ROW
};
