//! The meshes that a scene may have.

use oilwedge_mesh::developed::LinerDomain;
use oilwedge_reynolds::Bearing;
use oilwedge_scene::Scene;

use crate::effects::Sockets;
use crate::film_scale::needed_size;
use crate::mesh_plan::MeshPlan;
use crate::outline::LinerOutline;

/// The meshes of a scene, whose surfaces are not read yet.
pub(super) fn mesh_plan(scene: &Scene, sockets: &Sockets) -> MeshPlan {
    let (bearing, cavitation) = (&scene.bearing, &sockets.cavitation);
    let needed = needed_size(bearing.radius(), bearing.length);
    MeshPlan {
        source: scene.mesh.clone(),
        outline: LinerOutline::of(scene),
        longest: scene.mesh.size().unwrap_or(needed),
        needed,
        bearing: Bearing {
            radius: bearing.radius(),
            length: bearing.length,
            clearance: bearing.clearance,
            end_pressure: scene.ends.pressure,
        },
        speed: scene.journal.speed,
        bores: scene.bores.clone(),
        profiles: Vec::new(),
        touching: sockets.contact.as_ref().map(|contact| contact.law.scale()),
        carrying: cavitation.pressure().filter(|_| cavitation.conserves_oil()),
        is_of_orbit: scene.orbit.is_some(),
    }
}

impl LinerOutline {
    /// The outline that a scene describes.
    pub fn of(scene: &Scene) -> Self {
        let bearing = &scene.bearing;
        let arc = bearing.arc.map(|arc| (arc.from, arc.to));
        Self {
            liner: LinerDomain { radius: bearing.radius(), length: bearing.length, arc },
            feeds: scene.feeds.clone(),
            film_start: bearing.film_start,
            is_drawn: scene.mesh.is_graded(),
        }
    }
}
