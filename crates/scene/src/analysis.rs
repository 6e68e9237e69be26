//! What is asked of a film: its solution at a given position, or the position in which it carries a load.

use std::time::Instant;

use oilwedge_bearing::{Equilibrium, NoEquilibrium, Squeeze, find};
use oilwedge_reynolds::{FilmSolution, JournalState, NoFilm};

use crate::compile::{CompileError, Study, compile, compile_near};
use crate::scene::Scene;

/// A mesh is graded anew where the least film thickness found is another one than it was graded for by this factor,
const REGRADED: f64 = 1.3;
/// or where the thinnest film lies elsewhere by this angle [rad].
const ELSEWHERE: f64 = 0.2;
/// No mesh is graded for films thinner than at this eccentricity.
const THICK_ENOUGH: f64 = 0.9999;
/// Gradings of one search.
const GRADINGS: usize = 4;

/// A solved film of a study.
#[derive(Debug)]
pub struct Solved {
    /// The film.
    pub film: FilmSolution,
    /// How the load is balanced, where the position was sought.
    pub balance: Option<Balance>,
}

/// How well a load is balanced, and what it took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balance {
    /// Load less force of the film, relative to the load.
    pub residual: f64,
    /// Positions tried on the mesh of the result.
    pub steps: usize,
    /// Seconds that the search took, but for the film of the result; gradings of the mesh count.
    pub seconds: f64,
}

/// Why there is nothing to report.
#[derive(Debug, thiserror::Error)]
pub enum NoAnswer {
    /// There is no film at the given position.
    #[error(transparent)]
    Film(#[from] NoFilm),
    /// There is no position for the load.
    #[error(transparent)]
    Equilibrium(#[from] NoEquilibrium),
}

/// Compiles a scene and answers what it asks. Under a load the journal of the study's problem is where it was found.
///
/// # Errors
/// The scene does not become a film. That there is no answer is no error.
pub fn analyse(scene: &Scene) -> Result<(Study, Result<Solved, NoAnswer>), CompileError> {
    let mut study = compile(scene)?;
    let clock = Instant::now();
    let Some(load) = study.load else {
        let film = study.problem.solve(&study.system);
        return Ok((
            study,
            film.map(|film| Solved { film, balance: None }).map_err(Into::into),
        ));
    };
    let squeeze = scene.journal.motion().map_or(Squeeze::default(), |motion| Squeeze {
        radial: motion.radial,
        tangential: motion.tangential,
    });
    for _ in 1..GRADINGS {
        if !scene.mesh.is_graded() {
            break;
        }
        // A coarser mesh is good enough to grade a mesh for, if it leads to a position. A load may be out of reach only
        // because the mesh is too coarse there.
        let on_coarser = (study.system.coarser.as_ref())
            .and_then(|coarser| find(&coarser.problem(&study.problem), &coarser.system, load, squeeze).ok());
        let found = match on_coarser.map_or_else(|| find(&study.problem, &study.system, load, squeeze), Ok) {
            Ok(Equilibrium { problem, .. }) => Some(problem.journal),
            Err(reason) => reason.last_position(),
        };
        let clearance = scene.bearing.clearance;
        let Some(found) = found.filter(|found| found.eccentricity() < THICK_ENOUGH * clearance) else {
            break;
        };
        if is_near(clearance, &study.problem.journal, &found) {
            break;
        }
        study = compile_near(scene, (found.eccentricity() / clearance, found.min_film_angle()))?;
    }
    Ok(match find(&study.problem, &study.system, load, squeeze) {
        Ok(found) => {
            study.problem = found.problem;
            let film = found.film;
            let parts = film.seconds;
            let balance = Balance {
                residual: found.residual,
                steps: found.steps,
                seconds: clock.elapsed().as_secs_f64() - parts.assemble - parts.factorise - parts.solve,
            };
            (
                study,
                Ok(Solved {
                    film,
                    balance: Some(balance),
                }),
            )
        }
        Err(reason) => (study, Err(reason.into())),
    })
}

/// Whether a mesh graded for one position suits another.
fn is_near(clearance: f64, graded_for: &JournalState, found: &JournalState) -> bool {
    let gap = |journal: &JournalState| clearance - journal.eccentricity();
    let ratio = gap(graded_for) / gap(found);
    let turn = graded_for.min_film_angle() - found.min_film_angle();
    let turn = turn.sin().atan2(turn.cos()).abs();
    ratio < REGRADED && ratio > 1.0 / REGRADED && turn < ELSEWHERE
}
