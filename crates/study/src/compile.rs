//! A scene becomes a model, once: its effects fill the sockets ([`crate::effects`]), its tables are read, and what its
//! meshes may be is planned. What computes asks the model.

pub mod duty;
mod mesh_plan;
pub(crate) mod oil;
mod scope;

use std::sync::Arc;

use oilwedge_scene::Scene;
use oilwedge_scene::surface_table::Covered;

use crate::checks::targets;
use crate::compile_error::CompileError;
use crate::effects::{Sockets, present};
use crate::model::{Description, Model};
use crate::oil::Oil;
use crate::scope::Scope;
use duty::load_of_orbit;
use mesh_plan::mesh_plan;

/// The model of a scene.
///
/// # Errors
/// [`CompileError`]: a table that the scene names cannot be used.
pub fn compile(scene: &Scene) -> Result<Arc<Model>, CompileError> {
    let sockets = Sockets::of(scene);
    let mut mesh = mesh_plan(scene, &sockets);
    let bearing = mesh.bearing;
    let covered = Covered { length: bearing.length, arc: scene.bearing.arc };
    let profiles = sockets.surfaces.iter().map(|surface| surface.profile(&bearing, covered));
    mesh.profiles = profiles.collect::<Result<_, _>>().map_err(CompileError::Surface)?;
    Ok(Arc::new(Model {
        description: Description { title: scene.title.clone(), text: scene.text.clone(), sha256: scene.sha256.clone() },
        effects: present(scene).map(|effect| effect.name).collect(),
        mesh,
        wall: sockets.wall.as_ref().map(|model| model.wall(&bearing)).transpose()?.map(Arc::new),
        oil: Oil::of(scene),
        placed: scene.journal.position,
        tilt: scene.journal.tilt.unwrap_or_default(),
        has_support: scene.support.is_some(),
        covered,
        roughness: scene.bearing.roughness,
        elastic_modulus: scene.bearing.elastic_modulus,
        duty: scene.orbit.as_ref().map(|_| load_of_orbit(scene)).transpose()?,
        scope: Scope::of(scene),
        criteria: scene.criteria,
        targets: targets(scene),
        sockets,
    }))
}

#[cfg(test)]
mod tests;
