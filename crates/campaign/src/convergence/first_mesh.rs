//! The coarse mesh that a study begins with.

use std::sync::Arc;
use std::time::Instant;

use oilwedge_bearing::Deadline;
use oilwedge_mesh::Mesh;

use oilwedge_study::analysis::solve;
use oilwedge_study::compile_error::CompileError;
use oilwedge_study::grading::graded;
use oilwedge_study::liner_mesh::liner_mesh;
use oilwedge_study::model::Model;
use oilwedge_study::no_answer::NoAnswer;
use oilwedge_study::position::Position;
use oilwedge_study::solved::SolveOptions;

/// How much longer than wanted the edges of a drawn mesh are, the first that leads to an answer: two, one and no
/// halving.
const FACTORS: [f64; 3] = [4.0, 2.0, 1.0];

/// The first mesh.
pub(super) struct First {
    pub(super) mesh: Arc<Mesh>,
    /// The position that it is graded for.
    pub(super) position: Position,
    /// Seconds [s] that it took.
    pub(super) seconds: f64,
}

/// Reads the mesh of a model or draws a coarse one. Under a load a drawn mesh is graded for the position that the load
/// leads to on a mesh as coarse.
///
/// # Errors
/// The mesh cannot be read or drawn; or, within, there is no position for the load on any of the coarse meshes.
pub(super) fn first_mesh(model: &Arc<Model>, deadline: Deadline) -> Result<Result<First, NoAnswer>, CompileError> {
    let clock = Instant::now();
    let start = Position::start(model);
    let first = |mesh: Mesh, position: Position| First {
        mesh: Arc::new(mesh),
        position,
        seconds: clock.elapsed().as_secs_f64(),
    };
    let options = SolveOptions { deadline, ..SolveOptions::default() };
    let mut tried = Ok(None);
    for factor in FACTORS.iter().filter(|_| model.mesh.is_graded()) {
        let longest = factor * model.mesh.longest;
        if !model.scope.is_loaded {
            match liner_mesh(&model.mesh, longest, &model.state_at(start)) {
                Ok(liner) => return Ok(Ok(first(liner.mesh, start))),
                Err(error) => tried = Err(error),
            }
            continue;
        }
        match graded(model, longest, deadline.into()).map(|film| solve(&film, &options)) {
            Ok(Ok(solved)) => {
                let mesh = Mesh::clone(solved.film.system.space().mesh());
                return Ok(Ok(first(mesh, solved.film.position())));
            }
            Ok(Err(reason)) => tried = Ok(Some(reason)),
            Err(error) => tried = Err(error),
        }
    }
    match tried? {
        Some(reason) => Ok(Err(reason)),
        None => Ok(Ok(first(model.first_mesh()?.mesh, start))),
    }
}
