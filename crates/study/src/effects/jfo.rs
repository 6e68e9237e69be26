//! Jakobsson, Floberg and Olsson's film: oil is conserved through the cavity.

use oilwedge_reynolds::Cavitation;
use oilwedge_scene::CavitationModel;
use oilwedge_scene::Scene;

use super::{Effect, changed, closure};

pub(super) const ROW: Effect = Effect {
    name: "cavitation: jfo",
    sentence: "oil is conserved, the cavity holds a film fraction that is carried along",
    is_in: |scene| closure::is(scene, CavitationModel::Jfo),
    install: |scene, sockets| {
        let pressure = closure::least_pressure(scene);
        sockets.cavitation = Cavitation::Jfo { pressure };
    },
    no_proportion: Some([
        "cavitation.model",
        "is \"jfo\", but a journal that does not turn carries no oil into a cavity that conserves it: its parts have no film of their own",
        "write model = \"reynolds\" or \"guembel\" for the characteristics",
    ]),
    ..closure::ROW
};

/// The scene with the nearest model that does not conserve oil in the cavity; `None` where it has such a model.
pub fn without_conservation(scene: &Scene) -> Option<Scene> {
    (ROW.is_in)(scene).then_some(())?;
    changed(scene, |scene| {
        if let Some(cavitation) = &mut scene.cavitation {
            cavitation.model = CavitationModel::Reynolds;
        }
    })
}
