//! A scene becomes a model, once: its effects fill the sockets ([`crate::effects`]), its tables are read, and what its
//! meshes may be is planned. What computes asks the model.

mod scope;

use std::sync::Arc;

use oilwedge_reynolds::Bearing;
use oilwedge_scene::Scene;

use crate::checks::targets;
use crate::compile_error::CompileError;
use crate::duty::load_of_orbit;
use crate::effects::{Sockets, present};
use crate::film_scale::needed_size;
use crate::mesh_plan::MeshPlan;
use crate::model::{Description, Model};
use crate::oil::Oil;
use crate::outline::LinerOutline;
use crate::scope::Scope;
use crate::wall::wall;

/// The model of a scene.
///
/// # Errors
/// [`CompileError`]: a table that the scene names cannot be used.
pub fn compile(scene: &Scene) -> Result<Arc<Model>, CompileError> {
    let sockets = Sockets::of(scene);
    let bearing = Bearing {
        radius: scene.bearing.radius(),
        length: scene.bearing.length,
        clearance: scene.bearing.clearance,
        end_pressure: scene.ends.pressure,
    };
    let mut model = Model {
        description: Description { title: scene.title.clone(), text: scene.text.clone(), sha256: scene.sha256.clone() },
        effects: present(scene).map(|effect| effect.name).collect(),
        mesh: mesh_plan(scene, &sockets),
        wall: sockets.liner.as_ref().map(|liner| wall(liner, &bearing)).transpose()?.map(Arc::new),
        bearing,
        oil: Oil::of(scene),
        speed: scene.journal.speed,
        placed: scene.journal.position,
        tilt: scene.journal.tilt.unwrap_or_default(),
        has_support: scene.support.is_some(),
        roughness: scene.bearing.roughness,
        elastic_modulus: scene.bearing.elastic_modulus,
        duty: scene.orbit.as_ref().map(|_| load_of_orbit(scene)).transpose()?,
        scope: Scope::of(scene),
        criteria: scene.criteria,
        targets: targets(scene),
        sockets,
    };
    let covered = model.covered();
    let profiles = model.sockets.surfaces.iter().map(|surface| surface.profile(&bearing, covered));
    model.mesh.profiles = profiles.collect::<Result<_, _>>().map_err(CompileError::Surface)?;
    Ok(Arc::new(model))
}

/// The meshes of a scene, whose surfaces are not read yet.
fn mesh_plan(scene: &Scene, sockets: &Sockets) -> MeshPlan {
    let (bearing, cavitation) = (&scene.bearing, &sockets.cavitation);
    let needed = needed_size(bearing.radius(), bearing.length);
    MeshPlan {
        source: scene.mesh.clone(),
        outline: LinerOutline::of(scene),
        longest: scene.mesh.size().unwrap_or(needed),
        needed,
        clearance: bearing.clearance,
        speed: scene.journal.speed,
        end_pressure: scene.ends.pressure,
        bores: scene.bores.clone(),
        profiles: Vec::new(),
        touching: sockets.contact.as_ref().map(|contact| contact.law.scale()),
        carrying: cavitation.pressure().filter(|_| cavitation.conserves_oil()),
        is_of_orbit: scene.orbit.is_some(),
    }
}

#[cfg(test)]
mod tests;
