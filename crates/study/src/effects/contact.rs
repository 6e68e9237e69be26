//! Contact: rough surfaces touch where the film is thin.

use std::sync::Arc;

use oilwedge_reynolds::contact::{BearingCurve, Contact, ContactLaw, Fineness, GreenwoodTripp};
use oilwedge_reynolds::existence::readable;
use oilwedge_scene::{ContactModel, ContactTable, Scene};

use super::{Effect, ROUGHNESS, Socket, Sockets, changed};
use crate::film::Film;
use crate::measure::Measured;
use crate::regime::{APART, broken_assumption};
use crate::warning::{self, Warning};

/// Pressure of contact over the hardness from which on many asperities yield, and their heights are not those given.
const YIELDING: f64 = 0.5;
pub(super) const ROW: Effect = Effect {
    name: "contact of asperities",
    sentence: "rough surfaces carry a part of the load where they touch, and rub",
    socket: Socket::Contact,
    kind: ROUGHNESS,
    is_in: |scene| scene.contact.is_some(),
    install,
    instead: "surfaces that do not touch, however thin the film",
    remove: |scene| changed(scene, |scene| scene.contact = None),
    no_proportion: Some([
        "contact",
        "adds a force that depends on the position of the journal, not on its rates",
        "remove [contact] for the characteristics of the film",
    ]),
    warnings,
};

fn install(scene: &Scene, sockets: &mut Sockets) {
    let law = |contact: &ContactTable| -> Option<Arc<dyn ContactLaw>> {
        match contact.model {
            ContactModel::GreenwoodTripp { density, sharpness, modulus } => {
                let roughness = scene.bearing.roughness?;
                let law = GreenwoodTripp::new(roughness, density, sharpness, modulus, contact.hardness);
                Some(Arc::new(law))
            }
            ContactModel::BearingCurve { depth } => Some(Arc::new(BearingCurve { depth, hardness: contact.hardness })),
        }
    };
    let fineness = Fineness::Reported;
    sockets.contact =
        scene.contact.and_then(|given| Some(Contact { law: law(&given)?, friction: given.friction, fineness }));
}

fn warnings(film: &Film, measured: &Measured) -> Vec<Warning> {
    let Some(Contact { law, .. }) = &film.problem.contact else {
        return Vec::new();
    };
    let greatest = law.at(measured.thinnest.thickness).pressure;
    let part = greatest / law.hardness();
    let yields = (part > YIELDING).then(|| {
        broken_assumption(warning::ASPERITIES.says(format!(
            "asperities as they are given: the pressure of contact reaches {} % of contact.hardness, and asperities that yield are no more of the heights given; the surfaces run in",
            readable((100.0 * part).round())
        )))
    });
    let ratio = (film.model.roughness).map(|roughness| measured.thinnest.thickness / roughness);
    let is_smooth = !film.problem.is_rough();
    let through_valleys = ratio.filter(|ratio| is_smooth && *ratio < APART).map(|ratio| {
        let ratio = format!("{ratio:.1e}").parse().unwrap_or(ratio);
        broken_assumption(warning::VALLEYS.says(format!(
            "a smooth gap: the least film is {} times bearing.roughness, below {APART} times, and oil flows through the valleys there; give [roughness]",
            readable(ratio)
        )))
    });
    yields.into_iter().chain(through_valleys).collect()
}
