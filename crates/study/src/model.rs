//! What a scene is made of, once: the sockets of its film filled, the plan of its meshes, and what is asked, as plain
//! numbers. Nothing below it sees the scene.

use std::sync::Arc;

use oilwedge_bearing::duty_cycle::DutyCycle;
use oilwedge_reynolds::lubricant::Lubricant;
use oilwedge_reynolds::lubricant::density::MINERAL_OIL;
use oilwedge_reynolds::wall::Wall;
use oilwedge_scene::surface_table::Covered;
use oilwedge_scene::{Criteria, PositionTable as Placed};

use crate::effects::sockets::Sockets;
use crate::mesh_plan::MeshPlan;
use crate::oil::Oil;
use crate::scope::Scope;
use crate::targets::Targets;

/// A bearing to be computed.
#[derive(Debug, Clone)]
pub struct Model {
    /// The description that it is made of, for the head of results.
    pub description: Description,
    /// Names of its effects, in the order of their table.
    pub effects: Vec<&'static str>,
    /// What its effects have filled.
    pub sockets: Sockets,
    /// The meshes that it may have.
    pub mesh: MeshPlan,
    /// How the wall gives way to the pressure; `None`: it is rigid.
    pub wall: Option<Arc<Wall>>,
    /// The oil at the temperature that is given or, with a heat balance, at which the search for it begins.
    pub oil: Oil,
    /// Where the journal is, or what load leads it.
    pub placed: Placed,
    /// Slope of the journal's axis [rad], as far as it is given.
    pub tilt: [f64; 2],
    /// Whether a support holds the journal against tilt.
    pub has_support: bool,
    /// What a measured surface has to cover.
    pub covered: Covered,
    /// Combined roughness of the surfaces [m], where it is given.
    pub roughness: Option<f64>,
    /// Young's modulus of journal and liner [Pa], where it is given.
    pub elastic_modulus: Option<f64>,
    /// What its answer may contain.
    pub scope: Scope,
    /// The load over a cycle, where an orbit is followed.
    pub duty: Option<DutyCycle>,
    /// What the bearing is judged by.
    pub criteria: Criteria,
    /// The bars that must become small by refinement; `None` where the mesh is used as it is.
    pub targets: Option<Targets>,
}

/// Title and text of a scene.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Description {
    /// Title of the study.
    pub title: String,
    /// The text.
    pub text: String,
    /// SHA-256 of the text, hexadecimal.
    pub sha256: String,
}

impl Model {
    /// The oil at a temperature [K], or at that of the model.
    pub(crate) fn oil_at(&self, temperature: Option<f64>) -> Oil {
        temperature.map_or_else(|| self.oil.clone(), |temperature| self.oil.at(temperature))
    }

    /// What an oil is to the film.
    pub fn lubricant(&self, oil: &Oil) -> Lubricant {
        Lubricant {
            viscosity: oil.viscosity,
            pressure_law: self.sockets.pressure_rule.at(oil.viscosity),
            density: oil.film_density().unwrap_or(MINERAL_OIL),
            temperature: oil.temperature,
        }
    }
}
