//! Which meshes a model may have. A mesh follows from the plan, the length of its longest edges, and a state of the
//! film.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use oilwedge_reynolds::Bearing;
use oilwedge_reynolds::film_thickness::Profile;
use oilwedge_scene::{Bore, MeshSource};

use crate::outline::LinerOutline;

/// The meshes of a model.
#[derive(Debug, Clone)]
pub struct MeshPlan {
    /// Origin of the mesh.
    pub source: MeshSource,
    /// The liner and its feeds.
    pub outline: LinerOutline,
    /// Longest edges [m] of a mesh made here: those wanted or, where none are, those that the film needs.
    pub longest: f64,
    /// Longest edges [m] that the film needs.
    pub needed: f64,
    /// Radius, length, clearance and end pressure.
    pub bearing: Bearing,
    /// Angular speed of the journal [rad/s].
    pub speed: f64,
    /// Shapes of the bore.
    pub bores: Vec<Bore>,
    /// Profiles of bore and journal, if they are no circles.
    pub profiles: Vec<Arc<dyn Profile>>,
    /// Scale [m] of the gap in which the pressure of contact changes, where surfaces touch.
    pub touching: Option<f64>,
    /// Pressure [Pa] of a cavity through which the film carries its oil: its triangles lie in rows along the flow;
    /// `None` for other films.
    pub carrying: Option<f64>,
    /// True of the films of an orbit.
    pub is_of_orbit: bool,
}

impl MeshPlan {
    /// Whether the size of the mesh follows the thickness of the film, and so the position of the journal.
    pub fn is_graded(&self) -> bool {
        self.source.is_graded()
    }

    /// Whether the size of the mesh is left to the program.
    pub(crate) fn is_free(&self) -> bool {
        matches!(self.source, MeshSource::Drawing { size: None })
    }

    /// What messages call the mesh.
    pub(crate) fn name(&self) -> PathBuf {
        self.source.path().unwrap_or(Path::new("of the liner described")).to_owned()
    }
}
