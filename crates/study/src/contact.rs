//! Contact of a scene as films know it.

use oilwedge_reynolds::contact::{BearingCurve, Contact, ContactLaw, Fineness, GreenwoodTripp};
use oilwedge_scene::{ContactModel, Scene};

/// The contact of a scene.
pub(crate) fn contact(scene: &Scene) -> Option<Contact> {
    let contact = scene.contact?;
    let law = match contact.model {
        ContactModel::GreenwoodTripp { density, sharpness, modulus } => {
            let roughness = scene.bearing.roughness?;
            let law = GreenwoodTripp::new(roughness, density, sharpness, modulus, contact.hardness);
            ContactLaw::GreenwoodTripp(law)
        }
        ContactModel::BearingCurve { depth } => {
            ContactLaw::BearingCurve(BearingCurve { depth, hardness: contact.hardness })
        }
    };
    Some(Contact { law, friction: contact.friction, fineness: Fineness::Reported })
}
