//! The meshes on the way to a tolerance: drawn, given, or divided from the one before.

use std::sync::Arc;

use oilwedge_bearing::Deadline;
use oilwedge_fem::marking::doerfler;
use oilwedge_mesh::{Mesh, refine};

use crate::analysis::graded;
use crate::compile::{CompileError, Study, compile_on};
use crate::estimate::Estimated;
use crate::liner_mesh::resized;
use crate::result::Refinement;
use crate::run::DEGREE;
use crate::start::start;
use oilwedge_scene::{MeshSource, Scene};

/// Edges of the first mesh towards a tolerance over those of a mesh that is used as it is.
const FIRST: f64 = 3.0;
/// Share of the indicator that the triangles divided carry.
const SHARE: f64 = 0.7;
/// The scene with the first mesh on the way to its tolerance.
pub fn at_first(scene: &Scene) -> Scene {
    match scene.mesh {
        MeshSource::Drawing { size: None } => resized(scene, FIRST).unwrap_or_else(|| scene.clone()),
        _ => scene.clone(),
    }
}

/// The next mesh.
pub(super) enum Next {
    /// Made of the scene with longest edges times this.
    Drawn(f64),
    /// That of the scene as it is.
    Given,
    /// One at hand, for the journal at this position.
    Divided(Arc<Mesh>, Refinement, (f64, f64)),
}

/// Where the journal of a study is: eccentricity [1] and angle of the minimum film [rad].
fn position(scene: &Scene, study: &Study) -> (f64, f64) {
    let journal = &study.problem.journal;
    match study.load {
        None => start(scene),
        Some(_) => (
            journal.eccentricity() / scene.bearing.clearance,
            journal.min_film_angle(),
        ),
    }
}

impl Next {
    /// The mesh of a study divided uniformly, if its round rims are fine enough for that.
    pub(super) fn divided(scene: &Scene, study: &Study) -> Option<Self> {
        let divided = refine::uniform(study.system.space().mesh()).ok()?;
        let near = position(scene, study);
        Some(Self::Divided(Arc::new(divided.mesh), Refinement::Uniform, near))
    }

    pub(super) fn first(scene: &Scene) -> Self {
        match scene.mesh {
            MeshSource::Drawing { size: None } => Self::Drawn(FIRST),
            _ => Self::Given,
        }
    }

    pub(super) fn study(&self, scene: &Scene, deadline: Deadline) -> Result<(Refinement, Study), CompileError> {
        match self {
            Self::Given => Ok((Refinement::Given, graded(scene, deadline)?)),
            Self::Drawn(factor) => {
                let resized = resized(scene, *factor).unwrap_or_else(|| scene.clone());
                let refinement = if *factor == FIRST {
                    Refinement::Given
                } else {
                    Refinement::Uniform
                };
                Ok((refinement, graded(&resized, deadline)?))
            }
            Self::Divided(mesh, refinement, near) => {
                Ok((*refinement, compile_on(scene, Mesh::clone(mesh), *near, DEGREE)?))
            }
        }
    }

    /// How many times the triangles of `study` it has; none where that shows only once it is drawn.
    pub(super) fn growth(&self, study: &Study) -> Option<f64> {
        match self {
            Self::Divided(mesh, ..) => {
                let cells = study.system.space().mesh().triangles().len();
                Some(mesh.triangles().len() as f64 / cells as f64)
            }
            _ => None,
        }
    }

    /// Another start where the first mesh was too coarse to have an answer.
    pub(super) fn finer_first(&self, scene: &Scene) -> Option<Self> {
        match (self, &scene.mesh) {
            (Self::Drawn(factor), MeshSource::Drawing { size: None }) if *factor > 1.0 => Some(Self::Drawn(1.0)),
            _ => None,
        }
    }

    /// The mesh after that of `study`, or why it cannot be made. `bound` tells that drawing it finer made it hardly larger:
    /// its sizes are those of holes and grooves; `stuck` that local division does not help.
    pub(super) fn refined(
        scene: &Scene,
        last: &Self,
        study: &Study,
        judged: &Estimated,
        growth: f64,
        [bound, stuck]: [bool; 2],
    ) -> Result<Self, String> {
        let mesh = study.system.space().mesh();
        let near = position(scene, study);
        // A mesh once divided at a front is as fine there as it must be: what is left is divided where it is too coarse.
        let fitted = matches!(last, Self::Divided(_, Refinement::Local, _));
        let local = judged
            .indicator
            .as_ref()
            // Rows along the flow are divided as a whole: a triangle divided for its neighbour's sake lies across it.
            .filter(|_| !study.problem.cavitation.conserves_oil() && !stuck && (judged.is_local || fitted || bound));
        let (divided, refinement) = match (local, last) {
            (Some(indicator), _) => (refine::local(mesh, &doerfler(indicator, SHARE)), Refinement::Local),
            (None, Self::Drawn(factor)) => return Ok(Self::Drawn(factor / growth.sqrt())),
            (None, _) => (refine::uniform(mesh), Refinement::Uniform),
        };
        let divided = divided.map_err(|_| {
            "limit: the mesh cannot be divided, for a round rim of it is too coarse; give a finer mesh".to_owned()
        })?;
        Ok(Self::Divided(Arc::new(divided.mesh), refinement, near))
    }
}
