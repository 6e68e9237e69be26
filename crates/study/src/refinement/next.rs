//! The meshes on the way to a tolerance: drawn, given, or divided from the one before.

use std::sync::Arc;

use oilwedge_bearing::Deadline;
use oilwedge_fem::marking::doerfler;
use oilwedge_mesh::{Mesh, refine};

use super::growth::Growth;
use super::level::Level;
use crate::compile::compile_on;
use crate::compile_error::CompileError;
use crate::film::DEGREE;
use crate::film::Film;
use crate::grading::graded;
use crate::liner_mesh::resized;
use crate::position::Position;
use crate::reasons::Limit;
use crate::result::Refinement;
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
    Divided(Arc<Mesh>, Refinement, Position),
}

/// Where the journal of a film is, as its scene gives it where it does.
fn position(film: &Film) -> Position {
    match film.load {
        None => Position::start(&film.scene),
        Some(_) => film.position(),
    }
}

impl Next {
    /// The mesh of a film divided uniformly, if its round rims are fine enough for that.
    pub(super) fn divided(film: &Film) -> Option<Self> {
        let divided = refine::uniform(film.system.space().mesh()).ok()?;
        Some(Self::Divided(
            Arc::new(divided.mesh),
            Refinement::Uniform,
            position(film),
        ))
    }

    pub(super) fn first(scene: &Scene) -> Self {
        match scene.mesh {
            MeshSource::Drawing { size: None } => Self::Drawn(FIRST),
            _ => Self::Given,
        }
    }

    /// The film on it, and how the mesh was made.
    pub(super) fn film(&self, scene: &Scene, deadline: Deadline) -> Result<(Refinement, Film), CompileError> {
        match self {
            Self::Given => Ok((Refinement::Given, graded(scene, deadline)?)),
            Self::Drawn(factor) => {
                let resized = resized(scene, *factor).unwrap_or_else(|| scene.clone());
                let refinement = if *factor == FIRST {
                    Refinement::Given
                } else {
                    Refinement::Drawn
                };
                Ok((refinement, graded(&resized, deadline)?))
            }
            Self::Divided(mesh, refinement, near) => {
                Ok((*refinement, compile_on(scene, Mesh::clone(mesh), *near, DEGREE)?))
            }
        }
    }

    /// How many times the triangles of `film` it has; none where that shows only once it is drawn.
    pub(super) fn growth(&self, film: &Film) -> Option<f64> {
        match self {
            Self::Divided(mesh, ..) => {
                let cells = film.system.space().mesh().triangles().len();
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

    /// The mesh after that of a level, or why it cannot be made.
    pub(super) fn refined(last: &Self, level: &Level, growth: &Growth) -> Result<Self, Limit> {
        let (film, estimated) = (&level.solved.film, &level.estimated);
        let mesh = film.system.space().mesh();
        // A mesh once divided at a front is as fine there as it must be: what is left is divided where it is too coarse.
        let is_fitted = matches!(last, Self::Divided(_, Refinement::Local, _));
        let is_local = !growth.is_stuck && (estimated.is_local || is_fitted || growth.is_bound);
        // Rows along the flow are divided as a whole: a triangle divided for its neighbour's sake lies across it.
        let in_rows = film.problem.cavitation.conserves_oil();
        let (divided, refinement) = match (&estimated.indicator, last) {
            (Some(indicator), _) if is_local && !in_rows => {
                (refine::local(mesh, &doerfler(indicator, SHARE)), Refinement::Local)
            }
            (_, Self::Drawn(factor)) => return Ok(Self::Drawn(factor / growth.factor.sqrt())),
            _ => (refine::uniform(mesh), Refinement::Uniform),
        };
        let divided = divided.map_err(|_| Limit::CoarseRim)?;
        Ok(Self::Divided(Arc::new(divided.mesh), refinement, position(film)))
    }
}
