//! One level: a scene solved on one mesh with elements of one degree, and what that gives.

use std::time::Instant;

use oilwedge_bearing::{NoEquilibrium, Squeeze, find};
use oilwedge_mesh::Mesh;
use oilwedge_reynolds::NoFilm;

use crate::analysis::NoAnswer;
use crate::compile::{CompileError, Study, compile_on};
use crate::measure::{measure, quantities};
use crate::report::Quantity;
use crate::scene::Scene;

/// What one mesh gives.
pub struct Level {
    /// The film; under a load the journal of its problem is where it was found.
    pub study: Study,
    /// Nodes whose pressure is not given.
    pub unknowns: usize,
    /// The quantities of the report, with their error where it was estimated.
    pub quantities: Vec<Quantity>,
    /// Share of each triangle in the error of the goal, signed, in the goal's unit; `None` where it was not estimated.
    pub indicator: Option<Vec<f64>>,
    /// Where the time went [s], in the order of the run, without the making of the mesh.
    pub seconds: Vec<(&'static str, f64)>,
}

/// Why a mesh gives nothing.
#[derive(Debug, thiserror::Error)]
pub enum LevelError {
    /// The scene does not become a film on this mesh.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// There is no answer to what the scene asks.
    #[error(transparent)]
    NoAnswer(#[from] NoAnswer),
}

impl From<NoFilm> for LevelError {
    fn from(reason: NoFilm) -> Self {
        Self::NoAnswer(reason.into())
    }
}

impl From<NoEquilibrium> for LevelError {
    fn from(reason: NoEquilibrium) -> Self {
        Self::NoAnswer(reason.into())
    }
}

/// Solves `scene` on `mesh` with elements of the given degree, the journal at the position `near` (eccentricity [1], angle
/// of the minimum film [rad]) or, under a load, sought from there. With `bars` errors are estimated where they can be.
///
/// # Errors
/// [`LevelError`]: the scene does not become a film on this mesh, or there is no film or position.
pub fn solve_level(
    scene: &Scene,
    mesh: Mesh,
    near: (f64, f64),
    degree: usize,
    _bars: bool,
) -> Result<Level, LevelError> {
    let clock = Instant::now();
    let mut study = compile_on(scene, mesh, near, degree)?;
    let order = clock.elapsed().as_secs_f64();
    let clock = Instant::now();
    let film = match study.load {
        None => study.problem.solve(&study.system)?,
        Some(load) => {
            let squeeze = scene.journal.motion().map_or(Squeeze::default(), |motion| Squeeze {
                radial: motion.radial,
                tangential: motion.tangential,
            });
            let found = find(&study.problem, &study.system, load, squeeze)?;
            study.problem = found.problem;
            found.film
        }
    };
    let parts = film.seconds;
    let search = clock.elapsed().as_secs_f64() - parts.assemble - parts.factorise - parts.solve;
    let clock = Instant::now();
    let quantities = quantities(&study, &measure(&study, &film));
    let owner = |dof: &usize| study.system.supply.owner(*dof);
    Ok(Level {
        unknowns: (0..study.system.space().dofs())
            .filter(|dof| owner(dof).is_none())
            .count(),
        quantities,
        indicator: None,
        seconds: vec![
            ("order", order),
            ("search", search),
            ("assemble", parts.assemble),
            ("factorise", parts.factorise),
            ("solve", parts.solve),
            ("measure", clock.elapsed().as_secs_f64()),
        ],
        study,
    })
}
